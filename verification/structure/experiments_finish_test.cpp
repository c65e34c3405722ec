/// \file
/// \brief Experiments look at how their steps end.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <regex>

namespace tumble::structure {

TEST_CASE("Each step of a technique in an experiment has to finish, or its status is read",
          "[structure]") {
  const std::vector<SourceFile> files = code_in(project_files(), "chapters/");
  REQUIRE(files.size() > 100);
  // A statement that has technique.step(world, dt), with any names.
  static const std::regex step(R"re([^;{}]*(\.|->)step\([^;,]*, [^;,]*\))re");
  Complaints complaints;
  std::size_t steps = 0;
  for (const SourceFile& file : files) {
    const std::string code = code_of(file.text);
    const bool reads_status = code.find("StepStatus::event_cap") != std::string::npos ||
                              code.find("StepStatus::done") != std::string::npos;
    for (std::sregex_iterator it(code.begin(), code.end(), step), end; it != end; ++it) {
      ++steps;
      const bool finished = it->str().find("finished(") != std::string::npos;
      if (!finished && !reads_status)
        complaints.push_back(
            place(file, line_at(code, static_cast<std::size_t>(it->position()))) +
            "a step of an experiment is not checked: write finished(...) around it");
    }
  }
  CHECK(steps > 40);
  for (const std::string& complaint : complaints) FAIL_CHECK(complaint);
}

}  // namespace tumble::structure
