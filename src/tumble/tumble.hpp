/// \file
/// \brief All that a program which simulates scenes needs: worlds, simulations, techniques, scenes, records.
#pragma once

#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/dynamics/snapshot.hpp"
#include "tumble/dynamics/trajectory.hpp"
#include "tumble/record/run_files.hpp"
#include "tumble/scenes/library.hpp"
#include "tumble/scenes/scene_file.hpp"
#include "tumble/scenes/simulation.hpp"
#include "tumble/techniques.hpp"
