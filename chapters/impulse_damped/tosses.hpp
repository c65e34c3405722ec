/// \file
/// \brief Measured tosses of a real cube onto a table, and the same tosses simulated.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::chapters {

/// Where the cube was at one instant, y up, the table at y = 0.
struct TossSample {
  Vec3 position_w = Vec3::Zero();          ///< [m] centre
  Quat orientation_wb = Quat::Identity();  ///< [-] body to world
  Vec3 velocity_w = Vec3::Zero();          ///< [m/s] of the centre
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] world frame
};

/// One toss, from the hand to rest.
struct MeasuredToss {
  std::string name;                 ///< of the file, for example "toss_007"
  std::vector<TossSample> samples;  ///< one every `toss_interval`
};

/// [s] That are simulated; the measured cubes rest after 0.7.
inline constexpr double kTossSeconds = 2.0;

/// How a toss ended.
struct TossOutcome {
  int face = 0;         ///< which face is up: 2 i for the one at -axis i of the cube, 2 i + 1 at +
  double tilt = 0.0;    ///< [rad] between that face's normal and the vertical
  double travel = 0.0;  ///< [m] from start to end, along the table
  double time_to_rest = 0.0;  ///< [s] from the start until it moves no more, see `toss_still`
  bool rests = false;         ///< whether it moved no more at the end
};

/// The outcomes of many tosses, one number each.
struct TossNumbers {
  std::vector<double> travel;        ///< [m] of each
  std::vector<double> time_to_rest;  ///< [s] of each
  std::vector<int> face;             ///< of each
  int resting = 0;                   ///< how many rest at the end
  int flat = 0;                      ///< how many end with a face up, within two degrees
};

/// [s] between two samples: the camera took 148 a second.
inline constexpr double toss_interval = 1.0 / 148.0;

/// [m] edge of the cube.
inline constexpr double toss_edge = 0.1048;

/// [m/s] A cube that is slower moves no more, if it turns slower than ten times this in rad/s,
/// which is about the same speed at its corners. Five times the noise of the measured speed at
/// rest.
inline constexpr double toss_still = 0.02;

/// Reads the tosses of a folder, z up as they were measured, and turns them y up.
///
/// The data are ContactNets' (Pfrommer, Halm, Posa, CoRL 2020), one CSV file for each toss, with a
/// header and position, quaternion w x y z, velocity, and angular velocity in the cube's frame. At
/// rest the measured centre is 1 mm below half an edge; each toss is lifted until it is not.
/// \param folder  with files toss_*.csv
/// \return in the order of their names
/// \throws std::runtime_error naming the file with a row that has not 13 numbers, or the folder if
///         it has none
std::vector<MeasuredToss> read_tosses(const std::filesystem::path& folder);

/// How a measured toss ended.
/// \param toss  from read_tosses()
/// \return its last sample says
TossOutcome measured_outcome(const MeasuredToss& toss);

/// The cube and the table at the start of a toss.
///
/// Position and velocity are the least-squares free flight through the first eight samples, in
/// which no corner is at the table yet; the angular velocity is their mean. Mass 0.37 kg, moment of
/// inertia 0.00081 kg m², friction 0.18 and restitution 0.125 are those that go with the data.
/// \param toss  from read_tosses()
/// \return the table as the ground, and the cube
World toss_world(const MeasuredToss& toss);

/// Simulates a toss for two seconds.
/// \param toss       where it starts
/// \param technique  fresh: one that has seen no step
/// \param dt         [s] length of a step
/// \return how it ended
TossOutcome simulated_outcome(const MeasuredToss& toss, Technique& technique, double dt);

/// Adds an outcome to others.
/// \param outcome  one more
/// \param numbers  gets it
void add(const TossOutcome& outcome, TossNumbers& numbers);

/// A quantile, with straight lines between the sorted numbers.
/// \param numbers  at least one
/// \param share    [-] 0 to 1; 0.5 is the median
/// \return the number below which this share of them is
double quantile_of(std::vector<double> numbers, double share);

/// The distance of Kolmogorov and Smirnov, \f$\max_x |F_1(x) - F_2(x)|\f$ of the shares of numbers
/// up to x.
/// \param first   at least one number
/// \param second  at least one number
/// \return [-] 0 to 1
double distribution_distance(std::vector<double> first, std::vector<double> second);

}  // namespace tumble::chapters
