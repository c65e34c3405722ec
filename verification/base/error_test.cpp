/// \file
/// \brief Refusals name what was given and what would be right.
#include "tumble/base/error.hpp"

#include "support/test.hpp"

TEST_CASE("A refused number is reported with its name, its value and the expected one",
          "[unit][error]") {
  CHECK(refusal_of([] { require::finite(kNan, "mass"); }) ==
        "tumble: mass = nan: expected a finite number");
  CHECK(refusal_of([] { require::positive(-0.5, "mass"); }) ==
        "tumble: mass = -0.5: expected a finite number above 0");
  CHECK(refusal_of([] { require::positive(0.0, "mass"); }) ==
        "tumble: mass = 0: expected a finite number above 0");
  CHECK(refusal_of([] { require::positive(kInfinity, "mass"); }) ==
        "tumble: mass = inf: expected a finite number above 0");
  CHECK(refusal_of([] { require::not_negative(-1e-300, "friction"); }) ==
        "tumble: friction = -1e-300: expected a finite number, 0 or above");
  CHECK(refusal_of([] { require::not_negative(kInfinity, "friction"); }) ==
        "tumble: friction = inf: expected a finite number, 0 or above");
  CHECK(refusal_of([] { require::within(1.5, 0.0, 1.0, "restitution"); }) ==
        "tumble: restitution = 1.5: expected a number from 0 to 1");
  CHECK(refusal_of([] { require::within(kNan, 0.0, 1.0, "restitution"); }) ==
        "tumble: restitution = nan: expected a number from 0 to 1");
  CHECK(refusal_of([] { require::that(false, "rows = -1: give at least 1"); }) ==
        "tumble: rows = -1: give at least 1");
}

TEST_CASE("A refused vector, matrix or quaternion is reported with all components",
          "[unit][error]") {
  CHECK(refusal_of([] { require::finite(Vec3(1.0, kNan, -2.5), "position"); }) ==
        "tumble: position = [1, nan, -2.5]: expected three finite numbers");
  CHECK(refusal_of([] {
          Mat3 m = Mat3::Identity();
          m(0, 2) = kInfinity;
          require::finite(m, "inertia");
        }) == "tumble: inertia = [1, 0, inf][0, 1, 0][0, 0, 1]: expected nine finite numbers");
  CHECK(refusal_of([] { require::unit(Vec3(0.0, 2.0, 0.0), "axis"); }) ==
        "tumble: axis = [0, 2, 0]: expected a vector of length 1: normalise it first");
  CHECK(refusal_of([] { require::unit(Vec3(kNan, 0.0, 0.0), "axis"); }) ==
        "tumble: axis = [nan, 0, 0]: expected three finite numbers");
  CHECK(refusal_of([] { require::unit(Quat(2.0, 0.0, 0.0, 0.0), "q"); }) ==
        "tumble: q = (w 2, x y z [0, 0, 0]): expected a quaternion of length 1: normalise it "
        "first");
  CHECK(refusal_of([] { require::unit(Quat(kNan, 0.0, 0.0, 0.0), "q"); }) ==
        "tumble: q = (w nan, x y z [0, 0, 0]): expected a quaternion of length 1: "
        "normalise it "
        "first");
}

TEST_CASE("What is right is accepted", "[unit][error]") {
  CHECK_NOTHROW(require::finite(1e308, "x"));
  CHECK_NOTHROW(require::finite(Vec3(1.0, 2.0, 3.0), "x"));
  CHECK_NOTHROW(require::finite(Mat3(Mat3::Identity()), "x"));
  CHECK_NOTHROW(require::positive(5e-324, "x"));
  CHECK_NOTHROW(require::not_negative(0.0, "x"));
  CHECK_NOTHROW(require::not_negative(-0.0, "x"));
  CHECK_NOTHROW(require::within(0.0, 0.0, 1.0, "x"));
  CHECK_NOTHROW(require::within(1.0, 0.0, 1.0, "x"));
  CHECK_NOTHROW(require::unit(Vec3(0.6, 0.8, 0.0), "x"));
  CHECK_NOTHROW(require::unit(Vec3(1.0 + 0.5e-9, 0.0, 0.0), "x"));
  CHECK_NOTHROW(require::unit(Quat(0.5, -0.5, 0.5, -0.5), "x"));
  CHECK_NOTHROW(require::that(true, "never said"));
}
