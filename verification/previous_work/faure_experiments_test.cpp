/// \file
/// \brief The experiment about Faure's iteration, small.
#include "driver/quick.hpp"
#include "support/catch.hpp"

using namespace tumble::chapters;

TEST_CASE("One per cent of error takes Faure's iteration a fifth of the work of a direct solver",
          "[claims][faure]") {
  const FigureUnderTest figure("claim_2_6_4a_faure");
  const std::string work =
      "multiplications of Faure's iteration to an error of one per cent over those of the direct "
      "solver, geometric mean over pyramids";
  CHECK(figure.number(work) < 0.4);  // measured: 0.24 up to 64 contacts, 0.19 up to 144
  CHECK(figure.number("the same at rest") < 0.2);
}
