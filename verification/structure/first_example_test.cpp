/// \file
/// \brief The first example of README.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

namespace tumble::structure {

TEST_CASE("README shows the first example as it is compiled", "[structure]") {
  const auto files = project_files();
  const auto text_of = [&](const char* path) { return file_called(files, path).text; };
  const std::string mark = "// [stack]\n";
  const std::string example = text_of("examples/link/stack.cpp");
  const std::size_t begin = example.find(mark) + mark.size();
  const std::string code = example.substr(begin, example.rfind(mark) - begin);
  REQUIRE(code.size() > 200);
  const std::string readme = text_of("README.md");
  CHECK(readme.find("```cpp\n" + code + "```\n") != std::string::npos);
  std::string output = text_of("examples/link/stack_output.txt");
  output.pop_back();
  CHECK(readme.find("`" + output + "`") != std::string::npos);
}

}  // namespace tumble::structure
