/// \file
/// \brief trajectory.csv and trajectory_filtered.csv: a row for each body and recorded frame.
#pragma once

#include "tumble/filtering/pose_filter.hpp"
#include "tumble/record/table_file.hpp"

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// The file of the poses that were computed.
inline constexpr std::string_view kTrajectoryFile = "trajectory.csv";
/// The file of the poses that a filter shows.
inline constexpr std::string_view kFilteredFile = "trajectory_filtered.csv";

/// A table of where bodies are and how fast they move, frame by frame. The ground has no rows.
class TrajectoryFile {
 public:
  /// Creates the file with its first line.
  /// \throws CannotWrite naming the path and the reason
  explicit TrajectoryFile(std::filesystem::path path);

  /// Adds a row for each body.
  /// \param world the bodies, whose time is that of the frame
  /// \throws CannotWrite if a block of rows could not be written
  void write(const World& world);

  /// Adds a row.
  /// \param time                [s] of the frame
  /// \param pose                for the position and the orientation alone
  /// \param velocity_w          [m/s] of the centre of mass, world frame
  /// \throws CannotWrite if a block of rows could not be written
  void write(double time, std::string_view name, const BodyState& pose, const Vec3& velocity_w,
             const Vec3& angular_velocity_w);

  /// Hands everything to the system.
  /// \throws CannotWrite if it could not be written
  void flush() { table_.flush(); }

 private:
  TableFile table_;
};

/// The same table as a filter shows it: times, bodies and velocities as computed, positions and
/// orientations filtered.
///
/// Frames are written when the filter shows them, so that memory is bounded: as many frames are kept
/// as the filter holds back. A frame that the filter refuses, because a state in it is not finite,
/// ends the table: the frames before it are all there.
class FilteredTrajectoryFile {
 public:
  /// Creates the file with its first line.
  /// \param filter  of which a fresh copy is used
  /// \throws CannotWrite naming the path and the reason
  FilteredTrajectoryFile(std::filesystem::path path, const PoseFilter& filter);

  /// Takes in a frame, and writes those that can be shown by now.
  /// \param world the bodies, whose time is that of the frame
  /// \throws CannotWrite if a block of rows could not be written
  void write(const World& world);

  /// The run is over: writes what was held back.
  /// \throws CannotWrite if something could not be written
  void finish();

  /// How many frames are in the table up to now, the start included.
  [[nodiscard]] std::int64_t frames() const { return frames_; }

  /// Why the table ends before the run does.
  /// \return what the filter said of the first frame that it refused; empty if there was none
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

 private:
  struct Known {
    std::string name;
    bool ground = false;
  };
  struct Velocities {
    Vec3 velocity_w;
    Vec3 angular_velocity_w;
  };

  void show(const Frame& frame);

  TrajectoryFile table_;
  std::unique_ptr<PoseFilter> filter_;
  std::map<BodyId, Known> known_;              // every body that there has been
  std::deque<std::vector<Velocities>> moves_;  // of the frames that are held back, in their order
  std::int64_t frames_ = 0;
  std::string refusal_;
};

}  // namespace tumble
