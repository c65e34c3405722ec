/// \file
/// \brief The direction of includes: layers, licences, the form of headers.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <regex>

namespace tumble::structure {
namespace {

struct Include {
  std::size_t line = 0;
  std::string target;  // as written between the quotes or angles
};

std::vector<Include> includes_of(const SourceFile& file) {
  static const std::regex form(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> found;
  const std::vector<std::string> lines = lines_of(file.text);
  std::smatch match;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].find('#') != std::string::npos && std::regex_search(lines[i], match, form))
      found.push_back({i + 1, match[1]});
  return found;
}

// "src/tumble/math/x.hpp" and "tumble/math/x.hpp" give "math"; "tumble/techniques.hpp" gives
// "techniques"; outside the library, the first folder: "bench".
std::string folder_of(std::string path) {
  if (path.starts_with("src/")) path.erase(0, 4);
  if (path.starts_with("tumble/")) path.erase(0, 7);
  return path.substr(0, path.find_first_of("/."));
}

// Height of a folder of the library; nothing for one that is not known.
std::optional<int> height_of(const std::string& folder) {
  static const std::map<std::string, int> heights{{"base", 0},
                                                  {"math", 1},
                                                  {"geometry", 2},
                                                  {"dynamics", 3},
                                                  {"contact", 4},
                                                  {"basic_colliding", 5},
                                                  {"lcp_solvers", 5},
                                                  {"analytic_lcp", 5},
                                                  {"contact_patches", 5},
                                                  {"contact_damped", 5},
                                                  {"impulse_damped", 5},
                                                  {"geometric_stability", 5},
                                                  {"timewarp", 5},
                                                  {"filtering", 5},
                                                  {"exterior_rotation", 5},
                                                  {"previous_work", 5},
                                                  {"fracture", 5},
                                                  {"techniques", 6},
                                                  {"technique_by_name", 6},
                                                  {"scenes", 6},
                                                  {"record", 6},
                                                  {"pictures", 6},
                                                  {"tumble", 7}};
  const auto found = heights.find(folder);
  if (found == heights.end()) return std::nullopt;
  return found->second;
}

bool in_library(const std::string& path) { return path.starts_with("src/"); }

// Walks from a folder along its includes; true if the walk comes back to where it began.
bool returns_to(const std::map<std::string, std::set<std::string>>& edges, const std::string& start,
                const std::string& at, std::set<std::string>& seen) {
  const auto next = edges.find(at);
  if (next == edges.end()) return false;
  for (const std::string& folder : next->second) {
    if (folder == start) return true;
    if (seen.insert(folder).second && returns_to(edges, start, folder, seen)) return true;
  }
  return false;
}

// base < math < geometry < dynamics < contact < chapters' folders < techniques, scenes, record, pictures <
// apps, chapters, live, verification, bench. Tests may include the experiments of chapters.
Complaints upward_includes(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::optional<int> here = height_of(folder_of(file.path));
    if (in_library(file.path) && !here)
      complaints.push_back(place(file, 1) + "no layer is known for this folder");
    for (const Include& include : includes_of(file)) {
      const bool of_library = include.target.starts_with("tumble/");
      const std::optional<int> there = height_of(folder_of(include.target));
      const std::string said = place(file, include.line) + "includes " + include.target;
      if (of_library && !there) complaints.push_back(said + ", which is in no known layer");
      if (in_library(file.path) && here && of_library && there && *there > *here)
        complaints.push_back(said + ", which is in a higher layer");
      if (in_library(file.path) && !of_library && include.target.find(".hpp") != std::string::npos)
        complaints.push_back(said + ", which is no header of the library");

      // Outside the library, only tests see another folder's files: the experiments.
      static const std::regex programs("^(apps|bench|live|verification|support|structure)/");
      const bool of_programs = std::regex_search(include.target, programs);
      if (of_programs && !file.path.starts_with("verification/"))
        complaints.push_back(said + ", which belongs to another program");
    }
  }
  return complaints;
}

// Names of chapters and of their ideas in the layers below them, comments included; in base also ids of errata.
Complaints chapters_named_below(const std::vector<SourceFile>& files) {
  static const std::regex chapters(
      "basic_colliding|timewarp|filtering|exterior_rotation|geometric_stability|damped|analytic_"
      "lcp|"
      "lcp_solvers|chatter|freez",
      std::regex::icase);
  static const std::regex errata("\\b(T|F|D|C|RK|RC|DM|X|G)[1-9][0-9]?\\b");
  const int lowest_chapter = *height_of("filtering");
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::optional<int> here = height_of(folder_of(file.path));
    if (!in_library(file.path) || !here || *here >= lowest_chapter) continue;
    const std::vector<std::string> lines = lines_of(file.text);
    std::smatch match;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (std::regex_search(lines[i], match, chapters) ||
          (*here == 0 && std::regex_search(lines[i], match, errata)))
        complaints.push_back(place(file, i + 1) + match[0].str() + ": belongs to a chapter");
  }
  return complaints;
}

