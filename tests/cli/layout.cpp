#include "model/layout.h"

#include "catch.h"
#include "scene/read_scene.h"

using namespace halfspace::cli;

TEST_CASE("generators that make too many blocks together are told before any is made") {
  std::string scene =
      "dimension = 2\n[world]\nduration = 1\n[[material]]\nname = \"rock\"\ndensity = 1\n"
      "[default_law]\nstiffness = \"per contact\"\nnormal_stiffness = 1\n";
  for (const char* name : {"a", "b", "c"}) {
    scene += "[[triangulated]]\nname = \"" + std::string(name) +
             "\"\nmaterial = \"rock\"\nlower_left = [0, 0]\nupper_right = [1, 1]\ncount = 6000000\n";
  }
  const Context context = make_context();
  Faults faults;
  const Layout layout = lay_out_blocks(context, read_scene_text(scene, "scene.toml", faults), faults);
  CHECK(faults.describe("scene.toml") ==
        "scene.toml:17:8: triangulated[1].count: makes 12000000 blocks in all; allowed: at most 10000000\n");
  CHECK(layout.blocks.empty());
}

TEST_CASE("vertices in space beyond those of shapes are told at their place") {
  const std::string scene =
      "dimension = 3\n[world]\nduration = 1\n[[material]]\nname = \"rock\"\ndensity = 1\n"
      "[default_law]\nstiffness = \"per contact\"\nnormal_stiffness = 1\n"
      "[[block]]\nname = \"a\"\nmaterial = \"rock\"\n"
      "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1e80]]\n";
  const Context context = make_context();
  Faults faults;
  lay_out_blocks(context, read_scene_text(scene, "scene.toml", faults), faults);
  CHECK(
      faults.describe("scene.toml") ==
      "scene.toml:13:12: block[0].vertices: points[3] is (0, 0, 1e+80); it must be finite and at most 1e75; "
      "allowed: points that are not all in one plane\n");
}
