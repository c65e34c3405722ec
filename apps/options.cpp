/// \file
/// \brief The options of the sub-commands.
#include "options.hpp"

#include "tumble/base/number_text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace tumble::app {

CLI::Validator number() {
  return CLI::Validator(
      [](std::string& text) {
        return parse_number(text) ? std::string() : text + ": expected a finite number";
      },
      "");
}

CLI::Validator whole(std::uint64_t most) {
  return CLI::Validator(
      [most](std::string& text) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good = error == std::errc() && end == text.data() + text.size() && value <= most;
        return good ? std::string()
                    : text + ": expected a whole number from 0 to " + std::to_string(most);
      },
      "");
}

CLI::Validator not_empty() {
  return CLI::Validator(
      [](std::string& text) {
        return text.empty() ? std::string("\"\": expected a word") : std::string();
      },
      "");
}

void add_list(CLI::App& command, const std::string& option, const std::string& help,
              const std::function<void(const std::string&)>& take) {
  const auto take_all = [option, take](const std::string& list) {
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t comma = std::min(list.find(',', at), list.size());
      if (comma == at)
        throw CLI::ValidationError(option, '"' + list + "\": expected words between the commas");
      take(list.substr(at, comma - at));
      at = comma + 1;
    }
  };
  command.add_option_function<std::string>(option, take_all, help);
}

namespace {

// A whole number that has a default.
void add_count(CLI::App& command, const char* option, int& value, const std::string& help) {
  command.add_option(option, value, help)
      ->check(whole(std::numeric_limits<int>::max()))
      ->capture_default_str();
}

// Any number that has a default.
void add_number(CLI::App& command, const char* option, double& value, const std::string& help) {
  command.add_option(option, value, help)->check(number())->capture_default_str();
}

// A list of numbers, which replace those that were there.
void add_numbers(CLI::App& command, const std::string& option, const std::string& help,
                 std::vector<double>& numbers) {
  auto given = std::make_shared<std::vector<double>>();
  add_list(command, option, help, [option, given, &numbers](const std::string& item) {
    const std::optional<double> value = parse_number(item);
    if (!value) throw CLI::ValidationError(option, item + ": expected a finite number");
    given->push_back(*value);
    numbers = *given;
  });
}

}  // namespace

void add_recording_options(CLI::App& run, Request& request) {
  run.add_option("--technique", request.technique, "technique (list: tumble techniques)")
      ->check(not_empty());
  add_count(run, "--halvings", request.halvings,
            "halve a step up to N times if bodies are fast, overlap or chatter");
  add_count(run, "--every", request.run.every,
            "record every Nth step, in the trajectory and in the tables");
  run.add_flag("--contacts", request.contacts, "also write contacts.csv");
  run.add_option("--filter", request.filter,
                 "also write trajectory_filtered.csv, with a filter, for example box:5 "
                 "(list: tumble filters)");
}

void add_motion_option(CLI::App& command, std::optional<int>& motion) {
  command.add_option("--motion", motion, "which motion in a folder of tumble sample; default: 1")
      ->check(whole(std::numeric_limits<int>::max()));
}

void add_run_options(CLI::App& command, Request& request) {
  command.add_option("scene", request.scene, "built-in scene (list: tumble scenes) or .toml file")
      ->required();
  add_number(command, "--dt", request.run.dt, "time step [s]");
  add_number(command, "--duration", request.run.duration, "simulated time [s]");
  command.add_option("--seed", request.run.seed, "random seed")
      ->check(whole(std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command
      .add_option("--set", request.settings,
                  "change a setting: key=value, scene.key=value or technique.key=value; repeatable")
      ->allow_extra_args(false);
  command.add_option("--out", request.out, "output folder; default: a new one in runs/")
      ->check(not_empty());
  command.add_flag("--force", request.force, "replace an earlier run in the folder");
  command.add_flag("--quiet", request.quiet, "no progress line and no summary");
}

void add_sample_options(CLI::App& command, Request& request, SampleRequest& sample) {
  command.add_option("--technique", request.technique, "technique (list: tumble techniques)")
      ->check(not_empty());
  add_count(command, "--samples", sample.samples, "number of motions to find that meet all wishes");
  add_count(command, "--chains", sample.chains,
            "number of Markov chains that share the search; 0: four, or fewer for fewer motions");
  add_count(command, "--cores", sample.cores,
            "cores to use; 0: all. The result does not depend on it");
  add_count(command, "--proposals", sample.proposals,
            "largest number of motions that a chain tries");
  add_number(command, "--strictness", sample.strictness,
             "s in exp(-s V), where V is the violation of all wishes");
  add_number(command, "--noise-speed", sample.noise.speed,
             "slowest impact with noise, as a fraction of sqrt(g L), L the shortest edge");
  add_number(command, "--noise-normal", sample.noise.normal,
             "standard deviation of the rotation of an impulse [rad]");
  add_number(command, "--noise-restitution", sample.noise.restitution,
             "half the range of restitution");
  command.add_flag("--resume", sample.resume, "continue the chains in the folder");
}

void add_render_options(CLI::App& command, RenderRequest& request) {
  command.add_option("folder", request.folder, "folder of a recorded run")->required();
  command
      .add_option(
          "--as", request.form,
          "format: svg or png for a picture, gif or mp4 for a film, gltf for an animated scene, "
          "html for a page with a 3D view")
      ->required();
  command.add_option("--at", request.at, "picture: time of the frame [s]; default: the last one")
      ->expected(1)
      ->check(number());
  add_numbers(command, "--strip", "picture: times of several frames, separated by commas [s]",
              request.strip);
  command.add_flag("--filtered", request.filtered, "draw the filtered trajectory of the run");
  add_motion_option(command, request.motion);
  add_numbers(command, "--view", "direction from the boxes to the camera, X,Y,Z", request.view);
  command.add_option("--from", request.from, "film, gltf, html: start time [s]")->check(number());
  command.add_option("--to", request.to, "film, gltf, html: end time [s]")->check(number());
  command
      .add_option(
          "--fps", request.rate,
          "film, gltf, html: frames per second; default: 25, for gltf and html those of the run")
      ->check(number());
  command
      .add_option("--speed", request.speed,
                  "film, gltf, html: speed; default: 1; 0.25 is four times slower than the run")
      ->check(number());
  command
      .add_option("--width", request.width,
                  "film: width in pixels; default: 480 for gif, 960 for mp4")
      ->check(whole(std::numeric_limits<int>::max()));
}

}  // namespace tumble::app
