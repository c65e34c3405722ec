/// \file
/// \brief Independent judges of the falling column, by GSL.
#include "exterior_rotation/column_reference.hpp"

#include "driver/experiment.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_odeiv2.h>

namespace tumble::chapters {
namespace {

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

void integrate(gsl_odeiv2_system system, double time, double* y) {
  constexpr double accuracy = 1e-14;  // between this and rounding there is nothing left to gain
  const Owned<gsl_odeiv2_driver> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, accuracy, accuracy),
      gsl_odeiv2_driver_free);
  double now = 0.0;
  if (gsl_odeiv2_driver_apply(driver.get(), &now, time, y) != GSL_SUCCESS)
    throw std::runtime_error("the reference integrator gave up");
}

int pendulum_rate(double, const double y[], double rate[], void* squared) {
  rate[0] = y[1];
  rate[1] = *static_cast<const double*>(squared) * std::sin(y[0]);
  return GSL_SUCCESS;
}

// A point of a cube, and what of its acceleration is not linear in that of the cube.
struct Point {
  double x, y;  // from the cube's centre
  double square_x, square_y;
};

Point point_of(const double* cube, double across, double along) {
  const double s = std::sin(cube[2]);
  const double c = std::cos(cube[2]);
  Point p{c * across - s * along, s * across + c * along, 0.0, 0.0};
  p.square_x = -cube[5] * cube[5] * p.x;
  p.square_y = -cube[5] * cube[5] * p.y;
  return p;
}

// Unknowns of a cube: x, y, angle (anticlockwise), and their rates. The accelerations a and the joints'
// forces f solve  M a - Jᵀ f = M g,  J a = -(squares).
int column_rate_of_all(double, const double y[], double rate[], void* count_data) {
  const int count = *static_cast<const int*>(count_data);
  const int rows = 2 + 3 * (count - 1);
  const auto size = static_cast<std::size_t>(3 * count + rows);
  std::vector<double> matrix(size * size, 0.0);
  std::vector<double> right(size, 0.0);
  const auto at = [&](int row, int column) -> double& {
    return matrix[static_cast<std::size_t>(row) * size + static_cast<std::size_t>(column)];
  };
  for (int k = 0; k < count; ++k) {
    at(3 * k, 3 * k) = 1.0;
    at(3 * k + 1, 3 * k + 1) = 1.0;
    at(3 * k + 2, 3 * k + 2) = 1.0 / 6;
    right[static_cast<std::size_t>(3 * k + 1)] = -kGravity;
  }
  int row = 3 * count;
  const auto put = [&](int equation, int unknown, double value) {
    at(equation, unknown) += value;
    at(unknown, equation) -= value;
  };
  const auto hold = [&](int cube, double along, double sign) {
    const Point p = point_of(y + 6 * cube, 0.5, along);
    put(row, 3 * cube, sign);
    put(row, 3 * cube + 2, -sign * p.y);
    put(row + 1, 3 * cube + 1, sign);
    put(row + 1, 3 * cube + 2, sign * p.x);
    right[static_cast<std::size_t>(row)] -= sign * p.square_x;
    right[static_cast<std::size_t>(row + 1)] -= sign * p.square_y;
  };
  hold(0, -0.5, 1.0);
  row += 2;
  for (int k = 0; k + 1 < count; ++k) {
    hold(k, 0.5, -1.0);
    hold(k + 1, -0.5, 1.0);
    put(row + 2, 3 * k + 2, -1.0);
    put(row + 2, 3 * (k + 1) + 2, 1.0);
    row += 3;
  }
  gsl_matrix_view a = gsl_matrix_view_array(matrix.data(), size, size);
  gsl_vector_view b = gsl_vector_view_array(right.data(), size);
  const Owned<gsl_permutation> order(gsl_permutation_alloc(size), gsl_permutation_free);
  int sign = 0;
  gsl_linalg_LU_decomp(&a.matrix, order.get(), &sign);
  gsl_linalg_LU_svx(&a.matrix, order.get(), &b.vector);
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < 3; ++i) {
      rate[6 * k + i] = y[6 * k + 3 + i];
      rate[6 * k + 3 + i] = right[static_cast<std::size_t>(3 * k + i)];
    }
  }
  return GSL_SUCCESS;
}

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

ReferenceFall integrated_pendulum(double time, double phi0, int count) {
  const double p = column_frequency(count);
  double squared = p * p;
  std::array<double, 2> y{phi0, 0.0};
  integrate({pendulum_rate, nullptr, 2, &squared}, time, y.data());
  return {y[0], y[1], 0.0};
}

ReferenceFall integrated_column(double time, double phi0, int count) {
  // The pivot is at (0, 0), where the lowest cube has its lower right corner.
  const double angle = -(phi0 + column_tilt(count));
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  std::vector<double> y(static_cast<std::size_t>(6 * count), 0.0);
  for (int k = 0; k < count; ++k) {
    double* cube = y.data() + 6 * k;
    const double along = k + 0.5;
    cube[0] = -0.5 * c - along * s;
    cube[1] = -0.5 * s + along * c;
    cube[2] = angle;
  }
  integrate({column_rate_of_all, nullptr, y.size(), &count}, time, y.data());
  ReferenceFall found;
  double sum_x = 0.0;
  double sum_y = 0.0;
  for (int k = 0; k < count; ++k) {
    const double* cube = y.data() + 6 * k;
    sum_x += cube[0];
    sum_y += cube[1];
    const Point foot = point_of(cube, 0.5, -0.5);
    double apart_x = cube[0] + foot.x;
    double apart_y = cube[1] + foot.y;
    if (k > 0) {
      const Point head = point_of(cube - 6, 0.5, 0.5);
      apart_x -= cube[-6] + head.x;
      apart_y -= cube[-5] + head.y;
    }
    found.gap = std::max(found.gap, std::hypot(apart_x, apart_y));
  }
  found.angle = std::atan2(sum_x, sum_y);
  found.rate = -y[5];
  return found;
}

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
  GapConstants found;
  found.impulse = integral(chord, time);
  found.semi_implicit = integral(drift, time);
  found.forward_euler = 2.0 * found.semi_implicit + integral(turned, time);
  return found;
}

}  // namespace tumble::chapters
