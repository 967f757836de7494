#include <ccd/ccd.h>

#include "benchmarks/peer_of.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::Point3;
using halfspace_test::Points3;

constexpr std::size_t least_vertices_to_climb = 64;

struct Shape {
  Points3 vertices;                  // about the centre
  std::vector<int> first_neighbour;  // of each vertex, and the end
  std::vector<int> neighbours;
};

Shape shape_of(const Polyhedron& polyhedron) {
  Shape shape{halfspace_test::local_vertices(polyhedron), {0}, {}};
  for (int v = 0; v < int(shape.vertices.size()); ++v) {
    for (const Polyhedron::Edge& edge : polyhedron.edges) {
      if (edge.from == v) shape.neighbours.push_back(edge.to);
      if (edge.to == v) shape.neighbours.push_back(edge.from);
    }
    shape.first_neighbour.push_back(int(shape.neighbours.size()));
  }
  return shape;
}

/// A block of the pair in the frame of a, which is its own frame for a.
struct Body {
  const Shape* shape;
  Point3 position;
  Point3 axes[3];  // its own, in the frame of a
  mutable int last_vertex;
};

Point3 from_ccd(const ccd_vec3_t& v) { return {v.v[0], v.v[1], v.v[2]}; }
void to_ccd(const Point3& p, ccd_vec3_t* v) { ccdVec3Set(v, p.x, p.y, p.z); }

const Point3& farthest_of_all(const Shape& shape, const Point3& direction) {
  std::size_t farthest = 0;
  double most = dot(direction, shape.vertices[0]);
  for (std::size_t i = 1; i < shape.vertices.size(); ++i) {
    const double along = dot(direction, shape.vertices[i]);
    if (along > most) {
      most = along;
      farthest = i;
    }
  }
  return shape.vertices[farthest];
}

const Point3& farthest_by_climbing(const Shape& shape, const Point3& direction, int& vertex) {
  double most = dot(direction, shape.vertices[std::size_t(vertex)]);
  for (bool higher = true; higher;) {
    higher = false;
    const std::size_t from = std::size_t(vertex);
    for (int i = shape.first_neighbour[from]; i < shape.first_neighbour[from + 1]; ++i) {
      const int neighbour = shape.neighbours[std::size_t(i)];
      const double along = dot(direction, shape.vertices[std::size_t(neighbour)]);
      if (along <= most) continue;
      most = along;
      vertex = neighbour;
      higher = true;
    }
  }
  return shape.vertices[std::size_t(vertex)];
}

const Point3& farthest(const Body& body, const Point3& direction) {
  return body.shape->vertices.size() < least_vertices_to_climb
             ? farthest_of_all(*body.shape, direction)
             : farthest_by_climbing(*body.shape, direction, body.last_vertex);
}

void support_a(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  to_ccd(farthest(*static_cast<const Body*>(object), from_ccd(*direction)), point);
}

void support_b(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Body& body = *static_cast<const Body*>(object);
  const Point3 d = from_ccd(*direction);
  const Point3& p = farthest(body, {dot(d, body.axes[0]), dot(d, body.axes[1]), dot(d, body.axes[2])});
  to_ccd(body.position + p.x * body.axes[0] + p.y * body.axes[1] + p.z * body.axes[2], point);
}

void centre(const void* object, ccd_vec3_t* point) {
  to_ccd(static_cast<const Body*>(object)->position, point);
}

void first_direction(const void*, const void* b, ccd_vec3_t* direction) { centre(b, direction); }

ccd_t settings() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.first_dir = first_direction;
  ccd.support1 = support_a;
  ccd.support2 = support_b;
  ccd.center1 = ccd.center2 = centre;
  ccd.max_iterations = 100;
  return ccd;
}

using Penetration = int(const void*, const void*, const ccd_t*, ccd_real_t* depth, ccd_vec3_t* direction,
                        ccd_vec3_t* position);

template <Penetration* penetration>
struct Ccd {
  struct Pair {
    const Shape* a;
    const Shape* b;
    hs_pose at_a;
    hs_pose at_b;
  };

  explicit Ccd(const PairSet3& set) {
    for (const Polyhedron& p : set.polyhedra) shapes.push_back(shape_of(p));
    for (const PolyhedraAt& pair : set.pairs)
      pairs.push_back({&shapes[std::size_t(pair.a)], &shapes[std::size_t(pair.b)], pair.at_a, pair.at_b});
  }

  Answer answer(const Pair& pair) const {
    const halfspace_test::Turn3<double> turn_a(pair.at_a), turn_b(pair.at_b);
    const double inverse_a = 1 / turn_a.length_squared(), inverse_b = 1 / turn_b.length_squared();
    const auto axis = [&](const Point3& in_b) {
      return inverse_a * inverse_b * turn_a.turned_back(turn_b.turned(in_b));
    };
    const double *from = pair.at_a.position, *to = pair.at_b.position;
    const Point3 apart{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    const Body a{pair.a, {}, {}, 0};
    const Body b{pair.b,
                 inverse_a * turn_a.turned_back(apart),
                 {axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})},
                 0};
    Answer answer;
    ccd_vec3_t direction, position;
    const int status = penetration(&a, &b, &ccd, &answer.depth, &direction, &position);
    answer.touches = status == 0;
    answer.gave_up = status == -2;
    return answer;
  }

  std::vector<Pair> pairs;
  std::vector<Shape> shapes;
  ccd_t ccd = settings();
};

}  // namespace

std::unique_ptr<Peer> make_ccd_mpr(const PairSet3& set) {
  return std::make_unique<PeerOf<Ccd<ccdMPRPenetration>>>(set);
}
std::unique_ptr<Peer> make_ccd_gjk(const PairSet3& set) {
  return std::make_unique<PeerOf<Ccd<ccdGJKPenetration>>>(set);
}

}  // namespace halfspace_benchmark
