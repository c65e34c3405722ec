/// \file
/// \brief The usual headers of an experiment: figures, scenes that are played, statistics, and the scenes,
///        numbers and chance of the library.
#pragma once

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/random.hpp"
#include "tumble/dynamics/energy.hpp"
#include "tumble/math/elementary.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/scenes/library.hpp"

#include "driver/played_scene.hpp"
#include "driver/registry.hpp"
#include "driver/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
