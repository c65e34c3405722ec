/// \file
/// \brief The techniques of the chapter impulse_damped as a user sets them.
#include "tumble/base/error.hpp"
#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/filtering/freezing.hpp"
#include "tumble/impulse_damped/as_printed/damped_as_printed.hpp"
#include "tumble/impulse_damped/damped.hpp"
#include "tumble/impulse_damped/impulse.hpp"
#include "tumble/techniques/options.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

namespace tumble {
namespace {

void add_freeze(Parameters& p) {
  p.add_flag("freeze", false,
             "sleeping=on: heaps whose earlier steps tell that they only chatter fall asleep too "
             "(thesis 6.3.1)");
}

std::unique_ptr<Technique> frozen_if_asked(const Parameters& p, std::unique_ptr<Technique> made) {
  if (!p.flag("freeze")) return made;
  require::that(p.flag("sleeping"), "freeze = on: expected sleeping = on beside it");
  return std::make_unique<FreezeOnChatter>(std::move(made));
}

}  // namespace

Parameters impulse_options() {
  const ImpulseOptions standard;
  Parameters p;
  p.add_word("shock", {"velocity", "position", "off"},
             "what ends approaches that contact passes leave: shock propagation, moving bodies "
             "apart (thesis 4.4), nothing");
  p.add_word("shock_restitution", {"zero", "rising"},
             "of the sweeps over a level: 0 as in the paper, or -1 + j/S, which squirms less");
  p.add_word("points", {"area", "one"},
             "where impulses act: the whole contact area, or its centre");
  p.add_whole("collision_passes", standard.collision_passes, 1, 1000, "over all pairs");
  p.add_whole("contact_passes", standard.contact_passes, 1, 1000,
              "N of the restitutions -1 + i/N of contacts");
  p.add_whole("level_sweeps", standard.level_sweeps, 1, 1000,
              "over the pairs of a level in each pass");
  p.add_number("sticky", standard.sticky, 0.0, 1e6, "-",
               "collisions slower than this share of sqrt(g L) stick (thesis 4.3)");
  p.add_flag("repair", standard.repair, "move bodies apart that overlap after the step");
  p.add_flag("sleeping", standard.sleeping, "what rests is left alone (thesis 4.5)");
  add_freeze(p);
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn");
  add_pose(p);
  return p;
}

std::unique_ptr<Technique> make_impulse(const Parameters& p, std::uint64_t) {
  ImpulseOptions options;
  const std::string_view shock = p.word("shock");
  options.shock = shock == "velocity"   ? ImpulseShock::velocity
                  : shock == "position" ? ImpulseShock::position
                                        : ImpulseShock::off;
  options.shock_restitution =
      p.word("shock_restitution") == "zero" ? ShockRestitution::zero : ShockRestitution::rising;
  options.points = p.word("points") == "area" ? ImpulsePoints::area : ImpulsePoints::one;
  options.collision_passes = p.count("collision_passes");
  options.contact_passes = p.count("contact_passes");
  options.level_sweeps = p.count("level_sweeps");
  options.sticky = p.number("sticky");
  options.repair = p.flag("repair");
  options.sleeping = p.flag("sleeping");
  options.rotation = rotation_rule_from(p.word("rotation"));
  options.pose = pose_update_from(p.word("pose"));
  return frozen_if_asked(p, std::make_unique<Impulse>(options));
}

Parameters damped_options() {
  const DampedOptions standard;
  Parameters p;
  p.add_word("normals", {"last_face", "separation", "signed_distance"},
             "of overlapping pairs: the face that was closest in the last step (thesis 3.3.2), the "
             "exact one, or the gradient of a box's distance");
  p.add_word("points", {"one", "area"}, "contact points of a pair: the thesis's, or all");
  p.add_word(
      "shock", {"position", "velocity"},
      "what is left of overlap: bodies are pushed up (thesis 4.4), or velocities are stopped "
      "from the ground up (Guendelman)");
  p.add_word("stable_boxes", {"corners", "hull", "off"},
             "how geometrically stable boxes are told (thesis 5.4)");
  p.add_word("damping",
             {"all", "none", "scale", "small", "align", "tilt", "freeze", "scale+small",
              "scale+small+align", "scale+small+align+tilt", "small+align+tilt+freeze",
              "scale+align+tilt+freeze", "scale+small+tilt+freeze", "scale+small+align+freeze"},
             "which parts of the damping are used (thesis 5.3)");
  p.add_word("randomness", {"fast", "off", "slow", "all"},
             "collisions left to chance (thesis 4.2)");
  p.add_number("random_speed", standard.noise.speed, 0.0, 1e6, "-",
               "threshold of fast collisions, as a share of sqrt(g L)");
  p.add_number("random_normal", standard.noise.normal, 0.0, 1.0, "rad",
               "standard deviation of the angle by which chance turns a normal");
  p.add_number("random_restitution", standard.noise.restitution, 0.0, 1.0, "-",
               "half the range by which chance changes restitution");
  p.add_number("eps_scale", 1.0, 0.0, 1e3, "-", "all thresholds of the damping times this");
  p.add_number("k_scale", 1.0, 0.0, 1e3, "-", "all factors of the damping to this power");
  p.add_whole("collision_passes", standard.collision_passes, 0, 1000, "passes over collisions");
  p.add_whole("contact_passes", standard.contact_passes, 0, 1000, "passes over contacts");
  p.add_flag("sleeping", standard.sleeping, "bodies at rest are left alone (thesis 4.5)");
  add_freeze(p);
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn");
  p.add_word("reading", {"as_meant", "as_printed"},
             "the listings of appendix A.2 with their misprints mended, or as they are printed");
  p.add_text("repaired", "none",
             "reading=as_printed: errata that are mended all the same, as C1,DM3; or all, or none");
  return p;
}

namespace {

// The listings as printed have no other options than these; what they cannot do is refused.
std::unique_ptr<Technique> make_damped_as_printed(const Parameters& p) {
  const auto only = [&](const char* key, std::initializer_list<std::string_view> possible) {
    const std::string& word = p.word(key);
    require::that(std::find(possible.begin(), possible.end(), word) != possible.end(),
                  std::string(key) + " = " + word + ": reading=as_printed has only " +
                      std::string(*possible.begin()));
  };
  only("points", {"one"});
  only("shock", {"position"});
  only("damping", {"all"});
  only("randomness",
       {"off", "fast"});  // fast is the default of as_meant; the listings have no chance
  only("stable_boxes", {"corners", "off"});
  require::that(!p.flag("sleeping"), "sleeping = on: reading=as_printed has no sleeping");
  require::that(!p.flag("freeze"), "freeze = on: reading=as_printed has no sleeping");
  DampedAsPrintedOptions options;
  options.repaired = DampedErrata(p.text("repaired"));
  options.numbers.eps_scale = p.number("eps_scale");
  options.numbers.k_scale = p.number("k_scale");
  options.collision_passes = p.count("collision_passes");
  options.contact_passes = p.count("contact_passes");
  options.stable_boxes = p.word("stable_boxes") != "off";
  options.normals = normal_rule_from(p.word("normals"));
  options.rotation = rotation_rule_from(p.word("rotation"));
  return std::make_unique<DampedAsPrinted>(options);
}

}  // namespace

std::unique_ptr<Technique> make_damped(const Parameters& p, std::uint64_t seed) {
  if (p.word("reading") == "as_printed") return make_damped_as_printed(p);
  require::that(p.text("repaired") == "none",
                "repaired = " + p.text("repaired") + ": expected none unless reading=as_printed");
  DampedOptions options;
  options.normals = normal_rule_from(p.word("normals"));
  options.points = point_rule_from(p.word("points"));
  options.shock = p.word("shock") == "position" ? ShockRule::position : ShockRule::velocity;
  options.stable_boxes = stable_rule_from(p.word("stable_boxes"));
  options.damping = damping_parts_from(p.word("damping"));
  options.noise = {randomness_from(p.word("randomness")), p.number("random_speed"),
                   p.number("random_normal"), p.number("random_restitution")};
  options.numbers.eps_scale = p.number("eps_scale");
  options.numbers.k_scale = p.number("k_scale");
  options.collision_passes = p.count("collision_passes");
  options.contact_passes = p.count("contact_passes");
  options.sleeping = p.flag("sleeping");
  options.rotation = rotation_rule_from(p.word("rotation"));
  options.seed = seed;
  return frozen_if_asked(p, std::make_unique<Damped>(options));
}

Parameters contact_damped_options() {
  const ContactDampedOptions standard;
  Parameters p;
  p.add_whole("passes", standard.passes, 1, 1000, "sweeps down and up over the areas of a heap");
  p.add_whole("rounds", standard.rounds, 0, 10000,
              "of the direct solver, for heaps that sweeps do not settle; 0: none");
  p.add_whole("repair_passes", standard.repair_passes, 1, 1000, "sweeps that end overlap");
  p.add_flag("sleeping", standard.sleeping, "heaps at rest are left alone (thesis 4.5)");
  add_freeze(p);
  p.add_word("rotation", {"splitting", "frozen", "midpoint", "rk4"}, "how bodies turn");
  add_pose(p);
  return p;
}

std::unique_ptr<Technique> make_contact_damped(const Parameters& p, std::uint64_t) {
  ContactDampedOptions options;
  options.passes = p.count("passes");
  options.rounds = p.count("rounds");
  options.repair_passes = p.count("repair_passes");
  options.sleeping = p.flag("sleeping");
  options.rotation = rotation_rule_from(p.word("rotation"));
  options.pose = pose_update_from(p.word("pose"));
  return frozen_if_asked(p, std::make_unique<ContactDamped>(options));
}

}  // namespace tumble
