/// \file
/// \brief The two ways in which techniques with contact put bodies where they are next.
#include "tumble/dynamics/pose_update.hpp"

#include <array>
#include <stdexcept>

namespace tumble {
namespace {

constexpr std::array<PoseUpdate, 2> kUpdates = {PoseUpdate::separate, PoseUpdate::exponential};

}  // namespace

std::span<const PoseUpdate> pose_updates() { return kUpdates; }

std::string_view name_of(PoseUpdate update) {
  switch (update) {
    case PoseUpdate::separate: return "separate";
    case PoseUpdate::exponential: return "exponential";
  }
  throw std::invalid_argument("tumble: not a pose update");
}

}  // namespace tumble
