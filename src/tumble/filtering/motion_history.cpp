/// \file
/// \brief Features of a body's motion in its last frames.
#include "tumble/filtering/motion_history.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tumble {
namespace {

constexpr int kRounds = 8;  // of the power method: each reduces the error by a ratio of eigenvalues

// The direction of a line, without its sense; 0 without motion.
Placement principal_direction(std::span<const Placement> places) {
  Placement direction = Placement::Zero();
  double longest = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double length = (places[k] - places[k - 1]).norm();
    if (!(length > longest)) continue;
    longest = length;
    direction = (places[k] - places[k - 1]) / length;
  }
  if (longest == 0.0) return direction;
  for (int round = 0; round < kRounds; ++round) {
    Placement sum = Placement::Zero();
    for (std::size_t k = 1; k < places.size(); ++k) {
      const Placement step = (places[k] - places[k - 1]) / longest;
      sum += step * step.dot(direction);
    }
    direction = sum / sum.norm();
  }
  return direction;
}

using Coordinates = std::array<double, kMostPlaces>;

// Along the principal direction, from the first place [m].
Coordinates along_principal_direction(std::span<const Placement> places) {
  require::that(places.size() <= kMostPlaces, "more places than kMostPlaces");
  const Placement direction = principal_direction(places);
  Coordinates along;
  for (std::size_t k = 0; k < places.size(); ++k)
    along[k] = (places[k] - places.front()).dot(direction);
  return along;
}

}  // namespace

Placement placement_of(const BodyProperties& body, const BodyState& state) {
  const Box box = box_of(body, state);
  Placement place;
  place.segment<3>(0) = box.center_w;
  for (int axis = 0; axis < 3; ++axis)
    place.segment<3>(3 * (axis + 1)) = box.half[axis] * box.axes_w.col(axis);
  return place;
}

MotionHistory history_of(std::span<const Placement> places) {
  require::that(places.size() >= 2, "history_of: expected at least two places");
  MotionHistory history;
  const double last = static_cast<double>(places.size() - 1);
  Placement slope = Placement::Zero();
  double squares = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const Placement from_first = places[k] - places.front();
    history.path += (places[k] - places[k - 1]).norm();
    history.excursion = std::max(history.excursion, from_first.norm());
    slope += (static_cast<double>(k) - 0.5 * last) * from_first;
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double from_middle = static_cast<double>(k) - 0.5 * last;
    squares += from_middle * from_middle;
  }
  history.displacement = (places.back() - places.front()).norm();
  history.drift = slope.norm() * last / squares;
  return history;
}

double swing_of(std::span<const Placement> places, int reversals) {
  require::that(reversals >= 1, "swing_of: expected at least 1 reversal");
  const Coordinates along = along_principal_direction(places);
  // Best values for sequences that end at each place, by the sense of their last part.
  Coordinates forth;
  Coordinates back;
  forth.fill(std::numeric_limits<double>::infinity());
  back.fill(std::numeric_limits<double>::infinity());
  double swing = 0.0;
  for (int part = 0; part <= reversals; ++part) {
    swing = 0.0;
    for (std::size_t end = places.size();
         end-- > 0;) {  // earlier places still have the part before
      double best_forth = 0.0;
      double best_back = 0.0;
      for (std::size_t begin = 0; begin < end; ++begin) {
        const double way = along[end] - along[begin];
        best_forth = std::max(best_forth, std::min(back[begin], way));
        best_back = std::max(best_back, std::min(forth[begin], -way));
      }
      forth[end] = best_forth;
      back[end] = best_back;
      swing = std::max({swing, best_forth, best_back});
    }
  }
  return swing;
}

}  // namespace tumble
