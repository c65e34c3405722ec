/// \file
/// \brief Hits and false alarms of the detector (claim 6.3.1c).
#include "driver/quick.hpp"
#include "filtering/motion_corpus.hpp"
#include "support/test.hpp"

using namespace tumble::chapters;

TEST_CASE(
    "Chatter of a settled clump is detected from its past, and sliding, rolling or rocking is not",
    "[claims][filtering]") {
  const FigureUnderTest figure("claim_6_3_1c_detector");
  const double detected = figure.number("chatter that is classified as chatter");
  const double kept = figure.number(
      "mean share of sliding, creeping, rolling and rocking that is classified as motion");
  // Two small clumps; in eight of 125 cubes 0.98 and 0.995.
  CHECK(detected >= 0.9);
  CHECK(kept >= 0.95);
  CHECK(figure.number("the smaller of two shares of a corpus with labels: chatter that is "
                      "classified as chatter, and slow sliding, rolling and rocking that is not") ==
        std::min(detected, kept));
  CHECK(figure.number("falling and fast sliding that is classified as motion") == 1.0);
  CHECK(figure.number("false freezes per second of a moving body") <= 0.01);
}

TEST_CASE("The speed that puts bodies to sleep does not distinguish chatter from slow sliding",
          "[claims][filtering]") {
  const FigureUnderTest figure("claim_6_3_1c_detector");
  CHECK(figure.number("chatter that the sleeping rule calls slow") <= 0.1);
  CHECK(figure.number("slow sliding whose momenta the damping calls small") >= 0.9);
  CHECK(figure.number("area under the curve of speed") <
        figure.number("area under the curve of the rule"));
}

TEST_CASE("The label of a motion agrees with the whole run", "[unit][filtering]") {
  // A box that slides for a second and stops: what is labelled slides, and nothing after its stop.
  MotionCorpus corpus;
  const SettledRun run =
      settle_scene(make_scene("slide", {"speed=0.2", "friction=0.02", "height=1"}),
                   {"contact_damped", {}}, 0.0, 4.0);
  add_run(run, 1, Doing::slides, corpus);
  REQUIRE_FALSE(corpus.moments.empty());
  for (const Moment& moment : corpus.moments) CHECK(moment.doing == Doing::slides);
  // It stops after v/(μ g) = 1.02 s; half a second before and after a label it has to go.
  CHECK(corpus.moments.size() <= 34);
  CHECK(corpus.false_freezes == 0);

  MotionCorpus falling;
  add_run(settle_scene(make_scene("bouncing_box"), {"basic", {}}, 0.0, 1.5), 5, Doing::slides,
          falling);
  REQUIRE_FALSE(falling.moments.empty());
  CHECK(std::ranges::all_of(falling.moments,
                            [](const Moment& m) { return m.doing == Doing::falls; }));
}
