// halfspace/shape.h in space: what comes back of a polyhedron.

#include <algorithm>
#include <cmath>
#include <map>

#include "capi/polyhedra.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// Six times the volume of the tetrahedra from the origin to the triangles of all faces: above 0 when the
/// faces are counter-clockwise seen from outside.
double six_volumes(const Points3& vertices, const Faces& faces) {
  double sum = 0;
  std::size_t first = 0;
  for (const std::int32_t size : faces.sizes) {
    const auto corner = [&](std::size_t i) { return vertices[std::size_t(faces.vertices[first + i])]; };
    for (std::size_t i = 1; i + 1 < std::size_t(size); ++i)
      sum += dot(corner(0), cross(corner(i), corner(i + 1)));
    first += std::size_t(size);
  }
  return sum;
}

}  // namespace

TEST_CASE("a box has the properties of a box, to the bit") {
  const Context context = make_context();
  // Binary fractions throughout, so that nothing is rounded.
  const Solid solid = box_3d({1, -2, 8}, {3, 2, 16});
  Solid clockwise = solid;
  for (std::size_t f = 0; f < 6; ++f) {
    const auto loop = clockwise.faces.vertices.begin() + std::ptrdiff_t(4 * f);
    std::reverse(loop, loop + 4);
  }
  const Halfspaces planes = {{{0, 0, -1}, {0, 0, 2}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}},
                             {-8, 32, 2, 2, -1, 3}};
  hs_shape* of_planes = nullptr;
  REQUIRE(hs_polyhedron_create_from_halfspaces(context.get(), view_of(planes.normals), planes.offsets.data(),
                                               &of_planes) == HS_OK);
  const Shape shapes[] = {make_polyhedron(context.get(), solid), make_polyhedron(context.get(), clockwise),
                          make_hull(context.get(), solid.vertices), Shape(of_planes)};
  for (const Shape& shape : shapes) {
    const hs_shape_properties p = properties_of(shape.get());
    CHECK(p.dimension == 3);
    CHECK(p.vertex_count == 8);
    CHECK(p.edge_count == 12);
    CHECK(p.face_count == 6);
    CHECK(p.volume == 64);
    CHECK((p.centroid[0] == 2 && p.centroid[1] == 0 && p.centroid[2] == 12));
    // Volume times the square of the side, by 12.
    const double moments[6] = {64 * 4 / 12., 64 * 16 / 12., 64 * 64 / 12., 0, 0, 0};
    for (int i = 0; i < 6; ++i) CHECK(std::abs(p.second_moment[i] - moments[i]) <= 8 * 0x1p-53 * moments[2]);
    CHECK(p.bounding_radius == Approx(std::sqrt(1. + 4 + 16)).epsilon(1e-15));
    CHECK(p.shortest_edge == 2);
    CHECK(six_volumes(vertices_3d_of(shape.get()), faces_of(shape.get())) == 6 * 64);
  }
}

TEST_CASE("what comes back of a polyhedron makes the same again") {
  const Context context = make_context();
  Random random(1);
  for (int count : {4, 5, 8, 20, 100}) {
    INFO(count << " points on a sphere");
    const Shape hull = make_hull(context.get(), round_points(random, count));
    const hs_shape_properties p = properties_of(hull.get());
    CHECK(p.vertex_count == count);
    CHECK(p.vertex_count - p.edge_count + p.face_count == 2);
    const Points3 vertices = vertices_3d_of(hull.get());
    const Faces faces = faces_of(hull.get());
    const Shape again = make_polyhedron(context.get(), {vertices, faces});
    const hs_shape_properties q = properties_of(again.get());
    CHECK(faces_of(again.get()).vertices == faces.vertices);
    CHECK(faces_of(again.get()).sizes == faces.sizes);
    // Vertices have been taken about the centroid and back: a rounding each, of coordinates up to 1.
    CHECK(std::abs(p.volume - q.volume) <= 100 * 0x1p-53);

    // Half-spaces hold all vertices, and their own face's lie on them: 16 roundings of coordinates up to 2.
    const Halfspaces planes = halfspaces_of(hull.get());
    const Point3 centroid = vector_of(p.centroid);
    std::size_t first = 0;
    for (std::size_t f = 0; f < planes.normals.size(); ++f) {
      CHECK(length(planes.normals[f]) == Approx(1).epsilon(1e-15));
      for (const Point3& v : vertices)
        CHECK(dot(planes.normals[f], v - centroid) <= planes.offsets[f] + 32 * 0x1p-53);
      for (std::size_t k = first; k < first + std::size_t(faces.sizes[f]); ++k) {
        const Point3& v = vertices[std::size_t(faces.vertices[k])];
        CHECK(std::abs(dot(planes.normals[f], v - centroid) - planes.offsets[f]) <= 32 * 0x1p-53);
      }
      first += std::size_t(faces.sizes[f]);
    }
    // Back through the half-spaces, one of them twice and one that cuts nothing off: they make no face.
    Points3 normals = planes.normals;
    std::vector<double> offsets = planes.offsets;
    normals.push_back(normals[0]);
    offsets.push_back(offsets[0] + 1);
    normals.push_back({1, 0, 0});
    offsets.push_back(10);
    hs_shape* made = nullptr;
    REQUIRE(hs_polyhedron_create_from_halfspaces(context.get(), view_of(normals), offsets.data(), &made) ==
            HS_OK);
    const Shape of_planes(made);
    const hs_shape_properties r = properties_of(of_planes.get());
    CHECK(r.face_count == p.face_count);
    CHECK(r.vertex_count == p.vertex_count);
    CHECK(r.volume == Approx(p.volume).epsilon(1e-9));
  }
}

