/// \file
/// \brief Words that may not stand in the sources: functions whose bits differ between machines, tabs, paths of one machine.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <cctype>

namespace tumble::structure {
namespace {

// A name in code, with what decides whether it is a call of something forbidden.
struct Name {
  std::size_t offset = 0;
  std::string text;       // sin
  std::string qualifier;  // std in std::sin; "::" alone gives "::"
  bool member = false;    // after a point or an arrow
  char next = ' ';        // the first character after it that is no blank
};

std::vector<Name> names_in(const std::string& code) {
  std::vector<Name> names;
  for (std::size_t i = 0; i < code.size();) {
    if (!in_name(code[i])) {
      ++i;
      continue;
    }
    Name name{.offset = i};
    while (i < code.size() && in_name(code[i])) name.text += code[i++];
    const std::size_t after = code.find_first_not_of(" \n", i);
    if (after != std::string::npos) name.next = code[after];

    // What stands before it: a point, an arrow, or :: and the name before that.
    const std::size_t last =
        name.offset == 0 ? std::string::npos : code.find_last_not_of(" \n", name.offset - 1);
    const char before = last == std::string::npos ? ' ' : code[last];
    const char second = last == std::string::npos || last == 0 ? ' ' : code[last - 1];
    name.member = before == '.' || (before == '>' && second == '-');
    if (before == ':' && second == ':') {
      name.qualifier = "::";
      if (!names.empty() &&
          code.find_first_not_of(" \n", names.back().offset + names.back().text.size()) == last - 1)
        name.qualifier = names.back().text;
    }
    names.push_back(name);
  }
  return names;
}

// Why a name is forbidden; empty if it is not.
std::string fault_of(const Name& name, bool defines_elementary, bool is_program) {
  static const std::set<std::string> transcendental{
      "sin",   "cos",   "tan",   "asin", "acos", "atan",  "atan2", "sinh",   "cosh",   "tanh",
      "asinh", "acosh", "atanh", "exp",  "exp2", "exp10", "expm1", "log",    "log2",   "log10",
      "log1p", "pow",   "hypot", "cbrt", "fma",  "erf",   "erfc",  "tgamma", "lgamma", "sincos"};
  static const std::set<std::string> hidden_sines{"AngleAxis",       "AngleAxisd", "Rotation2D",
                                                  "Rotation2Dd",     "slerp",      "eulerAngles",
                                                  "angularDistance", "hypotNorm"};
  static const std::set<std::string> chance{"rand", "srand", "rand_r", "drand48"};
  static const std::set<std::string> clocks{"clock_gettime", "gettimeofday", "chrono"};
  static const std::set<std::string> too_new{"ranges",   "views",     "format",
                                             "bit_cast", "execution", "jthread"};
  static const std::set<std::string> by_locale{
      "snprintf", "sprintf", "strtod", "strtof",       "atof",          "stod",
      "stof",     "sscanf",  "scanf",  "stringstream", "ostringstream", "istringstream"};

  const bool of_std = name.qualifier == "std";
  if (transcendental.count(name.text) > 0) {
    if (of_std) return "C libraries differ in its last bit; call elementary::";
    if (name.next != '(' || name.qualifier == "elementary") return "";
    if (name.member) return "Eigen asks the C library, and libraries differ in its last bit";
    return defines_elementary ? "" : "C libraries differ in its last bit; call elementary::";
  }
  if (hidden_sines.count(name.text) > 0)
    return "Eigen asks the C library for its sines; see math/rotation.hpp";
  if ((of_std && name.text == "hash") || name.text.starts_with("unordered_"))
    return "no order by address or hash";
  if ((chance.count(name.text) > 0 && name.next == '(') || name.text == "random_device")
    return "take Random";
  if (name.text.ends_with("_distribution") || name.text.starts_with("mt19937"))
    return "standard libraries differ; take Random";
  if (!is_program && clocks.count(name.text) > 0)
    return "results must not depend on the time of day";
  if (!is_program && by_locale.count(name.text) > 0)
    return "a program's locale changes it; see base/number_text.hpp";
  if (of_std && too_new.count(name.text) > 0) return "em++ 3.1.6 or clang++ 14 cannot compile it";
  return "";
}

// Calls that make bits depend on compiler, C library or chance, in code of the library: the C library's transcendental
// functions (elementary:: has ours), Eigen's that call them, the standard's distributions, hashes and unordered containers,
// clocks (programs in apps/ may ask them: they write timing.csv), and what em++ 3.1.6 cannot compile.
Complaints forbidden_calls(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::string code = code_of(file.text);
    const bool defines_elementary = file.path.find("math/elementary") != std::string::npos;
    const bool is_program = file.path.starts_with("apps/");
    std::string before;
    for (const Name& name : names_in(code)) {
      std::string fault = fault_of(name, defines_elementary, is_program);
      if (before == "long" && name.text == "double") fault = "long double differs between machines";
      before = name.text;
      if (fault.empty()) continue;
      complaints.push_back(place(file, line_at(code, name.offset)) + name.text + ": " + fault);
    }
  }
  return complaints;
}

Complaints long_files(const std::vector<SourceFile>& files, std::size_t limit) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const auto lines = static_cast<std::size_t>(std::ranges::count(file.text, '\n'));
    if (lines > limit)
      complaints.push_back(place(file, lines) + "more than " + std::to_string(limit) + " lines");
  }
  return complaints;
}

