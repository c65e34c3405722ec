/// \file
/// \brief Measured tosses of a real cube onto a table, and the same tosses simulated.
#pragma once

#include "tumble/dynamics/technique.hpp"
#include "tumble/math/rotation.hpp"

#include "driver/played_scene.hpp"
#include "impulse_damped/tosses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::test {

// Where the cube was at one instant, y up, the table at y = 0.
struct TossSample {
  Vec3 position_w = Vec3::Zero();          // [m] centre
  Quat orientation_wb = Quat::Identity();  // [-] body to world
  Vec3 velocity_w = Vec3::Zero();          // [m/s] of the centre
  Vec3 angular_velocity_w = Vec3::Zero();  // [rad/s] world frame
};

// One toss, from the hand to rest.
struct MeasuredToss {
  std::string name;                 // of the file, for example "toss_007"
  std::vector<TossSample> samples;  // one every `toss_interval`
};

// How a toss ended.
struct TossOutcome {
  int face = 0;         // which face is up: 2 i for the one at -axis i of the cube, 2 i + 1 at +
  double tilt = 0.0;    // [rad] between that face's normal and the vertical
  double travel = 0.0;  // [m] from start to end, along the table
  double time_to_rest = 0.0;  // [s] from the start until it moves no more, see `toss_still`
  bool rests = false;         // whether it moved no more at the end
};

// The outcomes of many tosses, one number each.
struct TossNumbers {
  std::vector<double> travel;        // [m] of each
  std::vector<double> time_to_rest;  // [s] of each
  std::vector<int> face;             // of each
  int resting = 0;                   // how many rest at the end
  int flat = 0;                      // how many end with a face up, within two degrees
};

// [s] between two samples: the camera took 148 a second.
inline constexpr double toss_interval = 1.0 / 148.0;

// [m] edge of the cube.
inline constexpr double toss_edge = 0.1048;

inline constexpr std::size_t kTossColumns = 13;
inline constexpr std::size_t kFreeSamples = 8;  // samples before any corner is at the table

// Measured frames have z up: y and z change places, with a sign so that it is a rotation.
inline TossSample y_up(const std::array<double, kTossColumns>& row) {
  static const Quat upright = rotation_from_degrees(Vec3(-90.0, 0.0, 0.0));
  TossSample sample;
  const Quat measured = normalised(Quat(row[3], row[4], row[5], row[6]));
  sample.position_w = upright * Vec3(row[0], row[1], row[2]);
  sample.orientation_wb = normalised(upright * measured);
  sample.velocity_w = upright * Vec3(row[7], row[8], row[9]);
  sample.angular_velocity_w = sample.orientation_wb * Vec3(row[10], row[11], row[12]);
  return sample;
}

inline std::array<double, kTossColumns> toss_row_of(const std::string& line,
                                                    const std::string& file) {
  std::array<double, kTossColumns> row{};
  std::istringstream in(line);
  std::string cell;
  std::size_t count = 0;
  while (std::getline(in, cell, ',')) {
    if (count < kTossColumns) row.at(count) = std::stod(cell);
    ++count;
  }
  if (count != kTossColumns) throw std::runtime_error(file + ": expected 13 numbers in " + line);
  return row;
}

inline MeasuredToss read_toss(const std::filesystem::path& file) {
  std::ifstream in(file);
  MeasuredToss toss{.name = file.stem().string()};
  std::string line;
  std::getline(in, line);  // names of the columns
  while (std::getline(in, line)) toss.samples.push_back(y_up(toss_row_of(line, file.string())));
  if (toss.samples.size() < 2 * kFreeSamples)
    throw std::runtime_error(file.string() + ": expected at least 16 samples");
  // The table is where the cube came to rest on it.
  const double table = toss.samples.back().position_w.y() - 0.5 * toss_edge;
  for (TossSample& sample : toss.samples) sample.position_w.y() -= table;
  return toss;
}

inline bool still(const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  return velocity_w.norm() < chapters::toss_still &&
         angular_velocity_w.norm() < 10.0 * chapters::toss_still;
}

inline double along_table(const Vec3& way) { return std::hypot(way.x(), way.z()); }

// Which body axis is nearest to the vertical, and how near.
inline void find_face(const Quat& orientation_wb, TossOutcome& outcome) {
  const Vec3 up_b = orientation_wb.conjugate() * Vec3::UnitY();
  int axis = 0;
  up_b.cwiseAbs().maxCoeff(&axis);
  outcome.face = 2 * axis + (up_b[axis] > 0.0 ? 1 : 0);
  outcome.tilt = std::acos(std::min(std::abs(up_b[axis]), 1.0));
}

