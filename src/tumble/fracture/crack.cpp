/// \file
/// \brief Cracks.
#include "tumble/fracture/crack.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tumble {
namespace {

int place_in(const Tetrahedron& element, int node) {
  for (int i = 0; i < 4; ++i)
    if (element.nodes[idx(i)] == node) return i;
  return -1;
}

void weigh(ElasticMesh& mesh, int node) {
  double volume = 0.0;
  for (const int k : mesh.star[idx(node)]) volume += mesh.elements[idx(k)].volume;
  mesh.nodes[idx(node)].mass = 0.25 * mesh.material.density * volume;
}

// The plane through a node, and on which side of it the nodes around are.
struct SideOfPlane {
  int node = 0;
  double distance = 0.0;  // [m] above the plane
  int sign = 0;           // 0: the plane goes through it
};

class Splitter {
 public:
  Splitter(ElasticMesh& mesh, int node, const Vec3& normal_w, double least, CrackWork& work)
      : mesh_(mesh), node_(node), normal_w_(normal_w), least_(least), work_(work) {}
  bool split();

 private:
  using Edge = std::pair<int, int>;
  SideOfPlane& side(int node);
  void add_side(int node);
  [[nodiscard]] int sign_of(const Tetrahedron& element);
  std::vector<Edge> crossing();
  [[nodiscard]] bool divides(const Edge& edge, double share) const;
  int divide(const Edge& edge, double share);
  void loosen(int node);

