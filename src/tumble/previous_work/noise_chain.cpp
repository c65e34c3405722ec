/// \file
/// \brief Proposals and their acceptance.
#include "tumble/previous_work/noise_chain.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/math/elementary.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace tumble {
namespace {

constexpr double kShareOfAll = 0.1;     // [-] of the proposals draw all noise anew
constexpr double kShareOfNudges = 0.4;  // [-] nudge the values of one impact
constexpr double kNudge = 0.1;          // [-] half the range of a nudge

// The streams of one proposal.
enum Purpose : std::uint64_t { kChoice, kValues, kAcceptance };

// The logarithm of Hastings's ratio.
double log_ratio(double violation, double next, double strictness, double choices) {
  if (std::isinf(violation)) return 0.0;  // nothing is worse
  return std::isinf(next) ? next * -1.0
                          : elementary::log(choices) - strictness * (next - violation);
}

}  // namespace

NoiseChain::NoiseChain(const Random& stream, double strictness)
    : stream_(stream), strictness_(strictness) {
  require::positive(strictness, "strictness");
}

ImpactNoise NoiseChain::moved(const NoiseProposal& proposal, const Random& stream) const {
  Random drawn = stream.fork(kValues);
  if (proposal.move == NoiseMove::all) return ImpactNoise(drawn);
  ImpactNoise next = noise_;
  ImpactValues values = draw_values(drawn);
  if (proposal.move == NoiseMove::nudge) {
    const ImpactValues old = noise_.of(proposal.impact);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double value = old[k] + kNudge * (2.0 * values[k] - 1.0);
      const double wrapped = value - std::floor(value);
      values[k] = wrapped < 1.0 ? wrapped : 0.0;  // rounding
    }
  }
  next.set(proposal.impact, values);
  return next;
}

NoiseChain::Step NoiseChain::propose(const SimulateNoise& simulate) const {
  Step step;
  if (!recalled_) {
    step.recalls = true;
    step.noise = noise_;
    step.motion = simulate(noise_);
    return step;
  }
  // [S2.4.2:propose]
  const Random stream = stream_.fork(proposals_.size());
  const bool starts = proposals_.empty();
  Random choice = stream.fork(kChoice);
  const double which = choice.unit();
  if (!starts && !names_.empty() && which >= kShareOfAll) {
    step.proposal.move =
        which < kShareOfAll + kShareOfNudges ? NoiseMove::nudge : NoiseMove::redraw;
    step.proposal.impact = names_[choice.below(static_cast<std::uint32_t>(names_.size()))];
  }
  step.noise = moved(step.proposal, stream);
  step.motion = simulate(step.noise);
  step.proposal.violation = step.motion.violation;
  step.proposal.impacts = static_cast<int>(step.motion.impacts.size());

  // n / n': the impact that is changed is one of both motions, so that n' is above 0.
  const bool one = step.proposal.move != NoiseMove::all;
  const double choices = one && step.proposal.impacts > 0
                             ? static_cast<double>(impacts_) / step.proposal.impacts
                             : 1.0;
  Random acceptance = stream.fork(kAcceptance);
  const double drawn = elementary::log(1.0 - acceptance.unit());
  step.proposal.accepted =
      starts || drawn <= log_ratio(violation_, step.motion.violation, strictness_, choices);
  // [S2.4.2:propose]
  return step;
}

// The part of a step that a replay repeats.
void NoiseChain::keep(const NoiseProposal& proposal, ImpactNoise noise) {
  const auto number = static_cast<std::int64_t>(proposals_.size());
  proposals_.push_back(proposal);
  if (!proposal.accepted) return;
  if (number > 0) ++accepted_;
  noise_ = std::move(noise);
  violation_ = proposal.violation;
  impacts_ = proposal.impacts;
  if (proposal.violation == 0.0) found_.push_back({number, noise_});
  if (number > 0 && !(proposal.violation < least_)) return;
  least_ = proposal.violation;
  best_ = {number, noise_};
}

void NoiseChain::take(Step step) {
  if (!step.motion.finished) return;
  if (step.recalls) {
    require::that(step.motion.violation == violation_ &&
                      static_cast<int>(step.motion.impacts.size()) == impacts_,
                  "a motion that was recorded with violation " + shortest_text(violation_) +
                      " and " + std::to_string(impacts_) + " fast impacts has " +
                      shortest_text(step.motion.violation) + " and " +
                      std::to_string(step.motion.impacts.size()) +
                      ": go on with the scene, the settings and the program that recorded it");
    recalled_ = true;
  } else {
    keep(step.proposal, std::move(step.noise));
  }
  if (step.recalls || step.proposal.accepted) names_ = std::move(step.motion.impacts);
}

void NoiseChain::replay(std::span<const NoiseProposal> proposals) {
  require::that(proposals_.empty(), "a chain with proposals cannot be replayed: make a new one");
  for (const NoiseProposal& proposal : proposals) {
    const bool starts = proposals_.empty();
    require::that(!starts || (proposal.accepted && proposal.move == NoiseMove::all),
                  "the first proposal of a chain is its start, which is accepted");
    const Random stream = stream_.fork(proposals_.size());
    keep(proposal, proposal.accepted ? moved(proposal, stream) : ImpactNoise());
  }
  recalled_ = proposals_.empty();
}

}  // namespace tumble
