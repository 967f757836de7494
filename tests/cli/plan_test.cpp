#include "plan.h"

#include "catch.h"
#include "read_scene.h"

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
  const Plan plan = plan_blocks(context, read_scene_text(scene, "scene.toml", faults), faults);
  CHECK(faults.describe("scene.toml") ==
        "scene.toml:17:8: triangulated[1].count: makes 12000000 blocks in all; allowed: at most 10000000\n");
  CHECK(plan.blocks.empty());
}
