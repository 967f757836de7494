#pragma once

#include <array>

#include "force/potential/space/division_record.h"
#include "force/potential/space/near_face.h"
#include "geometry/polyhedron/division.h"

namespace halfspace {

/// Divides a polyhedron among the faces that its points are nearest to. Two faces have a part of it each,
/// where they are nearer than the other; of what they do not win against one there, a third one has nothing
/// in it. So each bit goes to exactly one face, however rounding places the planes between them, and it is no
/// worse than rounding when that is not quite the nearest.
class CellDivision {
 public:
  using Index = DividedPolyhedron::Index;

  explicit CellDivision(Memory* memory) : parts_(memory), lists_(memory), waiting_(memory), depth_(memory) {}

  /// For blocks of so many edges at most, until there are more than so many vertices or near faces.
  void reserve(std::size_t edges, std::size_t vertices, std::size_t near);

  /// Finds the cells in a part of a polyhedron. The largest coordinate of its vertices, or a little more,
  /// tells how they are rounded. New faces get numbers from the first one on; where planes between near faces
  /// cross edges is written down where there is a record.
  void divide(const DividedPolyhedron& polyhedron, DividedPolyhedron::Part whole,
              const VolumeAndMoment& content, double largest_coordinate, Index first_new_face,
              Array<NearFace>& near, DivisionRecord* record);

 private:
  /// A part has its near faces and vertices in the lists from `first` on. To each point of its content one of
  /// these faces is the nearest. What other faces have been given already is still within its vertices, but
  /// not in its content; there none of its faces is nearer than the first one.
  struct Part {
    std::size_t first;
    std::size_t near_count;
    std::size_t vertex_count;
    VolumeAndMoment content;
    Index vertices_of_all;  // when it was put aside: what has been added since is of others
  };

  void find_depths(const DividedPolyhedron& polyhedron, DividedPolyhedron::Part whole,
                   double largest_coordinate, Array<NearFace>& near);
  std::size_t list_near_faces(const Array<NearFace>& near);
  void divide_part(const Part& part, Array<NearFace>& near);
  std::size_t find_rivals(const Part& part);
  std::array<DepthRange, 2> find_leads(DividedPolyhedron::Part vertices, Index nearest, Index rival,
                                       Index other);
  void cut_edges(const Part& part);
  bool others_have_nothing_inside(std::span<const Index> faces);
  void interpolate_depths(Index first_new, std::span<const Index> faces);
  void put_aside(const Part& part, std::size_t near_count, const VolumeAndMoment& inside,
                 const VolumeAndMoment& outside);

  double* depths(Index vertex) { return depth_.data() + vertex * stride_; }

  DividedPolyhedron parts_;
  Array<Index> lists_;
  Array<Part> waiting_;
  Array<double> depth_;  // of each vertex behind each near face
  DivisionRecord* record_ = nullptr;
  std::size_t stride_ = 0;
  Index first_new_face_ = 0;
  double rounding_ = 0;  // of a difference of depths
};

}  // namespace halfspace
