/// \file
/// \brief The files of a run.
#include "tumble/record/run_files.hpp"

#include "tumble/base/version.hpp"
#include "tumble/dynamics/step_report.hpp"
#include "tumble/filtering/filters.hpp"
#include "tumble/record/json.hpp"
#include "tumble/record/matrix_market.hpp"
#include "tumble/record/metrics.hpp"
#include "tumble/scenes/scene_file.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace tumble {
namespace {

constexpr std::string_view kEventsHeader =
    "time_s,first,second,px_m,py_m,pz_m,nx,ny,nz,jx_N_s,jy_N_s,jz_N_s,rewinds,restarts";
constexpr std::string_view kContactsHeader =
    "time_s,first,second,px_m,py_m,pz_m,nx,ny,nz,fx,fy,fz,unit,state";

// The last two are diagnostics of techniques.
constexpr std::array<std::string_view, 10> kFiles = {
    kTrajectoryFile, kFilteredFile,  "metrics.csv", "events.csv",     "contacts.csv",
    "scene.toml",    "summary.json", "timing.csv",  "unsolved_A.mtx", "unsolved_b.mtx"};

std::string metrics_header() {
  std::string out = "time_s,status";
  for (const MetricsColumn& column : metrics_columns()) out.append(",").append(column.name);
  return out;
}

void write(const Metrics& metrics, const StepReport& report, Json& out) {
  out.begin();
  for (const MetricsColumn& column : metrics_columns()) {
    const double value = column.value(metrics, report);
    if (column.whole) out.field(column.name, static_cast<std::int64_t>(value));
    if (!column.whole) out.field(column.name, value);
  }
  out.end();
}

void write(const Parameters& settings, Json& out) {
  out.begin();
  for (const Parameter& p : settings.all()) {
    if (p.kind == ParameterKind::number) {
      out.field(p.key, settings.number(p.key));
    } else if (p.kind == ParameterKind::whole) {
      out.field(p.key, settings.whole(p.key));
    } else {
      out.field(p.key, std::string_view(p.value));
    }
  }
  out.end();
}

}  // namespace

RunFiles::RunFiles(const std::filesystem::path& folder, RunDescription description,
                   const Scene& scene)
    : folder_(folder, "run", kFiles),
      description_(std::move(description)),
      trajectory_(folder_.path() / kTrajectoryFile),
      metrics_(folder_.path() / "metrics.csv", metrics_header()),
      events_(folder_.path() / "events.csv", kEventsHeader) {
  if (description_.contacts) contacts_.emplace(folder_.path() / "contacts.csv", kContactsHeader);
  if (!description_.filter.empty())
    filtered_.emplace(folder_.path() / kFilteredFile, *filter_of(description_.filter));
  write_file(folder_.path() / "scene.toml", to_toml(scene));
}

void RunFiles::write_frame(const World& world) {
  trajectory_.write(world);
  if (filtered_) filtered_->write(world);
}

void RunFiles::on_begin(const World& world) { write_frame(world); }

void RunFiles::on_step(const World& world, const Technique& technique, const StepReport& report,
                       const Metrics& m) {
  folder_.publish();
  ++step_;
  if (step_ % description_.run.every != 0) return;
  write_frame(world);
  metrics_.cell(world.time()).cell(name_of(report.status));
  for (const MetricsColumn& column : metrics_columns()) {
    const double value = column.value(m, report);
    if (column.whole) metrics_.cell(static_cast<std::int64_t>(value));
    if (!column.whole) metrics_.cell(value);
  }
  metrics_.end_row();
  if (!contacts_) return;
  for (const ContactRecord& c : technique.contacts()) {
    contacts_->cell(c.time).cell(world.name(world.index_of(c.first)));
    contacts_->cell(world.name(world.index_of(c.second))).cell(c.point_w).cell(c.normal_w);
    contacts_->cell(c.push_w).cell(c.is_impulse ? "N s" : "N").cell(name_of(c.state)).end_row();
  }
}

void RunFiles::on_event(const World& world, const Event& event) {
  events_.cell(event.time).cell(world.name(world.index_of(event.first)));
  events_.cell(world.name(world.index_of(event.second)));
  events_.cell(event.point_w).cell(event.normal_w).cell(event.impulse_w);
  events_.cell(std::int64_t{event.rewinds}).cell(std::int64_t{event.restarts}).end_row();
}

void RunFiles::write_diagnostic(const Diagnostic& diagnostic) {
  assert(std::find(kFiles.begin(), kFiles.end(), diagnostic.file) != kFiles.end());
  write_file(folder_.path() / diagnostic.file,
             to_matrix_market(diagnostic.matrix, diagnostic.comment));
}

std::string RunFiles::filter_refusal() const {
  return filtered_ ? filtered_->refusal() : std::string();
}

void RunFiles::finish(const RunResult& result) {
  folder_.publish();
  trajectory_.flush();
  metrics_.flush();
  events_.flush();
  if (contacts_) contacts_->flush();
  if (filtered_) filtered_->finish();
  const BuildInfo build = build_info();
  Json out;
  out.begin()
      .field("state_hash", std::string_view(result.state_hash))
      .field("end", name_of(result.end))
      .field("worst_status", name_of(result.worst))
      .field("steps", result.steps)
      .field("steps_at_the_event_cap", result.capped_steps)
      .field("simulated_s", result.time)
      .field("scene", std::string_view(description_.scene))
      .field("technique", std::string_view(description_.technique))
      .field("dt_s", description_.run.dt)
      .field("duration_s", description_.run.duration)
      .field("seed", std::to_string(description_.run.seed))
      .field("every", std::int64_t{description_.run.every})
      .field("contacts", std::string_view(description_.contacts ? "on" : "off"))
      .field("filter", std::string_view(filtered_ ? description_.filter : "none"))
      .field("filtered_frames", filtered_ ? filtered_->frames() : 0)
      .field("halvings", std::int64_t{description_.halvings});
  write(description_.scene_settings, out.key("scene_settings"));
  write(description_.technique_settings, out.key("technique_settings"));
  out.key("ignored").begin_list();
  for (const std::string& what : description_.ignored_physics) out.item(what);
  out.end_list();
  write(result.last, result.last_report, out.key("at_the_end"));
  write(result.worst_metrics, result.worst_report, out.key("at_worst"));
  out.key("totals").begin();
  for (const ReportCount& count : kReportCounts) out.field(count.name, result.totals.*count.member);
  out.end();
  out.field("version", build.version).field("compiler", build.compiler).field("flags", build.flags);
  out.end();
  write_file(folder_.path() / "summary.json", out.text());
}

}  // namespace tumble