// Folders of the same height that include one another in a circle.
Complaints include_circles(const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> edges;
  for (const SourceFile& file : files) {
    if (!in_library(file.path)) continue;
    const std::string here = folder_of(file.path);
    for (const Include& include : includes_of(file)) {
      const std::string there = folder_of(include.target);
      if (include.target.starts_with("tumble/") && there != here) edges[here].insert(there);
    }
  }
  Complaints complaints;
  for (const auto& [folder, unused] : edges) {
    std::set<std::string> seen;
    if (returns_to(edges, folder, folder, seen))
      complaints.push_back("src/tumble/" + folder + " includes itself by way of other folders");
  }
  return complaints;
}

// Includes that would bring a licence or a dependency where it must not be.
Complaints misplaced_dependencies(const std::vector<SourceFile>& files) {
  struct Rule {
    std::regex included;
    std::regex allowed;  // paths in the project
  };
  static const std::vector<Rule> rules{
      {std::regex("^gsl/"), std::regex("^(chapters/|verification/.*gsl)")},
      {std::regex("^catch2/"), std::regex("^verification/support/")},
      {std::regex("^toml(\\+\\+|plusplus)"), std::regex("^(src/tumble/scenes|chapters)/.*\\.cpp$")},
      {std::regex("^CLI"), std::regex("^apps/")},
      {std::regex("gltf"), std::regex("^src/tumble/pictures/.*\\.cpp$")},
      {std::regex("^(ode/|bullet|BulletC|btBullet|LinearMath|mujoco|dart/|siconos)"),
       std::regex("^bench/")}};
  Complaints complaints;
  for (const SourceFile& file : files) {
    for (const Include& include : includes_of(file)) {
      for (const Rule& rule : rules) {
        const bool covered = !include.target.starts_with("tumble/") &&
                             std::regex_search(include.target, rule.included);
        if (covered && !std::regex_search(file.path, rule.allowed))
          complaints.push_back(place(file, include.line) + include.target + " must not be here");
      }
    }
  }
  return complaints;
}

Complaints unnamed_files(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::vector<std::string> lines = lines_of(file.text);
    if (lines.size() < 2 || lines[0] != "/// \\file" || !lines[1].starts_with("/// \\brief "))
      complaints.push_back(place(file, 1) + "begins without /// \\file and /// \\brief");
    if (file.path.find(".hpp") == std::string::npos) continue;
    const std::string code = code_of(file.text);
    const std::size_t first = code.find_first_not_of(" \n");
    if (first == std::string::npos || code.compare(first, 12, "#pragma once") != 0)
      complaints.push_back(place(file, 1) + "does not begin with #pragma once");
  }
  return complaints;
}

}  // namespace

TEST_CASE(
    "Includes that point upwards, circles, misplaced dependencies and unnamed files are found",
    "[structure]") {
  const auto upward = [](const char* path, const char* included) {
    return upward_includes({{path, std::string("#include \"") + included + "\"\n"}}).size();
  };
  CHECK(upward("src/tumble/math/a.cpp", "tumble/contact/graph.hpp") == 1);
  CHECK(upward("src/tumble/math/a.cpp", "support/catch.hpp") == 2);
  CHECK(upward("apps/a.cpp", "live/session.hpp") == 1);
  CHECK(upward("src/tumble/utilities/a.cpp", "tumble/base/error.hpp") == 1);
  CHECK(upward("src/tumble/timewarp/b.cpp", "tumble/basic_colliding/x.hpp") == 0);
  const SourceFile on{"src/tumble/filtering/b.hpp", "#include \"tumble/timewarp/c.hpp\"\n"};
  const SourceFile back{"src/tumble/timewarp/d.hpp", "#include \"tumble/filtering/b.hpp\"\n"};
  CHECK(include_circles({on, back}).size() == 2);
  CHECK(chapters_named_below({{"src/tumble/dynamics/a.hpp", "// set by FreezeOnChatter\n"},
                              {"src/tumble/base/b.cpp", "x(\"DM3\");\n"}})
            .size() == 2);
  CHECK(misplaced_dependencies({{"src/tumble/math/a.cpp", "#include <gsl/gsl_math.h>\n"}}).size() ==
        1);
  CHECK(unnamed_files({{"a.hpp", "#pragma once\n"}}).size() == 1);
}

TEST_CASE("The project's includes point downwards", "[structure]") {
  const auto files = project_files();
  for (const char* folder :
       {"src/", "apps/", "chapters/", "verification/", "bench/", "examples/", "live/"})
    expect_none(upward_includes(code_in(files, folder)));
}

TEST_CASE("The layers of the library name no chapter", "[structure]") {
  expect_none(chapters_named_below(code_in(project_files(), "src/")));
}

TEST_CASE("No folder of the library includes itself by way of others", "[structure]") {
  expect_none(include_circles(code_in(project_files(), "src/")));
}

TEST_CASE("Every dependency is on its side of the licence line", "[structure]") {
  expect_none(misplaced_dependencies(code_in(project_files(), "")));
}

TEST_CASE("Every source file says what it is", "[structure]") {
  expect_none(unnamed_files(code_in(project_files(), "")));
}

}  // namespace tumble::structure
