#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>

#include <cmath>
#include <exception>

#include "benchmarks/peer_of.h"

namespace halfspace_benchmark {
namespace {

using Shape = fcl::Convex<double>;
using Pose = fcl::Transform3<double>;

std::unique_ptr<Shape> shape_of(const Polyhedron& polyhedron) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const halfspace_test::Point3& v : halfspace_test::local_vertices(polyhedron))
    vertices->emplace_back(v.x, v.y, v.z);
  auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& face : polyhedron.faces) {
    faces->push_back(int(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return std::make_unique<Shape>(vertices, int(polyhedron.faces.size()), faces);
}

Pose pose_of(const hs_pose& at) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(at.rotation[3], at.rotation[0], at.rotation[1], at.rotation[2])
                      .normalized()
                      .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(at.position[0], at.position[1], at.position[2]);
  return pose;
}

template <fcl::GJKSolverType solver>
struct Fcl {
  struct Pair {
    const Shape* a;
    const Shape* b;
    Pose at_a;
    Pose at_b;
  };

  explicit Fcl(const PairSet3& set) {
    for (const Polyhedron& p : set.polyhedra) shapes.push_back(shape_of(p));
    for (const PolyhedraAt& pair : set.pairs)
      pairs.push_back({shapes[std::size_t(pair.a)].get(), shapes[std::size_t(pair.b)].get(),
                       pose_of(pair.at_a), pose_of(pair.at_b)});
    request.enable_contact = true;
    request.gjk_solver_type = solver;
  }

  /// FCL throws where its geometry contradicts itself.
  Answer answer(const Pair& pair) const {
    try {
      fcl::CollisionResult<double> result;
      fcl::collide(pair.a, pair.at_a, pair.b, pair.at_b, request, result);
      if (!result.isCollision()) return {};
      const double depth = result.getContact(0).penetration_depth;
      return {true, std::abs(depth), false};  // FCL's own solver gives the depth below 0
    } catch (const std::exception&) {
      return {false, 0, true};
    }
  }

  std::vector<Pair> pairs;
  std::vector<std::unique_ptr<Shape>> shapes;
  fcl::CollisionRequest<double> request;
};

}  // namespace

std::unique_ptr<Peer> make_fcl_ccd(const PairSet3& set) {
  return std::make_unique<PeerOf<Fcl<fcl::GST_LIBCCD>>>(set);
}
std::unique_ptr<Peer> make_fcl_own(const PairSet3& set) {
  return std::make_unique<PeerOf<Fcl<fcl::GST_INDEP>>>(set);
}

}  // namespace halfspace_benchmark
