/// \file
/// \brief The figures on the footnote of thesis 6.2.
#include "exterior_rotation/footnote_figures.hpp"

#include "tumble/base/tolerances.hpp"

#include "exterior_rotation/footnote_experiments.hpp"

namespace tumble::chapters {
namespace {

Figure openings_figure() {
  Figure figure;
  figure.name = "joint_openings";
  figure.section = "6.2";
  figure.title = "Without glue, where does the falling column come apart?";
  figure.caption =
      "The column of figure 6.1 with friction that never slips and joints that cannot pull, by an "
      "error-controlled Runge-Kutta method. Thick lines: faces that hold; dots: edges that boxes "
      "turn about. Below, the centre of pressure of each face on the closed form (dashed) of the "
      "glued column, with the error; it reaches the far edge at the top joint first. From there on "
      "the top box lags behind, so the other joints open later than glue would say. Last, angles "
      "between neighbouring boxes.";
  figure.parameters
      .add_number("angle", 0.1, 0.01, 0.5, "rad", "of the column's centre, at the start")
      .add_number("seconds", 1.9, 0.1, 10.0, "s", "length of the fall")
      .add_number("rate", 480.0, 10.0, 1e4, "1/s", "looks a second");
  figure.quick = {"rate=30"};
  figure.experiment = measure_joint_openings;
  return figure;
}

Figure order_figure() {
  Figure figure;
  figure.name = "event_order";
  figure.section = "6.2";
  figure.title = "What is left of a method's order when joints open on the way?";
  figure.caption =
      "How far a corner of the falling column is off, against the step: after one opening, after "
      "six changes of joints, and the moment of the first opening. Full marks: changes located "
      "within a step; open ones: noticed at its end. Located, each method keeps its order. A late "
      "opening costs the square of the delay; a box that comes apart late costs the delay itself, "
      "for friction lets go at once. Below, the error-controlled method: its estimate does not see "
      "what is late.";
  figure.parameters
      .add_number("angle", 0.3, 0.05, 0.5, "rad", "of the column's centre, at the start")
      .add_number("before", 0.8, 0.1, 10.0, "s", "end of a fall before any opening")
      .add_number("after", 0.86, 0.1, 10.0, "s", "end of a fall after one opening")
      .add_number("late", 1.15, 0.1, 10.0, "s", "end of a fall after several changes of joints")
      .add_whole("fewest", 24, 4, 1000, "steps of a fall")
      .add_whole("most", 768, 8, 100000, "steps of a fall")
      .add_whole("per_doubling", 4, 1, 100, "numbers of steps between one and its double");
  figure.quick = {"most=192", "per_doubling=2"};
  figure.experiment = measure_event_order;
  return figure;
}

Figure contacts_figure() {
  Figure figure;
  figure.name = "claim_6_2f_wrong_contacts";
  figure.section = "6.2";
  figure.title = "Are contacts lost, and found where there are none?";
  figure.caption =
      "The falling column, each contact told from where the bodies are. Above, the changes of "
      "contact by time: filled if the right motion (vertical lines) does not have them within two "
      "steps. Their numbers below, with the right changes that a scheme lacks. Of the schemes that "
      "move centre and orientation apart all but rk4 lose contacts within a tenth of a second; by "
      "the exponential nothing is wrong before the first joint opens. Last, the tolerance: whoever "
      "takes a centimetre for contact sees little of it.";
  figure.parameters
      .add_number("angle", 0.3, 0.01, 0.5, "rad", "of the column's centre, at the start")
      .add_number("seconds", 1.0, 0.1, 10.0, "s", "of the fall")
      .add_number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second")
      .add_number("tolerance", tolerance::contact_gap, 1e-12, 1.0, "-",
                  "distance up to which corners touch, over an edge")
      .add_whole("within", 2, 0, 100, "steps that a change may be early or late")
      .add_whole("per_decade", 5, 1, 100, "tolerances of the sweep");
  figure.quick = {"per_decade=1"};
  figure.experiment = measure_wrong_contacts;
  return figure;
}

}  // namespace

std::vector<Figure> footnote_figures() {
  return {openings_figure(), order_figure(), contacts_figure()};
}

}  // namespace tumble::chapters
