#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"
#include "contacts_3d.h"
#include "geometry/polyhedron/cut.h"
#include "geometry/polyhedron/hull.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

PolyhedronParts cut(const Polyhedron& whole, const Vector<3>& point, const Vector<3>& normal) {
  return cut_polyhedron(whole, point, normal, std::pmr::get_default_resource());
}

double volume_of(const Polyhedron& p) { return p.is_empty() ? 0 : shape_of(p).volume(); }

}  // namespace

TEST_CASE("a box cut in the middle is two boxes that share their new vertices") {
  const PolyhedronParts parts = cut(completed(box({2, 2, 2})), {0, 0, 0.5}, {0, 0, 3});
  const Shape<3> behind = shape_of(parts.behind);
  const Shape<3> ahead = shape_of(parts.ahead);
  CHECK(behind.volume() == 6);
  CHECK(ahead.volume() == 2);
  CHECK(behind.face_count() == 6);
  CHECK(ahead.face_count() == 6);
  CHECK(parts.behind.normals.back() == Vector<3>(0, 0, 1));
  CHECK(parts.ahead.normals.back() == Vector<3>(0, 0, -1));
  int shared = 0;
  for (const Vector<3>& p : parts.behind.vertices) {
    for (const Vector<3>& q : parts.ahead.vertices) shared += p == q;
  }
  CHECK(shared == 4);
}

TEST_CASE("a plane through vertices, edges and diagonals cuts there") {
  const Polyhedron cube = completed(box({2, 2, 2}));
  // Through two opposite edges: two prisms on the vertices that were there.
  const PolyhedronParts prisms = cut(cube, {0, 0, 0}, {1, 1, 0});
  for (const Polyhedron* part : {&prisms.behind, &prisms.ahead}) {
    CHECK(part->vertex_count() == 6);
    CHECK(part->face_count() == 5);
    CHECK(volume_of(*part) == Approx(4).epsilon(1e-15));
  }
  // Through three vertices: a corner, and the rest.
  const PolyhedronParts corner = cut(cube, {1, -1, -1}, {1, 1, 1});
  CHECK(corner.behind.vertex_count() == 4);
  CHECK(corner.ahead.vertex_count() == 7);
  CHECK(corner.ahead.face_count() == 7);
  CHECK(volume_of(corner.behind) == Approx(8.0 / 6).epsilon(1e-15));
}

TEST_CASE("a plane that only touches cuts nothing off") {
  const Polyhedron cube = completed(box({2, 2, 2}));
  for (const Vector<3>& normal :
       {Vector<3>(0, 0, 1), Vector<3>(0, 1, 1), Vector<3>(1, 1, 1), Vector<3>(3, 2, 1)}) {
    const PolyhedronParts parts = cut(cube, {1, 1, 1}, normal);
    CHECK(parts.ahead.is_empty());
    CHECK(parts.behind.vertices == cube.vertices);
    CHECK(parts.behind.normals == cube.normals);
    CHECK(parts.too_thin == Fault::none);
  }
}

TEST_CASE("a slice thinner than rounding is reported and not cut off") {
  const Polyhedron cube = completed(box({2, 2, 2}));
  const PolyhedronParts parts = cut(cube, {0, 0, 1 - 0.5 * flatness_tolerance(1)}, {0, 0, 1});
  CHECK(parts.too_thin == Fault::zero_volume);
  CHECK(parts.ahead.is_empty());
  CHECK(parts.behind.vertices == cube.vertices);
}

TEST_CASE("the parts of a cut make up the whole, far from the origin too") {
  Random random(21);
  for (const double away : {0.0, 1e8}) {
    for (int round = 0; round < 300; ++round) {
      Cloud points = random_cloud(random, 25, 0.5, 1);
      for (Vector<3>& p : points) p += Vector<3>(away, away, -away);
      const Polyhedron whole = hull_of(points);
      const Vector<3> point = Vector<3>(away, away, -away) + random_vector(random, -0.6, 0.6);
      const PolyhedronParts parts = cut(whole, point, random_direction(random));
      REQUIRE(parts.too_thin == Fault::none);
      for (const Polyhedron* part : {&parts.behind, &parts.ahead})
        if (!part->is_empty()) REQUIRE(check_polyhedron(*part).fault == Fault::none);
      // A new vertex is off its edge by a few ulps of its coordinates; the surface is about 12.
      const double rounding = 12 * 4 * 0x1p-53 * (1 + away);
      CHECK(std::abs(volume_of(parts.behind) + volume_of(parts.ahead) - volume_of(whole)) < rounding);
    }
  }
}

