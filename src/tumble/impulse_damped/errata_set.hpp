/// \file
/// \brief Which errata of damped integration's listings are mended (thesis A.2).
#pragma once

#include <bitset>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A set of errata of the listings of damped integration, by their ids.
///
/// The reading as printed takes such a set, so that a test can show the failure of one slip at a
/// time. The ids are D1 to D6 (DAMPEDINTEGRATION), C1 to C11 (COLLIDE), RK1 to RK4 and RC1 to RC4
/// (RESOLVECOLLISIONS, RESOLVECONTACTS), DM1 to DM17 (DAMPENOBJECTS), X1 to X7
/// (FIXCONTACTCONSTRAINTS) and G1 to G8 (SETGEOMETRICALLYSTABLE).
class ErrataSet {
 public:
  /// Nothing is mended.
  ErrataSet() = default;

  /// Reads a list.
  /// \param list  ids between commas, for example "C1,DM3"; blanks around ids, repetitions and the
  ///              order do not matter. "" and "none" are no erratum, "all" is each of them
  /// \throws std::invalid_argument for an id that is none or is missing between commas, with the
  ///         known ones
  explicit ErrataSet(std::string_view list);

  /// All errata that there are.
  /// \return each once
  [[nodiscard]] static ErrataSet all();

  /// The ids, in the order of the listings.
  /// \return "D1" to "G8"
  [[nodiscard]] static const std::vector<std::string>& known();

  /// Whether an erratum is mended.
  /// \param id one of known()
  /// \return true if it is in the set
  /// \throws std::invalid_argument for an id that is none
  [[nodiscard]] bool has(std::string_view id) const;

  /// The same set with one erratum more.
  /// \param id one of known()
  /// \return a copy
  /// \throws std::invalid_argument for an id that is none
  [[nodiscard]] ErrataSet with(std::string_view id) const;

  /// The same set with one erratum less.
  /// \param id one of known()
  /// \return a copy
  /// \throws std::invalid_argument for an id that is none
  [[nodiscard]] ErrataSet without(std::string_view id) const;

  /// The set as a list that the constructor reads.
  /// \return for example "C1,DM3"; "none" if it is empty
  [[nodiscard]] std::string text() const;

  /// Whether two sets hold the same errata.
  /// \param other the other set
  /// \return true if so
  bool operator==(const ErrataSet& other) const = default;

 private:
  static constexpr std::size_t kMost = 64;
  std::bitset<kMost> mended_;  // by place in known()
};

}  // namespace tumble
