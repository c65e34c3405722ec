/// \file
/// \brief The single rotation that keeps the nested boxes of figure 6.3 together best.
#include "exterior_rotation/best_frame.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_multimin.h>

namespace tumble::chapters {
namespace {

constexpr int kGrid = 4000;         // rates that are tried, from -widest to widest
constexpr int kSearch = 200;        // steps of Brent's method
constexpr int kRounds = 40;         // times that a simplex is taken up again
constexpr int kMoves = 600;         // of a simplex in a round
constexpr double kFirstSize = 0.3;  // [m] and [rad/s] of a simplex at first
constexpr double kLastSize = 1e-11;

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
  GroupFrame frame;
  frame.angular_velocity_w = Vec3(0.0, 0.0, rate);
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

double left_at_unknowns(const gsl_vector* u, void* problem) {
  return left_by(*static_cast<const Problem*>(problem),
                 {Vec3(gsl_vector_get(u, 0), gsl_vector_get(u, 1), 0.0),
                  Vec3(0.0, 0.0, gsl_vector_get(u, 2))});
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

BestFrame best_frame_by_simplex(const World& world, std::span<const Joint> joints, double dt,
                                const GroupFrame& start) {
  Problem problem{world, joints, dt};
  const std::unique_ptr<gsl_multimin_fminimizer, decltype(&gsl_multimin_fminimizer_free)> search(
      gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 3),
      gsl_multimin_fminimizer_free);
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> at(gsl_vector_alloc(3),
                                                                   gsl_vector_free);
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> size(gsl_vector_alloc(3),
                                                                     gsl_vector_free);
  gsl_vector_set(at.get(), 0, start.centre_w.x());
  gsl_vector_set(at.get(), 1, start.centre_w.y());
  gsl_vector_set(at.get(), 2, start.angular_velocity_w.z());
  gsl_multimin_function function{left_at_unknowns, 3, &problem};
  double least = left_at_unknowns(at.get(), &problem);
  for (int round = 0; round < kRounds; ++round) {
    gsl_vector_set_all(size.get(), round % 2 == 0 ? kFirstSize : 0.1 * kFirstSize);
    gsl_multimin_fminimizer_set(search.get(), &function, at.get(), size.get());
    for (int k = 0; k < kMoves; ++k) {
      if (gsl_multimin_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;
      if (gsl_multimin_fminimizer_size(search.get()) < kLastSize) break;
    }
    const double left = gsl_multimin_fminimizer_minimum(search.get());
    if (left < least) {
      least = left;
      gsl_vector_memcpy(at.get(), gsl_multimin_fminimizer_x(search.get()));
    }
  }
  return {{Vec3(gsl_vector_get(at.get(), 0), gsl_vector_get(at.get(), 1), 0.0),
           Vec3(0.0, 0.0, gsl_vector_get(at.get(), 2))},
          least};
}

}  // namespace tumble::chapters
