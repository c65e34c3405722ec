/// \file
/// \brief Contact points with friction as unknowns of an iteration (thesis 2.6.4, 2.7.2).
#pragma once

#include "tumble/contact/contact.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tumble {

/// Scale of the energy that impulses turn over: each push times the speed with which its point approached.
/// \return [J] the sum over all points
double pushed_energy(std::span<const Contact> contacts);

/// Contact points and their impulses, as ProjectedDescent asks for them: three unknowns a point, along its normal and two directions
/// across it.
///
/// Impulses p change the motions of all points by A p; they push, and friction is at most the coefficient times the push. Among
/// these the energy \f$\tfrac12 p^{\mathsf T} A p + b^{\mathsf T} p\f$ is least where no point moves less than it has to. Motions are
/// velocities, or displacements with kg m in place of N s.
class RubbingPoints {
 public:
  virtual ~RubbingPoints() = default;
  /// Takes contacts up.
  /// \param bodies    how they would move without contacts
  /// \param contacts  with the impulses to start from
  /// \param least     [m/s] least motion of each point along its normal, in the order of the contacts
  void take(std::span<const MovingBody> bodies, std::span<const Contact> contacts,
            std::span<const double> least);
  /// \return three for each point
  [[nodiscard]] std::size_t size() const { return 3 * rows_.size(); }
  /// \return [1/kg]
  [[nodiscard]] double diagonal(std::size_t i) const { return yield_[i]; }
  /// \return [m/s] how the point would move, less what it may
  [[nodiscard]] double constant(std::size_t i) const { return constant_[i]; }
  /// What impulses change of the motions of all points.
  /// \param p    [N s]
  /// \param out  [m/s] is overwritten
  void multiply(std::span<const double> p, std::span<double> out);
  /// Contacts push, and friction is at most the coefficient times the push.
  /// \param p  [N s] in and out
  void allow(std::span<double> p) const;
  /// Friction has limits of its own from now on, until take(): the coefficient times the present pushes, or none. With these the
  /// energy has one minimum; with limits that grow with the pushes, more push gives more friction, which may take more energy than the push adds.
  /// \param rubs  false: none
  void fix_limits(bool rubs);
  /// Ends fixed limits: friction is at most the coefficient times the present pushes.
  void end_limits();
  /// Whether a point that pushes leaves faster than it has to.
  /// \param share  [-] of the fastest point's motion, above which it counts
  /// \return true for an answer that is none
  [[nodiscard]] bool lifts(double share);
  /// \return [N s] those to start from, and then the answer
  [[nodiscard]] std::vector<double>& impulses() { return impulses_; }
  /// How long the first step from no impulses is, at least; see DescentReport::step.
  [[nodiscard]] double first_step() const;
  /// Begins without impulses if those of the start have an energy above 0, and so could add some.
  void require_no_energy();
  /// Gives the impulses to contacts and bodies.
  /// \param contacts  those taken up; receive the impulses
  /// \param bodies    receive what these change
  void push(std::span<Contact> contacts, std::span<MovingBody> bodies) const;

 private:
  /// What the velocities of all bodies become by impulses: by their own masses and inertias, unless something else holds them.
  /// \param linear_w   [N s] by body index; then [m/s]
  /// \param angular_w  [N m s] by body index; then [rad/s]
  virtual void yield(std::span<Vec3> linear_w, std::span<Vec3> angular_w);

  [[nodiscard]] Vec3 impulse_w(std::size_t row) const;  // [N s] on the second body

  struct Row {
    int first = 0, second = 0;         // bodies
    std::array<Vec3, 3> axis_w;        // [-] normal and tangents
    std::array<Vec3, 3> arm_first_w;   // [m] lever arm × axis
    std::array<Vec3, 3> arm_second_w;  // [m]
    double friction = 0.0;             // [-]
  };

  std::span<const MovingBody> bodies_;
  std::vector<Row> rows_;
  std::vector<double> yield_;     // [1/kg] by unknown, of the pair; across the normal the mean
  std::vector<double> constant_;  // [m/s] by unknown
  std::vector<double> impulses_;
  std::vector<double>
      limits_;  // [N s] by point: of friction; empty: the coefficient times the push
  std::vector<Vec3> linear_w_, angular_w_;  // [m/s], [rad/s] what impulses change, by body index
  std::vector<double> image_;
};

}  // namespace tumble
