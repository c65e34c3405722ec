/// \file
/// \brief Choosing a technique: the problems' closed forms, the claim, and what the page says of it.
#include "choosing/experiments.hpp"
#include "choosing/problems.hpp"
#include "driver/check.hpp"
#include "driver/csv.hpp"
#include "driver/quick.hpp"
#include "support/test.hpp"

#include <filesystem>

using namespace tumble::chapters;

namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(TUMBLE_SOURCE_DIR) / "chapters" / "choosing";

// What make figures compares the full runs with.
class Written {
 public:
  [[nodiscard]] bool has(const std::string& quantity) const {
    for (const DrawnFigure& figure : figures_)
      for (const CheckedNumber& number : figure.numbers)
        if (number.quantity == quantity) return true;
    return false;
  }
  [[nodiscard]] double of(const std::string& quantity) const {
    for (const DrawnFigure& figure : figures_)
      for (const CheckedNumber& number : figure.numbers)
        if (number.quantity == quantity) return number.expected;
    throw std::runtime_error("expected.csv has no " + quantity);
  }
  [[nodiscard]] double of(const std::string& technique, const std::string& what) const {
    return of(number_name(technique, what));
  }

 private:
  std::vector<DrawnFigure> figures_ = expected_figures({kFolder / "expected.csv"});
};

PlayedTechnique played(const std::string& name) {
  for (const PlayedTechnique& one : compared_techniques())
    if (one.name == name) return one;
  throw std::runtime_error("not compared: " + name);
}

// The rows of the page's tables about a technique, by their first cell.
std::vector<std::string> rows_of(const std::string& page, const std::string& technique) {
  const std::string begin = "\n| `" + technique + "` |";
  std::vector<std::string> rows;
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1))
    rows.push_back(page.substr(at + 1, page.find('\n', at + 1) - at - 1));
  return rows;
}

}  // namespace

TEST_CASE("Every technique of the library is compared, and each once", "[unit][choosing]") {
  std::set<std::string> names;
  for (const PlayedTechnique& one : compared_techniques()) names.insert(one.name);
  CHECK(names.size() == compared_techniques().size());
  for (const TechniqueRecipe& recipe : technique_library()) {
    INFO(recipe.name);
    CHECK(names.count(std::string(recipe.name)) == 1);
  }
}

TEST_CASE("Every technique has its row in each table of the page on choosing", "[unit][choosing]") {
  // A technique that is new to the library fails here until the page has it.
  const std::string page = read_file(kFolder / "page.md");
  for (const TechniqueRecipe& recipe : technique_library()) {
    INFO(recipe.name);
    const std::vector<std::string> rows = rows_of(page, std::string(recipe.name));
    CHECK(rows.size() == 4);
    for (const std::string& row : rows) CHECK(row.find("| |") == std::string::npos);
  }
}

TEST_CASE("A number in a technique's row of the page is measured with that technique",
          "[unit][choosing]") {
  const std::string page = read_file(kFolder / "page.md");
  const std::set<std::string> figures = {"claim_6_3_2a_work", "choose_rest", "choose_cost"};
  for (const PlayedTechnique& one : compared_techniques()) {
    for (const std::string& row : rows_of(page, one.name)) {
      for (std::size_t at = row.find("<!--"); at != std::string::npos;
           at = row.find("<!--", at + 1)) {
        const std::string comment = row.substr(at, row.find("-->", at) - at);
        const std::string figure = comment.substr(5, comment.find(':') - 5);
        if (figures.count(figure) == 0) continue;
        INFO(comment);
        CHECK_THAT(comment, Contains(": " + one.name + ": "));
      }
    }
  }
}

TEST_CASE("A number that was measured with a technique stands in its row of the page",
          "[unit][choosing]") {
  const std::string page = read_file(kFolder / "page.md");
  for (const DrawnFigure& figure : expected_figures({kFolder / "expected.csv"})) {
    for (const CheckedNumber& number : figure.numbers) {
      const std::size_t colon = number.quantity.find(": ");
      if (colon == std::string::npos) continue;
      INFO(number.quantity);
      CHECK_THAT(page, Contains("<!-- " + figure.name + ": " + number.quantity + " -->"));
    }
  }
}

