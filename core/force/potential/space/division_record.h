#pragma once

#include <optional>

#include "force/potential/space/near_face.h"
#include "force/potential/space/placed_block.h"
#include "geometry/polyhedron/division.h"

namespace halfspace {

/// Some of a block's near faces.
using FaceSet = std::uint64_t;
constexpr std::size_t max_near_faces = 64;
inline FaceSet face_set(std::size_t face) { return FaceSet(1) << face; }

/// A corner of what two blocks have in common, or of cells: a vertex of a block, or where planes meet. A
/// vertex lies on all near faces that meet there.
struct DivisionCorner {
  FaceSet on[2] = {};       // of a, of b
  FaceSet nearest[2] = {};  // as many as have it in their cells
  bool is_shared = false;   // by the blocks: it is a corner of what they have in common
  int block = -1;           // whose vertex it is
  std::int32_t vertex = -1;
  Vector<3> at;
};

/// Writes down the corners of two blocks' intersection and of its cells while it is cut out and divided: the
/// cutter knows on which faces each of them lies.
class DivisionRecord {
 public:
  using Index = DividedPolyhedron::Index;

  explicit DivisionRecord(Memory* memory)
      : near_{Array<NearFace>(memory), Array<NearFace>(memory)},
        place_{Array<std::uint8_t>(memory), Array<std::uint8_t>(memory)},
        meet_{Array<FaceSet>(memory), Array<FaceSet>(memory)},
        corners_(memory) {}

  void reserve(std::size_t edges);

  /// Two blocks, which of them is cut, and the near faces of each. Their outlines are read until the next
  /// ones begin.
  void begin(const PlacedBlock& a, const PlacedBlock& b, int whole, const Array<NearFace>& near_a,
             const Array<NearFace>& near_b);
  /// The record of the common part of the blocks.
  void add_corners(const DividedPolyhedron& intersection, DividedPolyhedron::Part vertices);
  /// From here on it is divided by the near faces of this block.
  void divide_by(int owner) { owner_ = owner; }
  /// Where a plane between two of them has just crossed edges.
  void add_crossings(const DividedPolyhedron& parts);

  /// False when there was too much to write down.
  bool is_complete() const { return is_complete_; }
  const PlacedBlock& block(int owner) const { return *block_[owner]; }
  const Array<NearFace>& near(int owner) const { return near_[owner]; }
  const Array<DivisionCorner>& corners() const { return corners_; }

 private:
  void lay_on(Index plane, DivisionCorner& corner) const;
  void find_nearest(int owner, DivisionCorner& corner) const;
  bool is_corner(DivisionCorner& corner) const;
  bool make_vertex(int block, DivisionCorner& corner) const;
  void add(DivisionCorner& corner);

  std::optional<PlacedBlock> block_[2];
  Array<NearFace> near_[2];
  Array<std::uint8_t> place_[2];  // among these, of each face of the block
  Array<FaceSet> meet_[2];        // at each vertex of the block
  Array<DivisionCorner> corners_;
  int whole_ = 0;
  int owner_ = 0;
  double rounding_ = 0;  // of depths
  bool is_complete_ = false;
};

}  // namespace halfspace
