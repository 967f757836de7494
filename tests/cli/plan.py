"""`halfspace plan`: what a scene makes the library compute, and what could be left out."""
import re

from command import EXAMPLES, SceneTest, halfspace, main

SLIDE = (EXAMPLES / "trade" / "slide.toml").read_text()

FALLING = """
dimension = 2
[world]
duration = 0.1
local_damping = {local_damping}
[[material]]
name = "stone"
density = 2500
young_modulus = 1e12
poisson_ratio = 0.2
[default_law]
stiffness = "per area"
normal_stiffness = 1e9
normal_damping = 0
shear_damping = 0
[[block]]
name = "falling"
material = "stone"
kind = "affine"
vertices = [[0, 1], [1, 1], [1, 2], [0, 2]]
"""

BEAM = """
dimension = 2
[world]
duration = 0.01
[[material]]
name = "steel"
density = 2000
young_modulus = 1e9
poisson_ratio = 0.25
[default_law]
stiffness = "none"
[[mesh]]
name = "beam"
material = "steel"
box = [[0, 0], [4, 0.4]]
cells = [16, 2]
[[mesh.support]]
box = [[-0.01, -1], [0.01, 1]]
"""

# A block cut into cells is thrown and meets nothing: it moves as a rigid one does.
THROWN = BEAM[:BEAM.index("[[mesh]]")] + """[[block]]
name = "thrown"
material = "steel"
kind = "mesh"
cell_size = 0.3
vertices = [[0, 0], [1, 0], [1, 1], [0, 1]]
velocity = [1, 0]
"""

# Three bricks in a row are bonded to a wall, and would fall without that.
BONDED = """
dimension = 2
[world]
duration = 0.1
[[material]]
name = "stone"
density = 2500
[default_law]
stiffness = "per area"
normal_stiffness = 1e9
[[bond]]
between = ["stone", "stone"]
normal_stiffness = 1e10
tensile_strength = 1e9
cohesion = 1e9
""" + "".join(f"""[[block]]
name = "{name}"
material = "stone"
kind = "{kind}"
vertices = [[{x}, 0], [{x + 1}, 0], [{x + 1}, 0.5], [{x}, 0.5]]
""" for name, kind, x in (("wall", "fixed", -1), ("b0", "rigid", 0), ("b1", "rigid", 1), ("b2", "rigid", 2)))


