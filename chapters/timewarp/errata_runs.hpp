/// \file
/// \brief One frame of cubes on a line, watched: shared by the experiments with the errata of A.1.
#pragma once

#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include "driver/figure.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble::chapters {

inline constexpr double kLineFrame = 1.0;  ///< [s] of the scenes on a line

/// The place of a body at a time, along x.
struct WayPoint {
  double time = 0.0;   ///< [s] since the start of the frame
  double place = 0.0;  ///< [m]
  bool hit = false;    ///< a collision; else the start or the end of the frame
};

/// A frame as it went.
struct FrameRun {
  std::vector<double> places;               ///< [m] along x at the end, by index
  std::vector<std::vector<WayPoint>> ways;  ///< by index
  std::vector<Event> events;                ///< collisions, as they were resolved
  World world;                              ///< at the end
};

/// A frame of a listing as printed.
struct PrintedRun : FrameRun {
  double passes = 0.0;              ///< [-] of the main loop
  std::vector<double> valid_times;  ///< [s] by index, as the main loop leaves them
};

/// Cubes of 1 m and 1 kg on a line, without gravity: the scene `line`.
/// \param boxes        place and speed of each as x:v in m and m/s
/// \param restitution  [-] as text
/// \return the world
[[nodiscard]] World line_world(const std::string& boxes, const std::string& restitution = "1");

/// A cube of 1 m and 1 kg above a ground.
/// \param height       [m] of its lower face
/// \param restitution  [-]
/// \return the world; the cube has index 1
[[nodiscard]] World world_with_falling_cube(double height, double restitution);

/// Runs one frame.
/// \param technique  how
/// \param world      a copy is run
/// \param dt         [s] the frame
/// \return the run
[[nodiscard]] FrameRun run_frame(Technique& technique, const World& world, double dt);

/// The experiments with the errata of one listing: runs of it, and the numbers and ways of bodies that they
/// collect.
class ErrataBench {
 public:
  using Reading = std::pair<std::string, double>;  ///< end of a quantity's name, and its value

  /// Makes empty tables.
  /// \param listing  which
  /// \param cap      passes of the main loop after which a run is given up
  ErrataBench(TimewarpListing listing, int cap);

  /// The listing as meant: all misprints are mended, the choices T5, T9 and F8 are kept.
  /// \param left  misprints that are left in, their ids between commas
  /// \return options
  [[nodiscard]] TimewarpAsPrintedOptions as_meant_but(std::string_view left = "") const;

  /// Runs one frame of the listing with some misprints left in.
  /// \param left   as of as_meant_but()
  /// \param world  a copy is run
  /// \param dt     [s] the frame
  /// \return the run
  [[nodiscard]] PrintedRun run(std::string_view left, const World& world,
                               double dt = kLineFrame) const;

  /// Adds the numbers of an erratum.
  /// \param row      its number in the listing, for the table
  /// \param what     beginning of both names, with the erratum's id
  /// \param unit     of both
  /// \param printed  the text taken literally
  /// \param mended   the other reading
  void add(int row, const std::string& what, const std::string& unit, const Reading& printed,
           const Reading& mended);

  /// Adds the ways of all bodies on both sides of the figure.
  /// \param row      the erratum's number
  /// \param printed  with the text taken literally
  /// \param mended   under the other reading
  void show(int row, const FrameRun& printed, const FrameRun& mended);

  Result result;  ///< tables "" and "ways" and others, and the numbers

 private:
  TimewarpListing listing_;
  int cap_;
};

/// Runs one frame of a listing as printed.
/// \param options  the listing, and the errata that are mended
/// \param world    a copy is run
/// \param dt       [s] the frame
/// \return the run
[[nodiscard]] PrintedRun run_printed(const TimewarpAsPrintedOptions& options, const World& world,
                                     double dt = kLineFrame);

/// The figure of a listing.
/// \param name     of it
/// \param listing  which
/// \param parts    each adds some errata
/// \return it, with the parameter `cap`
[[nodiscard]] Figure errata_figure(const std::string& name, TimewarpListing listing,
                                   const std::vector<void (*)(ErrataBench&)>& parts);

}  // namespace tumble::chapters
