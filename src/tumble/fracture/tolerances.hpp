/// \file
/// \brief The small numbers of `fracture`.
#pragma once

namespace tumble::tolerance {

// --- fracture -------------------------------------------------------------------------------

/// [-] Sine of the angle, seen from a node that cracks, up to which the plane goes through what it passes. Reason: that of
/// O'Brien and Hodgins is a tenth of a radian; thinner elements would need as much shorter steps. (2.4.1)
inline constexpr double crack_angle = 0.1;

/// [-] Smallest height of an element that a split may leave, over that of the smallest at the start. Reason: a quarter divides the
/// step by four at most; a tenth makes cracks hardly straighter. (2.4.1)
inline constexpr double crack_least = 0.25;

/// [-] Bound of the principal stress of an element, over the strength, from which its nodes are looked at. Reason: a node's separation is
/// a mean of its elements', so one of them has more. (2.4.1)
inline constexpr double crack_tension = 0.8;

/// [-] Time between searches for cracks, over the Courant step at the start. Reason: stress changes no faster than a wave goes through
/// a cell. (2.4.1)
inline constexpr double crack_look = 0.5;

/// [-] How deep in another piece a node is still pushed out, over the smallest height of an element at the start. Reason: deeper it may have
/// come from another side. (2.4.1)
inline constexpr double fracture_deepest = 0.02;

/// [-] Stiffness of contacts over mass, as a share of the square of the highest frequency of an element at the start.
/// Reason: it shortens the step by a twentieth. (2.4.1)
inline constexpr double fracture_contact = 0.1;

/// [-] Damping of contacts, of the critical one. Reason: a node leaves with half of its speed, and the step has room for it. (2.4.1)
inline constexpr double fracture_damping = 0.2;

/// [-] Step over the stable one. Reason: at nine tenths a light node at a crack swings itself up whenever the step changes, and stretched
/// elements need some room. (2.4.1)
inline constexpr double fracture_step = 0.7;

}  // namespace tumble::tolerance
