/// \file
/// \brief The rows, the matrix and the constant part of the problem of contact forces.
#include "tumble/analytic_lcp/assembly.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/effective_mass.hpp"

#include <algorithm>
#include <string>

namespace tumble {
namespace {

void require_entries(std::size_t given, std::size_t needed, std::string_view name) {
  if (given != needed)
    refuse(std::string(name) + ": " + std::to_string(given) + " entries; " +
           std::to_string(needed) + " are needed");
}

void require_body(int body, std::size_t count) {
  if (body < 0 || idx(body) >= count)
    refuse("contact with body " + std::to_string(body) + ": an index below " +
           std::to_string(count) + " is needed");
}

// The axes are numbered as in AxisIndex: three faces of the first body, three of the second, then
// the edges.
bool is_edge_axis(AxisIndex axis) { return axis >= 6; }

Vec3 rate_of_edge_normal(const World& world, const Vec3& omega_first_w, const Vec3& omega_second_w,
                         const Contact& contact) {
  const auto edge_of = [&world](int body, int axis) -> Vec3 {
    return world.states()[idx(body)].orientation_wb.toRotationMatrix().col(axis);
  };
  const Vec3 e = edge_of(contact.first, (contact.axis - 6) / 3);
  const Vec3 h = edge_of(contact.second, (contact.axis - 6) % 3);
  const Vec3 c = e.cross(h);
  const double length = c.norm();
  require::that(length > tolerance::parallel_edges,
                "contact: its edges are parallel, so its normal is not that of two edges; gather "
                "contacts at the present poses");
  const Vec3& n = contact.normal_w;
  const Vec3 c_rate = omega_first_w.cross(e).cross(h) + e.cross(omega_second_w.cross(h));
  const Vec3 across = c_rate - n.dot(c_rate) * n;
  return (c.dot(n) < 0.0 ? -across : across) / length;
}

}  // namespace

Vec3 acceleration_at(const MovingBody& body, const Acceleration& acceleration,
                     const Vec3& point_w) {
  const Vec3 r = point_w - body.position_w;
  const Vec3& omega_w = body.angular_velocity_w;
  return acceleration.linear_w + acceleration.angular_w.cross(r) + omega_w.cross(omega_w.cross(r));
}

void free_accelerations(const World& world, std::span<const MovingBody> bodies,
                        std::vector<Acceleration>& out) {
  require_entries(bodies.size(), world.bodies().size(), "bodies");
  out.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Acceleration& free = out.emplace_back();
    if (!world.bodies()[i].movable()) continue;
    const MovingBody& body = bodies[i];
    for (int k = 0; k < 3; ++k)
      if (body.inverse_mass[k] > 0.0) free.linear_w[k] = world.gravity_w[k];
    // L is constant, w is not: 0 = L' = I w' + w x L.
    const Vec3& omega_w = body.angular_velocity_w;
    const Vec3 momentum_w =
        angular_momentum(world.bodies()[i], world.states()[i].orientation_wb, omega_w);
    free.angular_w = body.inverse_inertia_w * momentum_w.cross(omega_w);
  }
}

void accelerate(std::span<const MovingBody> bodies, std::span<const Wrench> wrenches,
                std::span<Acceleration> accelerations) {
  require_entries(wrenches.size(), bodies.size(), "wrenches");
  require_entries(accelerations.size(), bodies.size(), "accelerations");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    accelerations[i].linear_w += bodies[i].inverse_mass.cwiseProduct(wrenches[i].force_w);
    accelerations[i].angular_w += bodies[i].inverse_inertia_w * wrenches[i].torque_w;
  }
}

Vec3 rate_of_normal(const World& world, std::span<const MovingBody> bodies,
                    const Contact& contact) {
  require_entries(bodies.size(), world.bodies().size(), "bodies");
  require_body(contact.first, bodies.size());
  require_body(contact.second, bodies.size());
  if (contact.axis < kNoAxis || contact.axis > 14)
    refuse("contact.axis = " + std::to_string(contact.axis) + ": expected an axis from -1 to 14");
  const Vec3& omega_first_w = bodies[idx(contact.first)].angular_velocity_w;
  const Vec3& omega_second_w = bodies[idx(contact.second)].angular_velocity_w;
  if (contact.axis == kNoAxis) return Vec3::Zero();  // the ground's
  if (is_edge_axis(contact.axis))
    return rate_of_edge_normal(world, omega_first_w, omega_second_w, contact);
  return (contact.axis < 3 ? omega_first_w : omega_second_w).cross(contact.normal_w);
}

