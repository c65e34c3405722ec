/// \file
/// \brief The synchronised timewarp with swept volumes (thesis 5.1): nothing is missed.
///
/// Uses no other chapter.
#pragma once

#include "tumble/timewarp/synchronised_timewarp.hpp"

namespace tumble {

/// What becomes of collisions closer in time than the resolution.
enum class TieRule : std::uint8_t {
  /// Those that follow one within a resolution are resolved with it at one stroke: their order is not
  /// known, so none is made up.
  together,
  /// One after the other by their times as found, as the thesis's forms do it: they may be in the
  /// wrong order.
  one_by_one
};

/// Options of the timewarp with swept volumes.
struct TimewarpSweptOptions : TimewarpOptions {
  TieRule ties = TieRule::together;  ///< see there
};

/// Names the options to a visitor, see options.hpp.
/// \param o  the options
/// \param v  an OptionDeclarer or OptionReader
template <class Visitor>
void describe(TimewarpSweptOptions& o, Visitor& v) {
  describe(static_cast<TimewarpOptions&>(o), v);
  v.word("ties", o.ties, {{"together", TieRule::together}, {"one_by_one", TieRule::one_by_one}},
         "collisions closer in time than the resolution: resolved together, or in the order found");
}

/// TimewarpSimple with the cure that the thesis names: whose swept volumes meet is searched, and
/// times are found by conservative advancement, rotation included.
///
/// Every pair that overlaps for one resolution or longer is found, wherever in the frame. So each
/// collision is foreseen before it is its turn, none is resolved too early, and the order is that of a
/// search over all bodies, while only those that collide are taken back.
/// \par Cost
/// As TimewarpSimple; searches take more tests, the faster bodies spin.
/// \algorithm{Timewarp with swept volumes: section 5.1}
/// \verified{Swept, full timewarp and a search over all bodies find the same collisions}
class TimewarpSwept final : public SynchronisedTimewarp {
 public:
  /// Makes the technique.
  /// \param options see there
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  explicit TimewarpSwept(const TimewarpSweptOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "timewarp_swept"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;

 private:
  void take_moment(const World& world);

  TimewarpSweptOptions options_;
  ForeseenCollision first_;
  std::vector<IndexPair> pairs_;  // of one moment
  std::vector<int> bodies_;       // ditto
};

}  // namespace tumble
