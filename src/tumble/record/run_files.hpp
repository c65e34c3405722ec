/// \file
/// \brief The folder of a run: every file that `tumble run` leaves behind.
#pragma once

#include "tumble/record/output_folder.hpp"
#include "tumble/record/run.hpp"
#include "tumble/record/table_file.hpp"
#include "tumble/record/trajectory_file.hpp"

#include <optional>

namespace tumble {

/// The settings of a run, for summary.json.
struct RunDescription {
  std::string scene;                 ///< the name or file that the user gave
  std::string technique;             ///< its name
  Parameters scene_settings;         ///< of a built-in scene
  Parameters technique_settings;     ///< options of the technique
  RunSettings run;                   ///< step, duration, seed
  bool contacts = false;             ///< whether contacts.csv is wanted
  std::string filter;                ///< as filter_of() takes it; empty: no filtered trajectory
  int halvings = 0;                  ///< how often a step may be halved, see AdaptiveStep; 0: never
  std::vector<std::string> ignored;  ///< parts that the technique leaves out, for example friction
};

/// Writes trajectory.csv, metrics.csv, events.csv, contacts.csv, scene.toml and summary.json; with a
/// filter also trajectory_filtered.csv.
///
/// All of them are the same bytes for the same run. Times of the clock are not the library's
/// business: the command writes them into timing.csv beside these. An earlier run in the folder is replaced after
/// the first step, or at the end of a run without steps: one that is refused before leaves it as it was.
/// summary.json is written last: a folder without it is of a run that could not be finished.
class RunFiles : public RunObserver {
 public:
  /// Makes the folder and opens the files.
  /// \param folder       where; made if missing. One that is not empty must be a run's
  /// \param description  how the run is made
  /// \param scene        as resolved, for scene.toml
  /// \throws std::invalid_argument if the folder holds other things than a run, if another process writes into it,
  ///         or for a filter that there is not
  /// \throws CannotWrite if it cannot be made or written
  RunFiles(const std::filesystem::path& folder, RunDescription description, const Scene& scene);

  void on_begin(const World& world) override;
  void on_step(const World& world, const Technique& technique, const StepReport& report,
               const Metrics& metrics) override;
  void on_event(const World& world, const Event& event) override;

  /// Writes summary.json and what the tables still hold.
  /// \param result what the run came to
  /// \throws CannotWrite if something cannot be written
  void finish(const RunResult& result);

  /// Writes a file about the step that ended a run: a matrix whose numbers keep their bits, so that `tumble lcp` solves
  /// the very same problem.
  /// \param diagnostic  one of Technique::diagnostics(), called unsolved_A.mtx or unsolved_b.mtx
  /// \throws CannotWrite if something cannot be written
  /// \throws std::invalid_argument if a number in it is not finite
  void write_diagnostic(const Diagnostic& diagnostic);

  /// Why trajectory_filtered.csv ends before the run does.
  /// \return what the filter said of the frame that it refused; empty if it refused none
  [[nodiscard]] std::string filter_refusal() const;

  /// Where to write now what goes beside these files.
  /// \return see OutputFolder::path()
  [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }

 private:
  void write_frame(const World& world);

  OutputFolder folder_;
  RunDescription description_;
  TrajectoryFile trajectory_;
  TableFile metrics_;
  TableFile events_;
  std::optional<TableFile> contacts_;
  std::optional<FilteredTrajectoryFile> filtered_;
  std::int64_t step_ = 0;
};

}  // namespace tumble
