/// \file
/// \brief Impacts at many points, solved at one stroke.
#include "tumble/contact/simultaneous_impacts.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/contact/collision_law.hpp"
#include "tumble/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace tumble {
namespace {

// All of the impulse at a point.
Vec3 impulse_w(const PatchPoint& point, const Vec3& normal_w) {
  return point.normal_impulse * normal_w + point.friction_impulse_w;
}

}  // namespace

SimultaneousResult SimultaneousImpacts::solve(std::span<Contact> contacts,
                                              std::span<MovingBody> bodies) {
  SimultaneousResult result;
  load(contacts, bodies);
  assemble();
  bool approaching = false;
  for (std::size_t i = 0; i < rows_.size() && !approaching; ++i)
    approaching =
        rows_[i].movable && patches_[idx(rows_[i].patch)].normal_w.dot(slip_at(start_, i)) < 0.0;
  if (!approaching) return result;
  result.status = SimultaneousStatus::solved;

  // Ask for each contact's own restitution; if that cannot be had, for the smallest of all, and if
  // not even that, for none.
  const auto [least, most] =
      std::minmax_element(contacts.begin(), contacts.end(),
                          [](auto& a, auto& b) { return a.restitution < b.restitution; });
  const double smallest = least->restitution, largest = most->restitution;
  require_separation(contacts, largest);
  bool found = attempt(1.0, true, answer_, result);
  if (!found && smallest < largest) {
    require_separation(contacts, smallest);
    result.restitution_share = smallest / largest;
    found = attempt(1.0, true, answer_, result);
  }
  if (!found && largest > 0.0) {
    require_separation(contacts, 0.0);
    result.restitution_share = 0.0;
    found = attempt(1.0, true, answer_, result);
  }
  if (!found || !guard_energy(result)) {
    result.status = SimultaneousStatus::no_solution;
    return result;
  }
  account(answer_, result);
  finish(contacts, bodies);
  return result;
}

// Copies what is needed of bodies and contacts, so that the work is in proportion to the block.
void SimultaneousImpacts::load(std::span<const Contact> contacts,
                               std::span<const MovingBody> bodies) {
  for (const int body : involved_) place_[idx(body)] = -1;
  if (place_.size() < bodies.size()) place_.resize(bodies.size(), -1);
  involved_.clear();
  start_.clear();
  patches_.clear();
  rows_.clear();
  points_.clear();
  lcp_.pushing.clear();
  for (const Contact& contact : contacts) {
    Patch& patch = patches_.emplace_back();
    patch.normal_w = contact.normal_w;
    patch.friction = contact.friction;
    patch.first = place_of(contact.first, bodies);
    patch.second = place_of(contact.second, bodies);
    patch.begin = static_cast<int>(points_.size());
    patch.end = patch.begin + contact.count;
    for (int i = 0; i < contact.count; ++i) {
      points_.emplace_back().position_w = contact.points[idx(i)].position_w;
      rows_.emplace_back().patch = static_cast<int>(patches_.size()) - 1;
    }
  }
}

int SimultaneousImpacts::place_of(int body, std::span<const MovingBody> bodies) {
  require::that(body >= 0 && idx(body) < bodies.size(),
                "contacts: the index of a body of `bodies` is needed");
  if (place_[idx(body)] < 0) {
    place_[idx(body)] = static_cast<int>(start_.size());
    start_.push_back(bodies[idx(body)]);
    involved_.push_back(body);
  }
  return place_[idx(body)];
}

// A = J M⁻¹ J': how a unit impulse along one normal changes the velocity along another.
void SimultaneousImpacts::assemble() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    const Patch& patch = patches_[idx(row.patch)];
    for (std::size_t side = 0; side < 2; ++side) {
      const MovingBody& body = start_[idx(side == 0 ? patch.first : patch.second)];
      row.lever_w[side] = (points_[i].position_w - body.position_w).cross(patch.normal_w);
      row.velocity_w[side] = body.inverse_mass.cwiseProduct(patch.normal_w);
      row.spin_w[side] = body.inverse_inertia_w * row.lever_w[side];
    }
  }
  const int n = static_cast<int>(rows_.size());
  if (A_.rows() < n) {
    A_.resize(n, n);
    b_.resize(n);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = j; i < n; ++i) {
      A_(i, j) = coupling(rows_[idx(i)], rows_[idx(j)]);
      A_(j, i) = A_(i, j);
    }
    const Patch& patch = patches_[idx(rows_[idx(j)].patch)];
    const double all_ways = inverse_mass_at(start_[idx(patch.first)], start_[idx(patch.second)],
                                            points_[idx(j)].position_w)
                                .trace();
    rows_[idx(j)].movable = A_(j, j) > tolerance::rigid * all_ways;
  }
}

