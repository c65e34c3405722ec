/// \file
/// \brief Our own techniques as engines of scenes.cpp.
#include "scene_engines.hpp"

#include "tumble/record/run.hpp"
#include "tumble/techniques.hpp"

#include <algorithm>
#include <utility>

namespace scene_bench {
namespace {

using tumble::Parameters;
using tumble::StepStatus;
using tumble::World;

// Methods whose time grows with the third power of the bodies, or faster, are run on larger scenes
// only by name: a single step of the wall would not end.
constexpr int kMostBoxesOfSlowOnes = 12;

// What the random numbers of techniques with chance in them start from.
constexpr std::uint64_t kSeed = 1;

class OwnEngine : public Engine {
 public:
  explicit OwnEngine(std::unique_ptr<tumble::Technique> technique)
      : technique_(std::move(technique)) {}

  void take_in(const World& /*world*/) override {}

  void advance(World& world, double dt) override { report_ = technique_->step(world, dt); }

  bool write_back(World& world, double /*dt*/) override {
    if (report_.status == StepStatus::event_cap) ++capped_;
    const auto states = world.states();
    return std::ranges::all_of(states, [](const tumble::BodyState& s) {
      return s.position_w.allFinite() && s.orientation_wb.coeffs().allFinite();
    });
  }

  [[nodiscard]] int asleep(const World& world) const override {
    const auto rests = world.sleep_states();
    return static_cast<int>(
        std::ranges::count_if(rests, [](const tumble::SleepState& rest) { return rest.asleep; }));
  }

  [[nodiscard]] std::string note() const override {
    if (failed()) return "a step ended as " + std::string(name_of(report_.status));
    if (capped_ > 0) return "steps that reached the event cap: " + std::to_string(capped_);
    return {};
  }

  [[nodiscard]] bool failed() const override { return report_.status >= StepStatus::unsolved; }

 private:
  std::unique_ptr<tumble::Technique> technique_;
  tumble::StepReport report_;
  int capped_ = 0;
};

// "name,key=value,key=value" taken apart at the commas.
std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == ',')
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

bool in_library(std::string_view name) {
  const auto& all = tumble::technique_library();
  return std::ranges::any_of(
      all, [name](const tumble::TechniqueRecipe& recipe) { return recipe.name == name; });
}

}  // namespace

EngineChoice technique_choice(std::string_view text) {
  const std::vector<std::string> parts = parts_of(text);
  const tumble::TechniqueRecipe& recipe = tumble::technique_recipe(parts[0]);
  Parameters options = recipe.options();
  for (std::size_t k = 1; k < parts.size(); ++k) options.assign(parts[k]);
  EngineChoice choice;
  choice.name = text;
  choice.make = [&recipe, options](const World&, bool sleeping) -> std::unique_ptr<Engine> {
    Parameters now = options;
    if (now.has("sleeping"))
      now.set("sleeping", sleeping ? "on" : "off");
    else if (sleeping)
      return nullptr;
    return std::make_unique<OwnEngine>(recipe.make(now, kSeed));
  };
  return choice;
}

std::vector<EngineChoice> standard_techniques() {
  std::vector<EngineChoice> out;
  for (const char* name : {"contact_damped", "impulse", "damped"})
    if (in_library(name)) out.push_back(technique_choice(name));
  if (out.empty()) {
    for (const char* name : {"basic", "time_stepping"}) {
      if (!in_library(name)) continue;
      out.push_back(technique_choice(name));
      out.back().most_boxes = kMostBoxesOfSlowOnes;
    }
  }
  for (EngineChoice& choice : out) choice.standard = true;
  return out;
}

}  // namespace scene_bench