TEST_CASE("The paths that techniques are compared with are the closed forms", "[exact][choosing]") {
  const double g = 9.81;
  const Problem bounce = bounce_problem();
  const double fall = std::sqrt(2.0 / g);  // [s] from 1 m
  CHECK(bounce.exact(0.0) == 1.0);
  CHECK(std::abs(bounce.exact(fall)) < 1e-15);                  // [m] rounding
  CHECK(std::abs(bounce.exact(1.5 * fall) - 0.25) < 1e-14);     // e² of the height
  CHECK(std::abs(bounce.exact(2.25 * fall) - 0.0625) < 1e-14);  // and again
  CHECK(bounce.frames * kComparedEvery > 2.5 * fall);           // three impacts
  const Problem slide = slide_problem();
  CHECK(std::abs(slide.exact(10.0) - 9.0 / (2.0 * 0.3 * g)) < 1e-15);  // v²/(2 μ g)
  CHECK(std::abs(slide.exact(10.0) - slide.scale) < 1e-15);
  CHECK(slide.frames * kComparedEvery > 3.0 / (0.3 * g));  // it has stopped
  const Problem rock = rock_problem();
  CHECK(std::abs(rock.exact(0.0) - rock.scale) < 1e-14);
  // [s] a quarter period by elliptic integrals, evaluated apart; 12 digits were written down
  CHECK(std::abs(rock.exact(0.490864457850)) < 1e-11);
  CHECK(rock.frames * kComparedEvery < 0.490864457850);
}

TEST_CASE("Everything that a report counts as work is counted once", "[unit][choosing]") {
  StepReport report{.iterations = 1,
                    .pivots = 10,
                    .impulses = 100,
                    .pair_tests = 1000,
                    .integrations = 10000,
                    .searches = 100000};
  CHECK(work_of(report) == 111111.0);
  CHECK(work_of(report, 10.0) == 111201.0);
}

TEST_CASE("A pair changes places if each of the two is ahead somewhere", "[exact][choosing]") {
  const double never = kInfinity;
  CHECK(share_that_changes_places({{1, 1, 1}, {2, 2, 2}}) == 0.0);
  CHECK(share_that_changes_places({{1, 3, 1}, {2, 2, 2}}) == 1.0);
  CHECK(share_that_changes_places({{1, never, 1}, {2, never, 2}}) == 0.0);
  CHECK(share_that_changes_places({{1, never, 1}, {never, 1, 1}}) == 1.0);
  CHECK(share_that_changes_places({{never, never, never}, {never, never, never}}) == 0.0);
  CHECK(share_that_changes_places({{1, 3, 1}, {2, 2, 2}, {3, 4, 5}}) == 1.0 / 3.0);
}

TEST_CASE("Smaller steps bring time stepping nearer to a slide, a bounce and a rocking block",
          "[reference][choosing]") {
  for (const Problem& problem : closed_problems()) {
    INFO(problem.name);
    const double coarse = attempt(problem, played("time_stepping"), 2).error;
    const double fine = attempt(problem, played("time_stepping"), 16).error;
    CHECK(fine < 0.5 * coarse);  // first order would be an eighth
    CHECK(fine > 0.0);
  }
}

TEST_CASE("Stacks that stand apart have five boxes each and touch no other stack",
          "[exact][choosing]") {
  for (const int boxes : {10, 100, 1000}) {
    const Scene scene = separate_stacks(boxes);
    CHECK(static_cast<int>(scene.boxes.size()) == boxes);
    CHECK_NOTHROW(build_world(scene));
  }
}

TEST_CASE("A technique that refuses a scene has no cost", "[unit][choosing]") {
  CHECK(
      std::isnan(step_cost(separate_stacks(10), PlayedTechnique{"penalty", {"stiffness=1e9"}}, 1)));
  // Each box is advanced, and more.
  CHECK(step_cost(separate_stacks(10), played("contact_damped"), 1) > 10.0);
}

