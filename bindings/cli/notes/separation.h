#pragma once

#include <cstddef>
#include <vector>

#include "common/vector.h"
#include "notes/start.h"

namespace halfspace::cli {

/// Max number of blocks for notes that compare all pairs of neighbours, which cost more than all other notes.
constexpr std::size_t max_compared_blocks = 200'000;

/// A block as a convex body, at its initial position.
struct ConvexBody {
  std::vector<Point> vertices;
  std::vector<HalfSpace> faces;  ///< with normals of unit length, and all vertices behind them
  Point low{}, high{};           ///< corners of its box
};

/// The convex body of each block of the layout.
std::vector<ConvexBody> convex_bodies(const Start& start);

/// The largest separation along the axes and the face normals of both bodies, negative for an overlap: a
/// lower bound of their distance.
double separation(const ConvexBody& a, const ConvexBody& b);

/// Two blocks, the first with the lower index, and their separation, m.
struct Neighbours {
  std::size_t a, b;
  double separation;
};

/// All pairs of blocks whose separation is at most this fraction of the thinner one's thickness.
std::vector<Neighbours> neighbours_within(const Start& start, const std::vector<ConvexBody>& bodies,
                                          double fraction);

}  // namespace halfspace::cli
