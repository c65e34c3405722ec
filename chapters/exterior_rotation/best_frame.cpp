/// \file
/// \brief The single rotation that keeps the nested boxes of figure 6.3 together best.
#include "exterior_rotation/best_frame.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

namespace tumble::chapters {
namespace {

constexpr int kGrid = 4000;   // rates that are tried, from -widest to widest
constexpr int kSearch = 200;  // steps of Brent's method

struct Problem {
  const World& world;
  std::span<const Joint> joints;
  double dt = 0.0;
};

double left_by(const Problem& problem, const GroupFrame& frame) {
  return mismatch(problem.joints, moved_in_frame(problem.world, frame, problem.dt));
}

// The frame of a rate whose centre closes the lower joint.
//
// A shift of c by d moves all bodies by M d, M = 1 + h [Omega] - Exp(h Omega), and that has to make up for
// what is missing with c = 0.
GroupFrame closing_lower(const Problem& problem, double rate) {
  GroupFrame frame{.angular_velocity_w = Vec3(0.0, 0.0, rate)};
  const auto states = moved_in_frame(problem.world, frame, problem.dt);
  const Joint& lower = problem.joints.front();
  const JointPoint point = held_point(lower, states);
  const bool first_moves = problem.world.bodies()[static_cast<std::size_t>(lower.first)].movable();
  const Vec3 missing_w =
      first_moves ? Vec3(point.second_w - point.first_w) : Vec3(point.first_w - point.second_w);
  // In the plane M is a multiple of a rotation: a real part and an imaginary one.
  const Vec3 ahead_w = rotation_from_vector(problem.dt * frame.angular_velocity_w) * Vec3::UnitX();
  const double real = 1.0 - ahead_w.x();
  const double imaginary = problem.dt * rate - ahead_w.y();
  const double square = real * real + imaginary * imaginary;
  frame.centre_w = Vec3(real * missing_w.x() + imaginary * missing_w.y(),
                        real * missing_w.y() - imaginary * missing_w.x(), 0.0) /
                   square;
  return frame;
}

double left_at_rate(double rate, void* problem) {
  const auto& p = *static_cast<const Problem*>(problem);
  return left_by(p, closing_lower(p, rate));
}

}  // namespace

BestFrame best_frame(const World& world, std::span<const Joint> joints, double dt, double widest) {
  Problem problem{world, joints, dt};
  const double apart = 2.0 * widest / kGrid;
  double best_rate = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kGrid; ++k) {  // no grid point is 0
    const double rate = -widest + (k + 0.5) * apart;
    const double left = left_at_rate(rate, &problem);
    if (left < least) {
      least = left;
      best_rate = rate;
    }
  }
  const double low = best_rate - apart;
  const double high = best_rate + apart;
  if (least < left_at_rate(low, &problem) && least < left_at_rate(high, &problem)) {
    const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> search(
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
    gsl_function function{left_at_rate, &problem};
    gsl_min_fminimizer_set(search.get(), &function, best_rate, low, high);
    for (int k = 0; k < kSearch; ++k)
      if (gsl_min_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;
    if (gsl_min_fminimizer_f_minimum(search.get()) < least) {
      least = gsl_min_fminimizer_f_minimum(search.get());
      best_rate = gsl_min_fminimizer_x_minimum(search.get());
    }
  }
  return {closing_lower(problem, best_rate), least};
}

}  // namespace tumble::chapters
