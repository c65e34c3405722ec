/// \file
/// \brief Work saved if stable boxes are left out of the contact forces (thesis 5.4).
#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/resting_pile.hpp"

namespace tumble::chapters {
namespace {

const char* const kOurSolver = "augmented_lagrangian";
constexpr int kTouchingRows = 7;  // of the pyramid without gaps, a second measurement

// The work of a solver with all boxes and without the stable ones.
struct Work {
  RestingForces all;
  RestingForces left;
  [[nodiscard]] double saved() const {
    return static_cast<double>(all.report.multiplications) /
           static_cast<double>(left.report.multiplications);
  }
};

Work work_of(const RestingPile& pile, const char* solver) {
  return {forces_of(pile, solver, StableRule::off), forces_of(pile, solver, StableRule::corners)};
}

// The work of one size, with the solver of the thesis and with ours.
struct Size {
  Work baraff;
  Work ours;
  ForceChange change;
  int boxes = 0;
};

// Whether Baraff's pivoting has ended at its cap, so that BaraffSolver went on with the factors.
bool gave_up(const RestingForces& forces) {
  constexpr int kCap = 50;  // pivots for each contact, and as many more
  return forces.report.pivots > kCap * (forces.report.unknowns + 1);
}

Size measure_size(int rows, double gap) {
  const RestingPile pile = pyramid_without_middle(rows, gap);
  Size size{work_of(pile, "baraff"), work_of(pile, kOurSolver), {}, pile.world.count() - 1};
  for (const Work* work : {&size.baraff, &size.ours}) {
    const ForceChange change = change_of(pile, work->all, work->left);
    size.change.acceleration = std::max(size.change.acceleration, change.acceleration);
    size.change.wrench = std::max(size.change.wrench, change.wrench);
  }
  return size;
}

// The sizes from three rows on, and of the one that decides.
Table size_table(const std::map<int, Size>& sizes) {
  Table table{"",
              {{"rows", "-", "boxes in the lowest row before one is taken out"},
               {"boxes", "-", "of the pyramid"},
               {"stable", "-", "boxes that are left out"},
               {"unknowns_all", "-", "contact points, all boxes"},
               {"unknowns_left", "-", "contact points, without stable boxes"},
               {"pivots_all", "-", "of Baraff's method, all boxes"},
               {"pivots_left", "-", "of Baraff's method, without stable boxes"},
               {"gave_up_all", "-", "1: Baraff's pivoting ended at its cap, all boxes"},
               {"gave_up_left", "-", "1: the same, without stable boxes"},
               {"baraff_all", "-", "multiplications of Baraff's method, all boxes"},
               {"baraff_left", "-", "the same without stable boxes"},
               {"baraff_saved", "-", "their ratio"},
               {"ours_all", "-", "multiplications of our default solver, all boxes"},
               {"ours_left", "-", "the same without stable boxes"},
               {"ours_saved", "-", "their ratio"}}};
  for (const auto& [rows, size] : sizes) {
    const ForceReport& all = size.baraff.all.report;
    const ForceReport& left = size.baraff.left.report;
    table.add(rows, size.boxes, left.stable, all.unknowns, left.unknowns, all.pivots, left.pivots,
              gave_up(size.baraff.all), gave_up(size.baraff.left), all.multiplications,
              left.multiplications, size.baraff.saved(), size.ours.all.report.multiplications,
              size.ours.left.report.multiplications, size.ours.saved());
  }
  return table;
}

// Influence of the order of contacts on Baraff's method.
Quantity saved_in_any_order(int rows, double gap, int orders) {
  std::vector<double> all;
  std::vector<double> left;
  for (int order = 1; order <= orders; ++order) {
    RestingPile pile = pyramid_without_middle(rows, gap);
    Random random(static_cast<std::uint64_t>(order));
    shuffle(pile.contacts, random);
    const Work work = work_of(pile, "baraff");
    all.push_back(static_cast<double>(work.all.report.multiplications));
    left.push_back(static_cast<double>(work.left.report.multiplications));
  }
  return ratio_of_sums("the same with " + std::to_string(rows) + " rows, contacts in random orders",
                       "-", all, left);
}

double sum(const std::vector<double>& values) { return sum_without(values, -1); }

// The gain while the pyramid is simulated: at rest, knocked, and one that falls.
void measure_runs(const Parameters& settings, Result& result) {
  const int steps = settings.count("steps");
  const int seeds = settings.count("seeds");
  const double gap = settings.number("gap");
  const CountedRun rests = count_run(knocked_pyramid(settings.count("rows"), gap, 0.0, 1), steps);
  const CountedRun falls = count_run(knocked_pyramid(3, gap, 0.0, 1), steps);
  std::vector<double> all(static_cast<std::size_t>(steps), 0.0);  // by step, of all seeds
  std::vector<double> left = all;
  std::vector<double> all_of;  // by seed
  std::vector<double> left_of;
  for (int seed = 1; seed <= seeds; ++seed) {
    const CountedRun run =
        count_run(knocked_pyramid(settings.count("knocked_rows"), gap, settings.number("knock"),
                                  static_cast<std::uint64_t>(seed)),
                  steps);
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k] += run.all[k];
      left[k] += run.left[k];
    }
    all_of.push_back(sum(run.all));
    left_of.push_back(sum(run.left));
  }
  Table table{"run",
              {{"time_s", "s", "at the start of a step"},
               {"rests", "-", "unknowns, all boxes over those not stable: at rest"},
               {"knocked", "-", "ditto: knocked, all seeds together"},
               {"falls", "-", "ditto: three rows, which fall"}}};
  for (std::size_t k = 0; k < all.size(); ++k)
    table.add(static_cast<double>(k) / 60.0, rests.all[k] / rests.left[k], all[k] / left[k],
              falls.all[k] / falls.left[k]);
  result.tables.push_back(table);
  const std::string which = "unknowns of a run, all boxes over those that are not stable, ";
  result.add(which + "at rest", "-", sum(rests.all) / sum(rests.left));
  result.add(ratio_of_sums(which + "knocked", "-", all_of, left_of));
  result.add(which + "three rows that fall", "-", sum(falls.all) / sum(falls.left));
}

