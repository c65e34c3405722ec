/// \file
/// \brief Every way to tell who stands firm, judged on random piles (thesis 5.4, 6.3.1).
#pragma once

#include "driver/figure.hpp"

#include <string>
#include <vector>

namespace tumble::chapters {

/// The figures on random piles: "stable_confusion", "claim_5_4a_any_load" and "claim_5_4c_hull".
/// \return with their parameters, their defaults, and the functions that compute them
std::vector<Figure> pile_figures();

/// A share of what is counted in each pile, with its interval over the piles.
/// \param name   of the quantity
/// \param hits   by pile
/// \param trials  by pile
/// \return the sum of hits over that of trials
Quantity share_over_piles(std::string name, const std::vector<double>& hits,
                          const std::vector<double>& trials);

/// What each way calls stable in random piles, against what rests by the complementarity problem.
/// \param settings  piles, shown
/// \return tables "" (a row for each way); drawing "pile" (one of them); how much each way misses, and
///         what it calls stable that moves
/// \throws std::runtime_error if a problem of contact forces has no answer
Result measure_confusion(const Parameters& settings);

}  // namespace tumble::chapters
