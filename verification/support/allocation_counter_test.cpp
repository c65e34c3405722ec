/// \file
/// \brief The counter of requests for memory counts.
#include "support/allocation_counter.hpp"

#include "support/test.hpp"

#include <Eigen/Core>

namespace tumble {
namespace {

// Taken through a volatile pointer, so that no compiler may leave a request out.
template <class Make>
std::int64_t requests_of(Make make) {
  const AllocationCount count;
  const auto made = make();
  const void* volatile kept = &made;
  (void)kept;
  return count.value();
}

struct alignas(64) Aligned {
  double values[8] = {};
};

}  // namespace

TEST_CASE("Every way to ask for memory is counted", "[unit][allocation]") {
  CHECK(requests_of([] { return std::make_unique<int>(1); }) == 1);
  CHECK(requests_of([] { return std::make_unique<Aligned>(); }) == 1);
  CHECK(requests_of([] { return std::vector<double>(100); }) == 1);
  CHECK(requests_of([] { return std::string(100, 'x'); }) == 1);
#ifdef TUMBLE_WRAP_MALLOC
  CHECK(requests_of([] { return Eigen::VectorXd(Eigen::VectorXd::Zero(100)); }) == 1);
#endif
}

TEST_CASE("What asks for no memory counts as none", "[unit][allocation]") {
  std::vector<double> warm(100);
  CHECK(requests_of([] { return Eigen::Matrix3d(Eigen::Matrix3d::Identity()); }) == 0);
  CHECK(requests_of([&] {
          warm.clear();
          warm.resize(100);
          return warm.data();
        }) == 0);
}

}  // namespace tumble
