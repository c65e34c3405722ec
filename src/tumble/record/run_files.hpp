/// \file
/// \brief The files that `tumble run` writes.
#pragma once

#include "tumble/record/output_folder.hpp"
#include "tumble/record/run.hpp"
#include "tumble/record/table_file.hpp"
#include "tumble/record/trajectory_file.hpp"

#include <optional>

namespace tumble {

/// The settings of a run, for summary.json.
struct RunDescription {
  std::string scene;              ///< the name or file that the user gave
  std::string technique;          ///< its name
  Parameters scene_settings;      ///< of a built-in scene
  Parameters technique_settings;  ///< options of the technique
  RunSettings run;                ///< step, duration, seed
  bool contacts = false;          ///< whether contacts.csv is written
  std::string filter;             ///< as filter_of() takes it; empty: no filtered trajectory
  int halvings = 0;               ///< how often a step may be halved, see AdaptiveStep; 0: never
  std::vector<std::string> ignored_physics;  ///< see Technique::ignores()
};

/// Writes trajectory.csv, metrics.csv, events.csv, contacts.csv, scene.toml and summary.json; with a
/// filter also trajectory_filtered.csv.
///
/// The same run gives the same bytes. Wall times are not written here, but by the command, into timing.csv. The files
/// replace those of an earlier run after the first step, or at the end of a run without steps, so that a refused run
/// leaves the folder as it was. summary.json is written last: without it the run was not finished.
class RunFiles : public RunObserver {
 public:
  /// Makes the folder and opens the files.
  /// \param folder       created if missing; if it is not empty, it has to be that of a run
  /// \param description  settings of the run
  /// \throws std::invalid_argument if the folder holds something else, if another process writes into it, or for an
  ///         unknown filter
  /// \throws CannotWrite if it cannot be made or written
  RunFiles(const std::filesystem::path& folder, RunDescription description, const Scene& scene);

  void on_begin(const World& world) override;
  void on_step(const World& world, const Technique& technique, const StepReport& report,
               const Metrics& metrics) override;
  void on_event(const World& world, const Event& event) override;

  /// Writes summary.json and the remaining rows of the tables.
  /// \throws CannotWrite if something cannot be written
  void finish(const RunResult& result);

  /// Writes a matrix of the step that ended a run, with all bits of its numbers, for `tumble lcp`.
  /// \param diagnostic  one of Technique::diagnostics(), called unsolved_A.mtx or unsolved_b.mtx
  /// \throws CannotWrite if something cannot be written
  /// \throws std::invalid_argument if a number in it is not finite
  void write_diagnostic(const Diagnostic& diagnostic);

  /// Reason why trajectory_filtered.csv ends before the run does.
  /// \return the filter's message about the frame that it refused; empty if it refused none
  [[nodiscard]] std::string filter_refusal() const;

  /// Folder for further files of the run; see OutputFolder::path().
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