// The block of W that a body has in the problem; -1 for one that nothing moves.
int ContactProblem::place_of(int body, const World& world, std::span<const MovingBody> bodies) {
  if (!world.bodies()[idx(body)].movable()) return -1;
  if (place_[idx(body)] < 0) {
    place_[idx(body)] = static_cast<int>(involved_.size());
    involved_.push_back(body);
    lcp_.factors.bodies.push_back(
        {bodies[idx(body)].inverse_mass, bodies[idx(body)].inverse_inertia_w});
  }
  return place_[idx(body)];
}

// [S2.6.1:J]
// What a force at a point does to its two bodies: a row of J.
void ContactProblem::add_row(const World& world, std::span<const MovingBody> bodies,
                             const Contact& contact, const Vec3& point_w) {
  const Vec3& n = contact.normal_w;
  LcpFactors::Row& row = lcp_.factors.rows.emplace_back();
  row.first = place_of(contact.first, world, bodies);
  row.second = place_of(contact.second, world, bodies);
  row.linear_first_w = -n;
  row.angular_first_w = -(point_w - bodies[idx(contact.first)].position_w).cross(n);
  row.linear_second_w = n;
  row.angular_second_w = (point_w - bodies[idx(contact.second)].position_w).cross(n);
}
// [S2.6.1:J]

void ContactProblem::assemble(const World& world, std::span<const MovingBody> bodies,
                              std::span<const Acceleration> free, std::span<const Contact> contacts,
                              double separation_speed) {
  require_entries(bodies.size(), world.bodies().size(), "bodies");
  require_entries(free.size(), bodies.size(), "free");
  if (!(separation_speed >= 0.0))
    refuse("separation_speed = " + shortest_text(separation_speed) + ": give at least 0");
  for (const int body : involved_) place_[idx(body)] = -1;
  place_.resize(bodies.size(), -1);
  involved_.clear();
  rows_.clear();
  constant_.clear();
  lcp_.factors.rows.clear();
  lcp_.factors.bodies.clear();
  separating_ = 0;
  fastest_approach_ = 0.0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    const Vec3& n = contact.normal_w;
    const Vec3 n_rate = rate_of_normal(world, bodies, contact);
    const MovingBody& first = bodies[idx(contact.first)];
    const MovingBody& second = bodies[idx(contact.second)];
    for (int k = 0; k < contact.count; ++k) {
      const Vec3& p = contact.points[idx(k)].position_w;
      const Vec3 velocity_w = relative_velocity(first, second, p);
      const double speed = n.dot(velocity_w);
      if (speed > separation_speed) {
        ++separating_;
        continue;
      }
      fastest_approach_ = std::max(fastest_approach_, -speed);
      rows_.push_back({static_cast<int>(c), k});

      // [S2.6.1:row]
      // What the gap does without forces; what a force does to it.
      const Vec3 acceleration_w = acceleration_at(second, free[idx(contact.second)], p) -
                                  acceleration_at(first, free[idx(contact.first)], p);
      constant_.push_back(n.dot(acceleration_w) + 2.0 * n_rate.dot(velocity_w));
      add_row(world, bodies, contact, p);
      // [S2.6.1:row]
    }
  }
  multiply_out(lcp_.factors, lcp_.A);
  lcp_.b = view(constant_);
  lcp_.equality.clear();
}

void ContactProblem::add_to_b(std::span<const double> terms) {
  require_entries(terms.size(), rows_.size(), "terms");
  for (std::size_t i = 0; i < terms.size(); ++i) lcp_.b[static_cast<int>(i)] += terms[i];
}

void ContactProblem::add_wrenches(std::span<const double> f, std::span<Wrench> wrenches) const {
  require_entries(f.size(), rows_.size(), "f");
  require_entries(wrenches.size(), place_.size(), "wrenches");
  const auto push = [&](int place, double force, const Vec3& linear, const Vec3& angular) {
    if (place < 0) return;
    Wrench& wrench = wrenches[idx(involved_[idx(place)])];
    wrench.force_w += force * linear;
    wrench.torque_w += force * angular;
  };
  for (std::size_t i = 0; i < f.size(); ++i) {
    const LcpFactors::Row& row = lcp_.factors.rows[i];
    push(row.first, f[i], row.linear_first_w, row.angular_first_w);
    push(row.second, f[i], row.linear_second_w, row.angular_second_w);
  }
}

}  // namespace tumble
