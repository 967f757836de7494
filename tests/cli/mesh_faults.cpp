#include <string>

#include "blocks/mesh/convex_solid.h"
#include "blocks/mesh/gmsh.h"
#include "blocks/mesh/mesh_fault.h"
#include "blocks/mesh/surface.h"
#include "catch.h"
#include "mesh_texts.h"

using namespace halfspace::cli;
using Catch::Matchers::StartsWith;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t place = text.find(what);
  REQUIRE(place != std::string::npos);
  return text.replace(place, what.size(), by);
}

void check_obj(const std::string& text, const std::string& fault) {
  CHECK_THROWS_WITH(solids_of(read_obj("a.obj", text)), StartsWith(fault));
}

void check_off(const std::string& text, const std::string& fault) {
  CHECK_THROWS_WITH(solids_of(read_off("a.off", text)), StartsWith(fault));
}

void check_stl(const std::string& text, const std::string& fault) {
  CHECK_THROWS_WITH(solids_of(read_stl("a.stl", text)), StartsWith(fault));
}

void check_gmsh(const std::string& text, const std::string& fault) {
  CHECK_THROWS_WITH(solids_of(read_gmsh("a.msh", text)), StartsWith(fault));
}

/// What is said when the solids of an OBJ file are made convex.
void check_convex(const std::string& text, const std::string& fault) {
  const Context context = make_context();
  CHECK_THROWS_WITH(make_convex(context, solids_of(read_obj("a.obj", text)).at(0), 1), StartsWith(fault));
}

}  // namespace

TEST_CASE("faults of an OBJ file carry its name and line") {
  const std::string box = mesh_texts::obj_box;
  check_obj(replaced(box, "v 2 1 0", "v 2 one 0"), "a.obj:6: not a finite number: \"one\"");
  check_obj(replaced(box, "v 2 1 0", "v 2 1"), "a.obj:6: the line is too short");
  check_obj(replaced(box, "v 2 1 0", "v 2 1 1e999"), "a.obj:6: not a finite number: \"1e999\"");
  check_obj(replaced(box, "f 3 4 8 7", "f 3 4 8 9"), "a.obj:18: no vertex 9; there are 8 before it");
  check_obj(replaced(box, "f 3 4 8 7", "f 3 4 8 0"), "a.obj:18: no vertex 0");
  check_obj(replaced(box, "f 3 4 8 7", "f 3 4"), "a.obj:18: a face of fewer than 3 vertices");
  check_obj(replaced(box, "usemtl", "curv"), "a.obj:13: unknown: \"curv\"");
  check_obj("v 0 0 0\n", "a.obj: no faces");
}

TEST_CASE("a file of no known kind is not read, should it be without end") {
  CHECK_THROWS_WITH(read_solids("/dev/zero"), StartsWith("zero: unknown file extension"));
}

TEST_CASE("coordinates beyond those of shapes are told with the solid") {
  const std::string far_off = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1e83\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  check_convex(far_off, "a.obj:5: vertices[3] = (0, 0, 1e+83) is not finite, or beyond 1e50");
}

TEST_CASE("a surface that is not closed is told by the edge") {
  const std::string box = mesh_texts::obj_box;
  check_obj(replaced(box, "f 3 4 8 7\n", ""),
            "a.obj:17: the edge from [2, 1, 0] to [2, 1, 1] has no face on");
  check_obj(replaced(box, "f 3 4 8 7", "f 7 8 4 3"),
            "a.obj:18: the edge from [2, 1, 0] to [2, 1, 1] is used twice in the same direction");
}

TEST_CASE("faults of an OFF file carry its name and line") {
  check_off("COFF\n", "a.off:1: not an OFF file");
  check_off("", "a.off:0: the file ends here; expected: OFF");
  check_off("OFF\n4 4 6\n0 0 0\n", "a.off:3: the file ends here; expected: vertex 1 of 4");
  check_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
            "a.off:6: no vertex 3; there are 3, counted from 0");
  check_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "a.off:6: a face of fewer than 3 vertices");
  check_off("OFF\n99999999999 1 0\n", "a.off:2: not a count that the file could hold");
  check_off("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off:6: more than the 0 faces announced");
}

