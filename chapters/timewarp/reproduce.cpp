/// \file
/// \brief The program that computes the figures of the chapter on timewarp.
#include "driver/driver.hpp"
#include "timewarp/experiments.hpp"

/// Computes the chapter's figures; see run_driver() for the options.
/// \param argc  as the system gives it
/// \param argv  as the system gives it
/// \return the exit code
int main(int argc, char** argv) {
  const auto figures = tumble::chapters::timewarp_figures();
  return tumble::chapters::run_driver(argc, argv, "reproduce_timewarp", figures);
}
