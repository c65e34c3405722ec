/// \file
/// \brief Steps that fracture needs to stay stable (thesis 2.4.1).
#include "driver/experiment.hpp"
#include "fracture/fracture_scenes.hpp"

#include <Eigen/Eigenvalues>

namespace tumble::chapters {
namespace {

constexpr double kMillion = 1e6;     // steps per second
constexpr double kDropSpeed = 4.0;   // [m/s] of the plank
constexpr double kShotSpeed = 20.0;  // [m/s] of the cube
constexpr double kDamped = 3.2e-3;   // [m] way of the wave in the time of the damping
constexpr int kIterations = 60;      // of Lanczos: four right digits
constexpr double kWithin = 0.002;    // [-] how closely the longest step is found
constexpr int kStableSteps = 1000;   // after which a swing that grows is seen
constexpr double kGrown = 100.0;     // times the energy of the start

// The highest angular frequency of a mesh at rest, by Lanczos' iteration, with masses as weights.
double highest_frequency(const ElasticMesh& mesh) {
  const std::size_t n = mesh.nodes.size();
  std::vector<Vec3> before(n, Vec3::Zero()), now(n), next(n);
  const auto dot = [&](const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += mesh.nodes[i].mass * a[i].dot(b[i]);
    return sum;
  };
  Random chance(1);
  for (Vec3& one : now) one = chance.in_cube(1.0);
  double length = std::sqrt(dot(now, now));
  for (Vec3& one : now) one /= length;
  Eigen::VectorXd diagonal(kIterations), beside(kIterations - 1);
  length = 0.0;
  for (int k = 0; k < kIterations; ++k) {
    linear_forces(mesh, now, next);
    for (std::size_t i = 0; i < n; ++i) next[i] /= -mesh.nodes[i].mass;
    diagonal[k] = dot(now, next);
    for (std::size_t i = 0; i < n; ++i) next[i] -= diagonal[k] * now[i] + length * before[i];
    if (k + 1 == kIterations) break;
    beside[k] = length = std::sqrt(dot(next, next));
    for (std::size_t i = 0; i < n; ++i) next[i] /= length;
    std::swap(before, now);
    std::swap(now, next);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes;
  modes.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return std::sqrt(modes.eigenvalues()[kIterations - 1]);
}

// Whether a mesh that is shaken swings on and on at a step, or explodes.
bool stays(const ElasticMesh& mesh, double h) {
  ElasticMesh shaken = mesh;
  Random chance(1);
  for (ElasticNode& node : shaken.nodes) node.velocity_w = chance.in_cube(1e-3);
  std::vector<Vec3> forces(shaken.nodes.size());
  std::vector<double> tension(shaken.elements.size());
  const double start = shaken.kinetic_energy();
  for (int k = 0; k < kStableSteps; ++k) {
    std::ranges::fill(forces, Vec3::Zero());
    add_forces(shaken, forces, tension);
    for (std::size_t i = 0; i < forces.size(); ++i) {
      shaken.nodes[i].velocity_w += h / shaken.nodes[i].mass * forces[i];
      shaken.nodes[i].position_w += h * shaken.nodes[i].velocity_w;
    }
    if (!(shaken.kinetic_energy() < kGrown * start)) return false;
  }
  return true;
}

// The longest step, to a few thousandths, looked for from where theory has it.
double longest_step(const ElasticMesh& mesh, double theory) {
  double stable = (1.0 - kWithin) * theory, not_stable = (1.0 + kWithin) * theory;
  for (; !stays(mesh, stable); stable *= 1.0 - 2.0 * kWithin) not_stable = stable;
  for (; stays(mesh, not_stable); not_stable *= 1.0 + 2.0 * kWithin) stable = not_stable;
  return stable;
}

struct NamedMaterial {
  const char* name;
  ElasticMaterial material;
};

// Glass and concrete as strong as they are in an impact, and viscosity that lets waves of a few cells live on.
std::array<NamedMaterial, 3> materials() {
  std::array<NamedMaterial, 3> all{{{"glass", elastic_material(70e9, 0.22, 2500.0, 60e6)},
                                    {"concrete", elastic_material(30e9, 0.2, 2400.0, 30e6)},
                                    {"soft", elastic_material(0.26e9, 0.25, 2600.0, 3e6)}}};
  for (auto& [name, material] : all) {
    material.phi = kDamped / material.wave_speed() * material.lambda;
    material.psi = kDamped / material.wave_speed() * material.mu;
  }
  return all;
}

// A run of a scene: steps per second that stability needs at the start, and at the worst mesh.
struct Needed {
  double start = 0.0;
  double worst = 0.0;
  double taken = 0.0;  // by the code, at the shortest
  int pieces = 0;
};

Needed needed_by(Fracture scene, double transits, double longest) {
  Needed needed{.start = 0.5 * highest_frequency(scene.mesh())};
  needed.worst = needed.start;
  const double time = transits * longest / scene.mesh().material.wave_speed();
  std::size_t elements = 0;
  for (int k = 0; k < 10; ++k) {
    finished(scene.step(time / 10.0));
    if (scene.mesh().elements.size() == elements) continue;  // it has not cracked any further
    elements = scene.mesh().elements.size();
    needed.worst = std::max(needed.worst, 0.5 * highest_frequency(scene.mesh()));
  }
  needed.taken = 1.0 / scene.work().shortest;
  std::vector<int> piece;
  needed.pieces = pieces_of(scene.mesh(), piece);
  return needed;
}

void add_stable_steps(int most, Result& result) {
  Table table{"steps",
              {{"young_Pa", "Pa", "Young's modulus"},
               {"cell_m", "m", "edge of a cell"},
               {"courant_s", "s", "smallest height of an element over the speed of the wave"},
               {"bound_s", "s", "stable step of the fastest element"},
               {"exact_s", "s", "two over the highest frequency of the mesh"},
               {"found_s", "s", "longest step at which a shaken cube does not explode"}}};
  double least = 2.0, largest = 0.0, worst = 0.0;
  for (const NamedMaterial& named : materials()) {
    for (int cells = 2; cells <= most; cells *= 2) {
      const double edge = 0.1;  // [m] of the cube
      ElasticMesh cube = elastic_box(Vec3::Constant(edge), {cells, cells, cells}, named.material);
      cube.material.phi = cube.material.psi = 0.0;
      const double courant = courant_step(cube);
      const double exact = 2.0 / highest_frequency(cube), found = longest_step(cube, exact);
      const ElasticMaterial& m = named.material;
      const double young = m.mu * (3.0 * m.lambda + 2.0 * m.mu) / (m.lambda + m.mu);
      table.add(young, edge / cells, courant, stable_step(cube), exact, found);
      least = std::min(least, found / courant);
      largest = std::max(largest, found / courant);
      worst = std::max(worst, std::abs(found / exact - 1.0));
    }
  }
  result.tables.push_back(table);
  result.add("longest stable step over the Courant step, at least", "-", least);
  result.add("longest stable step over the Courant step, at most", "-", largest);
  result.add("longest stable step found by runs, beside two over the highest frequency", "-",
             worst);
}

Result measure_fracture_steps(const Parameters& settings) {
  const int fine = settings.count("fine");
  const double transits = settings.number("transits");
  Table table{"",
              {{"scene", "-", "1: plank, 2: wall"},
               {"material", "-", "1: glass, 2: concrete, 3: soft"},
               {"start", "1/s", "steps that stability needs before the first crack"},
               {"worst", "1/s", "the same of the worst mesh"},
               {"taken", "1/s", "steps that the code takes there"},
               {"pieces", "-", "at the end"}}};
  double decades = 0.0, start = 0.0, growth = 0.0;
  int number = 0;
  for (const NamedMaterial& named : materials()) {
    ++number;
    const std::array<Needed, 2> both{
        needed_by(falling_plank(named.material, kDropSpeed, {20 * fine, fine, 2 * fine}), transits,
                  kPlank.maxCoeff()),
        needed_by(hit_wall(named.material, kShotSpeed, {10 * fine, 8 * fine, fine}), transits,
                  kWall.maxCoeff())};
    for (std::size_t k = 0; k < both.size(); ++k) {
      const Needed& run = both[k];
      table.add(k + 1, number, run.start, run.worst, run.taken, run.pieces);
      decades += elementary::log(run.worst / kMillion) / elementary::log(10.0) / 6.0;
      start += elementary::log(run.start) / 6.0;
      growth = std::max(growth, run.worst / run.start);
    }
  }
  Result result{.tables = {table}};
  add_stable_steps(settings.count("cells"), result);
  result.add(
      "powers of ten between a million and the steps per second that stability needs, geometric "
      "mean over six runs",
      "-", std::abs(decades));
  result.add("steps per second that stability needs, geometric mean over six runs", "1/s",
             kMillion * elementary::pow(10.0, decades));
  result.add("the same before the first crack", "1/s", elementary::exp(start));
  result.add("how many times more steps cracks need, at most", "-", growth);
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const std::vector<double>& row = table.rows[k];
    result.add(std::string("steps per second for a ") + (row[0] < 1.5 ? "plank" : "wall") + " of " +
                   (row[1] < 1.5   ? "glass"
                    : row[1] < 2.5 ? "concrete"
                                   : "soft material"),
               "1/s", row[3]);
  }
  return result;
}

const Registered fracture_steps_figure{
    {.name = "claim_2_4_1a_fracture_steps",
     .parameters = {whole("fine", 2, 1, 8, "cells through the thickness of plank and wall"),
                    number("transits", 10.0, 1.0, 1000.0, "-",
                           "of a wave through the longest edge, for each run"),
                    whole("cells", 8, 2, 16, "largest number along an edge of the cube")},
     .quick = {"fine=1", "transits=3", "cells=4"},
     .experiment = measure_fracture_steps}};

}  // namespace
}  // namespace tumble::chapters
