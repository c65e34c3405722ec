/// \file
/// \brief The engines beside ours that were found at build time, and their settings.
#include "scene_peers.hpp"

namespace scene_bench {

std::vector<EngineChoice> peer_choices() {
  std::vector<EngineChoice> out;
#ifdef TUMBLE_HAVE_BULLET
  const auto bullet = [](int iterations, bool two_directions) {
    return [=](const tumble::World& start, bool sleeping) {
      return make_bullet(start, sleeping, iterations, two_directions);
    };
  };
  out.push_back({"bullet", 1, 0, true, true, bullet(10, false)});
  out.push_back({"bullet_dt4", 4, 0, true, false, bullet(10, false)});
  out.push_back({"bullet_200", 1, 0, true, false, bullet(200, false)});
  out.push_back({"bullet_2dir", 1, 0, false, false, bullet(10, true)});
#endif
#ifdef TUMBLE_HAVE_ODE
  const auto ode = [](int iterations) {
    return [=](const tumble::World& start, bool sleeping) {
      return make_ode(start, sleeping, iterations);
    };
  };
  out.push_back({"ode", 1, 0, true, false, ode(20)});
  out.push_back({"ode_dt4", 4, 0, false, false, ode(20)});
  out.push_back({"ode_100", 1, 0, false, false, ode(100)});
#endif
  return out;
}

std::string peer_versions() {
  std::string out;
#ifdef TUMBLE_HAVE_BULLET
  out += bullet_version();
#else
  out += "Bullet was not found";
#endif
#ifdef TUMBLE_HAVE_ODE
  out += "; " + ode_version();
#else
  out += "; ODE was not found";
#endif
  return out;
}

}  // namespace scene_bench
