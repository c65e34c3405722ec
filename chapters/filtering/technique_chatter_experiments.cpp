/// \file
/// \brief Chatter of every technique, as a table.
#include "tumble/pictures/lighting.hpp"

#include "driver/experiment.hpp"
#include "filtering/chatter_ranks.hpp"
#include "filtering/chatter_run.hpp"

namespace tumble::chapters {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
// [m] Differences below it mean nothing: solvers stop there, and then there is rounding.
constexpr double kQuiet = 1e-9;
constexpr double kLoud = 1e-2;  // [m] where the colours end
constexpr double kFell = 0.5;   // [m] half an edge: what gets farther from its place in a pile fell
constexpr std::size_t kScenes = 4;
constexpr std::size_t kDamped = 1;  // a technique that is never left out
// The cells that the text compares, by scene and technique.
constexpr std::array<std::array<std::size_t, 2>, 4> kCompared = {
    {{1, 0}, {1, kDamped}, {1, 3}, {2, 0}}};

struct Rested {
  std::string words;
  PlayedTechnique technique;
  std::array<bool, kScenes> soon = {true, true, true, true};  // false: for the patient
};

// With Coulomb's friction, forces are searched for in hundreds of unknowns once the boxes of a pyramid
// touch one another: minutes for a frame, or no solution. Impulses of 27 cubes take four seconds.
std::vector<Rested> techniques_at_rest() {
  return {
      {"impulse", {"impulse"}, {true, true, true, false}},
      {"damped", {"damped"}},
      {"the repaired listings of damped", {"damped", {"reading=as_printed", "repaired=all"}}},
      {"contact_damped", {"contact_damped"}},
      {"analytic with damping", {"analytic", {"friction=damping"}}},
      {"analytic", {"analytic"}, {true, false, false, false}},
      {"time_stepping", {"time_stepping", {"directions=4"}}, {true, true, true, false}},
  };
}

// What has no resting contact, in the order of the thesis.
constexpr std::array<const char*, 5> kRestless = {"basic", "timewarp_simple", "timewarp_safer",
                                                  "timewarp_swept", "timewarp_full"};

struct Start {
  std::string scene;
  std::vector<std::string> settings;
  double settling = 0.0;  // [s]
  bool stands = false;    // a pile: its boxes begin where they should stay
};

std::array<Start, kScenes> starts_of(const Parameters& p) {
  const auto whole = [&](const char* key, const char* setting) {
    return std::string(setting) + '=' + std::to_string(p.count(key));
  };
  const std::string shift = setting("scatter", p.number("scatter"));
  const std::string turn = setting("scatter_angle", p.number("scatter_angle"));
  const double settling = p.number("settling");
  const double flying = p.number("flying");
  return {Start{"stack", {whole("boxes", "count"), shift, turn}, settling, true},
          Start{"pyramid", {whole("rows", "rows"), shift, turn}, settling, true},
          Start{"fig6_7", {whole("small", "per_edge")}, flying, false},
          Start{"fig6_7", {whole("large", "per_edge")}, flying, false}};
}

// One technique with one scene, over seeds.
struct Cell {
  MedianRange amplitude = median_range({});  // [m] of the worst body; NaN until there is one
  double acceleration = kNone;               // [-] of the worst body, median
  double restless = 0.0;                     // bodies of all seeds that do not rest
  double cubes = 0.0;                        // in the scene
  double fell = 0.0;                         // seeds in which a pile fell
  double unsolved = 0.0;                     // seeds in which a step was not solved
  double seeds = 0.0;
  double capped = 0.0;      // share of steps that met the cap of events
  double collisions = 0.0;  // a step while watched
  bool calm = true;         // it stands and something rests, whatever the seed
  int rank = 0;             // among the calm ones of a scene; 0: none
  bool tied = false;        // others have this rank too
};

Cell cell_of(const Parameters& p, int count, const Start& start, const PlayedTechnique& technique) {
  Cell cell;
  std::vector<double> amplitudes;
  std::vector<double> accelerations;
  double steps = 0.0;
  const double watched = p.number("watched");
  for (int seed = 1; seed <= count; ++seed) {
    const auto number = static_cast<std::uint64_t>(seed);
    const ChatterRun run = chatter_of(scene_with(start.scene, start.settings, number), technique,
                                      start.settling, watched, number);
    const bool fell = start.stands && run.displaced > kFell;
    const bool counts = !fell && run.solved && !run.resting.empty();
    cell.cubes = run.bodies;
    cell.restless += run.restless();
    cell.fell += fell ? 1.0 : 0.0;
    cell.unsolved += run.solved ? 0.0 : 1.0;
    cell.seeds += 1.0;
    cell.capped += static_cast<double>(run.capped);
    cell.collisions += static_cast<double>(run.last_collisions) / (watched / kStep);
    steps += static_cast<double>(run.steps);
    cell.calm = cell.calm && counts;
    if (counts) {
      amplitudes.push_back(run.amplitude());
      accelerations.push_back(run.acceleration());
    }
  }
  cell.amplitude = median_range(amplitudes);
  cell.acceleration = median_range(accelerations).median;
  cell.capped /= steps;
  cell.collisions /= cell.seeds;
  return cell;
}

// Pale, so that letters can be read: from blue to vermilion on a scale of powers.
std::uint32_t colour_of(double amplitude) {
  constexpr std::uint32_t cold = 0xc4e2f5, middle = 0xf8f3dc, hot = 0xf2a57c;
  const double clipped = std::clamp(amplitude, kQuiet, kLoud);
  const double place = elementary::log(clipped / kQuiet) / elementary::log(kLoud / kQuiet);
  return place < 0.5 ? mixed(cold, middle, 2.0 * place) : mixed(middle, hot, 2.0 * place - 1.0);
}

void rank(std::vector<Cell>& cells) {
  std::vector<Cell*> calm;
  std::vector<MedianRange> ranges;
  for (Cell& cell : cells) {
    if (cell.seeds == 0.0 || !cell.calm) continue;
    calm.push_back(&cell);
    ranges.push_back(cell.amplitude);
  }
  const std::vector<int> ranks = shared_ranks(ranges, kQuiet);
  for (std::size_t k = 0; k < calm.size(); ++k) {
    calm[k]->rank = ranks[k];
    calm[k]->tied = std::count(ranks.begin(), ranks.end(), ranks[k]) > 1;
  }
}

Table techniques_without(const Parameters& p, const Start& start) {
  Table table{"without",
              {{"technique", "-", "0: basic, then timewarp simple, safer, swept, full"},
               {"amplitude_m", "m", "largest of a box that rests, median over seeds; empty: none"},
               {"acceleration", "-", "the same, over that of a free fall"},
               {"restless", "-", "boxes that do not rest, share of all"},
               {"fell", "-", "seeds in which the stack fell"},
               {"seeds", "-", "of all"},
               {"capped", "-", "share of steps that met the cap of collisions"},
               {"collisions", "-", "in a step, while watched"}}};
  for (std::size_t k = 0; k < kRestless.size(); ++k) {
    const Cell cell = cell_of(p, p.count("others"), start, {kRestless[k]});
    table.add(k, cell.amplitude.median, cell.acceleration,
              cell.restless / (cell.cubes * cell.seeds), cell.fell, cell.seeds, cell.capped,
              cell.collisions);
  }
  return table;
}

Table shades() {
  Table bar{"bar",
            {{"amplitude_m", "m", "an amplitude"}, {"colour", "-", "its colour as 0xRRGGBB"}}};
  constexpr int steps = 70;
  for (int k = 0; k <= steps; ++k) {
    const double amplitude =
        kQuiet * elementary::pow(kLoud / kQuiet, static_cast<double>(k) / steps);
    bar.add(amplitude, colour_of(amplitude));
  }
  return bar;
}

// Chatter of every technique on a stack, a pyramid and two clumps, with ranks: by the medians over seeds of
// the amplitude of the body that shakes most; what fell, or never rested, has no rank.
Result tabulate_chatter(const Parameters& settings) {
  const std::vector<Rested> rested = techniques_at_rest();
  const std::array<Start, kScenes> starts = starts_of(settings);
  const bool patient = settings.flag("patient");
  Table table{
      "",
      {{"technique", "-", "its row, from 0"},
       {"scene", "-", "0: stack, 1: pyramid, 2: small clump, 3: large clump"},
       {"cubes", "-", "in the scene"},
       {"run", "-", "0: left out, it would take too long"},
       {"amplitude_m", "m", "largest of a cube that rests, median over seeds"},
       {"amplitude_low_m", "m", "lower end of its interval of 95 %"},
       {"amplitude_high_m", "m", "upper end"},
       {"acceleration", "-", "largest, over that of a free fall, median over seeds"},
       {"restless", "-", "cubes that do not rest, of all seeds"},
       {"all_cubes", "-", "of all seeds"},
       {"fell", "-", "seeds in which a cube of a pile left its place"},
       {"unsolved", "-", "seeds in which a step was not solved"},
       {"rank", "-", "1, and one more for each whose interval is wholly below; empty: none"},
       {"tied", "-", "1: others have this rank too"},
       {"colour", "-", "0xRRGGBB"}}};
  Result result;
  const std::array<std::string, kScenes> words = {"stack", "pyramid", "small clump", "large clump"};
  for (std::size_t s = 0; s < kScenes; ++s) {
    std::vector<Cell> cells(rested.size());
    for (std::size_t t = 0; t < rested.size(); ++t)
      if (rested[t].soon[s] || patient)
        cells[t] = cell_of(settings, settings.count("seeds"), starts[s], rested[t].technique);
    rank(cells);
    const double cubes = cells[kDamped].cubes;
    for (std::size_t t = 0; t < rested.size(); ++t) {
      const Cell& cell = cells[t];
      table.add(t, s, cubes, cell.seeds > 0.0 ? 1.0 : 0.0, cell.amplitude.median,
                cell.amplitude.low, cell.amplitude.high, cell.acceleration, cell.restless,
                cell.cubes * cell.seeds, cell.fell, cell.unsolved,
                cell.rank > 0 ? cell.rank : kNone, cell.tied ? 1.0 : 0.0,
                cell.rank > 0 ? colour_of(cell.amplitude.median) : 0xeeeeee);
      if (cell.rank > 0 &&
          std::count(kCompared.begin(), kCompared.end(), std::array<std::size_t, 2>{s, t}) > 0)
        result.add(words[s] + ": amplitude of " + rested[t].words, "mm",
                   1e3 * cell.amplitude.median, 1e3 * cell.amplitude.low, 1e3 * cell.amplitude.high,
                   static_cast<int>(cell.seeds));
    }
  }
  result.tables = {table, techniques_without(settings, starts[0]), shades()};
  return result;
}

const Registered chatter_table_figure{
    {.name = "chatter_table",
     .parameters =
         Parameters{}
             .add_whole("seeds", 6, 1, 100, "random starts")
             .add_whole("others", 3, 1, 100, "of these, for techniques without resting contact")
             .add_whole("boxes", 5, 1, 20, "of the stack")
             .add_whole("rows", 5, 1, 10, "of the pyramid")
             .add_whole("small", 2, 2, 3, "cubes along each edge of the small clump's grid")
             .add_whole("large", 3, 2, 6, "cubes along each edge of the large clump's grid")
             .add_number("scatter", 0.01, 0.0, 0.1, "m",
                         "how far boxes of piles are off their places")
             .add_number("scatter_angle", 0.0, 0.0, 10.0, "deg", "and by how much they are turned")
             .add_number("settling", 2.0, 0.0, 60.0, "s", "before boxes of piles should rest")
             .add_number("flying", 5.0, 0.0, 60.0, "s", "before cubes of clumps should rest")
             .add_number("watched", 1.0, 0.5, 60.0, "s", "after that")
             .add_flag("patient", false, "run what takes minutes too"),
     .quick = {"seeds=1", "boxes=3", "rows=2", "large=2", "settling=1", "flying=1.5",
               "watched=0.5"},
     .experiment = tabulate_chatter}};

}  // namespace
}  // namespace tumble::chapters
