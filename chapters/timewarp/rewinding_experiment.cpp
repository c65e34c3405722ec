/// \file
/// \brief Claim 2.4.3a: all bodies taken back for a collision, or only those near it.
#include "timewarp/cage_runs.hpp"

namespace tumble::chapters {
namespace {

constexpr int kMost = 512;  // bodies of the claim

// A form, and its names in columns and in words.
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

// The claim's ratio, of any count.
double all_over_near(const std::array<Works, 5>& works, double CageWork::*count, int left_out) {
  return per_event(works[kAll], count, left_out) / per_event(works[kSimple], count, left_out);
}

// The fewer bodies there are, the longer it takes until as many collisions have been seen.
CageStretch counted_stretch(const Parameters& settings, int count) {
  CageStretch stretch = stretch_of(settings, count);
  stretch.frames = settings.count("frames") * kMost / count;
  return stretch;
}

// Adds the work of one cage under the first so many forms.
void add_works(const World& led, const CageStretch& stretch, std::size_t how_many,
               std::array<Works, 5>& works) {
  const SettledCage cage = settled_cage(led, stretch);
  // Flights of several frames: counted are as many frames as make whole flights.
  CageStretch whole = stretch;
  whole.frames = (stretch.frames + kLongFlight - 1) / kLongFlight * kLongFlight;
  for (std::size_t i = 0; i < how_many; ++i)
    works[i].push_back(work_of(cage, forms()[i].form.settles ? whole : stretch, forms()[i].form));
}

Table table_by_number() {
  Table table{"", {{"bodies", "-", "cubes in the cage"}}};
  for (const auto& [form, column, words] : forms()) {
    table.columns.push_back({column, "-", std::string("integrations per collision, ") + words});
    table.columns.push_back(
        {std::string(column) + "_tests", "-", std::string("pair tests per collision, ") + words});
  }
  table.columns.push_back({"fixed", "-", "flights of all bodies in a frame, per collision"});
  return table;
}

void add_number(int bodies, const std::array<Works, 5>& works, Table& table) {
  std::vector<double> each;
  for (const Works& form : works)
    for (double CageWork::*const count : {&CageWork::integrations, &CageWork::pair_tests})
      each.push_back(per_event(form, count));
  table.add(bodies, each, bodies * per_event(works[kAll], &CageWork::frames));
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
  Table table{"rates", {{"in_frame", "-", "collisions in a frame"}}};
  add_interval_columns("ratio", "-", "integrations per collision, all taken back over simple",
                       table);
  for (const auto& forms_at_rate : works)
    table.add(1.0 / per_event(forms_at_rate[kAll], &CageWork::frames),
              with_interval(over_seeds("", "-", seeds, [&](int left_out) {
                return all_over_near(forms_at_rate, &CageWork::integrations, left_out);
              })));
  return table;
}

Result measure_rewinding(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  Table table = table_by_number();
  std::array<Works, 5> works;
  std::array<std::array<Works, 5>, 4> by_rate;
  for (const int edge : {2, 3, 4, 6, 8}) {
    const CageStretch stretch = counted_stretch(settings, edge * edge * edge);
    works = {};
    for (int seed = 1; seed <= seeds; ++seed) {
      const World& led = led_cage(stretch, seed);
      add_works(led, stretch, forms().size(), works);
      for (std::size_t i = 0; i < kFactors.size(); ++i)
        if (stretch.count == kMost && i != kAsItIs)
          add_works(led, hurried(settings, i), 2, by_rate[i]);
    }
    add_number(stretch.count, works, table);
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
      {"the first number with a sixteenth of the speeds", "-", slow[1], slow[2], slow[3], seeds});
  quantities.push_back({"collisions in a frame with a sixteenth of the speeds", "-", slow[0]});
  return {{table, rates}, quantities};
}

const Registered claim_2_4_3a_rewinding_figure{
    {.name = "claim_2_4_3a_rewinding",
     .parameters = cage_settings().add(whole(
         "frames", 2, 1, 100, "in which the work of 512 bodies is counted; of fewer bodies, more")),
     .quick = {"seeds=2", "lead=20"},
     .experiment = measure_rewinding}};

}  // namespace

}  // namespace tumble::chapters
