/// \file
/// \brief Progress and timing.
#include "progress.hpp"

#include <algorithm>

namespace tumble::app {
namespace {

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

ProgressLine::ProgressLine(std::string label, double duration, bool quiet)
    : label_(std::move(label)),
      duration_(duration),
      line_(quiet),
      begin_(std::chrono::steady_clock::now()),
      last_(begin_) {}

void ProgressLine::on_step(const World& world, const Technique&, const StepReport& report,
                           const Metrics&) {
  if (!line_.shown()) return;
  const auto now = std::chrono::steady_clock::now();
  if (seconds(now - last_) < 0.1) return;
  last_ = now;
  const double share = std::clamp(world.time() / duration_, 1e-9, 1.0);
  const double left = seconds(now - begin_) * (1.0 - share) / share;
  std::fprintf(stderr, "\r\x1b[K%s  %.2f of %g s  %3.0f %%  %lld contacts  %.0f s left",
               label_.c_str(), world.time(), duration_, 100.0 * share,
               static_cast<long long>(report.contacts), left);
}

void ProgressLine::on_finding(const std::string& message) {
  std::fprintf(stderr, "%s%s, %s\n", line_.shown() ? "\r\x1b[K" : "", label_.c_str(),
               message.c_str());
}

TimingFile::TimingFile(const std::filesystem::path& folder, int every)
    : table_(folder / "timing.csv", "step,time_s,wall_ms_step_and_measurement"), every_(every) {}

void TimingFile::on_begin(const World&) { last_ = std::chrono::steady_clock::now(); }

void TimingFile::on_step(const World& world, const Technique&, const StepReport&, const Metrics&) {
  const auto now = std::chrono::steady_clock::now();
  if (++step_ % every_ == 0)
    table_.cell(step_).cell(world.time()).cell(1e3 * seconds(now - last_)).end_row();
  last_ = std::chrono::steady_clock::now();
}

}  // namespace tumble::app
