#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <halfspace/halfspace.h>

#include <cstdint>
#include <map>
#include <memory>

#include "polygon.h"

namespace halfspace::box2d {

/// What a block is made of: its own density and friction.
struct Material {
  double density;
  float friction;
  auto operator<=>(const Material&) const = default;
};

/// May the fixture be a block?
bool takes_part(const b2Fixture& fixture);

/// How the fixtures of a body move as blocks.
std::int32_t kind_of(const b2Body& body);

/// Of the fixture's own density, so that bodies of one density share a material. Where the host has given the
/// body another mass, of what makes the block as heavy as its share of it. What no force moves has any
/// density.
Material material_of(const b2Fixture& fixture, const Polygon& polygon);

/// A world of the library whose blocks are polygon fixtures.
class BlockWorld {
 public:
  /// `law` is that of all pairs but for the friction angle. The context must outlive the world. All
  /// functions throw std::bad_alloc, and std::invalid_argument with the library's reason when it refuses.
  BlockWorld(hs_context& context, const hs_law_def& law, const b2Vec2& gravity);

  /// `def` holds all but the material.
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
