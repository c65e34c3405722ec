/// \file
/// \brief Plain English in comments, messages and test names, first on bad examples, then on the project.
#include "structure/plain_english.hpp"

#include "support/catch.hpp"

namespace tumble::structure {

TEST_CASE("A word that has a plainer one is found", "[structure]") {
  const auto found = [](const char* text) { return old_dialect({{"a.hpp", text}}).size(); };
  CHECK(old_dialect({{"a.hpp", std::string("\n// bodies w") + "ho rest\n"}}) ==
        Complaints{std::string("a.hpp:2: 'w") + "ho': a body is \"it\""});
  CHECK(found("say(\"To"
              "ld by its speed\");\n") == 1);
  CHECK(found("/// \\brief W"
              "hat a step does\n") == 1);
  CHECK(found("/// The share of w"
              "hat is left\n") == 1);
  CHECK(found("int nobo"
              "dy = 0;  // a name in code is looked at elsewhere\n") == 0);
  CHECK(found("// whose arms, somewhat, a total and a retold tale\n") == 0);
}

TEST_CASE("Comments and messages and test names use plain English", "[structure]") {
  const auto files = project_files();
  auto code = code_in(files, "");
  std::erase_if(code, [](const SourceFile& file) {
    return file.path.starts_with("verification/structure/plain_english");  // which quotes them
  });
  const Complaints complaints = old_dialect(code);
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

}  // namespace tumble::structure
