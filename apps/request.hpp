/// \file
/// \brief Requests of the command line, as typed and resolved.
#pragma once

#include "tumble/previous_work/noisy_impacts.hpp"
#include "tumble/record/run_files.hpp"
#include "tumble/scenes/scene.hpp"

#include <optional>
#include <string>
#include <vector>

/// The command `tumble`: its sub-commands.
namespace tumble::app {

/// Exit codes of every command.
enum ExitCode : int {
  kDone = 0,      ///< success
  kDefect = 1,    ///< a defect of the program
  kDiffer = 1,    ///< `tumble diff`: the runs differ; 1 as for diff(1)
  kBadInput = 2,  ///< the user's mistake; nothing was run
  kMathematical =
      3,  ///< a step met the event cap, was unsolved or not finite, broke off or, after the first, was
          ///< refused; or a check of the run failed
  kCannotWrite = 4  ///< disk full, no permission, no program to draw with
};

/// A scene, a technique and their settings, as typed by a user.
struct Request {
  std::string scene;                  ///< a built-in name or a TOML file
  std::string technique;              ///< a name; empty: the default
  std::vector<std::string> settings;  ///< key=value, scene.key=value or technique.key=value
  RunSettings run;                    ///< step, duration, seed, every
  std::string out;                    ///< folder; empty: runs/SCENE-TECHNIQUE, or a number more
  bool force = false;                 ///< whether a run in that folder is replaced
  bool contacts = false;              ///< whether contacts.csv is written
  std::optional<std::string> filter;  ///< as filter_of() takes it; none: no filtered trajectory
  int halvings = 0;                   ///< how often a step may be halved
  bool quiet = false;                 ///< no progress line and no summary
  std::optional<int> motion;          ///< `tumble view`: of a folder of `tumble sample`, from 1
};

/// A Request, looked up and checked.
struct ResolvedRequest {
  Simulation simulation;         ///< at its start
  RunDescription description;    ///< for summary.json
  std::filesystem::path folder;  ///< of the run's files
};

/// Changes settings as `--set` asks for: "scene.rows=13", "technique.impacts=sequential", or a bare
/// "rows=13" where only one of the two has it.
/// \throws std::invalid_argument for a key that neither or both have, or a value out of range
void apply(const std::vector<std::string>& settings, Parameters& scene, Parameters& technique);

/// The folder for output: the one that was typed, or a new one in runs/. A finished output in it is replaced only with
/// --force.
/// \param kind     second part of the new folder's name, for example the technique
/// \param last     the file by which a finished output is recognised
/// \return the folder, which need not exist
/// \throws std::invalid_argument if the folder that was typed holds a finished output or the scene file that is read
std::filesystem::path output_folder(const Request& request, const std::string& kind,
                                    const std::string& last);

/// Looks up scene, technique and settings, and checks them.
/// \throws std::invalid_argument for an unknown scene, technique or key, a value out of range, or
///         a bare key that both the scene and the technique have, or a folder that holds the scene
ResolvedRequest resolve(const Request& request);

/// Looks up the scene alone, for commands without a run.
/// \param request as typed: scene, settings, seed
/// \return the scene, not checked yet
/// \throws std::invalid_argument for an unknown scene or key, or a value out of range
Scene resolve_scene(const Request& request);

/// `tumble run`.
int run_command(const Request& request);

/// Runs and records as `tumble run` does.
/// \param folder   becomes the folder of the run
int run_into(const Request& request, std::filesystem::path& folder);

/// `tumble view`: a page of a recorded run, opened in the browser.
/// \param request  as typed; the scene may be the folder of a recorded run
/// \param open     whether the browser is started
int view_command(const Request& request, bool open);

/// `tumble diff`: where two recorded runs part.
/// \return kDone if all bits are equal, else kDiffer
int diff_command(const std::string& first, const std::string& second);

/// `tumble compare`.
/// \param request     as typed; its technique is not used
/// \param techniques  names; empty: all
/// \param limit       [s] of the clock that each technique may take
int compare_command(const Request& request, const std::vector<std::string>& techniques,
                    double limit);

/// A picture or a film of a recorded run, as typed.
struct RenderRequest {
  std::string folder;                          ///< of the run
  std::string form;                            ///< svg, png, gif, mp4, gltf or html
  std::vector<double> at;                      ///< [s] one time; empty: the last recorded frame
  std::vector<double> strip;                   ///< [s] times of several frames in one picture
  std::vector<double> view = {2.0, 1.0, 4.0};  ///< [-] direction from the boxes to the eye
  bool filtered = false;                       ///< as its filter showed it, not as it was computed
  std::optional<int> motion;                   ///< of a folder of `tumble sample`, from 1
  std::optional<double> from;                  ///< [s] start of a film; none: the first frame
  std::optional<double> to;                    ///< [s] end of a film; none: the last frame
  std::optional<double>
      rate;  ///< [1/s] frames in a second of a film; none: 25, for gltf as recorded
  std::optional<double> speed;  ///< [-] seconds of the run in a second of a film; none: 1
  std::optional<int> width;     ///< [px] of a film; none: 480 for gif, 960 for mp4
};

/// Whether a folder was written by `tumble sample`.
/// \return true if it has a first motion
bool is_sampling(const std::filesystem::path& folder);

/// The file of a sampled motion.
/// \param motion from 1
std::string motion_file(int motion);

/// The table that is drawn.
/// \return of the run, filtered or not, or of a sampled motion: the first one unless another was asked for
/// \throws std::invalid_argument for a filtered motion
std::string table_of(const RenderRequest& request);

/// The end of the names of its pictures and films.
/// \return for example "_filtered", or "_2" of the second motion; empty for a run as computed
std::string suffix_of(const RenderRequest& request);

/// `tumble render`.
int render_command(const RenderRequest& request);

/// `tumble stability`.
/// \param request  as typed: scene, settings, seed
/// \param rule     corners, hull, load_proof or equilibrium
int stability_command(const Request& request, const std::string& rule);

/// What `tumble sample` has beside a run, as typed.
struct SampleRequest {
  int samples = 4;           ///< motions that are wanted
  int chains = 0;            ///< Markov chains; 0: four, or as many as samples if these are fewer
  int cores = 0;             ///< threads; 0: one for each core of the machine
  int proposals = 1000;      ///< of each chain, at most
  double strictness = 10.0;  ///< [-] see NoiseChain
  ImpactNoiseOptions noise;  ///< see there
  bool resume = false;       ///< whether chains in the folder go on
};

/// `tumble sample`.
/// \param asked    its own options, as typed
int sample_command(const Request& request, const SampleRequest& asked);

/// A linear complementarity problem in files, as typed.
struct LcpRequest {
  std::string matrix;            ///< Matrix Market file of A
  std::string vector;            ///< Matrix Market file of b, one column
  std::string solver = "lemke";  ///< the default takes any matrix
  std::string equalities;        ///< rows, from 1: "2,5-7"; empty: none
};

/// `tumble lcp`.
int solve_lcp(const LcpRequest& request);

/// `tumble lcp --list`.
int list_lcp_solvers();

/// `tumble scenes`.
/// \param name      one scene to describe; empty: list all
/// \param as_toml   print it as a scene file
/// \param settings  parameters for as_toml
/// \param seed      for scenes with chance in them
int list_scenes(const std::string& name, bool as_toml, const std::vector<std::string>& settings,
                std::uint64_t seed);

/// `tumble techniques`.
/// \param name one technique to describe; empty: list all
int list_techniques(const std::string& name);

/// `tumble filters`.
int list_filters();

/// The signal that asked this process to stop.
/// \return 0 while there was none
int stop_signal();

/// Lets SIGINT and SIGTERM end a run at the next step instead of killing it (the third one kills); a limit on file
/// sizes is reported like a full disk.
void catch_stop_signals();

}  // namespace tumble::app
