/// \file
/// \brief The folder of a run, read back: its scene and its trajectory.
#pragma once

#include "tumble/record/trajectory_file.hpp"
#include "tumble/scenes/scene.hpp"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// Rows of a trajectory that can be read, at most: 2 GB of poses.
inline constexpr int kMostTrajectoryRows = 20000000;

/// One body in one recorded frame: a row of a trajectory.
struct RecordedPose {
  int box = 0;                             ///< place of the body in the scene, from 0
  Vec3 position_w = Vec3::Zero();          ///< [m] centre of mass, world frame
  Quat orientation_wb = Quat::Identity();  ///< [-] body to world
  Vec3 velocity_w = Vec3::Zero();          ///< [m/s] of the centre of mass, world frame
  Vec3 angular_velocity_w = Vec3::Zero();  ///< [rad/s] world frame
};

/// All bodies at one recorded time.
struct RecordedFrame {
  double time = 0.0;                ///< [s]
  std::vector<RecordedPose> poses;  ///< those that there were
};

/// What a run recorded.
struct RecordedRun {
  Scene scene;                        ///< of scene.toml
  std::vector<RecordedFrame> frames;  ///< of its table, times ascending, at least one
};

/// Reads scene.toml and the trajectory of a run's folder. Numbers have the bits that were written.
/// \param table   kTrajectoryFile for the poses as computed, kFilteredFile for those that its filter
///                showed
/// \throws std::invalid_argument "FILE:LINE: KEY = VALUE: what would be right", or if one of the files
///         cannot be read, has a line of 64 KiB, or more than kMostTrajectoryRows rows
RecordedRun read_run(const std::filesystem::path& folder, std::string_view table = kTrajectoryFile);

/// Reads a trajectory from an open file or from memory.
/// \param in     what the file holds, from its first line on
/// \throws std::invalid_argument as read_run() does
RecordedRun read_trajectory(Scene scene, std::istream& in, const std::string& name);

/// What was to be seen at a time. Between two recorded frames positions go along straight lines and
/// orientations turn the shorter way; a body is there if both frames have it, and velocities are those of the
/// frame before.
/// \param time  [s] within the recorded times
/// \return the recorded frame itself at its time
/// \throws std::invalid_argument naming the recorded times if `time` is outside
/// \verified{Between recorded frames boxes are interpolated linearly, and boxes of one frame alone are absent}
RecordedFrame frame_at(const RecordedRun& run, double time);

/// The bodies of a frame as a world, at rest.
/// \return the ground, if there is one, and the frame's bodies with their names
World world_of(const RecordedRun& run, const RecordedFrame& frame);

/// The frame that is nearest in time.
/// \param time  [s] within the recorded times, or half a frame outside
/// \throws std::invalid_argument naming the recorded times if `time` is outside
const RecordedFrame& nearest_frame(const RecordedRun& run, double time);

}  // namespace tumble
