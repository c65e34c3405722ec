/// \file
/// \brief The program that computes the figures of the chapter on exterior rotation.
#include "driver/driver.hpp"
#include "exterior_rotation/experiments.hpp"

/// Computes the chapter's figures; see run_driver() for the options.
/// \param argc  as the system gives it
/// \param argv  as the system gives it
/// \return the exit code
int main(int argc, char** argv) {
  const auto figures = tumble::chapters::exterior_rotation_figures();
  return tumble::chapters::run_driver(argc, argv, "reproduce_exterior_rotation", figures);
}
