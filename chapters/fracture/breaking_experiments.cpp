/// \file
/// \brief The load and the drop at which a plank breaks, of tetrahedra and of glued boxes (thesis 2.4.1).
#include "tumble/analytic_lcp/time_stepping.hpp"
#include "tumble/fracture/breaking_row.hpp"

#include "driver/experiment.hpp"
#include "fracture/fracture_scenes.hpp"

namespace tumble::chapters {
namespace {

constexpr double kLoadGrows = 1.01;  // of the load, from one step to the next
constexpr double kMostLoad = 200.0;  // times the beam's
constexpr double kSmallStrain =
    1e-6;  // [-] about that of the static solution, where Green's strain is linear
constexpr double kSolved = 1e-8;      // [-] residual of the static solution
constexpr double kTouching = 1e-6;    // [m] gap before a drop, so that gravity adds no speed
constexpr double kSpeedFound = 1.02;  // [-] between two speeds, of which one breaks
constexpr double kWatched = 0.02;     // [s] after the drop: a few swings of the plank

// Three-point bending: σ = M c / I with M = F L / 4.
double beam_load(double strength) {
  return 2.0 * strength * kPlank.z() * kPlank.y() * kPlank.y() / (3.0 * kPlank.x());
}

// Displacements of a mesh at rest under its loads, by conjugate gradients scaled with the masses.
std::vector<Vec3> bent(const ElasticMesh& mesh) {
  const std::size_t n = mesh.nodes.size();
  std::vector<Vec3> q(n, Vec3::Zero()), residual(n), way(n), pull(n);
  const auto held = [&](std::size_t i, const Vec3& a) -> Vec3 {
    return a.cwiseProduct(mesh.nodes[i].moves);
  };
  double size = 0.0, start = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = held(i, mesh.nodes[i].load_w);
    way[i] = residual[i] / mesh.nodes[i].mass;
    size += residual[i].dot(way[i]);
  }
  start = size;
  for (std::size_t k = 0; k < 20 * n && size > kSolved * kSolved * start; ++k) {
    linear_forces(mesh, way, pull);
    double along = 0.0;
    for (std::size_t i = 0; i < n; ++i) along -= way[i].dot(held(i, pull[i]));
    const double length = size / along;
    double next = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      q[i] += length * way[i];
      residual[i] += length * held(i, pull[i]);
      next += residual[i].squaredNorm() / mesh.nodes[i].mass;
    }
    for (std::size_t i = 0; i < n; ++i)
      way[i] = residual[i] / mesh.nodes[i].mass + (next / size) * way[i];
    size = next;
  }
  if (size > kSolved * kSolved * start)
    throw std::runtime_error("the plank under its load was not solved");
  return q;
}

struct Break {
  double load = 0.0;       // over the beam's
  double place = 0.0;      // from the middle, over the length
  double toughness = 0.0;  // [N] the largest eigenvalue there, the paper's measure
};

// The load at which a plank of tetrahedra on two supports is pulled apart first.
Break elements_break(int cells) {
  const ElasticMaterial material = soft_material();
  ElasticMesh mesh = elastic_box(kPlank, {20 * cells, cells, 2 * cells}, material);
  const Vec3 half = 0.5 * kPlank;
  const double near = 0.1 * half.y() / cells;
  std::vector<std::size_t> loaded;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    ElasticNode& node = mesh.nodes[n];
    if (std::abs(node.rest.x()) < near && node.rest.y() > half.y() - near) loaded.push_back(n);
    if (node.rest.y() > near - half.y() || std::abs(node.rest.x()) < half.x() - near) continue;
    node.moves.y() = 0.0;
    if (node.rest.x() < 0.0) node.moves.x() = 0.0;
    if (std::abs(node.rest.z()) < near) node.moves.z() = 0.0;
  }
  for (const std::size_t n : loaded)
    mesh.nodes[n].load_w.y() = -beam_load(material.strength) / static_cast<double>(loaded.size());
  const std::vector<Vec3> q = bent(mesh);
  const double scale =
      kSmallStrain * kPlank.x() / largest_of(q, [](const Vec3& one) { return one.norm(); });
  for (std::size_t n = 0; n < q.size(); ++n)
    mesh.nodes[n].position_w = mesh.nodes[n].rest + scale * q[n];
  Break found;
  double stress = 0.0;
  TensileStresses stresses(mesh);
  for (std::size_t n = 0; n < q.size(); ++n) {
    const NodeSeparation here = separation_at(stresses, static_cast<int>(n));
    if (here.stress() <= stress) continue;
    stress = here.stress();
    found = {scale * material.strength / stress, std::abs(mesh.nodes[n].rest.x()) / kPlank.x(),
             here.force / scale};
  }
  return found;
}

RowOptions glued_plank(RowRule rule) {
  return RowOptions{.size = kPlank,
                    .density = soft_material().density,
                    .strength = soft_material().strength,
                    .rule = rule};
}

// The same for a row of glued boxes on two narrow supports, at 60 steps a second.
Break row_breaks(RowRule rule) {
  World world;
  world.gravity_w.setZero();
  const BodyProperties support = fixed_box_properties(Vec3(0.002, 0.1, 0.2));
  for (const double x : {-0.5, 0.5}) world.add(support, Vec3(x * kPlank.x(), 0.05, 0.0));
  BreakingRow row(world, glued_plank(rule), Vec3(0.0, 0.1 + 0.5 * kPlank.y(), 0.0));
  TimeStepping technique;
  const double beam = beam_load(soft_material().strength);
  for (double load = 0.5 * beam; load < kMostLoad * beam; load *= kLoadGrows) {
    row.push(world, Vec3(0.0, -load * kStep, 0.0), 0.5);
    if (finished(row.step(world, technique, kStep)).events == 0) continue;
    const double along = static_cast<double>(row.pieces()[0].count) / 40.0;
    return {load / beam, std::abs(along - 0.5), 0.0};
  }
  throw std::runtime_error("the row did not break");
}

