/// \file
/// \brief The technique of Guendelman, Bridson and Fedkiw (thesis 2.5.2), which damped integration
///        starts from.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/contact/graph.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"
#include "tumble/impulse_damped/impulse_push.hpp"

#include <vector>

namespace tumble {

/// What ends approaches that the contact passes have left.
enum class ImpulseShock : std::uint8_t {
  velocity,  ///< shock propagation: level by level, all that lies below being infinitely heavy
  position,  ///< bodies that overlap after the step are moved apart: the thesis's choice (4.4)
  off        ///< nothing
};

/// The restitution of the sweeps over a level, in each pass and in shock propagation.
enum class LevelRestitution : std::uint8_t {
  constant,  ///< that of the pass in each, and 0 in shock propagation, as the paper prints it. Of two supports
  ///< the first one stops a body on its side alone, which turns it; the turning that is left when the
  ///< second has spoken lifts what stands on it, from level to level: a pyramid falls
  shock,  ///< -1 + j/S in sweep j of S in shock propagation, constant in the passes
  rising  ///< -1 + (i j)/(N S) in sweep j of S of pass i of N, and -1 + j/S in shock propagation: both supports
          ///< brake together. The default of the authors' own library
};

/// Options of the impulse technique.
struct ImpulseOptions {
  int collision_passes = 5;                     ///< over all pairs, at least 1
  int contact_passes = 10;                      ///< N of the restitutions -1 + i/N, at least 1
  int level_sweeps = 5;                         ///< over the pairs of a level in a pass
  ImpulseShock shock = ImpulseShock::velocity;  ///< see there
  LevelRestitution level_restitution = LevelRestitution::constant;  ///< see there
  bool repair = false;                              ///< whether ImpulseShock::position comes on top
  ImpulsePoints points = ImpulsePoints::area;       ///< where impulses act
  double sticky = 0.0;                              ///< [-] see StickyOptions; 0 as in the paper
  bool sleeping = false;                            ///< whether what rests falls asleep
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn
  PoseUpdate pose = PoseUpdate::separate;           ///< how bodies that push each other are moved
};

template <class Visitor>
void describe(ImpulseOptions& o, Visitor& v) {
  v.word("shock", o.shock,
         {{"velocity", ImpulseShock::velocity},
          {"position", ImpulseShock::position},
          {"off", ImpulseShock::off}},
         "remedy for approaches that remain after the contact passes: shock propagation, moving "
         "bodies apart (thesis 4.4), or none");
  v.word(
      "level_restitution", o.level_restitution,
      {{"constant", LevelRestitution::constant},
       {"shock", LevelRestitution::shock},
       {"rising", LevelRestitution::rising}},
      "restitution in the sweeps over a level: that of the pass as in the paper, rising to it in "
      "shock propagation, or in all passes, so that two supports share the impulse");
  v.word("points", o.points, {{"area", ImpulsePoints::area}, {"one", ImpulsePoints::one}},
         "contact points: the whole contact area, or its centre");
  v.whole("collision_passes", o.collision_passes, 1, 1000, "passes over colliding pairs");
  v.whole("contact_passes", o.contact_passes, 1, 1000,
          "passes over contacts, N of their restitutions -1 + i/N");
  v.whole("level_sweeps", o.level_sweeps, 1, 1000, "sweeps over the pairs of a level in each pass");
  v.number("sticky", o.sticky, 0.0, 1e6, "-",
           "collisions slower than this times sqrt(g L) do not bounce (thesis 4.3)");
  v.flag("repair", o.repair, "move bodies apart that overlap after the step");
  v.flag("sleeping", o.sleeping, "do not simulate bodies at rest (thesis 4.5)");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
  v.word("pose", o.pose, words_of(pose_updates()), kPoseMeaning);
}

/// Impulses for collisions, contacts and shock propagation, each at the predicted poses. A step has five stages:
///
/// 1. *Collisions*. Pairs that overlap at the predicted poses \f$x' = x + h(v + h g)\f$ and approach with the velocities
///    at the start of the step collide, deepest first. A body at rest has the velocity 0 and does not bounce, so no
///    threshold is needed to separate rest from flight.
/// 2. *Velocities*. Gravity is added.
/// 3. *Contacts*. Now all supports are approached. The approach is removed in passes with restitution
///    \f$\varepsilon_i = -1 + i/N,\; i = 1 \dots N\f$, from the ground up. Early passes only slow bodies down, so that no
///    pair takes the whole load before the others.
/// 4. *Shock propagation*. One more pass with ε = 0 by levels of the ContactGraph. Bodies of a finished level become
///    immovable, so that those above cannot press them down again.
/// 5. *Positions*. Bodies move to their predicted poses.
///
/// After each impulse its two bodies are predicted again, and each pair is tested at the latest predicted poses.
/// With PoseUpdate::exponential bodies are predicted, and move, about the points on which they stood at the end of the
/// step before (PivotUpdate), if the pair has not been moved since.
///
/// **Conserved.** The approach speed for Newton's restitution is that of the collision, once for each pair and step
/// (ImpulsePush). No impulse between two free bodies raises their energy. Linear momentum is conserved by each impulse,
/// angular momentum at the predicted centres: it is off by the impulse times the relative motion of the pair in the step.
/// Since impulses act at predicted poses, bodies end touching, with J v = 0 there and not at the start of the step; and a
/// falling body is stopped up to h² g above its support. One that arrives fast and does not bounce stops where the step
/// began, up to its way in a step before it arrives; from half its shortest edge on a run reports it (HitCheck).
///
/// **Limits.** A frozen level does not feel the load on it, so weight that the contact passes have not passed down is lost.
/// Ten passes pass down about three boxes: the lowest of a stack of ten bears 3.3 of them, and on a see-saw such a stack is
/// lifted by half its weight. Frozen bodies take no momentum, in a heap in flight either. Impulses keep overlap from growing
/// and do not remove it; in heaps it grows, and `repair` removes it. Results depend on the order of bodies of equal depth.
/// A body on two supports creeps by millimetres in a second (LevelRestitution). Without friction nothing undoes that: three
/// cubes that are set off from each other by a quarter of an edge slide 16 cm apart in two seconds, and no run reports it.
/// Over flush neighbours a box stumbles.
/// \par Energy
/// Collisions are booked at the velocities that they change, contacts at velocities half a step of gravity earlier. With
/// \f$v_c\f$ after collisions and \f$v'\f$ at the end of the step, \f$\tfrac12 m h\,g\cdot(v_c - v')\f$ of each body that a
/// contact pushes is booked with the impulses. The error of the semi-implicit rule, \f$-\tfrac12 m h^2 g^2\f$ for a body in
/// flight, and that of rotation are not booked.
///
/// **Large turns.** A step in which a body turns by more than a radian is divided (parts_of_turn()).
/// \par Cost
/// In each pass and sweep a test of each near pair of which a body has moved; with ImpulsePoints::area a complementarity
/// problem of up to eight points for each impulse, unless one impulse at the centre of the area is enough, as for a box on
/// the ground or on one other box. A pair may get 50 impulses in a step: a wall of 55 cubes, each on two, takes about ten
/// times as long with areas as with one point.
/// \see Guendelman, Bridson, Fedkiw, "Nonconvex rigid bodies with stacking", SIGGRAPH 2003.
/// \algorithm{Impulses with contact levels and shock propagation: section 2.5.2}
/// \deviation{All points of a contact area are solved together, and the graph of support follows from the normals, where the authors take one point after the other and let each body fall alone.}
/// \verified{A stack of ten rests under shock propagation}
class Impulse : public Cloned<Technique, Impulse> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a count below 1 or a negative threshold
  explicit Impulse(const ImpulseOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "impulse"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }

