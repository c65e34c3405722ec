/// \file
/// \brief One frame of cubes on a line, watched: what the experiments with the errata of A.1 have in
///        common.
#pragma once

#include "tumble/timewarp/as_printed/timewarp_as_printed.hpp"

#include "driver/figure.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tumble::chapters {

/// Where a body was known to be at a time, along x.
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
  int passes = 0;                   ///< [-] of the main loop
  bool capped = false;              ///< it was given up
  std::vector<double> valid_times;  ///< [s] by index, as the main loop leaves them
};

/// Cubes of 1 m and 1 kg on a line, without gravity: the scene `line`.
/// \param boxes        place and speed of each as x:v in m and m/s
/// \param restitution  [-] as text
/// \return the world
[[nodiscard]] World line_world(std::string_view boxes, std::string_view restitution = "1");

/// A cube of 1 m and 1 kg above a ground.
/// \param height       [m] of its lower face
/// \param restitution  [-]
/// \return the world; the cube has index 1
[[nodiscard]] World world_with_falling_cube(double height, double restitution);

/// Runs one frame.
/// \param technique  how
/// \param world      a copy is run
/// \param dt         [s] the frame
/// \return what happened
[[nodiscard]] FrameRun run_frame(Technique& technique, const World& world, double dt);

/// Runs one frame of a listing as printed.
/// \param options  which listing, and what is mended
/// \param world    a copy is run
/// \param dt       [s] the frame
/// \return what happened
[[nodiscard]] PrintedRun run_printed(const TimewarpAsPrintedOptions& options, const World& world,
                                     double dt);

/// A listing as meant: all misprints are mended, the choices T5, T9 and F8 are kept.
/// \param listing  which
/// \param cap      [-] passes of the main loop after which a run is given up
/// \param left     misprints that are left in, their ids between commas
/// \return options
[[nodiscard]] TimewarpAsPrintedOptions as_meant_but(TimewarpListing listing, int cap,
                                                    std::string_view left = "");

/// Collects the two numbers of each erratum, and the ways of the bodies on both sides.
class ErrataTables {
 public:
  /// Makes empty tables.
  ErrataTables();

  /// Adds the numbers of an erratum.
  /// \param row      its number in the listing, for the table
  /// \param what     beginning of both names, with the erratum's id
  /// \param printed  end of the name of the first number
  /// \param failure  with the text taken literally
  /// \param reading  end of the name of the second number
  /// \param mended   under the other reading
  /// \param unit     of both
  void add(int row, const std::string& what, const std::string& printed, double failure,
           const std::string& reading, double mended, const std::string& unit);

  /// Adds one number more.
  /// \param name   begins with the erratum's id
  /// \param value  of the number
  /// \param unit   of it
  void add_more(const std::string& name, double value, const std::string& unit);

  /// Adds the ways of all bodies.
  /// \param row     the erratum's number
  /// \param mended  on which side of the figure
  /// \param run     what happened
  void add_ways(int row, bool mended, const FrameRun& run);

  /// All of it.
  /// \return tables "" and "ways", and the numbers
  [[nodiscard]] Result result() const { return {{pairs_, ways_}, quantities_}; }

 private:
  Table pairs_;
  Table ways_;
  std::vector<Quantity> quantities_;
};

}  // namespace tumble::chapters
