/// \file
/// \brief The progress line of a run, and the times of its steps.
#pragma once

#include "tumble/record/run.hpp"
#include "tumble/record/table_file.hpp"

#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace tumble::app {

/// A line of a terminal that is written again and again, and gone in the end; nothing without a terminal.
class TerminalLine {
 public:
  /// Writes nothing yet.
  /// \param quiet  never show it
  explicit TerminalLine(bool quiet = false) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}
  ~TerminalLine() {
    if (shown_) std::fprintf(stderr, "\r\x1b[K");  // leave the terminal as it was
  }
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  /// Whether anything is to be written.
  [[nodiscard]] bool shown() const { return shown_; }

 private:
  bool shown_;
};

/// The progress of a run in one line of a terminal.
class ProgressLine : public RunObserver {
 public:
  /// Prepares the line.
  /// \param duration  [s] simulated time of the whole run
  /// \param quiet     never show it
  ProgressLine(std::string label, double duration, bool quiet);

  void on_step(const World& world, const Technique& technique, const StepReport& report,
               const Metrics& metrics) override;
  void on_finding(const std::string& message) override;

 private:
  std::string label_;
  double duration_;
  TerminalLine line_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point last_;
};

/// timing.csv: the clock's time of every step. The only file of a run that differs between runs.
class TimingFile : public RunObserver {
 public:
  /// Opens the file.
  /// \param folder  the run's folder
  /// \param every   steps from one row to the next
  TimingFile(const std::filesystem::path& folder, int every);

  void on_begin(const World& world) override;
  void on_step(const World& world, const Technique& technique, const StepReport& report,
               const Metrics& metrics) override;
  /// Writes the rest.
  void finish() { table_.flush(); }

 private:
  TableFile table_;
  int every_;
  std::int64_t step_ = 0;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace tumble::app
