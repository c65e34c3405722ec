/// \file
/// \brief The box filter: a moving average of poses (thesis 5.5).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/filtering/pose_filter.hpp"

#include <vector>

namespace tumble {

/// Position of the averaging window of a box filter.
enum class BoxWindow : std::uint8_t {
  centred,  ///< as many frames before as after; waits for later frames
  causal    ///< past frames only: no waiting, but a delay
};

/// Low-pass filter: the mean over an odd number of frames, five in the thesis.
///
/// With \f$h\f$ frames on each side of frame c,
/// \f[ \tilde x_c = x_c + \frac1{2h+1}\sum_{k=1}^{h}\bigl((x_{c-k}-x_c)+(x_{c+k}-x_c)\bigr),\qquad
///     \tilde q_c = \exp\Bigl(\frac1{2h+1}\sum_{k=1}^{h}(r_{c-k}+r_{c+k})\Bigr)\,q_c, \f]
/// where \f$r_k = \log(q_k q_c^{-1})\f$ is the rotation vector from the middle pose: components of
/// quaternions have no mean that is an orientation. A motion of frequency f (in cycles a frame)
/// about a fixed axis or along a line is multiplied by
/// \f$H(f) = \frac1{2h+1}\bigl(1+2\sum_k\cos 2\pi k f\bigr)\f$, see response().
///
/// A run of equal poses keeps its bits, a constant velocity its path. *Ends*: near the first and last
/// frame of a body the window shrinks symmetrically, so these two frames are unchanged. A window also
/// ends where a body has turned by half a turn or more from the middle, as its rotation vector is then
/// ambiguous.
///
/// `causal` shows of each body in frame n the pose that `centred` shows in frame n - h, bit for bit,
/// and its first pose in its first h frames: it waits for no frame, but lags by h frames. The last h
/// poses of `centred` are never shown.
/// \par Spacing
/// Frames must be equally spaced, to tolerance::equal_spacing. Only the last frame may differ, as the
/// last step of a run is cut at its duration. No window contains that frame; `centred` shows it
/// unchanged.
/// \par Cost
/// O(frames in the window) for a body and frame, about 0.1 microseconds each.
class BoxFilter : public Cloned<PoseFilter, BoxFilter> {
 public:
  /// Makes the filter.
  /// \param frames  in the window, odd, 1 to 1001; 1 changes nothing
  /// \throws std::invalid_argument for another number of frames
  explicit BoxFilter(int frames, BoxWindow window = BoxWindow::centred);

  /// Number of frames averaged, odd.
  [[nodiscard]] int frames() const { return 2 * half_ + 1; }

  [[nodiscard]] int latency() const override { return window_ == BoxWindow::centred ? half_ : 0; }
  [[nodiscard]] std::string text() const override;

  /// Factor by which a motion of one frequency is multiplied, \f$H(f)\f$; negative: inverted.
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
  int waiting_ = 0;         // how many of them have not been shown yet
  double interval_ = 0.0;   // [s] between frames; 0 before there are two
  bool broken_ = false;     // the newest came after another interval: no frame may follow
  std::vector<BodyState> shown_;
};

}  // namespace tumble