TEST_CASE("cutting scales by powers of two bit for bit") {
  Random random(22);
  const Polyhedron whole = hull_of(random_cloud(random, 40, 0.8, 1));
  Polyhedron large = copy_of(whole);
  for (Vector<3>& v : large.vertices) v *= 0x1p40;
  const Vector<3> point(0.1, -0.2, 0.3), normal = random_direction(random);
  const PolyhedronParts parts = cut(whole, point, normal);
  const PolyhedronParts scaled = cut(large, point * 0x1p40, normal);
  REQUIRE(scaled.behind.face_vertices == parts.behind.face_vertices);
  for (std::size_t v = 0; v < parts.behind.vertices.size(); ++v)
    CHECK(scaled.behind.vertices[v] == parts.behind.vertices[v] * 0x1p40);
}

namespace {

/// Least extent across a face of the part behind the plane, made anew as the hull of its corners; 0 when it
/// has no hull.
double thickness_behind(const Polyhedron& whole, const Vector<3>& point, const Vector<3>& normal) {
  Cloud corners;
  const auto height = [&](const Vector<3>& v) { return normal.normalized().dot(v - point); };
  for (const Vector<3>& v : whole.vertices) {
    if (height(v) <= 0) corners.push_back(v);
    for (const Vector<3>& w : whole.vertices) {
      if (height(v) < 0 && height(w) > 0)
        corners.push_back(v + height(v) / (height(v) - height(w)) * (w - v));
    }
  }
  Polyhedron part(std::pmr::get_default_resource());
  if (convex_hull(corners, part).fault != Fault::none) return 0;
  double thickness = HUGE_VAL;
  for (std::int32_t f = 0; f < part.face_count(); ++f) {
    double deepest = 0;
    for (const Vector<3>& v : part.vertices)
      deepest = std::max(deepest, part.normals[std::size_t(f)].dot(part.corner(f, 0) - v));
    thickness = std::min(thickness, deepest);
  }
  return thickness;
}

/// What is left of a whole after one cut after the other.
class Rock {
 public:
  explicit Rock(Polyhedron whole) : volume_(volume_of(whole)) { blocks_.push_back(std::move(whole)); }

  int count() const { return int(blocks_.size()); }
  const Polyhedron& block(int i) const { return blocks_[std::size_t(i)]; }

  void cut_block(int i, const Vector<3>& point, const Vector<3>& normal) {
    PolyhedronParts parts = cut(block(i), point, normal);
    if (parts.too_thin != Fault::none) {
      const double thickness =
          std::min(thickness_behind(block(i), point, normal), thickness_behind(block(i), point, -normal));
      REQUIRE(thickness <= 4 * flatness_tolerance(largest_coordinate(block(i).vertices)));
    }
    if (parts.behind.is_empty()) return;
    blocks_[std::size_t(i)] = std::move(parts.behind);
    if (!parts.ahead.is_empty()) blocks_.push_back(std::move(parts.ahead));
  }

  void cut_all(const Vector<3>& point, const Vector<3>& normal) {
    for (int i = count(); i-- > 0;) cut_block(i, point, normal);
  }

  /// Valid blocks make up the whole: each new face moves the surface by a few ulps, twice and cancelling but
  /// for what is lost where vertices are off the plane.
  void check(double tolerance) const {
    double volume = 0;
    for (const Polyhedron& block : blocks_) {
      REQUIRE(int(check_polyhedron(block).fault) == int(Fault::none));
      volume += volume_of(block);
    }
    CHECK(volume == Approx(volume_).epsilon(tolerance));
  }

 private:
  double volume_;
  std::vector<Polyhedron> blocks_;
};

/// Of planes through a vertex of a block: through two others, through one, along a face, any.
struct PlanesThroughVertex {
  Vector<3> vertex;
  std::array<Vector<3>, 4> normals;
};

PlanesThroughVertex planes_through_vertex(const Polyhedron& block, Random& random) {
  const auto vertex = [&] {
    return block.vertices[std::size_t(random.integer(0, block.vertex_count() - 1))];
  };
  const Vector<3> a = vertex(), b = vertex(), c = vertex();
  const Vector<3> of_face = block.normals[std::size_t(random.integer(0, block.face_count() - 1))];
  return {a,
          {cross_product(b - a, c - a), cross_product(b - a, random_direction(random)), of_face,
           random_direction(random)}};
}

Polyhedron unit_cube() { return completed(box({1, 1, 1}, {0.5, 0.5, 0.5})); }

}  // namespace

