#pragma once

#include <array>
#include <optional>
#include <span>

#include "force/cell_division.h"
#include "force/division_plan.h"
#include "force/placed_block.h"

namespace halfspace {

/// Makes a plan of how two blocks' intersection has been divided, from where its corners and those of the
/// cells are: every solid is the convex one that has those corners which lie in its faces.
class DivisionPlanner {
 public:
  explicit DivisionPlanner(Memory* memory)
      : corners_(memory),
        near_{Array<NearFace>(memory), Array<NearFace>(memory)},
        facets_(memory),
        plan_(memory) {}

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
  using Set = std::uint64_t;  // of faces or corners
  enum Kind { vertex_of_a, vertex_of_b, shared, of_cells_of_a, of_cells_of_b, none };
  using FacePair = std::array<PlanCode, 2>;

  struct Corner {
    Vector<3> at;
    Kind kind;
    std::int32_t vertex;
    Set on[2];  // faces of a, of b
    Set nearest[2];
    std::array<FacePair, 3> faces;  // which tell where it is
  };
  struct Facet {
    Vector<3> outward;
    Set corners;
    std::array<std::uint8_t, most_plan_corners> around;  // counter-clockwise seen from outside
  };

  static Kind of_cells(int owner) { return owner == 0 ? of_cells_of_a : of_cells_of_b; }
  static bool is_shared(const Corner& corner) { return corner.kind <= shared; }
  static bool is_of_cells(int owner, const Corner& corner) {
    return is_shared(corner) || corner.kind == of_cells(owner);
  }

  bool is_known(const Corner& corner, std::size_t before) const;
  void add_corner(const Vector<3>& at, Kind kind);
  void measure_size();
  void find_faces(Corner& corner) const;
  bool is_vertex_of(int owner, Corner& corner) const;
  bool locate(Corner& corner) const;
  bool locate_by_faces(Corner& corner) const;
  bool is_told_by_faces_of_other(const Corner& corner) const;
  bool sort_corners();

  int count(Kind kind) const;
  void put(std::initializer_list<int> codes);
  void put_shared_corners();
  bool put_cells(int owner);
  template <class FacesOf>
  void put_faces_of_corners(Set corners, FacesOf faces_of);
  bool put_solid(double expected);
  void go_around(Facet& facet) const;
  bool is_closed() const;
  void put_fan(const Facet& facet, int top, double& volume);
  template <class Has>
  Set corners_with(Has has) const;
  void find_facets(Set corners);
  void add_facet(Set corners, const Vector<3>& outward);

  const CuttingPlane& plane(int owner, int face) const { return near_[owner][std::size_t(face)].plane; }
  const Corner& corner(int c) const { return corners_[std::size_t(c)]; }
  int near_count(int owner) const { return int(near_[owner].size()); }

  Array<Corner> corners_;
  Array<NearFace> near_[2];
  Array<Facet> facets_;
  Array<PlanCode> plan_;
  std::optional<PlacedBlock> block_[2];
  bool is_too_large_ = false;
  double volume_ = 0;
  double size_ = 0;
};

}  // namespace halfspace
