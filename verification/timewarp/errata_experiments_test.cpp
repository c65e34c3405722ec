/// \file
/// \brief The errata T1 to T10 and F1 to F9, each with both of its numbers.
#include "driver/common_numbers.hpp"
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

namespace {

constexpr double kRounding = 1e-12;  // of some ten operations on numbers up to 10
constexpr double kTime = 2e-6;       // [s] two searches, each to a microsecond
constexpr double kPlace = 1e-5;      // [m] what cubes with up to 5 m/s fly meanwhile
constexpr int kCap = 50;             // [-] that of --quick

double number(const std::string& name) {
  return FigureUnderTest(name.front() == 'T' ? "errata_timewarp_simple" : "errata_timewarp_safer")
      .number(name);
}

// Both numbers of an erratum, with the closed forms.
void check_pair(const std::string& what, const std::string& printed, double failure,
                const std::string& reading, double mended, double tolerance) {
  INFO(what);
  CHECK(number(what + ", " + printed) == near(failure).margin(tolerance));
  CHECK(number(what + ", " + reading) == near(mended).margin(tolerance));
}

}  // namespace

TEST_CASE("A collision in each turn of the loop throws a cube a metre too far",
          "[claims][timewarp]") {
  // It has turned round at the start of the frame and not at its middle: 2 + 1 and 2 - 1/2 + 1/2.
  check_pair("T1: place of the second of two cubes", "each turn of the loop collides", 3.0,
             "both cubes fly before they collide", 2.0, kPlace);
  // The second impulse undoes the first: they fly through each other.
  CHECK(number("T1: place of the first of two cubes, each turn collides, separating cubes too") ==
        near(1.0).margin(kPlace));
}

TEST_CASE("One counter for two loops leaves the second cube where it was", "[claims][timewarp]") {
  // It flies back from 2 m for half a second, and has not flown there before.
  check_pair("T2: place of the second of two cubes", "one counter for both loops", 2.5,
             "two loops one after the other", 2.0, kPlace);
}

TEST_CASE("A cube asked before the other has flown is made valid up to the end of the frame",
          "[claims][timewarp]") {
  check_pair("T3: time up to which two cubes are valid", "one asked before the other flies", 1.0,
             "asked when both have flown", 0.25, kTime);
}

TEST_CASE("A search without valid times finds the second of three collisions too early",
          "[claims][timewarp]") {
  // 0.9 m at 3 m/s from the start; or from 0.25 s on, when the third cube has come 0.25 m nearer.
  check_pair("T4: time of the second collision in a row", "searched as if all began together", 0.3,
             "searched from the valid times", 0.25 + 0.65 / 3.0, kTime);
}

TEST_CASE("Three cubes of the simple timewarp change places unless their ways are searched",
          "[claims][timewarp]") {
  // At the end they are at 3 and 1.8 m. Else they meet at 4/15 s, the third at 2.533 m, then at 2 m/s;
  // the second gives what it has got to the first and rests where they meet, at 1.5 m.
  const double meet = 0.25 + 0.05 / 3.0;
  check_pair("T5: third cube ahead of the second", "end of the frame tested", -1.2,
             "way there searched", 2.8 - meet + 2.0 * (1.0 - meet) - 1.5, kPlace);
}

TEST_CASE("The simple timewarp does not get past a landing unless short hops end it",
          "[claims][timewarp]") {
  // The n-th hop begins with 0.05 / 2^n m/s; the first one that lasts below 1 µs is the 14th.
  const double hops = std::ceil(std::log2(0.05 / (0.5 * kGravity * 1e-6)));
  check_pair("T6: passes of the loop for a landing", "nothing ends them, until a cap", kCap,
             "hops below the resolution end them", hops, 0.0);
}

TEST_CASE("Two cubes of the simple timewarp that stick where they overlap collide for ever",
          "[claims][timewarp]") {
  check_pair("T7: passes of the loop for one collision", "overlapping end kept, until a cap", kCap,
             "end that is apart kept", 1.0, 0.0);
}

