/// \file
/// \brief An impact at one point, followed through its duration.
#include "tumble/previous_work/sliding_impact.hpp"

#include "tumble/math/bracket.hpp"
#include "tumble/previous_work/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

using Slip = Eigen::Vector2d;  // across the normal

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::array<double, 4> kStages{0.0, 0.5, 0.5, 1.0};  // of Runge and Kutta's step
constexpr int kMostSteps = 10000;   // of the integration; then the direction is kept
constexpr int kMostHalvings = 200;  // far above the digits of a double

// How far an impact has come. Components 0 and 1 lie across the normal, 2 along it.
struct Moment {
  Vec3 impulse = Vec3::Zero();  // [N s]
  double work = 0.0;            // [J] of its normal part
};

// The end of an interval from 0 at which a function becomes negative.
template <class Function>
double last_of(const Function& function, double length) {
  return bisect(function, {0.0, length}, tolerance::impact_root * length, kMostHalvings)
      .bracket.high;
}

class Course {
 public:
  explicit Course(const SlidingImpact& impact)
      : tangents_(tangents_of(impact.normal_w)),
        normal_w_(impact.normal_w),
        friction_(impact.friction),
        restitution_(impact.restitution),
        end_(impact.end),
        rebound_(impact.rebound) {
    Mat3 axes;
    axes.col(0) = tangents_.first_w;
    axes.col(1) = tangents_.second_w;
    axes.col(2) = normal_w_;
    start_ = axes.transpose() * impact.velocity_w;
    yield_ = axes.transpose() * impact.inverse_mass_w * axes;
  }

  SlidingImpulse run();

 private:
  [[nodiscard]] Vec3 velocity(const Moment& at) const { return start_ + yield_ * at.impulse; }
  [[nodiscard]] static Slip slip_of(const Vec3& u) { return u.head<2>(); }
  [[nodiscard]] Vec3 against(const Slip& way) const {
    return {-friction_ * way.x(), -friction_ * way.y(), 1.0};
  }
  [[nodiscard]] Vec3 after_stop();
  [[nodiscard]] bool done(const Moment& at) const;
  [[nodiscard]] double until_done(const Vec3& change) const;
  bool go_straight(const Vec3& way, double most);
  bool turn(double length);
  [[nodiscard]] Moment stepped(double length) const;
  [[nodiscard]] Moment rate_at(const Moment& at) const;
  void end_approach();

  Tangents tangents_;
  Vec3 normal_w_;
  double friction_, restitution_;
  ImpactEnd end_;
  double rebound_;
  Vec3 start_;  // [m/s]
  Mat3 yield_;  // [1/kg]

  Moment now_;
  bool approaching_ = true;
  double work_wanted_ = 0.0;     // [J] at the end
  double impulse_wanted_ = 0.0;  // [N s] at the end
};

// [S2.5.2:course]
// Sliding, until slip stops or the impact is over; then sticking, or sliding back.
SlidingImpulse Course::run() {
  SlidingImpulse out;
  if (!(start_.z() < 0.0)) return out;
  const double still = tolerance::impact_still * start_.norm();
  const double slow = tolerance::impact_slow * slip_of(start_).norm();
  for (bool over = false; !over;) {
    const Slip slip = slip_of(velocity(now_));
    const double speed = slip.norm();
    if (out.stopped || !(speed > still)) {
      out.stopped = true;
      over = go_straight(after_stop(), kNever);
      continue;
    }
    const Slip along = slip / speed;
    const Vec3 change = yield_ * against(along);
    const double faster = along.dot(slip_of(change));
    const double turns = along.x() * change.y() - along.y() * change.x();
    if (std::abs(turns) <= tolerance::impact_straight * change.norm() || !(speed > slow) ||
        out.steps == kMostSteps) {
      over = go_straight(against(along), faster < 0.0 ? -speed / faster : kNever);
      out.stopped = !over;
    } else {
      over = turn(tolerance::impact_turn / (std::abs(faster) + std::abs(turns)));
      ++out.steps;
    }
  }
  out.mode = slip_of(velocity(now_)).norm() > still ? ImpactMode::slip : ImpactMode::stick;
  out.impulse_w = now_.impulse.x() * tangents_.first_w + now_.impulse.y() * tangents_.second_w +
                  now_.impulse.z() * normal_w_;
  return out;
}
// [S2.5.2:course]

