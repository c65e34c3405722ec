/// \file
/// \brief Sets of errata of printed listings.
#pragma once

#include <bitset>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// Errata whose ids have the same letters, numbered from 1.
struct ErrataGroup {
  std::string_view letters;  ///< "A", for example
  int count = 0;             ///< A1 to A11: 11
};

/// The errata of some listings, by their ids.
class ErrataList {
 public:
  /// At most this many.
  static constexpr std::size_t kMost = 64;

  /// \param groups in the order of the listings
  explicit ErrataList(std::span<const ErrataGroup> groups);

  /// All ids, in the order of the groups.
  [[nodiscard]] std::span<const std::string> ids() const { return ids_; }

  /// The place of an erratum.
  /// \return from 0
  /// \throws std::invalid_argument for another id, with the known ones
  [[nodiscard]] std::size_t place_of(std::string_view id) const;

  /// The errata that a text lists.
  /// \param list  ids between commas, for example "A1,B3"; blanks around ids, repetitions and
  ///              the order do not matter. "" and "none" are no erratum, "all" is each of them
  /// \return by place
  /// \throws std::invalid_argument for an id that is unknown or missing between commas
  [[nodiscard]] std::bitset<kMost> read(std::string_view list) const;

  /// A list that read() reads.
  /// \param errata by place
  /// \return for example "A1,B3"; "none" if there are none
  [[nodiscard]] std::string text(const std::bitset<kMost>& errata) const;

 private:
  std::vector<std::string> ids_;
  std::string expected_;  // "A1 to A11 or B1 to B3, or none, or all"
};

/// A set of errata that are repaired, by their ids.
///
/// The readings as printed take such a set, so that a test can show the failure of one misprint at a
/// time.
/// \tparam known_errata the errata of the listings
template <const ErrataList& (*known_errata)()>
class ErrataSetOf {
 public:
  /// No erratum.
  ErrataSetOf() = default;

  /// Reads a list.
  /// \param list  see ErrataList::read()
  /// \throws std::invalid_argument for an unknown id
  explicit ErrataSetOf(std::string_view list) : mended_(known_errata().read(list)) {}

  /// All errata of the listings.
  [[nodiscard]] static ErrataSetOf all() { return ErrataSetOf("all"); }

  /// The ids, in the order of the listings; see ErrataList::ids().
  [[nodiscard]] static std::span<const std::string> known() { return known_errata().ids(); }

  /// Whether an erratum is in the set.
  /// \throws std::invalid_argument for another id
  [[nodiscard]] bool has(std::string_view id) const {
    return mended_.test(known_errata().place_of(id));
  }

  /// The same set with one erratum more.
  /// \throws std::invalid_argument for another id
  [[nodiscard]] ErrataSetOf with(std::string_view id) const {
    ErrataSetOf copy = *this;
    copy.mended_.set(known_errata().place_of(id));
    return copy;
  }

  /// The same set with one erratum less.
  /// \throws std::invalid_argument for another id
  [[nodiscard]] ErrataSetOf without(std::string_view id) const {
    ErrataSetOf copy = *this;
    copy.mended_.reset(known_errata().place_of(id));
    return copy;
  }

  /// The set as a list, which the constructor reads, for example "A1,B3"; "none" if it is empty.
  [[nodiscard]] std::string text() const { return known_errata().text(mended_); }

  /// Whether two sets hold the same errata.
  bool operator==(const ErrataSetOf& other) const = default;

 private:
  std::bitset<ErrataList::kMost> mended_;  // by place
};

}  // namespace tumble
