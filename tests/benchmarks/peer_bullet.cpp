#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <limits>

#include "benchmarks/peer_of.h"

namespace halfspace_benchmark {
namespace {

std::unique_ptr<btConvexHullShape> shape_of(const Polyhedron& polyhedron) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const halfspace_test::Point3& v : halfspace_test::local_vertices(polyhedron))
    shape->addPoint({v.x, v.y, v.z}, false);
  shape->setMargin(0);
  shape->recalcLocalAabb();
  return shape;
}

btTransform pose_of(const hs_pose& at) {
  const auto& [x, y, z, w] = at.rotation;
  return btTransform({x, y, z, w}, {at.position[0], at.position[1], at.position[2]});
}

struct Bullet {
  struct Pair {
    const btConvexHullShape* a;
    const btConvexHullShape* b;
    btTransform at_a;
    btTransform at_b;
  };

  explicit Bullet(const PairSet3& set) {
    for (const Polyhedron& p : set.polyhedra) shapes.push_back(shape_of(p));
    for (const PolyhedraAt& pair : set.pairs)
      pairs.push_back({shapes[std::size_t(pair.a)].get(), shapes[std::size_t(pair.b)].get(),
                       pose_of(pair.at_a), pose_of(pair.at_b)});
  }

  Answer answer(const Pair& pair) {
    btGjkPairDetector detector(pair.a, pair.b, &simplex_solver, &depth_solver);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = pair.at_a;
    input.m_transformB = pair.at_b;
    // It may stop when it knows that they are apart, and still reports a distance of 0.
    input.m_maximumDistanceSquared = std::numeric_limits<btScalar>::min();
    struct : btStorageResult {
      void setShapeIdentifiersA(int, int) override {}
      void setShapeIdentifiersB(int, int) override {}
    } result;
    detector.getClosestPoints(input, result, nullptr);
    if (result.m_distance > 0) return {};
    return {true, -result.m_distance, false};
  }

  std::vector<Pair> pairs;
  std::vector<std::unique_ptr<btConvexHullShape>> shapes;
  btVoronoiSimplexSolver simplex_solver;
  btGjkEpaPenetrationDepthSolver depth_solver;
};

}  // namespace

std::unique_ptr<Peer> make_bullet(const PairSet3& set) { return std::make_unique<PeerOf<Bullet>>(set); }

}  // namespace halfspace_benchmark