Result measure_excluded(const Parameters& settings) {
  const int rows = settings.count("rows");
  const double gap = settings.number("gap");
  std::map<int, Size> sizes;
  for (int size = 3; size <= settings.count("largest"); size += 2)
    sizes.emplace(size, measure_size(size, gap));
  if (sizes.find(rows) == sizes.end()) sizes.emplace(rows, measure_size(rows, gap));
  ForceChange change;
  int solved = 0;  // rows of the largest pyramid that pivoting alone solves
  for (const auto& [count, size] : sizes) {
    change.acceleration = std::max(change.acceleration, size.change.acceleration);
    change.wrench = std::max(change.wrench, size.change.wrench);
    if (!gave_up(size.baraff.all)) solved = count;
  }
  const Work& baraff = sizes.at(rows).baraff;
  const Work& ours = sizes.at(rows).ours;
  const auto over = [](auto all, auto left) {
    return static_cast<double>(all) / static_cast<double>(left);
  };
  const double cut = over(ours.all.report.unknowns, ours.left.report.unknowns);
  Result result{.tables = {size_table(sizes)}};
  result.quantities = {
      {"multiplications of Baraff's method for the pyramid of figure 5.6 with " +
           std::to_string(rows) + " rows, all boxes over the boxes that are not stable",
       "-", baraff.saved()},
      saved_in_any_order(settings.count("shuffled_rows"), gap, settings.count("seeds")),
      {"multiplications of Baraff's method for the pyramid of figure 5.6 with 7 rows that touch, "
       "all boxes over the boxes that are not stable",
       "-", work_of(pyramid_without_middle(kTouchingRows, 0.0), "baraff").saved()},
      {"the same, the cube of the unknowns", "-", cut * cut * cut},
      {"the same, our default solver", "-", ours.saved()},
      {"multiplications of Baraff's method over those of our default solver, all boxes", "-",
       over(baraff.all.report.multiplications, ours.all.report.multiplications)},
      {"rows of the largest pyramid that Baraff's pivoting solves with all boxes", "-", solved},
      {"largest change of an acceleration, over g", "-", change.acceleration},
      {"largest change of a box's net contact force and torque, over its weight", "-",
       change.wrench}};
  measure_runs(settings, result);
  return result;
}

const Registered claim_5_4b_excluded_figure{
    {.name = "claim_5_4b_excluded",
     .parameters = {whole("rows", 11, 3, 21, "of the pyramid that decides; an odd number"),
                    whole("largest", 13, 3, 21, "rows of the largest pyramid"),
                    number("gap", 0.05, 0.0, 0.9, "-", "between neighbours, in edges"),
                    whole("shuffled_rows", 7, 3, 11, "of the one whose contacts are shuffled; odd"),
                    whole("knocked_rows", 5, 3, 11,
                          "of the pyramid that is knocked; an odd number"),
                    number("knock", 0.2, 0.0, 2.0, "m/s",
                           "largest component of a velocity at the start"),
                    whole("seeds", 20, 2, 1000, "knocks, and orders of contacts"),
                    whole("steps", 60, 1, 6000, "of 1/60 s")},
     .quick = {"rows=7", "largest=7", "shuffled_rows=5", "seeds=2", "steps=20"},
     .experiment = measure_excluded}};

}  // namespace
}  // namespace tumble::chapters
