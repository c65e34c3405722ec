/// \file
/// \brief The listing RESOLVECONTACTS, and Guendelman's shock step (thesis 4.4, 5.2, A.2).
#pragma once

#include "tumble/contact/graph.hpp"
#include "tumble/impulse_damped/damped_stage.hpp"

#include <vector>

namespace tumble {

/// The listing RESOLVECONTACTS: bodies that gravity would press into each other are stopped.
///
/// In pass i of N the restitution is \f$-1 + i/N\f$: each pass takes a larger part of the approach,
/// the last one all of it. The division is one of real numbers; of whole numbers it would be 0 in
/// every pass but the last, and these would do nothing.
/// \param stage   velocities in and out
/// \param passes  NUM_CONTACT_ITERATIONS, N, at least 0
/// \algorithm{RESOLVECONTACTS: appendix A.2}
/// \deviation{i/N is divided as real numbers.}
/// \verified{A box at rest stays where it is}
void resolve_contacts(DampedStage& stage, int passes);

/// Guendelman, Bridson and Fedkiw's shock propagation, which the thesis replaced by a push (4.4).
///
/// Once more contacts are stopped, from the ground up: level by level of the contact graph, and
/// what is below counts as immovable. Bodies of one level that touch are stopped as usual.
class ShockPropagation {
 public:
  /// Goes up once.
  /// \param stage   velocities in and out
  /// \param passes  over the contacts of each level, at least 1
  void run(DampedStage& stage, int passes);

 private:
  std::vector<SupportEdge> edges_;
  ContactGraph graph_;
};

}  // namespace tumble