// The sum over the bodies that two points share; minus where one is pushed and the other pushed
// against.
double SimultaneousImpacts::coupling(const Row& a, const Row& b) const {
  const Patch& p = patches_[idx(a.patch)];
  const Patch& q = patches_[idx(b.patch)];
  double sum = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      if ((i == 0 ? p.first : p.second) != (j == 0 ? q.first : q.second)) continue;
      const double part = p.normal_w.dot(b.velocity_w[j]) + a.lever_w[i].dot(b.spin_w[j]);
      sum += i == j ? part : -part;
    }
  }
  return sum;
}

void SimultaneousImpacts::require_separation(std::span<const Contact> contacts,
                                             double largest_restitution) {
  separation_speeds_.clear();
  for (const Contact& contact : contacts) {
    const double e = std::min(contact.restitution, largest_restitution);
    for (int i = 0; i < contact.count; ++i)
      separation_speeds_.push_back(std::max(0.0, -e * contact.points[idx(i)].approach_speed));
  }
}

// u at a point.
Vec3 SimultaneousImpacts::slip_at(const std::vector<MovingBody>& bodies, std::size_t point) const {
  const Patch& patch = patches_[idx(rows_[point].patch)];
  return relative_velocity(bodies[idx(patch.first)], bodies[idx(patch.second)],
                           points_[point].position_w);
}

// The bodies after the impulses of an answer, or after its friction alone.
void SimultaneousImpacts::apply(const Answer& answer, bool with_normals) {
  trial_ = start_;
  for (std::size_t i = 0; i < answer.size(); ++i) {
    const Patch& patch = patches_[idx(rows_[i].patch)];
    const Vec3 j =
        with_normals ? impulse_w(answer[i], patch.normal_w) : answer[i].friction_impulse_w;
    if (j.isZero(0.0)) continue;
    apply_impulse(trial_[idx(patch.first)], trial_[idx(patch.second)], answer[i].position_w, j);
  }
}

// The normal impulses that go with the friction in the answer.
bool SimultaneousImpacts::solve_normals(double share, Answer& answer, SimultaneousResult& result) {
  apply(answer, false);
  const int n = static_cast<int>(rows_.size());
  for (int i = 0; i < n; ++i) {
    const Vec3& normal_w = patches_[idx(rows_[idx(i)].patch)].normal_w;
    // What cannot be moved is as good as not there.
    b_[i] = rows_[idx(i)].movable
                ? normal_w.dot(slip_at(trial_, idx(i))) - share * separation_speeds_[idx(i)]
                : 0.0;
  }
  solver_.solve(A_.topLeftCorner(n, n), b_.head(n), lcp_, lcp_.pushing);
  result.pivots += lcp_.pivots;
  if (lcp_.status != ComplementarityStatus::solved) {
    lcp_.pushing.clear();
    return false;
  }
  for (int i = 0; i < n; ++i) answer[idx(i)].normal_impulse = lcp_.f[idx(i)];
  for (const Patch& patch : patches_)
    even_out(patch.normal_w,
             std::span(answer).subspan(idx(patch.begin), idx(patch.end - patch.begin)));
  return true;
}

// An answer for a share of the separation speeds: normal impulses and friction in turn.
bool SimultaneousImpacts::attempt(double share, bool with_friction, Answer& answer,
                                  SimultaneousResult& result) {
  answer = points_;
  friction_.begin(answer.size());
  bool settled = false;
  for (int round = 0; round < kMostRounds && !settled; ++round) {
    if (!solve_normals(share, answer, result)) return false;
    ++result.rounds;
    double pressed = 0.0;
    double changed = 0.0;
    if (with_friction) {
      apply(answer, true);
      for (const PatchPoint& point : answer) pressed += point.normal_impulse;
      changed = friction_.step(patches_, trial_, answer);
    }
    settled = changed <= tolerance::friction_settled * pressed;
  }
  if (settled) return true;
  result.status = SimultaneousStatus::unsettled;
  // Where friction and pushes have driven each other up beyond all numbers, pushes alone.
  return std::isfinite(gain(answer)) || attempt(share, false, answer, result);
}

