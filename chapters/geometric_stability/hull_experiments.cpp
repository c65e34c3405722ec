/// \file
/// \brief Which of two rules is right where they differ.
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/tolerances.hpp"

#include "geometric_stability/disputes.hpp"
#include "geometric_stability/pile_levels.hpp"

namespace tumble::chapters {
namespace {

// Kinds of bodies, as the rows of the table.
enum Kind { kOverhang, kSide, kOther, kTriangle, kHexagon, kCut, kTower, kKinds };

struct KindCount {
  double tried = 0.0;
  double text = 0.0;        // called stable by it
  double hull = 0.0;        // called stable by it
  double hull_wrong = 0.0;  // of all that were tried
  double differ = 0.0;      // the rules do
  double right = 0.0;       // the hull is, where they differ

  // Of those on which the rules differ.
  [[nodiscard]] double share_right() const { return right / differ; }
};

void add(const Trial& trial, KindCount& count) {
  count.tried += 1.0;
  count.text += trial.text ? 1.0 : 0.0;
  count.hull += trial.hull ? 1.0 : 0.0;
  count.hull_wrong += trial.hull_right() ? 0.0 : 1.0;
  if (!trial.differ()) return;
  count.differ += 1.0;
  count.right += trial.hull_right() ? 1.0 : 0.0;
}

// Why the footnote refuses a body that has all four corners held: the fault of the support that it names.
Kind kind_of(const Trial& trial) {
  GeometricStability rules({tolerance::exact_vertical, tolerance::exact_corner});
  std::vector<char> stable;
  rules.run(trial.world, trial.contacts, StableRule::hull, tolerance::resting_speed, stable);
  const StabilityVerdict verdict = rules.verdict(trial.world, trial.body);
  if (verdict.reason != StabilityReason::unstable_support) return kOther;
  const Contact& contact = trial.contacts[idx(verdict.contact)];
  const int below = contact.first == trial.body ? contact.second : contact.first;
  const StabilityReason reason = rules.verdict(trial.world, below).reason;
  if (reason == StabilityReason::corner) return kOverhang;
  return reason == StabilityReason::side_contact ? kSide : kOther;
}

// The plainest trial so far: the least spread, and of equals the fewest contacts.
void keep_plainest(const Trial& trial, std::optional<Trial>& kept) {
  const auto key = [](const Trial& t) { return std::pair(spread_of(t), t.contacts.size()); };
  if (!kept || key(trial) < key(*kept)) kept = trial;
}

Result measure_hull(const Parameters& settings) {
  std::array<KindCount, kKinds> kinds;
  std::vector<double> differ;  // by pile
  std::vector<double> right;   // by pile
  double text_false = 0.0;
  double hull_false = 0.0;
  std::array<std::optional<Trial>, 4> drawn;
  for (std::int64_t k = 1; k <= settings.count("piles"); ++k) {
    differ.push_back(0.0);
    right.push_back(0.0);
    for (const Trial& trial : pile_disputes(static_cast<std::uint64_t>(k))) {
      const Kind kind = kind_of(trial);
      add(trial, kinds[kind]);
      differ.back() += 1.0;
      right.back() += trial.hull_right() ? 1.0 : 0.0;
      text_false += trial.text && trial.moves ? 1.0 : 0.0;
      hull_false += trial.hull && trial.moves ? 1.0 : 0.0;
      if (kind == kOverhang && trial.moves) keep_plainest(trial, drawn[0]);
      if (kind == kSide && !trial.moves) keep_plainest(trial, drawn[1]);
    }
  }
  for (std::int64_t k = 1; k <= settings.count("trials"); ++k) {
    Random random = Random(static_cast<std::uint64_t>(k)).fork(3);
    const Trial triangle = prism_trial(3, random);
    add(triangle, kinds[kTriangle]);
    add(prism_trial(6, random), kinds[kHexagon]);
    if (triangle.hull && !triangle.moves) keep_plainest(triangle, drawn[2]);
    const Trial cut = cut_corner(random);
    add(cut, kinds[kCut]);
    if (cut.differ()) keep_plainest(cut, drawn[3]);
    add(leaning_tower(random.uniform(1.0, 10.0)), kinds[kTower]);
  }

  Table table{"",
              {{"kind", "-", "0 to 6: see the picture"},
               {"differ", "-", "bodies on which the rules differ"},
               {"hull_right", "-", "of these, the hull is right"}}};
  for (int kind = 0; kind < kKinds; ++kind) {
    const KindCount& count = kinds[idx(kind)];
    table.add(kind, count.differ, count.right);
  }
  Result result{.tables = {table}};
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    if (!drawn[k]) throw std::runtime_error("no body of kind " + std::to_string(k) + " to draw");
    const std::string suffix = "plan" + std::to_string(k + 1);
    result.drawings.push_back(k < 3 ? plan_of(*drawn[k], suffix)
                                    : enlarged_corner_of(*drawn[k], suffix));
  }
  const double all = sum_without(differ, -1);
  const KindCount& triangle = kinds[kTriangle];
  const KindCount& hexagon = kinds[kHexagon];
  const double prisms = triangle.tried + hexagon.tried;
  result.quantities = {
      ratio_of_sums("share of the boxes on which the two rules differ of which the hull is right",
                    "-", right, differ),
      {"boxes of random piles on which the two rules differ", "-", all},
      {"of these, called stable by the text and moving", "-", text_false},
      {"of these, called stable by the hull and moving", "-", hull_false},
      {"share of which the hull is right, a support hangs over", "-",
       kinds[kOverhang].share_right()},
      {"share of which the hull is right, a support is touched from the side", "-",
       kinds[kSide].share_right()},
      {"share of the prisms that the hull calls stable", "-",
       (triangle.hull + hexagon.hull) / prisms},
      {"prisms that four corners call stable", "-", triangle.text + hexagon.text},
      {"prisms that the hull judges wrongly", "-", triangle.hull_wrong + hexagon.hull_wrong},
      {"share of which the hull is right, a cut corner, tolerances of damped", "-",
       kinds[kCut].share_right()}};
  return result;
}

const Registered claim_5_4c_hull_figure{
    {.name = "claim_5_4c_hull",
     .parameters = {whole("piles", 800, 2, 100000, "random piles"),
                    whole("trials", 200, 1, 100000, "bodies of each other kind")},
     .quick = {"piles=40", "trials=15"},
     .experiment = measure_hull}};

}  // namespace
}  // namespace tumble::chapters
