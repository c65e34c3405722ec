/// \file
/// \brief The fuzz targets: each takes any bytes and looks for a promise that the library breaks.
///
/// A target throws BrokenPromise; a refusal (std::invalid_argument with a message) is no mistake. Everything
/// else that goes wrong, a crash or an endless loop, is seen by whatever runs the target.
#pragma once

#include "fuzz/promise.hpp"

#include <array>
#include <string_view>

namespace tumble::fuzz {

// A scene file: is read or refused, is written and read back the same, and the first three steps are finite.
void fuzz_scene(Bytes bytes);

// A Matrix Market file: is read or refused, and is read back to the same bits. With a second one after a NUL
// byte that is a vector of at most 8 rows, the two are a problem that every solver gets.
void fuzz_matrix(Bytes bytes);

// A run's folder: scene.toml up to the first NUL byte, trajectory.csv after it.
void fuzz_run_folder(Bytes bytes);

// Two boxes with edges from 1e-3 to 1e3 that are aligned, nearly aligned or turned anyhow: contact points.
void fuzz_boxes(Bytes bytes);

// A technique's number (one byte) and the seed of a random world (eight), 20 steps, of slow techniques 5.
void fuzz_world(Bytes bytes);

// Seed (eight bytes), size, rank, units and equalities (one each) of a problem with a known solution.
void fuzz_complementarity(Bytes bytes);

// A target by name.
struct Target {
  std::string_view name;  // of its folder in corpus
  void (*run)(Bytes);     // throws BrokenPromise
};

// All targets.
inline constexpr std::array<Target, 6> kTargets{{{"scene", fuzz_scene},
                                                 {"matrix", fuzz_matrix},
                                                 {"run_folder", fuzz_run_folder},
                                                 {"boxes", fuzz_boxes},
                                                 {"world", fuzz_world},
                                                 {"complementarity", fuzz_complementarity}}};

}  // namespace tumble::fuzz
