/// \file
/// \brief The techniques of the chapter timewarp as a user sets them.
#include "tumble/base/error.hpp"
#include "tumble/techniques/options.hpp"
#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"
#include "tumble/timewarp/timewarp_full.hpp"
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

// What is said about the reading as printed, and means nothing for the one as meant.
void refuse_unless_printed(const Parameters& p) {
  const TimewarpAsPrintedOptions standard;
  const auto only = [&](const std::string& key, const std::string& given,
                        const std::string& usual) {
    require::that(given == usual,
                  key + " = " + given + ": expected " + usual + " unless reading=as_printed");
  };
  only("repaired", p.text("repaired"), "none");
  only("cap", std::to_string(p.count("cap")), std::to_string(standard.cap));
  only("separating", p.word("separating"), "ignored");
}

std::unique_ptr<Technique> make_as_printed(const Parameters& p, TimewarpListing listing) {
  TimewarpAsPrintedOptions options;
  options.listing = listing;
  options.repaired = TimewarpErrata(p.text("repaired"));
  options.resolution = p.number("resolution");
  options.cap = p.count("cap");
  options.pair_events = p.count("pair_events");
  options.collide_separating = p.word("separating") == "collided";
  options.rotation = rotation_rule_from(p.word("rotation"));
  return std::make_unique<TimewarpAsPrinted>(options);
}

// One of the two listings, in the reading that is asked for.
template <typename AsMeant>
std::unique_ptr<Technique> make_listing(const Parameters& p, TimewarpListing listing) {
  if (p.word("reading") == "as_printed") return make_as_printed(p, listing);
  refuse_unless_printed(p);
  TimewarpOptions options;
  read_common(p, options);
  return std::make_unique<AsMeant>(options);
}

}  // namespace

Parameters timewarp_listing_options() {
  const TimewarpAsPrintedOptions printed;
  Parameters p;
  add_common(p);
  p.add_word("reading", {"as_meant", "as_printed"},
             "the listings of appendix A.1 with their misprints mended, or as they are printed");
  p.add_text("repaired", "none",
             "reading=as_printed: errata that are mended all the same, as T1,F6; or all, or none");
  p.add_whole("cap", printed.cap, 1, 1000000,
              "reading=as_printed: collisions in one frame until it is given up");
  p.add_word("separating", {"ignored", "collided"},
             "reading=as_printed: what collideTwoObjects does with two bodies that part");
  return p;
}

std::unique_ptr<Technique> make_timewarp_simple(const Parameters& p, std::uint64_t) {
  return make_listing<TimewarpSimple>(p, TimewarpListing::simple);
}

std::unique_ptr<Technique> make_timewarp_safer(const Parameters& p, std::uint64_t) {
  return make_listing<TimewarpSafer>(p, TimewarpListing::safer);
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

Parameters timewarp_full_options() {
  const TimewarpFullOptions standard;
  Parameters p;
  add_common(p);
  p.add_number("stride", standard.stride, 0.0, TimewarpFullOptions::kLongestStride, "-",
               "how far a body flies at a time, in steps; 0: to the end of the step or the next "
               "synchronisation");
  p.add_whole("synchronise_every", standard.synchronise_every, 0, 1000000,
              "frames after which nobody may be ahead; 0: never");
  return p;
}

std::unique_ptr<Technique> make_timewarp_full(const Parameters& p, std::uint64_t) {
  TimewarpFullOptions options;
  read_common(p, options);
  options.stride = p.number("stride");
  options.synchronise_every = p.count("synchronise_every");
  return std::make_unique<TimewarpFull>(options);
}

}  // namespace tumble
