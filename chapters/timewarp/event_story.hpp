/// \file
/// \brief The order in which a technique resolves collisions, held against another order (thesis
///        5.1).
#pragma once

#include "driver/experiment.hpp"

namespace tumble::chapters {

// A collision that was resolved.
struct Collision {
  double time = 0.0;  // [s] since the start of the story
  int first = 0;      // index of a body
  int second = 0;     // index of the other one, above the first
};

// The reference of stories: a search over all bodies that misses nothing, all of them taken back for
// each collision. Meant for steps much smaller than a frame.
// resolution: [s] how exactly collisions are searched for
std::unique_ptr<Technique> search_over_all(double resolution = 1e-9);

// Runs a technique and keeps its events.
// dt: [s] of a frame, above 0
EventLog events_of(Technique& technique, World& world, double dt, int frames = 1);

// Events as a story.
std::vector<Collision> story_of(const EventLog& events, const World& start);

// Runs a technique and writes down the collisions.
// dt: [s] of a frame, above 0
std::vector<Collision> story_of(Technique& technique, World world, double dt, int frames = 1);

// The difference of a story from another one that is taken for true.
//
// The k-th collision of a pair in one story and the k-th of the same pair in the other are
// *partners*. The partners that both stories have in the same order, as many as there can be, are
// *in place* (the longest common subsequence). Times are not compared.
struct StoryDifference {
  int reference = 0;        // collisions of the true story
  int missed = 0;           // of the true story, without a partner
  int misordered = 0;       // with a partner, and not in place
  int invented = 0;         // of the tested story, without a partner
  std::vector<char> wrong;  // by collision of the tested story: 1 if it is not in place, else 0
};

// Holds a story against another one.
//
// Where several choices have as many collisions in place, the one is taken whose last collision
// comes first in the true story.
// \par Cost
// n log n
StoryDifference compare_stories(const std::vector<Collision>& reference,
                                const std::vector<Collision>& tested);

}  // namespace tumble::chapters