// Whether a drop across the bar breaks it.
bool elements_drop(double speed, int cells, FractureWork& work) {
  Fracture plank = falling_plank(soft_material(), speed, {20 * cells, cells, 2 * cells}, kTouching);
  const int parts = 20;
  for (int k = 0; k < parts; ++k) {
    finished(plank.step(kWatched / parts));
    work = plank.work();
    if (plank.work().cracks.cracks > 0) return true;
  }
  return false;
}

// The bar, and the plank as a row of glued boxes that has come down to it.
BreakingRow falling_row(World& world, double speed) {
  add_bar(world);
  return BreakingRow(world, glued_plank(RowRule::stress),
                     Vec3(0.0, kBar.y() + kTouching + 0.5 * kPlank.y(), 0.0),
                     Vec3(0.0, -speed, 0.0));
}

bool row_drop(double speed, double dt) {
  World world;
  BreakingRow row = falling_row(world, speed);
  TimeStepping technique;
  for (double time = 0.0; time < 0.1; time += dt)
    if (finished(row.step(world, technique, dt)).events > 0) return true;
  return false;
}

// The lowest speed that breaks.
double breaking_speed(const std::function<bool(double)>& breaks) {
  double holds = 1e-3, broken = 1e-3;
  while (!breaks(broken)) {
    holds = broken;
    broken *= 2.0;
    if (broken > 1e3) throw std::runtime_error("no speed breaks the plank");
  }
  while (broken > kSpeedFound * holds) {
    const double speed = std::sqrt(holds * broken);
    (breaks(speed) ? broken : holds) = speed;
  }
  return broken;
}

// A second of a plank that breaks in two: elements evaluated over joints solved.
double work_ratio(int cells, double speed) {
  Fracture plank = falling_plank(soft_material(), speed, {20 * cells, cells, 2 * cells});
  finished(plank.step(kWatched));
  World world;
  BreakingRow row = falling_row(world, speed);
  TimeStepping technique;
  for (int k = 0; k < 12; ++k) finished(row.step(world, technique, kStep));
  const double elements = static_cast<double>(plank.work().evaluations) / kWatched;
  return elements / (static_cast<double>(row.joints_solved()) / (12.0 * kStep));
}

Result measure_breaking(const Parameters& settings) {
  const int most = settings.count("cells"), drop = settings.count("drop");
  Table loads{"",
              {{"cells", "-", "through the thickness of the plank"},
               {"load", "-", "that breaks it, over that of the beam"},
               {"place", "-", "where, from the middle over the length"},
               {"toughness_N", "N", "the largest eigenvalue there under the beam's load"}}};
  Result result;
  std::vector<Break> elements;
  for (int cells = 1; cells <= most; ++cells) {
    elements.push_back(elements_break(cells));
    const Break& found = elements.back();
    loads.add(cells, found.load, found.place, found.toughness);
  }
  const Break stress = row_breaks(RowRule::stress), force = row_breaks(RowRule::force);
  Table speeds{"speeds",
               {{"steps_per_second", "1/s", "of the glued boxes"},
                {"row_m_s", "m/s", "drop that breaks them"},
                {"elements_m_s", "m/s", "drop that cracks the elements, at any step"}}};
  FractureWork work;
  const double cracking =
      breaking_speed([&](double speed) { return elements_drop(speed, drop, work); });
  std::vector<double> row;
  for (const int rate : {60, 120, 240, 480, 960}) {
    row.push_back(breaking_speed([&](double speed) { return row_drop(speed, 1.0 / rate); }));
    speeds.add(rate, row.back(), cracking);
  }
  result.tables = {loads, speeds};
  const std::string finest = "load that breaks elements, ";
  for (const int cells : {1, 2, most})
    result.add(finest + std::to_string(cells) + " through the thickness, over the beam's", "-",
               elements[idx(cells) - 1].load);
  result.add("place where the finest break, from the middle over the length", "-",
             elements.back().place);
  result.add("largest eigenvalue under the same load, cells half as large", "-",
             elements[1].toughness / elements[0].toughness);
  result.add("load that breaks glued boxes by their stress, over the beam's", "-", stress.load);
  result.add("load that breaks glued boxes by their force, over the beam's", "-", force.load);
  result.add("place where glued boxes break by their stress, from the middle over the length", "-",
             stress.place);
  result.add("place where glued boxes break by their force, from the middle over the length", "-",
             force.place);
  result.add("speed of the drop that cracks elements", "m/s", cracking);
  result.add("speed of the drop that breaks glued boxes at 60 steps a second", "m/s", row[0]);
  result.add("the same at 960 over that at 60", "-", row.back() / row.front());
  result.add("elements evaluated in a second over joints solved", "-", work_ratio(drop, 2.0));
  return result;
}

const Registered breaking_figure{
    {.name = "fracture_breaking",
     .parameters = {whole("cells", 4, 2, 8, "most through the thickness under the load"),
                    whole("drop", 2, 1, 4, "through the thickness in the drop")},
     .quick = {"cells=2", "drop=1"},
     .experiment = measure_breaking}};

}  // namespace
}  // namespace tumble::chapters
