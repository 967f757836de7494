#include "benchmarks/called_pairs_3d.h"

#include <stdexcept>

#include "benchmarks/peer_of.h"
#include "capi/handles.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::Point3;

halfspace_test::Shape make_hull(hs_context* context, const Polyhedron& polyhedron) {
  const halfspace_test::Points3& p = polyhedron.vertices;
  const hs_view points = {&p[0].x, &p[0].y, &p[0].z, sizeof p[0], std::int64_t(p.size())};
  hs_shape* shape = nullptr;
  halfspace_test::require_ok(hs_polyhedron_create_hull(context, points, &shape), context);
  return halfspace_test::Shape(shape);
}

/// A shape of the library, and the centroid that its poses put at their position, seen from the polyhedron's
/// centre.
struct CalledShape {
  halfspace_test::Shape shape;
  Point3 centroid;

  CalledShape(hs_context* context, const Polyhedron& polyhedron) : shape(make_hull(context, polyhedron)) {
    const hs_shape_properties properties = halfspace_test::properties_of(shape.get());
    const double* c = properties.centroid;
    centroid = Point3{c[0], c[1], c[2]} - polyhedron.centre;
  }

  hs_pose placed(hs_pose at) const {
    const Point3 way = halfspace_test::turned(at, centroid);
    at.position[0] += way.x;
    at.position[1] += way.y;
    at.position[2] += way.z;
    return at;
  }
};

template <bool is_warm>
struct Called {
  struct Pair {
    const hs_shape* a;
    const hs_shape* b;
    hs_pose at_a;
    hs_pose at_b;
    hs_pair_cache cache;
  };

  explicit Called(const PairSet3& set) {
    for (const Polyhedron& p : set.polyhedra) shapes.emplace_back(context.get(), p);
    for (const PolyhedraAt& pair : set.pairs) {
      const CalledShape &a = shapes[std::size_t(pair.a)], &b = shapes[std::size_t(pair.b)];
      pairs.push_back({a.shape.get(), b.shape.get(), a.placed(pair.at_a), b.placed(pair.at_b), {}});
    }
  }

  Answer answer(Pair& pair) const {
    hs_contact contact;
    const hs_status status = hs_pair_detect(pair.a, &pair.at_a, pair.b, &pair.at_b, nullptr,
                                            is_warm ? &pair.cache : nullptr, &contact);
    if (status != HS_OK) throw std::runtime_error(hs_status_string(status));
    return {contact.type != HS_CONTACT_NONE, -contact.gap, false};
  }

  halfspace_test::Context context = halfspace_test::make_context();
  std::vector<CalledShape> shapes;
  std::vector<Pair> pairs;
};

}  // namespace

std::unique_ptr<Peer> make_called_cold(const PairSet3& set) {
  return std::make_unique<PeerOf<Called<false>>>(set);
}
std::unique_ptr<Peer> make_called_warm(const PairSet3& set) {
  return std::make_unique<PeerOf<Called<true>>>(set);
}

}  // namespace halfspace_benchmark
