#pragma once

#include <span>

#include "block/inertia.h"
#include "geometry/pose.h"
#include "geometry/shape.h"
#include "geometry/vector.h"

namespace halfspace {

/// The mass, inertia and centroid of several shapes that form one rigid body.
template <int D>
struct CompoundBody {
  double mass = 0;
  Vector<D> centroid = Vector<D>::Zero();  // in the frame of the poses
  Inertia<D> inertia;                      // about the centroid
  double radius = 0;                       // of the bounding circle or sphere about the centroid
};

/// `poses`: of the shapes, in one frame. The shapes must not overlap.
template <int D>
CompoundBody<D> compound_body(std::span<const Shape<D>* const> shapes, std::span<const Pose<D>> poses,
                              double density);

extern template CompoundBody<2> compound_body(std::span<const Shape<2>* const>, std::span<const Pose<2>>,
                                              double);
extern template CompoundBody<3> compound_body(std::span<const Shape<3>* const>, std::span<const Pose<3>>,
                                              double);

}  // namespace halfspace
