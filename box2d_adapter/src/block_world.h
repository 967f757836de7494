#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <halfspace/halfspace.h>

#include <cstdint>
#include <map>
#include <memory>

#include "polygon.h"

namespace halfspace::box2d {

/// Properties of a block.
struct Material {
  double density;
  float friction;
  float restitution = 0;
  auto operator<=>(const Material&) const = default;
};

/// Can the fixture be a block?
bool takes_part(const b2Fixture& fixture);

/// The kind of the blocks of a body, an HS_BLOCK_ value.
std::int32_t kind_of(const b2Body& body);

/// The material of a fixture, with its own density, so that bodies of one density have a common material. If
/// the host has set another mass of the body, the density gives the block its fraction of that mass. The
/// density of fixed and prescribed blocks is arbitrary. Restitution is left at 0.
Material material_of(const b2Fixture& fixture, const Polygon& polygon);

/// Throws std::runtime_error if the library has refused to initialize a definition of this size.
void require_current(hs_status status);

/// The default settings of a world in 2D.
hs_world_def make_world_def(const b2Vec2& gravity);

/// A world of the library whose blocks are polygon fixtures.
class BlockWorld {
 public:
  /// `law` is the law of all pairs, except for the friction angle, and for the restitution of materials that
  /// have one. The context must outlive the world. All functions throw std::bad_alloc, and
  /// std::invalid_argument with the library's error text.
  BlockWorld(hs_context& context, const hs_law_def& law, const hs_world_def& def);

  /// `def` has all members except the material.
  hs_block add(const Polygon& polygon, const Material& material, hs_block_def def);

  hs_world* get() const { return world_.get(); }
  void require_ok(hs_status status) const;

 private:
  struct DestroyWorld {
    void operator()(hs_world* world) const { hs_world_destroy(world); }
  };

  std::int32_t index_of(const Material& material);

  hs_context& context_;
  hs_law_def law_;
  std::unique_ptr<hs_world, DestroyWorld> world_;
  std::map<Material, std::int32_t> materials_;
};

}  // namespace halfspace::box2d
