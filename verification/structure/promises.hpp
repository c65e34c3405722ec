/// \file
/// \brief Promises of docstrings, tests and README, compared with the project.
#pragma once

#include "structure/source_tree.hpp"

namespace tumble::structure {

/// A test case as its source writes it.
struct TestCase {
  std::string path;               ///< the file
  std::size_t line{};             ///< where it begins
  std::string name;               ///< the sentence
  std::vector<std::string> tags;  ///< without brackets
};

/// Reads the test cases out of their sources.
/// \param files C++ files
/// \return every TEST_CASE and TEMPLATE_TEST_CASE
std::vector<TestCase> test_cases(const std::vector<SourceFile>& files);

/// Sentences in \\verified{...} that are no test's name.
/// \param files  C++ files with docstrings
/// \param tests  all tests
/// \return a complaint for each
Complaints unkept_promises(const std::vector<SourceFile>& files,
                           const std::vector<TestCase>& tests);

/// Tests that claims, errata and pages name, lines `test = "sentence"` and `- "sentence"`, and that do not exist.
/// \param files  claims.toml, errata.toml, and page.md or measured.md of the chapters
/// \param tests  all tests
/// \return a complaint for each
Complaints unkept_records(const std::vector<SourceFile>& files, const std::vector<TestCase>& tests);

/// Tests that do not say which rung of the ladder they are on: unit, exact, reference, claims,
/// determinism, structure. Sanitizers and equal-bits builds choose by these.
/// \param tests all tests
/// \return a complaint for each
Complaints tests_without_rung(const std::vector<TestCase>& tests);

/// Whether a file defines tolerances.
/// \param file  any
/// \return true for a `tolerances.hpp` of the library
bool defines_tolerances(const SourceFile& file);

/// Small numbers in code outside of the files that define tolerances: decimal literals above 0 and below
/// 1e-2. Named ones (constexpr) and the ranges of options (add_number) are allowed.
/// \param files  C++ files of the library
/// \return a complaint for each
Complaints bare_small_literals(const std::vector<SourceFile>& files);

/// Constants of the files of tolerances that no other file uses.
/// \param files  C++ files of the library; constants are those of `inline constexpr double name = ...`
/// \return a complaint for each
Complaints unused_tolerances(const std::vector<SourceFile>& files);

/// Commands `make x` in a text that the Makefile does not have.
/// \param text      README.md, for example
/// \param makefile  the Makefile
/// \return a complaint for each
Complaints unknown_commands(const SourceFile& text, const SourceFile& makefile);

}  // namespace tumble::structure
