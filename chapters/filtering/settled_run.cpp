/// \file
/// \brief Recording bodies until they rest, and which of them do.
#include "filtering/settled_run.hpp"

#include "tumble/contact/tolerances.hpp"
#include "tumble/filtering/chatter_detector.hpp"
#include "tumble/record/chatter.hpp"

namespace tumble::chapters {
namespace {

constexpr std::size_t kWindow = ChatterMeter::kWindow;

// A path as half seconds that share their ends.
std::vector<std::span<const Corners>> half_seconds(const std::vector<Corners>& path) {
  std::vector<std::span<const Corners>> parts;
  for (std::size_t begin = 0; begin + kWindow <= path.size(); begin += kWindow - 1)
    parts.push_back(std::span(path).subspan(begin, kWindow));
  return parts;
}

}  // namespace

SettledRun record_run(PlayedScene& played, double settling, double watched,
                      const MarkTouches& touches,
                      const std::function<void(const StepReport&)>& after) {
  SettledRun run;
  const auto record = [&] {
    run.frames.record(played.world());
    touches(played.world(), run.touches.emplace_back());
  };
  record();
  played.advance(settling + watched, [&](const StepReport& report) {
    record();
    if (after) after(report);
  });
  run.first = static_cast<int>(std::lround(settling / kStep));
  run.world = played.world();
  return run;
}

SettledRun settle_scene(const Scene& scene, const PlayedTechnique& played, double settling,
                        double watched, std::uint64_t seed) {
  PlayedScene now(scene, played, seed);
  return record_run(now, settling, watched, [&](const World& world, std::vector<char>& touches) {
    mark_contacts(world, now.technique().contacts(), touches);
  });
}

Scene clump_scene(int per_edge, std::uint64_t seed) {
  return scene_with("fig6_7", {"per_edge=" + std::to_string(per_edge)}, seed);
}

SettledRun settle_clump(const Parameters& settings, int seed, const PlayedTechnique& technique,
                        double afterwards) {
  const auto chance = static_cast<std::uint64_t>(seed);
  return settle_scene(clump_scene(settings.count("per_edge"), chance), technique,
                      settings.number("settling"), settings.number("watched") + afterwards, chance);
}

std::size_t first_movable(const World& world) {
  std::size_t index = 0;
  while (!world.bodies()[index].movable()) ++index;
  return index;
}

std::vector<Corners> settled_path(const SettledRun& run, const Trajectory& frames,
                                  std::size_t index) {
  std::vector<Corners> path;
  for (int k = run.first; k < frames.count(); ++k)
    path.push_back(corners_of(box_of(run.world.bodies()[index], frames.frame(k).states[index])));
  return path;
}

Shake shake_of(const std::vector<Corners>& path, double gravity) {
  Shake shake;
  const auto parts = half_seconds(path);
  for (const std::span<const Corners> part : parts) {
    shake.amplitude += largest_excursion(part);
    shake.acceleration += rms_second_difference(part) / (gravity * kStep * kStep);
  }
  const double count = static_cast<double>(parts.size());
  shake.amplitude /= count;
  shake.acceleration /= count;
  shake.squirm = squirm(path, kStep);
  return shake;
}

Shake settled_shake(const SettledRun& run, std::size_t index) {
  return shake_of(settled_path(run, run.frames, index), run.world.gravity_w.norm());
}

bool same_pose(const BodyState& a, const BodyState& b) {
  return a.position_w == b.position_w && a.orientation_wb.coeffs() == b.orientation_wb.coeffs();
}

std::vector<std::size_t> resting_bodies(const SettledRun& run) {
  std::vector<std::size_t> resting;
  for (std::size_t k = 0; k < run.world.bodies().size(); ++k) {
    const BodyProperties& body = run.world.bodies()[k];
    if (!body.movable()) continue;
    bool rests = true;
    for (std::size_t f = static_cast<std::size_t>(run.first); f < run.touches.size(); ++f)
      rests = rests && run.touches[f][k] != 0;
    const std::vector<Corners> path = settled_path(run, run.frames, k);
    for (const std::span<const Corners> part : half_seconds(path))
      rests = rests && largest_displacement(part.front(), part.back()) <
                           tolerance::resting_movement * body.size.minCoeff();
    if (rests) resting.push_back(k);
  }
  return resting;
}

std::vector<std::size_t> chattering_bodies(const SettledRun& run) {
  std::vector<std::size_t> chattering;
  for (const std::size_t k : resting_bodies(run))
    if (settled_shake(run, k).amplitude >= kChatters * run.world.bodies()[k].size.minCoeff())
      chattering.push_back(k);
  return chattering;
}

}  // namespace tumble::chapters
