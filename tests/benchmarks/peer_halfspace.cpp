#include <memory_resource>
#include <stdexcept>

#include "benchmarks/peer_of.h"
#include "detect/separation_3d.h"
#include "geometry/polyhedron_hull.h"
#include "geometry/shape.h"

namespace halfspace_benchmark {
namespace {

using halfspace::Rotation;
using halfspace::Shape;
using halfspace::Vector;

/// A shape, and where its centroid is seen from what a pose puts at its position.
struct Block {
  explicit Block(const Polyhedron& polyhedron)
      : shape(hull_of(polyhedron), std::pmr::get_default_resource()),
        centroid(shape.centroid() - centre_of(polyhedron)) {}

  static Vector<3> centre_of(const Polyhedron& p) { return {p.centre.x, p.centre.y, p.centre.z}; }

  static halfspace::Polyhedron hull_of(const Polyhedron& polyhedron) {
    std::vector<Vector<3>> points;
    for (const auto& p : polyhedron.vertices) points.push_back({p.x, p.y, p.z});
    halfspace::Polyhedron hull(std::pmr::get_default_resource());
    if (halfspace::convex_hull(points, hull).fault != halfspace::Fault::none)
      throw std::runtime_error("no hull of one of the polyhedra");
    return hull;
  }

  Shape<3> shape;
  Vector<3> centroid;
};

/// The core itself, as there is no way to it through the C API yet.
struct Halfspace {
  struct Pair {
    const Block* a;
    const Block* b;
    hs_pose at_a;
    hs_pose at_b;
  };

  explicit Halfspace(const PairSet3& set) {
    for (const Polyhedron& p : set.polyhedra) blocks.push_back(std::make_unique<Block>(p));
    for (const PolyhedraAt& pair : set.pairs)
      pairs.push_back(
          {blocks[std::size_t(pair.a)].get(), blocks[std::size_t(pair.b)].get(), pair.at_a, pair.at_b});
  }

  Answer answer(const Pair& pair) const {
    const Rotation<3> into_a = Rotation<3>::from_quaternion(pair.at_a.rotation).inverse();
    const Rotation<3> b_in_a = into_a * Rotation<3>::from_quaternion(pair.at_b.rotation);
    const double *from = pair.at_a.position, *to = pair.at_b.position;
    const Vector<3> apart(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const Vector<3> to_b = into_a * apart + (b_in_a * pair.b->centroid - pair.a->centroid);
    const auto found =
        halfspace::find_separation(pair.a->shape.outline(), pair.b->shape.outline(), to_b, b_in_a);
    return {found.gap <= 0, -found.gap, false};
  }

  std::vector<Pair> pairs;
  std::vector<std::unique_ptr<Block>> blocks;
};

}  // namespace

std::unique_ptr<Peer> make_halfspace(const PairSet3& set) { return std::make_unique<PeerOf<Halfspace>>(set); }

}  // namespace halfspace_benchmark
