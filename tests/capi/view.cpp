// halfspace/view.h: every layout that a host may have passes without a copy and without a difference.

#include <cstring>
#include <limits>
#include <string>

#include "capi/polyhedra.h"
#include "capi/refusals.h"

namespace halfspace_test {
namespace {

const Points outline = {{0.1, 0.2}, {3.3, -0.4}, {4.5, 1.6}, {2.7, 3.8}, {0.9, 2.1}};
constexpr std::int64_t n = 5;
constexpr double guard = 12345;  // what must not be overwritten

/// One way to lay n points out in memory.
struct Layout {
  std::string name;
  std::size_t size;     // of the whole, in doubles
  std::size_t x, y, z;  // where point 0 begins; z == size: none
  std::int64_t stride;  // in doubles
};

const Layout layouts[] = {
    {"C double[n][3]", 3 * n, 0, 1, 2, 3},
    {"C double[n][2]", 2 * n, 0, 1, 2 * n, 2},
    {"Fortran x(3,n)", 3 * n, 0, 1, 2, 3},
    {"Fortran x(n,3)", 3 * n, 0, n, 2 * n, 1},
    {"separate arrays with room between", 3 * (n + 4), 2, n + 6, 2 * n + 10, 1},
    {"every third row of a NumPy array", 12 * n, 1, 2, 3, 12},
    {"backwards", 3 * n, 3 * n - 3, 3 * n - 2, 3 * n - 1, -3},
};

hs_view read_view(const Layout& l, const std::vector<double>& memory) {
  const double* p = memory.data();
  return {p + l.x, p + l.y, l.z < l.size ? p + l.z : nullptr, l.stride * std::int64_t(sizeof(double)), n};
}

hs_mutable_view write_view(const Layout& l, std::vector<double>& memory, std::int64_t count = n) {
  double* p = memory.data();
  return {p + l.x, p + l.y, l.z < l.size ? p + l.z : nullptr, l.stride * std::int64_t(sizeof(double)), count};
}

std::size_t at(std::size_t first, std::int64_t stride, std::int64_t i) {
  return std::size_t(std::int64_t(first) + i * stride);
}

std::vector<double> laid_out(const Layout& l, const Points3& points) {
  std::vector<double> memory(l.size, guard);
  for (std::int64_t i = 0; i < n; ++i) {
    const Point3& p = points[std::size_t(i)];
    memory[at(l.x, l.stride, i)] = p.x;
    memory[at(l.y, l.stride, i)] = p.y;
    memory[at(l.z, l.stride, i)] = p.z;
  }
  return memory;
}

std::vector<double> laid_out(const Layout& l) {
  std::vector<double> memory(l.size, guard);
  for (std::int64_t i = 0; i < n; ++i) {
    memory[at(l.x, l.stride, i)] = outline[std::size_t(i)].x;
    memory[at(l.y, l.stride, i)] = outline[std::size_t(i)].y;
    // In 2D whatever comes in as z is ignored, also what is no number.
    if (l.z < l.size) memory[at(l.z, l.stride, i)] = std::numeric_limits<double>::quiet_NaN();
  }
  return memory;
}

}  // namespace

TEST_CASE("a shape is the same from every layout") {
  const Context context = make_context();
  const Shape plain = make_shape(context.get(), outline);
  const hs_shape_properties expected = properties_of(plain.get());
  for (const Layout& l : layouts) {
    INFO(l.name);
    const std::vector<double> memory = laid_out(l);
    hs_shape* made = nullptr;
    REQUIRE(hs_polygon_create(context.get(), read_view(l, memory), &made) == HS_OK);
    const Shape shape(made);
    const hs_shape_properties got = properties_of(shape.get());
    CHECK(std::memcmp(&got, &expected, sizeof got) == 0);
  }
}

TEST_CASE("vertices and half-spaces arrive in every layout, z is 0, nothing else is written") {
  const Context context = make_context();
  const Shape shape = make_shape(context.get(), outline);
  const Points expected = vertices_of(shape.get());
  for (const Layout& l : layouts) {
    for (std::int64_t capacity : {n, n - 2, std::int64_t(0)}) {
      INFO(l.name << ", capacity " << capacity);
      std::vector<double> memory(l.size, guard);
      std::int64_t count = -1;
      const hs_status status = hs_shape_get_vertices(shape.get(), write_view(l, memory, capacity), &count);
      CHECK(status == (capacity < n ? HS_NOTE_TRUNCATED : HS_OK));
      CHECK(count == n);
      std::vector<double> wanted(l.size, guard);
      for (std::int64_t i = 0; i < capacity; ++i) {
        wanted[at(l.x, l.stride, i)] = expected[std::size_t(i)].x;
        wanted[at(l.y, l.stride, i)] = expected[std::size_t(i)].y;
        if (l.z < l.size) wanted[at(l.z, l.stride, i)] = 0;
      }
      CHECK(memory == wanted);
    }
    std::vector<double> memory(l.size, guard), offsets(n + 1, guard);
    std::int64_t count = -1;
    REQUIRE(hs_shape_get_halfspaces(shape.get(), write_view(l, memory), offsets.data(), &count) == HS_OK);
    CHECK(count == n);
    CHECK(offsets[n] == guard);
    const hs_shape_properties p = properties_of(shape.get());
    for (std::int64_t i = 0; i < n; ++i) {
      // Half-space i is that of the edge from vertex i to the next: both lie on its line, to rounding of
      // coordinates below 8.
      for (std::int64_t v : {i, (i + 1) % n}) {
        const double height = memory[at(l.x, l.stride, i)] * (expected[std::size_t(v)].x - p.centroid[0]) +
                              memory[at(l.y, l.stride, i)] * (expected[std::size_t(v)].y - p.centroid[1]);
        CHECK(std::abs(height - offsets[std::size_t(i)]) <= 16 * 8 * 0x1p-53);
      }
    }
  }
}

TEST_CASE("a polyhedron is the same from every layout, and its vertices and normals arrive in each") {
  const Context context = make_context();
  const Points3 corners = {{0.1, 0.2, 0.3}, {3.3, -0.4, 0.1}, {4.5, 1.6, -0.2}, {2.7, 3.8, 0}, {1.9, 1.1, 2}};
  const Shape plain = make_hull(context.get(), corners);
  const hs_shape_properties expected = properties_of(plain.get());
  REQUIRE(expected.vertex_count == n);
  const Points3 vertices = vertices_3d_of(plain.get());
  const Halfspaces planes = halfspaces_of(plain.get());
  for (const Layout& l : layouts) {
    if (l.z == l.size) continue;  // in space z must be there
    INFO(l.name);
    const std::vector<double> memory = laid_out(l, corners);
    hs_shape* made = nullptr;
    REQUIRE(hs_polyhedron_create_hull(context.get(), read_view(l, memory), &made) == HS_OK);
    const Shape shape(made);
    const hs_shape_properties got = properties_of(shape.get());
    CHECK(std::memcmp(&got, &expected, sizeof got) == 0);

    for (std::int64_t capacity : {n, n - 2, std::int64_t(0)}) {
      INFO("capacity " << capacity);
      std::vector<double> out(l.size, guard), normals(l.size, guard), offsets(n, guard);
      std::int64_t count = -1;
      CHECK(hs_shape_get_vertices(shape.get(), write_view(l, out, capacity), &count) ==
            (capacity < n ? HS_NOTE_TRUNCATED : HS_OK));
      CHECK(count == n);
      const hs_status status =
          hs_shape_get_halfspaces(shape.get(), write_view(l, normals, capacity), offsets.data(), &count);
      CHECK(status == (capacity < expected.face_count ? HS_NOTE_TRUNCATED : HS_OK));
      CHECK(count == expected.face_count);
      std::vector<double> wanted(l.size, guard), wanted_normals(l.size, guard);
      const auto put = [&](std::vector<double>& to, std::int64_t i, const Point3& p) {
        to[at(l.x, l.stride, i)] = p.x;
        to[at(l.y, l.stride, i)] = p.y;
        to[at(l.z, l.stride, i)] = p.z;
      };
      for (std::int64_t i = 0; i < capacity; ++i) {
        put(wanted, i, vertices[std::size_t(i)]);
        put(wanted_normals, i, planes.normals[std::size_t(i)]);
        CHECK(offsets[std::size_t(i)] == planes.offsets[std::size_t(i)]);
      }
      CHECK(out == wanted);
      CHECK(normals == wanted_normals);
    }
  }
}

TEST_CASE("views that cannot be read are refused") {
  const Context context = make_context();
  hs_context* c = context.get();
  double numbers[6] = {0, 0, 1, 0, 0, 1};
  hs_shape* const sentinel = reinterpret_cast<hs_shape*>(0x10);
  hs_shape* shape = sentinel;
  const auto create = [&](hs_view v) { return [&, v] { return hs_polygon_create(c, v, &shape); }; };
  check_refusals(c, "hs_polygon_create",
                 {{"vertices.count", "-1", create({numbers, numbers + 1, nullptr, 16, -1})},
                  {"vertices.x", "NULL", create({nullptr, numbers + 1, nullptr, 16, 3})},
                  {"vertices.y", "NULL", create({numbers, nullptr, nullptr, 16, 3})},
                  {"vertices.stride", "12", create({numbers, numbers + 1, nullptr, 12, 3})},
                  {"vertices.stride", "-7", create({numbers, numbers + 1, nullptr, -7, 3})},
                  {"vertices.stride", "0", create({numbers, numbers + 1, nullptr, 0, 3})}});
  CHECK(shape == sentinel);

  const Shape triangle = make_shape(c, {{0, 0}, {1, 0}, {0, 1}});
  const auto get = [&](hs_mutable_view v) {
    return [&, v] { return hs_shape_get_vertices(triangle.get(), v, nullptr); };
  };
  const auto get_halfspaces = [&](hs_mutable_view v) {
    return [&, v] { return hs_shape_get_halfspaces(triangle.get(), v, nullptr, nullptr); };
  };
  check_refusals(c, "hs_shape_get_vertices",
                 {{"vertices.count", "-3", get({numbers, numbers + 1, nullptr, 16, -3})},
                  {"vertices.x", "NULL", get({nullptr, numbers + 1, nullptr, 16, 3})},
                  {"vertices.y", "NULL", get({numbers, nullptr, nullptr, 16, 3})},
                  {"vertices.stride", "4", get({numbers, numbers + 1, nullptr, 4, 3})}});
  check_refusals(c, "hs_shape_get_halfspaces",
                 {{"normals.count", "-3", get_halfspaces({numbers, numbers + 1, nullptr, 16, -3})},
                  {"normals.x", "NULL", get_halfspaces({nullptr, numbers + 1, nullptr, 16, 3})},
                  {"normals.y", "NULL", get_halfspaces({numbers, nullptr, nullptr, 16, 3})},
                  {"normals.stride", "0", get_halfspaces({numbers, numbers + 1, nullptr, 0, 3})}});
}

}  // namespace halfspace_test
