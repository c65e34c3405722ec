/// \file
/// \brief Changes of the queue of collisions from one collision to the next (thesis 5.1, A.1).
#include "tumble/base/number_text.hpp"
#include "tumble/timewarp/synchronised_timewarp.hpp"

#include "driver/experiment.hpp"
#include "timewarp/bands.hpp"
#include "timewarp/event_story.hpp"

namespace tumble::chapters {
namespace {

// The state before a collision is taken out of the queue.
struct Moment {
  std::vector<ForeseenCollision> foreseen;  // the earliest first
  std::optional<ForeseenCollision> taken;   // none: the queue is empty
  bool goes_back = false;                   // a neighbour has an earlier collision
  std::vector<Way> valid;                   // by body, up to its valid time
  std::vector<Way> test;                    // by body, from there to the end of the frame
};

// Makes moments of what a timewarp shows.
class MomentKeeper final : public TimewarpWatcher {
 public:
  explicit MomentKeeper(double frame) : frame_(frame) {}

  void on_queue(const TimewarpLook& look) override {
    if (look.current != nullptr) take(*look.current);
    Moment moment;
    moment.foreseen.assign(look.foreseen.begin(), look.foreseen.end());
    ways_.resize(look.valid.size());
    for (std::size_t body = 0; body < ways_.size(); ++body) {
      const Knot valid{look.valid_times[body], look.valid[body].position_w.x()};
      Way& way = ways_[body];
      if (way.empty() || way.back().time < valid.time) way.push_back(valid);
      moment.test.push_back({valid, {frame_, look.test[body].position_w.x()}});
    }
    moment.valid = ways_;
    moments.push_back(moment);
  }

  std::vector<Moment> moments;

 private:
  // A form that looks at neighbours may resolve a collision that was not in the queue.
  void take(const ForeseenCollision& collision) {
    Moment& last = moments.back();
    if (last.foreseen.front() == collision) {
      last.taken = collision;
      return;
    }
    if (!(collision < last.foreseen.front()))
      throw std::runtime_error("more than one collision was put in front of the queue");
    Moment next = last;
    last.taken = last.foreseen.front();
    last.goes_back = true;
    next.foreseen.insert(next.foreseen.begin(), collision);
    next.taken = collision;
    moments.push_back(next);
  }

