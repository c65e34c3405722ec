/// \file
/// \brief Measured tosses of a real cube onto a table, and the same tosses simulated.
#include "impulse_damped/tosses.hpp"

#include "tumble/math/rotation.hpp"

#include "driver/common_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tumble::chapters {
namespace {

constexpr std::size_t kColumns = 13;
constexpr std::size_t kFree = 8;  // samples before any corner is at the table

// Measured frames have z up: y and z change places, with a sign so that it is a rotation.
TossSample y_up(const std::array<double, kColumns>& row) {
  static const Quat upright = rotation_from_degrees(Vec3(-90.0, 0.0, 0.0));
  TossSample sample;
  const Quat measured = normalised(Quat(row[3], row[4], row[5], row[6]));
  sample.position_w = upright * Vec3(row[0], row[1], row[2]);
  sample.orientation_wb = normalised(upright * measured);
  sample.velocity_w = upright * Vec3(row[7], row[8], row[9]);
  sample.angular_velocity_w = sample.orientation_wb * Vec3(row[10], row[11], row[12]);
  return sample;
}

std::array<double, kColumns> numbers_of(const std::string& line, const std::string& file) {
  std::array<double, kColumns> row{};
  std::istringstream in(line);
  std::string cell;
  std::size_t count = 0;
  while (std::getline(in, cell, ',')) {
    if (count < kColumns) row.at(count) = std::stod(cell);
    ++count;
  }
  if (count != kColumns) throw std::runtime_error(file + ": expected 13 numbers in " + line);
  return row;
}

MeasuredToss read_toss(const std::filesystem::path& file) {
  std::ifstream in(file);
  MeasuredToss toss;
  toss.name = file.stem().string();
  std::string line;
  std::getline(in, line);  // names of the columns
  while (std::getline(in, line)) toss.samples.push_back(y_up(numbers_of(line, file.string())));
  if (toss.samples.size() < 2 * kFree)
    throw std::runtime_error(file.string() + ": expected at least 16 samples");
  // The table is where the cube came to rest on it.
  const double table = toss.samples.back().position_w.y() - 0.5 * toss_edge;
  for (TossSample& sample : toss.samples) sample.position_w.y() -= table;
  return toss;
}

bool still(const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  return velocity_w.norm() < toss_still && angular_velocity_w.norm() < 10.0 * toss_still;
}

double along_table(const Vec3& way) { return std::hypot(way.x(), way.z()); }

// Which body axis is nearest to the vertical, and how near.
void find_face(const Quat& orientation_wb, TossOutcome& outcome) {
  const Vec3 up_b = orientation_wb.conjugate() * Vec3::UnitY();
  int axis = 0;
  up_b.cwiseAbs().maxCoeff(&axis);
  outcome.face = 2 * axis + (up_b[axis] > 0.0 ? 1 : 0);
  outcome.tilt = std::acos(std::min(std::abs(up_b[axis]), 1.0));
}

}  // namespace

std::vector<MeasuredToss> read_tosses(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".csv" &&
        entry.path().filename().string().rfind("toss_", 0) == 0)
      files.push_back(entry.path());
  if (files.empty()) throw std::runtime_error(folder.string() + ": has no file toss_*.csv");
  std::sort(files.begin(), files.end());
  std::vector<MeasuredToss> tosses;
  for (const std::filesystem::path& file : files) tosses.push_back(read_toss(file));
  return tosses;
}

TossOutcome measured_outcome(const MeasuredToss& toss) {
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

World toss_world(const MeasuredToss& toss) {
  // x(t) + g t²/2 is a straight line in free flight: its least-squares value and slope at t = 0.
  Vec3 sum = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  Vec3 spin = Vec3::Zero();
  const double middle = 0.5 * static_cast<double>(kFree - 1) * toss_interval;
  double spread = 0.0;
  for (std::size_t k = 0; k < kFree; ++k) {
    const double t = static_cast<double>(k) * toss_interval;
    Vec3 straight = toss.samples[k].position_w;
    straight.y() += 0.5 * kGravity * t * t;
    sum += straight;
    moment += (t - middle) * straight;
    spread += (t - middle) * (t - middle);
    spin += toss.samples[k].angular_velocity_w;
  }
  const double count = static_cast<double>(kFree);
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

TossOutcome simulated_outcome(const MeasuredToss& toss, Technique& technique, double dt) {
  World world = toss_world(toss);
  const Vec3 start = world.states()[1].position_w;
  TossOutcome outcome;
  const int steps = static_cast<int>(std::lround(kTossSeconds / dt));
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

void add(const TossOutcome& outcome, TossNumbers& numbers) {
  numbers.travel.push_back(outcome.travel);
  numbers.time_to_rest.push_back(outcome.time_to_rest);
  numbers.face.push_back(outcome.face);
  if (outcome.rests) ++numbers.resting;
  if (outcome.tilt < 0.035) ++numbers.flat;  // two degrees
}

double quantile_of(std::vector<double> numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  const double place = share * static_cast<double>(numbers.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, numbers.size() - 1);
  return numbers[below] + (place - static_cast<double>(below)) * (numbers[above] - numbers[below]);
}

double distribution_distance(std::vector<double> first, std::vector<double> second) {
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
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

}  // namespace tumble::chapters
