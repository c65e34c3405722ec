/// \file
/// \brief Time and quality of whole scenes: our techniques beside the engines that are installed.
///
/// All engines start from the same world and take turns of half a second of a scene each, in one
/// process, so that whatever else the machine does meets all of them. Each is measured by the same
/// routine on its poses. Ratios are to the medians of Bullet's defaults in the same run.
///
/// Run `scenes [--scene NAME] [--engine NAME] [--seconds S] [--budget S] [--csv FILE]`; scenes and
/// engines may be named more than once. An engine is `bullet`, `bullet_dt4`, ... or a technique
/// with its settings: `impulse,shock=off`. Peers are those found at build time: ODE
/// (`TUMBLE_HAVE_ODE`) and Bullet (`TUMBLE_HAVE_BULLET`).
#include "tumble/techniques.hpp"

#include "scene_engines.hpp"
#include "scene_list.hpp"
#include "scene_run.hpp"
#include "scene_table.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace scene_bench;

constexpr int kTurn = 30;         // steps that an engine makes before it is the next one's turn
constexpr double kBudget = 20.0;  // [s] of step time for each run
constexpr double kLongest = 1e6;  // [s] largest duration and budget that are taken

// What the command line asks for.
struct Request {
  std::vector<std::string> scenes;   // empty: all
  std::vector<std::string> engines;  // empty: the standard ones
  double seconds = 0.0;              // [s] 0: as each scene has it
  double budget = kBudget;           // [s]
  std::string csv;                   // empty: none
};

double read_seconds(const std::string& option, const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(value > 0.0 && value <= kLongest))
    throw std::invalid_argument(option + " " + text + ": expected a number above 0, in seconds");
  return value;
}

Request read_request(int argc, char** argv) {
  Request out;
  for (int k = 1; k < argc; k += 2) {
    const std::string option = argv[k];
    if (k + 1 == argc) throw std::invalid_argument(option + ": expected a value after it");
    const std::string value = argv[k + 1];
    if (option == "--scene")
      out.scenes.push_back(value);
    else if (option == "--engine")
      out.engines.push_back(value);
    else if (option == "--seconds")
      out.seconds = read_seconds(option, value);
    else if (option == "--budget")
      out.budget = read_seconds(option, value);
    else if (option == "--csv")
      out.csv = value;
    else
      throw std::invalid_argument(option +
                                  ": expected --scene, --engine, --seconds, --budget or --csv");
  }
  return out;
}

// The scenes asked for, in their own order.
std::vector<SceneChoice> chosen_scenes(const Request& request) {
  std::vector<SceneChoice> all = all_scenes();
  std::string names;
  for (const SceneChoice& scene : all) names.append(" ").append(scene.name);
  for (const std::string& name : request.scenes) {
    if (std::ranges::none_of(all, [&name](const SceneChoice& scene) { return scene.name == name; }))
      throw std::invalid_argument("--scene " + name + ": expected one of" + names);
  }
  std::vector<SceneChoice> out;
  for (SceneChoice& scene : all) {
    const auto& asked = request.scenes;
    if (!asked.empty() && std::ranges::find(asked, scene.name) == asked.end()) continue;
    if (request.seconds > 0.0) scene.seconds = request.seconds;
    out.push_back(scene);
  }
  return out;
}

// A peer's name, or a technique's with its settings.
EngineChoice choice_of(const std::string& text, const std::vector<EngineChoice>& peers) {
  std::string names;
  for (const EngineChoice& peer : peers) {
    if (peer.name == text) return peer;
    names.append(" ").append(peer.name);
  }
  const std::string technique = text.substr(0, text.find(','));
  bool known = false;
  for (const tumble::TechniqueRecipe& recipe : tumble::technique_library()) {
    known = known || recipe.name == technique;
    names.append(" ").append(recipe.name);
  }
  if (!known) throw std::invalid_argument("--engine " + text + ": expected one of" + names);
  return technique_choice(text);
}

// The engines asked for, in this order; or the standard ones, ours first.
std::vector<EngineChoice> chosen_engines(const Request& request) {
  const std::vector<EngineChoice> peers = peer_choices();
  std::vector<EngineChoice> out;
  if (request.engines.empty()) {
    out = standard_techniques();
    for (const EngineChoice& peer : peers)
      if (peer.standard) out.push_back(peer);
    return out;
  }
  for (const std::string& text : request.engines) out.push_back(choice_of(text, peers));
  return out;
}

std::vector<Outcome> run_scene(const SceneChoice& scene, const std::vector<EngineChoice>& engines,
                               double budget) {
  const auto boxes = static_cast<int>(scene.scene.boxes.size());
  std::vector<std::unique_ptr<Run>> runs;
  for (const EngineChoice& engine : engines) {
    if (engine.most_boxes > 0 && boxes > engine.most_boxes) continue;
    auto run = std::make_unique<Run>(engine, scene, budget);
    if (run->possible()) runs.push_back(std::move(run));
  }
  for (bool more = true; more;) {
    more = false;
    for (const auto& run : runs) more = run->advance(kTurn) || more;
  }
  std::vector<Outcome> out;
  for (const auto& run : runs) out.push_back(run->outcome());
  return out;
}

// A file that closes itself.
struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

File open_csv(const std::string& name) {
  if (name.empty()) return {};
  File file(std::fopen(name.c_str(), "w"));
  if (file == nullptr) throw std::invalid_argument("--csv " + name + ": cannot be written");
  write_csv_head(file.get());
  return file;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Request request = read_request(argc, argv);
    const std::vector<SceneChoice> scenes = chosen_scenes(request);
    const std::vector<EngineChoice> engines = chosen_engines(request);
    const File csv = open_csv(request.csv);
    std::string reference;
    for (const EngineChoice& engine : engines)
      if (engine.reference) reference = engine.name;

    std::printf("Whole scenes, steps of 1/60 s, one thread.\n%s.\n%s", peer_versions().c_str(),
                legend().c_str());
    for (const SceneChoice& scene : scenes) {
      const std::vector<Outcome> runs = run_scene(scene, engines, request.budget);
      print_table(scene, runs, reference);
      if (csv != nullptr) write_csv(csv.get(), scene, runs);
    }
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "scenes: %s\n", std::string(tumble::message_of(error)).c_str());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scenes: %s\n", error.what());
    return 2;
  }
  return 0;
}