// The work of each part of the impulse: times the mean of the velocities before and after.
void SimultaneousImpacts::account(const Answer& answer, SimultaneousResult& result) {
  apply(answer, true);
  result.impulses = 0;
  result.restitution_energy = 0.0;
  result.friction_energy = 0.0;
  for (std::size_t i = 0; i < answer.size(); ++i) {
    const Vec3 mean = 0.5 * (slip_at(start_, i) + slip_at(trial_, i));
    const Vec3& n = patches_[idx(rows_[i].patch)].normal_w;
    result.restitution_energy += answer[i].normal_impulse * n.dot(mean);
    result.friction_energy += answer[i].friction_impulse_w.dot(mean);
    if (answer[i].normal_impulse > 0.0) ++result.impulses;
  }
}

// [J] by how much an answer raises the energy: 0 or less, or less than rounding, is allowed.
double SimultaneousImpacts::gain(const Answer& answer) {
  SimultaneousResult sums;
  account(answer, sums);
  double work = 0.0;
  for (std::size_t i = 0; i < answer.size(); ++i) {
    const Vec3& n = patches_[idx(rows_[i].patch)].normal_w;
    work += std::abs(impulse_w(answer[i], n).dot(slip_at(start_, i)));
  }
  const double change = sums.restitution_energy + sums.friction_energy;
  return change > tolerance::energy_rounding * work ? change : std::min(change, 0.0);
}

// Moves an answer that raises the energy towards one that does not, until it does not either. The
// energy along the way is E0 + slope θ + curvature θ². Returns the share θ that is left.
double SimultaneousImpacts::draw_back(const Answer& safe, Answer& answer) {
  const double end = gain(answer);
  if (end <= 0.0) return 1.0;
  const double start = std::min(0.0, gain(safe));  // leaves trial_ with the safe impulses
  double slope = 0.0;
  for (std::size_t i = 0; i < answer.size(); ++i) {
    const Vec3& n = patches_[idx(rows_[i].patch)].normal_w;
    slope += (impulse_w(answer[i], n) - impulse_w(safe[i], n)).dot(slip_at(trial_, i));
  }
  const double share = largest_share(start, slope, std::max(0.0, end - start - slope));
  for (std::size_t i = 0; i < answer.size(); ++i) {
    PatchPoint& point = answer[i];
    point.normal_impulse = (1.0 - share) * safe[i].normal_impulse + share * point.normal_impulse;
    point.friction_impulse_w =
        (1.0 - share) * safe[i].friction_impulse_w + share * point.friction_impulse_w;
  }
  return share;
}

// Sees to it that the energy does not rise. Returns false if a problem that has an answer was not
// solved.
bool SimultaneousImpacts::guard_energy(SimultaneousResult& result) {
  if (gain(answer_) <= 0.0) return true;
  if (!attempt(0.0, false, safe_, result)) return false;
  const bool bounces = std::any_of(separation_speeds_.begin(), separation_speeds_.end(),
                                   [](double w) { return w > 0.0; });
  if (!bounces) {
    draw_back(safe_, answer_);
    return true;
  }
  if (!attempt(0.0, true, inelastic_, result)) return false;
  draw_back(safe_, inelastic_);
  result.restitution_share *= draw_back(inelastic_, answer_);
  return true;
}

// Hands the velocities and the impulses out.
void SimultaneousImpacts::finish(std::span<Contact> contacts, std::span<MovingBody> bodies) {
  for (std::size_t i = 0; i < involved_.size(); ++i) bodies[idx(involved_[i])] = trial_[i];
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    for (int i = 0; i < contacts[c].count; ++i) {
      const PatchPoint& from = answer_[idx(patches_[c].begin + i)];
      contacts[c].points[idx(i)].normal_impulse += from.normal_impulse;
      contacts[c].points[idx(i)].friction_impulse_w += from.friction_impulse_w;
    }
  }
}

}  // namespace tumble
