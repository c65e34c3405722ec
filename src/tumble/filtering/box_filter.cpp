/// \file
/// \brief The box filter: a moving average of poses (thesis 5.5).
#include "tumble/filtering/box_filter.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/filtering/tolerances.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tumble {
namespace {

constexpr int kMostFrames = 1001;

// A body in a frame, or nullptr. Its place in the frame before is tried first.
const BodyState* find(std::span<const BodyId> ids, std::span<const BodyState> states, BodyId id,
                      std::size_t hint) {
  if (hint < ids.size() && ids[hint] == id) return &states[hint];
  const auto place = std::lower_bound(ids.begin(), ids.end(), id);
  if (place == ids.end() || *place != id) return nullptr;
  return &states[static_cast<std::size_t>(place - ids.begin())];
}

// Whether a body is less than half a turn from the middle of a window, coming from a neighbouring frame.
// Of q and -q, the same orientation, the one closer to that of the neighbour is used; it becomes the
// neighbour.
bool within_half_a_turn(const Quat& q, const Quat& middle, Eigen::Vector4d& neighbour) {
  neighbour = neighbour.dot(q.coeffs()) < 0.0 ? Eigen::Vector4d(-q.coeffs()) : q.coeffs();
  return neighbour.dot(middle.coeffs()) > 0.0;
}

}  // namespace

BoxFilter::BoxFilter(int frames, BoxWindow window) : half_(frames / 2), window_(window) {
  require::that(frames >= 1 && frames <= kMostFrames && frames % 2 == 1,
                "box filter over " + std::to_string(frames) +
                    " frames: expected an odd number from 1 to " + std::to_string(kMostFrames));
}

std::string BoxFilter::text() const {
  return "box:" + std::to_string(frames()) + (window_ == BoxWindow::causal ? ",causal" : "");
}

double BoxFilter::response(int frames, double frequency) {
  double sum = 1.0;
  for (int k = 1; k <= frames / 2; ++k)
    sum += 2.0 * elementary::cos(2.0 * std::numbers::pi * k * frequency);
  return sum / frames;
}

// [S5.5:live]
void BoxFilter::take(const Frame& frame, const FrameSink& show) {
  if (broken_)
    refuse(where(frame) +
           ": a box filter needs frames at equal times, and the one before it "
           "did not come after " +
           shortest_text(interval_) + " s like the others. Keep the step constant");
  const double interval = kept_.empty() ? 0.0 : frame.time - kept_.back().time;
  if (kept_.size() == 1) interval_ = interval;
  broken_ = std::abs(interval - interval_) > tolerance::equal_spacing * interval_;
  keep(frame);
  ++waiting_;
  if (waiting_ > latency()) {
    show_frame(newest() + 1 - waiting_, show);
    --waiting_;
  }
}
// [S5.5:live]

// [S5.5]
// The mean pose of a window, with the momenta of its middle.
BodyState BoxFilter::mean(BodyId id, std::size_t hint, int middle) const {
  const auto body = [&](int place) { return find(at(place).ids, at(place).states, id, hint); };
  BodyState out = *body(middle);
  const Quat centre = out.orientation_wb;
  std::array<Eigen::Vector4d, 2> neighbours = {centre.coeffs(), centre.coeffs()};
  Vec3 moved = Vec3::Zero();
  Vec3 turned = Vec3::Zero();
  int reach = 0;  // frames on each side
  const int last = broken_ ? newest() - 1 : newest();
  while (reach < std::min({half_, middle, last - middle})) {
    const BodyState* before = body(middle - reach - 1);
    const BodyState* after = body(middle + reach + 1);
    if (before == nullptr || after == nullptr ||
        !within_half_a_turn(before->orientation_wb, centre, neighbours[0]) ||
        !within_half_a_turn(after->orientation_wb, centre, neighbours[1]))
      break;
    ++reach;  // sums of two, so that a reversed run gives the same bits
    moved += (before->position_w - out.position_w) + (after->position_w - out.position_w);
    turned += rotation_vector(before->orientation_wb * centre.conjugate()) +
              rotation_vector(after->orientation_wb * centre.conjugate());
  }
  const double share = 1.0 / (2 * reach + 1);
  if (moved != Vec3::Zero()) out.position_w += share * moved;
  if (turned != Vec3::Zero())
    out.orientation_wb = normalised(rotation_from_vector(share * turned) * centre);
  return out;
}
// [S5.5]

void BoxFilter::end(const FrameSink& show) {
  for (; waiting_ > 0; --waiting_) show_frame(newest() + 1 - waiting_, show);
  kept_.clear();
  interval_ = 0.0;
  broken_ = false;
}

// Appends a frame, in the storage of the oldest one if that is no longer needed.
void BoxFilter::keep(const Frame& frame) {
  if (kept_.size() < static_cast<std::size_t>(frames()))
    kept_.emplace_back();
  else
    std::rotate(kept_.begin(), kept_.begin() + 1, kept_.end());
  Kept& kept = kept_.back();
  kept.time = frame.time;
  kept.step = frame.step;
  kept.ids.assign(frame.ids.begin(), frame.ids.end());
  kept.states.assign(frame.states.begin(), frame.states.end());
}

// The frame whose pose the causal form shows of a body now: half a window ago, or its first one.
int BoxFilter::delayed(BodyId id, std::size_t hint) const {
  int place = newest();
  while (place > std::max(0, newest() - half_) &&
         find(at(place - 1).ids, at(place - 1).states, id, hint) != nullptr)
    --place;
  return place;
}

void BoxFilter::show_frame(int place, const FrameSink& show) {
  const Kept& frame = at(place);
  shown_ = frame.states;
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    const BodyId id = frame.ids[k];
    const BodyState pose = mean(id, k, window_ == BoxWindow::causal ? delayed(id, k) : place);
    shown_[k].position_w = pose.position_w;
    shown_[k].orientation_wb = pose.orientation_wb;
  }
  show(Frame{frame.time, frame.step, frame.ids, shown_});
}

}  // namespace tumble
