/// \file
/// \brief The box filter: each pose becomes the mean of those around it (thesis 5.5).
#pragma once

#include "tumble/filtering/pose_filter.hpp"

#include <vector>

namespace tumble {

/// Which frames a box filter averages to show one.
enum class BoxWindow : std::uint8_t {
  centred,  ///< as many before as after, so later frames are waited for
  causal    ///< those up to now: shown at once, and late
};

/// Low-pass filter: the mean over an odd number of frames, as in the thesis with five.
///
/// With \f$h\f$ frames on each side of frame c,
/// \f[ \tilde x_c = x_c + \frac1{2h+1}\sum_{k=1}^{h}\bigl((x_{c-k}-x_c)+(x_{c+k}-x_c)\bigr),\qquad
///     \tilde q_c = \exp\Bigl(\frac1{2h+1}\sum_{k=1}^{h}(r_{c-k}+r_{c+k})\Bigr)\,q_c, \f]
/// where \f$r_k = \log(q_k q_c^{-1})\f$ is the rotation vector from the middle pose: components of
/// quaternions have no mean that is an orientation. A motion of frequency f (in cycles a frame)
/// about a fixed axis or along a line is multiplied by
/// \f$H(f) = \frac1{2h+1}\bigl(1+2\sum_k\cos 2\pi k f\bigr)\f$, see response().
///
/// A run of equal poses keeps its bits, and a constant velocity its path. *Ends*: near the first and
/// last frame of a body the window shrinks to what there is on both sides, so these two frames are
/// shown as they are. A window also ends where a body has turned by half a turn or more from the
/// middle, beyond which its rotation vector says little.
///
/// `causal` shows of each body in frame n the pose that `centred` shows in frame n - h, bit for bit,
/// and in its first h frames where it came in: nothing is held back, and all is h frames late. What
/// `centred` shows in the last h frames is never seen.
/// \par Spacing
/// Frames must be equally spaced, to tolerance::equal_spacing. One frame may break it, if it is the
/// last: a run's last step is cut to end at its duration. No window has that frame, as if the run
/// had ended before it; `centred` shows it as it is.
/// \par Cost
/// O(frames in the window) for a body and frame, about 0.1 microseconds each.
class BoxFilter : public PoseFilter {
 public:
  /// Makes the filter.
  /// \param frames  in the window, odd, 1 to 1001; 1 changes nothing
  /// \param window  around the frame that is shown, or before it
  /// \throws std::invalid_argument for another number of frames
  explicit BoxFilter(int frames, BoxWindow window = BoxWindow::centred);

  /// How many frames are averaged.
  /// \return odd
  [[nodiscard]] int frames() const { return 2 * half_ + 1; }

  [[nodiscard]] int latency() const override { return window_ == BoxWindow::centred ? half_ : 0; }
  [[nodiscard]] std::string text() const override;
  [[nodiscard]] std::unique_ptr<PoseFilter> clone() const override;

  /// By what a motion of one frequency is multiplied, \f$H(f)\f$; below 0 it is shown inverted.
  /// \param frames     in the window, odd
  /// \param frequency  [1/frame] 0 to 1/2
  /// \return [-] 1 at frequency 0
  static double response(int frames, double frequency);

 private:
  struct Kept {
    double time = 0.0;
    std::int64_t step = 0;
    std::vector<BodyId> ids;
    std::vector<BodyState> states;
  };

  void take(const Frame& frame, const FrameSink& show) override;
  void end(const FrameSink& show) override;
  void keep(const Frame& frame);
  [[nodiscard]] int newest() const { return static_cast<int>(kept_.size()) - 1; }
  [[nodiscard]] const Kept& at(int place) const { return kept_[static_cast<std::size_t>(place)]; }
  [[nodiscard]] BodyState mean(BodyId id, std::size_t hint, int middle) const;
  [[nodiscard]] int delayed(BodyId id, std::size_t hint) const;
  void show_frame(int place, const FrameSink& show);

  int half_;
  BoxWindow window_;
  std::vector<Kept> kept_;  // the last frames() frames, oldest first
  int waiting_ = 0;         // how many of them have not been shown, at the end of kept_
  double interval_ = 0.0;   // [s] between frames; 0 before there are two
  bool broken_ = false;     // the newest came after another interval: there must be none after it
  std::vector<BodyState> shown_;
};

}  // namespace tumble