TEST_CASE("The simple timewarp lands too early if its flights are Euler steps",
          "[claims][timewarp]") {
  // A semi-implicit step of t falls by g t², a flight by half of that.
  check_pair("T8: time of the landing from 1 mm", "integrated by Euler's steps",
             std::sqrt(1e-3 / kGravity), "flown exactly", std::sqrt(2e-3 / kGravity), kTime);
}

TEST_CASE("A cube hit from both sides alike stays only if both hit it at one stroke",
          "[claims][timewarp]") {
  // Three impulses in turn with restitution 0.5: the middle one has 3/4, -9/16 and 3/64 m/s.
  check_pair("T9: speed of a cube hit from both sides alike", "one after the other", 3.0 / 64.0,
             "at one stroke", 0.0, kRounding);
}

TEST_CASE("The ground gets a valid time only if immovable bodies are stamped",
          "[claims][timewarp]") {
  check_pair("T10: time up to which the ground is valid", "all bodies stamped",
             std::sqrt(2e-3 / kGravity), "only movable bodies", 0.0, kTime);
}

TEST_CASE("A collision of test states is forgotten by the next line", "[claims][timewarp]") {
  check_pair("F1: place of a cube that has hit another", "test states collide", 0.0,
             "valid states collide", 0.5, kPlace);
}

TEST_CASE("Bodies whose valid times stand still fly part of their way twice",
          "[claims][timewarp]") {
  // The third cube is hit at 0.3 s and 3.1 m and then flies for the whole of a second.
  check_pair("F2: place of the third cube", "valid times never advanced", 3.4 - 0.3 + 2.0,
             "valid times advanced", 4.0, kPlace);
}

TEST_CASE("A neighbour that is not put back loses the rest of its frame", "[claims][timewarp]") {
  check_pair("F3: place of a neighbour", "index of one of the two", -1.2 - 0.25,
             "index of the neighbour", -2.2, kPlace);
  check_pair("F4: place of a neighbour", "flown to the collision", -1.2 - 0.25,
             "flown to the end of the frame", -2.2, kPlace);
}

TEST_CASE("A collision that waits for an earlier one is lost unless it goes back into the queue",
          "[claims][timewarp]") {
  // At 0.5 s it is at -1.5 m. There it stays, or goes on with the 4 m/s of the cube that hits it.
  check_pair("F5: place of a cube that waits its turn", "collision and test states lost", -1.5,
             "both kept", -1.5 - 0.5 * 4.0, kPlace);
}

TEST_CASE("A pair that is looked for in its own group never gets to collide",
          "[claims][timewarp]") {
  check_pair("F6: passes of the loop for one collision", "present pair in the group, until a cap",
             kCap, "present pair left out", 1.0, 0.0);
}

TEST_CASE("The safer timewarp as printed does not get past its first collision",
          "[claims][timewarp]") {
  CHECK(number("passes of the loop for one collision, nothing mended, until a cap") == kCap);
}

TEST_CASE("A cube flies over another one that is not near it any more at the end of the frame",
          "[claims][timewarp]") {
  // It hits the third at 2.1 m and is pushed out of the second, 0.6 m each way but for the 1 mm that
  // repair leaves; else it hits the second at 0.7 m.
  const std::string what = "F7: place of a cube that flies over another";
  CHECK(number(what + ", near at the end of the frame") ==
        near(2.1 + 0.5 * (0.6 - 1e-3)).margin(kPlace));
  CHECK(number(what + ", near on the way to the collision") == near(0.7).margin(kPlace));
}

TEST_CASE(
    "A look at neighbours does not find that A meets B in figure 5.1, a search of the ways does",
    "[claims][timewarp]") {
  check_pair("F8: collisions of cube B in figure 5.1", "neighbours looked at", 0.0, "ways searched",
             2.0, 0.0);
}

TEST_CASE("Cube D of figure 5.1 is foreseen to meet E and not C", "[claims][timewarp]") {
  check_pair("F9: collisions foreseen for cube D in figure 5.1", "with C, as the caption says", 0.0,
             "with E", 1.0, 0.0);
}
