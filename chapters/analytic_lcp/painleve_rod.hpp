/// \file
/// \brief Painlevé's rod: a stick that slides on its lower end (thesis 2.6.3).
#pragma once

#include "tumble/analytic_lcp/velocity_step.hpp"

#include <vector>

namespace tumble::chapters {

// A thin rod of 1 kg and a half length of 1 m. Its lower end is on the ground and slides to the left,
// away from the side to which the rod leans.
struct PainleveRod {
  double angle = 1.0;     // [rad] above the ground, to the right
  double friction = 0.0;  // [-] Coulomb's coefficient, at least 0
  double spin = 0.0;      // [rad/s] angular velocity
};

// [1/kg] The acceleration of the lower end away from the ground per force N there, while friction mu N
// pushes it to the right: p = (1 + 3 cos² - 3 mu sin cos) / m. Below 0 a harder push moves the end down.
double push_response(const PainleveRod& rod);

// [m/s²] The same without a force there: b = l omega² sin - g.
double free_acceleration(const PainleveRod& rod);

// [N] All forces that obey N >= 0, p N + b >= 0 and N (p N + b) = 0, ascending.
std::vector<double> possible_forces(const PainleveRod& rod);

// The friction beyond which there may be none or two: (4 + tan²) / (3 tan), where p = 0.
double critical_friction(double angle);

// A world at the start of a step.
struct Instant {
  World world;
  ContactList contacts;
  std::vector<MovingBody> bodies;
  std::vector<Acceleration> free;  // gravity
};

// Loads the bodies and gravity of a world with contacts.
void add_gravity(Instant& instant);

// The ground and the rod, 0.01 mm thick, whose end slides with 1 m/s to the left.
Instant rod_on_end(const PainleveRod& rod);

// The state of the lower end after a time step.
struct RodStep {
  bool solved = false;
  double normal_impulse = 0.0;    // [N s] away from the ground
  double friction_impulse = 0.0;  // [N s] to the right
  double slip = 0.0;              // [m/s] to the right, after the step
  double lift = 0.0;              // [m/s] away from the ground, after the step
  double spin = 0.0;              // [rad/s] after the step
};

// A step of Stewart and Trinkle with a pyramid of 4 or 8 directions.
RodStep step_rod(const PainleveRod& rod, double step, int directions);

}  // namespace tumble::chapters
