/// \file
/// \brief Claim 2.4.3a: all bodies taken back for a collision, or only those near it.
#include "driver/statistics.hpp"
#include "timewarp/cage_runs.hpp"
#include "timewarp/rewind_experiments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tumble::chapters {
namespace {

constexpr int kMost = 512;  // bodies of the claim

// A form, and what it is called in columns and in words.
struct NamedForm {
  TimewarpForm form;
  const char* column;
  const char* words;
};

// Full timewarp without synchronisation is what bodies near a collision cost at the least.
const std::array<NamedForm, 5>& forms() {
  static const std::array<NamedForm, 5> list = {
      NamedForm{all_taken_back(), "all", "all taken back"},
      NamedForm{{"timewarp_simple"}, "simple", "simple"},
      NamedForm{{"timewarp_safer"}, "safer", "safer"},
      NamedForm{{"timewarp_swept"}, "swept", "swept"},
      NamedForm{full_timewarp(), "full", "full timewarp"}};
  return list;
}
constexpr std::size_t kAll = 0;
constexpr std::size_t kSimple = 1;
constexpr std::size_t kFull = 4;  // the last one

using Works = std::vector<CageWork>;  // by seed

// What remains of the integrations if each frame's flights of all bodies are taken off.
double per_event_alone(const Works& works, int bodies, int left_out) {
  return (total(works, &CageWork::integrations, left_out) -
          bodies * total(works, &CageWork::frames, left_out)) /
         total(works, &CageWork::events, left_out);
}

// The claim's ratio, of any count.
double all_over_near(const std::array<Works, 5>& works, double CageWork::*count, int left_out) {
  return per_event(works[kAll], count, left_out) / per_event(works[kSimple], count, left_out);
}

CageStretch stretch_of(const Parameters& settings, int count) {
  CageStretch stretch;
  stretch.count = count;
  stretch.speed = settings.number("speed");
  stretch.spin = settings.number("spin");
  stretch.lead = settings.count("lead");
  stretch.settle = kLongFlight;
  // The fewer bodies there are, the longer it takes until as many collisions have been seen.
  stretch.frames = settings.count("frames") * kMost / count;
  return stretch;
}

// Adds what one cage costs under the first so many forms.
void add_works(const World& led, const CageStretch& stretch, std::size_t how_many,
               std::array<Works, 5>& works) {
  const SettledCage cage = settled_cage(led, stretch);
  // Flights of several frames: counted are as many frames as make whole flights.
  CageStretch whole = stretch;
  whole.frames = (stretch.frames + kLongFlight - 1) / kLongFlight * kLongFlight;
  for (std::size_t i = 0; i < how_many; ++i)
    works[i].push_back(work_of(cage, i == kFull ? whole : stretch, forms()[i].form));
}

Table table_by_number() {
  Table table{"", {{"bodies", "-", "cubes in the cage"}}};
  for (const NamedForm& named : forms()) {
    const std::string column = named.column;
    const std::string words = named.words;
    table.columns.push_back({column, "-", "integrations per collision, " + words});
    table.columns.push_back({column + "_low", "-", "lower end of its interval of 95 %"});
    table.columns.push_back({column + "_high", "-", "upper end of it"});
    if (column != "full")
      table.columns.push_back(
          {column + "_alone", "-", "the same without one flight of each body in a frame"});
    table.columns.push_back({column + "_tests", "-", "pair tests per collision, " + words});
    table.columns.push_back({column + "_back", "-", "bodies taken back per collision, " + words});
  }
  table.columns.push_back({"in_frame", "-", "collisions in a frame"});
  table.columns.push_back({"fixed", "-", "flights of all bodies in a frame, per collision"});
  return table;
}

std::vector<double> row_by_number(int count, const std::array<Works, 5>& works, int seeds) {
  std::vector<double> row = {static_cast<double>(count)};
  for (std::size_t i = 0; i < works.size(); ++i) {
    const Quantity integrations = over_seeds("", "-", seeds, [&](int left_out) {
      return per_event(works[i], &CageWork::integrations, left_out);
    });
    row.insert(row.end(), {integrations.value, integrations.low, integrations.high});
    if (i != kFull) row.push_back(per_event_alone(works[i], count, -1));
    row.push_back(per_event(works[i], &CageWork::pair_tests, -1));
    row.push_back(per_event(works[i], &CageWork::rewinds, -1));
  }
  const double frames_per_event = per_event(works[kAll], &CageWork::frames, -1);
  row.insert(row.end(), {1.0 / frames_per_event, count * frames_per_event});
  return row;
}

// Other speeds. Without gravity, bodies twice as fast are frames twice as long.
constexpr std::array<double, 4> kFactors = {1.0 / 16, 1.0 / 4, 1.0, 2.0};
constexpr std::size_t kAsItIs = 2;

CageStretch hurried(const Parameters& settings, std::size_t factor) {
  CageStretch stretch = stretch_of(settings, kMost);
  stretch.factor = kFactors[factor];
  stretch.settle = 0;
  const double frames = 0.5 * settings.count("frames") / stretch.factor;
  stretch.frames = std::clamp(static_cast<int>(frames), 1, 16);
  return stretch;
}

Table table_by_rate(const std::array<std::array<Works, 5>, 4>& works, int seeds) {
  Table table{"rates",
              {{"factor", "-", "of all speeds"},
               {"in_frame", "-", "collisions in a frame"},
               {"ratio", "-", "integrations per collision, all taken back over simple"},
               {"low", "-", "lower end of its interval of 95 %"},
               {"high", "-", "upper end of it"},
               {"closed", "-", "the same from collisions in a frame, 4 flights for each"}}};
  for (std::size_t i = 0; i < kFactors.size(); ++i) {
    const Quantity ratio = over_seeds("", "-", seeds, [&](int left_out) {
      return all_over_near(works[i], &CageWork::integrations, left_out);
    });
    const double in_frame = 1.0 / per_event(works[i][kAll], &CageWork::frames, -1);
    table.rows.push_back({kFactors[i], in_frame, ratio.value, ratio.low, ratio.high,
                          kMost * (in_frame + 1.0) / (4.0 * in_frame + kMost)});
  }
  return table;
}

}  // namespace

