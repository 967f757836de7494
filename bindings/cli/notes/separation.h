#pragma once

#include <cstddef>
#include <vector>

#include "notes/start.h"
#include "vector.h"

namespace halfspace::cli {

/// Scenes of more blocks get no notes that look at all pairs of neighbours: these would take longer than the
/// rest.
constexpr std::size_t most_compared_blocks = 200'000;

/// A block as a convex body in space, where it is at the start.
struct ConvexBody {
  std::vector<Point> vertices;
  std::vector<Point> normals;  ///< unit length, of its faces
  Point low{}, high{};         ///< corners of its box
};

/// Of each block of the layout.
std::vector<ConvexBody> convex_bodies(const Start& start);

/// The largest distance along the axes and the normals of both bodies' faces, below 0 where they overlap.
/// Bodies apart are at least so far apart.
double separation(const ConvexBody& a, const ConvexBody& b);

/// Two blocks, the first with the lower index, and how far apart they are.
struct Neighbours {
  std::size_t a, b;
  double separation;
};

/// All pairs of blocks that are no farther apart than this fraction of the thinner one's thickness.
std::vector<Neighbours> neighbours_within(const Start& start, const std::vector<ConvexBody>& bodies,
                                          double fraction);

}  // namespace halfspace::cli
