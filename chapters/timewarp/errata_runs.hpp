/// \file
/// \brief One frame of cubes on a line, watched: shared by the experiments with the errata of A.1.
#pragma once

#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {

inline constexpr double kLineFrame = 1.0;  // [s] of the scenes on a line

// The place of a body at a time, along x.
struct WayPoint {
  double time = 0.0;   // [s] since the start of the frame
  double place = 0.0;  // [m]
  bool hit = false;    // a collision; else the start or the end of the frame
};

// A frame as it went.
struct FrameRun {
  std::vector<double> places;               // [m] along x at the end, by index
  std::vector<std::vector<WayPoint>> ways;  // by index
  std::vector<Event> events;                // collisions, as they were resolved
  World world;                              // at the end
};

// A frame of a listing as printed.
struct PrintedRun : FrameRun {
  double passes = 0.0;              // [-] of the main loop
  std::vector<double> valid_times;  // [s] by index, as the main loop leaves them
};

// Cubes of 1 m and 1 kg on a line, without gravity: the scene `line`.
// restitution: [-] as text
[[nodiscard]] World line_world(const std::string& boxes, const std::string& restitution = "1");

// A cube of 1 m and 1 kg above a ground.
// height: [m] of its lower face
// restitution: [-]
[[nodiscard]] World world_with_falling_cube(double height, double restitution);

// Runs one frame.
// dt: [s] the frame
[[nodiscard]] FrameRun run_frame(Technique& technique, const World& world, double dt);

// The experiments with the errata of one listing: runs of it, and the numbers and ways of bodies that they
// collect.
class ErrataBench {
 public:
  using Reading = std::pair<std::string, double>;  // end of a quantity's name, and its value

  // Makes empty tables.
  ErrataBench(TimewarpListing listing, int cap);

  // The listing as meant: all misprints are mended, the choices T5, T9 and F8 are kept.
  [[nodiscard]] TimewarpAsPrintedOptions as_meant_but(std::string_view left = "") const;

  // Runs one frame of the listing with some misprints left in.
  // dt: [s] the frame
  [[nodiscard]] PrintedRun run(std::string_view left, const World& world,
                               double dt = kLineFrame) const;

  // Adds the numbers of an erratum.
  void add(int row, const std::string& what, const std::string& unit, const Reading& printed,
           const Reading& mended);

  // Adds the ways of all bodies on both sides of the figure.
  void show(int row, const FrameRun& printed, const FrameRun& mended);

  Result result;  // tables "" and "ways" and others, and the numbers

 private:
  TimewarpListing listing_;
  int cap_;
};

// Runs one frame of a listing as printed.
// dt: [s] the frame
[[nodiscard]] PrintedRun run_printed(const TimewarpAsPrintedOptions& options, const World& world,
                                     double dt = kLineFrame);

// The figure of a listing.
[[nodiscard]] Figure errata_figure(const std::string& name, TimewarpListing listing,
                                   const std::vector<void (*)(ErrataBench&)>& parts);

}  // namespace tumble::chapters
