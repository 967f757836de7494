#pragma once

#include "block/blocks.h"
#include "geometry/tolerances.h"
#include "narrow_phase/ray.h"

namespace halfspace {

/// The first block that a ray meets; slot -1 if there is none.
struct BlockHit {
  std::int32_t slot = -1;
  RayHit at;
};

/// Does a ray meet the sphere (2D: the circle) about the origin before a distance?
template <int D>
bool meets_sphere(const Ray<D>& ray, double radius, double distance) {
  const double along = -ray.origin.dot(ray.direction);
  const Vector<D> nearest = ray.origin + std::clamp(along, 0.0, distance) * ray.direction;
  // The radius is larger by rounding at this distance, as rays that touch a block hit it.
  const double reach = radius + place_rounding * ray.origin.norm();
  return nearest.squaredNorm() <= reach * reach;
}

/// Tests all blocks in their present deformation, first by their bounding spheres.
template <int D>
BlockHit first_block_on(const Ray<D>& ray, const Blocks<D>& blocks) {
  BlockHit first;
  first.at.distance = ray.length;
  for (std::size_t slot = 0; slot < blocks.slot_count(); ++slot) {
    if (!blocks.lives(slot)) continue;
    const Ray<D> seen{ray.origin - blocks.position[slot], ray.direction, ray.length};
    const double stretch = blocks.is_deformable(slot) ? blocks.deformation(slot).gradient.norm() : 1;
    if (!meets_sphere(seen, stretch * blocks.radius[slot], first.at.distance)) continue;
    if (!meets(seen, blocks.outline(std::int32_t(slot)), first.at)) continue;
    first.slot = std::int32_t(slot);
    if (first.at.distance == 0) break;
  }
  return first;
}

}  // namespace halfspace
