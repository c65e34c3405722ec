/// \file
/// \brief Every committed input of the fuzz targets, replayed: what was once found stays mended.
#include "fuzz/judged_answer.hpp"
#include "fuzz/targets.hpp"
#include "support/files.hpp"
#include "support/test.hpp"

#include <filesystem>

namespace tumble::fuzz {
namespace {

std::vector<std::filesystem::path> inputs_in(std::string_view kind, const Target& target) {
  const std::filesystem::path folder =
      std::filesystem::path(TUMBLE_SOURCE_DIR) / "verification/fuzz" / kind / target.name;
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

void run(const Target& target, const std::string& content) {
  target.run({reinterpret_cast<const std::uint8_t*>(content.data()), content.size()});
}

}  // namespace

TEST_CASE("No input of the corpus breaks a promise", "[unit][fuzz]") {
  for (const Target& target : kTargets) {
    const std::vector<std::filesystem::path> files = inputs_in("corpus", target);
    CHECK(files.size() >= 5);
    for (const std::filesystem::path& file : files) {
      CAPTURE(file.string());
      CHECK_NOTHROW(run(target, test::content(file)));
    }
  }
}

// These wait to be mended. One that is goes from `open` into `corpus`.
TEST_CASE("Every input in the folder of open findings still breaks a promise", "[unit][fuzz]") {
  for (const Target& target : kTargets) {
    for (const std::filesystem::path& file : inputs_in("open", target)) {
      CAPTURE(file.string());
      CHECK_THROWS_AS(run(target, test::content(file)), BrokenPromise);
    }
  }
}

TEST_CASE("Every fuzz target takes an input of no bytes", "[unit][fuzz]") {
  for (const Target& target : kTargets) {
    CAPTURE(target.name);
    CHECK_NOTHROW(run(target, {}));
  }
}

TEST_CASE("A refusal has a message without control characters", "[unit][fuzz]") {
  CHECK_THROWS_AS(require_message(""), BrokenPromise);
  CHECK_THROWS_AS(require_message("x = \x1b[31m"), BrokenPromise);
  CHECK_NOTHROW(require_message("x = 1: expected 2"));
}

TEST_CASE("An answer that is called solved and is none breaks a promise", "[unit][fuzz]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LcpProblem problem{MatX::Identity(2, 2), VecX::Constant(2, -1.0), {}};
  LcpResult result{.f = {1.0, 1.0}};
  CHECK_NOTHROW(require_solved(problem, result, "right"));
  for (const double wrong : {nan, 0.9, 1.1, -1.0}) {
    CAPTURE(wrong);
    result.f = {1.0, wrong};
    CHECK_THROWS_AS(require_solved(problem, result, "wrong"), BrokenPromise);
  }
}

}  // namespace tumble::fuzz
