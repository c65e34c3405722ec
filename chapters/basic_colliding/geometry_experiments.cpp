/// \file
/// \brief Experiments on where bodies touch (thesis 3.2).
#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/manifold.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// The cube that stands on the other one.
Box turned_cube(double size, double angle) {
  return make_box(Vec3(0.0, size, 0.0), rotation_from_vector(Vec3(0.0, angle, 0.0)),
                  Vec3::Constant(size));
}

// The contact points of the upper cube on the lower one, in order around their area.
Manifold contact_area(double size, double angle) {
  const Box lower = make_box(Vec3::Zero(), Quat::Identity(), Vec3::Constant(size));
  Manifold manifold;
  // The faces touch exactly; the turned corners are off by rounding, far below the margin.
  const double margin = 1e-9 * size;
  if (!collide(lower, turned_cube(size, angle), margin, kNoAxis, manifold))
    throw std::runtime_error("the cubes do not touch");
  return manifold;
}

// Shoelace formula in the horizontal plane.
double area_of(const Manifold& manifold) {
  double twice = 0.0;
  for (int i = 0; i < manifold.count; ++i) {
    const int j = (i + 1) % manifold.count;
    const Vec3& p = manifold.points[static_cast<std::size_t>(i)].position_w;
    const Vec3& q = manifold.points[static_cast<std::size_t>(j)].position_w;
    twice += p.z() * q.x() - p.x() * q.z();
  }
  return 0.5 * std::abs(twice);
}

// Appends a closed outline; a row without coordinates ends it.
void add_outline(Table& table, double angle_deg, double outline, const std::vector<Vec3>& corners) {
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    const Vec3& corner = corners[i % corners.size()];
    table.add(angle_deg, outline, corner.x(), corner.z());
  }
  table.add(angle_deg, outline, std::nan(""), std::nan(""));
}

// The lower face of the upper cube or the upper face of the lower one, seen from above.
std::vector<Vec3> face_of(const Box& box, bool upper) {
  const int y = upper ? 2 : 0;  // bit 1 of a corner's number says +y
  return {corner_of(box, y), corner_of(box, y + 1), corner_of(box, y + 5), corner_of(box, y + 4)};
}

Table polygons(double size) {
  Table table{"polygons",
              {{"angle_deg", "degrees", "how far the upper cube is turned"},
               {"outline", "-", "0 lower cube, 1 upper cube, 2 contact area"},
               {"x_m", "m", "corner"},
               {"z_m", "m", "corner"}}};
  for (const double angle_deg : {0.0, 15.0, 45.0}) {
    add_outline(table, angle_deg, 0.0, face_of(turned_cube(size, 0.0), false));
    add_outline(table, angle_deg, 1.0, face_of(turned_cube(size, angle_deg * kDegree), false));
    const Manifold manifold = contact_area(size, angle_deg * kDegree);
    std::vector<Vec3> corners;
    for (int i = 0; i < manifold.count; ++i)
      corners.push_back(manifold.points[static_cast<std::size_t>(i)].position_w);
    add_outline(table, angle_deg, 2.0, corners);
  }
  return table;
}

Result measure_box_overlap(const Parameters& settings) {
  const double size = settings.number("size");
  const int steps = settings.count("steps");

  Table table{"",
              {{"angle_deg", "degrees", "how far the upper cube is turned"},
               {"points", "-", "contact points"},
               {"area", "-", "area between the contact points over size²"},
               {"exact", "-", "2/(1 + sin θ + cos θ)"},
               {"error", "-", "their difference"},
               {"accepted", "-", "what widening a face by its slack before clipping may add"}}};
  for (int step = 0; step <= steps; ++step) {
    const double angle_deg = 90.0 * step / steps;
    const Manifold manifold = contact_area(size, angle_deg * kDegree);
    const double area = area_of(manifold) / (size * size);
    const double sum =
        1.0 + elementary::sin(angle_deg * kDegree) + elementary::cos(angle_deg * kDegree);
    const double error = std::abs(area - 2.0 / sum);
    table.add(angle_deg, manifold.count, area, 2.0 / sum, error, 2.0 * tolerance::clip_slack);
  }
  return {{table, polygons(size)}, {}};
}

const Registered box_overlap_figure{
    {.name = "box_overlap",
     .parameters =
         Parameters{}
             .add_number("size", 1.0, 0.001, 1000.0, "m", "edge length of both cubes")
             .add_whole("steps", 90, 6, 900, "angles from 0 to 90 degrees, a multiple of 6"),
     .quick = {"steps=12"},
     .experiment = measure_box_overlap}};

}  // namespace
}  // namespace tumble::chapters
