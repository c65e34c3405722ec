/// \file
/// \brief Layers, licences and the form of headers, first on bad examples, then on the project.
#include "structure/includes.hpp"

#include "support/catch.hpp"

namespace tumble::structure {

TEST_CASE("An include of a higher layer is found", "[structure]") {
  CHECK(
      upward_includes({{"src/tumble/math/a.cpp", "#include \"tumble/contact/graph.hpp\"\n"},
                       {"src/tumble/base/b.hpp", "\n#  include <tumble/math/dense.hpp>\n"},
                       {"src/tumble/contact/c.hpp", "#include \"tumble/timewarp/heap.hpp\"\n"},
                       {"src/tumble/timewarp/d.cpp", "#include \"tumble/techniques.hpp\"\n"}}) ==
      Complaints{
          "src/tumble/math/a.cpp:1: includes tumble/contact/graph.hpp, which is in a higher layer",
          "src/tumble/base/b.hpp:2: includes tumble/math/dense.hpp, which is in a higher layer",
          "src/tumble/contact/c.hpp:1: includes tumble/timewarp/heap.hpp, which is in a higher "
          "layer",
          "src/tumble/timewarp/d.cpp:1: includes tumble/techniques.hpp, which is in a higher "
          "layer"});
}

TEST_CASE("An include of a program's file is found", "[structure]") {
  CHECK(upward_includes({{"src/tumble/math/a.cpp", "#include \"support/catch.hpp\"\n"}}).size() ==
        2);
  CHECK(upward_includes({{"chapters/x/a.cpp", "#include \"bench/clock.hpp\"\n"}}).size() == 1);
  CHECK(upward_includes({{"live/a.cpp", "#include \"apps/request.hpp\"\n"}}).size() == 1);
  CHECK(upward_includes({{"apps/a.cpp", "#include \"live/session.hpp\"\n"}}).size() == 1);
  CHECK(upward_includes({{"src/tumble/math/a.cpp", "#include \"basic/run.hpp\"\n"}}).size() == 1);
}

TEST_CASE("A folder without a layer is found", "[structure]") {
  CHECK(upward_includes({{"src/tumble/utilities/a.cpp", ""}}).size() == 1);
  CHECK(upward_includes({{"bench/a.cpp", "#include \"tumble/utilities/a.hpp\"\n"}}).size() == 1);
}

TEST_CASE("Includes of the same or a lower layer are allowed", "[structure]") {
  CHECK(upward_includes(
            {{"src/tumble/contact/a.cpp",
              "#include \"tumble/contact/graph.hpp\"\n#include \"tumble/base/error.hpp\"\n"
              "#include <vector>\n"},
             {"src/tumble/timewarp/b.cpp", "#include \"tumble/basic_colliding/x.hpp\"\n"},
             {"verification/math/c_test.cpp", "#include \"support/catch.hpp\"\n"}})
            .empty());
}

TEST_CASE("Folders that include one another are found", "[structure]") {
  const SourceFile there{"src/tumble/timewarp/a.cpp", "#include \"tumble/filtering/b.hpp\"\n"};
  const SourceFile on{"src/tumble/filtering/b.hpp", "#include \"tumble/analytic_lcp/c.hpp\"\n"};
  const SourceFile back{"src/tumble/analytic_lcp/c.hpp", "#include \"tumble/timewarp/d.hpp\"\n"};
  CHECK(include_circles({there, on}).empty());
  CHECK(include_circles({there, on, back}).size() == 3);
}

TEST_CASE("The name of a chapter in a layer below it is found", "[structure]") {
  CHECK(chapters_named_below({{"src/tumble/dynamics/a.hpp", "// a\n// set by FreezeOnChatter\n"},
                              {"src/tumble/base/b.cpp", "x(\"DM3\");\n"}}) ==
        Complaints{"src/tumble/dynamics/a.hpp:2: Freez: belongs to a chapter",
                   "src/tumble/base/b.cpp:1: DM3: belongs to a chapter"});
  CHECK(chapters_named_below({{"src/tumble/filtering/a.hpp", "// chatter\n"},
                              {"src/tumble/dynamics/b.hpp", "// undo a collision: X1\n"},
                              {"chapters/filtering/c.cpp", "// chatter\n"}})
            .empty());
}

TEST_CASE("A dependency on the wrong side of the licence line is found", "[structure]") {
  CHECK(misplaced_dependencies({{"src/tumble/math/a.cpp", "#include <gsl/gsl_math.h>\n"},
                                {"apps/b.cpp", "#include <catch2/catch.hpp>\n"},
                                {"src/tumble/scenes/c.hpp", "#include <toml++/toml.h>\n"},
                                {"chapters/x/c.hpp", "#include <toml++/toml.h>\n"},
                                {"verification/x/c_test.cpp", "#include <toml++/toml.h>\n"},
                                {"src/tumble/record/d.cpp", "#include <CLI/CLI.hpp>\n"},
                                {"apps/e.cpp", "#include <tiny_gltf.h>\n"},
                                {"verification/math/f_test.cpp", "#include <gsl/gsl_fft.h>\n"},
                                {"verification/math/g_test.cpp", "#include <ode/ode.h>\n"}})
            .size() == 9);
  CHECK(misplaced_dependencies({{"chapters/x/a.cpp", "#include <gsl/gsl_math.h>\n"},
                                {"src/tumble/scenes/c.cpp", "#include <toml++/toml.h>\n"},
                                {"chapters/x/c.cpp", "#include <toml++/toml.h>\n"},
                                {"verification/math/f_gsl_test.cpp", "#include <gsl/gsl_fft.h>\n"}})
            .empty());
}

TEST_CASE("A file without name and purpose is found", "[structure]") {
  const std::string good = "/// \\file\n/// \\brief What it is.\n#pragma once\n";
  CHECK(unnamed_files({{"a.hpp", good}, {"b.cpp", good}}).empty());
  CHECK(unnamed_files({{"a.hpp", "#pragma once\n"}}).size() == 1);
  CHECK(unnamed_files({{"a.hpp", "/// \\file\n/// \\brief x\n#include <b>\n#pragma once\n"}})
            .size() == 1);
}

TEST_CASE("The project's includes point downwards", "[structure]") {
  const auto files = project_files();
  Complaints complaints;
  for (const char* folder :
       {"src/", "apps/", "chapters/", "verification/", "bench/", "examples/", "live/"}) {
    const auto more = upward_includes(code_in(files, folder));
    complaints.insert(complaints.end(), more.begin(), more.end());
  }
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("The layers of the library name no chapter", "[structure]") {
  const Complaints complaints = chapters_named_below(code_in(project_files(), "src/"));
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("No folder of the library includes itself by way of others", "[structure]") {
  const Complaints complaints = include_circles(code_in(project_files(), "src/"));
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("Every dependency is on its side of the licence line", "[structure]") {
  const Complaints complaints = misplaced_dependencies(code_in(project_files(), ""));
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

TEST_CASE("Every source file says what it is", "[structure]") {
  const Complaints complaints = unnamed_files(code_in(project_files(), ""));
  INFO(joined(complaints));
  CHECK(complaints.empty());
}

}  // namespace tumble::structure
