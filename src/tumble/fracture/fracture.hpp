/// \file
/// \brief Brittle fracture of a body of tetrahedra by explicit steps (thesis 2.4.1).
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/dynamics/world.hpp"
#include "tumble/fracture/crack.hpp"
#include "tumble/fracture/outside.hpp"

#include <limits>
#include <vector>

namespace tumble {

/// Work of a run, in counts.
struct FractureWork {
  std::int64_t substeps = 0;     ///< explicit steps
  std::int64_t evaluations = 0;  ///< elements whose forces were computed
  double shortest = 0.0;         ///< [s] shortest substep, but for those that end a step
  CrackWork cracks;              ///< of the mesh
};

/// A body of tetrahedra that breaks, among rigid boxes and on the ground.
///
/// Each substep: forces of stress, gravity and contacts; nodes that are pulled apart crack (crack_all()); then velocities, and positions
/// with the new velocities. A substep is `tolerance::fracture_step` of stable_step() long, and shorter after each crack that leaves a
/// smaller element.
///
/// **Contacts** are penalty forces, as in the paper: of nodes in boxes and in the ground, and of nodes on the outside of a piece in elements of another
/// one. Friction is a damper across the normal, up to Coulomb's limit. Edges that cross without a node in the other body meet nothing.
/// \par Determinism
/// Nodes, elements and contacts are visited in the order in which they were made.
/// \see O'Brien, Hodgins, "Graphical modeling and animation of brittle fracture", SIGGRAPH 1999.
/// \algorithm{Brittle fracture: section 2.4.1}
/// \verified{A plank that falls on a bar breaks, and keeps its mass and its momentum between contacts}
class Fracture {
 public:
  /// Takes a mesh and the rigid bodies around it.
  /// \param mesh   at least one element
  /// \param rigid  boxes, movable or not, and the ground; they do not meet each other
  /// \param least  [m] smallest height of an element that a split may leave, above 0
  /// \throws std::invalid_argument naming the value that is out of range
  Fracture(ElasticMesh mesh, World rigid, double least);

  /// Advances by substeps.
  /// \return `event_cap` if the step would have taken more than the cap of substeps, and ended before; `not_finite` if it blew up;
  ///         `events` are cracks, `integrations` nodes that moved
  /// \throws std::invalid_argument for a dt that is not finite and above 0
  StepReport step(double dt);

  /// \return the body
  [[nodiscard]] const ElasticMesh& mesh() const { return mesh_; }
  /// The body, to be changed from outside between steps: loads, velocities, nodes that are held.
  [[nodiscard]] ElasticMesh& mesh() { return mesh_; }
  /// \return the boxes around it
  [[nodiscard]] const World& rigid() const { return rigid_; }
  /// \return counts since construction
  [[nodiscard]] const FractureWork& work() const { return work_; }
  /// \return [s] length of the next substep
  [[nodiscard]] double substep() const { return substep_; }

  /// Substeps in a step at most.
  static constexpr int kMostSubsteps = 1000000;

 private:
  // A node of one piece in an element of another.
  struct Touch {
    int node;
    int element;
    int corner;     // of the element, across from its face on the outside
    double volume;  // [m³] of the element; another one: it has been divided since
    double depth;   // [m] below the face in the last substep; below 0: outside
    bool open;      // whether it is pushed out
  };
  void measure(int from);
  void find_forces();
  void find_touches();
  void push_by_boxes(double h);
  void push_by_pieces();
  [[nodiscard]] Vec3 push(double mass, double depth, const Vec3& normal_w,
                          const Vec3& slip_w) const;
  bool move(double h);

  ElasticMesh mesh_;
  World rigid_;
  double least_;
  double stiffness_ = 0.0;  // [1/s²] of contacts, over mass
  double substep_ = std::numeric_limits<double>::infinity();
  double look_ = 0.0;        // [s] between searches for cracks
  double since_look_ = 0.0;  // [s]
  double deepest_ = 0.0;     // [m] node in another piece that is still pushed out
  FractureWork work_;
  std::vector<Vec3> forces_;
  std::vector<double> tension_;
  std::vector<int> piece_;            // by element
  std::vector<OutsideFace> outside_;  // of all pieces
  int pieces_ = 1;
  bool has_cracked_ = true;  // since these three were found
  std::vector<Touch> touches_;
  int until_touches_ = 0;  // substeps
};

}  // namespace tumble
