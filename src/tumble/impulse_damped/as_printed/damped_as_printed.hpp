/// \file
/// \brief Damped integration as its listings are printed (thesis A.2).
///
/// Uses the chapter geometric_stability for its listing SETGEOMETRICALLYSTABLE.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometric_stability/as_printed/set_geometrically_stable_as_printed.hpp"
#include "tumble/impulse_damped/as_printed/printed_objects.hpp"
#include "tumble/impulse_damped/as_printed/resolve_as_printed.hpp"
#include "tumble/impulse_damped/damped_numbers.hpp"
#include "tumble/impulse_damped/pair_gatherer.hpp"

#include <vector>

namespace tumble {

/// Options of damped integration as printed.
struct DampedAsPrintedOptions {
  DampedErrata repaired;  ///< which errata are mended
  DampedNumbers numbers;  ///< ε and k; taken for the first movable body and for 1/60 s (DM8, DM15)
  int collision_passes = 5;      ///< [-] NUM_COLLISION_ITERATIONS, at least 0
  int contact_passes = 10;       ///< [-] NUM_CONTACT_ITERATIONS, at least 0
  std::int64_t push_cap = 1000;  ///< [-] pushes for one contact point until it is given up (X1)
  bool stable_boxes = true;      ///< whether line 6 is done
  NormalRule normals = NormalRule::last_face;       ///< along which bodies are pushed apart
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
  int index_base = 0;                               ///< see PrintedCollide::index_base (C10)
  int loop_base = 1;                                ///< see PrintedStage::loop_base (RK2)
  bool elastic_contacts = false;                    ///< see PrintedStage::elastic (RK3)
};

/// The thesis's damped integration, each listing of its appendix A.2 statement by statement, with
/// every misprint of the print, or without some of them.
///
/// It is there to be compared with the reading as meant: a run with all errata mended but one shows
/// what that one does. What the listings do not say is taken in the simplest way, and stated where it
/// is done. Friction is not in the listings; the damping stands for it.
///
/// | errata      | listing                            | where                                 |
/// |-------------|------------------------------------|---------------------------------------|
/// | D1 to D6    | DAMPEDINTEGRATION                  | here                                  |
/// | C1 to C11   | COLLIDE                            | collide_as_printed()                  |
/// | RK, RC      | RESOLVECOLLISIONS, RESOLVECONTACTS | resolve_contacts_as_printed()         |
/// | DM1 to DM17 | DAMPENOBJECTS                      | dampen_objects_as_printed()           |
/// | X1 to X7    | FIXCONTACTCONSTRAINTS              | fix_contact_constraints_as_printed()  |
/// | G1 to G8    | SETGEOMETRICALLYSTABLE             | set_geometrically_stable_as_printed() |
///
/// Of an erratum that is a choice without an alternative in these listings (D3, C8, C9, RC1, RC3
/// and others) nothing changes when it is mended. D1 mended is the order of section 5.2: gravity
/// before contacts.
/// \par How it ends
/// `event_cap` if bodies could not be pushed apart (X1), `not_finite` if a momentum is not a number
/// any more: the step is then taken back, up to its time.
/// \par Cost
/// 5 + 10 times a broad phase and a test of two boxes for each near pair. Allocates.
/// \algorithm{Damped integration as printed: appendix A.2}
/// \deviation{Pushes are capped, and immovable bodies keep their place whatever is done to their velocity.}
/// \verified{With all misprints mended the printed listings keep a cube at rest where it is}
/// \verified{Damped integration as printed ends every step with finite numbers, whatever is mended}
class DampedAsPrinted final : public Cloned<Technique, DampedAsPrinted> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for passes below 0, a cap below 1, an index or loop base that is
  ///         not 0 or 1, or numbers that check() refuses
  explicit DampedAsPrinted(const DampedAsPrintedOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "damped"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override;

  /// What SETGEOMETRICALLYSTABLE has found in the last step.
  /// \return whether it is geometrically stable; false if there was no such body in the last step
  [[nodiscard]] bool geometrically_stable(BodyId id) const;

 private:
  // What is known of a body from step to step.
  struct Memory {
    BodyId id{};
    PrintedStability stability;
    std::uint8_t touched = 0;              // it has had a contact interaction (DM5)
    Vec3 fixed_velocity_w = Vec3::Zero();  // [m/s] of a body that is immovable (D6)
  };

  void remember(const World& world);
  void resolve(World& world, double dt, bool contacts, StepReport& report);
  void integrate_object_velocities(World& world, double dt);
  void dampen_objects(World& world, double dt, StepReport& report);
  void fix_contact_constraints(World& world, StepReport& report);
  void set_geometrically_stable(World& world, StepReport& report);
  void gather_again(const World& world, double margin, ContactList& out, StepReport& report);
  void record(const World& world, double dt, const Contact& contact, const PrintedCollision& done,
              bool contacts);
  [[nodiscard]] DampedThresholds thresholds(const World& world, double dt) const;

  DampedAsPrintedOptions options_;
  PairGatherer gatherer_;
  std::vector<Memory> memory_;  // by body index, of the last step

  // Storage of one step.
  PrintedObjects objects_;
  ContactList collisions_;
  Vec3 ahead_w_ = Vec3::Zero();  // [m/s] what gravity has still to add
  std::vector<BodyState> start_;
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
