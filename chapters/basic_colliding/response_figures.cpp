/// \file
/// \brief The figures of the claims on handling collisions, and of the errata of the event search.
#include "basic_colliding/experiments.hpp"

namespace tumble::chapters {
namespace {

Figure impact_times_figure() {
  Figure figure;
  figure.name = "claim_2_1a_impacts";
  figure.section = "2.1";
  figure.title = "The basic technique finds the impacts of a bouncing cube at their times";
  figure.caption =
      "A cube is dropped flat from 1 m and keeps 0.9 of its speed at each impact. Above, "
      "its height as the technique moves it: a step of 1/60 s, a look for overlap, a search "
      "back to the moment of impact, an impulse, and on from there. In the middle, the "
      "energy that each impact leaves lies on the closed form. Below, how far the 20 impact "
      "times are from the closed form. A search may end one resolution (1 ns) early, and "
      "every later flight shows an echo of that; the line is what is accepted, five "
      "resolutions for each impact. At worst it is half of one.";
  figure.parameters.add_number("height", 1.0, 0.01, 100.0, "m", "free height at the start")
      .add_number("restitution", 0.9, 0.5, 1.0, "-", "rebound speed over impact speed")
      .add_whole("impacts", 20, 1, 100, "how many are compared")
      .add_number("step", 1.0 / 60.0, 1e-4, 0.1, "s", "time step")
      .add_number("resolution", 1e-9, 1e-12, 1e-4, "s", "how closely impact times are found");
  figure.quick = {"impacts=8"};
  figure.experiment = measure_impact_times;
  return figure;
}

Figure rest_figure() {
  Figure figure;
  figure.name = "claim_2_1b_rest";
  figure.section = "2.1";
  figure.title = "A cube at rest: the basic technique meets its cap, and repair hides what follows";
  figure.caption =
      "A cube is dropped flat from 1 m and keeps half of its speed at each impact: after "
      "infinitely many impacts it rests, from the dashed moment on. Above, its height; in "
      "the middle, how many impacts each step resolves. The technique as it is (blue) meets "
      "its cap of 1000 once, in the step in which the cube comes to rest: in 1 of the 39 "
      "steps that end after that moment. The rest of that step is flown without impacts, "
      "into the ground, and from there on the repair of overlap takes over. It leaves a "
      "thousandth of an edge, so that each later step begins inside the ground: one impact "
      "at its start, a sinking by half a millimetre, a lift (below). The cube neither rests "
      "nor stops the program. Lifted clear of the ground after each step (orange), it is "
      "searched for impacts again, and most steps end at the cap: the technique by itself "
      "does not handle rest, and it is the repair that hides it.";
  figure.parameters.add_number("height", 1.0, 0.01, 100.0, "m", "free height at the start")
      .add_number("restitution", 0.5, 0.0, 0.9, "-", "rebound speed over impact speed")
      .add_number("duration", 2.0, 0.1, 60.0, "s", "length of the run")
      .add_number("step", 1.0 / 60.0, 1e-4, 0.1, "s", "time step")
      .add_number("resolution", 1e-9, 1e-12, 1e-4, "s", "how closely impact times are found")
      .add_whole("cap", 1000, 1, 100000, "impacts allowed in a step")
      .add_number("clear", 1e-9, 1e-12, 1e-3, "m", "how high overlap is lifted in the second run");
  figure.quick = {"duration=1.6"};
  figure.experiment = measure_rest;
  return figure;
}

Figure stack_impulses_figure() {
  Figure figure;
  figure.name = "claim_2_5_2a_stack";
  figure.section = "2.5.2";
  figure.title = "With impulses alone, the work of a stack grows faster than its height";
  figure.caption =
      "Cubes on top of each other never rest, contact is a train of small collisions: two "
      "that meet part at least as fast as it takes to be thrown up from the ground for the "
      "shortest hop. Counted are the impulses of a simulated second, for hops of 1 ms and "
      "0.1 ms. They grow with the square of the height (full lines), not with the height "
      "(dotted): four cubes need 16.4 times the impulses of one. The square follows from "
      "momentum alone: each contact has to hand up the weight above it, and does so in "
      "impulses of one size. Nothing is lost by stopping a run early here; a run that met "
      "the cap would be framed. Where faster impacts are livelier the growth is slower: "
      "with restitution 0.9 the factor is 14.3. Each mark is the mean of 20 runs with "
      "random small gaps at the start.";
  figure.parameters.add_whole("most", 8, 4, 32, "cubes in the highest stack")
      .add_number("restitution", 0.0, 0.0, 0.9, "-", "of impacts faster than the slowest rebound")
      .add_number("duration", 1.0, 1e-3, 60.0, "s", "length of each run")
      .add_whole("seeds", 20, 2, 1000, "runs for each height, with random gaps at the start")
      .add_whole("cap", 5000000, 1000, 1000000000, "impulses allowed in a run");
  figure.quick = {"most=5", "duration=0.1", "seeds=4"};
  figure.experiment = measure_stack_impulses;
  return figure;
}

Figure event_search_errata_figure() {
  Figure figure;
  figure.name = "errata_event_search";
  figure.section = "3.2, 3.3.1, 5.1, A.1";
  figure.title = "Five places where the text on finding impacts fails, and the same mended";
  figure.caption =
      "Left: what the text says or leaves open, taken literally. Right: mended. S5: three "
      "cubes on a line; a test of the end of the step alone lets the second fly through the "
      "third. S6: a cube lands at 5 cm/s; its flights get shorter for ever within one step, "
      "unless a flight below a microsecond is the last. S7: a cube pushes another; put "
      "where they overlap, they are found again in each search, put where they are apart, "
      "once. S8: a body 1 mm above the ground; poses by an Euler step from the start meet "
      "the ground after 10.1 ms, the flight and the truth (grey) after 14.3 ms. S9: a cube "
      "lands flat; its corners resolved one after the other tilt it, and another order "
      "tilts it otherwise; resolved together they leave it level.";
  figure.parameters.add_whole("cap", 1000, 20, 100000,
                              "impacts at which an endless step is stopped");
  figure.quick = {"cap=100"};
  figure.experiment = measure_event_search_errata;
  return figure;
}

}  // namespace

void add_response_figures(std::vector<Figure>& list) {
  list.push_back(impact_times_figure());
  list.push_back(rest_figure());
  list.push_back(stack_impulses_figure());
  list.push_back(event_search_errata_figure());
}

}  // namespace tumble::chapters
