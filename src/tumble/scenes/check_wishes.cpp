/// \file
/// \brief Wishes that cannot come true.
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/scenes/scene.hpp"
#include "tumble/scenes/wish.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tumble {
namespace {

constexpr double kHalfTurn = 180.0;  // [degrees]

// One wish of a scene, with its place for messages.
struct PlacedWish {
  int place = 0;
  const Wish& wish;

  [[noreturn]] void refuse(const std::string& key, const std::string& message) const {
    throw SceneMistake(place, key, message, "wish");
  }
};

const SceneBox& wished_box(const PlacedWish& placed, const std::string& name, const Scene& scene) {
  std::vector<std::string_view> names;
  for (const SceneBox& box : scene.boxes) {
    if (box.name == name) return box;
    names.push_back(box.name);
  }
  placed.refuse("body",
                " = " + one_line(name) + ": there is no such box; " + expected_names(name, names));
}

void check_numbers(const PlacedWish& placed) {
  const Wish& w = placed.wish;
  const auto kind = static_cast<std::size_t>(w.kind);
  if (kind >= kWishKinds.size()) placed.refuse("kind", ": " + expected_names("", kWishKinds));
  if (w.bodies.empty()) placed.refuse("body", ": a wish needs the name of a box");
  if (w.face < 0 || w.face >= static_cast<int>(kFaces.size()))
    placed.refuse("face", " = " + std::to_string(w.face) + ": expected 0 to 5, a place in kFaces");
  if (!(w.angle_deg > 0.0 && w.angle_deg < kHalfTurn))
    placed.refuse("angle",
                  " = " + shortest_text(w.angle_deg) + ": expected degrees above 0 and below 180");
  if (!(w.distance >= 0.0 && std::isfinite(w.distance)))
    placed.refuse("distance", " = " + shortest_text(w.distance) + ": expected 0 m or more");
  if (!w.low_w.allFinite()) placed.refuse("low", ": expected finite numbers");
  if (!w.high_w.allFinite()) placed.refuse("high", ": expected finite numbers");
  if ((w.high_w - w.low_w).minCoeff() < 0.0)
    placed.refuse("high", " = " + vector_text(w.high_w) + ": the region is empty, since low = " +
                              vector_text(w.low_w) + ": expected no number below that of low");
}

// What one wish asks of one box.
void check_box(const PlacedWish& placed, const SceneBox& box, bool ground) {
  const Wish& w = placed.wish;
  if (box.fixed && (w.kind == WishKind::topples || w.kind == WishKind::moves))
    placed.refuse("body", " = " + box.name + ": it is fixed and never moves: give it a mass");
  const double lowest = 0.5 * box.size.minCoeff();
  if (w.kind == WishKind::ends_in && ground && !box.fixed && w.high_w.y() < lowest)
    placed.refuse("high", " = " + vector_text(w.high_w) + ": above the ground the centre of " +
                              box.name + " is never lower than " + shortest_text(lowest) +
                              " m: expected more for y");
}

// Nearest point of the region to where the box begins, and how far that is. [m]
double way_to_region(const Wish& wish, const SceneBox& box) {
  const Vec3 nearest_w = box.position_w.cwiseMax(wish.low_w).cwiseMin(wish.high_w);
  return (nearest_w - box.position_w).norm();
}

// Why two wishes about a box exclude each other; empty if that cannot be seen. The kinds are in the order of WishKind.
std::string conflict(const Wish& a, const Wish& b, const SceneBox& box) {
  using enum WishKind;
  if (a.kind == face_up && b.kind == face_up && a.face != b.face)
    return "only one face of " + box.name + " can be up";
  if (a.kind == ends_in && b.kind == ends_in &&
      (a.low_w.cwiseMax(b.low_w) - a.high_w.cwiseMin(b.high_w)).maxCoeff() > 0.0)
    return "the two regions have no point in common";
  if (a.kind == ends_in && b.kind == stays && way_to_region(a, box) > distance_of(b, box))
    return box.name + " begins " + shortest_text(way_to_region(a, box)) +
           " m from the region and may move by " + shortest_text(distance_of(b, box)) + " m";
  if (a.kind == topples && b.kind == stands && a.angle_deg >= b.angle_deg)
    return box.name + " cannot rotate by " + shortest_text(a.angle_deg) +
           " degrees and by less than " + shortest_text(b.angle_deg);
  if (a.kind == moves && b.kind == stays && distance_of(a, box) > distance_of(b, box))
    return box.name + " cannot move by " + shortest_text(distance_of(a, box)) +
           " m or more and by at most " + shortest_text(distance_of(b, box)) + " m";
  return "";
}

bool is_about(const Wish& wish, const std::string& name) {
  return std::find(wish.bodies.begin(), wish.bodies.end(), name) != wish.bodies.end();
}

}  // namespace

void check_wishes(const Scene& scene) {
  for (std::size_t i = 0; i < scene.wishes.size(); ++i) {
    const PlacedWish placed{static_cast<int>(i), scene.wishes[i]};
    check_numbers(placed);
    for (const std::string& name : placed.wish.bodies) {
      const SceneBox& box = wished_box(placed, name, scene);
      check_box(placed, box, scene.ground.has_value());
      for (std::size_t k = 0; k < i; ++k) {
        const Wish* first = &scene.wishes[k];
        const Wish* second = &placed.wish;
        if (!is_about(*first, name)) continue;
        if (second->kind < first->kind) std::swap(first, second);
        const std::string why = conflict(*first, *second, box);
        if (!why.empty())
          placed.refuse(
              "kind", " = " + std::string(kWishKinds[static_cast<std::size_t>(placed.wish.kind)]) +
                          ": contradicts wish[" + std::to_string(k + 1) + "]: " + why +
                          ": leave one of them out");
      }
    }
  }
}

}  // namespace tumble
