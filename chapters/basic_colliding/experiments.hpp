/// \file
/// \brief What is measured for the chapter on basic colliding and for the layers below it.
#pragma once

#include "driver/figure.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// All figures of this chapter, in the order of the page.
/// \return each with its parameters, their defaults, and the function below that computes it
std::vector<Figure> basic_colliding_figures();

/// Adds the figures of the claims on handling collisions (thesis 2.1, 2.5.2), and of the errata of
/// the event search (5.1, A.1).
/// \param list  gets them
void add_response_figures(std::vector<Figure>& list);

/// Adds the figures of the claims on finding collisions (thesis 3.2, 3.3.1, 3.3.2, 4.1).
/// \param list  gets them
void add_detection_figures(std::vector<Figure>& list);

/// Adds the figures that show boxes in three dimensions: the strip of a thrown die, and a picture of
/// each built-in scene, called `gallery_...`; of figures of the thesis, those that run in the book.
/// \param list  gets them
void add_picture_figures(std::vector<Figure>& list);

/// A tumbling box under each rotation rule beside Euler's exact solution (thesis 3.1).
///
/// The box is spun about its middle axis, which is unstable, and turns over again and again. The
/// exact angular velocity is made of Jacobi's elliptic functions.
/// \param settings  step, duration
/// \return tables "" (middle angular velocity and energy error over time) and "flips" (error of the
///         first flip for each step and rule); the first flip and the largest errors
Result measure_rotation_rules(const Parameters& settings);

/// The error of each rotation rule against the step (thesis 3.1).
/// \param settings  time, halvings
/// \return table "" (angle from the true orientation); the measured orders
Result measure_rotation_order(const Parameters& settings);

/// The error of a fall under forward Euler, semi-implicit Euler and ballistic flight (thesis 3.1).
/// \param settings  height, duration, halvings
/// \return table "" (error of the height for each step); the measured orders and errors
Result measure_free_fall(const Parameters& settings);

/// A ball-like drop of a box with ever smaller bounces (thesis 4.3).
/// \param settings  height, restitution, threshold
/// \return tables "" (height over time) and "impacts" (time and rebound speed of each impact beside
///         the closed form); the number of bounces and the time until the rebound is slow
Result measure_zeno(const Parameters& settings);

/// The impact times that the basic technique finds for a bouncing cube (thesis 2.1; claim 2.1a).
/// \param settings  height, restitution, impacts, step, resolution
/// \return tables "" (time and energy of each impact beside the closed form) and "path" (height over
///         time); the largest errors, and the work
Result measure_impact_times(const Parameters& settings);

/// The basic technique on a cube that comes to rest (thesis 2.1; claim 2.1b).
/// \param settings  height, restitution, duration, step, resolution, cap, clear
/// \return tables "" (impacts and heights of each step), "path" (height over time), "cleared" (the
///         steps of a run whose overlap is lifted clear of the ground) and "rest" (moment of rest,
///         cap, what the repair leaves); the share of the steps that end at the cap
Result measure_rest(const Parameters& settings);

/// A stack held up by impulses alone (thesis 2.5.2; claim 2.5.2a).
/// \param settings  most, restitution, duration, seeds, cap
/// \return table "" (impulses per second against the height, for two shortest hops); the ratio of four
///         cubes to one, with intervals
Result measure_stack_impulses(const Parameters& settings);

/// What the text leaves open about finding impacts, taken literally and mended (thesis 3.2, 3.3.1,
/// 5.1, A.1; errata S5 to S9).
/// \param settings  cap
/// \return tables "pass_...", "flights_...", "side_...", "fall" and "landing"; for each erratum a
///         number that shows the failure and the same number mended
Result measure_event_search_errata(const Parameters& settings);

/// Newton's cradle, with all impulses at once and one after the other (thesis 3.2).
/// \param settings  boxes, moving, restitution
/// \return table "" (velocity of each box before and after, in both readings); energies and errors
Result measure_cradle(const Parameters& settings);

/// How many passes one-contact-at-a-time needs for a stack (thesis 3.3).
/// \param settings  most, accuracy
/// \return table "" (passes against the height of the stack beside the closed form); some of them
Result measure_stack_convergence(const Parameters& settings);

/// The contact area of a cube that stands turned on another one (thesis 3.2).
/// \param settings  size, steps
/// \return tables "" (area and number of contact points against the angle) and "polygons" (three of
///         the areas); the largest error
Result measure_box_overlap(const Parameters& settings);

/// Random passes of a small cube by a large one: which collisions does a test at the end of each
/// step find (thesis 3.2)?
///
/// A share of all passes is sampled densely, and every collision that the end-of-step test finds has
/// to be one for the conservative search as well.
/// \param settings  passes, thickness, spin
/// \return table "" (share found for each speed, three sizes, brushes apart); the share at 4
///         thicknesses per step, closed form, contradictions
/// \throws std::runtime_error if a search does not end
Result measure_missed_passes(const Parameters& settings);

/// Visible collisions that the end-of-step test misses in the thesis's scenes (thesis 3.2).
/// \param settings  seeds, rows, per_edge, duration, event_cap
/// \return table "" (share missed against the depth that counts as visible, both scenes); the share
///         at 1 %, counts
/// \throws std::runtime_error if a search does not end
Result measure_missed_visible(const Parameters& settings);

/// How often the search for an impact has to start again (thesis 3.3.1).
/// \param settings  seeds, duration, count, room
/// \return table "" (restarts per collision against the step, and the share of careful searches that
///         uncover a collision of bodies apart at the end); the ratio of 1/480 s to 1/60 s
/// \throws std::runtime_error if a step ends at the event cap
Result measure_restarts(const Parameters& settings);

/// Tests of pairs of bounds with and without a broad phase (thesis 4.1).
/// \param settings  seeds, steps, spacing, most
/// \return table "" (tests per step against the number of bodies, four methods); the ratio at 1000
///         bodies, crossing points
/// \throws std::runtime_error if two methods find different pairs
Result measure_subdivision(const Parameters& settings);

/// The signed distance of a box beside its closest face (thesis 3.3.2): operations, and how wrong
/// the closest face of the step before is as a normal.
/// \param settings  queries, paths, speed, spin
/// \return tables "" (operations by kind), "angles" (histogram) and "speeds" (share of wrong normals
///         against the speed); the ratio of operations
/// \throws std::runtime_error if the counted functions and the library's differ in a bit
Result measure_signed_distance(const Parameters& settings);

/// A thrown die under the basic technique, in six frames (thesis 2.1, 4.2).
/// \param settings  speed, spin, restitution, seed, first, interval, step
/// \return table "" (poses in the frames), drawings "frame1" to "frame6"; the first impact beside
///         that of the exact flight, the side up at the end, energy booked
/// \throws std::runtime_error if the die begins to rest before the last frame, or has not met the
///         ground by then
Result measure_dice_strip(const Parameters& settings);

/// A picture of a built-in scene after a run with the basic technique.
/// \param name      of the scene
/// \param settings  those of the scene, and time, event_cap, view_x, view_y, view_z
/// \return table "" (poses), drawing "boxes"; how many boxes move, their lowest point
Result measure_gallery(const std::string& name, const Parameters& settings);

}  // namespace tumble::chapters
