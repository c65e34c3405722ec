/// \file
/// \brief The command `tumble`.
#include "tumble/base/suggestion.hpp"
#include "tumble/base/version.hpp"

#include "options.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>

namespace {

using namespace tumble::app;

// Words of a command line that its sub-command does not take: an option is mistyped, or there are too many.
std::string unexpected(const CLI::App& command) {
  const std::vector<std::string> words = command.remaining();
  const auto is_option = [](const std::string& word) { return word.substr(0, 2) == "--"; };
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  if (option == words.end())
    return "unexpected " + tumble::one_line(words.empty() ? "" : words.front()) +
           ": expected an option, or nothing more";
  std::vector<std::string> names;
  for (const CLI::Option* known : command.get_options())
    for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
  const std::string word = option->substr(0, option->find('='));
  return "unknown option " + tumble::one_line(word) + ": " +
         tumble::expected_names(word, std::vector<std::string_view>(names.begin(), names.end()));
}

// One line about a command line that cannot be read. Its first word is a sub-command.
void print_mistake(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const std::vector<std::string_view> commands(names.begin(), names.end());
  const std::string_view first = argc > 1 ? argv[1] : "";
  const bool known = std::find(commands.begin(), commands.end(), first) != commands.end();
  std::string message(error.what());
  if (argc < 2) message = "no command: " + tumble::expected_names("", commands);
  if (argc > 1 && !known && first[0] != '-')
    message =
        "unknown command " + std::string(first) + ": " + tumble::expected_names(first, commands);
  if (known && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    message = unexpected(*app.get_subcommand(std::string(first)));
  std::replace(message.begin(), message.end(), '\n', ' ');
  const std::string help = known ? "tumble " + std::string(first) + " --help" : "tumble --help";
  std::fprintf(stderr, "tumble: %s (more: %s)\n", message.c_str(), help.c_str());
}

// What changes a scene that is not run.
void add_scene_settings(CLI::App& command, Request& request) {
  command.add_option("--set", request.settings, "change a setting: key=value")
      ->allow_extra_args(false);
  command.add_option("--seed", request.run.seed, "random seed")
      ->check(whole(std::numeric_limits<std::uint64_t>::max()));
}

// The output may not have arrived: the disk behind > can be full.
int printed(int code) {
  const bool good = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (good || code != kDone) return code;
  std::fprintf(stderr, "tumble: cannot write to the standard output\n");
  return kCannotWrite;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Tumble: techniques for real-time rigid body simulation (Egan 2003)", "tumble");
  app.set_version_flag("--version", tumble::build_info().text());
  app.require_subcommand(1);
  app.footer(kHelp);

  Request request;
  CLI::App* run = app.add_subcommand("run", "simulate a scene and record it");
  add_run_options(*run, request);
  add_recording_options(*run, request);
  run->footer(kSceneHelp);

  CLI::App* view = app.add_subcommand(
      "view", "simulate a scene, or take a recorded run, and show it in the browser");
  bool page_only = false;
  add_run_options(*view, request);
  view->get_option("scene")->description(
      "scene, .toml file, or folder of tumble run or tumble sample");
  add_recording_options(*view, request);
  view->add_flag("--no-browser", page_only, "only write the page, do not open it");
  add_motion_option(*view, request.motion);
  view->footer(kSceneHelp);

  CLI::App* compare = app.add_subcommand("compare", "simulate a scene with several techniques");
  std::vector<std::string> techniques;
  double limit = 60.0;
  add_run_options(*compare, request);
  add_list(*compare, "--techniques", "names, separated by commas; default: all",
           [&techniques](const std::string& name) { techniques.push_back(name); });
  compare->add_option("--limit", limit, "wall-clock limit of each technique [s]")
      ->check(number())
      ->capture_default_str();

  SampleRequest sampling;
  CLI::App* sample = app.add_subcommand(
      "sample", "find motions of a scene that meet its wishes, with noise in its impacts");
  add_run_options(*sample, request);
  add_sample_options(*sample, request, sampling);
  sample->footer(kSampleHelp);

  std::string first;
  std::string second;
  CLI::App* diff = app.add_subcommand(
      "diff", "report the first frame and body in which two recorded runs differ");
  diff->add_option("first", first, "folder of a recorded run")->required();
  diff->add_option("second", second, "folder of another recorded run")->required();

  RenderRequest picture;
  CLI::App* render = app.add_subcommand(
      "render", "draw a recorded run as pictures, as a film or as an animated scene");
  add_render_options(*render, picture);
  render->footer(kRenderHelp);

  LcpRequest problem;
  bool list_solvers = false;
  CLI::App* lcp = app.add_subcommand("lcp", "solve f >= 0, a = A f + b >= 0, f'a = 0 from files");
  lcp->add_option("--matrix", problem.matrix, "A: a Matrix Market file");
  lcp->add_option("--vector", problem.vector, "b: a Matrix Market file with one column");
  lcp->add_option("--equalities", problem.equalities,
                  "rows with a = 0 and f of any sign, from 1: 2,5-7")
      ->check(not_empty());
  lcp->add_option("--solver", problem.solver, "solver (list: --list)")
      ->check(not_empty())
      ->capture_default_str();
  lcp->add_flag("--list", list_solvers, "list the solvers");

  std::string rule = "equilibrium";
  CLI::App* stability = app.add_subcommand(
      "stability", "report which boxes are stable at the start of a scene, and why");
  stability->add_option("scene", request.scene, "built-in scene or .toml file")->required();
  stability->add_option("--rule", rule, "rule: corners, hull, load_proof or equilibrium")
      ->capture_default_str();
  add_scene_settings(*stability, request);

  std::string name;
  bool as_toml = false;
  CLI::App* scenes = app.add_subcommand("scenes", "list the built-in scenes, or describe one");
  scenes->add_option("name", name, "scene to describe");
  scenes->add_flag("--toml", as_toml, "print it as a scene file");
  add_scene_settings(*scenes, request);
  CLI::App* list = app.add_subcommand("techniques", "list the techniques, or describe one");
  list->add_option("name", name, "technique to describe");
  CLI::App* filters = app.add_subcommand("filters", "list the filters for recorded runs");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);  // prints the help
    return printed(kDone);
  } catch (const CLI::ParseError& error) {
    print_mistake(app, error, argc, argv);
    return kBadInput;
  }
  try {
    if (run->parsed() || view->parsed() || compare->parsed() || sample->parsed() ||
        render->parsed())
      catch_stop_signals();
    if (run->parsed()) return printed(run_command(request));
    if (view->parsed()) return printed(view_command(request, !page_only));
    if (diff->parsed()) return printed(diff_command(first, second));
    if (compare->parsed()) return printed(compare_command(request, techniques, limit));
    if (sample->parsed()) return printed(sample_command(request, sampling));
    if (lcp->parsed() && list_solvers) return printed(list_lcp_solvers());
    if (lcp->parsed()) return printed(solve_lcp(problem));
    if (render->parsed()) return printed(render_command(picture));
    if (stability->parsed()) return printed(stability_command(request, rule));
    if (filters->parsed()) return printed(list_filters());
    if (scenes->parsed())
      return printed(list_scenes(name, as_toml, request.settings, request.run.seed));
    return printed(list_techniques(name));
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kBadInput;
  } catch (const tumble::CannotWrite& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kCannotWrite;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tumble: a mistake in the program, please report it: %s\n", error.what());
    return kDefect;
  }
}
