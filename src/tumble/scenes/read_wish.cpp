/// \file
/// \brief Reading a table [[wish]] of a scene file.
#include "tumble/base/suggestion.hpp"
#include "tumble/scenes/scene_table.hpp"
#include "tumble/scenes/wish.hpp"

#include <algorithm>

namespace tumble {
namespace {

template <std::size_t n>
int place_in(const SceneTable& table, std::string_view key, const std::string& word,
             const std::array<std::string_view, n>& words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) table.refuse(key, expected_names(word, words));
  return static_cast<int>(found - words.begin());
}

void read_face(const SceneTable& table, Wish& wish) {
  table.only({"kind", "body", "face"});
  std::string face;
  if (!table.text("face", face))
    table.refuse("face", "missing: the face that is up, \"+x\", \"-x\", \"+y\" and so on");
  wish.face = place_in(table, "face", face, kFaces);
}

void read_region(const SceneTable& table, Wish& wish) {
  table.only({"kind", "body", "low", "high"});
  if (!table.vector("low", wish.low_w)) table.refuse("low", "missing: [x, y, z] in m");
  if (!table.vector("high", wish.high_w)) table.refuse("high", "missing: [x, y, z] in m");
}

}  // namespace

Wish read_wish(const SceneTable& table) {
  Wish wish;
  std::string kind;
  if (!table.text("kind", kind)) table.refuse("kind", "missing: " + expected_names("", kWishKinds));
  wish.kind = static_cast<WishKind>(place_in(table, "kind", kind, kWishKinds));
  if (!table.texts("body", wish.bodies))
    table.refuse("body", "missing: the name of a box, or a list of names");
  switch (wish.kind) {
    case WishKind::face_up: read_face(table, wish); break;
    case WishKind::ends_in: read_region(table, wish); break;
    case WishKind::topples:
    case WishKind::stands:
      table.only({"kind", "body", "angle"});
      table.number("angle", wish.angle_deg);
      break;
    case WishKind::moves:
    case WishKind::stays:
      table.only({"kind", "body", "distance"});
      if (table.number("distance", wish.distance) && !(wish.distance > 0.0))
        table.refuse("distance", "expected a number above 0 m");
      break;
  }
  return wish;
}

}  // namespace tumble
