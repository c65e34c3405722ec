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
  // technique.step(world, dt) in a statement, with any names.
  static const std::regex step(R"re((\.|->)step\([^;,]*, [^;,]*\))re");
  Complaints complaints;
  std::size_t steps = 0;
  for (const SourceFile& file : files) {
    const std::string code = code_of(file.text);
    const bool reads_status = code.find("StepStatus::event_cap") != std::string::npos ||
                              code.find("StepStatus::done") != std::string::npos;
    for (std::size_t begin = 0; begin < code.size();) {
      const std::size_t end = std::min(code.find_first_of(";{}", begin), code.size());
      const std::string statement = code.substr(begin, end - begin);
      const bool is_step =
          statement.find("step(") != std::string::npos && std::regex_search(statement, step);
      if (is_step) ++steps;
      const bool checked = statement.find("finished(") != std::string::npos ||
                           statement.find("ended_at_cap(") != std::string::npos;
      if (is_step && !reads_status && !checked)
        complaints.push_back(place(file, line_at(code, end)) +
                             "a step of an experiment is not checked: write finished(...) or "
                             "ended_at_cap(...) around it");
      begin = end + 1;
    }
  }
  CHECK(steps > 40);
  expect_none(complaints);
}

}  // namespace tumble::structure
