/// \file
/// \brief Sets of errata.
#include "tumble/base/errata_set.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace tumble {
namespace {

constexpr std::size_t kOfTimewarp = 19;  // T1 to T10, F1 to F9; they come first

std::vector<std::string> all_ids() {
  std::vector<std::string> ids;
  for (const auto& [letters, count] : {std::pair{"T", 10},
                                       {"F", 9},
                                       {"D", 6},
                                       {"C", 11},
                                       {"RK", 4},
                                       {"RC", 4},
                                       {"DM", 17},
                                       {"X", 7},
                                       {"G", 8}})
    for (int number = 1; number <= count; ++number) ids.push_back(letters + std::to_string(number));
  return ids;
}

const std::vector<std::string>& ids_of_both() {
  static const std::vector<std::string> ids = all_ids();
  return ids;
}

std::size_t first_of(Listings listings) { return listings == Listings::timewarp ? 0 : kOfTimewarp; }

// The place of an id among those of both listings; nothing if there is none.
std::optional<std::size_t> place_of(std::string_view id) {
  const auto& ids = ids_of_both();
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ids.begin());
}

std::string expected_of(std::string_view id) {
  return "erratum '" + std::string(id) + "': expected ";
}

constexpr const char* kTimewarp = "T1 to T10 or F1 to F9";
constexpr const char* kDamped =
    "D1 to D6, C1 to C11, RK1 to RK4, RC1 to RC4, DM1 to DM17, X1 to X7 or G1 to G8";

// The place of an id of these listings.
std::size_t require_place(std::string_view id, Listings listings) {
  const std::optional<std::size_t> place = place_of(id);
  const std::size_t first = first_of(listings);
  const bool known = place && *place >= first && *place < first + ErrataSet::known(listings).size();
  if (!known)
    require::that(false, expected_of(id) + (listings == Listings::timewarp ? kTimewarp : kDamped) +
                             ", or none, or all");
  return *place;
}

// The place of an id of either.
std::size_t require_place(std::string_view id) {
  const std::optional<std::size_t> place = place_of(id);
  if (!place) require::that(false, expected_of(id) + kTimewarp + ", " + kDamped);
  return *place;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(' ');
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(' ') - from + 1);
}

}  // namespace

ErrataSet::ErrataSet(std::string_view list, Listings listings) {
  list = trimmed(list);
  if (list.empty() || list == "none") return;
  if (list == "all") {
    *this = all(listings);
    return;
  }
  for (;;) {
    const std::size_t comma = list.find(',');
    mended_.set(require_place(trimmed(list.substr(0, comma)), listings));
    if (comma == std::string_view::npos) return;
    list.remove_prefix(comma + 1);
  }
}

std::span<const std::string> ErrataSet::known(Listings listings) {
  const std::span<const std::string> ids = ids_of_both();
  return listings == Listings::timewarp ? ids.first(kOfTimewarp) : ids.subspan(kOfTimewarp);
}

ErrataSet ErrataSet::all(Listings listings) {
  ErrataSet set;
  const std::size_t first = first_of(listings);
  for (std::size_t k = 0; k < known(listings).size(); ++k) set.mended_.set(first + k);
  return set;
}

bool ErrataSet::has(std::string_view id) const { return mended_.test(require_place(id)); }

ErrataSet ErrataSet::with(std::string_view id) const {
  ErrataSet copy = *this;
  copy.mended_.set(require_place(id));
  return copy;
}

ErrataSet ErrataSet::without(std::string_view id) const {
  ErrataSet copy = *this;
  copy.mended_.reset(require_place(id));
  return copy;
}

std::string ErrataSet::text() const {
  std::string list;
  const auto& ids = ids_of_both();
  for (std::size_t place = 0; place < ids.size(); ++place)
    if (mended_.test(place)) list += (list.empty() ? "" : ",") + ids[place];
  return list.empty() ? "none" : list;
}

}  // namespace tumble
