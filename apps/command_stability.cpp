/// \file
/// \brief `tumble stability`: stable boxes at the start of a scene, the reasons, and the motion of the others.
#include "tumble/analytic_lcp/touch.hpp"
#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/contact/tolerances.hpp"
#include "tumble/geometric_stability/load_proof.hpp"
#include "tumble/geometric_stability/stable_boxes.hpp"
#include "tumble/geometric_stability/tolerances.hpp"
#include "tumble/geometric_stability/upright.hpp"

#include "request.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace tumble::app {
namespace {

constexpr std::array<std::string_view, 4> kRules = {"corners", "hull", "load_proof", "equilibrium"};
constexpr std::size_t kMostMoving = 10;  // printed of the boxes that begin to move

// A body's line of the table.
struct Line {
  std::string name;
  bool stable = false;
  std::string by = "-";  // the level that found it
  std::string why;
};

// A scene at its start, with all points that nearly touch, those of bodies that part included.
struct Start {
  World world;
  std::vector<MovingBody> moving;
  ContactList contacts;

  explicit Start(const Scene& scene) : world(build_world(scene)) {
    load_moving_bodies(world, moving);
    gather_near(world, moving, contacts);
  }
};

// [m/s²] How fast a body begins to move from rest, its rim included; 0 in balance.
double start_of(const World& world, const StaticEquilibrium& balance, int body) {
  if (balance.balanced()[idx(body)] != 0) return 0.0;
  const Acceleration& a = balance.motion()[idx(body)];
  const double rim = 0.5 * world.bodies()[idx(body)].size.norm() * a.angular_w.norm();
  const double all = a.linear_w.norm() + rim;
  return all > tolerance::exact_balance * world.gravity_w.norm() ? all : 0.0;
}

// The answers of all levels for one start.
class Levels {
 public:
  Levels(const Start& start, std::string_view rule) : start_(start), rule_(rule) {
    const World& world = start.world;
    const auto hold = [&](StableRule by, std::vector<char>& out) {
      StableBoxes boxes(by, std::numeric_limits<int>::max());
      const std::span<const char> held = boxes.find(world, start.moving, start.contacts);
      out.assign(held.begin(), held.end());
    };
    const StableRule thesis = rule == "corners" ? StableRule::corners : StableRule::hull;
    hold(thesis, by_thesis_);
    hold(StableRule::equilibrium, at_rest_);
    stable_ = rule == "equilibrium" ? at_rest_ : by_thesis_;
    if (rule == "load_proof") LoadProof().run(world, start.contacts, stable_);
    std::vector<char> ignored;
    geometric_.run(world, start.contacts, thesis, tolerance::resting_speed, ignored);
    towers_.run(world, start.contacts, by_thesis_);
    // Boxes that rest in balance are left out, which keeps the problem small.
    balance_.solve(world, {.contacts = start.contacts, .loads = {}, .held = at_rest_});
  }

  [[nodiscard]] const StaticEquilibrium& balance() const { return balance_; }
  [[nodiscard]] std::span<const char> at_rest() const { return at_rest_; }

  [[nodiscard]] Line line(int body) {
    const World& world = start_.world;
    Line line{world.name(body), stable_[idx(body)] != 0, "-", ""};
    const bool thesis = by_thesis_[idx(body)] != 0;
    if (line.stable) line.by = thesis ? thesis_level() : own_level(body);
    if (line.stable && !thesis)
      line.why = own_reason(line.by);
    else if (!line.stable && rule_ == "equilibrium")
      line.why = loose_reason(body);
    else if (!gravity_is_down(world))
      line.why = world.gravity_w.isZero(0.0) ? "there is no gravity"
                                             : "gravity does not act straight down";
    else
      line.why = explanation(world, start_.contacts, geometric_.verdict(world, body));
    return line;
  }

 private:
  [[nodiscard]] std::string thesis_level() const { return rule_ == "corners" ? "corners" : "hull"; }
  [[nodiscard]] std::string own_level(int body) const {
    if (rule_ == "load_proof") return "load_proof";
    return towers_.states()[idx(body)] == TowerState::supported ? "tower" : "balance";
  }
  [[nodiscard]] static std::string own_reason(const std::string& level) {
    if (level == "load_proof") return "it carries any load, with the help of its neighbours";
    if (level == "tower") return "its weight and its load are above its supports";
    return "contact forces balance the weights";
  }
  [[nodiscard]] std::string loose_reason(int body) const {
    if (start_of(start_.world, balance_, body) > 0.0) return "begins to move, see below";
    if (balance_.balanced()[idx(body)] == 0)
      return "belongs to a group in which some boxes begin to move";
    return "moves, or touches a box that moves";
  }

