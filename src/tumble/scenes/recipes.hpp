/// \file
/// \brief The recipes of the built-in scenes, grouped by subject.
#pragma once

#include "tumble/scenes/library.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// Recipes of built-in scenes; users find them through scene_library().
namespace tumble::recipes {

using namespace declare;

/// Boxes piled up at rest: stack, pyramid, pyramid3d, wall.
void add_structures(std::vector<SceneRecipe>& list);

/// One or two boxes: box_drop, bouncing_box, tumbling_box, two_boxes, crate_off_table, cradle.
void add_single(std::vector<SceneRecipe>& list);

/// Boxes that slide, or carry others along: slide, slope, fig5_2, sled.
void add_sliding(std::vector<SceneRecipe>& list);

/// Boxes near the limit of balance: rocking_block, seesaw, fig6_5, leaning, table.
void add_balanced(std::vector<SceneRecipe>& list);

/// Boxes some of which cannot move, whatever presses on them: fig5_3, fig5_4, fig5_5, fig5_6, fig6_4.
void add_stability(std::vector<SceneRecipe>& list);

/// Many boxes in motion: clump, projectile, dice, cage, toss; fig6_6, fig6_7.
void add_thrown(std::vector<SceneRecipe>& list);

/// Boxes that stick together and turn about a point outside them: fig6_1, fig6_2, fig6_3.
void add_turning(std::vector<SceneRecipe>& list);

/// Boxes in joints: chain, pendulum, crane, plank_bridge.
void add_jointed(std::vector<SceneRecipe>& list);

/// Boxes on a line whose collisions have an order: line, fig5_1.
void add_lines(std::vector<SceneRecipe>& list);

/// Declares also how far the boxes of a pile are from their places: `scatter` and `scatter_angle`, 0 by default.
Parameters with_scatter(Parameters p);

/// Builds a pile anew, less exactly: each box in turn is shifted sideways by up to `scatter` along
/// x and z and turned by up to `scatter_angle` about any axis, is then lowered until it touches the
/// ground or a box before it, and is lifted by up to `scatter`.
///
/// Nothing overlaps whatever the settings are: a box that has become too wide for its place lies on
/// its neighbours. With both settings 0 not a bit of the scene changes.
/// \param p       has the settings of with_scatter()
/// \param random  one stream for each box is taken from it
/// \param scene   boxes above a ground, each after those that it stands on
/// \par Cost
/// O(n²) comparisons of bounds, and a sweep for each pair that is one above the other.
void scatter(const Parameters& p, const Random& random, Scene& scene);

/// Puts the bricks of the pyramid of pyramid() into a scene; projectile() shoots at it.
/// \param rows     boxes in the lowest row
/// \param spacing  [-] from centre to centre, in edges
/// \param scene    gets the boxes
void build_pyramid(int rows, double spacing, Scene& scene);

/// Puts the boxes of clump() into a scene; projectile() shoots at it.
/// \param per_edge  boxes along each edge of the grid
/// \param spacing   [m] from centre to centre
void build_clump(int per_edge, double spacing, Random random, Scene& scene);

/// A movable box that is at rest and upright.
/// \param size        [m] full edge lengths
/// \param mass        [kg]
/// \return the box, with the friction and restitution of SceneBox
SceneBox box_at(std::string_view name, const Vec3& size, const Vec3& position_w, double mass = 1.0);

/// An immovable box that is upright.
/// \param size        [m] full edge lengths
SceneBox fixed_at(std::string_view name, const Vec3& size, const Vec3& position_w);

/// Declares `friction`.
Parameter friction();

/// Declares also `friction` and `restitution`.
/// \param friction     [-] its default
/// \param restitution  [-] ditto
Parameters with_surface(Parameters p, double friction, double restitution);

/// Gives all boxes the settings `friction` and `restitution`.
void set_surfaces(const Parameters& p, Scene& scene);

/// The same, and puts the scene on such a ground.
void add_bouncing_ground(const Parameters& p, Scene& scene);

/// Puts a scene on the ground, with one friction everywhere.
/// \param scene  its boxes get that friction too
void add_ground(const Parameters& p, Scene& scene);

/// A box's name: a stem and its place, such as "level3" or "l2_1_4".
/// \param stem    letters
/// \param places  numbers from 1, with a low line between them
std::string numbered(std::string_view stem, std::initializer_list<int> places);

}  // namespace tumble::recipes
