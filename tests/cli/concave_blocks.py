"""Concave blocks of scenes: a concave polygon, and the solids of a file that are joined, each as one rigid body."""
import math

from command import SceneTest, main

GRAVITY = 9.81

PLANE = """
dimension = 2
[world]
duration = 0.5
time_step = 1e-3
{world}
[[material]]
name = "stone"
density = 2000
[default_law]
stiffness = "{law}"
{springs}
friction_angle = 40
[[block]]
name = "hook"
material = "stone"
kind = "{kind}"
vertices = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2]]
shift = [0, 5]
{motion}
[output]
tracked = ["hook.0", "hook.1"]
"""

# Two boxes that share a face: the L of the plane, 1 deep.
SOLIDS = """
v 0 0 0
v 3 0 0
v 3 1 0
v 0 1 0
v 0 0 1
v 3 0 1
v 3 1 1
v 0 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
v 0 0 2
v 1 0 2
v 1 1 2
v 0 1 2
f 12 11 10 9
f 13 14 15 16
f 9 10 14 13
f 10 11 15 14
f 11 12 16 15
f 12 9 13 16
"""

SPACE = """
dimension = 3
[world]
duration = 0.5
time_step = 1e-3
[[material]]
name = "stone"
density = 2000
[default_law]
stiffness = "per area"
normal_stiffness = 1e8
[[block]]
name = "hook"
material = "stone"
kind = "{kind}"
file = "hook.obj"
joined = true
shift = [0, 0, 5]
velocity = [0, 0, 2]
angular_velocity = [0, 90, 0]
[output]
tracked = ["hook.0", "hook.1"]
"""


