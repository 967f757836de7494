#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "benchmarks/timing.h"
#include "engine.h"

namespace halfspace_trade {
namespace {

btScalar scalar(double x) { return btScalar(x); }
btVector3 vector_of(const Vector& v) { return {scalar(v[0]), scalar(v[1]), scalar(v[2])}; }
Vector vector_from(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }

class BulletWorld : public World {
 public:
  BulletWorld(const Scene& scene, const Setting& setting)
      : time_step_(whole_part(scene.duration, setting.step)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broad_phase_, &solver_, &configuration_) {
    world_.setGravity(vector_of(scene.gravity));
    // One direction of friction, that of the slip, is not along the slide in a trough.
    world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    world_.getSolverInfo().m_numIterations = setting.way == "100 iterations" ? 100 : 10;
    for (const Body& body : scene.bodies) add(body, scene);
  }
  ~BulletWorld() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  double step(long steps) override {
    return halfspace_benchmark::seconds_of([&] {
      for (long i = 0; i < steps; ++i) world_.stepSimulation(scalar(time_step_), 0);
    });
  }
  double time_step() const override { return time_step_; }

  State state(std::size_t i) const override {
    const btRigidBody& body = *bodies_[i];
    const btQuaternion turn = body.getWorldTransform().getRotation();
    return {vector_from(body.getWorldTransform().getOrigin()),
            {double(turn.x()), double(turn.y()), double(turn.z()), double(turn.w())},
            vector_from(body.getLinearVelocity()),
            vector_from(body.getAngularVelocity())};
  }

 private:
  void add(const Body& body, const Scene& scene) {
    shapes_.push_back(std::make_unique<btBoxShape>(vector_of(body.size) / 2));
    const Mass mass = mass_of(body, 3);
    btRigidBody::btRigidBodyConstructionInfo info(
        scalar(body.is_fixed ? 0 : mass.mass), nullptr, shapes_.back().get(),
        body.is_fixed ? btVector3(0, 0, 0) : vector_of(mass.inertia));
    const auto& [x, y, z, w] = body.rotation;
    info.m_startWorldTransform =
        btTransform({scalar(x), scalar(y), scalar(z), scalar(w)}, vector_of(body.position));
    info.m_friction = scalar(std::sqrt(scene.friction));  // Bullet multiplies those of both
    info.m_restitution = scalar(scene.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    made.setLinearVelocity(vector_of(body.velocity));
    made.setAngularVelocity(vector_of(body.spin));
    made.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&made);
  }

  double time_step_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btBoxShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

const char* engine_name() { return sizeof(btScalar) == 8 ? "Bullet, double" : "Bullet, single"; }
bool knows_dimension(int dimension) { return dimension == 3; }
bool knows_hulls() { return false; }

std::vector<Setting> settings() { return with_frame_steps({"10 iterations", "100 iterations"}); }

std::unique_ptr<World> build(const Scene& scene, const Setting& setting) {
  return std::make_unique<BulletWorld>(scene, setting);
}

}  // namespace halfspace_trade