TEST_CASE(
    "A box tips at the angle of its diagonal under friction, and not where damping stands for it",
    "[exact][choosing]") {
  CHECK(kTippingSlope == near(26.565051177, 1e-9));  // [deg] arctan 1/2
  for (const char* name : {"contact_damped", "analytic", "time_stepping", "impulse"}) {
    INFO(name);
    CHECK(tips_at_limit(played(name), 0.1));
  }
  CHECK_FALSE(tips_at_limit(played("damped"), 30.0));
}

TEST_CASE("A pile that falls has no speed at rest, and one that stands has", "[unit][choosing]") {
  const Scene pair = make_scene("stack", {"count=2"});
  const PileRun stands = pile_run(pair, played("contact_damped"), 0.6);
  CHECK(stands.stands);
  CHECK(stands.speed < 1e-6);  // [m/s] measured: 0
  Scene high = pair;
  for (SceneBox& box : high.boxes) box.position_w.y() += 5.0;
  const PileRun falls = pile_run(high, played("contact_damped"), 0.6);
  CHECK_FALSE(falls.stands);
  CHECK(std::isnan(falls.speed));
}

TEST_CASE("The advice of the page agrees with the numbers", "[unit][choosing]") {
  // make figures holds these numbers to those of a full run; here they are held to the advice.
  const Written numbers;
  const auto others = [](const std::string& than) {
    std::vector<std::string> names;
    for (const PlayedTechnique& one : compared_techniques())
      if (one.name != than) names.push_back(one.name);
    return names;
  };
  SECTION("contact_damped for piles") {
    CHECK(numbers.of("contact_damped", "chatter in a stack") < 0.01);            // [mm]
    CHECK(numbers.of("contact_damped", "overlap in a stack") < 0.01);            // [mm]
    CHECK(numbers.of("contact_damped", "overlap under a load of 1000") < 0.01);  // [mm]
    // Ten times the boxes in one island, and no more than twelve times the work.
    CHECK(numbers.of("contact_damped", "work of a step, 990 boxes in a pyramid") <
          12.0 * numbers.of("contact_damped", "work of a step, 105 boxes in a pyramid"));
  }
  SECTION("analytic for motion that has to be right") {
    CHECK(numbers.of("analytic", "error of slide at 1/60 s") < 1e-6);   // [%]
    CHECK(numbers.of("analytic", "error of rock at 1/60 s") < 0.1);     // [%]
    CHECK(numbers.of("analytic", "error of bounce at 1/60 s") < 0.01);  // [%]
  }
  SECTION("time_stepping rests to rounding and costs more") {
    CHECK(numbers.of("time_stepping", "speed in a stack at rest") < 1e-6);  // [mm/s]
    const std::string slide = "work of slide for an error of one per cent";
    CHECK(numbers.of("time_stepping", slide) > numbers.of("contact_damped", slide));
  }
  SECTION("a timewarp for bodies in flight, not for piles") {
    const std::string bounce = "work of bounce for an error of one per cent";
    for (const std::string& name : others("timewarp_full"))
      if (numbers.has(number_name(name, bounce)))
        CHECK(numbers.of("timewarp_full", bounce) < numbers.of(name, bounce));
    for (const char* name :
         {"timewarp_simple", "timewarp_safer", "timewarp_swept", "timewarp_full", "basic"})
      CHECK_FALSE(numbers.has(number_name(name, "speed in a stack at rest")));
  }
  SECTION("basic for impacts") {
    CHECK(numbers.of("basic", "error of bounce at 1/60 s") < 0.01);  // [%]
    CHECK(numbers.of("basic", "speed of a box at rest") > 10.0);     // [mm/s]
  }
  SECTION("damped is no friction") {
    CHECK(numbers.of("damped", "error of slide at 1/60 s") > 50.0);  // [%]
    CHECK_FALSE(numbers.has("damped: slope from which a box tips"));
  }
  SECTION("glued holds joined bodies and nothing else") {
    CHECK(numbers.of("glued", "error of rock at 1/60 s") < 1e-3);   // [%]
    CHECK(numbers.of("glued", "error of slide at 1/60 s") > 50.0);  // [%]
  }
}
