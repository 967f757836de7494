#pragma once

#include <cmath>

#include "world/contacts/contact_list.h"
#include "world/hard_contact/contact_constraint.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"

namespace halfspace {

/// The face of a simplex lies opposite to one of its nodes.
inline int node_opposite(const Outline<2>&, int face) { return (face + 2) % 3; }
inline int node_opposite(const Outline<3>& o, int face) {
  const std::int32_t* corner = o.topology->face_vertex + o.topology->first_of_face[face];
  return 6 - corner[0] - corner[1] - corner[2];
}

/// An edge at the surface of a mesh, between two faces.
struct SurfaceEdge {
  std::int32_t block = -1;  // whose edge it is: of those that share it, one
  std::array<std::int32_t, 2> node{};
  std::array<std::int32_t, 2> beside{};  // the third node of each face
};

/// One of the two.
struct SideOfEdge {
  std::array<std::int32_t, 2> node;
  std::int32_t block;
  std::int32_t beside;
};

/// An edge now and at the end of the predicted motion: see edge_edge_search.cpp.
struct MovingEdge;

/// A ball about an edge.
struct EdgeBound {
  bool is_near(const EdgeBound& other, double reach) const {
    const double most = radius + other.radius + reach;
    return (middle - other.middle).squaredNorm() <= most * most;
  }
  Vector<3> middle;
  double radius;
};

/// Looks for the places where blocks would pass through each other in the predicted motion: corners through
/// faces, and in space edges through edges.
template <int D>
class PointContactSearch {
 public:
  PointContactSearch(const Model<D>& model, const ContactList<D>& contacts, const Integrator<D>& integrator,
                     Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        contacts_(contacts),
        integrator_(integrator),
        outwards_(memory),
        owner_(memory),
        sides_(memory),
        edges_(memory),
        first_edge_(memory) {}

  /// Takes note of the surfaces of meshes, after the neighbour list has been made anew.
  void rebuild_surface();
  /// Finds all that come near each other in the predicted motion, in order of their keys, and places them.
  void find(Array<ContactConstraint<D>>& found);
  /// Sets points, normal, gap and mobilities to those of now.
  void place(ContactConstraint<D>& at) const;
  /// The gap at the end of the predicted motion.
  double predicted_gap(const ContactConstraint<D>& at) const;
  /// The area that a corner stands for on the face before it. Nodes of two meshes share it, and against any
  /// other block those of the mesh have it.
  double area_of(const ContactConstraint<D>& at) const;
  /// A corner nearer to a face than this is at it.
  double reach(std::size_t b) const;

 private:
  /// A block now, or at the end of the predicted motion.
  struct Pose {
    Pose(const Vector<D>& at, const Tensor<D>& turned_by);
    Vector<D> position;
    Tensor<D> gradient;
    Tensor<D> inverse;
  };
  Pose pose_now(std::size_t slot) const;
  Pose predicted_pose(std::size_t slot) const;
  Vector<D> node_now(std::size_t slot, std::int32_t node) const;
  Vector<D> corner_now(std::size_t slot, int corner) const;
  Vector<D> predicted_corner(std::size_t slot, int corner) const;
  Vector<D> outwards(std::size_t slot, int corner) const;
  bool owns_vertex(std::size_t slot, int corner) const;
  Vector<D> face_of(std::size_t slot, int corner) const;
  /// A block that corners may come into.
  struct Target {
    bool is_outer(const Outline<D>& own, int face) const {
      return outer_faces < 0 || (outer_faces >> node_opposite(own, face) & 1);
    }
    std::size_t slot;
    Pose now;
    Pose predicted;
    std::int32_t outer_faces;  // of a mesh; else all are
  };
  /// The face through which a corner comes in, or -1, and when: a share of the motion.
  struct Entrance {
    int face = -1;
    double time = -HUGE_VAL;
    double before = -HUGE_VAL;  // in front of the face at the start
    double after = -HUGE_VAL;   // and at the end
    bool looks_at_a = false;
  };
  Entrance entrance(const Target& b, std::size_t a, int corner) const;
  bool is_well_inside(const Target& b, const Vector<D>& end, int but_for) const;
  void compute_node_normals();
  void find_vertex_face(std::int32_t a, std::int32_t b, Array<ContactConstraint<D>>& found) const;
  void place_corner(ContactConstraint<D>& at) const;
  MaterialPoint<D> corner_of(std::int32_t block, int corner) const;

  // Edges, in space.
  MovingEdge edge(std::int32_t block, int which) const;
  EdgeBound bound_of_edge(std::int32_t block, int which) const;
  int edge_count(std::size_t slot) const;
  void rebuild_surface_edges() {}
  void find_edge_edge(std::int32_t, std::int32_t, Array<ContactConstraint<D>>&) const {}
  void place_edges(ContactConstraint<D>&) const {}
  double predicted_gap_of_edges(const ContactConstraint<D>&) const { return 0; }

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  const Integrator<D>& integrator_;
  Array<Vector<D>> outwards_;       // of each node: its part of the faces around it, area times normal
  Array<std::int32_t> owner_;       // of each node: the block whose corner it is
  Array<SideOfEdge> sides_;         // kept for the next survey, so that it takes no memory
  Array<SurfaceEdge> edges_;        // of meshes, in ascending order of blocks
  Array<std::int32_t> first_edge_;  // of each block, and one more
  double margin_ = 0;               // two that are farther apart at the end of the motion do not count
};

// Edges meet in space only.
template <>
int PointContactSearch<3>::edge_count(std::size_t slot) const;
template <>
EdgeBound PointContactSearch<3>::bound_of_edge(std::int32_t block, int which) const;
template <>
MovingEdge PointContactSearch<3>::edge(std::int32_t block, int which) const;
template <>
void PointContactSearch<3>::rebuild_surface_edges();
template <>
void PointContactSearch<3>::find_edge_edge(std::int32_t a, std::int32_t b,
                                           Array<ContactConstraint<3>>& found) const;
template <>
void PointContactSearch<3>::place_edges(ContactConstraint<3>& at) const;
template <>
double PointContactSearch<3>::predicted_gap_of_edges(const ContactConstraint<3>& at) const;

extern template class PointContactSearch<2>;
extern template class PointContactSearch<3>;

}  // namespace halfspace