TEST_CASE("a thousand cuts, each of some block by some plane, leave valid blocks that make up the whole") {
  Random random(23);
  Rock rock(unit_cube());
  for (int i = 0; i < 1000; ++i) {
    const int block = random.integer(0, rock.count() - 1);
    const Shape<3> shape = shape_of(rock.block(block));
    const Vector<3> off_center = 0.5 * shape.bounding_radius() * random_vector(random, -1, 1);
    rock.cut_block(block, shape.centroid() + off_center, random_direction(random));
  }
  CHECK(rock.count() > 500);
  rock.check(1e-14);
}

TEST_CASE("a thousand planes shave one block, and the shavings make up what it lost") {
  Random random(24);
  Rock rock(unit_cube());
  for (int i = 0; i < 1000; ++i) {
    const Vector<3> outwards = random_direction(random);
    rock.cut_block(0, Vector<3>(0.5, 0.5, 0.5) + random.uniform(0.4, 0.5) * outwards, outwards);
  }
  CHECK(rock.block(0).face_count() > 100);
  rock.check(1e-13);
}

TEST_CASE("joint sets, cut again by almost and exactly the same planes, leave no invalid block") {
  const double jitter = GENERATE(0.0, 1e-16, 1e-14, 1e-12, 1e-9);
  Random random(25);
  Rock rock(unit_cube());
  const Vector<3> sets[] = {{0.3, 0.1, 1}, {1, -0.2, 0.1}, {0, 1, 0.4}};
  for (int repetition = 0; repetition < 3; ++repetition) {
    for (const Vector<3>& set : sets) {
      for (int i = -2; i < 10; ++i) {
        const Vector<3> point = set.normalized() * (0.15 * i) + jitter * random_vector(random, -1, 1);
        rock.cut_all(point, set + jitter * random_vector(random, -1, 1));
      }
    }
  }
  CHECK(rock.count() > 300);
  rock.check(1e-12);
}

TEST_CASE("planes through a block's own vertices, edges and faces leave valid blocks") {
  Random random(26);
  for (int round = 0; round < 20; ++round) {
    Rock rock(hull_of(random_cloud(random, 20, 0.5, 1)));
    for (int i = 0; i < 60; ++i) {
      const Polyhedron& some = rock.block(random.integer(0, rock.count() - 1));
      const PlanesThroughVertex planes = planes_through_vertex(some, random);
      const Vector<3> normal = planes.normals[std::size_t(i % 4)];
      if (normal.norm() > 1e-12) rock.cut_all(planes.vertex, normal);
      if (rock.count() > 400) break;
    }
    rock.check(1e-12);
  }
}

TEST_CASE("the planes of another block's faces cut, through vertices that each of them has left") {
  // Vertices a few roundings apart can all be on the next plane. Each seed has a pair where some of them
  // would let the new face's rim branch, if being on the plane were enough to be outside.
  for (const std::uint64_t seed : {142, 143, 157}) {
    Random random(seed);
    for (int round = 0; round < 300; ++round) {
      const Shape<3> other = random_block(random, random.integer(4, 24));
      const Shape<3> whole = random_block(random, random.integer(4, 24));
      const Vector<3> to_whole = random_vector(random, -0.8, 0.8);
      Polyhedron moved = polyhedron_of(whole, std::pmr::get_default_resource());
      for (Vector<3>& v : moved.vertices) v += to_whole - whole.centroid();
      Rock rock(std::move(moved));
      const Topology& t = other.topology();
      for (int f = 0; f < other.face_count(); ++f) {
        const Outline<3>& o = other.outline();
        rock.cut_block(0, o.vertex(t.face_vertex[t.first_of_face[f]]), o.normal(f));
      }
      rock.check(1e-13);
    }
  }
}

TEST_CASE("planes through a block's own vertices, off by roundings, cut off all that is not thin") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Random random(seed);
    for (int round = 0; round < 300; ++round) {
      Rock rock(hull_of(random_cloud(random, random.integer(5, 24), 1, 1)));
      for (int i = 0; i < 40; ++i) {
        const int block = random.integer(0, rock.count() - 1);
        const PlanesThroughVertex planes = planes_through_vertex(rock.block(block), random);
        const Vector<3> normal = planes.normals[std::size_t(random.integer(0, 3))];
        const double jitter = std::pow(10, random.uniform(-17, -13));
        if (normal.norm() > 1e-12)
          rock.cut_block(block, planes.vertex + jitter * random_direction(random), normal.normalized());
      }
      rock.check(1e-12);
    }
  }
}
