/// \file
/// \brief Construction of filters from text.
#include "tumble/filtering/filters.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/filtering/box_filter.hpp"
#include "tumble/filtering/envelope_filter.hpp"
#include "tumble/filtering/one_euro_filter.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tumble {
namespace {

constexpr std::array<FilterRecipe, 4> kFilters = {{
    {"box", "box[:FRAMES=5[,causal]]", "mean over an odd number of frames (thesis 5.5)"},
    {"envelope", "envelope:RADIUS,ANGLE", "at rest until it leaves an envelope (thesis 5.5)"},
    {"soft_envelope", "soft_envelope:RADIUS,ANGLE", "an envelope that does not pop"},
    {"one_euro", "one_euro:CUTOFF[,GAIN[,SPEED_CUTOFF]]",
     "low-pass whose cutoff rises with speed (Casiez 2012)"},
}};

// A unit, with the factor and the divisor that convert to SI: 9 mm must have the same bits as 0.009 m.
struct Unit {
  std::string_view name;
  double times;
  double over;
};
constexpr std::array<Unit, 2> kLengths = {{{"m", 1.0, 1.0}, {"mm", 1.0, 1000.0}}};
constexpr std::array<Unit, 2> kAngles = {{{"rad", 1.0, 1.0}, {"deg", std::numbers::pi, 180.0}}};
constexpr std::array<Unit, 1> kFrequencies = {{{"Hz", 1.0, 1.0}}};
constexpr std::array<Unit, 1> kPlain = {{{"", 1.0, 1.0}}};

std::string quoted(std::string_view word) { return std::string("\"").append(word).append("\""); }

// The text form of a filter, split at the colon and the commas.
struct Request {
  std::string text;
  std::string_view form;
  std::vector<std::string_view> numbers;

  [[noreturn]] void refuse(const std::string& why) const {
    tumble::refuse("filter " + text + ": " + why + ": expected " + std::string(form));
  }

  [[nodiscard]] double number(std::size_t place, std::span<const Unit> units) const {
    std::string_view rest = numbers[place];
    const std::optional<double> value = take_number(rest);
    std::string names;
    for (const Unit& unit : units) {
      if (value && rest == unit.name) return *value * unit.times / unit.over;
      names.append(names.empty() ? "" : " or ").append(unit.name);
    }
    refuse(quoted(numbers[place]) + " is not a finite number" +
           (names.empty() ? "" : " with the unit " + names));
  }
};

std::unique_ptr<PoseFilter> box_of(const Request& r) {
  if (r.numbers.empty()) return std::make_unique<BoxFilter>(5);
  const double frames = r.number(0, kPlain);
  if (!(std::abs(frames) < 1e6) || frames != std::floor(frames))
    r.refuse(quoted(r.numbers[0]) + " is not a number of frames");
  BoxWindow window = BoxWindow::centred;
  if (r.numbers.size() > 2) r.refuse("there are too many commas");
  if (r.numbers.size() > 1 && r.numbers[1] != "causal")
    r.refuse(quoted(r.numbers[1]) + " is not the word causal");
  if (r.numbers.size() > 1) window = BoxWindow::causal;
  return std::make_unique<BoxFilter>(static_cast<int>(frames), window);
}

Envelope envelope_of(const Request& r) {
  if (r.numbers.empty()) return {};
  if (r.numbers.size() != 2) r.refuse("an envelope has a radius and an angle");
  return {r.number(0, kLengths), r.number(1, kAngles)};
}

OneEuroOptions one_euro_of(const Request& r) {
  OneEuroOptions options;
  if (r.numbers.size() > 3) r.refuse("there are too many commas");
  if (!r.numbers.empty()) options.cutoff = r.number(0, kFrequencies);
  if (r.numbers.size() > 1) options.gain = r.number(1, kPlain);
  if (r.numbers.size() > 2) options.speed_cutoff = r.number(2, kFrequencies);
  return options;
}

}  // namespace

std::span<const FilterRecipe> filter_library() { return kFilters; }

std::unique_ptr<PoseFilter> filter_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  std::vector<std::string_view> names;
  Request request{std::string(text), {}, {}};
  for (const FilterRecipe& recipe : kFilters) {
    names.push_back(recipe.name);
    if (recipe.name == name) request.form = recipe.form;
  }
  if (request.form.empty())
    refuse("filter " + std::string(text) + ": there is none called " + quoted(name) + ": " +
           expected_names(name, names));
  if (colon != std::string_view::npos) {
    std::string_view rest = text.substr(colon + 1);
    for (;;) {
      const std::size_t comma = rest.find(',');
      request.numbers.push_back(rest.substr(0, comma));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
  }
  if (name == "box") return box_of(request);
  if (name == "envelope") return std::make_unique<EnvelopeFilter>(envelope_of(request));
  if (name == "soft_envelope") return std::make_unique<SoftEnvelopeFilter>(envelope_of(request));
  return std::make_unique<OneEuroFilter>(one_euro_of(request));
}

}  // namespace tumble
