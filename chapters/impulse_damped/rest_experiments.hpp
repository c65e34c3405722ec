/// \file
/// \brief What rests, and what rest saves (thesis 3.1, 4.5, 6.1).
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// Adds the figures of claims 2.4.2a, 3.1a, 4.5a, 6.1a and 6.3.1a.
/// \param list  gets "claim_2_4_2a_tosses", "claim_3_1a_faces", "claim_4_5a_sleeping",
///              "claim_6_1a_frame_rate" and "claim_6_3_1a_size"
void add_rest_figures(std::vector<Figure>& list);

/// Claim 3.1a: whether boxes that flew together come to rest on their faces.
/// \param settings  smallest, largest (cubes along each edge), duration, seeds
/// \return table "" (share of the boxes by tilt); how many rest with a face down
Result measure_faces(const Parameters& settings);

/// Claim 4.5a: work of a step against how many boxes move; who wakes if a support goes.
/// \param settings  stacks, boxes, speed
/// \return tables "" (work by share of moving boxes) and "wake" (who is awake by step)
Result measure_sleeping(const Parameters& settings);

/// Claim 6.1a: how much there is to do in a step of the clump and of the pyramid.
/// \param settings  per_edge, rows (the largest), duration
/// \return tables "" (clumps) and "pyramid", counts by number of boxes
Result measure_frame_work(const Parameters& settings);

}  // namespace tumble::chapters