TEST_CASE("faults of an STL file carry its name and line, or triangle") {
  const std::string facet =
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  check_stl("facets\n", "a.stl:1: expected: \"solid\"");
  check_stl("solid\n" + facet, "a.stl:8: the file ends here; expected: facet or endsolid");
  check_stl("solid\n" + replaced(facet, "vertex 0 1 0\n", "") + "endsolid\n",
            "a.stl:6: expected: \"vertex\"");
  check_stl("solid\n" + replaced(facet, "vertex 0 1 0", "vertex 1 0 0") + "endsolid\n",
            "a.stl:2: a triangle with two corners at the same place");
  check_stl("solid\n" + facet + "endsolid\n", "a.stl:2: the edge from [0, 0, 0] to [1, 0, 0] has no face");
  std::string binary(84 + 50, '\0');
  binary[80] = 1;
  check_stl(binary, "a.stl: triangle 1: a triangle with two corners at the same place");
  binary[98] = '\x80';  // with the next byte an infinite number
  binary[99] = '\x7f';
  check_stl(binary, "a.stl: triangle 1: a coordinate that is not finite");
}

TEST_CASE("faults of a Gmsh file carry its name and line") {
  const std::string mesh = mesh_texts::gmsh_2;
  check_gmsh("OFF\n", "a.msh:1: not a Gmsh file");
  check_gmsh(replaced(mesh, "2.2 0 8", "3.0 0 8"), "a.msh:2: version 3.0; allowed: 2.2 and 4.1");
  check_gmsh(replaced(mesh, "2.2 0 8", "2.2 1 8"), "a.msh:2: a binary file");
  check_gmsh(replaced(mesh, "\n5 4 2", "\n5 11 2"), "a.msh:28: an element of type 11");
  check_gmsh(replaced(mesh, "6 10 7 20", "6 10 7 21"), "a.msh:28: no node 21");
  check_gmsh(replaced(mesh, "\n20 0.5", "\n10 0.5"), "a.msh:20: node 10 is defined twice");
  check_gmsh(replaced(mesh, "\n11\n", "\n10\n"), "a.msh:20: expected: $EndNodes");
  check_gmsh(replaced(mesh, "\n11\n", "\n12\n"), "a.msh:21: not a whole number: \"$EndNodes\"");
  check_gmsh("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "a.msh: no element with a volume");
}

TEST_CASE("a solid that is not convex is named by its deepest dent") {
  // A box whose upper face is folded inwards along its diagonal, by a corner pushed down.
  const std::string folded =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 0.75\nv 0 1 1\n"
      "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const Context context = make_context();
  const std::string with_ridge = folded + "f 5 6 8\nf 6 7 8\n", with_valley = folded + "f 5 6 7\nf 5 7 8\n";
  CHECK(properties_of(context, make_convex(context, solids_of(read_obj("a.obj", with_ridge)).at(0), 1).shape)
            .volume == Approx(1 - 0.25 / 6));
  check_convex(with_valley, "a.obj:9: not convex: a dent ");
}

TEST_CASE("a dent is a fault where it is deeper than the last digit of the file") {
  // Two tetrahedra back to back whose common plane is pushed in: a corner 1e-4 of the size inside the hull.
  const std::string dented =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.3 0.3 0.00010"
      "\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 5 2\nf 2 5 3\nf 3 5 1\n";
  check_convex(dented,
               "a.obj:6: not convex: a dent 0.0001 m deep at [0.3, 0.3, 1e-04]; allowed: dents up to the "
               "tolerance, 2e-05 m; tolerance = ");
  const Context context = make_context();
  const std::string of_four_decimals = replaced(dented, "0.00010", "0.0001");
  const ConvexSolid made = make_convex(context, solids_of(read_obj("a.obj", of_four_decimals)).at(0), 1);
  CHECK(properties_of(context, made.shape).face_count == 4);
  CHECK(made.report.merged == 2);
  CHECK_THROWS_WITH(make_convex(context, solids_of(read_obj("a.obj", of_four_decimals)).at(0), 1, 1e-5),
                    StartsWith("a.obj:6: not convex: a dent 0.0001 m deep"));
}

TEST_CASE("a solid without volume, or folded onto itself, is refused") {
  check_convex("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n", "a.obj:4: ");
  // A cup without thickness: the box without its lid, from outside and from inside.
  const std::string cup =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
      "f 12 9 10 11\nf 9 5 6 10\nf 10 6 7 11\nf 11 7 8 12\nf 12 8 5 9\n";
  check_convex(cup, "a.obj:9: a surface folded onto itself");
}