// [S2.5.2:stop]
// The impulse per normal impulse once slip has stopped.
Vec3 Course::after_stop() {
  const Eigen::Matrix2d across = yield_.topLeftCorner<2, 2>();
  const Slip pull = yield_.topRightCorner<2, 1>();
  const auto solved = [&](double more) -> Slip {  // (μ K_tt + λ)⁻¹ K_tn, by Cramer's rule
    const double a = friction_ * across(0, 0) + more, d = friction_ * across(1, 1) + more;
    const double b = friction_ * across(0, 1);
    return Slip(d * pull.x() - b * pull.y(), a * pull.y() - b * pull.x()) / (a * d - b * b);
  };
  if (friction_ > 0.0) {
    const Slip way = solved(0.0);
    if (way.norm() <= 1.0) return against(way);  // sticks
  } else if (!(pull.norm() > 0.0)) {
    return against(Slip::Zero());
  }
  // Slides back: (2). At λ = |K_tn| the length is at most 1.
  const auto too_long = [&](double more) { return solved(more).norm() - 1.0; };
  return against(solved(last_of(too_long, pull.norm())).normalized());
}
// [S2.5.2:stop]

// Whether the approach, or the whole impact, is over.
bool Course::done(const Moment& at) const {
  const double speed = velocity(at).z();
  if (approaching_) return speed >= 0.0;
  const bool given =
      end_ == ImpactEnd::work ? at.work >= work_wanted_ : at.impulse.z() >= impulse_wanted_;
  return given && speed >= rebound_;
}

// What is to come, once the bodies approach no more.
void Course::end_approach() {
  if (!approaching_) return;
  approaching_ = false;
  work_wanted_ = (1.0 - restitution_ * restitution_) * now_.work;
  impulse_wanted_ = (1.0 + restitution_) * now_.impulse.z();
}

// How much normal impulse is left along a straight line on which the velocity changes at this rate; infinite: its end is
// not on this line.
double Course::until_done(const Vec3& change) const {
  const double u = velocity(now_).z();
  const double rate = change.z();
  if (approaching_) return rate > 0.0 ? std::max(-u / rate, 0.0) : kNever;
  double left = 0.0;
  if (u < rebound_) left = rate > 0.0 ? (rebound_ - u) / rate : kNever;
  if (end_ == ImpactEnd::impulse) {
    left = std::max(left, impulse_wanted_ - now_.impulse.z());
  } else if (const double need = work_wanted_ - now_.work; need > 0.0) {
    const double square = u * u + 2.0 * rate * need;  // of the speed at the end
    if (square < 0.0 || (u < 0.0 && rate <= 0.0)) return kNever;
    left = std::max(
        left, u < 0.0 ? (std::sqrt(square) - u) / rate : 2.0 * need / (u + std::sqrt(square)));
  }
  return rate < 0.0 && u + left * rate < rebound_ ? kNever : left;
}

// Goes on along a straight line, at most so far. Returns whether the impact is over; if not, the line is.
bool Course::go_straight(const Vec3& way, double most) {
  const Vec3 change = yield_ * way;
  const double left = until_done(change);
  const double length = std::min(left, most);
  if (!std::isfinite(length)) return true;  // velocities that overflow
  now_.work += length * (velocity(now_).z() + 0.5 * length * change.z());
  now_.impulse += length * way;
  if (left > most) return false;
  if (!approaching_) return true;
  end_approach();
  return go_straight(way, most - length);
}

// [S2.5.2:turn]
// A step of (1) where slip turns, with dp = |u_t| dσ, or as much of it as is left. Returns whether the impact is over.
bool Course::turn(double length) {
  const Moment next = stepped(length);
  if (!done(next)) {
    now_ = next;
    return false;
  }
  const auto before = [&](double part) { return done(stepped(part)) ? -1.0 : 1.0; };
  now_ = stepped(last_of(before, length));
  if (!approaching_) return true;
  end_approach();
  return done(now_);
}

Moment Course::rate_at(const Moment& at) const {
  const Vec3 u = velocity(at);
  const double speed = slip_of(u).norm();
  return {{-friction_ * u.x(), -friction_ * u.y(), speed}, speed * u.z()};
}

// Runge and Kutta's of fourth order.
Moment Course::stepped(double length) const {
  const auto on = [&](const Moment& rate, double share) -> Moment {
    return {now_.impulse + share * length * rate.impulse, now_.work + share * length * rate.work};
  };
  std::array<Moment, 4> at;
  for (std::size_t k = 0; k < 4; ++k) at[k] = rate_at(k == 0 ? now_ : on(at[k - 1], kStages[k]));
  const auto& [a, b, c, d] = at;
  const Moment mean{(a.impulse + 2.0 * (b.impulse + c.impulse) + d.impulse) / 6.0,
                    (a.work + 2.0 * (b.work + c.work) + d.work) / 6.0};
  return on(mean, 1.0);
}
// [S2.5.2:turn]

}  // namespace

SlidingImpulse solve_sliding_impact(const SlidingImpact& impact) { return Course(impact).run(); }

}  // namespace tumble
