/// \file
/// \brief Bullet as an engine of scenes.cpp; empty where Bullet was not found at build time.
#ifdef TUMBLE_HAVE_BULLET
#include "scene_peers.hpp"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <vector>

namespace scene_bench {
namespace {

using tumble::BodyProperties;
using tumble::BodyState;
using tumble::Quat;
using tumble::Vec3;
using tumble::World;

// btSequentialImpulseConstraintSolver with Bullet's own defaults (10 iterations, one direction of
// friction) unless said. The ground is the top of a large static box, since its plane gives fewer
// contacts. Units are metres, and the box-box routine works on full sizes: margins do not show.
class Bullet : public Peer {
 public:
  Bullet(const World& start, bool sleeping, int iterations, bool two_directions)
      : sleeping_(sleeping),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &pairs_, &solver_, &configuration_) {
    world_.setGravity(converted(start.gravity_w));
    world_.getSolverInfo().m_numIterations = iterations;
    if (two_directions) world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  }
  ~Bullet() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;

  void advance(World& /*world*/, double dt) override {
    world_.stepSimulation(static_cast<btScalar>(dt), 0);
  }

 protected:
  void add(const BodyProperties& body, const BodyState& state) override {
    const bool ground = body.shape == tumble::Shape::ground;
    const Vec3 size = ground ? Vec3(kGroundEdge, kGroundThick, kGroundEdge) : body.size;
    const Vec3 center = ground ? Vec3(0.0, -0.5 * kGroundThick, 0.0) : state.position_w;
    shapes_.push_back(std::make_unique<btBoxShape>(converted(0.5 * size)));
    const btScalar mass = body.movable() ? static_cast<btScalar>(body.mass) : btScalar(0);
    const btVector3 inertia = body.movable() ? converted(body.inertia_b) : btVector3(0, 0, 0);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shapes_.back().get(), inertia);
    const Quat& q = state.orientation_wb;
    info.m_startWorldTransform =
        btTransform(btQuaternion(scalar(q.x()), scalar(q.y()), scalar(q.z()), scalar(q.w())),
                    converted(center));
    info.m_friction = scalar(std::sqrt(body.friction));  // products are taken
    info.m_restitution = scalar(std::sqrt(body.restitution));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& added = *bodies_.back();
    added.setLinearVelocity(converted(velocity(body, state)));
    added.setAngularVelocity(converted(angular_velocity(body, state)));
    if (!sleeping_) added.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&added);
  }

  [[nodiscard]] Motion motion(int i) const override {
    const btRigidBody& body = *bodies_[static_cast<std::size_t>(i)];
    const btTransform& pose = body.getWorldTransform();
    const btQuaternion q = pose.getRotation();
    return {converted(pose.getOrigin()),
            Quat(number(q.w()), number(q.x()), number(q.y()), number(q.z())),
            converted(body.getLinearVelocity()), converted(body.getAngularVelocity())};
  }

  [[nodiscard]] bool sleeps(int i) const override {
    return !bodies_[static_cast<std::size_t>(i)]->isActive();
  }

 private:
  static constexpr double kGroundEdge = 200.0;  // [m]
  static constexpr double kGroundThick = 10.0;  // [m]

  static btScalar scalar(double x) { return static_cast<btScalar>(x); }
  static double number(btScalar x) { return static_cast<double>(x); }
  static btVector3 converted(const Vec3& v) {
    return {scalar(v.x()), scalar(v.y()), scalar(v.z())};
  }
  static Vec3 converted(const btVector3& v) {
    return {number(v.x()), number(v.y()), number(v.z())};
  }

  bool sleeping_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase pairs_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btBoxShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::unique_ptr<Engine> make_bullet(const World& start, bool sleeping, int iterations,
                                    bool two_directions) {
  return std::make_unique<Bullet>(start, sleeping, iterations, two_directions);
}

std::string bullet_version() {
  return "Bullet " + std::to_string(btGetVersion() / 100) + "." +
         std::to_string(btGetVersion() % 100) + " in " +
         (sizeof(btScalar) == 8 ? "double" : "single") + " precision";
}

}  // namespace scene_bench
#endif
