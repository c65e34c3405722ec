/// \file
/// \brief The C interface of the module: statuses, sentences, and that no exception leaves it.

#include "catalogue.hpp"
#include "live/seen.hpp"
#include "session.hpp"
#include "support/test.hpp"

extern "C" {
char* tumble_input(int bytes);
const char* tumble_answer();
int tumble_answer_size();
int tumble_catalogue();
int tumble_open(int slot);
void tumble_close(int slot);
int tumble_step(int slot, int steps, double dt);
int tumble_throw(int slot, double edge, double mass, double x, double y, double z, double vx,
                 double vy, double vz);
int tumble_take_away(int slot, int id);
int tumble_look(int slot, int wanted);
const double* tumble_seen(int slot, int what);
int tumble_seen_count(int slot, int what);
int tumble_hash(int slot);
int tumble_scene(int slot);
}

namespace {

using namespace tumble::live;
using Catch::Matchers::StartsWith;

constexpr int kOk = 0;
constexpr int kBadInput = 2;
constexpr int kFailed = 3;

std::string answer() { return {tumble_answer(), static_cast<std::size_t>(tumble_answer_size())}; }

int open(int slot, const std::string& request) {
  char* at = tumble_input(static_cast<int>(request.size()));
  REQUIRE(at != nullptr);
  std::copy(request.begin(), request.end(), at);
  return tumble_open(slot);
}

std::string hash_of(int slot) {
  REQUIRE(tumble_hash(slot) == kOk);
  return answer();
}

std::string scene_of(int slot) {
  REQUIRE(tumble_scene(slot) == kOk);
  return answer();
}

std::vector<double> seen(int slot, int what) {
  const double* at = tumble_seen(slot, what);
  return {at, at + tumble_seen_count(slot, what)};
}

// Both slots are closed at the start and at the end of a test.
struct Closed {
  Closed() { close(); }
  ~Closed() { close(); }
  Closed(const Closed&) = delete;
  Closed& operator=(const Closed&) = delete;
  static void close() {
    tumble_close(0);
    tumble_close(1);
  }
};

int throw_at(int slot, double edge, double mass, const Vec3& at, const Vec3& velocity_w) {
  return tumble_throw(slot, edge, mass, at.x(), at.y(), at.z(), velocity_w.x(), velocity_w.y(),
                      velocity_w.z());
}

}  // namespace

TEST_CASE("The module does what a session does", "[unit][live]") {
  const Closed closed;
  const std::string request = "scene pyramid\nset scene.rows=3";
  Session session(request);
  REQUIRE(open(1, request) == kOk);
  CHECK(answer().empty());  // nothing is left out
  REQUIRE(tumble_step(1, 7, kDt) == kOk);
  step(session, 7);
  REQUIRE(throw_at(1, 0.5, 2.0, Vec3(0.25, 1.0, 4.0), Vec3(0.0, 1.0, -20.0)) == kOk);
  session.throw_in(SceneBox{.name = "",
                            .size = Vec3::Constant(0.5),
                            .mass = 2.0,
                            .position_w = Vec3(0.25, 1.0, 4.0),
                            .velocity_w = Vec3(0.0, 1.0, -20.0)});
  REQUIRE(tumble_step(1, 20, kDt) == kOk);
  step(session, 20);
  const BodyId top = session.run().world().ids()[5];
  REQUIRE(tumble_take_away(1, static_cast<int>(number_of(top))) == kOk);
  session.take_away(top);
  REQUIRE(tumble_step(1, 1, kDt) == kOk);
  step(session, 1);

  CHECK(hash_of(1) == session.run().world().hash().text());
  CHECK(scene_of(1) == to_toml(session.run().scene()));
  // All but pivots, which are NaN here and there.
  const unsigned wanted = kEverything & ~static_cast<unsigned>(kLookPivots);
  REQUIRE(tumble_look(1, static_cast<int>(wanted)) == kOk);
  session.look(wanted);
  REQUIRE(tumble_seen_count(1, 0) == static_cast<int>(session.bodies().size()));
  for (std::size_t k = 0; k < session.bodies().size(); ++k)
    if (k % kBodyNumbers < 21) CHECK(tumble_seen(1, 0)[k] == session.bodies()[k]);
  CHECK(!seen(1, 1).empty());
  CHECK(seen(1, 1) == session.contacts());
  CHECK(seen(1, 2) == session.numbers());
  REQUIRE(tumble_catalogue() == kOk);
  CHECK(answer() == catalogue());
}

