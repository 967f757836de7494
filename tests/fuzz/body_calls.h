#pragma once

// Calls of a fuzzer on the bodies, bonds and rest of a world.

#include "fuzz/world_calls.h"

namespace halfspace_fuzz {

using namespace halfspace_test;

/// A world that calls are made on. Ids may be stale.
class WorldUnderCalls {
 public:
  WorldUnderCalls(Bytes bytes, hs_context* context) : bytes_(bytes), context_(context) {}

 protected:
  static constexpr int max_steps = 30;

  hs_world* world() const { return world_.get(); }

  /// Whether it has succeeded; else the world is bit for bit what it was.
  template <class Call>
  bool unless_refused(const char* name, Call call) {
    const std::vector<unsigned char> before = saved_between_steps(world());
    if (succeeds_or(call(), {HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY, HS_ERROR_STALE_ID, HS_ERROR_STATE}, name))
      return true;
    demand(saved_between_steps(world()) == before, "a call that fails changes nothing");
    demand(*hs_context_last_error(context_) != 0, "a refusal has a text");
    return false;
  }

  /// Now and then one that is no longer there, or never was.
  hs_block any_block() {
    if (ids_.empty() || bytes_.byte() == 0) return bytes_.raw<std::uint8_t>();
    return ids_[std::size_t(bytes_.below(int(ids_.size())))];
  }

  Bytes bytes_;
  hs_context* context_;
  int dimension_ = 2;
  World world_;
  std::vector<hs_block> ids_;
  std::vector<hs_body> bodies_;
  int steps_ = 0;
};

class BodyCalls : public WorldUnderCalls {
 protected:
  using WorldUnderCalls::WorldUnderCalls;

  void call_of_bodies(int which) {
    switch (which) {
      case 0:
      case 1:
      case 2:
        return add_mesh();
      case 3:
        return remove_body();
      case 4:
      case 5:
        return hold_nodes();
      case 6:
      case 7:
        return push_nodes();
      case 8:
        return set_node_velocities();
      case 9:
      case 10:
      case 11:
        return bond_materials();
      case 12:
        return bond_blocks();
      case 13:
        return hold_bonds();
      case 14:
        return set_gravity();
      case 15:
        return set_damping();
      case 16:
        return set_time_step();
      case 17:
        return set_strength_factor();
      case 18:
        return check_balance(world());
      case 19:
        return find_strength_factor();
      case 20:
      case 21:
        return remove_cells();
      case 22:
      case 23:
        return set_body_stress();
      default:
        return relax();
    }
  }

  hs_body any_body() {
    if (bodies_.empty() || bytes_.byte() == 0) return bytes_.raw<std::uint8_t>();
    return bodies_[std::size_t(bytes_.below(int(bodies_.size())))];
  }

  /// Mostly one of the body's.
  std::int32_t any_node() { return bytes_.below(16) - 1; }

 private:
  static constexpr std::size_t most_bodies = 3;

  /// A bar, whose nodes are moved a little.
  void add_mesh() {
    MeshWords words = bar(dimension_, bytes_.positive_or(1));
    for (int moved = bytes_.below(4); moved > 0; --moved) {
      Point3& node = words.nodes[std::size_t(bytes_.below(int(words.nodes.size())))];
      node = node + read_point(bytes_);
    }
    if (bytes_.byte() == 1) words.kinds[0] = bytes_.below(6);
    if (bytes_.byte() == 1) words.cell_nodes[std::size_t(bytes_.below(10))] = any_node();
    hs_mesh* made = nullptr;
    if (!succeeds_or(create_mesh(context_, words, &made), {HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY},
                     "create_mesh"))
      return;
    const Mesh mesh(made);
    if (bodies_.size() >= most_bodies) return;
    hs_body_def def = body_def();
    def.material = bytes_.below(3);
    if (bytes_.flag()) def.pose = read_pose(bytes_, dimension_);
    if (bytes_.flag()) read_into(def.velocity, bytes_, dimension_);
    hs_body body = 0;
    if (unless_refused("add_mesh",
                       [&] { return hs_world_add_mesh(world(), mesh.get(), &def, nullptr, &body); }))
      bodies_.push_back(body);
    ids_ = blocks_of(world());
  }

  void remove_body() {
    const hs_body body = any_body();
    if (unless_refused("remove_body", [&] { return hs_world_remove_body(world(), body); }))
      std::erase(bodies_, body);
  }

  void hold_nodes() {
    const hs_body body = any_body();
    const std::int32_t nodes[] = {any_node(), any_node()};
    const int axes = bytes_.below(9);
    double velocity[3];
    read_into(velocity, bytes_, dimension_);
    unless_refused("hold_nodes",
                   [&] { return hs_world_hold_nodes(world(), body, nodes, 2, axes, velocity); });
  }

  void push_nodes() {
    const hs_body body = any_body();
    const std::int32_t node = any_node();
    double force[3];
    read_into(force, bytes_, dimension_);
    unless_refused("set_node_force", [&] { return hs_world_set_node_force(world(), body, &node, 1, force); });
  }

