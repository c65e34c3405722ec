/// \file
/// \brief Time of contact forces with all boxes and without the stable ones (thesis 5.4).
///
/// Prints for the pyramid of figure 5.6, of 5 to 13 rows, at rest and without friction: unknowns and the
/// time of one solution from scratch, for each rule of which boxes are left out, with our default solver and
/// with Baraff's. The first column of times has the search for stable boxes in it, the second has not:
/// nothing has changed since, and the answer is remembered. Counted work, without clocks, is the figure
/// `claim_5_4b_excluded`.
///
/// Run `stable_boxes [largest number of rows]`.
#include "tumble/analytic_lcp/contact_forces.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/scenes/library.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using tumble::ContactForces;
using tumble::ContactList;
using tumble::MovingBody;
using tumble::StableRule;
using tumble::World;

// A pyramid, and all that touches in it.
struct Pile {
  World world;
  std::vector<MovingBody> bodies;
  ContactList contacts;
};

Pile pyramid(int rows) {
  Pile pile{
      tumble::build_world(tumble::make_scene("fig5_6", {"rows=" + std::to_string(rows)})), {}, {}};
  tumble::load_moving_bodies(pile.world, pile.bodies);
  std::vector<tumble::IndexPair> pairs;
  for (int i = 0; i < pile.world.count(); ++i)
    for (int j = i + 1; j < pile.world.count(); ++j) pairs.push_back({i, j});
  constexpr double margin = 1e-9;  // [m]
  tumble::gather_contacts(pile.world, pile.bodies, pairs, margin, {}, pile.contacts);
  return pile;
}

// [ms] One solution from scratch.
double time_of(const Pile& pile, ContactForces& forces, tumble::ForceReport& report) {
  ContactList contacts = pile.contacts;
  const auto start = std::chrono::steady_clock::now();
  report = forces.solve(pile.world, pile.bodies, contacts, {});
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  return took.count();
}

double median(std::vector<double> times) {
  std::ranges::sort(times);
  return times[times.size() / 2];
}

constexpr tumble::Word<tumble::StableRule> kRules[] = {
    {"off", tumble::StableRule::off},
    {"corners", tumble::StableRule::corners},
    {"hull", tumble::StableRule::hull},
    {"equilibrium", tumble::StableRule::equilibrium}};

void measure(const Pile& pile, const char* solver, const tumble::Word<tumble::StableRule>& rule) {
  const tumble::ContactForceOptions options{
      .solver = solver, .friction = false, .stable_boxes = rule.value};
  std::vector<double> searched;
  std::vector<double> remembered;
  double sum = 0.0;
  tumble::ForceReport report;
  while (searched.empty() || (searched.size() < 200 && sum < 300.0)) {
    ContactForces forces(options);
    searched.push_back(time_of(pile, forces, report));
    remembered.push_back(time_of(pile, forces, report));
    sum += searched.back() + remembered.back();
  }
  std::printf("  %-20s %-12s %5d boxes left out %6d unknowns %10.3f ms %10.3f ms remembered\n",
              solver, rule.word.data(), report.stable, report.unknowns, median(searched),
              median(remembered));
}

}  // namespace

// Runs all sizes.
int main(int argc, char** argv) {
  const int largest = argc > 1 ? std::atoi(argv[1]) : 13;
  for (int rows = 5; rows <= largest; rows += 2) {
    const Pile pile = pyramid(rows);
    std::printf("\n%d rows, %d boxes\n", rows, pile.world.count() - 1);
    for (const char* solver : {"augmented_lagrangian", "baraff"})
      for (const auto& rule : kRules) measure(pile, solver, rule);
  }
  return 0;
}
