/// \file
/// \brief Boxes that each way calls stable, and boxes that rest.
#include "tumble/pictures/picture.hpp"

#include "geometric_stability/pile_builder.hpp"
#include "geometric_stability/pile_forces.hpp"
#include "geometric_stability/pile_levels.hpp"
#include "geometric_stability/random_piles.hpp"

namespace tumble::chapters {
namespace {

constexpr std::size_t kLevels = kStabilityLevels.size();
constexpr double kMovesAlone = 1e-6;  // [-] of g; see the gap between what rests and what moves

// Counts of movable boxes.
struct Cells {
  double stable_rests = 0.0;
  double stable_moves = 0.0;
  double other_rests = 0.0;
  double other_moves = 0.0;
};

// Counts of one pile.
struct PileCount {
  std::array<Cells, kLevels> cells;
  double rules_differ = 0.0;     // boxes on which corners and hull do
  double largest_at_rest = 0.0;  // [m/s²] of boxes that rest, by any solver
  double least_moving = 1e300;   // [m/s²] of boxes that move, by any solver
};

// Accelerations of all bodies.
std::vector<Acceleration> accelerations(const char* solver, const World& world,
                                        const ContactList& contacts) {
  PileForces forces(solver);
  if (!forces.solve(world, contacts))
    throw std::runtime_error(std::string("a pile was not solved by ") + solver);
  return {forces.accelerations().begin(), forces.accelerations().end()};
}

// The bodies that move, with the least and the largest acceleration.
std::vector<char> truth_of(const World& world, const ContactList& contacts, PileCount& count) {
  std::vector<char> moves;
  for (const char* solver : {"least_constraint", "augmented_lagrangian", "baraff"}) {
    const std::vector<Acceleration> found = accelerations(solver, world, contacts);
    for (std::size_t b = 0; b < found.size(); ++b) {
      const double a = fastest_of(world.bodies()[b], found[b]);
      if (moves.size() == b) moves.push_back(a > kMovesAlone * world.gravity_w.norm() ? 1 : 0);
      if (!world.bodies()[b].movable()) continue;
      if (moves[b] != 0)
        count.least_moving = std::min(count.least_moving, a);
      else
        count.largest_at_rest = std::max(count.largest_at_rest, a);
    }
  }
  return moves;
}

PileCount judged(std::uint64_t seed) {
  const World world = random_pile(seed);
  const ContactList contacts = touching(world);
  PileCount count;
  const std::vector<char> moves = truth_of(world, contacts, count);
  std::vector<char> by_corners;
  for (std::size_t level = 0; level < kLevels; ++level) {
    const std::vector<char> stable = called_stable(kStabilityLevels[level], world, contacts);
    Cells& cells = count.cells[level];
    for (std::size_t b = 0; b < stable.size(); ++b) {
      if (!world.bodies()[b].movable()) continue;
      if (stable[b] != 0)
        (moves[b] != 0 ? cells.stable_moves : cells.stable_rests) += 1.0;
      else
        (moves[b] != 0 ? cells.other_moves : cells.other_rests) += 1.0;
      if (kStabilityLevels[level] == StabilityLevel::hull && stable[b] != by_corners[b])
        count.rules_differ += 1.0;
    }
    if (kStabilityLevels[level] == StabilityLevel::corners) by_corners = stable;
  }
  return count;
}

// A pile, its boxes coloured by their state.
Drawing picture_of(std::uint64_t seed) {
  const World world = random_pile(seed, {.scaffolds = false});
  const ContactList contacts = touching(world);
  const std::vector<Acceleration> truth = accelerations("least_constraint", world, contacts);
  const std::vector<char> firm = called_stable(StabilityLevel::hull, world, contacts);
  const std::vector<char> balanced = called_stable(StabilityLevel::hierarchy, world, contacts);
  std::vector<PictureBox> boxes;
  for (std::size_t b = 1; b < world.bodies().size(); ++b) {
    const BodyProperties& body = world.bodies()[b];
    std::uint32_t colour = 0xf0e442;  // rests, and is not called stable
    if (!body.movable())
      colour = 0x9a9a9a;
    else if (firm[b] != 0)
      colour = 0x0072b2;
    else if (balanced[b] != 0)
      colour = 0x8ecdf2;
    else if (fastest_of(body, truth[b]) > kMovesAlone * world.gravity_w.norm())
      colour = 0xd55e00;
    boxes.push_back({box_of(body, world.states()[b]), colour});
  }
  const Camera camera = camera_for(boxes, Vec3(0.5, 0.5, 1.0), 600.0, 400.0, true);
  return {"pile", to_gnuplot(draw_boxes(boxes, camera))};
}

Result measure_confusion(const Parameters& settings) {
  std::vector<PileCount> piles;
  for (std::int64_t k = 1; k <= settings.count("piles"); ++k)
    piles.push_back(judged(static_cast<std::uint64_t>(k)));
  const auto each = [&](const auto& number) {
    std::vector<double> values;
    for (const PileCount& pile : piles) values.push_back(number(pile));
    return values;
  };
  const auto most = [&](const auto& number) {
    const std::vector<double> values = each(number);
    return *std::ranges::max_element(values);
  };
  const auto all = [&](const auto& number) { return sum_without(each(number), -1); };

  Table table{"",
              {{"level", "-", "which way, from the thesis's rule to balance"},
               {"found", "-", "share of the movable boxes that are called stable and rest"},
               {"missed", "-", "that are not called stable and rest"},
               {"moving", "-", "that are not called stable and move"},
               {"false", "-", "that are called stable and move"}}};
  const auto boxes = each([](const PileCount& p) {
    const Cells& c = p.cells[0];
    return c.stable_rests + c.stable_moves + c.other_rests + c.other_moves;
  });
  const double count = sum_without(boxes, -1);
  const auto resting =
      each([](const PileCount& p) { return p.cells[0].stable_rests + p.cells[0].other_rests; });
  Result result;
  result.quantities = {{"boxes that can move", "-", count},
                       ratio_of_sums("share of them that rest", "-", resting, boxes),
                       ratio_of_sums("share of them that the thesis's rule calls stable", "-",
                                     each([](const PileCount& p) {
                                       return p.cells[0].stable_rests + p.cells[0].stable_moves;
                                     }),
                                     boxes)};
  double wrong = 0.0;
  for (std::size_t level = 0; level < kLevels; ++level) {
    const auto sum = [&](double Cells::*cell) {
      return all([&](const PileCount& p) { return p.cells[level].*cell; });
    };
    table.add(level, sum(&Cells::stable_rests) / count, sum(&Cells::other_rests) / count,
              sum(&Cells::other_moves) / count, sum(&Cells::stable_moves) / count);
    // Hull and corners agree, as the next number but one shows.
    if (kStabilityLevels[level] != StabilityLevel::hull)
      result.add(ratio_of_sums(
          "share of the resting boxes missed by " + name_of(kStabilityLevels[level]), "-",
          each([&](const PileCount& p) { return p.cells[level].other_rests; }), resting));
    wrong += sum(&Cells::stable_moves);
  }
  const double g = 9.81;  // [m/s²]
  result.add("boxes called stable that move, all six ways", "-", wrong);
  result.add("boxes on which corners and hull differ", "-",
             all([](const PileCount& p) { return p.rules_differ; }));
  result.add("largest acceleration of a box that rests, three solvers, over g", "-",
             most([](const PileCount& p) { return p.largest_at_rest; }) / g);
  result.add("least acceleration of a box that moves, three solvers, over g", "-",
             -most([](const PileCount& p) { return -p.least_moving; }) / g);
  result.tables = {table};
  result.drawings = {picture_of(static_cast<std::uint64_t>(settings.count("shown")))};
  return result;
}

const Registered stable_confusion_figure{
    {.name = "stable_confusion",
     .parameters = {whole("piles", 400, 2, 100000, "random piles"),
                    whole("shown", 28, 1, 100000, "the pile that is drawn")},
     .quick = {"piles=40"},
     .experiment = measure_confusion}};

}  // namespace
}  // namespace tumble::chapters