class ConcaveBlocks(SceneTest):
    def plane(self, kind="rigid", law="per area", world="", motion=""):
        springs = "" if law == "none" else "normal_stiffness = 1e8"
        return PLANE.format(kind=kind, law=law, springs=springs, world=world, motion=motion)

    def test_parts_of_a_polygon_stay_together(self):
        for law in ("per area", "per contact", "potential", "none"):
            answer = self.run_scene(self.plane(law=law, motion="velocity = [1, 2]\nangular_velocity = 180"))
            self.assertIn("2 of them parts of 1 concave block", answer.stdout)
            first, last = self.rows()[0], self.rows()[-1]
            centre = [1.25 + 0.5, 0.75 + 5 + 2 * 0.5 - GRAVITY * 0.125]
            for row, turned, middle in ((first, 0, (1.25, 5.75)), (last, math.pi / 2, centre)):
                # The parts are a trapezoid above the diagonal from the reflex corner, and one below it.
                places = [[float(row[f"hook.{i}.{axis}"]) for axis in "xy"] for i in (0, 1)]
                areas = (1.5, 2.5)
                for axis in (0, 1):
                    mean = sum(area * place[axis] for area, place in zip(areas, places)) / 4
                    self.assertAlmostEqual(mean, middle[axis], delta=1e-9, msg=f"{law}, turned by {turned}")

    def test_solids_of_a_file_are_one_block(self):
        (self.directory / "hook.obj").write_text(SOLIDS)
        self.run_scene(SPACE.format(kind="rigid"))
        row = self.rows()[-1]
        places = [[float(row[f"hook.{i}.{axis}"]) for axis in "xyz"] for i in (0, 1)]
        mean = [(3 * a + b) / 4 for a, b in zip(*places)]
        for value, expected in zip(mean, (1.25, 0.5, 0.75 + 5 + 2 * 0.5 - GRAVITY * 0.125)):
            self.assertAlmostEqual(value, expected, delta=1e-9)
        # Turned by 45 degrees about y, so that x goes towards -z.
        apart = [b - a for a, b in zip(*places)]
        half = math.sqrt(0.5)
        for value, expected in zip(apart, (half * (-1 + 1), 0, half * (1 + 1))):
            self.assertAlmostEqual(value, expected, delta=1e-9)

    def test_a_prescribed_polygon_moves_and_stops(self):
        self.run_scene(self.plane(kind="prescribed", motion="velocity = [2, 0]\nstop = 0.25"))
        rows = self.rows()
        for part in ("hook.0", "hook.1"):
            moved = float(rows[-1][f"{part}.x"]) - float(rows[0][f"{part}.x"])
            self.assertAlmostEqual(moved, 0.5, delta=1e-12)

    def test_an_excavated_part_takes_the_whole_block(self):
        for name in ("hook", "hook.1"):
            stage = f'[[stage]]\ndo = "run"\nduration = 0.1\nexcavate = ["{name}"]\n'
            text = self.plane().replace("duration = 0.5\n", "")
            floor = '[[block]]\nname = "floor"\nmaterial = "stone"\nvertices = [[0, -1], [3, -1], [3, 0], [0, 0]]\n'
            text = text.replace("[output]", floor + stage + "[output]")
            answer = self.run_scene(text)
            self.assertIn("2 of them excavated", answer.stdout)

    def test_no_joint_between_parts_of_a_block(self):
        joint = 'joints = [{name = "j", blocks = ["hook.0", "hook.1"]}]\n'
        self.check_fault(self.plane() + joint, r'"hook\.0" and "hook\.1" never touch; allowed: .*concave block')
        at = 'joints = [{name = "j", at = [0.5, 5.5]}]\n'
        self.check_fault(self.plane() + at, "no two blocks that can touch each other")

    def test_a_concave_block_that_strains_is_a_fault(self):
        elastic = "density = 2000\nyoung_modulus = 1e9\npoisson_ratio = 0.2"
        text = self.plane(kind="affine").replace("density = 2000", elastic)
        self.check_fault(text, r"block\[0\].vertices: vertex 3 \[1, 1\]: a reflex corner; allowed: ")
        (self.directory / "hook.obj").write_text(SOLIDS)
        text = SPACE.format(kind="affine").replace("density = 2000", elastic)
        self.check_fault(text, r"block\[0\].joined: joined solids do not strain; allowed: ")

    def test_an_outline_that_touches_itself_is_a_fault_with_its_place(self):
        hook = "vertices = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2]]"
        for outline, fault in (
                ("[0, 0], [2, 0], [1, 1], [2, 2], [0, 2], [1, 1]", r"vertex 2 \[1, 1\]: touches vertex 5 \[1, 1\]"),
                ("[0, 0], [4, 0], [4, 3], [2, 0], [0, 3]", r"vertex 3 \[2, 0\]: touches the edge from vertex 0"),
                ("[0, 0], [2, 2], [2, 0], [0, 2]", r"vertex 0 \[0, 0\]: the edge to vertex 1 \[2, 2\] crosses the edge"),
                ("[0, 0], [3, 0], [1, 1], [1, 3], [1, 1]", r"vertex 3 \[1, 3\]: the outline turns back on itself")):
            text = self.plane().replace(hook, f"vertices = [{outline}]")
            self.check_fault(text, r"block\[0\].vertices: " + fault + ".*; allowed: ")

    def test_straight_corners_are_left_out(self):
        for outline, parts in (("[0, 0], [1, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2], [0, 1]", 2),
                               ("[0, 0], [1, 0], [2, 0], [2, 2], [1, 2], [0, 2]", 1)):
            text = self.plane().replace("[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2]", outline)
            answer = self.run_scene(text.replace('tracked = ["hook.0", "hook.1"]', ""))
            self.assertRegex(answer.stdout, rf"blocks +{parts} \({parts} rigid")

    def test_joined_solids_that_overlap_are_a_fault(self):
        base, lowered = "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n", "v 0 0 0.5\nv 1 0 0.5\nv 1 1 0.5\nv 0 1 0.5\n"
        (self.directory / "hook.obj").write_text(SOLIDS.replace(base, lowered))
        self.check_fault(SPACE.format(kind="rigid"), r"block\[0\].*overlap by 0.5")


if __name__ == "__main__":
    main()
