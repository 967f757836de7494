#include <ode/ode.h>

#include <deque>
#include <limits>

#include "benchmarks/peer_of.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::Point3;

/// The arrays that geoms of one shape point to.
struct Shape {
  std::vector<dReal> points;
  std::vector<dReal> planes;           // outer unit normal, offset
  std::vector<unsigned int> polygons;  // number of vertices, vertices counter-clockwise
};

/// A face so small that the sign of ODE's check of its sense of rotation is lost in rounding is left out: ODE
/// would print a complaint. Built with libccd, as in Debian, its collider reads the points alone. Of a sliver
/// all faces may be left out; but ODE ends the program when it is given no address of planes, so that there
/// is always room for some.
Shape shape_of(const Polyhedron& polyhedron) {
  Shape shape;
  shape.planes.reserve(4 * polyhedron.faces.size());
  shape.polygons.reserve(polyhedron.faces.size() + 2 * polyhedron.edges.size());
  const halfspace_test::Points3 local = halfspace_test::local_vertices(polyhedron);
  const auto vertex = [&](int i) { return local[std::size_t(i)]; };
  for (const Point3& v : local) shape.points.insert(shape.points.end(), {v.x, v.y, v.z});
  for (const std::vector<int>& face : polyhedron.faces) {
    const Point3 p = vertex(face[0]), q = vertex(face[1]), r = vertex(face[2]);
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * length(p) * length(q) * length(r);
    if (dot(p, cross(q, r)) <= rounding) continue;
    const halfspace_test::Corner corner = halfspace_test::widest_corner(polyhedron, face);
    const Point3 here = vertex(corner.here);
    const Point3 normal = unit(cross(here - vertex(corner.before), vertex(corner.after) - here));
    shape.planes.insert(shape.planes.end(), {normal.x, normal.y, normal.z, dot(normal, here)});
    shape.polygons.push_back(static_cast<unsigned int>(face.size()));
    shape.polygons.insert(shape.polygons.end(), face.begin(), face.end());
  }
  return shape;
}

/// ODE's geoms know where they are, so that each block of each pair is one.
class Geom {
 public:
  Geom(const Shape& shape, const hs_pose& at)
      : id_(dCreateConvex(nullptr, shape.planes.data(), static_cast<unsigned int>(shape.planes.size() / 4),
                          shape.points.data(), static_cast<unsigned int>(shape.points.size() / 3),
                          shape.polygons.data())) {
    dGeomSetPosition(id_, at.position[0], at.position[1], at.position[2]);
    const dQuaternion rotation = {at.rotation[3], at.rotation[0], at.rotation[1], at.rotation[2]};
    dGeomSetQuaternion(id_, rotation);
  }
  ~Geom() { dGeomDestroy(id_); }
  Geom(const Geom&) = delete;
  Geom& operator=(const Geom&) = delete;

  dGeomID id() const { return id_; }

 private:
  dGeomID id_;
};

/// ODE's globals, for as long as it is used.
struct Library {
  Library() { dInitODE2(0); }
  ~Library() { dCloseODE(); }
};

struct Ode {
  struct Pair {
    dGeomID a;
    dGeomID b;
  };

  explicit Ode(const PairSet3& set) {
    static const Library library;
    for (const Polyhedron& p : set.polyhedra) shapes.push_back(shape_of(p));
    for (const PolyhedraAt& pair : set.pairs) {
      const Geom& a = geoms.emplace_back(shapes[std::size_t(pair.a)], pair.at_a);
      const Geom& b = geoms.emplace_back(shapes[std::size_t(pair.b)], pair.at_b);
      pairs.push_back({a.id(), b.id()});
    }
  }

  Answer answer(const Pair& pair) const {
    dContactGeom contact;
    if (dCollide(pair.a, pair.b, 1, &contact, sizeof contact) == 0) return {};
    return {true, contact.depth, false};
  }

  std::vector<Pair> pairs;
  std::vector<Shape> shapes;
  std::deque<Geom> geoms;  // a deque: they do not move
};

}  // namespace

std::unique_ptr<Peer> make_ode(const PairSet3& set) { return std::make_unique<PeerOf<Ode>>(set); }

}  // namespace halfspace_benchmark
