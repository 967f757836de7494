#pragma once

#include <optional>

#include "force/potential/space/near_face.h"
#include "force/potential/space/placed_block.h"
#include "geometry/polyhedron/division.h"

namespace halfspace {

/// A set of a block's near faces.
using FaceSet = std::uint64_t;
constexpr std::size_t max_near_faces = 64;
inline FaceSet face_set(std::size_t face) { return FaceSet(1) << face; }

/// A corner of two blocks' overlap, or of cells: a vertex of a block, or an intersection of planes. A vertex
/// lies on all near faces that meet there.
struct DivisionCorner {
  FaceSet on[2] = {};       // of a, of b
  FaceSet nearest[2] = {};  // the faces with cells at the corner
  bool is_shared = false;   // by the blocks: it is a corner of their overlap
  int block = -1;           // owner of the vertex
  std::int32_t vertex = -1;
  Vector<3> at;
};

/// Records the corners of two blocks' intersection and of its cells while it is cut and divided: only the
/// cutter has the faces of each.
class DivisionRecord {
 public:
  using Index = DividedPolyhedron::Index;

  explicit DivisionRecord(Memory* memory)
      : near_{Array<NearFace>(memory), Array<NearFace>(memory)},
        place_{Array<std::uint8_t>(memory), Array<std::uint8_t>(memory)},
        meet_{Array<FaceSet>(memory), Array<FaceSet>(memory)},
        corners_(memory) {}

  void reserve(std::size_t edges);

  /// Sets the blocks, the index of the one that is cut, and the near faces of each. Their outlines must stay
  /// valid until the next call.
  void begin(const PlacedBlock& a, const PlacedBlock& b, int whole, const Array<NearFace>& near_a,
             const Array<NearFace>& near_b);
  /// Adds the corners of the overlap.
  void add_corners(const DividedPolyhedron& intersection, DividedPolyhedron::Part vertices);
  /// From here on the overlap is divided by the near faces of this block.
  void divide_by(int owner) { owner_ = owner; }
  /// Adds the crossings of a plane between two near faces with edges.
  void add_crossings(const DividedPolyhedron& parts);

  /// False when there were too many corners.
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
  Array<std::uint8_t> place_[2];  // index in near_ of each face of the block
  Array<FaceSet> meet_[2];        // faces at each vertex of the block
  Array<DivisionCorner> corners_;
  int whole_ = 0;
  int owner_ = 0;
  double rounding_ = 0;  // error of depths
  bool is_complete_ = false;
};

}  // namespace halfspace
