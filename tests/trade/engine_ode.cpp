#include <ode/ode.h>

#include <array>
#include <stdexcept>

#include "benchmarks/timing.h"
#include "engine.h"

namespace halfspace_trade {
namespace {

struct Library {
  Library() { dInitODE2(0); }
  ~Library() { dCloseODE(); }
};

class OdeWorld : public World {
 public:
  OdeWorld(const Scene& scene, const Setting& setting)
      : way_(setting.way),
        friction_(scene.friction),
        restitution_(scene.restitution),
        time_step_(whole_part(scene.duration, setting.step)) {
    static const Library library;
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    dWorldSetQuickStepNumIterations(world_, way_ == "100 iterations" ? 100 : 20);
    for (const Body& body : scene.bodies) add(body);
  }
  ~OdeWorld() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  double step(long steps) override {
    return halfspace_benchmark::seconds_of([&] {
      for (long i = 0; i < steps; ++i) {
        dSpaceCollide(space_, this, touch);
        const auto step_world = way_ == "direct" ? dWorldStep : dWorldQuickStep;
        if (!step_world(world_, time_step_)) throw std::runtime_error("ODE has not enough memory for a step");
        dJointGroupEmpty(contacts_);
      }
    });
  }
  double time_step() const override { return time_step_; }

  State state(std::size_t i) const override {
    const dBodyID body = bodies_[i];
    const dReal* turn = dBodyGetQuaternion(body);  // w first
    return {vector_from(dBodyGetPosition(body)),
            {turn[1], turn[2], turn[3], turn[0]},
            vector_from(dBodyGetLinearVel(body)),
            vector_from(dBodyGetAngularVel(body))};
  }

 private:
  static Vector vector_from(const dReal* v) { return {v[0], v[1], v[2]}; }

  void add(const Body& body) {
    const auto& [x, y, z, w] = body.rotation;
    const dQuaternion turn = {w, x, y, z};
    const dGeomID box = dCreateBox(space_, body.size[0], body.size[1], body.size[2]);
    const dBodyID made = body.is_fixed ? nullptr : dBodyCreate(world_);
    if (made) {
      dMass mass;
      dMassSetBox(&mass, body.density, body.size[0], body.size[1], body.size[2]);
      dBodySetMass(made, &mass);
      dGeomSetBody(box, made);
      dBodySetLinearVel(made, body.velocity[0], body.velocity[1], body.velocity[2]);
      dBodySetAngularVel(made, body.spin[0], body.spin[1], body.spin[2]);
    }
    dGeomSetPosition(box, body.position[0], body.position[1], body.position[2]);
    dGeomSetQuaternion(box, turn);
    bodies_.push_back(made);
  }

  static void touch(void* self, dGeomID a, dGeomID b) { static_cast<OdeWorld*>(self)->add_contacts(a, b); }

  void add_contacts(dGeomID a, dGeomID b) {
    if (!dGeomGetBody(a) && !dGeomGetBody(b)) return;
    std::array<dContact, 8> contacts{};
    const int count = dCollide(a, b, int(contacts.size()), &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      dContact& contact = contacts[std::size_t(i)];
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = friction_;
      if (restitution_ > 0) {
        contact.surface.mode |= dContactBounce;
        contact.surface.bounce = restitution_;
        contact.surface.bounce_vel = 0.01;
      }
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  std::string way_;
  double friction_;
  double restitution_;
  double time_step_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<dBodyID> bodies_;
};

}  // namespace

const char* engine_name() { return "ODE"; }
bool knows_dimension(int dimension) { return dimension == 3; }
bool knows_hulls() { return false; }

std::vector<Setting> settings() { return with_frame_steps({"direct", "20 iterations", "100 iterations"}); }

std::unique_ptr<World> build(const Scene& scene, const Setting& setting) {
  return std::make_unique<OdeWorld>(scene, setting);
}

}  // namespace halfspace_trade
