#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "force/potential/space/placed_block.h"
#include "geometry/polyhedron/clipped.h"

namespace halfspace {

/// The faces of a block that are the nearest to some point of its overlap with another block.
class NearFaces {
 public:
  explicit NearFaces(Memory* memory) : corners_(memory), depths_(memory), faces_(memory), rivals_(memory) {}

  /// For a block of up to `faces` faces. Grows later where more than 32 of them are near, or the overlap has
  /// more than `vertices` vertices.
  void reserve(std::size_t faces, std::size_t vertices);
  /// Takes the vertices of the overlap.
  void begin(const ClippedPolyhedron& overlap);
  /// Finds the near faces of one of its blocks. `min_depth`: lower bounds of the depth of the overlap
  /// behind each face; `reach`: an upper bound of the depth in the block.
  void find(const PlacedBlock& owner, const double* min_depth, double reach);

  std::size_t count() const { return faces_.size(); }
  /// The first is the face that most of the overlap is near to.
  const Halfspace<3>& operator[](std::size_t k) const { return faces_[k].plane; }
  /// The others than one that is not the first, in the order in which they cut most of its cell: the first,
  /// then those of the nearest directions.
  std::span<const std::uint32_t> rivals_of(std::size_t k);

 private:
  struct Face {
    Halfspace<3> plane;
    DepthRange depths;  // of the vertices
    std::size_t row;    // of their depths
  };

  const double* depths_of(const Face& face) const { return depths_.data() + face.row * stride_; }
  bool is_nowhere_nearer(const Face& face, const Face& than) const;

  Array<double> corners_;  // of the overlap: all x, all y, all z
  Array<double> depths_;   // of the corners, a row for each face
  Array<Face> faces_;
  Array<std::uint32_t> rivals_;
  std::size_t stride_ = 0;  // the number of corners, rounded up to an even one
};

}  // namespace halfspace
