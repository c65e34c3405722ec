/// \file
/// \brief The techniques of the chapter timewarp as a user sets them.
#include "tumble/base/error.hpp"
#include "tumble/techniques/options.hpp"
#include "tumble/timewarp/timewarp_safer.hpp"
#include "tumble/timewarp/timewarp_simple.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include <string>

namespace tumble {
namespace {

void add_common(Parameters& p) {
  const TimewarpOptions standard;
  p.add_number("resolution", standard.resolution, 1e-15, 1.0, "s",
               "how exactly the moment of a collision is searched for");
  p.add_whole("pair_events", standard.pair_events, 1, 1000000,
              "collisions of a pair in one frame until it is left to the frame's end");
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn in flight");
}

void read_common(const Parameters& p, TimewarpOptions& options) {
  options.resolution = p.number("resolution");
  options.pair_events = p.count("pair_events");
  options.rotation = rotation_rule_from(p.word("rotation"));
}

}  // namespace

Parameters timewarp_listing_options() {
  Parameters p;
  add_common(p);
  return p;
}

std::unique_ptr<Technique> make_timewarp_simple(const Parameters& p, std::uint64_t) {
  TimewarpOptions options;
  read_common(p, options);
  return std::make_unique<TimewarpSimple>(options);
}

std::unique_ptr<Technique> make_timewarp_safer(const Parameters& p, std::uint64_t) {
  TimewarpOptions options;
  read_common(p, options);
  return std::make_unique<TimewarpSafer>(options);
}

Parameters timewarp_swept_options() {
  Parameters p;
  add_common(p);
  p.add_word("ties", {"together", "one_by_one"},
             "collisions closer in time than the resolution: at one stroke, or as found");
  return p;
}

std::unique_ptr<Technique> make_timewarp_swept(const Parameters& p, std::uint64_t) {
  TimewarpSweptOptions options;
  read_common(p, options);
  options.ties = p.word("ties") == "together" ? TieRule::together : TieRule::one_by_one;
  return std::make_unique<TimewarpSwept>(options);
}

}  // namespace tumble
