/// \file
/// \brief The live page in live/ready, for machines without a compiler for the browser, is that of these sources.
#include "hashes/outcomes.hpp"
#include "support/test.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;
const fs::path kLive = fs::path(TUMBLE_SOURCE_DIR) / "live";
const char* const kRenew =
    "The page in live/ready is no longer that of these sources. `make ready` renews it, for "
    "you to commit.";

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  INFO(path);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

// FNV-1a, 32 bits wide, as live/record.mjs has it.
std::string fnv(const std::string& bytes) {
  std::uint32_t hash = 0x811c9dc5U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x01000193U;
  char text[9];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(hash));
  return text;
}

// The record's lines; those that begin with `sources` and `archive` come last.
std::vector<std::string> recorded() {
  std::istringstream in(bytes_of(kLive / "ready" / "record.txt"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  REQUIRE(lines.size() > 2);
  return lines;
}

}  // namespace

TEST_CASE("The committed live page moves as these sources do", "[determinism][live]") {
  const std::vector<std::string> right = tumble::live::record();
  std::vector<std::string> found = recorded();
  found.resize(found.size() - 2);
  const auto [here, there] = std::mismatch(right.begin(), right.end(), found.begin(), found.end());
  INFO("these sources: " << (here == right.end() ? "nothing more" : *here));
  INFO("live/ready/record.txt: " << (there == found.end() ? "nothing more" : *there));
  INFO(kRenew);
  CHECK((here == right.end() && there == found.end()));
}

TEST_CASE("The committed live page is made of these sources and is what was recorded",
          "[unit][live]") {
  std::set<std::string> sources;  // ordered by name
  for (const auto& entry : fs::directory_iterator(kLive)) {
    const std::string name = entry.path().filename().string();
    const std::string ending = entry.path().extension().string();
    if (ending == ".cpp" || ending == ".hpp" || name == "build.mjs" || name == "package-lock.json")
      sources.insert(name);
  }
  for (const auto& entry : fs::directory_iterator(kLive / "page"))
    sources.insert("page/" + entry.path().filename().string());
  CHECK(sources.size() > 30);
  std::string all;
  for (const std::string& name : sources) all += bytes_of(kLive / name);

  const std::vector<std::string> lines = recorded();
  INFO(kRenew);
  CHECK(lines.end()[-2] == "sources " + fnv(all));
  CHECK(lines.back() == "archive " + fnv(bytes_of(kLive / "ready" / "page.tar.xz")));
}