TEST_CASE("Two slots of the module are two simulations", "[unit][live]") {
  const Closed closed;
  REQUIRE(open(0, "scene dice\nseed 1") == kOk);
  REQUIRE(open(1, "scene dice\nseed 1") == kOk);
  CHECK(hash_of(0) == hash_of(1));
  REQUIRE(tumble_step(0, 3, kDt) == kOk);
  CHECK(hash_of(0) != hash_of(1));
  REQUIRE(tumble_step(1, 3, kDt) == kOk);
  CHECK(hash_of(0) == hash_of(1));
  tumble_close(0);
  CHECK(tumble_hash(0) == kBadInput);
  CHECK(tumble_step(1, 1, kDt) == kOk);
}

TEST_CASE("Opening reports the parts that the technique leaves out", "[unit][live]") {
  const Closed closed;
  REQUIRE(open(0, "scene stack\ntechnique damped") == kOk);
  CHECK(answer() == "friction");
  REQUIRE(open(0, "scene fig6_1\ntechnique glued") == kOk);
  CHECK(answer() == "collisions, contacts other than those at the start, limits of friction");
}

TEST_CASE("A request that is refused leaves the simulation that was there", "[unit][live]") {
  const Closed closed;
  REQUIRE(open(0, "scene stack") == kOk);
  REQUIRE(tumble_step(0, 2, kDt) == kOk);
  const std::string hash = hash_of(0);
  CHECK(open(0, "scene piramid") == kBadInput);
  CHECK_THAT(answer(), StartsWith("unknown scene piramid: did you mean pyramid?"));
  CHECK(open(0, "toml\n[[box]]\nsize = [1, 1, 1]\n") == kBadInput);
  CHECK_THAT(answer(), StartsWith("scene.toml:1: box[1].position: missing"));
  CHECK(hash_of(0) == hash);
}

TEST_CASE("A slot that is closed or does not exist answers every call with a sentence",
          "[unit][live]") {
  const Closed closed;
  REQUIRE(open(1, "scene stack") == kOk);
  for (const int slot : {0, 2, -1, 1000000, -2147483647 - 1}) {
    INFO(slot);
    const std::vector<std::pair<const char*, int>> statuses = {
        {"step", tumble_step(slot, 1, kDt)},
        {"no step", tumble_step(slot, 0, kDt)},
        {"throw", throw_at(slot, 1.0, 1.0, Vec3::Zero(), Vec3::Zero())},
        {"take away", tumble_take_away(slot, 1)},
        {"look", tumble_look(slot, 1)},
        {"hash", tumble_hash(slot)},
        {"scene", tumble_scene(slot)}};
    for (const auto& [call, status] : statuses) {
      INFO(call);
      CHECK(status == kBadInput);
    }
    CHECK(answer() == "no simulation is open there: open a scene first");
    for (const int what : {0, 1, 2}) CHECK(tumble_seen_count(slot, what) == 0);
    CHECK(seen(slot, 0).empty());
    tumble_close(slot);
    if (slot == 0) continue;
    CHECK(open(slot, "scene stack") == kBadInput);
    CHECK(answer() == "slot: expected 0 or 1");
  }
  CHECK(tumble_hash(1) == kOk);  // the other one is as it was
}

