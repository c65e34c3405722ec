/// \file
/// \brief `tumble compare`: the same scene with each technique; a table, files and a picture.
#include "tumble/base/error.hpp"
#include "tumble/scenes/scene_file.hpp"
#include "tumble/techniques.hpp"

#include "drawing_programs.hpp"
#include "progress.hpp"
#include "request.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

namespace tumble::app {
namespace {

// Energy and overlap of every step, of all techniques in one file.
class Series : public RunObserver {
 public:
  Series(TableFile& table, std::string technique)
      : table_(table), technique_(std::move(technique)) {}
  void on_step(const World& world, const Technique&, const StepReport&, const Metrics& m) override {
    table_.cell(technique_).cell(world.time()).cell(m.kinetic + m.potential);
    table_.cell(m.energy_error).cell(m.deepest_overlap).cell(m.chatter.amplitude).end_row();
  }

 private:
  TableFile& table_;
  std::string technique_;
};

struct Outcome {
  std::string technique;
  std::string end;      // as in the tables
  std::string refusal;  // why it did not begin, or go on; without its name
  RunResult result;
  double wall = 0.0;  // [s]
};

constexpr std::array<std::string_view, 7> kFiles = {"compare.csv",     "series.csv", "timing.csv",
                                                    "scene.toml",      "compare.gp", "compare.svg",
                                                    "compare.svg.part"};

void print_table(const std::vector<Outcome>& outcomes) {
  std::printf("%-16s %-11s %9s %11s %12s %12s %12s %10s\n", "technique", "end", "steps",
              "collisions", "overlap_m", "energy_err_J", "chatter_m", "ms/step");
  for (const Outcome& o : outcomes) {
    const RunResult& r = o.result;
    if (r.steps == 0) {
      std::printf("%-16s %-11s %9d %11s %12s %12s %12s %10s\n", o.technique.c_str(), o.end.c_str(),
                  0, "-", "-", "-", "-", "-");
      continue;
    }
    const auto steps = static_cast<double>(r.steps);
    std::printf("%-16s %-11s %9lld %11lld %12.4g %12.4g %12.4g %10.4g\n", o.technique.c_str(),
                o.end.c_str(), static_cast<long long>(r.steps),
                static_cast<long long>(r.totals.events), r.worst_metrics.deepest_overlap,
                r.worst_metrics.energy_error, r.last.chatter.amplitude, 1e3 * o.wall / steps);
  }
}

// Why techniques refused the scene: each reason once.
void print_refusals(const std::vector<Outcome>& outcomes) {
  std::vector<std::pair<std::string, std::string>> by_reason;  // reason, names
  for (const Outcome& o : outcomes) {
    if (o.refusal.empty()) continue;
    const auto same = std::find_if(by_reason.begin(), by_reason.end(),
                                   [&](const auto& one) { return one.first == o.refusal; });
    if (same == by_reason.end())
      by_reason.emplace_back(o.refusal, o.technique);
    else
      same->second += ", " + o.technique;
  }
  for (const auto& [reason, names] : by_reason)
    std::fprintf(stderr, "refused by %s: %s\n", names.c_str(), reason.c_str());
}

void write_tables(const std::filesystem::path& folder, const std::vector<Outcome>& outcomes) {
  TableFile table(folder / "compare.csv",
                  "technique,end,worst_status,steps,collisions,deepest_overlap_m,energy_error_J,"
                  "chatter_amplitude_m,chatter_acceleration,state_hash");
  TableFile timing(folder / "timing.csv", "technique,steps,wall_s");
  for (const Outcome& o : outcomes) {
    const RunResult& r = o.result;
    table.cell(o.technique).cell(o.end).cell(name_of(r.worst)).cell(r.steps);
    table.cell(r.totals.events).cell(r.worst_metrics.deepest_overlap);
    table.cell(r.worst_metrics.energy_error).cell(r.last.chatter.amplitude);
    table.cell(r.last.chatter.acceleration).cell(r.state_hash).end_row();
    timing.cell(o.technique).cell(r.steps).cell(o.wall).end_row();
  }
  table.flush();
  timing.flush();
}

// Two panels: total energy and deepest overlap against time.
std::string commands(const std::vector<Outcome>& outcomes) {
  std::string names;
  for (const Outcome& o : outcomes) names += (names.empty() ? "" : " ") + o.technique;
  const bool apart = std::all_of(outcomes.begin(), outcomes.end(), [](const Outcome& o) {
    return o.result.worst_metrics.deepest_overlap == 0.0;
  });
  const std::string top = apart ? "1" : "*";  // gnuplot warns of a range that is empty
  std::string out = "set datafile separator ','\nnames = '";
  out += names;
  return out +
         "'\n"
         "set terminal svg size 600,720 dynamic font 'sans-serif,18' background 'white'\n"
         "set multiplot layout 2,1; set lmargin 10; set rmargin 2\n"
         "set border 3 lc rgb '#808080'; set tics nomirror textcolor rgb '#303030'\n"
         "set grid y lc rgb '#dddddd'; set key noenhanced above reverse Left samplen 2.5 font "
         "',13'\n"
         "set linetype 1 lc rgb '#0072B2' dt 1; set linetype 2 lc rgb '#D55E00' dt (12,4)\n"
         "set linetype 3 lc rgb '#009E73' dt (3,3); set linetype 4 lc rgb '#CC79A7' dt (12,4,3,4)\n"
         "set linetype 5 lc rgb '#E69F00' dt (20,4); set linetype 6 lc rgb '#56B4E9' dt (6,3)\n"
         "set linetype 7 lc rgb '#4D4D4D' dt 1; set linetype cycle 7\n"
         "set xlabel 'time [s]'; set ylabel 'total energy [J]'\n"
         "plot for [t in names] 'series.csv' using "
         "(strcol(1) eq t ? $2 : NaN):3 with lines lw 2 title t\n"
         "unset key; set ylabel 'deepest overlap [m]'; set yrange [0:" +
         top +
         "]\n"
         "plot for [t in names] 'series.csv' using "
         "(strcol(1) eq t ? $2 : NaN):5 with lines lw 2 title t\n"
         "unset multiplot\n";
}

// Runs one technique. One that refuses the scene is a row of the table like the others.
Outcome run_one(const Request& request, ResolvedRequest& resolved, double limit,
                TableFile& series) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  Outcome out;
  out.technique = resolved.description.technique;
  Series recorder(series, out.technique);
  try {
    ProgressLine progress(out.technique, request.run.duration, request.quiet);
    const std::array<RunObserver*, 2> observers = {&recorder, &progress};
    out.result = run_simulation(resolved.simulation, request.run, observers,
                                [&] { return stop_signal() != 0 || passed() > limit; });
    out.end = name_of(out.result.end);
    if (out.result.end == RunEnd::interrupted && stop_signal() == 0) out.end = "time_limit";
    if (out.result.end == RunEnd::complete && !out.result.findings.empty()) out.end = "unphysical";
  } catch (const std::invalid_argument& error) {
    out.end = "refused";
    out.refusal = message_of(error);
    const std::string name = "technique " + out.technique;
    const std::size_t at = out.refusal.find(name);
    if (at != std::string::npos) out.refusal.replace(at, name.size(), "the technique");
  }
  out.wall = passed();
  return out;
}

std::vector<std::string> names_of(const std::vector<std::string>& asked) {
  std::vector<std::string> names = asked;
  if (names.empty())
    for (const TechniqueRecipe& t : technique_library()) names.emplace_back(t.name);
  for (std::size_t k = 0; k < names.size(); ++k)
    require::that(std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(k),
                            names[k]) == names.begin() + static_cast<std::ptrdiff_t>(k),
                  "--techniques: " + names[k] + " is there twice");
  return names;
}

}  // namespace

