#pragma once

#include <array>
#include <optional>
#include <span>

#include "force/potential/space/cell_division.h"
#include "force/potential/space/placed_block.h"
#include "force/potential/space/plan_writer.h"
#include "force/potential/space/planes_of_corner.h"
#include "force/potential/space/planned_solid.h"

namespace halfspace {

/// Makes a plan of how two blocks' intersection has been divided, from where its corners and those of the
/// cells are: every solid is the convex one that has those corners which lie in its faces.
class DivisionPlanner {
 public:
  explicit DivisionPlanner(Memory* memory)
      : corners_(memory),
        near_{Array<NearFace>(memory), Array<NearFace>(memory)},
        between_(memory),
        places_(memory),
        on_{Array<CornerSet>(memory), Array<CornerSet>(memory)},
        nearest_{Array<CornerSet>(memory), Array<CornerSet>(memory)},
        solid_(memory),
        writer_(memory) {}

  /// Room for all plans: what would need more is not planned.
  void reserve();

  /// First the corners of what the blocks have in common, then the cells of a, then of b, all seen from where
  /// these are placed. Their outlines are read until the plan is made.
  void begin(const PlacedBlock& a, const PlacedBlock& b, const VolumeAndMoment& content);
  void add_corner(const Vector<3>& at) { add_corner(at, shared); }
  /// With how deep, by its bounds, what they have in common is behind each face of the owner, or less; and
  /// places among which are all corners that only cells have.
  void add_cells(int owner, const Array<NearFace>& near, const Array<double>& least_depth,
                 const Array<Vector<3>>& places);
  /// Empty when what has been found out does not fit together, as where much lies in one place to rounding.
  /// Stays until the next one is begun.
  std::span<const PlanCode> make();

 private:
  using FaceSet = std::uint64_t;
  /// In the order in which corners are numbered; places that turn out to be none come last.
  enum Kind { vertex_of_a, vertex_of_b, shared, of_cells_of_a, of_cells_of_b, none };

  struct FacesOfCorner {
    FaceSet on[2];  // of a, of b
    FaceSet nearest[2];

    bool operator==(const FacesOfCorner&) const = default;
  };
  struct Corner {
    Vector<3> at;
    Kind kind;
    std::int32_t arrival;
    std::int32_t vertex;
    FacesOfCorner faces;
    std::array<FacePair, 3> told_by;
  };

  static Kind of_cells(int owner) { return owner == 0 ? of_cells_of_a : of_cells_of_b; }
  static bool is_shared(const Corner& corner) { return corner.kind <= shared; }
  static bool is_of_cells(int owner, const Corner& corner) {
    return is_shared(corner) || corner.kind == of_cells(owner);
  }

  bool is_known(const Corner& corner, std::size_t before) const;
  void add_corner(const Vector<3>& at, Kind kind);
  void find_rounding();
  bool find_corners();
  bool find_corner(Corner& corner) const;
  FacesOfCorner faces_at(const Vector<3>& at) const;
  bool locate(Corner& corner) const;
  bool is_vertex_of(int owner, Corner& corner) const;
  bool locate_by_faces(Corner& corner) const;
  bool sort_corners();
  void list_corners_of_faces();

  void put_faces();
  void put_planes_between();
  int number_of_plane(const FacePair& faces) const;
  void put_corners();
  bool put_whole();
  bool put_cells(int owner);
  void put_depths(int owner);
  void begin_solid(const CornerSet& corners);

  const CuttingPlane& plane(int owner, int face) const { return near_[owner][std::size_t(face)].plane; }
  const CornerSet& on(int owner, int face) const { return on_[owner][std::size_t(face)]; }
  const CornerSet& nearest(int owner, int face) const { return nearest_[owner][std::size_t(face)]; }
  int near_count(int owner) const { return int(near_[owner].size()); }
  int all_near() const { return near_count(0) + near_count(1); }

  Array<Corner> corners_;
  Array<NearFace> near_[2];
  int cell_count_[2] = {};  // of the first ones of these
  Array<FacePair> between_;
  Array<Vector<3>> places_;  // of the corners
  CornerSet shared_;
  CornerSet of_cells_[2];
  Array<CornerSet> on_[2];  // which corners are on a face, or nearest to it
  Array<CornerSet> nearest_[2];
  PlannedSolid solid_;
  PlanWriter writer_;
  std::optional<PlacedBlock> block_[2];
  bool is_too_large_ = false;
  double volume_ = 0;
  double reach_ = 0;     // within which corners are one
  double margin_ = 0;    // to faces that do not matter
  double rounding_ = 0;  // of depths
};

}  // namespace halfspace
