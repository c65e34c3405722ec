/// \file
/// \brief How much a stack chatters that is held up by impulses without damping (thesis 3.3.2).
#pragma once

#include "driver/figure.hpp"

namespace tumble::chapters {

/// Chatter of a stack against the time step, for all rules of normals, points and shock.
///
/// The cubes of the stack start at rest on top of each other, moved aside and turned about the
/// vertical at random. The method is damped integration without damping and without geometrically
/// stable boxes. Chatter is the amplitude of ChatterMeter: of each half second that ends after the
/// first second, mean over those in which a box rests. A box counts as in contact up to 1 % of its edge from
/// another one, so that hops that small count as chatter.
/// \param settings  boxes, restitution, aside, turn, duration, finest, seeds, many
/// \return table "": for each rule and step the amplitude; the shares of it that go away
Result measure_oscillation(const Parameters& settings);

}  // namespace tumble::chapters
