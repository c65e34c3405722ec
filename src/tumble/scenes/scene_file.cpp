/// \file
/// \brief Reading and writing scene files; the only place that knows TOML.
#include "tumble/scenes/scene_file.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/base/text_file.hpp"
#include "tumble/scenes/readable_toml.hpp"
#include "tumble/scenes/scene_table.hpp"

// Some bad files, such as "[[[", break what toml++ takes for granted: it would end the process, or with
// NDEBUG and clang do anything at all. Without checks of its own it goes on to where it reports the mistake.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(belief) static_assert(true)
#ifdef __EMSCRIPTEN__
// toml++ reads numbers by streams unless the standard library has functions for it, and streams would be a
// tenth of the module of the live page. The library of em++ lacks these two; the second one is never called.
#include <charconv>
#include <cmath>
namespace std {
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  value = tumble::parse_number(string(first, last)).value_or(HUGE_VAL);
  return {last, errc()};  // toml++ has looked at every character
}
template <floating_point Float, class... Form>
to_chars_result to_chars(char* /*first*/, char* last, Float /*value*/, Form... /*form*/) {
  return {last, errc::not_supported};
}
}  // namespace std
#define TOML_FLOAT_CHARCONV 1
#define TOML_INT_CHARCONV 1
#else
#include <charconv>
// A stream for each number would be a fifth of the time of a large scene.
#if defined(__cpp_lib_to_chars)
#define TOML_FLOAT_CHARCONV 1
#endif
#endif
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace tumble {
namespace {

std::string shown(const toml::node& node) {
  std::string out(1, '"');
  if (const auto* text = node.as_string()) return one_line(out.append(text->get()).append(1, '"'));
  if (const auto* number = node.as_integer()) return std::to_string(number->get());
  if (const auto* number = node.as_floating_point()) return shortest_text(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  const toml::array* list = node.as_array();
  if (list == nullptr) return node.is_table() ? "a table" : "a date or time";
  if (list->size() > 16) return "a list of " + std::to_string(list->size());
  out = '[';
  for (const toml::node& element : *list) {
    if (out.size() > 1) out.append(", ");
    out.append(shown(element));
  }
  return one_line(out.append(1, ']'));
}

// What a user of another simulator may try.
bool is_other_shape(std::string_view key) {
  constexpr std::array<std::string_view, 8> shapes = {"sphere", "ball", "capsule", "cylinder",
                                                      "cone",   "mesh", "polygon", "convex"};
  return std::find(shapes.begin(), shapes.end(), key) != shapes.end();
}

// A table of the file, with what a message needs to point at a place in it.
class Place : public SceneTable {
 public:
  Place(const toml::table& table, std::string_view file, std::string prefix)
      : table_(table), file_(file), prefix_(std::move(prefix)) {}

  [[noreturn]] void refuse(std::string_view key, const std::string& wanted) const override {
    refuse(key, find(key), wanted);
  }

  [[noreturn]] void refuse(std::string_view key, const toml::node* node,
                           const std::string& wanted) const {
    std::string out = place_of(node);
    out.append(prefix_).append(one_line(key));
    if (node != nullptr) out.append(" = ").append(shown(*node));
    throw std::invalid_argument(out + ": " + wanted);
  }

  // FILE:LINE: of a value, or of the table if there is none.
  std::string place_of(const toml::node* node) const {
    const auto line = (node != nullptr ? node : &table_)->source().begin.line;
    return std::string(file_) + ":" + std::to_string(line) + ": ";
  }

  // A key that is not part of the format is a mistake of the user's.
  void only(std::initializer_list<std::string_view> known) const override {
    for (const auto& [key, node] : table_) {
      const std::string_view name = key.str();
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      if (is_other_shape(name))
        refuse(name, &node, "boxes only, no other shape is simulated: write a table [[box]]");
      refuse(name, &node,
             "unknown key; " + expected_names(name, std::vector<std::string_view>(known)));
    }
  }

  const toml::node* find(std::string_view key) const { return table_.get(key); }

  bool number(std::string_view key, double& out) const override {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) refuse(key, node, "expected a finite number");
    out = *value;
    return true;
  }

  bool vector(std::string_view key, Vec3& out) const override {
    std::array<double, 3> v{};
    if (!numbers(key, v)) return false;
    out = Vec3(v[0], v[1], v[2]);
    return true;
  }

  bool quaternion(std::string_view key, Quat& out) const override {
    std::array<double, 4> v{};
    if (!numbers(key, v)) return false;
    out = Quat(v[0], v[1], v[2], v[3]);
    return true;
  }

  bool text(std::string_view key, std::string& out) const override {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    if (!node->is_string()) refuse(key, node, "expected a text in quotes");
    out = node->value<std::string>().value_or("");
    return true;
  }

  bool texts(std::string_view key, std::vector<std::string>& out) const override {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const toml::array* list = node->as_array();
    if (list == nullptr) return text(key, out.emplace_back());
    if (list->empty()) refuse(key, "expected a text in quotes, or a list of them");
    for (const toml::node& item : *list) {
      if (!item.is_string()) refuse(key, "expected texts in quotes in the list");
      out.push_back(item.value<std::string>().value_or(""));
    }
    return true;
  }

  bool flag(std::string_view key, bool& out) const override {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    if (!node->is_boolean()) refuse(key, node, "expected true or false");
    out = node->value<bool>().value_or(false);
    return true;
  }

  // How many tables there are in a list.
  std::size_t count(const std::string& key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return 0;
    if (!node->is_array_of_tables()) refuse(key, node, "expected [[" + key + "]] tables");
    return node->as_array()->size();
  }

  // One of them.
  Place table(const std::string& key, std::size_t k) const {
    return {*find(key)->as_array()->get(k)->as_table(), file_,
            key + "[" + std::to_string(k + 1) + "]."};
  }

  // All of them, read one by one.
  template <class Read>
  auto list(const std::string& key, const Read& read) const {
    std::vector<decltype(read(*this))> out;
    const std::size_t all = count(key);
    out.reserve(all);
    for (std::size_t k = 0; k < all; ++k) out.push_back(read(table(key, k)));
    return out;
  }

 private:
  template <std::size_t n>
  bool numbers(std::string_view key, std::array<double, n>& out) const {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const std::string wanted = "expected " + std::to_string(n) + " finite numbers in brackets";
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() != n) refuse(key, node, wanted);
    for (std::size_t i = 0; i < n; ++i) {
      const toml::node& item = *list->get(i);
      const auto value = item.is_number() ? item.value<double>() : std::nullopt;
      if (!value || !std::isfinite(*value)) refuse(key, node, wanted);
      out[i] = *value;
    }
    return true;
  }

  const toml::table& table_;
  std::string_view file_;
  std::string prefix_;
};

Scene read_table(const toml::table& root, std::string_view file) {
  const Place place(root, file, "");
  place.only({"title", "gravity", "ground", "box", "joint", "wish"});
  Scene scene;
  place.text("title", scene.title);
  place.vector("gravity", scene.gravity_w);
  if (const toml::node* node = place.find("ground"); node != nullptr) {
    if (!node->is_table()) place.refuse("ground", node, "expected a table [ground]");
    const Place ground(*node->as_table(), file, "ground.");
    ground.only({"friction", "restitution"});
    scene.ground.emplace();
    read_surface(ground, scene.ground->friction, scene.ground->restitution);
  }
  const toml::node* boxes = place.find("box");
  if (boxes == nullptr || !boxes->is_array() || boxes->as_array()->empty())
    place.refuse("box", boxes, "a scene needs at least one [[box]] table, in two brackets");
  scene.boxes = place.list("box", read_box);
  scene.wishes = place.list("wish", read_wish);
  scene.joints = place.list("joint", read_joint);
  return scene;
}

toml::table parsed(std::string_view text, std::string_view file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    constexpr std::size_t most = 200;  // bytes of a description, which may hold parts of the text
    throw std::invalid_argument(
        not_toml(file, error.source().begin.line, one_line(error.description(), most)));
  }
}

}  // namespace

// The tree of a large file takes more memory than all that is made of it. So it is gone before the scene is checked, and
// made once more to find the line of a mistake.
Scene parse_scene(std::string_view text, std::string_view file) {
  require_readable(text, file);
  Scene scene = read_table(parsed(text, file), file);
  try {
    return checked(std::move(scene));
  } catch (const SceneMistake& mistake) {
    const toml::table root = parsed(text, file);
    const Place all(root, file, "");
    const Place place = mistake.box() < 0
                            ? all
                            : all.table(mistake.table(), static_cast<std::size_t>(mistake.box()));
    std::string message(message_of(mistake));
    // Keys have no frame.
    const std::string quantity = ": " + mistake.key() + "_w = ";
    if (const std::size_t at = message.find(quantity); at != std::string::npos)
      message.erase(at + quantity.size() - 5, 2);
    throw std::invalid_argument(place.place_of(place.find(mistake.key())) + message);
  }
}

Scene read_scene(const std::filesystem::path& path) {
  constexpr std::size_t most_mib = 64;
  const std::string text = read_text(path, "a scene file, *.toml", most_mib);
  return parse_scene(text, path.string());
}

}  // namespace tumble
