/// \file
/// \brief `tumble run`: one scene, one technique, a folder of files.

#include "tumble/record/recorded_run.hpp"

#include "progress.hpp"
#include "request.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <sys/time.h>
#include <unistd.h>

namespace tumble::app {
namespace {

// A signal handler may touch nothing but such variables; the run asks for them before every step.
volatile std::sig_atomic_t g_signal = 0;
volatile std::sig_atomic_t g_asked = 0;  // how often

// Lets so many microseconds pass until end_at_once() is called; 0: for ever.
void set_alarm(int microseconds) {
  itimerval timer{};
  timer.it_value.tv_usec = microseconds;
  setitimer(ITIMER_REAL, &timer, nullptr);
}

// The signal was not heard in time: within a long step, or while a file is waited for.
extern "C" void end_at_once(int) {
  constexpr char message[] =
      "interrupted within a step, or before the first: tables have complete lines up to there\n";
  if (write(STDERR_FILENO, message, sizeof message - 1) < 0) _exit(kCannotWrite);
  _exit(128 + static_cast<int>(g_signal));
}

// A third signal kills at once. The second may be the first one again: timeout(1) signals its child, and then the
// group of the child.
extern "C" void remember_signal(int number) {
  g_signal = number;
  g_asked = g_asked + 1;
  if (g_asked >= 2) std::signal(number, SIG_DFL);
  constexpr int half_a_second = 500000;
  set_alarm(half_a_second);
}

void print_summary(const ResolvedRequest& r, const RunResult& result) {
  const Metrics& worst = result.worst_metrics;
  std::printf("%s, %s: %.6g s in %lld steps, %lld collisions\n", r.description.scene.c_str(),
              r.description.technique.c_str(), result.time, static_cast<long long>(result.steps),
              static_cast<long long>(result.totals.events));
  std::printf("  deepest overlap %.3g m, chatter %.3g m at the end\n", worst.deepest_overlap,
              result.last.chatter.amplitude);
  std::printf(
      "  largest energy change without a cause %.3g J, %.2g %% of lifting each box by its edge\n",
      worst.energy_error, 100.0 * worst.energy_error_share);
  std::printf("  state hash %s, files in %s\n", result.state_hash.c_str(), r.folder.c_str());
}

// What a run writes it should be able to read again.
void warn_of_length(const RunSettings& run, std::size_t boxes) {
  const double rows = run.duration / run.dt / run.every * static_cast<double>(boxes);
  if (!(rows > kMostTrajectoryRows)) return;
  std::fprintf(stderr,
               "note: trajectory.csv will have about %.2g rows, and at most %d can be read again: "
               "--every N records each N-th step only\n",
               rows, kMostTrajectoryRows);
}

// What a user may look at next.
void print_next(const std::string& folder) {
  std::printf("  see it: tumble view %s\n", folder.c_str());
  std::printf("  a film: tumble render %s --as gif\n", folder.c_str());
}

}  // namespace

int stop_signal() {
  if (g_signal != 0) set_alarm(0);  // heard: there is time for an orderly end
  return g_signal;
}

void catch_stop_signals() {
  std::signal(SIGALRM, end_at_once);
  std::signal(SIGINT, remember_signal);
  std::signal(SIGTERM, remember_signal);
  std::signal(SIGXFSZ, SIG_IGN);
}

int run_command(const Request& request) {
  std::filesystem::path folder;
  const int code = run_into(request, folder);
  if (!request.quiet) print_next(folder.string());
  return code;
}

int run_into(const Request& request, std::filesystem::path& folder) {
  ResolvedRequest r = resolve(request);
  folder = r.folder;
  RunFiles files(r.folder, r.description, r.simulation.scene());
  RunResult result;
  try {
    TimingFile timing(files.folder(), request.run.every);
    for (const std::string& what : r.description.ignored_physics)
      std::fprintf(stderr, "note: %s ignores %s\n", r.description.technique.c_str(), what.c_str());
    warn_of_length(request.run, r.simulation.scene().boxes.size());
    ProgressLine progress(r.description.scene + ", " + r.description.technique,
                          request.run.duration, request.quiet);
    const std::array<RunObserver*, 3> observers = {&timing, &files, &progress};
    result =
        run_simulation(r.simulation, request.run, observers, [] { return stop_signal() != 0; });
    timing.finish();
    files.finish(result);
    if (const std::string why = files.filter_refusal(); !why.empty())
      std::fprintf(stderr, "trajectory_filtered.csv has only the frames before a bad one: %s\n",
                   why.c_str());
    for (const Diagnostic& diagnostic : r.simulation.technique().diagnostics()) {
      files.write_diagnostic(diagnostic);
      std::fprintf(stderr, "see %s: %s\n", (r.folder / diagnostic.file).c_str(),
                   std::string(diagnostic.comment).c_str());
    }
  } catch (const CannotWrite& error) {
    throw CannotWrite(std::string(error.what()) + "; the tables in " + r.folder.string() +
                      " have complete lines up to there, and there is no summary.json");
  }
  if (!request.quiet) print_summary(r, result);
  if (result.end == RunEnd::interrupted) {
    std::fprintf(stderr, "interrupted at %.6g s: the files in %s are complete up to there\n",
                 result.time, r.folder.c_str());
    return 128 + stop_signal();  // as a shell reports a process ended by a signal
  }
  if (!result.refusal.empty()) {
    std::fprintf(stderr, "%s stopped at %.6g s: %s\nThe files in %s are complete up to there\n",
                 r.description.technique.c_str(), result.time, result.refusal.c_str(),
                 r.folder.c_str());
    return kMathematical;
  }
  if (result.worst >= StepStatus::energy_gained && result.worst < StepStatus::unsolved) {
    const Parameters& set = r.description.technique_settings;
    const bool passes = set.has("contacts") && set.word("contacts") != "collide";
    std::fprintf(stderr, "this run is wrong, see above: try %s\n",
                 passes ? "a smaller --dt, or --set contacts=collide if boxes are to collide"
                        : "a smaller --dt or another technique");
    return kMathematical;
  }
  if (result.worst != StepStatus::done) {
    std::fprintf(stderr, "%s: worst status %s, %lld steps at the event cap\n",
                 r.description.technique.c_str(), std::string(name_of(result.worst)).c_str(),
                 static_cast<long long>(result.capped_steps));
    return kMathematical;
  }
  return kDone;
}

}  // namespace tumble::app
