/// \file
/// \brief Which errata of the thesis's listings are mended (thesis A.1, A.2).
#pragma once

#include <bitset>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tumble {

/// The two parts of appendix A, with the errata of their listings.
enum class Listings : std::uint8_t {
  timewarp,           ///< A.1: T1 to T10 (SIMPLESYNCTIMEWARP), F1 to F9 (SAFERSYNCTIMEWARP)
  damped_integration  ///< A.2: D1 to D6 (DAMPEDINTEGRATION), C1 to C11 (COLLIDE), RK1 to RK4 and RC1
                      ///< to RC4 (RESOLVECOLLISIONS, RESOLVECONTACTS), DM1 to DM17 (DAMPENOBJECTS),
                      ///< X1 to X7 (FIXCONTACTCONSTRAINTS) and G1 to G8 (SETGEOMETRICALLYSTABLE)
};

/// A set of errata of the listings of appendix A, by their ids.
///
/// The readings as printed take such a set, so that a test can show the failure of one slip at a
/// time.
class ErrataSet {
 public:
  /// Nothing is mended.
  ErrataSet() = default;

  /// Reads a list.
  /// \param list      ids between commas, for example "C1,DM3"; blanks around ids, repetitions and
  ///                  the order do not matter. "" and "none" are no erratum, "all" is each of them
  /// \param listings  whose ids are expected
  /// \throws std::invalid_argument for an id that is none of theirs or is missing between commas,
  ///         with the known ones
  explicit ErrataSet(std::string_view list, Listings listings = Listings::damped_integration);

  /// All errata of some listings.
  /// \param listings  which
  /// \return each once
  [[nodiscard]] static ErrataSet all(Listings listings = Listings::damped_integration);

  /// The ids, in the order of the listings.
  /// \param listings  which
  /// \return for example "D1" to "G8"
  [[nodiscard]] static std::span<const std::string> known(
      Listings listings = Listings::damped_integration);

  /// Whether an erratum is mended.
  /// \param id one of known(), of either listings
  /// \return true if it is in the set
  /// \throws std::invalid_argument for an id that is none
  [[nodiscard]] bool has(std::string_view id) const;

  /// The same set with one erratum more.
  /// \param id one of known(), of either listings
  /// \return a copy
  /// \throws std::invalid_argument for an id that is none
  [[nodiscard]] ErrataSet with(std::string_view id) const;

  /// The same set with one erratum less.
  /// \param id one of known(), of either listings
  /// \return a copy
  /// \throws std::invalid_argument for an id that is none
  [[nodiscard]] ErrataSet without(std::string_view id) const;

  /// The set as a list, which the constructor reads if all are of one part.
  /// \return for example "C1,DM3"; "none" if it is empty
  [[nodiscard]] std::string text() const;

  /// Whether two sets hold the same errata.
  /// \param other the other set
  /// \return true if so
  bool operator==(const ErrataSet& other) const = default;

 private:
  static constexpr std::size_t kMost = 80;
  std::bitset<kMost> mended_;  // by place among the ids of both listings
};

}  // namespace tumble
