/// \file
/// \brief The claims of 5.3 on friction: the faster body, chains of bodies, what a viewer sees.
#include "driver/quick.hpp"
#include "support/test.hpp"

using namespace tumble;
using namespace tumble::chapters;
