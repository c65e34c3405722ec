/// \file
/// \brief Common interface of the routines in narrow_phase.cpp, ours and those of the installed engines.
#pragma once

#include "tumble/geometry/box.hpp"

#ifdef TUMBLE_HAVE_ODE
#include <ode/ode.h>
#endif
#ifdef TUMBLE_HAVE_BULLET
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace narrow_phase {

// Two boxes to be tested against each other.
struct Pair {
  tumble::Box first;   // the one
  tumble::Box second;  // the other
};

// What a routine says about one pair.
struct Answer {
  int points = 0;      // how many contact points
  double depth = 0.0;  // [m] of the deepest one; meaningless without points
};

// A routine under test.
struct Routine {
  std::string name;                          // as printed
  std::function<double()> run;               // over all pairs; a sum that depends on each
  std::function<Answer(std::size_t k)> ask;  // about pair k, for the quality; not timed
  std::vector<double> ns;                    // [ns] per pair, one for each round
};

// Makes a run over all pairs of a call on one pair.
template <typename Call>
std::function<double()> over_all(std::size_t count, Call call) {
  return [count, call]() mutable {
    double sum = 0.0;
    for (std::size_t k = 0; k < count; ++k) sum += call(k);
    return sum;
  };
}

#ifdef TUMBLE_HAVE_ODE
// A box as ODE wants it.
struct OdeBox {
  dVector3 center{};
  dMatrix3 axes{};
  dVector3 size{};

  explicit OdeBox(const tumble::Box& box) {
    for (int i = 0; i < 3; ++i) {
      center[i] = static_cast<dReal>(box.center_w[i]);
      size[i] = static_cast<dReal>(2.0 * box.half[i]);
      for (int j = 0; j < 3; ++j) axes[4 * i + j] = static_cast<dReal>(box.axes_w(i, j));
    }
  }
};

// A pair as ODE wants it.
struct OdePair {
  OdeBox first, second;
};

// ODE's dBoxBox.
inline Routine ode(const std::vector<Pair>& pairs) {
  const auto boxes = std::make_shared<std::vector<OdePair>>();
  for (const Pair& pair : pairs) boxes->push_back({OdeBox(pair.first), OdeBox(pair.second)});
  const auto ask = [boxes](std::size_t k) {
    const OdeBox& a = (*boxes)[k].first;
    const OdeBox& b = (*boxes)[k].second;
    dContactGeom contacts[8];
    dVector3 normal;
    dReal depth = 0;
    int code = 0;
    const int count = dBoxBox(a.center, a.axes, a.size, b.center, b.axes, b.size, normal, &depth,
                              &code, 8, contacts, static_cast<int>(sizeof(dContactGeom)));
    return Answer{count, static_cast<double>(depth)};
  };
  const auto timed = [ask](std::size_t k) { return ask(k).depth; };
  return {"ODE dBoxBox", over_all(pairs.size(), timed), ask, {}};
}
#endif

#ifdef TUMBLE_HAVE_BULLET
// A pair as Bullet wants it.
struct BulletPair {
  btBoxShape first, second;
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;

  static btVector3 converted(const tumble::Vec3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()),
            static_cast<btScalar>(v.z())};
  }
  static btTransform converted(const tumble::Box& box) {
    btMatrix3x3 axes;
    for (int i = 0; i < 3; ++i) axes[i] = converted(tumble::Vec3(box.axes_w.row(i)));
    return btTransform(axes, converted(box.center_w));
  }
  explicit BulletPair(const Pair& pair)
      : first(converted(pair.first.half)), second(converted(pair.second.half)) {
    input.m_transformA = converted(pair.first);
    input.m_transformB = converted(pair.second);
  }
};

// Counts the points that Bullet finds.
struct BulletPoints : btDiscreteCollisionDetectorInterface::Result {
  Answer answer;
  void setShapeIdentifiersA(int /*part*/, int /*index*/) override {}
  void setShapeIdentifiersB(int /*part*/, int /*index*/) override {}
  void addContactPoint(const btVector3& /*normal*/, const btVector3& /*point*/,
                       btScalar distance) override {
    ++answer.points;
    answer.depth = std::max(answer.depth, -static_cast<double>(distance));
  }
};

// Bullet's btBoxBoxDetector, in the precision that Bullet was built with.
inline Routine bullet(const std::vector<Pair>& pairs) {
  const auto boxes = std::make_shared<std::vector<BulletPair>>();
  boxes->reserve(pairs.size());
  for (const Pair& pair : pairs) boxes->emplace_back(pair);
  const auto ask = [boxes](std::size_t k) {
    const BulletPair& pair = (*boxes)[k];
    btBoxBoxDetector detector(&pair.first, &pair.second);
    BulletPoints points;
    detector.getClosestPoints(pair.input, points, nullptr);
    return points.answer;
  };
  const auto timed = [ask](std::size_t k) { return ask(k).depth; };
  const char* name = sizeof(btScalar) == 8 ? "Bullet box-box (double)" : "Bullet box-box (float)";
  return {name, over_all(pairs.size(), timed), ask, {}};
}
#endif

// The box-box routines of the engines that were found at build time.
inline std::vector<Routine> peers([[maybe_unused]] const std::vector<Pair>& pairs) {
  std::vector<Routine> out;
#ifdef TUMBLE_HAVE_ODE
  out.push_back(ode(pairs));
#endif
#ifdef TUMBLE_HAVE_BULLET
  out.push_back(bullet(pairs));
#endif
  return out;
}

}  // namespace narrow_phase
