/// \file
/// \brief Common part of the engines beside ours, and a factory for each.
///
/// Friction of a contact is that of our bodies, sqrt(mu_1 mu_2), in every engine.
#pragma once

#include "scene_engines.hpp"

#include <cstddef>
#include <memory>

namespace scene_bench {

// A body's pose and velocities as an engine has them.
struct Motion {
  tumble::Vec3 position_w = tumble::Vec3::Zero();          // [m] centre
  tumble::Quat orientation_wb = tumble::Quat::Identity();  // [-] body to world
  tumble::Vec3 velocity_w = tumble::Vec3::Zero();          // [m/s] of the centre
  tumble::Vec3 angular_velocity_w = tumble::Vec3::Zero();  // [rad/s] world frame

  // Whether it can be worked with.
  [[nodiscard]] bool finite() const {
    return position_w.allFinite() && orientation_wb.coeffs().allFinite() &&
           velocity_w.allFinite() && angular_velocity_w.allFinite() && orientation_wb.norm() > 0.5;
  }
};

// Common part of every engine beside ours: bodies in the world's order, read one by one.
class Peer : public Engine {
 public:
  void take_in(const tumble::World& world) override {
    for (; taken_ < world.count(); ++taken_) {
      const auto k = static_cast<std::size_t>(taken_);
      add(world.bodies()[k], world.states()[k]);
    }
  }

  bool write_back(tumble::World& world, double dt) override {
    for (int i = 0; i < taken_; ++i)
      if (world.bodies()[static_cast<std::size_t>(i)].movable() && !motion(i).finite())
        return false;
    for (int i = 0; i < taken_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (!world.bodies()[k].movable()) continue;
      const Motion now = motion(i);
      world.states()[k] =
          make_state(world.bodies()[k], now.position_w, now.orientation_wb.normalized(),
                     now.velocity_w, now.angular_velocity_w);
    }
    world.finish_step(dt);
    return true;
  }

  [[nodiscard]] int asleep(const tumble::World& world) const override {
    int count = 0;
    for (int i = 0; i < taken_; ++i)
      if (world.bodies()[static_cast<std::size_t>(i)].movable() && sleeps(i)) ++count;
    return count;
  }

 protected:
  // Adds the next body.
  virtual void add(const tumble::BodyProperties& body, const tumble::BodyState& state) = 0;
  // Reads a body.
  [[nodiscard]] virtual Motion motion(int i) const = 0;
  // Whether a body sleeps.
  [[nodiscard]] virtual bool sleeps(int i) const = 0;

 private:
  int taken_ = 0;
};

// ODE: dWorldQuickStep (scene_ode.cpp; only where ODE was found).
std::unique_ptr<Engine> make_ode(const tumble::World& start, bool sleeping, int iterations);

// ODE's version and precision.
std::string ode_version();

// Bullet: sequential impulses (scene_bullet.cpp; only where Bullet was found).
std::unique_ptr<Engine> make_bullet(const tumble::World& start, bool sleeping, int iterations,
                                    bool two_directions);

// Bullet's version and precision.
std::string bullet_version();

}  // namespace scene_bench
