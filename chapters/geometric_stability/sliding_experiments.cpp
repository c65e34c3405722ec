/// \file
/// \brief Steps in which the upper box of figure 5.4 is stable, slides and is slowed down (claim 5.4d).
#include "tumble/pictures/picture.hpp"

#include "geometric_stability/sliding_run.hpp"

namespace tumble::chapters {
namespace {

constexpr std::uint32_t kDark = 0x5a5a5a;   // stable
constexpr std::uint32_t kLight = 0xe2e2e2;  // not stable
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

SlideSetup setup_of(const Parameters& settings, Slider slider) {
  return {.slider = slider, .offset = settings.number("offset"), .speed = settings.number("speed")};
}

// The runs that are counted, of which a corner leaves its support, as one.
struct Counted {
  int runs = 0;
  int until = 0;
  int counted = 0;
  [[nodiscard]] double share() const { return static_cast<double>(counted) / until; }
  // Without the first step of each run, which comes before the first classification.
  [[nodiscard]] double later_share() const { return static_cast<double>(counted) / (until - runs); }
};

Counted count(const Parameters& settings, const SlideSetup& like, Table* table = nullptr) {
  Counted sum;
  for (int k = 0; k < settings.count("speeds"); ++k) {
    SlideSetup setup = like;
    setup.offset = settings.number("offset");
    setup.speed = settings.number("slowest") + k;
    const SlideRun run = slide(setup);
    if (table != nullptr) table->add(setup.speed, run.until(), run.counted());
    if (run.leaves < 0) continue;  // it has stopped before
    ++sum.runs;
    sum.until += run.until();
    sum.counted += run.counted();
  }
  if (sum.until == 0)
    throw std::runtime_error("no corner leaves its support: give a higher speed, or more of them");
  return sum;
}

// Boxes with the colours of stable and other ones.
std::vector<PictureBox> boxes_of(const World& world) {
  const std::vector<char> stable = stable_by_corners(world);
  std::vector<PictureBox> boxes;
  for (std::size_t b = 1; b < stable.size(); ++b)
    boxes.push_back(
        {box_of(world.bodies()[b], world.states()[b]), stable[b] != 0 ? kDark : kLight});
  return boxes;
}

// The speed of the upper box in each run, and where that is one of a stable box.
Table speeds_over_time(const std::vector<SlideRun>& runs) {
  Table table{"", {{"time_s", "s", "time"}}};
  for (const char* name : {"damped", "unmarked", "analytic", "free"}) {
    table.columns.push_back({std::string(name) + "_m_s", "m/s", "speed of the upper box"});
    table.columns.push_back(
        {std::string(name) + "_stable_m_s", "m/s", "the same while all its corners are carried"});
  }
  for (std::size_t k = 0; k < runs[0].worlds.size(); ++k) {
    std::vector<double> row;
    for (const SlideRun& run : runs) {
      const double speed = speed_of_upper(run.worlds[k]);
      row.insert(row.end(), {speed, stable_by_corners(run.worlds[k])[2] != 0 ? speed : kMissing});
    }
    table.add(runs[0].worlds[k].time(), row);
  }
  return table;
}

// The worlds that are drawn: the start, the last one in which all corners are carried, one in which
// the box hangs over, one in which it falls.
std::array<std::size_t, 4> shown(const SlideRun& run) {
  const auto first = [&](const auto& found) {
    std::size_t k = static_cast<std::size_t>(run.until());
    while (k < run.steps.size() && !found(k)) ++k;
    return k;
  };
  constexpr double kOver = 0.55;  // [m] of 1
  constexpr double kFall = 0.3;   // [m] below where the centre was
  const auto height = [&](std::size_t k) { return run.worlds[k].states()[2].position_w.y(); };
  const std::size_t over = first([&](std::size_t k) { return run.steps[k - 1].overhang > kOver; });
  const std::size_t falls = first([&](std::size_t k) { return height(k) < height(0) - kFall; });
  if (falls == run.steps.size())
    throw std::runtime_error("the box does not fall: give it a higher speed");
  return {0, static_cast<std::size_t>(run.leaves), over, falls};
}

void draw(const SlideRun& run, Result& result) {
  Table times{"frames", {{"time_s", "s", "of the drawing"}}};
  std::vector<std::vector<PictureBox>> frames;
  std::vector<PictureBox> all;
  for (const std::size_t k : shown(run)) {
    frames.push_back(boxes_of(run.worlds[k]));
    all.insert(all.end(), frames.back().begin(), frames.back().end());
    times.add(run.worlds[k].time());
  }
  const Camera camera = camera_for(all, Vec3(1.2, 0.9, 4.0), 300.0, 190.0, true);
  for (std::size_t k = 0; k < frames.size(); ++k)
    result.drawings.push_back(
        {"frame" + std::to_string(k + 1), to_gnuplot(draw_boxes(frames[k], camera, true, all))});
  result.tables.push_back(times);
}

Result measure_sliding(const Parameters& settings) {
  constexpr std::array<Slider, 4> kSliders = {Slider::damped, Slider::damped_unmarked,
                                              Slider::analytic_damping, Slider::analytic_free};
  std::vector<SlideRun> runs;
  for (const Slider slider : kSliders) {
    SlideSetup setup = setup_of(settings, slider);
    setup.steps = 90;
    runs.push_back(slide(setup));
    if (runs.back().leaves < 1)
      throw std::runtime_error("no corner leaves its support: give a higher speed");
  }
  const SlideRun& damped = runs[0];

  Result result{.tables = {speeds_over_time(runs)}};

  Table speeds{"speeds",
               {{"speed_m_s", "m/s", "of the upper box at the start"},
                {"steps", "-", "until a corner leaves its support; 0: it stops before"},
                {"counted", "-", "of these, steps in which it is stable, slides and is damped"}}};
  const Counted counted = count(settings, {}, &speeds);
  result.tables.push_back(speeds);
  draw(damped, result);

  // Influence of the marks until the corner leaves.
  double apart = 0.0;
  for (int k = 0; k < damped.until(); ++k) {
    const auto step = static_cast<std::size_t>(k);
    apart = std::max(apart, std::abs(damped.steps[step].speed - runs[1].steps[step].speed));
  }
  const SlideRun& free = runs[3];
  result.quantities = {
      {"share of the steps until a corner leaves its support in which the upper box is stable, "
       "slides, and is slowed down by damping",
       "-", counted.share()},
      {"the same, without the first step of each run", "-", counted.later_share()},
      {"the same, half the damping", "-", count(settings, {.k_scale = 0.5}).share()},
      {"the same, twice the damping", "-", count(settings, {.k_scale = 2.0}).share()},
      {"the same, half the size and speed", "-", count(settings, {.scale = 0.5}).share()},
      {"the same, twice the size and speed", "-", count(settings, {.scale = 2.0}).share()},
      {"largest change of the speed until then with no body marked", "m/s", apart},
      {"speed as a corner leaves, analytic forces without friction, over that at the start", "-",
       free.steps[static_cast<std::size_t>(free.leaves)].speed / settings.number("speed")},
      {"centre beyond the edge with which damping holds the box up for 10 s", "m",
       held_overhang(10.0)}};
  return result;
}

const Registered claim_5_4d_sliding_figure{
    {.name = "claim_5_4d_sliding",
     .parameters = {number("offset", -0.4, -0.5, 0.5, "m",
                           "of the upper box from the middle at the start"),
                    number("speed", 11.0, 1.0, 50.0, "m/s",
                           "of the upper box in the run that is drawn"),
                    number("slowest", 5.0, 0.1, 50.0, "m/s", "of the runs that are counted"),
                    whole("speeds", 10, 1, 50, "of them, 1 m/s apart")},
     .quick = {"slowest=11", "speeds=3"},
     .experiment = measure_sliding}};

}  // namespace
}  // namespace tumble::chapters
