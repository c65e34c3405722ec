/// \file
/// \brief The costs of taking bodies back and of waiting for one another (thesis 2.4.3).
#include "driver/quick.hpp"
#include "support/test.hpp"
#include "timewarp/cage_runs.hpp"

using namespace tumble::chapters;

namespace {

// A cage in which 27 cubes collide some twenty times.
CageStretch small_cage() { return CageStretch{.count = 27, .settle = 8, .frames = 16}; }

}  // namespace

TEST_CASE("Work in a cage is counted over the same collisions under every form",
          "[unit][timewarp]") {
  const CageStretch stretch = small_cage();
  const SettledCage cage = settled_cage(led_cage(stretch, 1), stretch);
  const CageWork swept = work_of(cage, stretch, {"timewarp_swept"});
  CHECK(swept.events > 10.0);
  for (const TimewarpForm& form :
       {TimewarpForm{"basic", {"search=conservative"}}, full_timewarp(), full_timewarp(1.0)}) {
    INFO(form.name);
    const CageWork work = work_of(cage, stretch, form);
    CHECK(work.events == swept.events);
    CHECK(work.frames == 16.0);
  }
  // Those that are synchronised wait for one another at the end, and have nothing to settle.
  for (const int every : {1, 2, 4, 8})
    CHECK(work_of(cage, stretch, synchronised_timewarp(every)).events == swept.events);
}

TEST_CASE("All taken back is a flight of every body for each collision and each frame",
          "[exact][timewarp]") {
  const CageStretch stretch = small_cage();
  const SettledCage cage = settled_cage(led_cage(stretch, 2), stretch);
  for (const TimewarpForm& form : {all_taken_back(), {"basic", {"search=conservative"}}}) {
    const CageWork work = work_of(cage, stretch, form);
    CHECK(work.events > 10.0);
    CHECK(work.rewinds == 27.0 * work.events);  // no two of them at one time
    CHECK(work.integrations == work.rewinds + 27.0 * work.frames);
  }
}

TEST_CASE("Of those near a collision each body that is taken back flies twice",
          "[exact][timewarp]") {
  const CageStretch stretch = small_cage();
  const SettledCage cage = settled_cage(led_cage(stretch, 2), stretch);
  for (const char* name : {"timewarp_simple", "timewarp_swept"}) {
    const CageWork work = work_of(cage, stretch, {name});
    CHECK(work.rewinds > work.events);        // two cubes,
    CHECK(work.rewinds < 2.0 * work.events);  // or one and a wall
    CHECK(work.integrations == 2.0 * work.rewinds + 27.0 * work.frames);
  }
}

TEST_CASE("What full timewarp loses by waiting on every frame falls with the collisions in it",
          "[claims][timewarp]") {
  const FigureUnderTest figure("claim_2_4_3b_synchronising", {"seeds=8"});
  for (const std::vector<double>& row : figure.result.tables[1].rows) {
    INFO("bodies " << row[0] << ", factor " << row[1]);
    // [-] lost, against 1/(1 + collisions); eight cages of few collisions
    CHECK(row[3] == near(1.0 / (1.0 + row[2]), 0.1));
  }
  CHECK(figure.number("the same, the smaller cage at a sixteenth of the speeds") > 0.5);
  const Table& periods = figure.result.tables[0];
  for (const char* cage : {"full_larger", "full_smaller"}) {
    const std::vector<double> rate = column_of(periods, cage);
    for (std::size_t k = 1; k < rate.size(); ++k) CHECK(rate[k] < rate[k - 1]);
  }
  // Bodies that wait for one another need not be looked at in between.
  CHECK(figure.number(
            "the first number if every body is looked at in every frame and that is counted") <
        0.01);
}
