/// \file
/// \brief The synchronised timewarp with swept volumes, which misses no collision (thesis 5.1).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/timewarp/timewarp_frame.hpp"

namespace tumble {

/// Treatment of collisions closer in time than the resolution.
enum class TieRule : std::uint8_t {
  /// Those within a resolution of the earliest are resolved simultaneously: their order is not known,
  /// so none is chosen.
  together,
  /// One after the other by the times found, as in the thesis's forms: possibly in the wrong order.
  one_by_one
};

/// Options of the timewarp with swept volumes.
struct TimewarpSweptOptions : TimewarpOptions {
  TieRule ties = TieRule::together;  ///< see there
};

template <class Visitor>
void describe(TimewarpSweptOptions& o, Visitor& v) {
  describe(static_cast<TimewarpOptions&>(o), v);
  v.word("ties", o.ties, {{"together", TieRule::together}, {"one_by_one", TieRule::one_by_one}},
         "collisions closer in time than the resolution: resolved together, or in the order found");
}

/// TimewarpSimple with the remedy that the thesis names: pairs with overlapping swept volumes are
/// searched, by conservative advancement, rotation included.
///
/// Every overlap of at least one resolution is found, anywhere in the frame. So each collision is
/// predicted in time, none is resolved too early, and the order is that of a search over all bodies,
/// while only colliding bodies are rolled back.
/// \par Cost
/// As TimewarpSimple; the faster bodies spin, the more tests a search takes.
/// \algorithm{Timewarp with swept volumes: section 5.1}
/// \verified{Swept, full timewarp and a search over all bodies find the same collisions}
class TimewarpSwept final : public Cloned<SynchronisedTimewarp, TimewarpSwept> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  explicit TimewarpSwept(const TimewarpSweptOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "timewarp_swept"; }
  StepReport step(World& world, double dt) override;

 private:
  void take_moment(const World& world);

  TimewarpSweptOptions options_;
  ForeseenCollision first_;
  std::vector<IndexPair> pairs_;  // of the collisions being resolved
  std::vector<int> bodies_;       // of those pairs
};

}  // namespace tumble