  const Start& start_;
  std::string_view rule_;
  std::vector<char> stable_;
  std::vector<char> by_thesis_;  // as the analytic technique takes it
  std::vector<char> at_rest_;    // by equilibrium
  GeometricStability geometric_{
      {tolerance::exact_vertical, tolerance::exact_corner, tolerance::resting_speed}};
  Towers towers_;
  StaticEquilibrium balance_;
};

int width_of(const std::vector<Line>& lines) {
  std::size_t width = 3;
  for (const Line& line : lines) width = std::max(width, line.name.size());
  return static_cast<int>(width);
}

void print_table(const std::vector<Line>& lines) {
  const int width = width_of(lines);
  std::printf("%-*s  %-6s  %-10s  %s\n", width, "box", "stable", "by", "why");
  for (const Line& line : lines)
    std::printf("%-*s  %-6s  %-10s  %s\n", width, line.name.c_str(), line.stable ? "yes" : "no",
                line.by.c_str(), line.why.c_str());
}

// Three numbers, without a sign where they are 0.
void print_vector(const Vec3& v) {
  for (const double value : v) std::printf(" %9.4f", std::abs(value) < 5e-5 ? 0.0 : value);
}

// The boxes that begin to move, the fastest first; equal in six digits: in the order of the scene.
void print_motion(const Start& start, const Levels& levels, int width) {
  const World& world = start.world;
  const StaticEquilibrium& balance = levels.balance();
  std::vector<std::pair<double, int>> list;
  for (int b = 0; b < world.count(); ++b)
    if (const double all = start_of(world, balance, b); all > 0.0)
      list.emplace_back(-std::round(1e6 * all), b);
  if (list.empty()) {
    std::printf("in equilibrium under the weights, without friction\n");
    return;
  }
  std::sort(list.begin(), list.end());
  constexpr int kEdges = 8;  // of the pyramid of friction forces
  StaticEquilibrium rough;
  const BalanceTask task{
      .contacts = start.contacts, .loads = {}, .held = levels.at_rest(), .friction_edges = kEdges};
  std::printf("not in equilibrium under the weights, without friction%s\n",
              rough.solve(world, task).balanced
                  ? "; with friction there are forces that balance them"
                  : ", nor with it");
  std::printf("initial accelerations, from rest and without friction:\n");
  std::printf("%-*s   acceleration x y z [m/s2]       angular x y z [rad/s2]\n", width, "box");
  const std::size_t shown = std::min(list.size(), kMostMoving);
  for (std::size_t k = 0; k < shown; ++k) {
    const int body = list[k].second;
    std::printf("%-*s ", width, world.name(body).c_str());
    print_vector(balance.motion()[idx(body)].linear_w);
    std::printf("  ");
    print_vector(balance.motion()[idx(body)].angular_w);
    std::printf("\n");
  }
  if (list.size() > shown) std::printf("and %zu more\n", list.size() - shown);
}

}  // namespace

int stability_command(const Request& request, const std::string& rule) {
  require::that(std::find(kRules.begin(), kRules.end(), rule) != kRules.end(),
                "--rule " + rule + ": " + expected_names(rule, kRules));
  const Start start(resolve_scene(request));
  const std::size_t joints = start.world.joints().size();
  require::that(joints == 0, "tumble stability does not support joints, and the scene has " +
                                 std::to_string(joints) + ": leave out [[joint]]");
  Levels levels(start, rule);
  std::vector<Line> lines;
  for (int b = 0; b < start.world.count(); ++b)
    if (start.world.bodies()[idx(b)].movable()) lines.push_back(levels.line(b));
  print_table(lines);
  const auto stable =
      std::count_if(lines.begin(), lines.end(), [](const Line& line) { return line.stable; });
  std::printf("%td of %zu movable boxes are stable by %s\n", stable, lines.size(), rule.c_str());

  print_motion(start, levels, width_of(lines));
  return kDone;
}

}  // namespace tumble::app
