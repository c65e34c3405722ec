/// \file
/// \brief The figures of the chapter on contact forces as a linear complementarity problem.
#pragma once

#include "driver/figure.hpp"

#include <vector>

namespace tumble::chapters {

/// All figures of this chapter, in the order of the page.
/// \return each with its parameters, their defaults, and the function that computes it
std::vector<Figure> analytic_lcp_figures();

/// Adds the figures that show what a contact force is and how pivoting finds it (thesis 2.6, 3.3.1).
/// \param list  gets them
void add_force_figures(std::vector<Figure>& list);

/// Adds the figures of the claims on solvers (thesis 2.6.2, 3.3.1, 5.3) and of their work.
/// \param list  gets them
void add_solver_figures(std::vector<Figure>& list);

/// Adds the figures of time stepping and of Painlevé's rod (thesis 2.6.3).
/// \param list  gets them
void add_time_stepping_figures(std::vector<Figure>& list);

/// Adds the figures of the joined simulator (thesis 3.3.1, 4.3).
/// \param list  gets them
void add_joined_figures(std::vector<Figure>& list);

}  // namespace tumble::chapters
