#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/contact_plane.h"

namespace halfspace {

/// The overlap of two faces, projected along the normal of a plane. Area, centroid and lowest value are exact
/// also when it has more corners than are kept.
struct FaceOverlap {
  double area = 0;
  Vector<2> centroid{0, 0};
  double lowest = 0;  // minimum of a linear function over all corners
  int count = 0;      // number of corners kept, counter-clockwise
  Vector<2> corner[max_region_points];
};

/// Overlap of two faces with any number of corners; `slope` is that of the linear function. An overlap whose
/// area is 0 to rounding is empty. All corners are kept if there are at most max_region_points and neither
/// face has more than 32; else those farthest in that many evenly spread directions, which span all but
/// slivers of the overlap.
FaceOverlap overlap_of(const FlatFace& one, const FlatFace& other, const Vector<2>& slope, double rounding);

/// The part of a segment over a face, as fractions of its length; from >= to if there is none.
struct SegmentPart {
  double from = 0;
  double to = 1;
};
SegmentPart part_over(const FlatFace& face, const Vector<2>& start, const Vector<2>& end, double rounding);

}  // namespace halfspace
