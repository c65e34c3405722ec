/// \file
/// \brief Work and memory of joint forces in linear time (thesis 2.6.5).
#include "tumble/previous_work/joint_tree.hpp"

#include "driver/experiment.hpp"

namespace tumble::chapters {
namespace {

// Boxes in ball joints, each on an earlier one.
struct Hung {
  std::vector<MovingBody> bodies;
  std::vector<JointRows> joints;
};

// A chain of boxes, or a tree in which each carries two; the first one hangs on a wall.
Hung hung_boxes(int links, int children) {
  const BodyProperties box = box_properties(Vec3(1.0, 0.2, 0.2), 1.0);
  Hung hung;
  hung.bodies.emplace_back();  // the wall
  for (int k = 1; k <= links; ++k) {
    const int parent = k == 1 ? 0 : 1 + (k - 2) / children;
    hung.bodies.push_back(moving_body_of(box, make_state(box, Vec3::Zero())));
    JointRows joint;  // the end of one at the beginning of the other
    joint.first = parent;
    joint.second = k;
    joint.count = 3;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 along = Vec3::Unit(axis);
      joint.on_first.row(axis) << -along.transpose(), -Vec3(0.5, 0.0, 0.0).cross(along).transpose();
      joint.on_second.row(axis) << along.transpose(), Vec3(-0.5, 0.0, 0.0).cross(along).transpose();
    }
    hung.joints.push_back(joint);
  }
  return hung;
}

// One solve of all joint forces under gravity.
struct Cost {
  double multiplications = 0.0;
  double memory = 0.0;    // [bytes]
  double residual = 0.0;  // [-] relative acceleration left in a joint, over g
};

Cost cost_of(const Hung& hung) {
  JointTree tree;
  tree.arrange(hung.bodies, hung.joints);
  if (!tree.factor(hung.bodies, hung.joints))
    throw std::runtime_error("the joints of a chain depend on one another");
  std::vector<Vec6> body_part(hung.bodies.size(), Vec6::Zero());
  std::vector<Vec6> joint_part(hung.joints.size(), Vec6::Zero());
  for (std::size_t k = 1; k < hung.bodies.size(); ++k)
    body_part[k][1] = -kGravity / hung.bodies[k].inverse_mass.y();
  tree.solve(body_part, joint_part);
  Cost cost{static_cast<double>(tree.multiplications()), static_cast<double>(tree.memory()), 0.0};
  for (const JointRows& joint : hung.joints) {
    Vec6 left = joint.on_second * body_part[idx(joint.second)];
    if (joint.first > 0) left += joint.on_first * body_part[idx(joint.first)];
    cost.residual = std::max(cost.residual, left.cwiseAbs().maxCoeff() / kGravity);
  }
  return cost;
}

double exponent(double low, double high, double times) {
  return elementary::log(high / low) / elementary::log(times);
}

Result measure_articulated(const Parameters& settings) {
  const int most = settings.count("links");
  Table table{"",
              {{"links", "-", "boxes in ball joints"},
               {"chain", "-", "multiplications of a solve for a chain"},
               {"tree", "-", "the same for a tree in which each box carries two"},
               {"dense", "-", "of a dense factor of the same unknowns, a third of their cube"}}};
  std::vector<Cost> chains, trees;
  double residual = 0.0;
  for (int links = 10; links <= most; links *= 10) {
    chains.push_back(cost_of(hung_boxes(links, 1)));
    trees.push_back(cost_of(hung_boxes(links, 2)));
    const double unknowns = 9.0 * links;
    table.add(links, chains.back().multiplications, trees.back().multiplications,
              unknowns * unknowns * unknowns / 3.0);
    residual = std::max({residual, chains.back().residual, trees.back().residual});
  }
  // From 1000 to 100 000: of each tenfold step the exponent.
  double largest = 0.0, memory = 0.0;
  for (std::size_t k = 1; k < chains.size(); ++k) {
    if (k < 3 && most > 1000) continue;
    for (const std::vector<Cost>* costs : {&chains, &trees}) {
      const Cost& low = (*costs)[k - 1];
      const Cost& high = (*costs)[k];
      largest = std::max(largest, exponent(low.multiplications, high.multiplications, 10.0));
      memory = std::max(memory, exponent(low.memory, high.memory, 10.0));
    }
  }
  Result result{.tables = {table}};
  result.add(
      "the largest exponent of multiplications against links, of chains and trees from 1000 to "
      "100 000 links",
      "-", largest);
  result.add("the same of memory", "-", memory);
  result.add("multiplications for each link of the longest chain", "-",
             chains.back().multiplications / most);
  result.add("relative acceleration left in a joint, over g, at most", "-", residual);
  return result;
}

const Registered articulated_figure{
    {.name = "claim_2_6_5a_articulated",
     .parameters = {whole("links", 100000, 100, 1000000, "of the longest chain")},
     .quick = {"links=1000"},
     .experiment = measure_articulated}};

}  // namespace
}  // namespace tumble::chapters
