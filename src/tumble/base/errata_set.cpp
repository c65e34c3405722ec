/// \file
/// \brief Sets of errata of printed listings.
#include "tumble/base/errata_set.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>

namespace tumble {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(' ');
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(' ') - from + 1);
}

}  // namespace

ErrataList::ErrataList(std::span<const ErrataGroup> groups) {
  for (const ErrataGroup& group : groups) {
    const std::string letters(group.letters);
    for (int number = 1; number <= group.count; ++number)
      ids_.push_back(letters + std::to_string(number));
    if (!expected_.empty()) expected_ += &group == &groups.back() ? " or " : ", ";
    expected_ += letters + "1 to " + ids_.back();
  }
  expected_ += ", or none, or all";
  require::that(ids_.size() <= kMost, "errata: more than a set can hold");
}

std::size_t ErrataList::place_of(std::string_view id) const {
  const auto found = std::find(ids_.begin(), ids_.end(), id);
  if (found == ids_.end()) refuse("erratum '" + std::string(id) + "': expected " + expected_);
  return static_cast<std::size_t>(found - ids_.begin());
}

std::bitset<ErrataList::kMost> ErrataList::read(std::string_view list) const {
  std::bitset<kMost> errata;
  list = trimmed(list);
  if (list.empty() || list == "none") return errata;
  if (list == "all") {
    for (std::size_t place = 0; place < ids_.size(); ++place) errata.set(place);
    return errata;
  }
  for (;;) {
    const std::size_t comma = list.find(',');
    errata.set(place_of(trimmed(list.substr(0, comma))));
    if (comma == std::string_view::npos) return errata;
    list.remove_prefix(comma + 1);
  }
}

std::string ErrataList::text(const std::bitset<kMost>& errata) const {
  std::string list;
  for (std::size_t place = 0; place < ids_.size(); ++place)
    if (errata.test(place)) list += (list.empty() ? "" : ",") + ids_[place];
  return list.empty() ? "none" : list;
}

}  // namespace tumble
