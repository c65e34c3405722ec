/// \file
/// \brief Moments of runs, labelled with the motion of a body, to test rules that classify it (thesis
///        6.3.1).
#pragma once

#include "tumble/filtering/chatter_detector.hpp"

#include "driver/experiment.hpp"
#include "filtering/settled_run.hpp"

namespace tumble::chapters {

// The motion of a body, as half a second before a frame and the time after it show.
enum class Doing : std::uint8_t {
  // of a clump: rests half a second before and two after, and shakes by a thousandth of its edge in
  // the half seconds on both sides
  chatters,
  slides,  // gets a hundredth of its edge in both half seconds, at up to 0.3 m/s, hardly turning
  rolls,   // gets as far, and turns: rolls, tumbles, tips over or spins
  rocks,   // a block on its edges, by a hundredth of its shortest edge in both half seconds
  creeps,  // slides within a settling clump, and shakes as the others there do
  falls,   // gets as far, and is not in contact for most of the time
  speeds,  // slides faster
  nothing  // rests, or hard to say
};

// Kinds that there are, without Doing::nothing.
inline constexpr std::size_t kDoings = 7;

// Windows that the rule is tried with [frame].
inline constexpr std::array<int, 8> kWindows = {8, 12, 16, 20, 24, 30, 45, 60};

// A frame of a body, and what rules can know of it by then.
struct Moment {
  Doing doing = Doing::nothing;    // what its whole run says that the body does
  Motion verdict = Motion::moves;  // of the rule, with its standard numbers
  double swing_ratio = 0.0;        // [-] ChatterDetector::swing_ratio()
  double path_over_way = 0.0;      // [-] P/D; 0: too fast or not in contact
  double fastest = 0.0;            // [-] over half a second, as the sleeping rule has it
  bool small = false;              // all momenta below ε5 and ε7 for half a second
  std::array<Motion, kWindows.size()> others;  // what the rule says with other windows
};

// Moments of some runs, and how often one would freeze what moves.
struct MotionCorpus {
  std::vector<Moment> moments;  // all that do something
  double moving = 0.0;          // [s] that bodies move, of all bodies together
  int false_freezes = 0;        // how often one was calm for half a second while moving
};

// Labels a run and applies the rules to it.
// every: [frame] between two moments of a body
void add_run(const SettledRun& run, int every, Doing scene, MotionCorpus& corpus);

// All runs of a seed: a clump that settles under `damped`, and boxes that slide, roll and rock under
// `contact_damped` and `impulse`, with sizes, speeds, friction and tilt drawn by chance.
MotionCorpus corpus_of(std::uint64_t seed, int per_edge, int boxes);

}  // namespace tumble::chapters