Result measure_rewinding(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  Table table = table_by_number();
  std::array<Works, 5> works;
  std::array<std::array<Works, 5>, 4> by_rate;
  for (const int edge : {2, 3, 4, 6, 8}) {
    const CageStretch stretch = stretch_of(settings, edge * edge * edge);
    works = {};
    for (int seed = 1; seed <= seeds; ++seed) {
      const World led = led_cage(stretch, seed);
      add_works(led, stretch, forms().size(), works);
      for (std::size_t i = 0; i < kFactors.size(); ++i)
        if (stretch.count == kMost && i != kAsItIs)
          add_works(led, hurried(settings, i), 2, by_rate[i]);
    }
    table.rows.push_back(row_by_number(stretch.count, works, seeds));
  }
  by_rate[kAsItIs] = works;  // of 512 bodies, which came last
  const Table rates = table_by_rate(by_rate, seeds);

  std::vector<Quantity> quantities;
  const auto add = [&](const std::string& name, const auto& estimate) {
    quantities.push_back(over_seeds(name, "-", seeds, estimate));
  };
  add("integrations per event of 512 bodies at constant density, all taken back over those near",
      [&](int k) { return all_over_near(works, &CageWork::integrations, k); });
  for (std::size_t i = 0; i < forms().size(); ++i)
    add(std::string("integrations per event of 512 bodies, ") + forms()[i].words,
        [&](int k) { return per_event(works[i], &CageWork::integrations, k); });
  add("of them under all but full timewarp, the flights of all bodies that each frame has anyway",
      [&](int k) { return kMost * per_event(works[kSimple], &CageWork::frames, k); });
  add("collisions of 512 bodies in a frame",
      [&](int k) { return 1.0 / per_event(works[kAll], &CageWork::frames, k); });
  add("bodies taken back per event of 512, simple",
      [&](int k) { return per_event(works[kSimple], &CageWork::rewinds, k); });
  add("pair tests per event of 512 bodies, all taken back over those near",
      [&](int k) { return all_over_near(works, &CageWork::pair_tests, k); });
  const std::vector<double>& slow = rates.rows.front();
  quantities.push_back(
      {"the first number with a sixteenth of the speeds", "-", slow[2], slow[3], slow[4], seeds});
  quantities.push_back({"collisions in a frame with a sixteenth of the speeds", "-", slow[1]});
  return {{table, rates}, quantities};
}

}  // namespace tumble::chapters
