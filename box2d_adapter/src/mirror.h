#pragma once

#include <halfspace/box2d_force.hpp>
#include <memory>
#include <unordered_map>
#include <vector>

#include "block_world.h"
#include "exact_motion.h"
#include "installation.h"

namespace halfspace::box2d {

/// Mirrors the polygon fixtures of a Box2D world as blocks of a world of the library, which computes their
/// contacts and forces. Box2D moves the bodies.
class ForceMode::Mirror {
 public:
  Mirror(NarrowPhase::Installation& narrow_phase, const hs_law_def& law);

  /// Detects what the host has created, changed, moved or destroyed.
  void follow();
  /// Computes contacts and forces at the current poses of the bodies.
  void evaluate();
  /// Applies the forces to the bodies for a sub-step.
  void push(float sub_step);
  /// Updates the motion after Box2D has moved the bodies.
  void carry_on(float sub_step);

  bool is_awake() const;
  double stable_sub_step() const;
  const hs_world* world() const { return world_.get(); }
  NarrowPhase::Installation& narrow_phase() const { return narrow_phase_; }
  hs_block block_of(const b2Fixture& fixture) const;

 private:
  /// The source of a block: if it changes, a new block replaces the block. A polygon of the host is not
  /// owned: it may be destroyed with its fixture, and another one may have the same address.
  struct Known {
    Known(b2Fixture& of, const std::shared_ptr<const Polygon>& taken_for);

    bool is_of_same_polygon(const Known& other) const { return polygon.lock() == other.polygon.lock(); }
    bool is_same(const Known& other) const {
      return is_of_same_polygon(other) && material == other.material && kind == other.kind;
    }

    b2Fixture* fixture;
    std::weak_ptr<const Polygon> polygon;
    std::shared_ptr<const Polygon> held;
    Vector centroid;
    Material material;
    std::int32_t kind;
    hs_block block = 0;
    bool is_there = true;
  };

  struct Body {
    b2Body* body;
    ExactMotion motion;
    Turn turn;
    Vector force;
    double torque = 0;  // about the center of mass
  };

  struct Block {
    b2Fixture* fixture;
    std::size_t body;
    Vector arm;  // from the body's center of mass to the centroid, in body coordinates
  };

  /// The force of a shear spring on block b.
  struct KeptShear {
    hs_block a, b;
    double force[3];
  };

  /// In the layout of the library's views.
  struct Motion {
    double velocity[3];
    double spin[3];
  };

  void find(b2Body& body);
  void find(b2Fixture& fixture);
  void add(const Polygon& polygon, Known known);
  void renew(Known& before, const Polygon& polygon, Known now);
  void keep_shear_of_renewed();
  void remove_what_is_gone();
  void list_blocks();
  bool are_all_somewhere() const;
  void place();
  void give_back_kept_shear();
  void find_forces(double elapsed);
  bool begin_shear_of_new_pairs();
  void begin_shear(const hs_contact& contact);
  const Block& block(hs_block id) const { return blocks_[index_of_block_.at(id)]; }
  JudgedPair* pair_of(const hs_contact& contact) const;
  void load(const hs_contact& contact);
  void load(const Block& block, const hs_contact& contact, double sign);

  NarrowPhase::Installation& narrow_phase_;
  Context context_;
  BlockWorld world_;
  std::unordered_map<const b2Fixture*, Known> known_;
  std::unordered_map<hs_block, hs_block> renewed_;  // in this follow(): old block to new block
  std::vector<KeptShear> kept_shear_;
  std::int64_t pairs_begun_ = 0;  // at the last evaluation
  double elapsed_ = 0;            // time over which shear springs extend, s

  std::vector<Body> bodies_;
  std::unordered_map<const b2Body*, std::size_t> index_of_body_;
  // In the order of the library's arrays.
  std::vector<hs_block> ids_;
  std::vector<Block> blocks_;
  std::unordered_map<hs_block, std::size_t> index_of_block_;
  std::vector<hs_pose> poses_;
  std::vector<Motion> motions_;
  std::vector<hs_contact> contacts_;
};

}  // namespace halfspace::box2d
