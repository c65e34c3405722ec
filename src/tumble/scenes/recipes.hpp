/// \file
/// \brief The recipes of the built-in scenes, grouped by what happens in them.
#pragma once

#include "tumble/scenes/library.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// Recipes of built-in scenes; users find them through scene_library().
namespace tumble::recipes {

/// Boxes piled up at rest: stack, pyramid, pyramid3d, wall.
/// \param list gets the recipes
void add_structures(std::vector<SceneRecipe>& list);

/// One or two boxes: box_drop, bouncing_box, tumbling_box, two_boxes, crate_off_table, cradle.
/// \param list gets the recipes
void add_single(std::vector<SceneRecipe>& list);

/// Many boxes in motion: clump, projectile, dice, cage; fig6_6, fig6_7.
/// \param list gets the recipes
void add_thrown(std::vector<SceneRecipe>& list);

/// Puts the bricks of the pyramid of pyramid() into a scene; projectile() shoots at it.
/// \param rows     boxes in the lowest row
/// \param spacing  [-] from centre to centre, in edges
/// \param scene    gets the boxes
void build_pyramid(int rows, double spacing, Scene& scene);

/// Puts the boxes of clump() into a scene; projectile() shoots at it.
/// \param per_edge  boxes along each edge of the grid
/// \param spacing   [m] from centre to centre
/// \param random    orientations
/// \param scene     gets the boxes
void build_clump(int per_edge, double spacing, Random random, Scene& scene);

/// A box's name: a stem and its place, such as "level3" or "l2_1_4".
/// \param stem    letters
/// \param places  numbers from 1, with a low line between them
/// \return the name
std::string numbered(std::string_view stem, std::initializer_list<int> places);

}  // namespace tumble::recipes
