#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

template <int D>
class Blocks;

/// A place at which a field over a face is integrated, from a's centroid, and its share of the area.
template <int D>
struct FacePoint {
  Vector<D> place;
  double area;
};

/// The part that two blocks' faces have in common, in the plane their edges: they lie in one plane and face
/// each other. Where a face is split, it is the sum over all pairs.
template <int D>
struct CommonFace {
  Vector<D> normal;  // from a to b, of the pair with the largest area
  Array<FacePoint<D>> points;
};

/// Finds the common face of two blocks, as they are now, or none. Faces that a joint has cut apart
/// lie in one plane to rounding only: planes within 1e-6 of the smaller block's radius are one, and parallel
/// to that over the faces' size. In the plane there are three points, both ends and the middle; in space
/// corners, middles of sides and centroids of the triangles that the common polygon is cut into. Linear
/// fields are integrated exactly, and so are their squares; and a face is open when all of its points are.
template <int D>
std::optional<CommonFace<D>> common_face(const Blocks<D>& blocks, std::int32_t a, std::int32_t b,
                                         Memory* memory);

extern template std::optional<CommonFace<2>> common_face(const Blocks<2>&, std::int32_t, std::int32_t,
                                                         Memory*);
extern template std::optional<CommonFace<3>> common_face(const Blocks<3>&, std::int32_t, std::int32_t,
                                                         Memory*);

}  // namespace halfspace