 private:
  // Two bodies that pushed each other when the last step ended, and where they were.
  struct KeptPush {
    BodyId first{};
    BodyId second{};
    Vec3 first_position_w = Vec3::Zero();
    Vec3 second_position_w = Vec3::Zero();
    PushedPair pair;  // indices are those of then
  };

  StepReport step_part(World& world, double dt);
  void list_pushed(const World& world);
  void keep_pushed(const World& world);
  void begin(World& world, double dt, StepReport& report);
  [[nodiscard]] const SleepingRule* sleeping() const;
  bool collide_deepest_first(const World& world, double dt, StepReport& report);
  void report_collisions(const World& world, StepReport& report);
  void build_graph(const World& world);
  bool hold_by_level(const World& world, double share, bool freeze, double dt, StepReport& report);
  bool hold_level(const World& world, std::span<const int> pairs, double share, bool rising,
                  double dt, StepReport& report);
  void book(const PushResult& push, StepReport& report) const;
  void repair_overlap(World& world, StepReport& report);
  void finish(World& world, double dt, StepReport& report);

  ImpulseOptions options_;
  ImpulseBodies bodies_;
  ImpulsePairs pairs_;
  ImpulsePush push_;
  ContactGraph graph_;
  OverlapRepair repair_;
  SleepingRule sleeping_;
  BoundingTree repair_phase_;
  std::vector<KeptPush> kept_;  // PoseUpdate::exponential: for the next step

  // Storage of one step, kept so that a warm step asks for no memory.
  std::vector<PushedPair> pushed_;
  ContactList contacts_;
  std::vector<int> order_;  // pairs in the order of a pass
  std::vector<SupportEdge> edges_;
  Islands islands_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> near_;
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
