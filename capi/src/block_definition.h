#pragma once

#include "halfspace/world.h"
#include "pose_and_vector.h"
#include "shape_handle.h"
#include "sized_struct.h"
#include "world_handle.h"

namespace halfspace::capi {

template <>
hs_block_def default_definition();

/// The start of a block, validated but for its mass.
template <int D>
struct BlockStart {
  BlockKind kind;
  std::int32_t material;
  Pose<D> pose;
  Vector<D> velocity;
  Angular<D> spin;
};

/// `last_kind`: the kinds up to it are allowed, as `kinds` says.
template <int D>
BlockStart<D> read_block(const World<D>& world, const hs_block_def* def, double radius,
                         std::int32_t last_kind, const char* kinds) {
  const hs_block_def known = read_definition(def, "def");
  if (known.kind < HS_BLOCK_FIXED || known.kind > last_kind)
    refuse(HS_ERROR_ARGUMENT, "def.kind is %d; it must be %s", known.kind, kinds);
  require_material(world, known.material, "def.material");
  const BlockStart<D> start{BlockKind(known.kind), known.material,
                            read_place<D>(&known.pose, radius, "def.pose"),
                            read_finite_vector<D>(known.velocity, "def.velocity"),
                            read_finite_angular<D>(known.angular_velocity, "def.angular_velocity")};
  if (start.kind == BlockKind::fixed &&
      (start.velocity != Vector<D>::Zero() || start.spin != Angular<D>::Zero())) {
    refuse(HS_ERROR_ARGUMENT,
           "def.velocity is %s, def.angular_velocity is (%g, %g, %g); both must be 0 for a fixed block",
           PointText(start.velocity).characters, known.angular_velocity[0], known.angular_velocity[1],
           known.angular_velocity[2]);
  }
  if (known.reserved != 0) refuse(HS_ERROR_ARGUMENT, "def.reserved is %d; it must be 0", known.reserved);
  return start;
}

/// Returns the shape for a block in a world of D dimensions; refuses the other dimension.
template <int D>
const Shape<D>& require_shape(const hs_shape* shape, const ArgumentName& name) {
  require_pointer(shape, name);
  if (shape->dimension() != D) {
    refuse(HS_ERROR_ARGUMENT, "%s has dimension %d; the world has %d", NameText(name).characters,
           shape->dimension(), D);
  }
  return as<D>(*shape);
}

/// `name`: of the shape.
template <int D>
void require_mass(double mass, const Inertia<D>& inertia, const ArgumentName& name) {
  if (is_within_bounds(mass, inertia)) return;
  refuse(HS_ERROR_ARGUMENT,
         "%s and def.material give a mass of %g and a moment of inertia of %g; the mass must be from %g to "
         "%g, the moment of inertia at most %g",
         NameText(name).characters, mass, inertia.min_moment(), min_mass, largest_mass, largest_inertia);
}

}  // namespace halfspace::capi
