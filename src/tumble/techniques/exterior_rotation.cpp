/// \file
/// \brief The technique of the chapter exterior_rotation as a user sets it.
#include "tumble/exterior_rotation/glued.hpp"
#include "tumble/exterior_rotation/tolerances.hpp"
#include "tumble/techniques/options.hpp"

namespace tumble {

Parameters glued_options() {
  const GluedOptions standard;
  Parameters p;
  std::vector<std::string> schemes;
  for (const GluedScheme scheme : glued_schemes()) schemes.emplace_back(name_of(scheme));
  p.add_word("scheme", schemes, "how the motion is integrated (thesis 6.2)");
  p.add_word("pose", {"separate", "exponential"},
             "schemes that find forces once: centre and orientation apart, or by one twist");
  p.add_word("joints", {"bilateral", "unilateral"},
             "glue, or very high friction that holds what is pressed together");
  p.add_word("events", {"located", "step_end"},
             "joints=unilateral: when it is noticed that a joint opens or closes");
  p.add_number("accuracy", standard.accuracy, tolerance::least_rotation_accuracy, 1.0, "-",
               "scheme=dormand_prince: error allowed in a step, in edges and radians");
  return p;
}

std::unique_ptr<Technique> make_glued(const Parameters& p, std::uint64_t) {
  GluedOptions options;
  options.scheme = glued_scheme_from(p.word("scheme"));
  options.pose = pose_update_from(p.word("pose"));
  options.joints =
      p.word("joints") == "bilateral" ? GluedJoints::bilateral : GluedJoints::unilateral;
  options.events = p.word("events") == "located" ? GluedEvents::located : GluedEvents::step_end;
  options.accuracy = p.number("accuracy");
  return std::make_unique<Glued>(options);
}

}  // namespace tumble