  void set_node_velocities() {
    const hs_body body = any_body();
    Points3 velocities(bar(dimension_).nodes.size());
    for (Point3& velocity : velocities) velocity = read_point(bytes_);
    unless_refused("set_node_velocities",
                   [&] { return hs_world_set_node_velocities(world(), body, view_of(velocities)); });
  }

  void remove_cells() {
    const hs_body body = any_body();
    const std::int32_t cells[] = {bytes_.below(6) - 1, bytes_.below(6) - 1};
    const int count = bytes_.between(1, 2);
    Points3 released(16);
    unless_refused("remove_cells", [&] {
      return hs_world_remove_cells(world(), body, cells, count, mutable_view_of(released));
    });
    ids_ = blocks_of(world());
  }

  void set_body_stress() {
    const hs_body body = any_body();
    const double xx = 1024 * bytes_.number(), yy = 1024 * bytes_.number(), xy = bytes_.number();
    const double stress[9] = {xx, xy, 0, xy, yy, 0, 0, 0, xx};
    double gradient[27] = {};
    gradient[13] = bytes_.number();
    const bool is_even = bytes_.flag();
    unless_refused("set_body_stress", [&] {
      return hs_world_set_body_stress(world(), body, stress, is_even ? nullptr : gradient);
    });
  }

  hs_bond_def read_bond() {
    hs_bond_def def = bond_def(1024 * bytes_.positive(), bytes_.positive_or(0));
    if (bytes_.flag()) def.shear_stiffness = 1024 * bytes_.positive();
    if (bytes_.flag()) def.friction_angle = bytes_.below(90) / 57.3;
    if (bytes_.flag()) return def;
    def.residual_cohesion = bytes_.positive_or(0);
    def.residual_friction_angle = bytes_.below(90) / 57.3;
    def.tensile_fracture_energy = bytes_.positive_or(0);
    def.shear_fracture_energy = bytes_.positive_or(0);
    return def;
  }

  void bond_materials() {
    const hs_bond_def def = read_bond();
    const int a = bytes_.below(3), b = bytes_.below(3);
    unless_refused("bond_materials", [&] { return hs_world_bond_materials(world(), a, b, &def, nullptr); });
  }

  void bond_blocks() {
    const hs_bond_def def = read_bond();
    const hs_block a = any_block(), b = any_block();
    unless_refused("bond_blocks", [&] { return hs_world_bond_blocks(world(), a, b, &def); });
  }

  void hold_bonds() {
    const int are_held = bytes_.below(3);
    unless_refused("hold_bonds", [&] { return hs_world_hold_bonds(world(), are_held); });
  }

  void set_gravity() {
    double gravity[3];
    read_into(gravity, bytes_, dimension_);
    unless_refused("set_gravity", [&] { return hs_world_set_gravity(world(), gravity); });
  }

  void set_damping() {
    const double local = bytes_.positive_or(0), by_mass = bytes_.positive_or(0);
    unless_refused("set_damping", [&] { return hs_world_set_damping(world(), local, by_mass); });
  }

  void set_time_step() {
    const double time_step = bytes_.positive_or(0) / 4096;
    unless_refused("set_time_step", [&] { return hs_world_set_time_step(world(), time_step); });
  }

  void set_strength_factor() {
    const double factor = bytes_.positive();
    unless_refused("set_strength_factor", [&] { return hs_world_set_strength_factor(world(), factor); });
  }

  hs_relaxation_def read_relaxation(int steps) {
    hs_relaxation_def def = relaxation_def(steps, bytes_.positive_or(1e-5));
    def.measure = bytes_.below(3);
    def.local_damping = bytes_.positive_or(def.local_damping);
    def.is_adaptive = bytes_.below(2);
    def.hold_bonds = bytes_.below(2);
    return def;
  }

  void relax() {
    const int steps = std::min(bytes_.between(1, 12), max_steps - steps_);
    const hs_relaxation_def def = read_relaxation(std::max(steps, 1));
    if (steps <= 0) return;
    steps_ += steps;
    if (!halfspace_fuzz::relax(world(), def)) steps_ = max_steps;
  }

  void find_strength_factor() {
    hs_strength_def def;
    hs_strength_def_init(&def, sizeof def);
    def.max_steps = bytes_.between(1, 3);
    def.resolution = 4;
    def.ratio = bytes_.positive_or(def.ratio);
    if (steps_ + 6 > max_steps) return;
    steps_ += 6;
    const std::vector<unsigned char> before = saved_between_steps(world());
    hs_strength_report report;
    hs_world* fallen = nullptr;
    const hs_status status = hs_world_find_strength_factor(world(), &def, &report, sizeof report, &fallen);
    const World owner(fallen);
    if (!succeeds_or(
            status,
            {HS_ERROR_ARGUMENT, HS_ERROR_STATE, HS_ERROR_UNSTABLE, HS_ERROR_TOO_FAST, HS_ERROR_INVERTED},
            "find_strength_factor"))
      steps_ = max_steps;
    demand(saved_between_steps(world()) == before, "a search for strength changes nothing");
    if (fallen) check_motion(fallen);
  }
};

}  // namespace halfspace_fuzz
