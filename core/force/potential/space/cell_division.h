#pragma once

#include <array>

#include "force/potential/space/division_record.h"
#include "force/potential/space/near_face.h"
#include "geometry/polyhedron/division.h"

namespace halfspace {

/// Divides a polyhedron into the cells of its nearest faces. Two faces divide a part, each where it is nearer
/// than the other; a third face gets a cell only where it is nearer than the owner of the part. So each point
/// belongs to exactly one face, for any rounding of the planes between faces, and it is the nearest to
/// rounding.
class CellDivision {
 public:
  using Index = DividedPolyhedron::Index;

  explicit CellDivision(Memory* memory) : parts_(memory), lists_(memory), waiting_(memory), depth_(memory) {}

  /// For blocks of up to `edges` edges; grows with more than `vertices` vertices or `near` near faces.
  void reserve(std::size_t edges, std::size_t vertices, std::size_t near);

  /// Computes the cells of a part of a polyhedron. `largest_coordinate`, or an upper bound of it, sets the
  /// rounding error of its vertices. New faces are numbered from `first_new_face` on. `record`, if given,
  /// receives the crossings of planes between near faces with edges.
  void divide(const DividedPolyhedron& polyhedron, DividedPolyhedron::Part whole,
              const VolumeAndMoment& content, double largest_coordinate, Index first_new_face,
              Array<NearFace>& near, DivisionRecord* record);

 private:
  /// A part has its near faces and vertices in the lists from `first` on. Each point of its content has one
  /// of these faces as its nearest. Cells assigned to other faces before are still within its vertices, but
  /// not in its content; there none of its faces is nearer than the first one.
  struct Part {
    std::size_t first;
    std::size_t near_count;
    std::size_t vertex_count;
    VolumeAndMoment content;
    Index vertices_of_all;  // when it was queued: later vertices belong to other parts
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
  double rounding_ = 0;  // error of a difference of depths
};

}  // namespace halfspace
