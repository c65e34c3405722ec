/// \file
/// \brief ODE as an engine of scenes.cpp; empty where ODE was not found at build time.
#ifdef TUMBLE_HAVE_ODE
#include "scene_peers.hpp"

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scene_bench {
namespace {

using tumble::BodyProperties;
using tumble::BodyState;
using tumble::Quat;
using tumble::Vec3;
using tumble::World;

// dWorldQuickStep with ODE's own defaults (ERP 0.2, CFM 1e-10), up to 8 contacts a pair with the
// friction pyramid of dContactApprox1, a hash space. The ground is a plane.
class Ode : public Peer {
 public:
  Ode(const World& start, bool sleeping, int iterations) {
    static const Library library;
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    joints_ = dJointGroupCreate(0);
    const Vec3& g = start.gravity_w;
    dWorldSetGravity(world_, real(g.x()), real(g.y()), real(g.z()));
    dWorldSetQuickStepNumIterations(world_, iterations);
    dWorldSetAutoDisableFlag(world_, sleeping ? 1 : 0);
  }
  ~Ode() override {
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  void advance(World& /*world*/, double dt) override {
    dRandSetSeed(seed_);  // the order of its sweeps is random; other runs have their own
    dSpaceCollide(space_, this, &Ode::near);
    dWorldQuickStep(world_, real(dt));
    dJointGroupEmpty(joints_);
    seed_ = dRandGetSeed();
  }

 protected:
  void add(const BodyProperties& body, const BodyState& state) override {
    dGeomID geom = nullptr;
    dBodyID id = nullptr;
    if (body.shape == tumble::Shape::ground) {
      geom = dCreatePlane(space_, 0, 1, 0, 0);
    } else {
      geom = dCreateBox(space_, real(body.size.x()), real(body.size.y()), real(body.size.z()));
      if (body.movable()) {
        id = dBodyCreate(world_);
        dGeomSetBody(geom, id);
      }
      const Vec3& x = state.position_w;
      const Quat& q = state.orientation_wb;
      const dQuaternion turned = {real(q.w()), real(q.x()), real(q.y()), real(q.z())};
      dGeomSetPosition(geom, real(x.x()), real(x.y()), real(x.z()));
      dGeomSetQuaternion(geom, turned);
    }
    if (id != nullptr) {
      dMass mass;
      dMassSetBoxTotal(&mass, real(body.mass), real(body.size.x()), real(body.size.y()),
                       real(body.size.z()));
      dBodySetMass(id, &mass);
      const Vec3 v = velocity(body, state);
      const Vec3 w = angular_velocity(body, state);
      dBodySetLinearVel(id, real(v.x()), real(v.y()), real(v.z()));
      dBodySetAngularVel(id, real(w.x()), real(w.y()), real(w.z()));
    }
    surface_.push_back({body.friction, body.restitution});
    dGeomSetData(geom, reinterpret_cast<void*>(surface_.size() - 1));
    bodies_.push_back(id);
  }

  [[nodiscard]] Motion motion(int i) const override {
    const dBodyID id = bodies_[static_cast<std::size_t>(i)];
    const dReal* x = dBodyGetPosition(id);
    const dReal* q = dBodyGetQuaternion(id);
    const dReal* v = dBodyGetLinearVel(id);
    const dReal* w = dBodyGetAngularVel(id);
    return {Vec3(x[0], x[1], x[2]), Quat(q[0], q[1], q[2], q[3]), Vec3(v[0], v[1], v[2]),
            Vec3(w[0], w[1], w[2])};
  }

  [[nodiscard]] bool sleeps(int i) const override {
    return dBodyIsEnabled(bodies_[static_cast<std::size_t>(i)]) == 0;
  }

 private:
  struct Library {
    Library() { dInitODE2(0); }
    ~Library() { dCloseODE(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };
  struct Surface {
    double friction, restitution;
  };
  static constexpr int kMostContacts = 8;

  static dReal real(double x) { return static_cast<dReal>(x); }

  static void near(void* self, dGeomID a, dGeomID b) {
    const dBodyID first = dGeomGetBody(a);
    const dBodyID second = dGeomGetBody(b);
    const auto awake = [](dBodyID id) { return id != nullptr && dBodyIsEnabled(id) != 0; };
    if (!awake(first) && !awake(second)) return;
    static_cast<Ode*>(self)->join(a, b, first, second);
  }

  void join(dGeomID a, dGeomID b, dBodyID first, dBodyID second) {
    const Surface& one = surface_[reinterpret_cast<std::size_t>(dGeomGetData(a))];
    const Surface& other = surface_[reinterpret_cast<std::size_t>(dGeomGetData(b))];
    dContact contacts[kMostContacts];
    const int count =
        dCollide(a, b, kMostContacts, &contacts[0].geom, static_cast<int>(sizeof(dContact)));
    for (int k = 0; k < count; ++k) {
      dSurfaceParameters& s = contacts[k].surface;
      s = {};
      s.mode = dContactApprox1 | dContactBounce;
      s.mu = real(std::sqrt(one.friction * other.friction));
      s.bounce = real(std::max(one.restitution, other.restitution));
      dJointAttach(dJointCreateContact(world_, joints_, &contacts[k]), first, second);
    }
  }

  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID joints_ = nullptr;
  std::vector<dBodyID> bodies_;
  std::vector<Surface> surface_;
  unsigned long seed_ = 0;
};

}  // namespace

std::unique_ptr<Engine> make_ode(const World& start, bool sleeping, int iterations) {
  return std::make_unique<Ode>(start, sleeping, iterations);
}

std::string ode_version() {
  return "ODE " dODE_VERSION " in " + std::string(sizeof(dReal) == 8 ? "double" : "single") +
         " precision";
}

}  // namespace scene_bench
#endif
