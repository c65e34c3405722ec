/// \file
/// \brief Docstrings, tests and README promise what there is.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <regex>

namespace tumble::structure {
namespace {

// A test case as its source writes it.
struct TestCase {
  std::string path;
  std::size_t line{};             // where it begins
  std::string name;               // the sentence
  std::vector<std::string> tags;  // without brackets
};

// The literals that follow one another from a place on, joined as the compiler joins them.
std::string joined_literals(const std::string& text, std::size_t& at) {
  std::string joined;
  while (true) {
    at = text.find_first_not_of(" \n", at);
    if (at == std::string::npos || text[at] != '"') return joined;
    for (++at; at < text.size() && text[at] != '"'; ++at) {
      if (text[at] == '\\') ++at;
      joined += text[at];
    }
    ++at;
  }
}

std::set<std::string> names_of(const std::vector<TestCase>& tests) {
  std::set<std::string> names;
  for (const TestCase& test : tests) names.insert(test.name);
  return names;
}

std::string with_single_blanks(const std::string& text) {
  static const std::regex blanks("\\s+");
  static const std::regex ends("^ | $");
  return std::regex_replace(std::regex_replace(text, blanks, " "), ends, "");
}

// Every TEST_CASE and TEMPLATE_TEST_CASE.
std::vector<TestCase> test_cases(const std::vector<SourceFile>& files) {
  static const std::regex tag("\\[([^\\]]+)\\]");
  static const std::string begin = "TEST_CASE";
  std::vector<TestCase> found;
  const std::sregex_iterator end;
  for (const SourceFile& file : files) {
    if (file.text.find(begin) == std::string::npos) continue;
    const std::string code = code_of(file.text);
    for (std::size_t i = code.find(begin); i != std::string::npos; i = code.find(begin, i + 1)) {
      // A word by itself, or the end of TEMPLATE_TEST_CASE, before a bracket.
      static const std::string more = "TEMPLATE_";
      std::size_t from = i;
      if (i >= more.size() && code.compare(i - more.size(), more.size(), more) == 0)
        from -= more.size();
      const bool word = from == 0 || !in_name(code[from - 1]);
      std::size_t at = code.find_first_not_of(" \n", i + begin.size());
      if (!word || at == std::string::npos || code[at] != '(') continue;
      ++at;
      TestCase test{file.path, line_at(code, from), "", {}};
      test.name = with_single_blanks(joined_literals(file.text, at));
      if (at < file.text.size() && file.text[at] == ',') {
        ++at;
        const std::string tags = joined_literals(file.text, at);
        for (std::sregex_iterator t(tags.begin(), tags.end(), tag); t != end; ++t)
          test.tags.push_back((*t)[1]);
      }
      found.push_back(test);
    }
  }
  return found;
}

// Sentences in \verified{...} that are no test's name.
Complaints unkept_promises(const std::vector<SourceFile>& files,
                           const std::vector<TestCase>& tests) {
  const std::set<std::string> names = names_of(tests);
  static const std::regex form("\\\\verified\\{([^}]*)\\}");
  Complaints complaints;
  const std::sregex_iterator end;
  for (const SourceFile& file : files) {
    // Only what comments say, so that a sentence may go on in the next line.
    std::string said;
    for (const std::string& comment : comments_of(file.text))
      said += (comment.starts_with('/') ? comment.substr(1) : comment) + '\n';
    for (std::sregex_iterator m(said.begin(), said.end(), form); m != end; ++m) {
      std::string sentence = with_single_blanks((*m)[1]);
      static const std::regex escaped_comma("\\\\,");
      sentence = std::regex_replace(sentence, escaped_comma, ",");
      if (names.count(sentence) > 0) continue;
      const std::size_t line = line_at(said, static_cast<std::size_t>(m->position()));
      complaints.push_back(place(file, line) + "no test is called \"" + sentence + '"');
    }
  }
  return complaints;
}

// Tests that claims, errata and pages name, `test = "sentence"` and `- "sentence"`, and that do not exist.
Complaints unkept_records(const std::vector<SourceFile>& files,
                          const std::vector<TestCase>& tests) {
  const std::set<std::string> names = names_of(tests);
  static const std::regex form(R"x(^(?:\s*test\s*=\s*|- )"((?:[^"\\]|\\.)*)")x");
  static const std::regex escape(R"(\\(.))");
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::vector<std::string> lines = lines_of(file.text);
    std::smatch match;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!std::regex_search(lines[i], match, form)) continue;
      const std::string sentence = std::regex_replace(match[1].str(), escape, "$1");
      if (names.count(sentence) == 0)
        complaints.push_back(place(file, i + 1) + "no test is called \"" + sentence + '"');
    }
  }
  return complaints;
}

// Sanitizers and equal-bits builds choose by rungs.
Complaints tests_without_rung(const std::vector<TestCase>& tests) {
  static const std::set<std::string> rungs{"unit",   "exact",       "reference",
                                           "claims", "determinism", "structure"};
  Complaints complaints;
  for (const TestCase& test : tests) {
    const bool placed =
        std::ranges::any_of(test.tags, [](const std::string& tag) { return rungs.count(tag) > 0; });
    if (!placed)
      complaints.push_back(test.path + ':' + std::to_string(test.line) + ": no rung: \"" +
                           test.name + '"');
  }
  return complaints;
}

bool defines_tolerances(const SourceFile& file) {
  static const std::regex form("src/tumble/\\w+/tolerances\\.hpp");
  return std::regex_match(file.path, form);
}

// Decimal literals above 0 and below 1e-2 outside of files that define tolerances. Named ones (constexpr) and
// the ranges of options (number) are allowed.
Complaints bare_small_literals(const std::vector<SourceFile>& files) {
  static const std::regex literal(R"x((^|[^\w.'])(\d[\d']*\.?\d*[eE]-\d+|0?\.\d+(?:[eE]-\d+)?))x");
  static const std::regex range_of_option("\\bnumber\\(");
  Complaints complaints;
  const std::sregex_iterator end;
  for (const SourceFile& file : files) {
    if (defines_tolerances(file)) continue;
    const std::string code = code_of(file.text);
    for (std::size_t line = 0, next = 0; line < code.size(); line = next) {
      next = std::min(code.find('\n', line), code.size() - 1) + 1;
      const std::string words = code.substr(line, next - line);
      if (words.find('.') == std::string::npos && words.find("e-") == std::string::npos &&
          words.find("E-") == std::string::npos)
        continue;
      for (std::sregex_iterator m(words.begin(), words.end(), literal); m != end; ++m) {
        const double value = std::stod((*m)[2]);
        if (!(value > 0.0) || value >= 0.01) continue;
        const std::size_t offset = line + static_cast<std::size_t>(m->position(2));
        const std::size_t before = code.find_last_of(";{}", offset);
        const std::string statement = code.substr(before + 1, offset - before - 1);
        const bool named = statement.find("constexpr") != std::string::npos;
        const bool range = std::regex_search(statement, range_of_option);
        if (!named && !range)
          complaints.push_back(place(file, line_at(code, offset)) + (*m)[2].str() +
                               ": give it a name, unit and reason in the folder's tolerances.hpp");
      }
    }
  }
  return complaints;
}

Complaints unused_tolerances(const std::vector<SourceFile>& files) {
  static const std::regex definition("\\binline\\s+constexpr\\s+\\w+\\s+(\\w+)\\s*=");
  // A file that has a name, and whether others have it too.
  struct Use {
    const SourceFile* file = nullptr;
    bool others = false;
  };
  std::map<std::string, Use> uses;
  std::map<std::string, std::string> tolerances;  // code by path
  for (const SourceFile& file : files) {
    const std::string code = code_of(file.text);
    for (std::size_t i = 0; i < code.size(); ++i) {
      const std::size_t from = i;
      while (i < code.size() && in_name(code[i])) ++i;
      if (i == from) continue;
      Use& use = uses[code.substr(from, i - from)];
      if (use.file == nullptr) use.file = &file;
      use.others = use.others || use.file != &file;
    }
    if (defines_tolerances(file)) tolerances.emplace(file.path, code);
  }
  Complaints complaints;
  const std::sregex_iterator end;
  for (const SourceFile& file : files) {
    const auto code = tolerances.find(file.path);
    if (code == tolerances.end()) continue;
    for (std::sregex_iterator m(code->second.begin(), code->second.end(), definition); m != end;
         ++m) {
      const std::string name = (*m)[1];
      if (uses.at(name).others) continue;
      const std::size_t line = line_at(code->second, static_cast<std::size_t>(m->position()));
      complaints.push_back(place(file, line) + "nothing uses " + name);
    }
  }
  return complaints;
}

// Commands `make x` in a text that the Makefile does not have.
Complaints unknown_commands(const SourceFile& text, const SourceFile& makefile) {
  static const std::regex target("(?:^|\\n)([a-z-]+):");
  static const std::regex command("(?:`|\\n)make(?: +[A-Z]+=\\S+)* +([a-z][a-z-]*)");
  std::set<std::string> targets;
  const std::sregex_iterator end;
  for (std::sregex_iterator m(makefile.text.begin(), makefile.text.end(), target); m != end; ++m)
    targets.insert((*m)[1]);
  Complaints complaints;
  for (std::sregex_iterator m(text.text.begin(), text.text.end(), command); m != end; ++m) {
    if (targets.count((*m)[1]) > 0) continue;
    const std::size_t line = line_at(text.text, static_cast<std::size_t>(m->position(1)));
    complaints.push_back(place(text, line) + "make " + (*m)[1].str() + " does not exist");
  }
  return complaints;
}

}  // namespace

TEST_CASE("Promises of tests that do not exist are found", "[structure]") {
  const auto tests =
      test_cases({{"a_test.cpp",
                   "// TEST_CASE(\"no\")\nTEST_CASE(\"A box \"\n          \"falls, and how\", "
                   "\"[unit][box]\") {}\n"
                   "TEMPLATE_TEST_CASE(\"It is \\\"so\\\"\", \"[box]\", int) {}\n"}});
  REQUIRE(tests.size() == 2);
  CHECK(tests[0].name == "A box falls, and how");
  CHECK(tests[0].line == 2);
  CHECK(tests[1].name == "It is \"so\"");
  CHECK(tests_without_rung(tests).size() == 1);
  CHECK(
      unkept_promises({{"a.hpp", "/// \\verified{A box falls\\, and\n/// how}\n"}}, tests).empty());
  CHECK(unkept_promises({{"a.hpp", "\n/// \\verified{A box rises}\n"}}, tests) ==
        Complaints{"a.hpp:2: no test is called \"A box rises\""});
  CHECK(unkept_records(
            {{"claims.toml",
              "[[claim]]\ntest = \"A box falls, and how\"\n  test=\"A box rises\" # so\n"}},
            tests)
            .size() == 1);
  CHECK(unkept_records({{"page.md", "Beside:\n\n- \"A box rises\"\n"}}, tests).size() == 1);
}

TEST_CASE("An unused tolerance, a bare small literal and an unknown command are found",
          "[structure]") {
  const SourceFile tolerances{"src/tumble/math/tolerances.hpp",
                              "inline constexpr double a = 1;\ninline constexpr int b = 2;\n"};
  CHECK(unused_tolerances({tolerances, {"a.cpp", "x < tolerance::a; // b\n"}}) ==
        Complaints{"src/tumble/math/tolerances.hpp:2: nothing uses b"});
  CHECK(bare_small_literals(
            {{"src/tumble/math/a.cpp",
              "double a = 0.0;\nif (b < 1e-4 * c) f(.005);\nx = 0.25 + 0x1p-20; // 1e-9\n"
              "constexpr double kClose = 1e-9;\np.add(number(\"size\", 1.0, 1e-3, 1e3, \"m\", "
              "\"edge\"));\n"}})
            .size() == 2);
  CHECK(unknown_commands({"a.md", "`make test`, they make sense\nmake fly\n"},
                         {"Makefile", "test:\n\tx\n"}) ==
        Complaints{"a.md:2: make fly does not exist"});
}

TEST_CASE("Every verified sentence is the name of a test", "[structure]") {
  const auto files = project_files();
  const std::vector<TestCase> tests = test_cases(code_in(files, "verification/"));
  for (const char* folder : {"src/", "live/"}) {
    expect_none(unkept_promises(code_in(files, folder), tests));
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
  expect_none(unkept_records(records, test_cases(code_in(files, "verification/"))));
}

TEST_CASE("Every test stands on a rung of the ladder", "[structure]") {
  const auto tests = test_cases(code_in(project_files(), "verification/"));
  expect_none(tests_without_rung(tests));
  CHECK(tests.size() > 30);
}

TEST_CASE("Every tolerance is used", "[structure]") {
  const auto files = project_files();
  const auto library = code_in(files, "src/");
  CHECK(std::ranges::count_if(library, defines_tolerances) > 5);
  expect_none(unused_tolerances(library));
}

TEST_CASE("Every small number of the library has a name", "[structure]") {
  expect_none(bare_small_literals(code_in(project_files(), "src/")));
}

TEST_CASE("Every command that README and CONTRIBUTING name exists", "[structure]") {
  const auto files = project_files();
  for (const char* path : {"README.md", "CONTRIBUTING.md"}) {
    expect_none(unknown_commands(file_called(files, path), file_called(files, "Makefile")));
  }
}

}  // namespace tumble::structure
