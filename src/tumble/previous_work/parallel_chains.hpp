/// \file
/// \brief Several Markov chains on several cores (thesis 2.4.2).
#pragma once

#include "tumble/previous_work/noise_chain.hpp"

#include <atomic>
#include <functional>
#include <span>

namespace tumble {

/// When a chain ends: the first of both.
struct ChainGoal {
  std::int64_t found = 1;         ///< motions that meet all wishes
  std::int64_t proposals = 1000;  ///< the start included
};

/// Whether a chain has come to its end.
[[nodiscard]] bool is_done(const NoiseChain& chain, const ChainGoal& goal);

/// Lets chains go on until all of them have come to their ends.
///
/// Each core takes a chain, brings it to its end and takes the next one. A chain knows nothing of the others, so the result
/// has the same bits for any number of cores.
/// \param chains    in and out
/// \param simulate  called by several threads at once
/// \param cores     threads that simulate, at least 1; more than there are chains are not used
/// \param stop      once it is true, no step is taken any more; `simulate` should look at it, too
/// \param watch     called by this thread at first, after steps and at the end, while no chain changes; may be empty
/// \throws std::invalid_argument for less than 1 core, and whatever `simulate` and `watch` throw, once all threads have ended
/// \verified{Chains have the same bits on any number of cores}
void run_chains(std::span<NoiseChain> chains, const ChainGoal& goal, const SimulateNoise& simulate,
                int cores, std::atomic<bool>& stop, const std::function<void()>& watch = {});

}  // namespace tumble
