/// \file
/// \brief Forces in the joints of the falling column.
#include "driver/quick.hpp"
#include "exterior_rotation/column_runs.hpp"
#include "support/catch.hpp"

using namespace tumble;
using namespace tumble::chapters;

TEST_CASE("Glue forces at release are those of the closed form, centre of pressure included",
          "[reference][exterior_rotation]") {
  World world = column_world(0.3);
  Glued glued;
  glued.step(world, 1e-9);  // nothing has moved by more than rounding
  struct Row {
    double shear, normal, from_edge;
  };
  constexpr std::array<Row, 3> rows{{{7.346365955, 26.74874999, 0.1866083421},
                                     {3.842891773, 17.8325, 0.3337873452},
                                     {1.394103122, 8.91625, 0.4415370095}}};
  REQUIRE(glued.contacts().size() == 4);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ContactRecord& contact = glued.contacts()[k + 1];
    const auto lower = static_cast<std::size_t>(world.index_of(contact.first));
    const BodyState& state = world.states()[lower];
    const Vec3 across_w = state.orientation_wb * Vec3::UnitX();
    const Vec3 along_w = state.orientation_wb * Vec3::UnitY();
    CHECK(-contact.push_w.dot(across_w) == near(rows[k].shear).margin(1e-8));
    CHECK(contact.push_w.dot(along_w) == near(rows[k].normal).margin(1e-8));
    CHECK(0.5 - (contact.point_w - state.position_w).dot(across_w) ==
          near(rows[k].from_edge).margin(1e-9));
  }
}
