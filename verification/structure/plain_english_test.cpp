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
  Complaints complaints;
  for (const char* folder : {"bench/",
                             "chapters/analytic_lcp/",
                             "chapters/basic_colliding/",
                             "chapters/lcp_solvers/",
                             "chapters/contact_damped/",
                             "chapters/timewarp/",
                             "src/tumble/analytic_lcp/",
                             "src/tumble/basic_colliding/",
                             "src/tumble/lcp_solvers/",
                             "src/tumble/scenes/",
                             "src/tumble/record/",
                             "src/tumble/contact_damped/",
                             "src/tumble/timewarp/",
                             "src/tumble/filtering/",
                             "src/tumble/geometric_stability/",
                             "src/tumble/exterior_rotation/",
                             "src/tumble/pictures/",
                             "apps/",
                             "live/",
                             "examples/",
                             "verification/analytic_lcp/",
                             "verification/basic_colliding/",
                             "verification/lcp_solvers/",
                             "verification/scenes/",
                             "verification/record/",
                             "verification/apps/",
                             "verification/techniques/",
                             "verification/live/",
                             "verification/support/",
                             "verification/contact_damped/",
                             "verification/timewarp/",
                             "verification/filtering/",
                             "verification/geometric_stability/",
                             "verification/exterior_rotation/",
                             "verification/pictures/"}) {
    auto code = code_in(files, folder);
    // Tests of experiments quote the names of quantities, which stay.
    std::erase_if(
        code, [](const SourceFile& file) { return file.path.ends_with("_experiments_test.cpp"); });
    const auto more = old_dialect(code);
    complaints.insert(complaints.end(), more.begin(), more.end());
  }
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

}  // namespace tumble::structure