TEST_CASE("Throws that make no sense are refused by the module and change nothing",
          "[unit][live]") {
  const Closed closed;
  const double inf = HUGE_VAL;
  const Vec3 free(20.0, 9.0, 0.0);
  for (const int steps : {0, 4}) {
    INFO("after " << steps << " steps");
    REQUIRE(open(0, "scene stack") == kOk);
    REQUIRE(tumble_step(0, steps, kDt) == kOk);
    const std::string hash = hash_of(0);
    const std::string scene = scene_of(0);
    const auto refused = [&](int status, const char* message) {
      CHECK(status == kBadInput);
      CHECK_THAT(answer(), Contains(message));
      CHECK(hash_of(0) == hash);
      CHECK(scene_of(0) == scene);
    };
    const Vec3 still = Vec3::Zero();
    for (const double bad : {kNan, inf, -1.0, 0.0, -inf}) {
      INFO(bad);
      refused(throw_at(0, bad, 1.0, free, still), "size.x = ");
      refused(throw_at(0, 1.0, bad, free, still), "mass = ");
    }
    for (const double bad : {kNan, inf, -inf}) {
      INFO(bad);
      refused(throw_at(0, 1.0, 1.0, Vec3(0.0, bad, 0.0), still), "position_w = ");
      refused(throw_at(0, 1.0, 1.0, free, Vec3(0.0, 0.0, bad)), "velocity_w = ");
    }
    refused(throw_at(0, 1.0, 1e-320, free, still), "mass = ");
    refused(throw_at(0, 1.0, 1e9, free, Vec3(0.0, 0.0, 1e300)), "velocity_w = [0, 0, 1e+300]");
    refused(throw_at(0, 1e200, 1.0, Vec3(0.0, 1e201, 0.0), still),
            "shortest edge of size = 1e+200");
    refused(tumble_take_away(0, 99), "there is no such box to take away");
    refused(tumble_take_away(0, -1), "there is no such box to take away");
    refused(tumble_take_away(0, 0), "there is no box called ground to take away");
    // After all of it a throw is a throw.
    REQUIRE(throw_at(0, 1.0, 1.0, free, still) == kOk);
    CHECK_THAT(scene_of(0), Contains("name = \"thrown1\""));
    CHECK(tumble_step(0, 3, kDt) == kOk);
  }
}

TEST_CASE("A technique that refuses a step ends with a sentence, and the scene can still be saved",
          "[unit][live]") {
  const Closed closed;
  // More than a turn in a step is not what glued bodies can do.
  REQUIRE(open(0,
               "technique glued\ntoml\n[[box]]\nsize = [1, 1, 1]\nmass = 1\nposition = [0, 1, 0]\n"
               "angular_velocity = [0, 900, 0]\n") == kOk);
  const std::string scene = scene_of(0);
  CHECK(tumble_step(0, 5, kDt) == kBadInput);
  CHECK_THAT(answer(), Contains("expected a shorter dt"));
  CHECK(scene_of(0) == scene);
  CHECK(tumble_look(0, 63) == kOk);
  CHECK(seen(0, 2).at(1) == 0.0);  // no step was done
  CHECK(tumble_step(0, 1, 1e-3) == kOk);
}

TEST_CASE("A step without a solution ends with a sentence, and the session can be looked at",
          "[unit][live]") {
  const Closed closed;
  REQUIRE(open(0, "scene stack\ntechnique analytic\nset technique.solver=baraff_as_printed") ==
          kOk);
  int status = kOk;
  int steps = 0;
  for (; steps < 200 && status == kOk; ++steps) status = tumble_step(0, 1, 1.0 / 60.0);
  CHECK(status == kFailed);
  CHECK(answer() == "a step could not be solved: reset, or choose a shorter step");
  CHECK(tumble_look(0, 63) == kOk);
  CHECK(seen(0, 2).at(2) >= 2.0);  // status: unsolved or not finite
  CHECK_FALSE(scene_of(0).empty());
  CHECK_FALSE(hash_of(0).empty());
  // Steps that follow the failed one in the same call are not done.
  REQUIRE(open(0, "scene stack\ntechnique analytic\nset technique.solver=baraff_as_printed") ==
          kOk);
  CHECK(tumble_step(0, 1000, 1.0 / 60.0) == kFailed);
  REQUIRE(tumble_look(0, 0) == kOk);
  CHECK(seen(0, 2).at(1) <= static_cast<double>(steps));
}

TEST_CASE("There is no room for a text of an impossible length, and no exception is thrown for it",
          "[unit][live]") {
  const Closed closed;
  CHECK(tumble_input(-1) == nullptr);
  CHECK_FALSE(answer().empty());
  CHECK(open(0, "scene stack") == kOk);
  CHECK(tumble_input(0) != nullptr);
  CHECK(tumble_open(0) == kBadInput);
  CHECK_THAT(answer(), StartsWith("unknown scene : expected one of"));
}
