/// \file
/// \brief The program that computes the figures of the page on choosing a technique.
#include "choosing/experiments.hpp"
#include "driver/driver.hpp"

/// Computes the page's figures; see run_driver() for the options.
/// \param argc  as the system gives it
/// \param argv  as the system gives it
/// \return the exit code
int main(int argc, char** argv) {
  const auto figures = tumble::chapters::choosing_figures();
  return tumble::chapters::run_driver(argc, argv, "reproduce_choosing", figures);
}
