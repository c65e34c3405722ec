/// \file
/// \brief The program that computes the figures of the chapter on filtering.
#include "driver/driver.hpp"
#include "filtering/experiments.hpp"

/// Computes the chapter's figures; see run_driver() for the options.
/// \param argc  as the system gives it
/// \param argv  as the system gives it
/// \return the exit code
int main(int argc, char** argv) {
  const auto figures = tumble::chapters::filtering_figures();
  return tumble::chapters::run_driver(argc, argv, "reproduce_filtering", figures);
}
