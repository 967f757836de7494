#pragma once

#include <optional>
#include <span>

#include "geometry/outline.h"
#include "geometry/vector.h"

namespace halfspace {

/// A place at which a field over a face is integrated, from a's centroid, and its share of the area.
template <int D>
struct FacePoint {
  Vector<D> place;
  double area;
};

/// The part that two blocks' faces have in common, in the plane two edges: they lie in one plane and look at
/// each other.
template <int D>
struct CommonFace {
  Vector<D> normal;  // from a to b
  Array<FacePoint<D>> points;
};

/// Finds the largest common face of two blocks, as they are now, or none. Planes within `reach` of each other
/// are one, and parallel to that over the faces' size. In the plane there are three points, both ends and the
/// middle; in space corners, middles of sides and centroids of the triangles that the common polygon is cut
/// into. Linear fields are integrated exactly, and so are their squares; and a face is open when all of its
/// points are.
template <int D>
std::optional<CommonFace<D>> common_face(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b,
                                         double reach, Memory* memory);

extern template std::optional<CommonFace<2>> common_face(const Outline<2>&, const Outline<2>&,
                                                         const Vector<2>&, double, Memory*);
extern template std::optional<CommonFace<3>> common_face(const Outline<3>&, const Outline<3>&,
                                                         const Vector<3>&, double, Memory*);

}  // namespace halfspace
