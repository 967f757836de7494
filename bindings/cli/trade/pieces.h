#pragma once

#include <cstddef>
#include <vector>

#include "layout.h"
#include "model.h"

namespace halfspace::cli {

/// The common centroid of blocks. Those that are not there count for nothing; a fixed one, which has no mass,
/// is where it is.
class Centroid {
 public:
  void add(const BlockFrame& block);
  Point value() const;

 private:
  Point sum_{}, fixed_{};
  double mass_ = 0;
};

/// A block by itself, or all cells of a body: the blocks of a layout from first to before last.
struct Piece {
  std::size_t first, last;
};

/// All pieces, in the order of the layout. A scene has as many whatever its blocks are: rigid or cut into
/// cells.
std::vector<Piece> pieces_of(const Layout& layout);

/// The part of a piece that is there and moves freely: false when that is none of it.
bool is_free(const Piece& piece, const Frame& frame);
/// Its centroid, and the distance of its outermost corner from there.
Point centroid_of(const Piece& piece, const Frame& frame);
double size_of(const Piece& piece, const Frame& frame);

/// How far a piece is from where another frame has it: its corner that is farthest off, or, where it is cut
/// otherwise there, the farther of the ends of the box around it.
double distance(const Piece& piece, const Frame& frame, const Piece& other, const Frame& other_frame);

}  // namespace halfspace::cli
