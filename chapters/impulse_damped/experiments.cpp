/// \file
/// \brief The figures of the chapter on impulses and damped integration, in the order of its page.
#include "impulse_damped/experiments.hpp"

#include "impulse_damped/damping_experiments.hpp"
#include "impulse_damped/errata_collide_experiments.hpp"
#include "impulse_damped/errata_damping_experiments.hpp"
#include "impulse_damped/friction_experiments.hpp"
#include "impulse_damped/impulse_figures.hpp"
#include "impulse_damped/rest_experiments.hpp"
#include "impulse_damped/scene_experiments.hpp"

namespace tumble::chapters {

std::vector<Figure> impulse_damped_figures() {
  std::vector<Figure> list;
  add_scene_figures(list);
  add_friction_figures(list);
  add_impulse_figures(list);
  add_damping_figures(list);
  add_rest_figures(list);
  list.push_back(contact_errata_figure());
  add_damping_errata_figures(list);
  return list;
}

}  // namespace tumble::chapters
