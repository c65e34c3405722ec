/// \file
/// \brief The files of `tumble sample`, and its line of progress.
#pragma once

#include "tumble/record/output_folder.hpp"
#include "tumble/record/sampling.hpp"

#include "progress.hpp"
#include "request.hpp"

#include <chrono>
#include <limits>

namespace tumble::app {

/// The most motions that a folder has.
inline constexpr int kMostMotions = 1000;
/// The most chains that a folder has.
inline constexpr int kMostChains = 256;
/// The file of the settings that have to stay the same for chains to go on.
inline constexpr std::string_view kSettingsFile = "sampling.txt";

/// The file of a chain.
/// \param chain from 1
std::string chain_file(int chain);

/// All files that a folder of `tumble sample` may have.
std::vector<std::string> all_sampling_files();

/// A motion that is written, and by which chain it was found.
struct SampledMotion {
  int chain = 0;       ///< from 0
  FoundMotion motion;  ///< its noise
};

/// The motions that are written: of those that meet all wishes the first ones of all chains, then the second ones: the same whichever
/// chain was faster. If there is none, the one that misses the least.
/// \param chains  with one state or more each
/// \param most    how many
/// \return one or more, the found ones
std::vector<SampledMotion> motions_of(const std::vector<NoiseChain>& chains, int most);

/// What chains came to, added up.
struct ChainCounts {
  std::int64_t found = 0;                                  ///< motions that meet all wishes
  std::int64_t proposals = 0;                              ///< starts included
  std::int64_t accepted = 0;                               ///< without starts
  double least = std::numeric_limits<double>::infinity();  ///< [-] smallest violation
  double acceptance = 0.0;  ///< [-] share of proposals, without starts
};

/// Adds up chains.
/// \param chains  at any state
ChainCounts counts_of(const std::vector<NoiseChain>& chains);

/// Writes the tables of chains every second while they go on, and a line of a terminal ten times a second.
class ChainWatch {
 public:
  /// Prepares both.
  /// \param folder   gets the tables; published as soon as there is a motion
  /// \param samples  motions that are wanted
  /// \param quiet    no line
  ChainWatch(OutputFolder& folder, const std::vector<NoiseChain>& chains, int samples,
             std::string label, bool quiet);

  /// Writes and shows at the intervals above.
  /// \throws CannotWrite if a table cannot be written
  void look();
  /// Writes the tables that have grown, each as a whole.
  /// \throws CannotWrite if a table cannot be written
  void write();
  /// The clock's time.
  /// \return [s] since the beginning
  [[nodiscard]] double passed() const;

 private:
  using Clock = std::chrono::steady_clock;
  void show();

  OutputFolder& folder_;
  const std::vector<NoiseChain>& chains_;
  int samples_;
  std::string label_;
  TerminalLine line_;
  std::vector<std::size_t> written_;  // proposals of each chain on file
  Clock::time_point begin_;
  Clock::time_point shown_at_;
  Clock::time_point written_at_;
};

/// Runs each motion again from its noise, and writes its trajectory and a row of motions.csv. Ends early after stop_signal().
/// \param every    steps from one frame to the next
/// \throws CannotWrite if a file cannot be written
void write_motions(const std::filesystem::path& folder, const SceneSampler& sampler,
                   const std::vector<SampledMotion>& motions, int every);

/// Writes summary.json.
/// \param description  what was sampled
/// \param chains       at their ends
/// \throws CannotWrite if it cannot be written
void write_summary(const std::filesystem::path& folder, const RunDescription& description,
                   const SampleRequest& sample, const std::vector<NoiseChain>& chains);

}  // namespace tumble::app
