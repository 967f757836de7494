#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/contact_plane.h"

namespace halfspace {

/// The common part of two faces, seen along the normal of a plane. Its area, centroid and lowest value are
/// those of the whole, also when it has more corners than are kept.
struct FaceOverlap {
  double area = 0;
  Vector<2> centroid{0, 0};
  double lowest = 0;  // of a linear function of the points, over all corners
  int count = 0;      // of the corners kept, counter-clockwise
  Vector<2> corner[max_region_points];
};

/// Overlap of two faces, which may have any number of corners; `slope` is that of the linear function. Up to
/// rounding, an overlap without area has none. All corners are kept when they are not more than
/// max_region_points and neither face has more than 32 corners; else those that lie farthest in that many
/// directions spread evenly round the plane, so that the corners kept span all but slivers at the others.
FaceOverlap overlap_of(const FlatFace& one, const FlatFace& other, const Vector<2>& slope, double rounding);

/// The part of a segment over a face, as shares of its length; from >= to when there is none.
struct SegmentPart {
  double from = 0;
  double to = 1;
};
SegmentPart part_over(const FlatFace& face, const Vector<2>& start, const Vector<2>& end, double rounding);

}  // namespace halfspace
