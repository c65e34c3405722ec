/// \file
/// \brief The list of techniques.
#include "tumble/techniques.hpp"

#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/analytic_lcp/time_stepping.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/options.hpp"
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/contact_damped/contact_damped_options.hpp"
#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/filtering/freezing.hpp"
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/damped.hpp"
#include "tumble/impulse_damped/impulse.hpp"
#include "tumble/previous_work/faure.hpp"
#include "tumble/previous_work/microcollisions.hpp"
#include "tumble/previous_work/optimised.hpp"
#include "tumble/previous_work/penalty.hpp"
#include "tumble/previous_work/relaxation.hpp"
#include "tumble/previous_work/settling.hpp"
#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"
#include "tumble/timewarp/timewarp_full.hpp"
#include "tumble/timewarp/timewarp_safer.hpp"
#include "tumble/timewarp/timewarp_simple.hpp"
#include "tumble/timewarp/timewarp_swept.hpp"

#include <algorithm>
#include <initializer_list>

namespace tumble {
namespace {

template <class Made, class Options>
std::unique_ptr<Technique> make(const Parameters& p, std::uint64_t /*seed*/) {
  return std::make_unique<Made>(read_options<Options>(p));
}

// --- techniques with sleeping: FreezeOnChatter can wrap them -------------------------------------
template <class Options>
struct Freezable {
  Options options;
  bool freeze = false;
};

template <class Options, class Visitor>
void describe(Freezable<Options>& o, Visitor& v) {
  describe(o.options, v);
  v.flag("freeze", o.freeze,
         "sleeping=on: islands that only chatter fall asleep too (thesis 6.3.1)");
}

template <class Made, class Options>
std::unique_ptr<Technique> freezable(const Freezable<Options>& o) {
  auto made = std::make_unique<Made>(o.options);
  if (!o.freeze) return made;
  require::that(o.options.sleeping, "freeze = on: expected sleeping = on beside it");
  return std::make_unique<FreezeOnChatter>(std::move(made));
}

template <class Made, class Options>
std::unique_ptr<Technique> make_freezable(const Parameters& p, std::uint64_t /*seed*/) {
  return freezable<Made>(read_options<Freezable<Options>>(p));
}

// --- techniques with a reading as printed --------------------------------------------------------

enum class ReadAs : std::uint8_t { meant, reported, printed };

struct Reading {
  ReadAs as = ReadAs::meant;
  std::string repaired = "none";
  bool traps = false;
};

// Errata of kind "choice": the text leaves them open, and one of the two readings fails (a trap).
constexpr const char* kDampedTraps =
    "D4,D5,D6,C3,C4,C6,C7,RK1,RC4,DM4,DM5,DM8,DM13,DM16,X1,G5,G7,G8";
constexpr const char* kTimewarpTraps = "T1,T2,T4,T6,T7,T8,F6";

// The errata that are repaired in a listing as printed: those that were asked for, and the traps unless traps=taken.
template <class Errata>
Errata repaired_in(const Reading& o, const char* traps) {
  Errata repaired(o.repaired);
  const Errata avoided(traps);
  for (const std::string& id : Errata::known())
    if (!o.traps && avoided.has(id)) repaired = repaired.with(id);
  return repaired;
}

template <class Visitor>
void describe_repaired(Reading& o, Visitor& v, std::string_view errata, std::string_view traps) {
  v.text("repaired", o.repaired,
         "reading=as_printed: errata that are corrected, for example " + std::string(errata) +
             "; or all, or none");
  v.word("traps", o.traps, {{"avoided", false}, {"taken", true}},
         "reading=as_printed: where the text is open (" + std::string(traps) +
             "), the less harmful reading, or the one that fails");
}

template <class Visitor>
void describe(Reading& o, Visitor& v, std::string_view appendix, std::string_view errata,
              std::string_view traps) {
  v.word("reading", o.as, {{"as_meant", ReadAs::meant}, {"as_printed", ReadAs::printed}},
         "the listings of appendix " + std::string(appendix) +
             " with their misprints corrected, or as printed");
  describe_repaired(o, v, errata, traps);
}

void refuse_unless_printed(std::string_view key, const std::string& given,
                           const std::string& usual) {
  require::that(given == usual, std::string(key) + " = " + given + ": expected " + usual +
                                    " unless reading=as_printed");
}

struct DampedSettings {
  Freezable<DampedOptions> meant;
  Reading reading;
};

template <class Visitor>
void describe(DampedSettings& o, Visitor& v) {
  describe(o.meant, v);
  v.word(
      "reading", o.reading.as,
      {{"as_meant", ReadAs::meant},
       {"as_reported", ReadAs::reported},
       {"as_printed", ReadAs::printed}},
      "the listings of appendix A.2 with their misprints corrected; the same with the damping that "
      "gives the results of thesis 6.1; or as printed");
  describe_repaired(o.reading, v, "C1,DM3", kDampedTraps);
}

// Options that the listings as printed do not have may only be at their defaults.
std::unique_ptr<Technique> make_damped_as_printed(const Parameters& p, const DampedSettings& o) {
  const auto only = [&](const char* key, std::initializer_list<std::string_view> possible) {
    const std::string& word = p.word(key);
    require::that(std::find(possible.begin(), possible.end(), word) != possible.end(),
                  std::string(key) + " = " + word + ": reading=as_printed has only " +
                      std::string(*possible.begin()));
  };
  only("points", {"one"});
  only("shock", {"position"});
  only("damping", {"all"});
  only("randomness", {"off", "fast"});  // fast is the default; the listings have no chance
  only("stable_boxes", {"corners", "off"});
  const DampedOptions& meant = o.meant.options;
  require::that(!meant.sleeping, "sleeping = on: reading=as_printed has no sleeping");
  require::that(!o.meant.freeze, "freeze = on: reading=as_printed has no sleeping");
  DampedAsPrintedOptions options;
  options.repaired = repaired_in<DampedErrata>(o.reading, kDampedTraps);
  options.numbers = meant.numbers;
  options.collision_passes = meant.collision_passes;
  options.contact_passes = meant.contact_passes;
  options.stable_boxes = meant.stable_boxes != StableRule::off;
  options.normals = meant.normals;
  options.rotation = meant.rotation;
  return std::make_unique<DampedAsPrinted>(options);
}

std::unique_ptr<Technique> make_damped(const Parameters& p, std::uint64_t seed) {
  auto o = read_options<DampedSettings>(p);
  if (o.reading.as == ReadAs::printed) return make_damped_as_printed(p, o);
  refuse_unless_printed("repaired", o.reading.repaired, "none");
  refuse_unless_printed("traps", p.word("traps"), "avoided");
  if (o.reading.as == ReadAs::reported) o.meant.options.numbers.k_scale *= kReportedDamping;
  o.meant.options.seed = seed;
  return freezable<Damped>(o.meant);
}

struct TimewarpSettings {
  TimewarpOptions meant;
  Reading reading;
  TimewarpAsPrintedOptions printed;
};

template <class Visitor>
void describe(TimewarpSettings& o, Visitor& v) {
  describe(o.meant, v);
  describe(o.reading, v, "A.1", "T3,F1", kTimewarpTraps);
  describe(o.printed, v);
}

// One of the two listings, as meant or as printed.
template <class AsMeant, TimewarpListing listing>
std::unique_ptr<Technique> make_listing(const Parameters& p, std::uint64_t /*seed*/) {
  const auto o = read_options<TimewarpSettings>(p);
  if (o.reading.as != ReadAs::printed) {
    refuse_unless_printed("repaired", o.reading.repaired, "none");
    refuse_unless_printed("traps", p.word("traps"), "avoided");
    refuse_unless_printed("cap", std::to_string(o.printed.cap),
                          std::to_string(TimewarpAsPrintedOptions{}.cap));
    refuse_unless_printed("separating", p.word("separating"), "ignored");
    return std::make_unique<AsMeant>(o.meant);
  }
  TimewarpAsPrintedOptions options = o.printed;
  options.listing = listing;
  options.repaired = repaired_in<TimewarpErrata>(o.reading, kTimewarpTraps);
  options.resolution = o.meant.resolution;
  options.pair_events = o.meant.pair_events;
  options.rotation = o.meant.rotation;
  return std::make_unique<TimewarpAsPrinted>(options);
}

}  // namespace

const std::vector<TechniqueRecipe>& technique_library() {
  static const std::vector<TechniqueRecipe> library = {
      {"contact_damped", "6.3.1", "contact patches that stick, slide or separate, solved together",
       declared_options<Freezable<ContactDampedOptions>>,
       make_freezable<ContactDamped, ContactDampedOptions>},
      {"basic", "2.1",
       "advance, find an overlap, search back for the impact, resolve, continue; fast bodies may "
       "pass through thin ones, sliding bodies catch on edges of flush neighbours, boxes creep "
       "down slopes",
       declared_options<BasicOptions>, make<Basic, BasicOptions>},
      {"analytic", "3.3.1, 4.3, 5.3",
       "collisions in the order of their times, exact contact forces in between; friction is up to "
       "8 % weaker between its eight directions, fast corners hit one by one and may throw a body "
       "aside, boxes on a rotating body drift outwards",
       declared_options<AnalyticOptions>, make<Analytic, AnalyticOptions>},
      {"time_stepping", "2.6.3",
       "impacts and contacts of a step solved together at its start; bounces come up to a step "
       "early, elastic bodies that collide one after another in a step lose energy, small bodies "
       "that fly several of their lengths or long ones that rotate by a radian in a step may pass "
       "through each other, bodies that fly closely past an edge may be turned aside, friction is "
       "up to 8 % weaker between its eight directions, boxes on a rotating body drift unless "
       "pose=exponential",
       declared_options<TimeSteppingOptions>, make<TimeStepping, TimeSteppingOptions>},
      {"impulse", "2.5.2",
       "collisions, gravity, contacts and shock propagation by impulses; bounces come up to a step "
       "early, elastic bounces die out, fast bodies may pass through thin ones, sliding bodies may "
       "catch on edges of flush neighbours, boxes on a moving body may sink or drift, stacks on "
       "slopes creep, stacks without friction slide apart, bodies pushed by heavy ones may sink in",
       declared_options<Freezable<ImpulseOptions>>, make_freezable<Impulse, ImpulseOptions>},
      {"damped", "5.2, 5.3, 5.4, A.2",
       "impulses, damping in place of friction, pushes out of overlap; elastic bounces die out, "
       "fast bodies may pass through thin ones, an elastic impact of faces may leave a spin, boxes "
       "on a moving body may drift, boxes may rest above their support by up to the fall of a "
       "step, light boxes give way to heavy loads",
       declared_options<DampedSettings>, make_damped},
      {"timewarp_simple", "5.1, A.1",
       "collisions in the order of their times, rolling back the two bodies that collide; fast "
       "bodies may pass through thin ones, sliding bodies catch on edges of flush neighbours, "
       "leaning or carried boxes may slip, boxes creep down slopes, elastic bodies on an elastic "
       "floor lose energy",
       declared_options<TimewarpSettings>, make_listing<TimewarpSimple, TimewarpListing::simple>},
      {"timewarp_safer", "5.1, A.1",
       "like timewarp_simple, with the same limits, and a search for earlier collisions nearby",
       declared_options<TimewarpSettings>, make_listing<TimewarpSafer, TimewarpListing::safer>},
      {"timewarp_swept", "5.1",
       "like timewarp_simple, with swept volumes, which miss no collision of bodies that rotate by "
       "less than a radian in a step",
       declared_options<TimewarpSweptOptions>, make<TimewarpSwept, TimewarpSweptOptions>},
      {"timewarp_full", "2.4.3",
       "every body has its own time, and a body that flew past a collision is rolled back; flush "
       "edges, slopes, leaning, carried and elastic bodies as in timewarp_simple",
       declared_options<TimewarpFullOptions>, make<TimewarpFull, TimewarpFullOptions>},
      {"glued", "2.6.5, 6.2",
       "bodies that touch at the start stay joined, with one of seven integrators; supports joints "
       "of scenes, with collisions if contacts=collide",
       declared_options<GluedOptions>, make<Glued, GluedOptions>},
      {"penalty", "2.5.1",
       "springs and dampers where bodies overlap; heavy loads sink in, boxes creep although "
       "friction "
       "should hold them, stacks without friction slide apart; flush edges and fast bodies as in "
       "timewarp_simple",
       declared_options<PenaltyOptions>, make<Penalty, PenaltyOptions>},
      {"faure", "2.6.4",
       "impulses of all contacts at once, with a limited number of iterations; bodies sink in if "
       "these are too few, and bounces may lose or gain energy; carried bodies and near misses as "
       "in time_stepping, leaning bodies, flush edges and fast bodies as in timewarp_simple",
       declared_options<FaureOptions>, make<Faure, FaureOptions>},
      {"relaxation", "2.3",
       "boxes of particles and rods; only fast impacts bounce, spins die out, boxes creep down "
       "slopes, carried boxes slip, stacks without friction slide apart, light boxes give way to "
       "heavy loads",
       declared_options<RelaxationOptions>, make<Relaxation, RelaxationOptions>},
      {"settling", "2.7.1", "lower potential energy step by step; no velocities, no friction",
       declared_options<SettlingOptions>, make<Settling, SettlingOptions>},
      {"optimised", "2.7.2",
       "nearest poses without overlap, then momenta; steps of any length; bounces may lose energy, "
       "fast and fast rotating bodies may go round obstacles, flush edges slow sliding bodies, "
       "bodies that pass an edge closely may be turned aside, boxes on a rotating body drift",
       declared_options<OptimisedOptions>, make<Optimised, OptimisedOptions>},
      {"microcollisions", "2.5.2",
       "every contact is a series of tiny collisions at one point (Mirtich); nothing comes to "
       "rest, "
       "boxes creep down slopes, carried boxes drift, loose tiles slow and rotate sliding bodies, "
       "an impact of faces leaves a spin, high stacks and fast rotating bodies reach the limit on "
       "impacts",
       declared_options<MicrocollisionsOptions>, make<Microcollisions, MicrocollisionsOptions>},
  };
  return library;
}

}  // namespace tumble