TEST_CASE("every edge is between two faces that go along it in opposite directions") {
  const Context context = make_context();
  Random random(2);
  const Points outline = {{0, 0}, {3, 0}, {4, 2}, {1, 3}};
  const Shape shapes[] = {make_polyhedron(context.get(), cube()),
                          make_hull(context.get(), round_points(random, 30)),
                          make_shape(context.get(), outline)};
  for (const Shape& shape : shapes) {
    const hs_shape_properties p = properties_of(shape.get());
    std::vector<std::int32_t> ends(std::size_t(2 * p.edge_count));
    std::int64_t count = -1;
    REQUIRE(hs_shape_get_edges(shape.get(), ends.data(), p.edge_count, &count) == HS_OK);
    CHECK(count == p.edge_count);
    std::map<std::pair<std::int32_t, std::int32_t>, int> steps;  // along the faces
    const Faces faces = faces_of(shape.get());
    std::size_t first = 0;
    for (const std::int32_t size : faces.sizes) {
      const std::size_t n = std::size_t(size);
      // In the plane a face is an edge, from end to end.
      const std::size_t along = p.dimension == 2 ? 1 : n;
      for (std::size_t i = 0; i < along; ++i)
        ++steps[{faces.vertices[first + i], faces.vertices[first + (i + 1) % n]}];
      first += n;
    }
    CHECK(steps.size() == std::size_t(p.dimension == 2 ? count : 2 * count));
    for (std::size_t e = 0; e < std::size_t(count); ++e) {
      CHECK(steps[{ends[2 * e], ends[2 * e + 1]}] == 1);
      if (p.dimension == 3) CHECK(steps[{ends[2 * e + 1], ends[2 * e]}] == 1);
    }
  }
  const Faces sides = faces_of(shapes[2].get());
  CHECK(sides.sizes == std::vector<std::int32_t>(4, 2));
  CHECK(sides.vertices == std::vector<std::int32_t>{0, 1, 1, 2, 2, 3, 3, 0});
}

TEST_CASE("faces and edges that do not fit are cut short, and nothing else is written") {
  const Context context = make_context();
  const Shape shape = make_polyhedron(context.get(), cube());
  constexpr std::int32_t guard = -99;
  std::vector<std::int32_t> first(9, guard), all(26, guard), ends(26, guard);
  std::int64_t faces = -1, vertices = -1, edges = -1;
  const auto get = [&](std::int64_t n, std::int64_t m) {
    return hs_shape_get_faces(shape.get(), first.data(), n, all.data(), m, &faces, &vertices);
  };
  CHECK(get(0, 0) == HS_NOTE_TRUNCATED);
  CHECK(faces == 6);
  CHECK(vertices == 24);
  CHECK(std::count(first.begin(), first.end(), guard) == 9);
  CHECK(get(6, 24) == HS_NOTE_TRUNCATED);
  CHECK(std::count(first.begin(), first.end(), guard) == 3);
  CHECK(std::count(all.begin(), all.end(), guard) == 2);
  CHECK(get(7, 23) == HS_NOTE_TRUNCATED);
  CHECK(get(7, 24) == HS_OK);
  CHECK(first[6] == 24);
  CHECK(first[7] == guard);
  CHECK(hs_shape_get_edges(shape.get(), ends.data(), 11, &edges) == HS_NOTE_TRUNCATED);
  CHECK(edges == 12);
  CHECK(std::count(ends.begin(), ends.end(), guard) == 4);
  CHECK(hs_shape_get_edges(shape.get(), ends.data(), 12, nullptr) == HS_OK);
  CHECK(std::count(ends.begin(), ends.end(), guard) == 2);
}

TEST_CASE("a plane cuts a polyhedron into parts that make up the whole") {
  const Context context = make_context();
  hs_context* c = context.get();
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Shape whole = make_hull(c, round_points(random, 4 + i % 20));
    const hs_shape_properties p = properties_of(whole.get());
    const Point3 n = random_direction(random);
    const double normal[3] = {n.x, n.y, n.z};
    hs_shape* made[2] = {};
    REQUIRE(hs_shape_cut(whole.get(), p.centroid, normal, &made[0], &made[1]) == HS_OK);
    const Shape parts[2] = {Shape(made[0]), Shape(made[1])};
    REQUIRE(parts[0]);
    REQUIRE(parts[1]);
    double volume = 0, first_moment = 0;
    for (int side : {0, 1}) {
      const hs_shape_properties q = properties_of(parts[side].get());
      volume += q.volume;
      first_moment += q.volume * dot(n, vector_of(q.centroid) - vector_of(p.centroid));
      // The new face is the last, and looks away from its part.
      const Point3 last = halfspaces_of(parts[side].get()).normals.back();
      CHECK(length(last - (side == 0 ? n : -1.0 * n)) <= 1e-15);
    }
    CHECK(volume == Approx(p.volume).epsilon(1e-13));
    CHECK(std::abs(first_moment) <= 1e-13 * p.volume);
  }
}

}  // namespace halfspace_test
