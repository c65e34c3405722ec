/// \file
/// \brief A row of glued boxes whose joints break: fracture as games have it (after thesis 2.4.1).
///
/// Uses `previous_work`, for joints in linear time.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/previous_work/joint_tree.hpp"

#include <span>
#include <vector>

namespace tumble {

/// When a joint breaks.
enum class RowRule : std::uint8_t {
  force,  ///< its force is above strength times cross section
  stress  ///< tension and bending stress of a beam are above the strength
};

/// A row of equal boxes along x.
struct RowOptions {
  Vec3 size = Vec3(1.0, 0.05, 0.1);  ///< [m] of the whole row
  int boxes = 40;                    ///< at least 2
  double density = 0.0;              ///< [kg/m³]
  double strength = 0.0;             ///< [Pa]
  RowRule rule = RowRule::stress;    ///< when a joint breaks
};

/// What a joint carries, in the frame of its row.
struct JointLoad {
  int joint = 0;                 ///< from 0, between boxes `joint` and `joint + 1`
  Vec3 force_b = Vec3::Zero();   ///< [N] on the box at larger x
  Vec3 torque_b = Vec3::Zero();  ///< [N m] about the middle of the joint
  double share = 0.0;            ///< [-] of what breaks it
};

/// A row of glued boxes in a world, moved by any technique.
///
/// Boxes that are glued in a row are one box as long as they hold, so every piece is a single body. After a step of the technique
/// the loads of all joints follow from the pushes of its contacts: a row whose boxes have the acceleration of their piece is a tree of joints
/// (JointTree). If the most loaded joint of a piece carries more than it can, the piece becomes two, with the motion that it had.
///
/// \f[ \sigma = \frac{N}{A} + \frac{|M_z|\,h/2}{b h^3/12} + \frac{|M_y|\,b/2}{h b^3/12} \f]
/// A push of contact lasts a whole step, however short the impact is. So what breaks in an impact depends on the step.
/// \par Cost
/// O(boxes) a step, whatever they are made of.
/// \verified{A row of glued boxes carries the bending moments of a beam}
/// \verified{A row of glued boxes breaks where the moment is largest, and keeps mass and momenta}
class BreakingRow {
 public:
  /// Adds the row to a world.
  /// \param world       receives one body
  /// \param position_w  [m] of its middle
  /// \throws std::invalid_argument naming the value that is out of range
  BreakingRow(World& world, const RowOptions& options, const Vec3& position_w,
              const Vec3& velocity_w = Vec3::Zero());

  /// Pushes the row in the next step.
  /// \param along      [-] where: 0 to 1 along the row
  void push(World& world, const Vec3& impulse_w, double along);

  /// A step of the technique, and what it breaks.
  /// \param technique  with contacts() of the whole step: one that divides steps, as contact_damped does, shows those of the last part
  /// \return the report of the technique; `events` are joints that broke
  StepReport step(World& world, Technique& technique, double dt);

  /// A piece of the row.
  struct Piece {
    BodyId body{};  ///< in the world
    int first = 0;  ///< of its boxes
    int count = 0;  ///< of boxes
  };
  /// \return all pieces, along the row
  [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
  /// \return joints and what they carried in the last step, along the row
  [[nodiscard]] std::span<const JointLoad> loads() const { return loads_; }
  /// \return systems of joints solved, each of one joint, since the start
  [[nodiscard]] std::int64_t joints_solved() const { return joints_solved_; }

 private:
  struct Push {
    BodyId body{};
    Vec3 impulse_w;
    Vec3 arm_b;  // of the point, from the centre of the piece
  };
  BodyId add(World& world, int count, const BodyState& state) const;
  void take_pushes(const World& world, const Technique& technique, double dt);
  void find_loads(const World& world, const Piece& piece, double dt);
  void divide(World& world, std::size_t piece, int count);

  RowOptions options_;
  Vec3 box_size_;
  std::vector<Piece> pieces_;
  std::vector<JointLoad> loads_;
  std::vector<Push> pushes_;
  std::vector<BodyState> starts_;  // of the pieces, where the step begins
  JointTree tree_;
  std::int64_t joints_solved_ = 0;
};

}  // namespace tumble
