/// \file
/// \brief The program that computes the figures of the chapter on geometric stability.
#include "driver/driver.hpp"
#include "geometric_stability/experiments.hpp"

/// Computes the chapter's figures; see run_driver() for the options.
/// \param argc  as the system gives it
/// \param argv  as the system gives it
/// \return the exit code
int main(int argc, char** argv) {
  const auto figures = tumble::chapters::geometric_stability_figures();
  return tumble::chapters::run_driver(argc, argv, "reproduce_geometric_stability", figures);
}
