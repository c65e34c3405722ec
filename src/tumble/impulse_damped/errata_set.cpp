/// \file
/// \brief Sets of errata.
#include "tumble/impulse_damped/errata_set.hpp"

#include "tumble/base/error.hpp"

#include <utility>

namespace tumble {
namespace {

std::vector<std::string> all_ids() {
  std::vector<std::string> ids;
  for (const auto& [letters, count] :
       {std::pair{"D", 6}, {"C", 11}, {"RK", 4}, {"RC", 4}, {"DM", 17}, {"X", 7}, {"G", 8}})
    for (int number = 1; number <= count; ++number) ids.push_back(letters + std::to_string(number));
  return ids;
}

// The place of an id among the known ones.
std::size_t place_of(std::string_view id) {
  const std::vector<std::string>& ids = ErrataSet::known();
  for (std::size_t place = 0; place < ids.size(); ++place)
    if (ids[place] == id) return place;
  require::that(false, "erratum '" + std::string(id) +
                           "': expected D1 to D6, C1 to C11, RK1 to RK4, RC1 to RC4, DM1 to DM17, "
                           "X1 to X7 or G1 to G8, or none, or all");
  return 0;  // not reached
}

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(' ');
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(' ') - from + 1);
}

}  // namespace

ErrataSet::ErrataSet(std::string_view list) {
  list = trimmed(list);
  if (list.empty() || list == "none") return;
  if (list == "all") {
    *this = all();
    return;
  }
  for (;;) {
    const std::size_t comma = list.find(',');
    mended_.set(place_of(trimmed(list.substr(0, comma))));
    if (comma == std::string_view::npos) return;
    list.remove_prefix(comma + 1);
  }
}

const std::vector<std::string>& ErrataSet::known() {
  static const std::vector<std::string> ids = all_ids();
  return ids;
}

ErrataSet ErrataSet::all() {
  ErrataSet set;
  for (std::size_t place = 0; place < known().size(); ++place) set.mended_.set(place);
  return set;
}

bool ErrataSet::has(std::string_view id) const { return mended_.test(place_of(id)); }

ErrataSet ErrataSet::with(std::string_view id) const {
  ErrataSet copy = *this;
  copy.mended_.set(place_of(id));
  return copy;
}

ErrataSet ErrataSet::without(std::string_view id) const {
  ErrataSet copy = *this;
  copy.mended_.reset(place_of(id));
  return copy;
}

std::string ErrataSet::text() const {
  std::string list;
  for (std::size_t place = 0; place < known().size(); ++place)
    if (mended_.test(place)) list += (list.empty() ? "" : ",") + known()[place];
  return list.empty() ? "none" : list;
}

}  // namespace tumble
