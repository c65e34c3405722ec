/// \file
/// \brief Values named by impacts.
#include "tumble/previous_work/impact_noise.hpp"

namespace tumble {

ImpactValues draw_values(Random& stream) {
  ImpactValues values{};
  for (double& value : values) value = stream.unit();
  return values;
}

ImpactValues ImpactNoise::of(const ImpactName& name) const {
  const auto found = set_.find(name);
  if (found != set_.end()) return found->second;
  Random stream = stream_.fork(number_of(name.first))
                      .fork(number_of(name.second))
                      .fork(static_cast<std::uint64_t>(name.number));
  return draw_values(stream);
}

}  // namespace tumble
