#include "studies/trade/pieces.h"

#include <algorithm>
#include <cmath>

#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// Calls visit(block) for the blocks of a piece that are not excavated.
template <class Visit>
void for_each_block(const Piece& piece, const Frame& frame, Visit visit) {
  for (std::size_t i = piece.first; i < piece.last; ++i)
    if (!frame.blocks[i].vertices.empty()) visit(frame.blocks[i]);
}

std::vector<Point> corners_of(const Piece& piece, const Frame& frame) {
  std::vector<Point> corners;
  for_each_block(piece, frame, [&](const BlockFrame& block) {
    corners.insert(corners.end(), block.vertices.begin(), block.vertices.end());
  });
  return corners;
}

/// The lowest and the highest corner of the box around points.
std::vector<Point> ends_of(const std::vector<Point>& points) {
  std::vector<Point> ends(2, points[0]);
  for (const Point& p : points) {
    for (std::size_t axis = 0; axis < p.size(); ++axis) {
      ends[0][axis] = std::min(ends[0][axis], p[axis]);
      ends[1][axis] = std::max(ends[1][axis], p[axis]);
    }
  }
  return ends;
}

}  // namespace

void Centroid::add(const BlockFrame& block) {
  if (block.vertices.empty()) return;
  const Point position = point_of(block.state.pose.position);
  if (block.state.mass == 0) fixed_ = position;
  sum_ = plus(sum_, times(block.state.mass, position));
  mass_ += block.state.mass;
}

Point Centroid::value() const { return mass_ > 0 ? times(1 / mass_, sum_) : fixed_; }

std::vector<Piece> pieces_of(const Layout& layout) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < layout.blocks.size(); i = pieces.back().last) {
    const std::optional<std::size_t> body = layout.blocks[i].body;
    pieces.push_back({i, i + (body ? layout.bodies[*body].cell_nodes.size() : 1)});
  }
  return pieces;
}

bool is_free(const Piece& piece, const Frame& frame) {
  bool is_free = false;
  for_each_block(piece, frame, [&](const BlockFrame& block) { is_free |= moves_freely(block.state.kind); });
  return is_free;
}

Point centroid_of(const Piece& piece, const Frame& frame) {
  Centroid centroid;
  for_each_block(piece, frame, [&](const BlockFrame& block) { centroid.add(block); });
  return centroid.value();
}

double size_of(const Piece& piece, const Frame& frame) {
  const Point centroid = centroid_of(piece, frame);
  double size = 0;
  for (const Point& p : corners_of(piece, frame)) size = std::max(size, length(minus(p, centroid)));
  return size;
}

double distance(const Piece& piece, const Frame& frame, const Piece& other, const Frame& other_frame) {
  std::vector<Point> here = corners_of(piece, frame), there = corners_of(other, other_frame);
  if (there.empty()) return HUGE_VAL;
  if (here.size() != there.size()) {
    here = ends_of(here);
    there = ends_of(there);
  }
  double farthest = 0;
  for (std::size_t k = 0; k < here.size(); ++k)
    farthest = std::max(farthest, length(minus(there[k], here[k])));
  return farthest;
}

}  // namespace halfspace::cli
