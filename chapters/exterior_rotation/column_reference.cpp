/// \file
/// \brief Gaps of the falling column to leading order, by GSL.
#include "exterior_rotation/column_reference.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_integration.h>

namespace tumble::chapters {
namespace {

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

double integral(const std::function<double(double)>& integrand, double to) {
  constexpr std::size_t pieces = 1000;
  const Owned<gsl_integration_workspace> room(gsl_integration_workspace_alloc(pieces),
                                              gsl_integration_workspace_free);
  const auto call = [](double t, void* data) {
    return (*static_cast<const std::function<double(double)>*>(data))(t);
  };
  std::function<double(double)> copy = integrand;
  gsl_function function{call, &copy};
  double sum = 0.0;
  double error = 0.0;
  gsl_integration_qag(&function, 0.0, to, 0.0, 1e-11, pieces, GSL_INTEG_GAUSS61, room.get(), &sum,
                      &error);
  return sum;
}

}  // namespace

GapConstants gap_constants(double time, double phi0, int count) {
  const double p = column_frequency(count);
  const double last = column_angle(time, phi0, count);
  struct Now {
    double angle, omega, alpha;
  };
  const auto at = [&](double t) {
    const double angle = column_angle(t, phi0, count);
    return Now{angle, column_rate(t, phi0, count), p * p * std::sin(angle)};
  };
  const auto chord = [&](double t) {
    const Now now = at(t);
    return 0.5 * now.omega * now.omega * std::cos(last - now.angle);
  };
  const auto drift = [&](double t) {
    const Now now = at(t);
    return (time - t) * now.omega * now.alpha * std::cos(last - now.angle);
  };
  const auto turned = [&](double t) {
    const Now now = at(t);
    return (time - t) * now.omega * now.omega * now.omega * std::sin(last - now.angle);
  };
  GapConstants found{.impulse = integral(chord, time), .semi_implicit = integral(drift, time)};
  found.forward_euler = 2.0 * found.semi_implicit + integral(turned, time);
  return found;
}

}  // namespace tumble::chapters
