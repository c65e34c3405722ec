/// \file
/// \brief The command `tumble`.
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/base/version.hpp"

#include "request.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace {

using tumble::app::Request;

// The first word is a sub-command; the message about an unknown one lists these.
constexpr std::array<std::string_view, 8> kCommands = {
    "run", "compare", "render", "lcp", "scenes", "stability", "techniques", "filters"};

// A word that is no number is refused with the expected form.
CLI::Validator number() {
  return CLI::Validator(
      [](std::string& text) {
        return tumble::parse_number(text) ? std::string() : text + ": expected a finite number";
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

// An option that takes items separated by commas, none of them empty.
// \param take  called with each item, from first to last
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

// The same for numbers, which replace those that were there.
void add_numbers(CLI::App& command, const std::string& option, const std::string& help,
                 std::vector<double>& numbers) {
  auto given = std::make_shared<std::vector<double>>();
  add_list(command, option, help, [option, given, &numbers](const std::string& item) {
    const std::optional<double> value = tumble::parse_number(item);
    if (!value) throw CLI::ValidationError(option, item + ": expected a finite number");
    given->push_back(*value);
    numbers = *given;
  });
}

// The options of `run` alone.
void add_recording_options(CLI::App& run, Request& request) {
  run.add_option("--technique", request.technique, "technique (list: tumble techniques)");
  run.add_option("--halvings", request.halvings,
                 "halve a step up to N times if bodies are fast, overlap or chatter")
      ->check(whole(std::numeric_limits<int>::max()))
      ->capture_default_str();
  run.add_option("--every", request.run.every,
                 "steps from one recorded frame, and one row of a table, to the next")
      ->check(whole(std::numeric_limits<int>::max()))
      ->capture_default_str();
  run.add_flag("--contacts", request.contacts, "write contacts.csv as well");
  run.add_option("--filter", request.filter,
                 "write trajectory_filtered.csv as well, through a filter, for example box:5 "
                 "(list: tumble filters)");
}

// The options that `run` and `compare` share.
void add_run_options(CLI::App& command, Request& request) {
  command.add_option("scene", request.scene, "built-in scene (list: tumble scenes) or .toml file")
      ->required();
  command.add_option("--dt", request.run.dt, "time step [s]")
      ->check(number())
      ->capture_default_str();
  command.add_option("--duration", request.run.duration, "simulated time [s]")
      ->check(number())
      ->capture_default_str();
  command.add_option("--seed", request.run.seed, "random seed")
      ->check(whole(std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command
      .add_option("--set", request.settings,
                  "change a setting: key=value, scene.key=value or technique.key=value; repeatable")
      ->allow_extra_args(false);
  command.add_option("--out", request.out, "output folder");
  command.add_flag("--quiet", request.quiet, "no progress line and no summary");
}

void add_render_options(CLI::App& command, tumble::app::RenderRequest& request) {
  command.add_option("folder", request.folder, "folder of a recorded run")->required();
  command
      .add_option(
          "--as", request.form,
          "format: svg or png for a picture, gif or mp4 for a film, gltf for an animated scene")
      ->required();
  command.add_option("--at", request.at, "picture: time of the frame [s]; default: the last one")
      ->expected(1)
      ->check(number());
  add_numbers(command, "--strip", "picture: times of several frames, separated by commas [s]",
              request.strip);
  command.add_flag("--filtered", request.filtered, "draw the filtered trajectory of the run");
  add_numbers(command, "--view", "direction from the boxes to the camera, X,Y,Z", request.view);
  command.add_option("--from", request.from, "film, gltf: start time [s]")->check(number());
  command.add_option("--to", request.to, "film, gltf: end time [s]")->check(number());
  command
      .add_option("--fps", request.rate,
                  "film, gltf: frames per second; default: 25, for gltf those of the run")
      ->check(number());
  command
      .add_option("--speed", request.speed,
                  "film, gltf: speed; default: 1; 0.25 is four times slower than the run")
      ->check(number());
  command
      .add_option("--width", request.width,
                  "film: width in pixels; default: 480 for gif, 960 for mp4")
      ->check(whole(std::numeric_limits<int>::max()));
}

// One line about a command line that cannot be read.
void print_mistake(const CLI::ParseError& error, int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  const bool known = std::find(kCommands.begin(), kCommands.end(), first) != kCommands.end();
  std::string message(error.what());
  if (argc < 2) message = "no command: " + tumble::expected_names("", kCommands);
  if (argc > 1 && !known && first[0] != '-')
    message =
        "unknown command " + std::string(first) + ": " + tumble::expected_names(first, kCommands);
  std::replace(message.begin(), message.end(), '\n', ' ');
  const std::string help = known ? "tumble " + std::string(first) + " --help" : "tumble --help";
  std::fprintf(stderr, "tumble: %s (more: %s)\n", message.c_str(), help.c_str());
}

// The output may not have arrived: the disk behind > can be full.
int printed(int code) {
  const bool good = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (good || code != tumble::app::kDone) return code;
  std::fprintf(stderr, "tumble: cannot write to the standard output\n");
  return tumble::app::kCannotWrite;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Tumble: techniques for real-time rigid body simulation (Egan 2003)", "tumble");
  app.set_version_flag("--version", tumble::build_info().text());
  app.require_subcommand(1);

  Request request;
  CLI::App* run = app.add_subcommand("run", "simulate a scene and record it");
  add_run_options(*run, request);
  add_recording_options(*run, request);

  CLI::App* compare = app.add_subcommand("compare", "simulate a scene with several techniques");
  std::vector<std::string> techniques;
  double limit = 60.0;
  add_run_options(*compare, request);
  add_list(*compare, "--techniques", "names, separated by commas; default: all",
           [&techniques](const std::string& name) { techniques.push_back(name); });
  compare->add_option("--limit", limit, "wall-clock limit of each technique [s]")
      ->check(number())
      ->capture_default_str();

  tumble::app::RenderRequest picture;
  CLI::App* render = app.add_subcommand(
      "render", "draw a recorded run as pictures, as a film or as an animated scene");
  add_render_options(*render, picture);

  tumble::app::LcpRequest problem;
  bool list_solvers = false;
  CLI::App* lcp = app.add_subcommand("lcp", "solve f >= 0, a = A f + b >= 0, f'a = 0 from files");
  lcp->add_option("--matrix", problem.matrix, "A: a Matrix Market file");
  lcp->add_option("--vector", problem.vector, "b: a Matrix Market file with one column");
  lcp->add_option("--equalities", problem.equalities,
                  "rows with a = 0 and f of any sign, from 1: 2,5-7");
  lcp->add_option("--solver", problem.solver, "solver (list: --list)")->capture_default_str();
  lcp->add_flag("--list", list_solvers, "list the solvers");

  std::string rule = "equilibrium";
  CLI::App* stability = app.add_subcommand(
      "stability", "report which boxes are stable at the start of a scene, and why");
  stability->add_option("scene", request.scene, "built-in scene or .toml file")->required();
  stability->add_option("--rule", rule, "rule: corners, hull, load_proof or equilibrium")
      ->capture_default_str();
  stability->add_option("--set", request.settings, "change a setting: key=value")
      ->allow_extra_args(false);
  stability->add_option("--seed", request.run.seed, "random seed")
      ->check(whole(std::numeric_limits<std::uint64_t>::max()));

  std::string name;
  bool as_toml = false;
  CLI::App* scenes = app.add_subcommand("scenes", "list the built-in scenes, or describe one");
  scenes->add_option("name", name, "scene to describe");
  scenes->add_flag("--toml", as_toml, "print it as a scene file");
  scenes->add_option("--set", request.settings, "change a setting: key=value")
      ->allow_extra_args(false);
  scenes->add_option("--seed", request.run.seed, "random seed")
      ->check(whole(std::numeric_limits<std::uint64_t>::max()));
  CLI::App* list = app.add_subcommand("techniques", "list the techniques, or describe one");
  list->add_option("name", name, "technique to describe");
  CLI::App* filters = app.add_subcommand("filters", "list the filters for recorded runs");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);  // prints the help
    return printed(tumble::app::kDone);
  } catch (const CLI::ParseError& error) {
    print_mistake(error, argc, argv);
    return tumble::app::kBadInput;
  }
  try {
    if (run->parsed() || compare->parsed() || render->parsed()) tumble::app::catch_stop_signals();
    if (run->parsed()) return printed(tumble::app::run(request));
    if (compare->parsed()) return printed(tumble::app::compare(request, techniques, limit));
    if (lcp->parsed() && list_solvers) return printed(tumble::app::list_lcp_solvers());
    if (lcp->parsed()) return printed(tumble::app::solve_lcp(problem));
    if (render->parsed()) return printed(tumble::app::render(picture));
    if (stability->parsed()) return printed(tumble::app::stability(request, rule));
    if (filters->parsed()) return printed(tumble::app::list_filters());
    if (scenes->parsed())
      return printed(tumble::app::list_scenes(name, as_toml, request.settings, request.run.seed));
    return printed(tumble::app::list_techniques(name));
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return tumble::app::kBadInput;
  } catch (const tumble::CannotWrite& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return tumble::app::kCannotWrite;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tumble: a mistake in the program, please report it: %s\n", error.what());
    return tumble::app::kOurMistake;
  }
}
