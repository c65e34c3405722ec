/// \file
/// \brief The list of techniques.
#include "tumble/techniques.hpp"

#include "tumble/analytic_lcp/analytic.hpp"
#include "tumble/analytic_lcp/time_stepping.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/basic_colliding/basic.hpp"
#include "tumble/techniques/options.hpp"

#include <string>

namespace tumble {
namespace {

Parameters basic_options() {
  const BasicOptions standard;
  Parameters p;
  p.add_number("resolution", standard.resolution, 1e-15, 1.0, "s",
               "how exactly the moment of an impact is searched for");
  p.add_whole("event_cap", standard.event_cap, 1, 1000000, "collisions allowed in one step");
  p.add_word("impacts", {"simultaneous", "sequential"},
             "how collisions at the same moment are resolved");
  p.add_word("search", {"discrete", "conservative"},
             "look at the end of a step only (thesis 3.2), or never pass a contact");
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn in flight");
  return p;
}

std::unique_ptr<Technique> make_basic(const Parameters& p, std::uint64_t) {
  BasicOptions options;
  options.resolution = p.number("resolution");
  options.event_cap = p.count("event_cap");
  options.impacts =
      p.word("impacts") == "simultaneous" ? ImpactOrder::simultaneous : ImpactOrder::sequential;
  options.search =
      p.word("search") == "discrete" ? SearchMethod::discrete : SearchMethod::conservative;
  options.rotation = rotation_rule_from(p.word("rotation"));
  return std::make_unique<Basic>(options);
}

// All solvers, the one of the default first, but for the one that tries everything: it is for eight
// contacts at most.
std::vector<std::string> solver_names(const std::string& first) {
  std::vector<std::string> names = {first};
  for (const LcpRecipe& recipe : lcp_solvers())
    if (recipe.name != first && recipe.name != "enumeration") names.emplace_back(recipe.name);
  return names;
}

Parameters analytic_options() {
  const AnalyticOptions standard;
  Parameters p;
  p.add_word("friction", {"coulomb", "none", "damping"},
             "Coulomb's, none, or none and bodies in contact are slowed down (thesis 5.3)");
  p.add_word("stable_boxes", {"off", "corners", "hull", "equilibrium"},
             "friction=none or damping: who is left out of the forces as geometrically stable "
             "(thesis 5.4)");
  p.add_word("directions", {"8", "4"}, "of the pyramid of friction in contacts");
  p.add_word("solver", solver_names(standard.solver), "of contact forces without friction");
  p.add_word("impacts", {"simultaneous", "sequential"},
             "how collisions at the same moment are resolved");
  p.add_number("sticky", standard.sticky.threshold, 0.0, 1e6, "-",
               "collisions slower than this share of sqrt(g L) stick (thesis 4.3)");
  p.add_number("resolution", standard.resolution, 1e-15, 1.0, "s",
               "how exactly the moment of an impact is searched for");
  p.add_whole("event_cap", standard.event_cap, 1, 1000000,
              "collisions and ends of sliding allowed in one step");
  p.add_number("damping_velocity", standard.damping.velocity, 0.0, 1.0, "-",
               "friction=damping: what 1/60 s leaves of velocities (k1 of the thesis)");
  p.add_number("damping_spin", standard.damping.spin, 0.0, 1.0, "-",
               "friction=damping: what 1/60 s leaves of angular velocities (k2)");
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn in flight");
  add_pose(p);
  return p;
}

std::unique_ptr<Technique> make_analytic(const Parameters& p, std::uint64_t) {
  AnalyticOptions options;
  const std::string_view friction = p.word("friction");
  options.friction = friction == "coulomb" ? AnalyticFriction::coulomb
                     : friction == "none"  ? AnalyticFriction::none
                                           : AnalyticFriction::damping;
  options.stable_boxes = stable_rule_from(p.word("stable_boxes"));
  options.directions = p.word("directions") == "8" ? 8 : 4;
  options.solver = p.word("solver");
  options.impacts =
      p.word("impacts") == "simultaneous" ? ImpactOrder::simultaneous : ImpactOrder::sequential;
  options.sticky.threshold = p.number("sticky");
  options.resolution = p.number("resolution");
  options.event_cap = p.count("event_cap");
  options.damping = {p.number("damping_velocity"), p.number("damping_spin")};
  options.rotation = rotation_rule_from(p.word("rotation"));
  options.pose = pose_update_from(p.word("pose"));
  return std::make_unique<Analytic>(options);
}

Parameters time_stepping_options() {
  Parameters p;
  p.add_word("form", {"stewart_trinkle", "anitescu_potra"},
             "close gaps and no more, or look at points that touch only");
  p.add_word("directions", {"4", "8"}, "of friction's pyramid");
  p.add_word("sticky", {"speed", "step_size", "off"},
             "how a collision is told to be too slow to bounce (thesis 4.3)");
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn");
  add_pose(p);
  return p;
}

std::unique_ptr<Technique> make_time_stepping(const Parameters& p, std::uint64_t) {
  TimeSteppingOptions options;
  options.velocities.form = p.word("form") == "stewart_trinkle" ? SteppingForm::stewart_trinkle
                                                                : SteppingForm::anitescu_potra;
  options.velocities.directions = p.word("directions") == "8" ? 8 : 4;
  const std::string_view sticky = p.word("sticky");
  options.velocities.sticky.rule = sticky == "speed"       ? StickyRule::speed
                                   : sticky == "step_size" ? StickyRule::step_size
                                                           : StickyRule::off;
  options.rotation = rotation_rule_from(p.word("rotation"));
  options.pose = pose_update_from(p.word("pose"));
  return std::make_unique<TimeStepping>(options);
}

}  // namespace

void add_pose(Parameters& p) {
  p.add_word("pose", {"separate", "exponential"},
             "how bodies that push each other are moved: each by itself, or about the point it "
             "stands on (thesis 6.2)");
}

const std::vector<TechniqueRecipe>& technique_library() {
  static const std::vector<TechniqueRecipe> library = {
      {"contact_damped", "6.3.1", "contact areas that stick, slide or let go, solved stiff",
       contact_damped_options, make_contact_damped},
      {"basic", "2.1", "advance, find an overlap, search back for the impact, resolve, go on",
       basic_options, make_basic},
      {"analytic", "3.3.1, 4.3, 5.3",
       "collisions in the order of their times, exact contact forces in between", analytic_options,
       make_analytic},
      {"time_stepping", "2.6.3", "impacts and contacts of a step at one stroke, with friction",
       time_stepping_options, make_time_stepping},
      {"impulse", "2.5.2", "collisions, gravity, contacts and shock propagation by impulses",
       impulse_options, make_impulse},
      {"damped", "5.2, 5.3, 5.4, A.2",
       "impulses, damping in place of friction, pushes out of overlap", damped_options,
       make_damped},
      {"timewarp_simple", "5.1, A.1",
       "collisions in the order of their times, two bodies taken back", timewarp_listing_options,
       make_timewarp_simple},
      {"timewarp_safer", "5.1, A.1", "as timewarp_simple, looking for earlier collisions nearby",
       timewarp_listing_options, make_timewarp_safer},
      {"timewarp_swept", "5.1", "as timewarp_simple, with swept volumes that miss nothing",
       timewarp_swept_options, make_timewarp_swept},
      {"timewarp_full", "2.4.3",
       "every body has a time of its own; who flew past a collision goes back",
       timewarp_full_options, make_timewarp_full},
      {"glued", "6.2", "what touches at the start sticks for ever, integrated in seven ways",
       glued_options, make_glued},
  };
  return library;
}

const TechniqueRecipe& technique_recipe(std::string_view name) {
  std::vector<std::string_view> names;
  for (const TechniqueRecipe& recipe : technique_library()) {
    if (recipe.name == name) return recipe;
    names.push_back(recipe.name);
  }
  require::that(false,
                "unknown technique " + std::string(name) + ": " + expected_names(name, names));
  return technique_library().front();  // not reached
}

}  // namespace tumble
