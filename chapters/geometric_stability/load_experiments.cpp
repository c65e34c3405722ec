/// \file
/// \brief Loads on the tops of random piles.
#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/pile_forces.hpp"
#include "geometric_stability/pile_levels.hpp"
#include "geometric_stability/pile_loads.hpp"
#include "geometric_stability/random_piles.hpp"

namespace tumble::chapters {
namespace {

constexpr double kMovesByLoad =
    1e-6;  // [-] of what the load alone gives; as the claim's rule has it

// Results for one movable box.
struct LoadedBox {
  std::size_t pile = 0;
  bool corners = false;     // called stable by the thesis's rule, as meant
  bool load_proof = false;  // called load-proof
  bool printed = false;     // called stable by the listing as printed
  bool mended = false;      // the same with its vetoes mended
  double ratio = 0.0;       // largest acceleration over that by its load alone, of all loads
  double rough = 0.0;       // the same by the method of multipliers

  [[nodiscard]] bool moves() const { return ratio > kMovesByLoad; }
};

// The largest of what each load does to each body.
void load_all(const World& world, const ContactList& contacts, const std::vector<Wrench>& loads,
              PileForces& forces, std::vector<double>& ratios) {
  if (!forces.solve(world, contacts, loads))
    throw std::runtime_error("the contact forces of a loaded pile were not found");
  for (std::size_t b = 0; b < ratios.size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    if (!body.movable()) continue;
    const double by_load = alone(world, static_cast<int>(b), loads[b]);
    ratios[b] = std::max(ratios[b], fastest_of(body, forces.accelerations()[b]) / by_load);
  }
}

void add_pile(std::size_t pile, std::int64_t cases, std::vector<LoadedBox>& boxes) {
  const std::uint64_t seed = pile + 1;
  const World world = random_pile(seed);
  const ContactList contacts = touching(world);
  const std::vector<char> corners = called_stable(StabilityLevel::corners, world, contacts);
  const std::vector<char> proof = called_stable(StabilityLevel::load_proof, world, contacts);
  const std::vector<char> printed = called_stable_as_printed(world, contacts);
  const std::vector<char> mended = called_stable_as_printed(world, contacts, true);
  std::vector<double> ratios(corners.size(), 0.0);
  std::vector<double> rough(corners.size(), 0.0);
  PileForces exact("least_constraint");
  PileForces multipliers("augmented_lagrangian");
  Random random = Random(seed).fork(2);
  for (std::int64_t k = 0; k < cases; ++k) {
    const std::vector<Wrench> loads = random_loads(world, random);
    load_all(world, contacts, loads, exact, ratios);
    load_all(world, contacts, loads, multipliers, rough);
  }
  for (std::size_t b = 0; b < ratios.size(); ++b)
    if (world.bodies()[b].movable())
      boxes.push_back({pile, corners[b] != 0, proof[b] != 0, printed[b] != 0, mended[b] != 0,
                       ratios[b], rough[b]});
}

using Choice = std::function<bool(const LoadedBox&)>;

// The ratios of some boxes, ascending, with the share of boxes up to each.
Table shares_of(const std::string& suffix, const std::vector<LoadedBox>& boxes,
                const Choice& chosen) {
  constexpr double none = 1e-17;  // stands for none at all on a logarithmic axis
  std::vector<double> ratios;
  for (const LoadedBox& box : boxes)
    if (chosen(box)) ratios.push_back(std::max(box.ratio, none));
  std::ranges::sort(ratios);
  Table table{suffix,
              {{"ratio", "-", "largest acceleration over that by the load alone; 1e-17: or none"},
               {"share", "-", "of the boxes, with at most this"}}};
  for (std::size_t k = 0; k < ratios.size(); ++k)
    table.add(ratios[k], static_cast<double>(k + 1) / static_cast<double>(ratios.size()));
  return table;
}

Result measure_any_load(const Parameters& settings) {
  const auto piles = static_cast<std::size_t>(settings.count("piles"));
  std::vector<LoadedBox> boxes;
  for (std::size_t pile = 0; pile < piles; ++pile) add_pile(pile, settings.count("loads"), boxes);

  const Choice stable = [](const LoadedBox& box) { return box.corners; };
  const Choice proof_only = [](const LoadedBox& box) { return box.load_proof && !box.corners; };
  const Choice printed = [](const LoadedBox& box) { return box.printed; };
  const Choice other = [](const LoadedBox& box) { return !box.corners; };
  const Choice not_proof = [](const LoadedBox& box) { return !box.load_proof; };
  const auto by_pile = [&](const Choice& chosen) {
    std::vector<double> counts(piles, 0.0);
    for (const LoadedBox& box : boxes)
      if (chosen(box)) counts[box.pile] += 1.0;
    return counts;
  };
  const auto count = [&](const Choice& chosen) {
    return static_cast<double>(std::ranges::count_if(boxes, chosen));
  };
  const auto worst = [&](const Choice& chosen, double LoadedBox::*ratio) {
    return largest_of(boxes, [&](const LoadedBox& box) { return chosen(box) ? box.*ratio : 0.0; });
  };
  const auto share_moving = [&](const std::string& name, const Choice& chosen) {
    const Choice both = [&](const LoadedBox& box) { return chosen(box) && box.moves(); };
    return ratio_of_sums(name, "-", by_pile(both), by_pile(chosen));
  };
  const Choice falsely = [](const LoadedBox& box) { return box.printed && box.moves(); };
  const Choice mended = [](const LoadedBox& box) { return box.mended && box.moves(); };
  return {{shares_of("stable", boxes, stable), shares_of("load_proof", boxes, proof_only),
           shares_of("printed", boxes, printed), shares_of("other", boxes, other)},
          {{"largest acceleration of a box called stable, over what its load alone would give it",
            "-", worst(stable, &LoadedBox::ratio)},
           {"the same by the method of multipliers", "-", worst(stable, &LoadedBox::rough)},
           {"the same of boxes called stable as printed", "-", worst(printed, &LoadedBox::ratio)},
           {"boxes called stable", "-", count(stable)},
           {"boxes that are only load-proof", "-", count(proof_only)},
           {"boxes called stable as printed", "-", count(printed)},
           {"boxes called stable as printed that move", "-", count(falsely)},
           {"the same with errata G2, G3 and G4 mended", "-", count(mended)},
           share_moving("share of the boxes not called stable that move", other),
           share_moving("share of the boxes that are not load-proof that move", not_proof)}};
}

const Registered claim_5_4a_any_load_figure{
    {.name = "claim_5_4a_any_load",
     .parameters = {whole("piles", 300, 2, 100000, "random piles"),
                    whole("loads", 20, 1, 10000, "loads on all tops of each pile")},
     .quick = {"piles=30", "loads=5"},
     .experiment = measure_any_load}};

}  // namespace
}  // namespace tumble::chapters
