/// \file
/// \brief Metropolis and Hastings' Markov chain over the noise of impacts (thesis 2.4.2).
#pragma once

#include "tumble/previous_work/impact_noise.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace tumble {

/// What a motion came to.
struct NoisyMotion {
  /// [-] How far it is from all that was wished: 0 if it meets it; infinity if there is no valid motion.
  double violation = std::numeric_limits<double>::infinity();
  std::vector<ImpactName> impacts;  ///< its fast impacts, in the order in which they happened
  bool finished = true;             ///< false if it was asked to stop; the rest means nothing then
};

/// Simulates the motion of some noise. Equal noise has to give an equal motion; several threads may call it at once.
using SimulateNoise = std::function<NoisyMotion(const ImpactNoise& noise)>;

/// How a proposal changes the noise.
enum class NoiseMove : std::uint8_t {
  all,     ///< new values for all impacts
  redraw,  ///< new values for one impact
  nudge    ///< the values of one impact, each moved a little; 1 is 0 again
};

/// The name of a move in files, for example "nudge".
[[nodiscard]] constexpr std::string_view name_of(NoiseMove move) {
  if (move == NoiseMove::all) return "all";
  return move == NoiseMove::redraw ? "redraw" : "nudge";
}

/// One proposal of a chain and what became of it.
struct NoiseProposal {
  NoiseMove move = NoiseMove::all;  ///< what was changed
  ImpactName impact;                ///< of which impact; not used by NoiseMove::all
  bool accepted = false;            ///< whether the chain went there
  double violation = 0.0;           ///< [-] of the motion proposed
  int impacts = 0;                  ///< fast impacts of this motion
};

/// A motion of a chain that meets all that was wished.
struct FoundMotion {
  std::int64_t proposal = 0;  ///< with which the chain went there
  ImpactNoise noise;          ///< gives the motion again
};

/// A Markov chain over the noise of a motion.
///
/// Its states are noises u; in the long run it is at each with the density
/// \f[ \pi(u) \propto p(u)\, e^{-s V(u)} , \f]
/// with p uniform, V the violation and s the strictness. A proposal draws anew what one impact gets, all three values, or nudges them, or
/// draws all noise anew. An impact is chosen among the n that the motion has; after the change the motion may have n', so the way back is
/// chosen with 1/n' where the way there was with 1/n, and the proposal is accepted with the probability (Hastings 1970)
/// \f[ \min\Bigl(1,\; \frac{n}{n'}\, e^{-s\,(V' - V)}\Bigr) , \f]
/// for new noise everywhere without n/n'. The chosen impact is one of both motions, since nothing before it changes.
///
/// All random numbers of a proposal come from a stream that is named by its number, so the list of proposals is all of the chain: replay()
/// needs no motion but the last one.
/// \see Chenney, Forsyth, "Sampling plausible solutions to multi-body constraint problems", 2000.
/// \see Hastings, "Monte Carlo sampling methods using Markov chains and their applications", 1970.
/// \algorithm{Sampling of motions: section 2.4.2}
/// \verified{A chain goes from one state to another as often as back, and is at each as often as it should be}
class NoiseChain {
 public:
  /// A step that has been simulated and not been taken yet.
  struct Step {
    bool recalls = false;    ///< the motion of the state after a replay
    NoiseProposal proposal;  ///< what becomes of it
    ImpactNoise noise;       ///< proposed
    NoisyMotion motion;      ///< of this noise
  };

  /// A chain without a state.
  /// \param stream      names all its random numbers
  /// \param strictness  [-] s, above 0
  /// \throws std::invalid_argument for another strictness
  NoiseChain(const Random& stream, double strictness);

  /// Simulates the next proposal; the first one is the start, which is always accepted.
  /// \return what take() makes the state; nothing has changed yet
  [[nodiscard]] Step propose(const SimulateNoise& simulate) const;

  /// Goes a step.
  /// \throws std::invalid_argument after a replay, if the motion is not the one that was replayed
  void take(Step step);

  /// Puts a chain without a state where another one was after some proposals.
  /// \param proposals  of a chain with the same stream and strictness
  /// \throws std::invalid_argument if they cannot be of a chain
  void replay(std::span<const NoiseProposal> proposals);

  /// All proposals: the start first.
  [[nodiscard]] std::span<const NoiseProposal> proposals() const { return proposals_; }
  /// The motions that meet all wishes: one for each accepted proposal without violation.
  [[nodiscard]] std::span<const FoundMotion> found() const { return found_; }
  /// The state with the smallest violation so far, the first of several: its proposal and its noise.
  [[nodiscard]] const FoundMotion& best() const { return best_; }
  /// The smallest violation so far [-]; infinity before the start.
  [[nodiscard]] double least_violation() const { return least_; }
  /// How many proposals were accepted, without the start, at most the number of proposals.
  [[nodiscard]] std::int64_t accepted() const { return accepted_; }

 private:
  [[nodiscard]] ImpactNoise moved(const NoiseProposal& proposal, const Random& stream) const;
  void keep(const NoiseProposal& proposal, ImpactNoise noise);

  Random stream_;
  double strictness_;
  std::vector<NoiseProposal> proposals_;
  std::vector<FoundMotion> found_;
  FoundMotion best_;
  double least_ = std::numeric_limits<double>::infinity();
  std::int64_t accepted_ = 0;
  ImpactNoise noise_;              // of the state
  double violation_ = 0.0;         // [-] of the state
  int impacts_ = 0;                // of the state
  std::vector<ImpactName> names_;  // of the state's impacts
  bool recalled_ = true;           // names_ is right; false after a replay
};

}  // namespace tumble
