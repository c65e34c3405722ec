/// \file
/// \brief Words that may not stand in the sources, first on bad examples, then on the project.
#include "structure/words.hpp"

#include "support/catch.hpp"

namespace tumble::structure {
namespace {

std::size_t calls_in(const std::string& code) {
  return forbidden_calls({{"src/tumble/dynamics/a.cpp", code}}).size();
}

}  // namespace

TEST_CASE("Comments and the insides of literals are not code", "[structure]") {
  CHECK(code_of("a; // sin(x)\nb; /* cos\n(x) */ c") == "a;          \nb;       \n       c");
  CHECK(code_of("f(\"sin(\\\"x\", '\"', 1'000); g") == "f(\"       \", ' ', 1'000); g");
  CHECK(code_of("R\"x(sin \")x\" + a") == "R\"         \" + a");
  CHECK(comments_of("a; // b\n\"// no\"\n// c\n") == std::vector<std::string>{" b", "", " c"});
  CHECK(line_at("a\nb\n", 2) == 2);
}

TEST_CASE("A call whose last bit depends on the C library is found", "[structure]") {
  CHECK(calls_in("x = std::sin(y);") == 1);
  CHECK(calls_in("x = std :: atan2 (y, z);") == 1);
  CHECK(calls_in("auto f = &std::pow;") == 1);
  CHECK(calls_in("using std::exp;") == 1);
  CHECK(calls_in("x = cos(y);") == 1);
  CHECK(calls_in("return\n  pow (y, 2.0);") == 1);
  CHECK(calls_in("x = ::cos(y);") == 1);
  CHECK(calls_in("x = Eigen::exp(y);") == 1);
  CHECK(calls_in("x = y.array().exp();") == 1);
  CHECK(calls_in("x = Eigen::AngleAxisd(a, n) * v;") == 1);
  CHECK(calls_in("q = p.slerp(0.5, r);") == 1);
  CHECK(calls_in("x = std::fma(a, b, c) + hypot(a, b);") == 2);
  CHECK(forbidden_calls({{"src/a.cpp", "a\nb = std::sin(c);\n"}}) ==
        Complaints{"src/a.cpp:2: sin: C libraries differ in its last bit; call elementary::"});
}

TEST_CASE("A call that makes an order or a number depend on chance is found", "[structure]") {
  CHECK(calls_in("std::unordered_map<int, int> m;") == 1);
  CHECK(calls_in("std::hash<int> h;") == 1);
  CHECK(calls_in("int x = rand();") == 1);
  CHECK(calls_in("std::random_device{}();") == 1);
  CHECK(calls_in("std::uniform_real_distribution<double> u;") == 1);
  CHECK(calls_in("auto t = std::chrono::steady_clock::now();") == 1);
  CHECK(calls_in("long  double x;") == 1);
  CHECK(calls_in("std::ranges::sort(v);") == 1);
}

TEST_CASE("A call that writes or reads numbers by the locale is found outside of programs",
          "[structure]") {
  CHECK(calls_in("std::snprintf(text, 9, \"%g\", x);") == 1);
  CHECK(calls_in("x = std::strtod(text, nullptr) + std::stod(word);") == 2);
  CHECK(calls_in("std::ostringstream out;") == 1);
  CHECK(forbidden_calls({{"apps/a.cpp", "x = std::strtod(text, nullptr);"}}).empty());
}

TEST_CASE("Calls with the same bits everywhere are allowed", "[structure]") {
  CHECK(calls_in("x = elementary::sin(y) + tumble::elementary::atan2(y, z);") == 0);
  CHECK(calls_in("x = std::sqrt(y) + std::abs(y) + std::floor(y) + std::ldexp(y, 2);") == 0);
  CHECK(calls_in(
            "// std::sin(x)\nsay(\"std::sin(x)\"); my_sin(x); sine(x); cost(x); explain(x);") == 0);
  CHECK(calls_in("struct Brand { int rand_count; };") == 0);
  CHECK(forbidden_calls({{"src/tumble/math/elementary.hpp", "double sin(double x);"}}).empty());
  CHECK(forbidden_calls({{"src/tumble/math/elementary.cpp", "return std::sin(x);"}}).size() == 1);
  CHECK(forbidden_calls({{"src/tumble/a.cpp", "using std::chrono::steady_clock;"}}).size() == 1);
  CHECK(forbidden_calls({{"apps/a.cpp", "using std::chrono::steady_clock;"}}).empty());
}

TEST_CASE("A file over the limit is found", "[structure]") {
  CHECK(long_files({{"a.cpp", "1\n2\n3\n"}}, 3).empty());
  CHECK(long_files({{"a.cpp", "1\n2\n3\n4\n"}}, 3) == Complaints{"a.cpp:4: more than 3 lines"});
}

TEST_CASE("Tabs, blank ends and unfinished lines are found", "[structure]") {
  CHECK(untidy_text({{"a.cpp", "a\n"}, {"Makefile", "b:\n\tc\n"}}).empty());
  CHECK(untidy_text({{"a.cpp", "a\n\tb\n"}}) == Complaints{"a.cpp:2: a tab"});
  CHECK(untidy_text({{"a.cpp", "a\r\n"}}).size() == 1);
  CHECK(untidy_text({{"a.cpp", "a \n"}}).size() == 1);
  CHECK(untidy_text({{"a.cpp", "a"}}).size() == 1);
}

TEST_CASE("A path of one machine is found", "[structure]") {
  const std::string home = std::string("/ho") + "me/someone";
  CHECK(private_words({{"a.md", "see " + home + "\n"}}) ==
        Complaints{std::string("a.md:1: /ho") + "me/: a path of one machine"});
  CHECK(private_words({{"a.md", std::string("../sha") + "red/data\n"}}).size() == 1);
  CHECK(private_words({{".ci/run", std::string("../sha") + "red/data\n"}}).empty());
  CHECK(private_words({{"a.md", "homework/tmp/x and build/root/y\n"}}).empty());
}

TEST_CASE("The library calls nothing whose bits differ between machines", "[structure]") {
  const auto files = project_files();
  Complaints complaints;
  for (const char* folder : {"src/", "apps/", "live/", "examples/"}) {
    const auto more = forbidden_calls(code_in(files, folder));
    complaints.insert(complaints.end(), more.begin(), more.end());
  }
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("No source file is longer than 300 lines", "[structure]") {
  const auto files = project_files();
  Complaints complaints;
  for (const char* folder : {"src/", "apps/", "chapters/", "live/", "examples/"}) {
    const auto more = long_files(code_in(files, folder), 300);
    complaints.insert(complaints.end(), more.begin(), more.end());
  }
  // What npm writes is not read by people.
  std::vector<SourceFile> page;
  for (const SourceFile& file : files)
    if (file.path.starts_with("live/page/")) page.push_back(file);
  CHECK_FALSE(page.empty());
  const auto more = long_files(page, 300);
  complaints.insert(complaints.end(), more.begin(), more.end());
  INFO(joined(complaints));
  CHECK(complaints.empty());

  // Tests may be long, but their length should be known.
  const Complaints long_tests = long_files(code_in(files, "verification/"), 300);
  if (!long_tests.empty()) WARN("long tests:" << joined(long_tests));
}

TEST_CASE("No text has tabs, blank ends or words of one machine", "[structure]") {
  const auto files = project_files();
  Complaints complaints = untidy_text(files);
  const Complaints more = private_words(files);
  complaints.insert(complaints.end(), more.begin(), more.end());
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

}  // namespace tumble::structure
