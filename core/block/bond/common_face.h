#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

template <int D>
class Blocks;

/// An integration point of a face, relative to a's centroid, with its part of the area.
template <int D>
struct FacePoint {
  Vector<D> place;
  double area;
};

/// The overlap of two blocks' faces in one plane, in 2D of their edges. Summed over all pairs of faces, so
/// that a face may be divided.
template <int D>
struct CommonFace {
  Vector<D> normal;  // from a to b, of the pair with the largest area
  Array<FacePoint<D>> points;
};

/// Computes the common face of two blocks at their present poses, if any. Planes coincide within 1e-6 of the
/// smaller block's radius, and are parallel to that tolerance over the size of the faces: faces cut by a
/// joint are in one plane only to rounding. The points are both ends and the middle in 2D; in 3D corners,
/// midpoints of sides and centroids of the triangles of the overlap. Squares of linear fields are integrated
/// exactly, and a face is open when all of its points are.
template <int D>
std::optional<CommonFace<D>> common_face(const Blocks<D>& blocks, std::int32_t a, std::int32_t b,
                                         Memory* memory);

extern template std::optional<CommonFace<2>> common_face(const Blocks<2>&, std::int32_t, std::int32_t,
                                                         Memory*);
extern template std::optional<CommonFace<3>> common_face(const Blocks<3>&, std::int32_t, std::int32_t,
                                                         Memory*);

}  // namespace halfspace
