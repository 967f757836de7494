#pragma once

#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "block_world.h"
#include "exact_motion.h"
#include "installation.h"

namespace halfspace::box2d {

/// A disabled body, or one with non-finite motion, takes no forces, as its pairs have no manifold.
bool is_somewhere(const b2Body& body);

/// Mirrors polygon fixtures of a Box2D world as blocks of a world of the library, which computes their
/// contacts. Box2D moves the bodies.
class Mirror {
 public:
  virtual ~Mirror() = default;
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;

  /// Detects what the host has created, changed, moved or destroyed.
  void follow();

  const hs_world* world() const { return world_.get(); }
  NarrowPhase::Installation& narrow_phase() const { return narrow_phase_; }
  hs_block block_of(const b2Fixture& fixture) const;

 protected:
  struct Body {
    explicit Body(b2Body& of) : body(&of), motion(of) {}

    b2Body* body;
    ExactMotion motion;
    Turn turn = {};
    Rates change = {};                       // by the library: in force mode force and torque
    std::array<Rates, 2> disturbances = {};  // with impulses: by others than the library, in the last steps
  };

  struct Block {
    b2Fixture* fixture;
    std::size_t body;
    Vector arm;  // from the body's center of mass to the centroid, in body coordinates
  };

  /// In the layout of the library's views.
  struct Motion {
    double velocity[3];
    double spin[3];
  };

  Mirror(NarrowPhase::Installation& narrow_phase, const hs_law_def& law, const hs_world_def& def)
      : narrow_phase_(narrow_phase), context_(make_context()), world_(*context_, law, def) {}

  /// The material of a fixture's block; nothing if the fixture is not mirrored.
  virtual std::optional<Material> material_for(const b2Fixture& fixture, const Polygon& polygon) const = 0;

  /// Sets poses and velocities of all blocks to those of the bodies.
  void place();
  std::int64_t block_count() const { return std::int64_t(blocks_.size()); }
  bool are_all_somewhere() const;
  const Block& block(hs_block id) const { return blocks_[index_of_block_.at(id)]; }
  /// Views of `motions_`.
  template <class View>
  View view_of(double (Motion::*member)[3]) {
    double* first = motions_[0].*member;
    return {first, first + 1, first + 2, sizeof(Motion), block_count()};
  }

  NarrowPhase::Installation& narrow_phase_;
  Context context_;
  BlockWorld world_;
  std::unordered_map<hs_block, hs_block> renewed_;  // in this follow(): old block to new block

  std::vector<Body> bodies_;
  // In the order of the library's arrays.
  std::vector<hs_block> ids_;
  std::vector<Block> blocks_;
  std::vector<hs_pose> poses_;
  std::vector<Motion> motions_;

 private:
  /// The source of a block: if it changes, a new block replaces the block. A polygon of the host is not
  /// owned: it may be destroyed with its fixture, and another one may have the same address.
  struct Known {
    Known(b2Fixture& of, const std::shared_ptr<const Polygon>& taken_for, const Material& material);

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

  void find(b2Body& body);
  void find(b2Fixture& fixture);
  void add(const Polygon& polygon, Known known);
  void renew(Known& before, const Polygon& polygon, Known now);
  void remove_what_is_gone();
  void list_blocks();

  std::unordered_map<const b2Fixture*, Known> known_;
  std::unordered_map<const b2Body*, std::size_t> index_of_body_;
  std::unordered_map<hs_block, std::size_t> index_of_block_;
};

}  // namespace halfspace::box2d
