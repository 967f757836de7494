#pragma once

// A world of the C API with its context, for tests that say what stands where and look at what comes of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>

#include "capi/handles.h"
#include "catch.h"

namespace halfspace_test {

constexpr double pi = 3.14159265358979323846;
constexpr double rounding = 1.1102230246251565e-16;  // of one operation, relative
constexpr double degree = pi / 180;

inline double square_of(double x) { return x * x; }

inline hs_world_def world_def(double time_step, double gravity = -9.81) {
  hs_world_def def;
  hs_world_def_init(&def, sizeof def, 2);
  def.time_step = time_step;
  def.gravity[1] = gravity;
  return def;
}

/// The penalty spring of the papers: the same stiffness for normal and shear, no dashpots.
inline hs_law_def spring_law(double stiffness, double friction_angle = 0) {
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.friction_angle = friction_angle;
  law.normal_damping = law.shear_damping = 0;
  return law;
}

/// The potentials of Zheng et al. 2020: normal stiffness in Pa, that of the shear spring in N/m.
inline hs_law_def potential_law(double stiffness, double friction_angle = 0, double shear_stiffness = 1e7) {
  hs_law_def law = spring_law(stiffness, friction_angle);
  law.stiffness_kind = HS_STIFFNESS_POTENTIAL;
  law.shear_stiffness = shear_stiffness;
  return law;
}

constexpr int32_t all_stiffness_kinds[] = {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA,
                                           HS_STIFFNESS_POTENTIAL};

inline const char* name_of_stiffness(int32_t kind) {
  return kind == HS_STIFFNESS_POTENTIAL  ? "potential"
         : kind == HS_STIFFNESS_PER_AREA ? "per area"
                                         : "per contact";
}

/// Where a block starts, relative to where its vertices are given, and how it moves.
struct Start {
  int32_t kind = HS_BLOCK_RIGID;
  Point velocity{};
  double spin = 0;
};

class Scene {
 public:
  Scene(const hs_world_def& def, const hs_law_def& law, double density = 2000)
      : context_(make_context()), checks_losses_(law.stiffness_kind != HS_STIFFNESS_NONE) {
    hs_world* world = nullptr;
    require_ok(hs_world_create(context(), &def, &world), context());
    world_.reset(world);
    require_ok(hs_world_set_default_law(world, &law), context());
    add_material(density);
  }

  Scene(Scene&&) = default;
  Scene& operator=(Scene&&) = delete;
  /// Every scene ends without energy made. Contacts without springs book their losses up to what iterations
  /// leave, which is more than rounding.
  ~Scene() {
    if (world_ && checks_losses_ && std::uncaught_exceptions() == 0) check_losses();
  }

  /// For steps so large that motions make energy.
  void let_energy_be_made() { checks_losses_ = false; }

  /// No entry of losses is below zero by more than the rounding of many steps: it would be energy made that
  /// the residual does not show.
  void check_losses() const {
    const hs_world_report r = report();
    const double losses[] = {r.energy.friction_loss, r.energy.contact_damping_loss,
                             r.energy.local_damping_loss, r.energy.mass_damping_loss, r.block_damping_loss};
    double all = r.energy.kinetic + r.energy.strain + r.block_strain_energy;
    for (const double loss : losses) all += std::abs(loss);
    for (const double loss : losses) CHECK(loss >= -1e-9 * all);
  }

  hs_context* context() const { return context_.get(); }
  hs_world* world() const { return world_.get(); }
  void check(hs_status status) const { require_ok(status, context()); }

  int32_t add_material(double density) {
    int32_t material = 0;
    check(hs_world_add_material(world(), density, &material));
    return material;
  }

  hs_block add(const Points& vertices, const Start& start = {}, int32_t material = 0) {
    const Shape shape = make_shape(context(), vertices);
    return place(shape.get(), nullptr, start, material);
  }

  /// With the centroid somewhere, turned.
  hs_block add_at(const Points& vertices, Point centroid, double angle, const Start& start = {},
                  int32_t material = 0) {
    const Shape shape = make_shape(context(), vertices);
    const hs_pose pose = pose_at(centroid.x, centroid.y, std::sin(angle / 2), std::cos(angle / 2));
    return place(shape.get(), &pose, start, material);
  }