class Plan(SceneTest):
    def plan(self, text, *options):
        self.scene.write_text(text)
        return halfspace("plan", self.scene, *options)

    def line(self, run, name):
        return re.search(rf"(?m)^{name}  +(.+)$", run.stdout)[1]

    def test_a_slide_needs_friction_and_hardly_damping(self):
        run = self.plan(SLIDE)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(self.line(run, "blocks"), "1 fixed, 1 rigid")
        self.assertEqual(self.line(run, "active"), "friction, damping of contacts")
        self.assertTrue(self.line(run, "stable step").endswith("limited by slider, at slope"))
        self.assertNotIn("can be left out", self.line(run, "friction"))
        self.assertIn("can be left out, within 1 %", self.line(run, "damping of contacts"))
        self.assertRegex(self.line(run, "moved by 1e-9"), r"^\d(e-\d\d|\.?\d*) % of its size, by chance$")

    def test_friction_without_springs_is_a_part_and_springs_do_not_rebound_by_a_restitution(self):
        rigid = (SLIDE.replace("[world]", "[world]\ntime_step = 0.01").replace("density", "young_modulus = 1e9\npoisson_ratio = 0.2\ndensity")
                 .replace('"per contact"\nnormal_stiffness = 1e8\nshear_stiffness = 1e8', '"none"\nrestitution = 0.5'))
        run = self.plan(rigid, "--time", "0.1")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(self.line(run, "active"), "friction, springless contacts")
        self.assertNotIn("can be left out", self.line(run, "friction"))
        self.assertRegex(run.stdout, r"(?m)^springless contacts ")

    def test_sleep_is_a_part_that_a_scene_may_do_without(self):
        run = self.plan(SLIDE.replace("[world]", "[world]\nsleep_tolerance = 1e-6"))
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(self.line(run, "active"), "friction, damping of contacts, sleep")
        self.assertIn("can be left out, within 1 %", self.line(run, "sleep"))

    def test_a_beam_of_elements(self):
        run = self.plan(BEAM)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(self.line(run, "meshes"), "1 body of 64 cells and 51 nodes")
        self.assertEqual(self.line(run, "active"), "strain, springless contacts")
        self.assertRegex(self.line(run, "memory"), r"^\d+ B per cell$")
        self.assertRegex(self.line(run, "stable step"), r"limited by beam\.\d+ as an element$")
        # It cannot do without strain, and nothing meets it.
        self.assertNotRegex(run.stdout, r"(?m)^strain ")
        self.assertIn("can be left out", self.line(run, "springless contacts"))

    def test_a_block_of_cells_can_do_without_them_where_nothing_strains_it(self):
        run = self.plan(THROWN)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertNotRegex(run.stdout, r"(?m)^strain  ")  # a rigid one without springs has no stable step
        run = self.plan(THROWN.replace('"none"', '"per area"\nnormal_stiffness = 1e9'))
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        for part in ("strain", "cells"):
            self.assertIn("can be left out", self.line(run, part + " "))
            self.assertRegex(self.line(run, part + " "), r" (0|\de-\d\d) % of its size")

    def test_stages_are_gone_through(self):
        stages = BEAM.replace("duration = 0.01", "") + """
[[stage]]
do = "settle"
name = "sag"
[[stage]]
do = "run"
duration = 0.01
gravity = [0, 0]
"""
        run = self.plan(stages)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(self.line(run, "meshes"), "1 body of 64 cells and 51 nodes")
        self.assertIn("can be left out", self.line(run, "springless contacts"))
        self.assertIn("allowed: no --time", self.plan(stages, "--time", "0.1").stderr)
        hasty = self.plan(stages.replace('"settle"', '"settle"\nmax_steps = 1'))
        self.assertEqual(hasty.returncode, 3, hasty.stdout)

    def test_bricks_fall_without_their_bonds(self):
        run = self.plan(BONDED)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertRegex(self.line(run, "stable step"), r"limited by b\d, bonded to (b\d|wall)$")
        self.assertNotIn("can be left out", self.line(run, "bonds  +-?[0-9.]+ %"))
        # They fall by g t^2 / 2 = 0.049 m, 8.8 % of half their diagonal.
        self.assertRegex(run.stdout, r"(?m)^bonds .* 9 % of its size$")

    def test_a_block_in_free_fall_needs_neither_strain_nor_areas(self):
        run = self.plan(FALLING.format(local_damping=0.5))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.line(run, "active"), "areas, strain, local damping")
        for part in ("areas", "strain"):
            self.assertIn("can be left out", self.line(run, part))
        # Without local damping of half its force it falls twice as far: by 0.0245 m more, 3.47 % of half its diagonal.
        self.assertRegex(self.line(run, "local damping"), r" 3 % of its size$")
        again = self.plan(FALLING.format(local_damping=0.5), "--tolerance", "0.1")
        self.assertIn("can be left out, within 10 %", self.line(again, "local damping"))

    def test_the_time_can_be_shorter(self):
        short = self.plan(SLIDE, "--time", "0.01")
        self.assertIn("can be left out", self.line(short, "friction"))

    def test_concave_blocks_and_actions_are_listed_and_can_be_left_out(self):
        angle = "vertices = [[0, 1], [2, 1], [2, 2], [1, 2], [1, 3], [0, 3]]"
        action = '\n[[action]]\non = "falling"\nkind = "force"\ntable = [[0, 0, 2500], [1, 0, 2500]]\n'
        text = FALLING.format(local_damping=0).replace("vertices = [[0, 1], [1, 1], [1, 2], [0, 2]]", angle + action)
        run = self.plan(text.replace('kind = "affine"\n', ""), "--time", "0.1")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(self.line(run, "concave blocks"), "1 of 2 convex parts")
        self.assertEqual(self.line(run, "actions"), "1")
        self.assertTrue(self.line(run, "active").endswith("actions"))
        # The force is a third of a metre per second squared, or 1.7 mm of a block of some 1.4 m in radius.
        self.assertRegex(run.stdout, r"(?m)^actions +-?[0-9.e-]+ % +0\.1 % of its size")

    def test_what_cannot_be_planned_says_why(self):
        run = self.plan(SLIDE.replace('name = "slider"', 'name = "slider"\nkind = "fixed"'))
        self.assertEqual(run.returncode, 1)
        self.assertIn("no free block; required for a plan", run.stderr)
        self.assertEqual(self.plan(SLIDE, "--time=-1").returncode, 2)
        hasty = self.plan(SLIDE, "--time", "1e-9")
        self.assertEqual(hasty.returncode, 1)
        self.assertIn("--time is too short", hasty.stderr)
        fast = self.plan(SLIDE.replace("[world]", '[world]\nfast_blocks = "refuse"\ngravity = [0, -1e9]'))
        self.assertEqual(fast.returncode, 3, fast.stdout)
        self.assertIn("does not run to its end", fast.stderr)


if __name__ == "__main__":
    main()