// Reads the tosses of a folder, z up as they were measured, and turns them y up.
//
// The data are ContactNets' (Pfrommer, Halm, Posa, CoRL 2020), one CSV file for each toss, with a
// header and position, quaternion w x y z, velocity, and angular velocity in the cube's frame. At
// rest the measured centre is 1 mm below half an edge; each toss is lifted until it is not.
inline std::vector<MeasuredToss> read_tosses(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".csv" && entry.path().filename().string().starts_with("toss_"))
      files.push_back(entry.path());
  if (files.empty()) throw std::runtime_error(folder.string() + ": has no file toss_*.csv");
  std::ranges::sort(files);
  std::vector<MeasuredToss> tosses;
  for (const std::filesystem::path& file : files) tosses.push_back(read_toss(file));
  return tosses;
}

// How a measured toss ended.
inline TossOutcome measured_outcome(const MeasuredToss& toss) {
  TossOutcome outcome;
  const TossSample& last = toss.samples.back();
  find_face(last.orientation_wb, outcome);
  outcome.travel = along_table(last.position_w - toss.samples.front().position_w);
  std::size_t moving = toss.samples.size();  // how many samples there are up to the last that moves
  while (moving > 0 &&
         still(toss.samples[moving - 1].velocity_w, toss.samples[moving - 1].angular_velocity_w))
    --moving;
  outcome.time_to_rest = static_cast<double>(moving) * toss_interval;
  outcome.rests = moving < toss.samples.size();
  return outcome;
}

// The cube and the table at the start of a toss.
//
// Position and velocity are the least-squares free flight through the first eight samples, in
// which no corner is at the table yet; the angular velocity is their mean. Mass 0.37 kg, moment of
// inertia 0.00081 kg m², friction 0.18 and restitution 0.125 are those that go with the data.
inline World toss_world(const MeasuredToss& toss) {
  // x(t) + g t²/2 is a straight line in free flight: its least-squares value and slope at t = 0.
  Vec3 sum = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  Vec3 spin = Vec3::Zero();
  const double middle = 0.5 * static_cast<double>(kFreeSamples - 1) * toss_interval;
  double spread = 0.0;
  for (std::size_t k = 0; k < kFreeSamples; ++k) {
    const double t = static_cast<double>(k) * toss_interval;
    Vec3 straight = toss.samples[k].position_w;
    straight.y() += 0.5 * chapters::kGravity * t * t;
    sum += straight;
    moment += (t - middle) * straight;
    spread += (t - middle) * (t - middle);
    spin += toss.samples[k].angular_velocity_w;
  }
  const double count = static_cast<double>(kFreeSamples);
  const Vec3 velocity = moment / spread;
  const Vec3 place = sum / count - middle * velocity;

  World world;
  world.add_ground(0.18, 0.125);
  BodyProperties cube = box_properties(Vec3::Constant(toss_edge), 0.37, 0.18, 0.125);
  cube.inertia_b = Vec3::Constant(0.00081);
  cube.inverse_inertia_b = cube.inertia_b.cwiseInverse();
  world.add(cube,
            make_state(cube, place, toss.samples.front().orientation_wb, velocity, spin / count),
            "cube");
  return world;
}

// Simulates a toss for two seconds.
inline TossOutcome simulated_outcome(const MeasuredToss& toss, Technique& technique, double dt) {
  World world = toss_world(toss);
  const Vec3 start = world.states()[1].position_w;
  TossOutcome outcome;
  const int steps = static_cast<int>(std::lround(chapters::toss_seconds / dt));
  for (int k = 0; k < steps; ++k) {
    technique.step(world, dt);
    const BodyProperties& cube = world.bodies()[1];
    const BodyState& state = world.states()[1];
    outcome.rests = still(velocity(cube, state), angular_velocity(cube, state));
    if (!outcome.rests) outcome.time_to_rest = (k + 1) * dt;
  }
  find_face(world.states()[1].orientation_wb, outcome);
  outcome.travel = along_table(world.states()[1].position_w - start);
  return outcome;
}

// Adds an outcome to others.
inline void add(const TossOutcome& outcome, TossNumbers& numbers) {
  numbers.travel.push_back(outcome.travel);
  numbers.time_to_rest.push_back(outcome.time_to_rest);
  numbers.face.push_back(outcome.face);
  if (outcome.rests) ++numbers.resting;
  if (outcome.tilt < 0.035) ++numbers.flat;  // two degrees
}

// The distance of Kolmogorov and Smirnov, \f$\max_x |F_1(x) - F_2(x)|\f$ of the shares of numbers
// up to x.
// Returns [-] 0 to 1
inline double distribution_distance(std::vector<double> first, std::vector<double> second) {
  std::ranges::sort(first);
  std::ranges::sort(second);
  double worst = 0.0;
  const auto share = [](const std::vector<double>& numbers, double x) {
    const auto up_to = std::upper_bound(numbers.begin(), numbers.end(), x) - numbers.begin();
    return static_cast<double>(up_to) / static_cast<double>(numbers.size());
  };
  for (const std::vector<double>* numbers : {&first, &second})
    for (const double x : *numbers)
      worst = std::max(worst, std::abs(share(first, x) - share(second, x)));
  return worst;
}

}  // namespace tumble::test
