/// \file
/// \brief Docstrings, tests and README promise what there is.
#include "structure/promises.hpp"

#include "support/catch.hpp"

namespace tumble::structure {
namespace {

const SourceFile& file_called(const std::vector<SourceFile>& files, const std::string& path) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const SourceFile& file) { return file.path == path; });
  if (found == files.end()) throw std::runtime_error("there is no " + path);
  return *found;
}

}  // namespace

TEST_CASE("Test cases are read with names in pieces and all tags", "[structure]") {
  const auto tests = test_cases(
      {{"a_test.cpp",
        "// TEST_CASE(\"no\")\nTEST_CASE(\"A box \"\n          \"falls\", \"[unit][box]\") {}\n"
        "TEMPLATE_TEST_CASE(\"It is \\\"so\\\"\", \"[exact]\", int) {}\n"}});
  REQUIRE(tests.size() == 2);
  CHECK(tests[0].name == "A box falls");
  CHECK(tests[0].line == 2);
  CHECK(tests[0].tags == std::vector<std::string>{"unit", "box"});
  CHECK(tests[1].name == "It is \"so\"");
}

TEST_CASE("A promise of a test that does not exist is found", "[structure]") {
  const std::vector<TestCase> tests{{"a_test.cpp", 1, "A box falls, and how", {}}};
  CHECK(
      unkept_promises({{"a.hpp", "/// \\verified{A box falls\\, and\n/// how}\n"}}, tests).empty());
  CHECK(unkept_promises({{"a.hpp", "\n/// \\verified{A box rises}\n"}}, tests) ==
        Complaints{"a.hpp:2: no test is called \"A box rises\""});
}

TEST_CASE("A claim or a page with a test that does not exist is found", "[structure]") {
  const std::vector<TestCase> tests{{"a_test.cpp", 1, "A \"box\" falls, and how", {}}};
  const std::string kept = "[[claim]]\ntest = \"A \\\"box\\\" falls, and how\"\n";
  CHECK(unkept_records({{"claims.toml", kept}}, tests).empty());
  CHECK(unkept_records({{"claims.toml", kept + "[[claim]]\n  test=\"A box rises\" # so\n"}},
                       tests) == Complaints{"claims.toml:4: no test is called \"A box rises\""});
  CHECK(unkept_records({{"page.md", "Beside:\n\n- \"A box rises\"\n"}}, tests).size() == 1);
}

TEST_CASE("A test on no rung is found", "[structure]") {
  CHECK(tests_without_rung({{"a", 1, "x", {"unit", "box"}}}).empty());
  CHECK(tests_without_rung({{"a", 1, "x", {"box"}}}).size() == 1);
}

TEST_CASE("A tolerance that nothing uses is found", "[structure]") {
  const SourceFile tolerances{"src/tumble/math/tolerances.hpp",
                              "inline constexpr double a = 1;\ninline constexpr int b = 2;\n"};
  CHECK(unused_tolerances({tolerances, {"a.cpp", "x < tolerance::a; tolerance::b"}}).empty());
  CHECK(unused_tolerances({tolerances, {"a.cpp", "x < tolerance::a; // b\n"}}) ==
        Complaints{"src/tumble/math/tolerances.hpp:2: nothing uses b"});
}

TEST_CASE("A bare small literal outside a tolerances.hpp is found", "[structure]") {
  const std::string code =
      "double a = 0.0;\nif (b < 1e-4 * c) f(.005);\nx = 0.25 + 0x1p-20; // 1e-9\n";
  CHECK(bare_small_literals({{"src/tumble/math/a.cpp", code}}) ==
        Complaints{"src/tumble/math/a.cpp:2: 1e-4: give it a name, unit and reason in the folder's "
                   "tolerances.hpp",
                   "src/tumble/math/a.cpp:2: .005: give it a name, unit and reason in the folder's "
                   "tolerances.hpp"});
  CHECK(bare_small_literals({{"src/tumble/math/tolerances.hpp", code}}).empty());
  CHECK(bare_small_literals({{"src/tumble/math/a.cpp",
                              "constexpr double kClose = 1e-9;\n"
                              "p.add_number(\"size\", 1.0, 1e-3, 1e3, \"m\", \"edge\");\n"}})
            .empty());
}

TEST_CASE("A command that the Makefile does not have is found", "[structure]") {
  const SourceFile makefile{"Makefile", "test:\n\tx\ntest-long:\n"};
  CHECK(unknown_commands({"a.md", "`make test`, `make SETUP=no test-long`, they make sense\n"},
                         makefile)
            .empty());
  CHECK(unknown_commands({"a.md", "\nmake fly\n"}, makefile) ==
        Complaints{"a.md:2: make fly does not exist"});
}

TEST_CASE("Every verified sentence is the name of a test", "[structure]") {
  const auto files = project_files();
  const std::vector<TestCase> tests = test_cases(code_in(files, "verification/"));
  for (const char* folder : {"src/", "live/"}) {
    const Complaints complaints = unkept_promises(code_in(files, folder), tests);
    INFO(joined(complaints));
    CHECK(complaints.empty());
  }
}

TEST_CASE("Every claim, every erratum and every page names tests that exist", "[structure]") {
  const auto files = project_files();
  const auto is_record = [](const SourceFile& file) {
    return file.path.starts_with("chapters/") &&
           (file.path.find("/claims.toml") != std::string::npos ||
            file.path.find("/errata.toml") != std::string::npos ||
            file.path.find("/page.md") != std::string::npos ||
            file.path.find("/measured.md") != std::string::npos);
  };
  std::vector<SourceFile> records;
  std::copy_if(files.begin(), files.end(), std::back_inserter(records), is_record);
  CHECK_FALSE(records.empty());
  const Complaints complaints =
      unkept_records(records, test_cases(code_in(files, "verification/")));
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("Every test stands on a rung of the ladder", "[structure]") {
  const auto tests = test_cases(code_in(project_files(), "verification/"));
  const Complaints complaints = tests_without_rung(tests);
  INFO(joined(complaints));
  CHECK(complaints.empty());
  CHECK(tests.size() > 30);
}

TEST_CASE("Every tolerance is used", "[structure]") {
  const auto files = project_files();
  const auto library = code_in(files, "src/");
  CHECK(std::count_if(library.begin(), library.end(), defines_tolerances) > 5);
  const Complaints complaints = unused_tolerances(library);
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("Every small number of the library has a name", "[structure]") {
  const Complaints complaints = bare_small_literals(code_in(project_files(), "src/"));
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("Every command that README and CONTRIBUTING name exists", "[structure]") {
  const auto files = project_files();
  for (const char* path : {"README.md", "CONTRIBUTING.md"}) {
    const Complaints complaints =
        unknown_commands(file_called(files, path), file_called(files, "Makefile"));
    INFO(joined(complaints));
    CHECK(complaints.empty());
  }
}

}  // namespace tumble::structure