  ElasticMesh& mesh_;
  int node_;
  Vec3 normal_w_;
  double least_;
  CrackWork& work_;
  std::vector<SideOfPlane> sides_;
};

SideOfPlane& Splitter::side(int node) {
  return *std::find_if(sides_.begin(), sides_.end(),
                       [&](const SideOfPlane& one) { return one.node == node; });
}

void Splitter::add_side(int node) {
  if (std::any_of(sides_.begin(), sides_.end(),
                  [&](const SideOfPlane& one) { return one.node == node; }))
    return;
  const Vec3 way = mesh_.nodes[idx(node)].position_w - mesh_.nodes[idx(node_)].position_w;
  const double distance = normal_w_.dot(way);
  const bool on = std::abs(distance) <= tolerance::crack_angle * way.norm();
  sides_.push_back({node, distance, on ? 0 : (distance > 0.0 ? 1 : -1)});
}

// The side of an element that the plane does not cross: of its nodes beside the plane, else of its middle.
int Splitter::sign_of(const Tetrahedron& element) {
  int sum = 0;
  double middle = 0.0;
  for (const int node : element.nodes) {
    sum += side(node).sign;
    middle += side(node).distance;
  }
  if (sum != 0) return sum > 0 ? 1 : -1;
  return middle >= 0.0 ? 1 : -1;
}

// Edges of the elements at the node whose ends are on different sides, each once.
std::vector<Splitter::Edge> Splitter::crossing() {
  std::vector<Edge> edges;
  for (const int k : mesh_.star[idx(node_)])
    for (const int a : mesh_.elements[idx(k)].nodes)
      for (const int b : mesh_.elements[idx(k)].nodes)
        if (a < b && side(a).sign * side(b).sign < 0) edges.emplace_back(a, b);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// Whether all elements at an edge can be divided without one that is too flat.
bool Splitter::divides(const Edge& edge, double share) const {
  const auto [a, b] = edge;
  std::array<ElasticNode, 5> nodes;
  nodes[4].rest = (1.0 - share) * mesh_.nodes[idx(a)].rest + share * mesh_.nodes[idx(b)].rest;
  for (const int k : mesh_.star[idx(a)]) {
    const Tetrahedron& element = mesh_.elements[idx(k)];
    if (place_in(element, b) < 0) continue;
    for (int i = 0; i < 4; ++i) nodes[idx(i)] = mesh_.nodes[idx(element.nodes[idx(i)])];
    for (const int end : {a, b}) {
      std::array<int, 4> part{0, 1, 2, 3};
      part[idx(place_in(element, end))] = 4;
      if (1.0 / tetrahedron(nodes, part).gradients.rowwise().norm().maxCoeff() < least_)
        return false;
    }
  }
  return true;
}

// Puts a node into an edge: each element there becomes two.
int Splitter::divide(const Edge& edge, double share) {
  const auto [a, b] = edge;
  const ElasticNode& one = mesh_.nodes[idx(a)];
  const ElasticNode& other = mesh_.nodes[idx(b)];
  ElasticNode between;
  between.rest = (1.0 - share) * one.rest + share * other.rest;
  between.position_w = (1.0 - share) * one.position_w + share * other.position_w;
  between.velocity_w = (1.0 - share) * one.velocity_w + share * other.velocity_w;
  between.moves = one.moves.cwiseMax(other.moves);
  const int fresh = static_cast<int>(mesh_.nodes.size());
  mesh_.nodes.push_back(between);
  mesh_.star.emplace_back();
  const std::vector<int> around = mesh_.star[idx(a)];
  std::vector<int> touched;
  for (const int k : around) {
    const std::array<int, 4> old = mesh_.elements[idx(k)].nodes;
    const int at_a = place_in(mesh_.elements[idx(k)], a);
    const int at_b = place_in(mesh_.elements[idx(k)], b);
    if (at_b < 0) continue;
    std::array<int, 4> near_a = old, near_b = old;
    near_a[idx(at_b)] = fresh;
    near_b[idx(at_a)] = fresh;
    const double volume = mesh_.elements[idx(k)].volume;
    mesh_.elements[idx(k)] = tetrahedron(mesh_.nodes, near_a);
    mesh_.elements.push_back(tetrahedron(mesh_.nodes, near_b));
    // Exactly what was there, whatever rounding does.
    mesh_.elements[idx(k)].volume = share * volume;
    mesh_.elements.back().volume = volume - mesh_.elements[idx(k)].volume;
    const int added = static_cast<int>(mesh_.elements.size()) - 1;
    std::vector<int>& star_b = mesh_.star[idx(b)];
    *std::find(star_b.begin(), star_b.end(), k) = added;
    std::sort(star_b.begin(), star_b.end());
    for (const int node : old)
      if (node != a && node != b) mesh_.star[idx(node)].push_back(added);
    mesh_.star[idx(fresh)].push_back(k);
    mesh_.star[idx(fresh)].push_back(added);
    touched.insert(touched.end(), old.begin(), old.end());
  }
  std::sort(mesh_.star[idx(fresh)].begin(), mesh_.star[idx(fresh)].end());
  touched.push_back(fresh);
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const int node : touched) weigh(mesh_, node);
  ++work_.splits;
  return fresh;
}

// Elements at a node that hang together by faces stay; each further part gets a node of its own.
void Splitter::loosen(int node) {
  std::vector<int> left = mesh_.star[idx(node)];
  for (bool first = true; !left.empty(); first = false) {
    std::vector<int> part{left.front()};
    left.erase(left.begin());
    for (std::size_t at = 0; at < part.size(); ++at)
      for (std::size_t k = 0; k < left.size();) {
        int common = 0;
        for (const int corner : mesh_.elements[idx(part[at])].nodes)
          common += place_in(mesh_.elements[idx(left[k])], corner) >= 0 ? 1 : 0;
        if (common == 3) {
          part.push_back(left[k]);
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
        } else {
          ++k;
        }
      }
    std::sort(part.begin(), part.end());
    int owner = node;
    if (!first) {
      owner = static_cast<int>(mesh_.nodes.size());
      ElasticNode copy = mesh_.nodes[idx(node)];
      copy.load_w.setZero();
      mesh_.nodes.push_back(copy);
      mesh_.star.emplace_back();
      for (const int k : part) {
        Tetrahedron& element = mesh_.elements[idx(k)];
        element.nodes[idx(place_in(element, node))] = owner;
      }
      ++work_.loose;
    }
    mesh_.star[idx(owner)] = std::move(part);
    weigh(mesh_, owner);
  }
}

bool Splitter::split() {
  for (const int k : mesh_.star[idx(node_)])
    for (const int node : mesh_.elements[idx(k)].nodes) add_side(node);
  // [S2.4.1:split]
  for (std::vector<Edge> edges = crossing(); !edges.empty(); edges = crossing()) {
    SideOfPlane& first = side(edges.front().first);
    SideOfPlane& second = side(edges.front().second);
    const double from = std::abs(first.distance), to = std::abs(second.distance);
    const double share = from / (from + to);
    if (divides(edges.front(), share)) {
      sides_.push_back({divide(edges.front(), share), 0.0, 0});
    } else {
      (share < 0.5 ? first : second).sign = 0;  // through the nearer end
    }
  }
  // [S2.4.1:split]
  // Now the plane runs along faces, if it parts anything.
  const int sign = sign_of(mesh_.elements[idx(mesh_.star[idx(node_)].front())]);
  if (std::all_of(mesh_.star[idx(node_)].begin(), mesh_.star[idx(node_)].end(),
                  [&](int k) { return sign_of(mesh_.elements[idx(k)]) == sign; }))
    return false;
  // The node becomes two.
  std::vector<int> above, below, around;
  for (const int k : mesh_.star[idx(node_)]) {
    (sign_of(mesh_.elements[idx(k)]) > 0 ? above : below).push_back(k);
    around.insert(around.end(), mesh_.elements[idx(k)].nodes.begin(),
                  mesh_.elements[idx(k)].nodes.end());
  }
  const int twin = static_cast<int>(mesh_.nodes.size());
  ElasticNode copy = mesh_.nodes[idx(node_)];
  copy.load_w.setZero();
  mesh_.nodes.push_back(copy);
  mesh_.star.push_back(below);
  mesh_.star[idx(node_)] = above;
  for (const int k : below)
    mesh_.elements[idx(k)].nodes[idx(place_in(mesh_.elements[idx(k)], node_))] = twin;
  ++work_.cracks;
  around.push_back(twin);
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  for (const int node : around) loosen(node);
  return true;
}

}  // namespace

