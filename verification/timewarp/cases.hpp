/// \file
/// \brief Scenes, techniques and records for the tests of the timewarps.
#pragma once

#include "tumble/scenes/library.hpp"
#include "tumble/timewarp/timewarp_full.hpp"
#include "tumble/timewarp/timewarp_safer.hpp"
#include "tumble/timewarp/timewarp_simple.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include "support/runs.hpp"
#include "support/scenes.hpp"

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

namespace tumble::test {

// The techniques whose bodies are synchronised at the end of a frame, by name.
inline constexpr std::initializer_list<const char*> kSynchronised = {
    "timewarp_simple", "timewarp_safer", "timewarp_swept"};

// All timewarps, by name.
inline constexpr std::initializer_list<const char*> kTimewarps = {
    "timewarp_simple", "timewarp_safer", "timewarp_swept", "timewarp_full"};

// Makes a timewarp.
inline std::unique_ptr<Technique> make_timewarp(std::string_view name,
                                                const TimewarpOptions& options = {}) {
  if (name == "timewarp_simple") return std::make_unique<TimewarpSimple>(options);
  if (name == "timewarp_safer") return std::make_unique<TimewarpSafer>(options);
  if (name == "timewarp_full") {
    TimewarpFullOptions full;
    static_cast<TimewarpOptions&>(full) = options;
    return std::make_unique<TimewarpFull>(full);
  }
  TimewarpSweptOptions swept;
  static_cast<TimewarpOptions&>(swept) = options;
  return std::make_unique<TimewarpSwept>(swept);
}

// A world of cubes of 1 m on a line.
inline World line_of(const char* boxes, const char* restitution = "1") {
  return world_of("line", {{"boxes", boxes}, {"restitution", restitution}});
}

// The two bodies of a collision, by name, as in "a-b".
inline std::string names_of(const World& world, const Event& event) {
  return world.name(world.index_of(event.first)) + "-" + world.name(world.index_of(event.second));
}

}  // namespace tumble::test
