/// \file
/// \brief Tables of chains, motions and their summary.
#include "sampling_output.hpp"

#include "tumble/base/version.hpp"
#include "tumble/record/json.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tumble::app {
namespace {

constexpr std::chrono::milliseconds kShowInterval(100);
constexpr std::chrono::seconds kWriteInterval(1);

// The trajectory of a motion, and how far it is from the wishes.
class MotionFile : public RunObserver {
 public:
  MotionFile(const std::filesystem::path& path, const Scene& scene, int every)
      : file_(path), scene_(scene), every_(every) {}
  void on_begin(const World& world) override { file_.write(world); }
  void on_step(const World& world, const Technique&, const StepReport&, const Metrics&) override {
    if (++step_ % every_ == 0) file_.write(world);
    violation_ = violation(scene_, world);
  }
  double finish() {
    file_.flush();
    return violation_;
  }

 private:
  TrajectoryFile file_;
  const Scene& scene_;
  int every_;
  std::int64_t step_ = 0;
  double violation_ = 0.0;
};

}  // namespace

std::string chain_file(int chain) { return "chain_" + std::to_string(chain) + ".csv"; }

std::string motion_file(int motion) { return "motion_" + std::to_string(motion) + ".csv"; }

bool is_sampling(const std::filesystem::path& folder) {
  std::error_code none;
  return std::filesystem::exists(folder / motion_file(1), none);
}

std::vector<std::string> all_sampling_files() {
  std::vector<std::string> names = {std::string(kSettingsFile), "scene.toml", "motions.csv",
                                    "summary.json", "timing.csv"};
  for (int k = 1; k <= kMostMotions; ++k) names.push_back(motion_file(k));
  for (int k = 1; k <= kMostChains; ++k) names.push_back(chain_file(k));
  return names;
}

std::vector<SampledMotion> motions_of(const std::vector<NoiseChain>& chains, int most) {
  std::vector<SampledMotion> motions;
  std::size_t longest = 0;
  for (const NoiseChain& chain : chains) longest = std::max(longest, chain.found().size());
  for (std::size_t turn = 0; turn < longest; ++turn)
    for (std::size_t k = 0; k < chains.size() && static_cast<int>(motions.size()) < most; ++k)
      if (turn < chains[k].found().size())
        motions.push_back({static_cast<int>(k), chains[k].found()[turn]});
  if (!motions.empty()) return motions;
  const auto nearest =
      std::min_element(chains.begin(), chains.end(), [](const NoiseChain& a, const NoiseChain& b) {
        return a.least_violation() < b.least_violation();
      });
  return {{static_cast<int>(nearest - chains.begin()), nearest->best()}};
}

ChainCounts counts_of(const std::vector<NoiseChain>& chains) {
  ChainCounts counts;
  std::int64_t tried = 0;
  for (const NoiseChain& chain : chains) {
    const auto proposals = static_cast<std::int64_t>(chain.proposals().size());
    counts.found += static_cast<std::int64_t>(chain.found().size());
    counts.proposals += proposals;
    tried += std::max<std::int64_t>(0, proposals - 1);
    counts.accepted += chain.accepted();
    counts.least = std::min(counts.least, chain.least_violation());
  }
  if (tried > 0)
    counts.acceptance = static_cast<double>(counts.accepted) / static_cast<double>(tried);
  return counts;
}

ChainWatch::ChainWatch(OutputFolder& folder, const std::vector<NoiseChain>& chains, int samples,
                       std::string label, bool quiet)
    : folder_(folder),
      chains_(chains),
      samples_(samples),
      label_(std::move(label)),
      line_(quiet),
      written_(chains.size(), 0),
      begin_(Clock::now()),
      shown_at_(begin_),
      written_at_(begin_ - kWriteInterval) {}

void ChainWatch::look() {
  const Clock::time_point now = Clock::now();
  if (line_.shown() && now - shown_at_ > kShowInterval) show();
  if (now - written_at_ >= kWriteInterval) write();
}

void ChainWatch::write() {
  if (counts_of(chains_).proposals == 0) return;
  for (std::size_t k = 0; k < chains_.size(); ++k) {
    const std::size_t count = chains_[k].proposals().size();
    if (count == written_[k]) continue;
    write_file(folder_.path() / chain_file(static_cast<int>(k) + 1),
               chain_table(chains_[k].proposals()));
    written_[k] = count;
  }
  folder_.publish();
  written_at_ = Clock::now();
}

double ChainWatch::passed() const {
  return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void ChainWatch::show() {
  const ChainCounts counts = counts_of(chains_);
  constexpr std::int64_t width = 20;
  const std::int64_t filled = std::min(width, width * counts.found / samples_);
  std::fprintf(stderr,
               "\r\x1b[K%s [%s%s] %lld of %d motions, %lld proposals, %.0f %% accepted, %.0f s",
               label_.c_str(), std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(width - filled), '.').c_str(),
               static_cast<long long>(counts.found), samples_,
               static_cast<long long>(counts.proposals), 100.0 * counts.acceptance, passed());
  shown_at_ = Clock::now();
}

void write_motions(const std::filesystem::path& folder, const SceneSampler& sampler,
                   const std::vector<SampledMotion>& motions, int every) {
  TableFile table(folder / "motions.csv",
                  "motion,chain,proposal,worst_status,violation,state_hash");
  for (std::size_t k = 0; k < motions.size() && stop_signal() == 0; ++k) {
    const int number = static_cast<int>(k) + 1;
    MotionFile file(folder / motion_file(number), sampler.scene(), every);
    const std::array<RunObserver*, 1> observers = {&file};
    const RunResult result = sampler.run(motions[k].motion.noise, observers);
    table.cell(std::int64_t{number}).cell(std::int64_t{motions[k].chain + 1});
    table.cell(motions[k].motion.proposal).cell(name_of(result.worst));
    table.cell(file.finish()).cell(result.state_hash).end_row();
  }
  table.flush();
}

void write_summary(const std::filesystem::path& folder, const RunDescription& description,
                   const SampleRequest& sample, const std::vector<NoiseChain>& chains) {
  const ChainCounts counts = counts_of(chains);
  const BuildInfo build = build_info();
  Json out;
  out.begin()
      .field("scene", std::string_view(description.scene))
      .field("technique", std::string_view(description.technique))
      .field("dt_s", description.run.dt)
      .field("duration_s", description.run.duration)
      .field("seed", std::to_string(description.run.seed))
      .field("samples_wanted", std::int64_t{sample.samples})
      .field("samples_found", std::min(counts.found, std::int64_t{sample.samples}))
      .field("proposals", counts.proposals)
      .field("acceptance_rate", counts.acceptance)
      .field("least_violation", counts.least);
  out.key("chains").begin_list();
  for (const NoiseChain& chain : chains)
    out.begin()
        .field("proposals", static_cast<std::int64_t>(chain.proposals().size()))
        .field("accepted", chain.accepted())
        .field("found", static_cast<std::int64_t>(chain.found().size()))
        .field("least_violation", chain.least_violation())
        .end();
  out.end_list();
  out.field("version", build.version).field("compiler", build.compiler).field("flags", build.flags);
  out.end();
  write_file(folder / "summary.json", out.text());
}

}  // namespace tumble::app
