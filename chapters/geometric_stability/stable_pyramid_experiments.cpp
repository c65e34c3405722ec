/// \file
/// \brief Figure 5.6: the stable boxes of a pyramid without its bottom centre box (thesis 5.4).
#include "tumble/geometric_stability/load_proof.hpp"

#include "driver/registry.hpp"
#include "geometric_stability/resting_pile.hpp"

namespace tumble::chapters {
namespace {

const char* const kSolver = "augmented_lagrangian";

// One pyramid of figure 5.6, classified in every way.
struct LookedAt {
  RestingPile pile;
  std::vector<char> stable;      // by the thesis's rule
  std::vector<char> load_proof;  // ours: under every load
  std::vector<char> moving;      // accelerates at rest
  int points = 0;                // unknowns with all boxes
  int by_corners = 0;            // without the stable ones
  int by_hull = 0;               // without the stable ones, by the footnote
  int by_load = 0;               // without those that bear every load
  int by_balance = 0;            // without those that are in balance now
};

LookedAt look_at(int rows, double gap) {
  LookedAt seen{.pile = pyramid_without_middle(rows, gap)};
  const RestingForces all = forces_of(seen.pile, kSolver, StableRule::off);
  const RestingForces left = forces_of(seen.pile, kSolver, StableRule::corners);
  LoadProof().run(seen.pile.world, seen.pile.contacts, seen.load_proof);
  seen.stable = left.held;
  seen.moving = accelerating(seen.pile, all, 1e-6);
  seen.points = all.report.unknowns;
  seen.by_corners = left.report.unknowns;
  seen.by_hull = forces_of(seen.pile, kSolver, StableRule::hull).report.unknowns;
  seen.by_balance = forces_of(seen.pile, kSolver, StableRule::equilibrium).report.unknowns;
  seen.by_load = points_without(seen.pile, seen.load_proof);
  return seen;
}

// Boxes of a pyramid, and its counts.
void add_pyramid(double panel, double gap, const LookedAt& seen, Table& boxes, Table& unknowns) {
  const World& world = seen.pile.world;
  for (std::size_t b = 0; b < seen.stable.size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (!body.movable()) continue;
    const Vec3& p = world.states()[b].position_w;
    const double colour = seen.stable[b] != 0 ? 1.0 : seen.load_proof[b] != 0 ? 2.0 : 0.0;
    boxes.add(panel, p.x(), p.y(), body.size.x(), body.size.y(), colour);
  }
  unknowns.add(gap, seen.points, seen.by_corners, seen.by_load, seen.by_balance);
}

Result measure_stable_pyramid(const Parameters& settings) {
  const double gap = settings.number("gap");
  const LookedAt apart = look_at(settings.count("rows"), gap);
  const LookedAt touching = look_at(settings.count("rows"), 0.0);
  Table boxes{
      "",
      {{"panel", "-", "0: neighbours are apart; 1: they touch"},
       {"x_m", "m", "middle of a box"},
       {"y_m", "m", "its height"},
       {"width_m", "m", "of the box"},
       {"height_m", "m", "of the box"},
       {"colour", "-", "1: stable by the rule; 2: not so, but bears every load; 0: neither"}}};
  Table unknowns{"unknowns",
                 {{"gap", "-", "between neighbours, in edges"},
                  {"all", "-", "contact points: unknown forces of the full system"},
                  {"rule", "-", "those without the boxes that are stable by the thesis's rule"},
                  {"load_proof", "-", "those without the boxes that bear every load (ours)"},
                  {"balance", "-", "those without groups that are in balance as they are (ours)"}}};
  add_pyramid(0.0, gap, apart, boxes, unknowns);
  add_pyramid(1.0, 0.0, touching, boxes, unknowns);

  const auto marked = [](const LookedAt& seen, const std::vector<char>& marks) {
    return movable_marked(seen.pile.world, marks);
  };
  const int moving = marked(apart, apart.moving) + marked(touching, touching.moving);
  return {{boxes, unknowns},
          {{"boxes", "-", apart.pile.world.count() - 1},
           {"stable by the rule, neighbours apart", "-", marked(apart, apart.stable)},
           {"stable by the rule, neighbours touch", "-", marked(touching, touching.stable)},
           {"bear every load, neighbours apart", "-", marked(apart, apart.load_proof)},
           {"bear every load, neighbours touch", "-", marked(touching, touching.load_proof)},
           {"boxes that accelerate, both pyramids", "-", moving},
           {"unknowns of the full system, neighbours apart", "-", apart.points},
           {"unknowns without stable boxes, neighbours apart", "-", apart.by_corners},
           {"the same, stable by the footnote's hull", "-", apart.by_hull},
           {"unknowns of the full system, neighbours touch", "-", touching.points},
           {"unknowns without boxes that bear every load, neighbours touch", "-", touching.by_load},
           {"unknowns without groups in balance, both pyramids", "-",
            apart.by_balance + touching.by_balance}}};
}

const Registered fig5_6_pyramid_figure{
    {.name = "fig5_6_pyramid",
     .parameters = {whole("rows", 9, 3, 31, "boxes in the lowest row before; an odd number"),
                    number("gap", 0.05, 0.0, 0.9, "-", "between neighbours on the left, in edges")},
     .quick = {"rows=5"},
     .experiment = measure_stable_pyramid}};

}  // namespace
}  // namespace tumble::chapters
