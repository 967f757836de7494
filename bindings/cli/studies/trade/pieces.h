#pragma once

#include <cstddef>
#include <vector>

#include "model/layout.h"
#include "model/model.h"

namespace halfspace::cli {

/// The common centroid of blocks. Excavated blocks are ignored; a fixed block, which has no mass, gives its
/// own position.
class Centroid {
 public:
  void add(const BlockFrame& block);
  Point value() const;

 private:
  Point sum_{}, fixed_{};
  double mass_ = 0;
};

/// A single block, or all cells of a body: the blocks [first, last) of a layout.
struct Piece {
  std::size_t first, last;
};

/// All pieces, in the order of the layout. Their number does not depend on the kind of blocks: rigid, or cut
/// into cells.
std::vector<Piece> pieces_of(const Layout& layout);

/// True if some of a piece is there and moves freely.
bool is_free(const Piece& piece, const Frame& frame);
/// The centroid of that part, and the distance of its farthest vertex from there.
Point centroid_of(const Piece& piece, const Frame& frame);
double size_of(const Piece& piece, const Frame& frame);

/// The largest displacement of a vertex of a piece between two frames; if the piece is cut differently, of
/// the corners of its bounding box.
double distance(const Piece& piece, const Frame& frame, const Piece& other, const Frame& other_frame);

}  // namespace halfspace::cli
