/// \file
/// \brief Random values for the impacts of a motion, named by the impacts (thesis 2.4.2).
#pragma once

#include "tumble/base/random.hpp"

#include <array>
#include <compare>
#include <map>

namespace tumble {

/// Names one fast impact of a motion: the pair that meets, and how many fast impacts the pair had before. So a change to
/// the impacts of one pair leaves the values of all other pairs with them.
struct ImpactName {
  BodyId first{};   ///< the body with the smaller id
  BodyId second{};  ///< the other one
  int number = 0;   ///< how many fast impacts this pair had before

  /// Orders names by the first body, the second, then the number.
  auto operator<=>(const ImpactName&) const = default;
};

/// [-] The random values of one impact, each uniform in [0, 1).
using ImpactValues = std::array<double, 3>;

/// Three uniform values.
/// \param stream  in and out
/// \return each in [0, 1)
[[nodiscard]] inline ImpactValues draw_values(Random& stream) {
  ImpactValues values{};
  for (double& value : values) value = stream.unit();
  return values;
}

/// The noise of a motion: values for every impact that it may have, independent and uniform.
///
/// Values that were not set come from a stream that is named by the impact, so that infinitely many of them take no
/// memory and are the same whichever impacts happen.
class ImpactNoise {
 public:
  /// New values for all impacts.
  /// \param stream  names them
  explicit ImpactNoise(const Random& stream = Random(0)) : stream_(stream) {}

  /// The values of an impact: those that were set, or those of the stream.
  [[nodiscard]] ImpactValues of(const ImpactName& name) const {
    const auto found = set_.find(name);
    if (found != set_.end()) return found->second;
    Random stream = stream_.fork(number_of(name.first))
                        .fork(number_of(name.second))
                        .fork(static_cast<std::uint64_t>(name.number));
    return draw_values(stream);
  }

  /// Changes the values of one impact.
  /// \param values  [-] each in [0, 1)
  void set(const ImpactName& name, const ImpactValues& values) { set_[name] = values; }

 private:
  Random stream_;
  std::map<ImpactName, ImpactValues> set_;
};

}  // namespace tumble