int compare_command(const Request& request, const std::vector<std::string>& techniques,
                    double limit) {
  require::positive(limit, "limit");
  const std::vector<std::string> names = names_of(techniques);
  std::vector<ResolvedRequest> resolved;  // all mistakes come out before anything runs
  for (const std::string& name : names) {
    Request one = request;
    one.technique = name;
    one.out.clear();
    resolved.push_back(resolve(one));
  }
  const std::filesystem::path path = output_folder(request, "compare", "compare.csv");
  OutputFolder folder(path, "comparison", kFiles);
  write_file(folder.path() / "scene.toml", to_toml(resolved.front().simulation.scene()));
  if (names.size() == 1)
    std::fprintf(stderr, "note: one technique only (%s), so there is nothing to compare it with\n",
                 names.front().c_str());
  TableFile series(folder.path() / "series.csv",
                   "technique,time_s,total_J,energy_error_J,deepest_overlap_m,chatter_amplitude_m");
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < names.size() && stop_signal() == 0; ++i)
    outcomes.push_back(run_one(request, resolved[i], limit, series));
  series.flush();
  write_tables(folder.path(), outcomes);
  folder.publish();
  std::string picture = ", energies and overlaps over time: " + (path / "compare.svg").string();
  try {
    draw_with_gnuplot(path, "compare.gp", commands(outcomes), "compare.svg");
  } catch (const CannotWrite& error) {
    std::fprintf(stderr, "no picture: %s\n", error.what());
    picture.clear();
  }
  print_refusals(outcomes);
  print_table(outcomes);
  std::printf("overlap and energy error: the largest of a step; chatter: at the end; ");
  std::printf("unphysical: a check of the run failed, see the messages above\n");
  std::printf("files in %s%s\n", path.c_str(), picture.c_str());
  return stop_signal() != 0 ? 128 + stop_signal() : kDone;
}

}  // namespace tumble::app