Complaints untidy_text(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::vector<std::string> lines = lines_of(file.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string& line = lines[i];
      const char* fault = nullptr;
      if (line.find('\t') != std::string::npos && file.path != "Makefile") fault = "a tab";
      if (!line.empty() && line.back() == '\r') fault = "a carriage return";
      if (!line.empty() && line.back() == ' ') fault = "a blank at the end";
      if (fault == nullptr) continue;
      complaints.push_back(place(file, i + 1) + fault);
      break;
    }
    if (!file.text.empty() && file.text.back() != '\n')
      complaints.push_back(place(file, lines.size()) + "the last line does not end");
  }
  return complaints;
}

// Words that only make sense on the machine or in the notes of their authors.
Complaints private_words(const std::vector<SourceFile>& files) {
  // Written in pieces, so that this file does not find itself.
  const std::string beside = std::string("../sha") + "red";
  const std::string notes = std::string("doss") + "ier";
  const std::set<std::string> roots{"home", "root", "work", "tmp", "Users"};
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::vector<std::string> lines = lines_of(file.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::string line = lines[i];
      std::transform(line.begin(), line.end(), line.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (line.find(notes) != std::string::npos)
        complaints.push_back(place(file, i + 1) + notes + ": readers do not have it");
      // The one place that looks beside the project, where there may be test problems of others.
      if (file.path != ".ci/run" && line.find(beside) != std::string::npos)
        complaints.push_back(place(file, i + 1) + beside + ": a path of one machine");

      // An absolute path: a slash that follows no path, one of the roots, a slash.
      line = lines[i];
      for (std::size_t at = line.find('/'); at != std::string::npos; at = line.find('/', at + 1)) {
        const bool absolute =
            at == 0 || (!in_name(line[at - 1]) &&
                        std::string("./-)}*").find(line[at - 1]) == std::string::npos);
        const std::size_t end = line.find('/', at + 1);
        if (!absolute || end == std::string::npos) continue;
        if (roots.count(line.substr(at + 1, end - at - 1)) > 0)
          complaints.push_back(place(file, i + 1) + line.substr(at, end - at + 1) +
                               ": a path of one machine");
      }
    }
  }
  return complaints;
}

}  // namespace

TEST_CASE("Comments and the insides of literals are not code", "[structure]") {
  CHECK(code_of("a; // sin(x)\nb; /* cos\n(x) */ c") == "a;          \nb;       \n       c");
  CHECK(code_of("f(\"sin(\\\"x\", '\"', 1'000); g") == "f(\"       \", ' ', 1'000); g");
  CHECK(code_of("R\"x(sin \")x\" + a") == "R\"         \" + a");
  CHECK(comments_of("a; // b\n\"// no\"\n// c\n") == std::vector<std::string>{" b", "", " c"});
  CHECK(line_at("a\nb\n", 2) == 2);
}

TEST_CASE("A call whose bits depend on the machine, chance or the locale is found", "[structure]") {
  const auto calls_in = [](const char* code) {
    return forbidden_calls({{"src/tumble/dynamics/a.cpp", code}}).size();
  };
  CHECK(calls_in("x = std :: atan2 (y, z);") == 1);
  CHECK(calls_in("return\n  pow (y, 2.0);") == 1);
  CHECK(calls_in("x = y.array().exp();") == 1);
  CHECK(calls_in("x = Eigen::AngleAxisd(a, n) * v;") == 1);
  CHECK(calls_in("std::unordered_map<int, int> m; std::hash<int> h; int x = rand();") == 3);
  CHECK(calls_in("auto t = std::chrono::steady_clock::now(); long  double x;") == 2);
  CHECK(calls_in("std::snprintf(text, 9, \"%g\", x); std::ostringstream out;") == 2);
  CHECK(calls_in("x = elementary::sin(y) + std::sqrt(z); say(\"std::sin(x)\"); sine(x);") == 0);
  CHECK(forbidden_calls({{"apps/a.cpp", "using std::chrono::steady_clock;"}}).empty());
  CHECK(forbidden_calls({{"src/a.cpp", "a\nb = std::sin(c);\n"}}) ==
        Complaints{"src/a.cpp:2: sin: C libraries differ in its last bit; call elementary::"});
}

TEST_CASE("A path of one machine and an untidy line are found", "[structure]") {
  CHECK(private_words({{"a.md", std::string("see /ho") + "me/someone\n"}}).size() == 1);
  CHECK(private_words({{"a.md", "homework/tmp/x and build/root/y\n"}}).empty());
  CHECK(untidy_text({{"a.cpp", "a\n\tb\n"}, {"b.cpp", "a \n"}, {"c.cpp", "a"}}).size() == 3);
}

TEST_CASE("The library calls nothing whose bits differ between machines", "[structure]") {
  const auto files = project_files();
  for (const char* folder : {"src/", "apps/", "live/", "examples/"})
    expect_none(forbidden_calls(code_in(files, folder)));
}

TEST_CASE("No source file is longer than 300 lines", "[structure]") {
  const auto files = project_files();
  for (const char* folder : {"src/", "apps/", "chapters/", "live/", "examples/"})
    expect_none(long_files(code_in(files, folder), 300));
  // What npm writes is not read by people.
  std::vector<SourceFile> page;
  for (const SourceFile& file : files)
    if (file.path.starts_with("live/page/")) page.push_back(file);
  CHECK_FALSE(page.empty());
  expect_none(long_files(page, 300));
}

TEST_CASE("No text has tabs, blank ends or words of one machine", "[structure]") {
  const auto files = project_files();
  expect_none(untidy_text(files));
  expect_none(private_words(files));
}

}  // namespace tumble::structure
