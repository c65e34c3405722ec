/// \file
/// \brief `tumble sample`: motions of a scene that meet its wishes.
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/text_file.hpp"
#include "tumble/previous_work/parallel_chains.hpp"
#include "tumble/scenes/scene_file.hpp"

#include "sampling_output.hpp"

#include <algorithm>
#include <cstdio>
#include <thread>

namespace tumble::app {
namespace {

namespace fs = std::filesystem;

void require_count(int value, int low, int high, const std::string& option) {
  require::that(value >= low && value <= high, option + " " + std::to_string(value) +
                                                   ": expected " + std::to_string(low) + " to " +
                                                   std::to_string(high));
}

void require_valid(const SampleRequest& sample) {
  require_count(sample.samples, 1, kMostMotions, "--samples");
  require_count(sample.chains, 0, kMostChains, "--chains");
  constexpr int most_cores = 1024;
  require_count(sample.cores, 0, most_cores, "--cores");
  constexpr int most_proposals = 1000000;  // of which the table of a chain has some 50 MB
  require_count(sample.proposals, 1, most_proposals, "--proposals");
  require::that(sample.chains <= sample.samples,
                "--chains " + std::to_string(sample.chains) + ": more than the " +
                    std::to_string(sample.samples) + " of --samples: each chain has to find one");
  require::that(sample.strictness > 0.0,
                "--strictness " + shortest_text(sample.strictness) + ": expected a number above 0");
}

// Without --resume chains that are not finished are not lost by mistake.
fs::path sample_folder(const Request& request, bool resume) {
  std::error_code none;
  const fs::path first =
      request.out.empty() ? fs::path("runs") / (fs::path(request.scene).stem().string() + "-sample")
                          : fs::path(request.out);
  const bool chains = fs::exists(first / chain_file(1), none);
  if (resume) {
    require::that(!request.force, "--resume --force: give one of them");
    require::that(chains, "--resume: " + first.string() + " has no chains to continue");
    return first;
  }
  require::that(
      request.out.empty() || request.force || !chains || fs::exists(first / "summary.json", none),
      "--out " + first.string() +
          " has chains that are not finished: continue with --resume, replace them with "
          "--force, or give another folder");
  return output_folder(request, "sample", chain_file(1));
}

// What must be the same for chains to go on, a line each.
std::string settings_text(const ResolvedRequest& r, const SampleRequest& sample) {
  const RunDescription& d = r.description;
  std::string out = "technique = " + d.technique + "\n";
  for (const Parameter& p : d.technique_settings.all())
    out.append("technique.").append(p.key).append(" = ").append(p.value).append("\n");
  out.append("dt = ").append(shortest_text(d.run.dt)).append("\n");
  out.append("duration = ").append(shortest_text(d.run.duration)).append("\n");
  out.append("seed = ").append(std::to_string(d.run.seed)).append("\n");
  out.append("chains = ").append(std::to_string(sample.chains)).append("\n");
  out.append("strictness = ").append(shortest_text(sample.strictness)).append("\n");
  out.append("noise-speed = ").append(shortest_text(sample.noise.speed)).append("\n");
  out.append("noise-normal = ").append(shortest_text(sample.noise.normal)).append("\n");
  return out.append("noise-restitution = ")
      .append(shortest_text(sample.noise.restitution))
      .append("\n");
}

// The first line that differs is the reason why chains cannot go on.
void require_same(const fs::path& file, const std::string& now) {
  constexpr std::size_t most_mib = 64;
  const std::string then = read_text(file, "a file of tumble sample", most_mib);
  if (then == now) return;
  const std::size_t at = static_cast<std::size_t>(
      std::mismatch(then.begin(), then.end(), now.begin(), now.end()).first - then.begin());
  const auto line = [at](const std::string& text) {
    const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
    return begin < text.size() ? text.substr(begin, text.find('\n', begin) - begin)
                               : std::string("nothing");
  };
  refuse("--resume: " + file.string() + " has \"" + line(then) + "\", and this is \"" + line(now) +
         "\": continue with the original settings");
}

int cores_of(const SampleRequest& sample) {
  if (sample.cores > 0) return sample.cores;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// What was found, or why not all of it.
int report(const RunDescription& d, const SampleRequest& sample,
           const std::vector<NoiseChain>& chains, const fs::path& folder, bool quiet) {
  const ChainCounts counts = counts_of(chains);
  if (!quiet) {
    std::printf("%s, %s: %lld of %d motions meet all wishes\n", d.scene.c_str(),
                d.technique.c_str(),
                static_cast<long long>(std::min<std::int64_t>(counts.found, sample.samples)),
                sample.samples);
    std::printf("  %zu chains, %lld motions tried, %.1f %% accepted\n", chains.size(),
                static_cast<long long>(counts.proposals), 100.0 * counts.acceptance);
    std::printf("  files in %s; see one: tumble view %s --motion 1\n", folder.c_str(),
                folder.c_str());
  }
  if (counts.found >= sample.samples) return kDone;
  const bool still = std::none_of(chains.begin(), chains.end(), [](const NoiseChain& chain) {
    const auto varied = [](const NoiseProposal& p) { return p.impacts > 0; };
    return std::any_of(chain.proposals().begin(), chain.proposals().end(), varied);
  });
  std::string why = "; the closest one has a violation of " + shortest_text(counts.least);
  if (counts.found > 0) why.clear();
  std::fprintf(stderr, "%s: %lld of %d motions were found before chains ended at %d proposals%s\n",
               d.scene.c_str(), static_cast<long long>(counts.found), sample.samples,
               sample.proposals, why.c_str());
  if (still) {
    std::fprintf(stderr, "no impact was fast enough for noise: try a smaller --noise-speed\n");
  } else {
    std::fprintf(
        stderr, "continue with --resume and more --proposals, or try more noise or other wishes\n");
  }
  return kMathematical;
}

}  // namespace

int sample_command(const Request& request, const SampleRequest& asked) {
  require_valid(asked);
  SampleRequest sample = asked;
  constexpr int usual_chains = 4;
  if (sample.chains == 0) sample.chains = std::min(usual_chains, sample.samples);
  Request lookup = request;
  lookup.out.clear();
  const ResolvedRequest r = resolve(lookup);  // all mistakes come out before anything is written
  const SceneSampler sampler(r.simulation.scene(), r.simulation.technique().clone(), request.run,
                             sample.noise);
  std::vector<NoiseChain> chains = make_chains(request.run.seed, sample.chains, sample.strictness);
  const fs::path path = sample_folder(request, sample.resume);
  const std::vector<std::string> names = all_sampling_files();
  const std::vector<std::string_view> files(names.begin(), names.end());
  OutputFolder folder(path, "sampling", files);
  const std::string settings = settings_text(r, sample);
  if (sample.resume) {
    require_same(path / kSettingsFile, settings);
    require_same(path / "scene.toml", to_toml(sampler.scene()));
    for (int k = 0; k < sample.chains; ++k) {
      const fs::path file = path / chain_file(k + 1);
      if (fs::exists(file)) chains[idx(k)].replay(read_chain(file));
    }
  }
  write_file(folder.path() / kSettingsFile, settings);
  write_file(folder.path() / "scene.toml", to_toml(sampler.scene()));
  for (const std::string& what : r.description.ignored_physics)
    std::fprintf(stderr, "note: %s ignores %s\n", r.description.technique.c_str(), what.c_str());

  const ChainGoal goal{(sample.samples + sample.chains - 1) / sample.chains, sample.proposals};
  std::atomic<bool> stop = false;
  double wall = 0.0;
  {
    ChainWatch watch(folder, chains, sample.samples, r.description.scene, request.quiet);
    const auto stopped = [&stop] { return stop || stop_signal() != 0; };
    const SimulateNoise simulate = [&](const ImpactNoise& noise) {
      return sampler.motion(noise, stopped);
    };
    run_chains(chains, goal, simulate, cores_of(sample), stop, [&] {
      stop = stopped();
      watch.look();
    });
    watch.write();
    wall = watch.passed();
  }
  const auto interrupted = [&] {
    if (counts_of(chains).proposals == 0)
      std::fprintf(stderr, "interrupted before the first motion: nothing was written\n");
    else
      std::fprintf(stderr, "interrupted: the chains in %s are complete; continue with --resume\n",
                   path.c_str());
    return 128 + stop_signal();  // as a shell reports a process ended by a signal
  };
  if (stop_signal() != 0) return interrupted();
  write_motions(folder.path(), sampler, motions_of(chains, sample.samples), request.run.every);
  if (stop_signal() != 0) return interrupted();
  TableFile timing(folder.path() / "timing.csv", "cores,proposals,wall_s");
  timing.cell(std::int64_t{cores_of(sample)}).cell(counts_of(chains).proposals).cell(wall);
  timing.end_row();
  timing.flush();
  write_summary(folder.path(), r.description, sample, chains);
  return report(r.description, sample, chains, path, request.quiet);
}

}  // namespace tumble::app
