/// \file
/// \brief Boxes of particles and rods held by relaxation, as a technique (thesis 2.3).
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/previous_work/rods.hpp"

#include <vector>

namespace tumble {

/// Options of relaxation.
struct RelaxationOptions {
  int passes = 10;  ///< over all rods and contacts in a step, at least 1
};

template <class Visitor>
void describe(RelaxationOptions& o, Visitor& v) {
  v.whole("passes", o.passes, 1, 100000, "passes over all rods and contacts in a step");
}

/// Jakobsen's relaxation: a box is four particles and six rods, and a contact moves particles until its point is outside.
///
/// A step moves the particles on (RodParticles::advance()), looks for contacts there, and goes through all rods and contacts
/// several times. A contact point is a weighted mean of the particles of its box, \f$P = \sum c_k x_k\f$. If its two bodies overlap there by d,
/// the particles move by
/// \f[ \Delta x_k = \pm \frac{c_k w_k}{\sum c^2 w}\, d\, n , \f]
/// w their inverse masses: the least movement that ends the overlap. Friction takes back the slip of the step, by at most the coefficient
/// times what the normal has moved. The pose of the box is the nearest one to its particles, and its momenta are theirs.
///
/// **What it cannot do.** Nothing bounces: an impact takes all speed. Rods are as stiff as the passes make them, so a box gives way where it is hit,
/// and more so with longer steps. A spin dies out. A body that goes through a thin one within a step is not held back. Boxes that overlap
/// at the start fly apart, since what moves a particle is its velocity. Where a box is turned inside out its particles are
/// put back with its momenta (`fallbacks`).
/// \par Cost and determinism
/// O(passes (bodies + contact points)). No allocation once warm. A box and its mirror image have other particles, so
/// they move alike only as far as rods have their lengths.
/// \algorithm{Boxes of rods, contacts by projection: section 2.3}
/// \deviation{Friction adds up over the passes and is bounded by Coulomb's law; Jakobsen takes off a share of the slip.}
/// \verified{A box of rods that lands flat keeps no speed}
class Relaxation : public Cloned<Technique, Relaxation> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for no pass
  explicit Relaxation(const RelaxationOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "relaxation"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;

 private:
  // The particles of a body between two steps, and the state that they gave it.
  struct Kept {
    BodyId id{};
    BodyState written;
    std::array<Vec3, 4> now_w, before_w;
  };
  // A point of a contact, as a weighted mean of particles.
  struct Touch {
    std::array<int, 2> particle{};  // the first of its body, -1: immovable
    std::array<std::array<double, 4>, 2> weight{};
    std::array<Vec3, 2> place_w;  // [m] now of an immovable body
    Vec3 normal_w;
    Vec3 apart_w;                        // [m] from the first to the second point, before the step
    Vec3 way_w;                          // [m] how far it changed in the step before
    double friction = 0.0, yield = 0.0;  // yield: [1/kg] Σ c² w
    double push = 0.0;                   // [kg m] along the normal
    Vec3 rub_w = Vec3::Zero();           // [kg m] across it
  };
  void load(const World& world, double dt);
  void put_in_place(const World& world, std::size_t body, double dt);
  void find_contacts(const World& world, double dt, StepReport& report);
  void take_up(const World& world, const Contact& contact, const ContactPoint& point, double dt);
  [[nodiscard]] Vec3 apart(const Touch& touch, const std::vector<Vec3>& at_w) const;
  void move(const Touch& touch, const Vec3& push_w);
  void project();
  void show(World& world, double dt, StepReport& report);
  void store(World& world, double dt, StepReport& report);
  void record(const World& world, double dt, double energy, StepReport& report);

  RelaxationOptions options_;
  double last_dt_ = 0.0;  // [s] of the step before, or 0
  std::vector<Kept> kept_;

  // Of one step; kept so that a warm step asks for no memory.
  RodParticles particles_;
  std::vector<int> first_;  // by body: its first particle, -1: immovable
  BoundingTree near_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<MovingBody> moving_;
  ContactList contacts_;
  std::vector<Touch> touches_;
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
