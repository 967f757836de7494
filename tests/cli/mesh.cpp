#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "blocks/mesh/convex_solid.h"
#include "blocks/mesh/gmsh.h"
#include "blocks/mesh/solid.h"
#include "blocks/mesh/surface.h"
#include "catch.h"
#include "mesh_texts.h"

using namespace halfspace::cli;

namespace {

double volume_of(const Context& context, const Solid& solid, double scale = 1) {
  return properties_of(context, make_convex(context, solid, scale).shape).volume;
}

/// The corners of a box of 2 x 1 x 1 and its twelve triangles, each corner written as often as it is used.
std::vector<Point> triangles_of_box() {
  static constexpr int quads[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                      {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  static constexpr Point corners[] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0},
                                      {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}};
  std::vector<Point> points;
  for (const auto& quad : quads) {
    for (int i : {0, 1, 2, 0, 2, 3}) points.push_back(corners[quad[i]]);
  }
  return points;
}

void append_bytes(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i & 255);
}

std::string binary_stl(const std::vector<Point>& corners) {
  std::string bytes = "solid in spite of this word a binary file";
  bytes.resize(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(corners.size() / 3), 4);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    for (int k = 0; k < 3; ++k) append_bytes(bytes, 0, 4);  // a normal that says nothing
    for (std::size_t k = i; k < i + 3; ++k) {
      for (double coordinate : corners[k])
        append_bytes(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)), 4);
    }
    append_bytes(bytes, 0, 2);
  }
  return bytes;
}

std::string text_stl(const std::vector<Point>& corners) {
  std::string text = "solid box\n";
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (std::size_t k = i; k < i + 3; ++k) {
      text += "   vertex";
      for (double coordinate : corners[k]) text += ' ' + std::to_string(coordinate);
      text += '\n';
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid box\n";
}

std::vector<Point> turned(std::vector<Point> points) {
  for (Point& p : points) {
    const double x = p[0], y = p[1];
    p[0] = std::cos(0.3) * x - std::sin(0.3) * y;
    p[1] = std::sin(0.3) * x + std::cos(0.3) * y;
  }
  return points;
}

}  // namespace

TEST_CASE("an OBJ file: looks and numbering forms are understood") {
  const Context context = make_context();
  const std::vector<Solid> solids = solids_of(read_obj("box.obj", mesh_texts::obj_box));
  REQUIRE(solids.size() == 1);
  CHECK(solids[0].vertices.size() == 8);
  CHECK(solids[0].faces.size() == 6);
  CHECK(solids[0].place == "box.obj:14");
  CHECK(volume_of(context, solids[0]) == Approx(2));
  CHECK(volume_of(context, solids[0], 0.5) == Approx(0.25));
}

TEST_CASE("an OFF file: counts on either line, and colours") {
  const Context context = make_context();
  for (const char* head : {"OFF\n# a comment\n4 4 6\n", "OFF 4 4 6\n"}) {
    const std::string text = std::string(head) +
                             "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                             "3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    const std::vector<Solid> solids = solids_of(read_off("t.off", text));
    REQUIRE(solids.size() == 1);
    CHECK(volume_of(context, solids[0]) == Approx(1.0 / 6));
  }
}

TEST_CASE("an STL file, text and binary: corners are welded, triangles of one plane are one face") {
  const Context context = make_context();
  for (const std::string& content : {text_stl(triangles_of_box()), binary_stl(triangles_of_box())}) {
    const std::vector<Solid> solids = solids_of(read_stl("box.stl", content));
    REQUIRE(solids.size() == 1);
    CHECK(solids[0].vertices.size() == 8);
    CHECK(solids[0].faces.size() == 12);
    const Shape shape = make_convex(context, solids[0], 1).shape;
    CHECK(properties_of(context, shape).volume == Approx(2));
    CHECK(properties_of(context, shape).face_count == 6);
    CHECK(vertices_of(context, shape).size() == 8);
  }
}

TEST_CASE("what single precision does to a turned box is no dent") {
  const Context context = make_context();
  const std::vector<Solid> solids = solids_of(read_stl("turned.stl", binary_stl(turned(triangles_of_box()))));
  REQUIRE(solids.size() == 1);
  // Each of eight corners is off by at most 2^-24, and the box has 10 m2 of faces.
  CHECK(std::abs(volume_of(context, solids[0]) - 2) < 10 * 0x1p-23);
}

TEST_CASE("each connected part of a surface is a solid, in the order of the file") {
  const Context context = make_context();
  const std::vector<Point> box = triangles_of_box();
  for (double shift : {2.0, 5.0}) {  // side by side with a whole face in common is one surface only if welded
    std::vector<Point> second = box;
    for (Point& p : second) p[2] += shift;
    const std::string text = text_stl(box) + text_stl(second);
    const std::vector<Solid> solids = solids_of(read_stl("two.stl", text));
    REQUIRE(solids.size() == 2);
    CHECK(solids[0].place == "two.stl:2");
    CHECK(solids[1].place == "two.stl:88");
    for (const Solid& solid : solids) CHECK(volume_of(context, solid) == Approx(2));
  }
}

TEST_CASE("objects that touch are apart: in OBJ by o, in STL by solid") {
  std::vector<Point> second = triangles_of_box();
  for (Point& p : second) p[2] += 1;  // on top: the faces between them coincide
  CHECK(solids_of(read_stl("two.stl", text_stl(triangles_of_box()) + text_stl(second))).size() == 2);
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string mirrored = "v 0 0 -1\no lower\nf 1 2 3\nf 1 5 2\nf 2 5 3\nf 3 5 1\n";
  CHECK(solids_of(read_obj("two.obj", vertices + "o upper\n" + faces + mirrored)).size() == 2);
}

TEST_CASE("a surface may be inside out as long as it is so throughout") {
  const Context context = make_context();
  std::vector<Point> corners = triangles_of_box();
  for (std::size_t i = 0; i < corners.size(); i += 3) std::swap(corners[i], corners[i + 1]);
  CHECK(volume_of(context, solids_of(read_stl("box.stl", text_stl(corners)))[0]) == Approx(2));
}

TEST_CASE("Gmsh meshes: elements with a volume are blocks, others are not") {
  const Context context = make_context();
  for (const char* text : {mesh_texts::gmsh_2, mesh_texts::gmsh_4}) {
    const std::vector<Solid> solids = solids_of(read_gmsh("mesh.msh", text));
    REQUIRE(solids.size() == 4);
    // A cube; beside it a prism, half a cube; on it a pyramid of height 1 and beside that a tetrahedron.
    const double volumes[] = {1, 0.5, 1.0 / 3, 1.0 / 6};
    const std::size_t face_counts[] = {6, 5, 5, 4};
    for (std::size_t i = 0; i < 4; ++i) {
      CAPTURE(i);
      CHECK(volume_of(context, solids[i]) == Approx(volumes[i]));
      CHECK(solids[i].faces.size() == face_counts[i]);
    }
  }
  CHECK(solids_of(read_gmsh("mesh.msh", mesh_texts::gmsh_2))[0].place == "mesh.msh:24");
  std::string parametric =
      mesh_texts::gmsh_2;  // with the nodes' places on curves and faces behind their coordinates
  parametric.replace(parametric.find("$Nodes"), 6, "$ParametricNodes");
  parametric.replace(parametric.find("$EndNodes"), 9, "$EndParametricNodes");
  CHECK(solids_of(read_gmsh("mesh.msh", parametric)).size() == 4);
}