  /// Each segment of a chain as a block.
  void add_boundary(const Points& chain, double depth) {
    const auto end = [&](std::size_t i) { return std::array<double, 3>{chain[i].x, chain[i].y, 0}; };
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const auto before = end(i > 0 ? i - 1 : 0), after = end(std::min(i + 2, chain.size() - 1));
      hs_shape* made = nullptr;
      check(hs_polygon_create_boundary(context(), i > 0 ? before.data() : nullptr, end(i).data(),
                                       end(i + 1).data(), i + 2 < chain.size() ? after.data() : nullptr,
                                       depth, &made));
      const Shape shape(made);
      place(shape.get(), nullptr, {HS_BLOCK_FIXED, {}, 0}, 0);
    }
  }

  void step(std::int64_t steps = 1) { check(hs_world_step(world(), steps)); }

  void apply(hs_block block, Point force, double torque = 0) {
    const double f[3] = {force.x, force.y, 0}, t[3] = {0, 0, torque};
    check(hs_world_set_applied_force(world(), block, f, t));
  }

  void set_velocity(hs_block block, Point velocity, double spin = 0) {
    const double v[3] = {velocity.x, velocity.y, 0}, w[3] = {0, 0, spin};
    check(hs_world_set_velocity(world(), block, v, w));
  }

  /// Detects, and sets the force of a shear spring on the second block along the tangent, counter-clockwise
  /// of the normal from a to b.
  void preload_shear(hs_block a, hs_block b, double force) {
    check(hs_world_detect(world(), nullptr));
    const std::optional<hs_contact> between = contact_between(a, b);
    REQUIRE(between);
    const double sign = between->block_a == a ? force : -force;
    const double on_b[3] = {-sign * between->normal[1], sign * between->normal[0], 0};
    check(hs_world_set_shear_force(world(), a, b, on_b));
  }

  hs_block_state state(hs_block block) const {
    hs_block_state state;
    check(hs_world_get_block_state(world(), block, &state));
    return state;
  }
  Point position(hs_block block) const {
    const hs_block_state s = state(block);
    return {s.pose.position[0], s.pose.position[1]};
  }
  Point velocity(hs_block block) const {
    const hs_block_state s = state(block);
    return {s.velocity[0], s.velocity[1]};
  }
  double spin(hs_block block) const { return state(block).angular_velocity[2]; }

  hs_world_report report() const {
    hs_world_report report;
    check(hs_world_get_report(world(), &report, sizeof report));
    return report;
  }
  hs_energy energy() const { return report().energy; }

  std::vector<hs_block> blocks() const {
    std::vector<hs_block> blocks(std::size_t(report().block_count));
    check(hs_world_get_blocks(world(), blocks.data(), std::int64_t(blocks.size()), nullptr));
    return blocks;
  }

  std::vector<hs_contact> contacts() const {
    std::int64_t count = 0;
    (void)hs_world_get_contacts(world(), nullptr, 0, &count);
    std::vector<hs_contact> contacts(static_cast<std::size_t>(count));
    check(hs_world_get_contacts(world(), contacts.data(), count, nullptr));
    return contacts;
  }

  std::optional<hs_contact> contact_between(hs_block a, hs_block b) const {
    for (const hs_contact& contact : contacts())
      if (std::minmax(contact.block_a, contact.block_b) == std::minmax(a, b)) return contact;
    return std::nullopt;
  }

  Points vertices(hs_block block) const {
    std::int64_t count = 0;
    Points vertices(64);
    check(hs_world_get_block_vertices(world(), block, mutable_view_of(vertices), &count));
    vertices.resize(std::size_t(count));
    return vertices;
  }

 protected:
  hs_block place(const hs_shape* shape, const hs_pose* pose, const Start& start, int32_t material) {
    hs_block_def def;
    check(hs_block_def_init(&def, sizeof def, shape));
    def.kind = start.kind;
    def.material = material;
    if (pose) def.pose = *pose;
    def.velocity[0] = start.velocity.x;
    def.velocity[1] = start.velocity.y;
    def.angular_velocity[2] = start.spin;
    hs_block block = 0;
    check(hs_world_add_block(world(), shape, &def, &block));
    return block;
  }

 private:
  Context context_;
  World world_;
  bool checks_losses_;
};

inline Points rectangle(double width, double height) {
  return box(-width / 2, -height / 2, width / 2, height / 2);
}

}  // namespace halfspace_test