  double frame_;           // [s]
  std::vector<Way> ways_;  // by body
};

std::string name_of(const ForeseenCollision& collision) {
  const auto letter = [](int body) { return static_cast<char>('A' + body); };
  return {letter(collision.pair.first), '-', letter(collision.pair.second)};
}

// The headings of the panels, and the queue as a list.
std::string words_of(const std::vector<Moment>& moments) {
  std::string commands = "array heading[" + std::to_string(moments.size()) + "]\n" +
                         "array queue[" + std::to_string(moments.size()) + "]\n";
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const Moment& moment = moments[k];
    std::string heading = "nothing is left";
    if (moment.taken) heading = name_of(*moment.taken) + " collides";
    if (moment.goes_back)
      heading = name_of(*moment.taken) + " waits: " + name_of(moments[k + 1].foreseen.front()) +
                " was earlier";
    std::string list = "queue:";
    for (const ForeseenCollision& collision : moment.foreseen)
      list += "\\n" + name_of(collision) + " " + fixed_text(collision.time, 3);
    if (moment.foreseen.empty()) list += "\\nempty";
    const std::string place = std::string("[").append(std::to_string(k + 1)).append("] = ");
    commands += "heading" + place + "'" + heading + "'\n";
    commands += "queue" + place + "\"" + list + "\"\n";
  }
  return commands;
}

// Where a centre is, as far as is known: on its valid way, then on its test way.
double known_place(const Moment& moment, int body, double time) {
  const auto k = static_cast<std::size_t>(body);
  const bool valid = time <= moment.valid[k].back().time;
  return place_at(valid ? moment.valid[k] : moment.test[k], time);
}

Result measure_queue_at_work(const Parameters& settings) {
  const World start =
      build_world(checked(scene_with("line", {"boxes=" + std::string(settings.text("boxes"))})));
  const double frame = settings.number("frame");
  MomentKeeper keeper(frame);
  const auto timewarp = make_technique("timewarp_" + std::string(settings.word("form")));
  dynamic_cast<SynchronisedTimewarp&>(*timewarp).watch(&keeper);
  World world = start;
  const StepReport report = finished(timewarp->step(world, frame));
  const std::vector<Moment>& moments = keeper.moments;

  Table queue{"",
              {{"panel", "-", "from 1"},
               {"time_s", "s", "at which two cubes are foreseen to collide"},
               {"place_m", "m", "halfway between the two then"},
               {"taken", "-", "0 waits, 1 is taken and resolved, 2 is taken and goes back"}}};
  Table ways{"ways",
             {{"panel", "-", "from 1"},
              {"body", "-", "0 is A"},
              {"test", "-", "0 up to the valid time, 1 the test part"},
              {"place_m", "m", "of a corner of its band"},
              {"time_s", "s", "ditto"}}};
  Table dots{"dots",
             {{"panel", "-", "from 1"},
              {"body", "-", "0 is A"},
              {"place_m", "m", "centre in its valid state"},
              {"time_s", "s", "its valid time"},
              {"early_m", "m", "centre at early_s, as far as is known"},
              {"early_s", "s", "a tenth of the frame"}}};
  const double width = start.bodies().front().size.x();
  std::size_t put_in_front = 0;
  std::vector<Quantity> times;  // of collisions that are resolved
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const Moment& moment = moments[k];
    const std::size_t panel = k + 1;
    if (moment.goes_back) ++put_in_front;
    if (moment.taken && !moment.goes_back)
      times.push_back(
          {"time of collision " + std::to_string(times.size() + 1), "s", moment.taken->time});
    for (const ForeseenCollision& foreseen : moment.foreseen) {
      const auto [first, second] = foreseen.pair;
      const double place = 0.5 * (known_place(moment, first, foreseen.time) +
                                  known_place(moment, second, foreseen.time));
      const bool taken = moment.taken && foreseen == *moment.taken;
      queue.add(panel, foreseen.time, place, taken ? (moment.goes_back ? 2.0 : 1.0) : 0.0);
    }
    for (std::size_t body = 0; body < moment.valid.size(); ++body) {
      const Knot& now = moment.valid[body].back();
      const double early = 0.1 * frame;
      dots.add(panel, body, now.place, now.time, known_place(moment, static_cast<int>(body), early),
               early);
      for (const int test : {0, 1})
        for (const Knot& corner :
             band_of(test == 0 ? moment.valid[body] : moment.test[body], width))
          ways.add(panel, body, test, corner.place, corner.time);
    }
  }
  if (static_cast<std::int64_t>(put_in_front) != report.restarts)
    throw std::runtime_error("a collision went back more than once");

  std::vector<Quantity> quantities = {
      {"collisions resolved", "-", times.size()},
      {"collisions put in front because a neighbour was looked at", "-", put_in_front}};
  constexpr int steps = 1000;
  const std::vector<Collision> reference =
      story_of(*search_over_all(), start, frame / steps, steps);
  for (const std::string form : {"safer", "simple"}) {
    const auto technique = make_technique("timewarp_" + form);
    const StoryDifference difference =
        compare_stories(reference, story_of(*technique, start, frame));
    quantities.push_back({"collisions out of place, " + form, "-",
                          std::count(difference.wrong.begin(), difference.wrong.end(), 1)});
  }
  quantities.insert(quantities.end(), times.begin(), times.end());
  return {{queue, ways, dots}, quantities, {{"words", words_of(moments)}}};
}

const Registered queue_at_work_figure{
    {.name = "queue_at_work",
     .parameters = Parameters{}
                       .add_text("boxes", "0:2.7,1.5:0,3:0,4.25:-0.4",
                                 "place and speed of each cube, as x:v in m and m/s")
                       .add_number("frame", 1.0, 1e-3, 100.0, "s", "length of the frame")
                       .add_word("form", {"safer", "simple", "swept"}, "of the timewarp"),
     .experiment = measure_queue_at_work}};

}  // namespace
}  // namespace tumble::chapters
