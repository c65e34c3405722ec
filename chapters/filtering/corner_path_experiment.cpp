/// \file
/// \brief The path of one corner of a cube that chatters, as computed and as shown by five filters.
#include "tumble/filtering/filters.hpp"
#include "tumble/pictures/world_picture.hpp"

#include "driver/experiment.hpp"
#include "filtering/shown_clump.hpp"

#include <Eigen/Eigenvalues>

namespace tumble::chapters {
namespace {

constexpr std::array<const char*, 5> kFilters = {"box:5", "box:15", "envelope:10mm,1deg",
                                                 "soft_envelope:10mm,1deg", "one_euro"};
constexpr std::array<const char*, 6> kColumns = {"computed", "box5", "box15",
                                                 "envelope", "soft", "one_euro"};

// The cube that chatters most: where filters differ most. An amplitude is a mean over half seconds.
std::size_t chosen_cube(const ChatteringClump& clump) {
  const std::vector<Shake> shakes = clump.shakes(clump.run.frames);
  const auto less = [](const Shake& a, const Shake& b) { return a.amplitude < b.amplitude; };
  const auto most = std::max_element(shakes.begin(), shakes.end(), less);
  return clump.bodies[static_cast<std::size_t>(most - shakes.begin())];
}

// The corner that comes around most, by its number.
std::size_t chosen_corner(const std::vector<Corners>& path) {
  std::size_t chosen = 0;
  double widest = 0.0;
  for (std::size_t c = 0; c < 8; ++c) {
    Vec3 low = path[0][c];
    Vec3 high = low;
    for (const Corners& corners : path) {
      low = low.cwiseMin(corners[c]);
      high = high.cwiseMax(corners[c]);
    }
    const double width = (high - low).norm();
    if (width > widest) chosen = c;
    widest = std::max(widest, width);
  }
  return chosen;
}

// The plane of a path: through its middle, along the two axes in which it spreads most.
struct Plane {
  Vec3 middle_w;
  Vec3 along_w, across_w;

  Plane(const std::vector<Corners>& path, std::size_t corner) : middle_w(Vec3::Zero()) {
    for (const Corners& corners : path) middle_w += corners[corner];
    middle_w /= static_cast<double>(path.size());
    Mat3 spread = Mat3::Zero();
    for (const Corners& corners : path) {
      const Vec3 d = corners[corner] - middle_w;
      spread += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);  // by ascending eigenvalues
    along_w = with_sign(axes.eigenvectors().col(2));
    across_w = with_sign(axes.eigenvectors().col(1));
  }

  // [mm] in the plane
  [[nodiscard]] Vec2 operator()(const Vec3& point_w) const {
    const Vec3 d = 1e3 * (point_w - middle_w);
    return {along_w.dot(d), across_w.dot(d)};
  }

 private:
  // An axis has no sign of its own: its largest component is above 0.
  static Vec3 with_sign(const Vec3& axis) {
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    return axis[largest] < 0.0 ? Vec3(-axis) : axis;
  }
};

std::string picture_of(const SettledRun& run, std::size_t chosen) {
  std::vector<PictureBox> boxes = picture_boxes(run.world);
  std::size_t drawn = 0;
  for (std::size_t k = 0; k < run.world.bodies().size(); ++k) {
    if (run.world.bodies()[k].shape != Shape::box) continue;
    boxes[drawn++].colour = k == chosen ? 0xd55e00 : 0xc9c9c4;
  }
  // From the side on which the cube is, so that it is seen.
  Vec3 outward_w = run.world.states()[chosen].position_w;
  outward_w.y() = 0.0;
  const Vec3 direction_w = outward_w.normalized() + Vec3(0.0, 0.5, 0.0);
  return to_gnuplot(draw_boxes(boxes, camera_for(boxes, direction_w, 600.0, 300.0, true)));
}

Result draw_corner_path(const Parameters& settings) {
  const ChatteringClump clump = chattering_clump(settings, settings.count("seed"));
  const SettledRun& run = clump.run;
  const std::size_t cube = chosen_cube(clump);

  std::vector<std::vector<Corners>> paths = {clump.path(run.frames, cube)};
  for (const char* text : kFilters)
    paths.push_back(clump.path(filtered(run.frames, *filter_of(text)), cube));
  const std::size_t corner = chosen_corner(paths[0]);
  const Plane plane(paths[0], corner);

  Table table{"", {{"time_s", "s", "since the first frame that counts"}}};
  for (const std::string column : kColumns)
    for (const std::string axis : {"_along_mm", "_across_mm"})
      table.columns.push_back({column + axis, "mm", "place in the plane of the path"});
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (std::size_t f = 0; f < paths[0].size(); ++f) {
    std::vector<double> places;
    for (const std::vector<Corners>& path : paths) {
      const Vec2 place = plane(path[f][corner]);
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
      places.insert(places.end(), {place.x(), place.y()});
    }
    table.add(static_cast<double>(f) * kStep, places);
  }
  const Vec2 first = plane(paths[3][0][corner]);
  const Table frame{"frame",
                    {{"left_mm", "mm", "of all paths"},
                     {"right_mm", "mm", "of all paths"},
                     {"bottom_mm", "mm", "of all paths"},
                     {"top_mm", "mm", "of all paths"},
                     {"circle_along_mm", "mm", "where the envelope shows the corner at first"},
                     {"circle_across_mm", "mm", "where the envelope shows the corner at first"},
                     {"radius_mm", "mm", "of the envelope"}},
                    {{low.x(), high.x(), low.y(), high.y(), first.x(), first.y(), 10.0}}};

  const Shake shake = shake_of(paths[0], run.world.gravity_w.norm());
  const Pops hard = pops(paths[3], paths[0], 0.01);
  const Pops gentle = pops(paths[4], paths[0], 0.01);
  return {{table, frame},
          {{"amplitude of the cube", "mm", 1e3 * shake.amplitude},
           {"squirm of the cube, computed", "mm/s", 1e3 * shake.squirm},
           {"squirm of the cube, box filter over 15 frames", "mm/s", 1e3 * squirm(paths[2], kStep)},
           {"pops of the cube, envelope", "-", hard.count},
           {"pops of the cube, soft envelope", "-", gentle.count},
           {"largest pop of the cube, envelope", "mm", 1e3 * hard.largest}},
          {{"clump", picture_of(run, cube)}}};
}

const Registered corner_path_figure{
    {.name = "corner_path",
     .parameters =
         Parameters{}
             .add_whole("per_edge", 5, 2, 8, "cubes along each edge of the grid at the start")
             .add_whole("seed", 1, 1, 1000, "of their orientations")
             .add_number("settling", 10.0, 0.5, 60.0, "s", "before cubes should rest")
             .add_number("watched", 2.0, 0.5, 60.0, "s", "of the path"),
     .quick = {"per_edge=4", "settling=6", "watched=1"},
     .experiment = draw_corner_path}};

}  // namespace

}  // namespace tumble::chapters