double least_height(const ElasticMesh& mesh) {
  return tolerance::crack_least * courant_step(mesh) * mesh.material.wave_speed();
}

bool crack(ElasticMesh& mesh, int node, const Vec3& normal_w, double least, CrackWork& work) {
  return Splitter(mesh, node, normal_w, least, work).split();
}

bool crack_all(ElasticMesh& mesh, std::span<const double> tension, double least, CrackWork& work) {
  const std::size_t nodes = mesh.nodes.size();
  const double limit = tolerance::crack_tension * mesh.material.strength;
  std::vector<int> looked;
  for (std::size_t k = 0; k < tension.size(); ++k)
    if (tension[k] > limit)
      looked.insert(looked.end(), mesh.elements[k].nodes.begin(), mesh.elements[k].nodes.end());
  std::sort(looked.begin(), looked.end());
  looked.erase(std::unique(looked.begin(), looked.end()), looked.end());
  struct Broken {
    int node;
    double stress;
    Vec3 normal_w;
  };
  std::vector<Broken> broken;
  TensileStresses stresses(mesh);
  for (const int node : looked) {
    const NodeSeparation found = separation_at(stresses, node);
    if (found.stress() > mesh.material.strength)
      broken.push_back({node, found.stress(), found.normal_w});
  }
  std::stable_sort(broken.begin(), broken.end(),
                   [](const Broken& a, const Broken& b) { return a.stress > b.stress; });
  std::vector<int> relieved;
  for (const Broken& one : broken) {
    if (std::find(relieved.begin(), relieved.end(), one.node) != relieved.end()) continue;
    for (const int k : mesh.star[idx(one.node)])
      relieved.insert(relieved.end(), mesh.elements[idx(k)].nodes.begin(),
                      mesh.elements[idx(k)].nodes.end());
    crack(mesh, one.node, one.normal_w, least, work);
  }
  return mesh.nodes.size() > nodes;  // a plane that parts nothing may have divided edges
}

}  // namespace tumble
