/// \file
/// \brief Claim 3.3.2c: lines of code of impulses and of analytic forces, and random piles that each runs through.
#include "tumble/record/overlap.hpp"

#include "driver/experiment.hpp"

#include <filesystem>
#include <fstream>
#include <set>

namespace tumble::chapters {
namespace {

namespace fs = std::filesystem;

const fs::path kSources = fs::path(TUMBLE_SOURCE_DIR) / "src";
constexpr double kRounding = 1e-6;  // [-] of the energy of the start: more is a gain

// The layers that all techniques share.
bool is_shared(const std::string& name) {
  static constexpr std::array<const char*, 5> kShared{
      "tumble/base/", "tumble/math/", "tumble/geometry/", "tumble/dynamics/", "tumble/contact/"};
  return std::ranges::any_of(kShared,
                             [&](const char* folder) { return name.rfind(folder, 0) == 0; });
}

// Lines with code of a file; what it includes is put into a list.
int code_lines(const fs::path& path, std::vector<std::string>& included) {
  std::ifstream file(path);
  int lines = 0;
  for (std::string line; std::getline(file, line);) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line.compare(begin, 2, "//") == 0) continue;
    ++lines;
    static const std::string include = "#include \"";
    if (line.rfind(include, 0) != 0) continue;
    included.push_back(
        line.substr(include.size(), line.find('"', include.size()) - include.size()));
  }
  return lines;
}

// The sources of a header: those that include it first.
std::multimap<std::string, fs::path> sources_by_header() {
  std::multimap<std::string, fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator(kSources / "tumble")) {
    std::vector<std::string> included;
    if (entry.path().extension() != ".cpp") continue;
    code_lines(entry.path(), included);
    if (!included.empty()) sources.emplace(included.front(), entry.path());
  }
  return sources;
}

// Lines with code of a header and all that it needs above the shared layers, with the sources of the headers.
int lines_of(const std::string& header, const std::multimap<std::string, fs::path>& sources) {
  std::vector<std::string> open = {header};
  std::set<std::string> seen;
  int lines = 0;
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    if (is_shared(name) || !seen.insert(name).second) continue;
    lines += code_lines(kSources / name, open);
    const auto [begin, end] = sources.equal_range(name);
    for (auto source = begin; source != end; ++source) lines += code_lines(source->second, open);
  }
  require::that(lines > 0, header + ": expected a header of the library");
  return lines;
}

// How a pile ends under a technique.
struct Ran {
  bool capped = false;  // a step did not end as done
  bool gained = false;  // energy above that of the start
  bool deep = false;    // an overlap of more than a twentieth of an edge in the end

  [[nodiscard]] bool through() const { return !capped && !gained && !deep; }
};

// Eight cubes that fall on one another from a column of random places and orientations.
Ran run_pile(const PlayedTechnique& played, int seed, int cubes, double duration) {
  Random random(static_cast<std::uint64_t>(seed));
  Scene scene{.ground = SceneGround{0.5, 0.0}};
  for (int k = 0; k < cubes; ++k) {
    SceneBox box{.name = "cube" + std::to_string(k + 1)};
    const double aside = random.uniform(-0.4, 0.4);
    box.position_w = Vec3(aside, 1.2 + 1.8 * k, 0.0);
    box.orientation_wb = random.orientation();
    scene.boxes.push_back(box);
  }
  World world = build_world(scene);
  const auto technique = make_technique(played.name, played.settings);
  const double allowed = energy_of(world).total() * (1.0 + kRounding);
  Ran ran;
  while (world.time() < duration - 0.5 * kStep) {
    if (technique->step(world, kStep).status != StepStatus::done) ran.capped = true;
    if (!(energy_of(world).total() <= allowed)) ran.gained = true;
  }
  OverlapMeter overlaps;
  ran.deep = !(overlaps.look(world.bodies(), world.states()) <= 0.05);
  return ran;
}

struct Compared {
  const char* name;
  const char* header;
};
constexpr std::array<Compared, 3> kTechniques{
    {{"impulse", "tumble/impulse_damped/impulse.hpp"},
     {"analytic", "tumble/analytic_lcp/analytic.hpp"},
     {"time_stepping", "tumble/analytic_lcp/time_stepping.hpp"}}};

Result measure_simpler(const Parameters& settings) {
  const int piles = settings.count("piles");
  Table table{"",
              {{"technique", "-", "1 impulse, 2 analytic, 3 time_stepping"},
               {"lines", "-", "with code, above the shared layers"},
               {"through", "-", "piles that it runs through"},
               {"capped", "-", "piles with a step that does not end as done"},
               {"gained", "-", "piles with energy above that of the start"},
               {"deep", "-", "piles that overlap by more than a twentieth of an edge in the end"}}};
  const std::multimap<std::string, fs::path> sources = sources_by_header();
  Result result;
  std::array<int, 3> lines{};
  std::array<int, 3> failed{};
  for (std::size_t t = 0; t < kTechniques.size(); ++t) {
    lines[t] = lines_of(kTechniques[t].header, sources);
    std::array<int, 4> counts{};
    for (int seed = 201; seed < 201 + piles; ++seed) {
      const Ran ran = run_pile({kTechniques[t].name}, seed, settings.count("cubes"),
                               settings.number("duration"));
      counts[0] += ran.through() ? 1 : 0;
      counts[1] += ran.capped ? 1 : 0;
      counts[2] += ran.gained ? 1 : 0;
      counts[3] += ran.deep ? 1 : 0;
    }
    failed[t] = piles - counts[0];
    table.add(t + 1, lines[t], counts);
  }
  const bool simpler = 2 * lines[0] <= lines[1];
  const bool more_robust = failed[1] > 0 && 2 * failed[0] <= failed[1];
  result.add(
      "of two sayings about impulses against analytic forces those that hold: half of the lines "
      "of code or fewer, and half as many random piles or fewer that do not run through, of "
      "which there are some",
      "-", (simpler ? 1 : 0) + (more_robust ? 1 : 0));
  result.add("lines of code of impulses over those of analytic forces", "-",
             static_cast<double>(lines[0]) / lines[1]);
  result.add("random piles that impulses do not run through", "-", failed[0]);
  result.add("random piles that analytic forces do not run through", "-", failed[1]);
  int left = 0;
  for (int seed = 201; seed < 201 + piles; ++seed)
    left += run_pile({"impulse", {"repair=on"}}, seed, settings.count("cubes"),
                     settings.number("duration"))
                    .through()
                ? 0
                : 1;
  result.add("random piles that impulses do not run through, repair=on", "-", left);
  result.tables = {table};
  return result;
}

const Registered claim_3_3_2c_simpler_figure{
    {.name = "claim_3_3_2c_simpler",
     .parameters = {whole("piles", 20, 1, 1000, "random piles, from seed 201 on"),
                    whole("cubes", 8, 1, 100, "of a pile"),
                    number("duration", 2.0, 0.1, 100.0, "s", "of each run")},
     .quick = {"piles=2", "cubes=2", "duration=1"},
     .experiment = measure_simpler}};

}  // namespace
}  // namespace tumble::chapters
