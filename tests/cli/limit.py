"""Limits by bisection: tilts at which a block slides or topples, loads and numbers of a scene."""
import math
import re

from command import SceneTest, halfspace, main

BLOCK = """title = "A block on a plane"
dimension = {dimension}

[world]
duration = 1
gravity = {gravity}

[[material]]
name = "stone"
density = 2500
young_modulus = 1e9
poisson_ratio = 0

[default_law]
stiffness = "per area"
normal_stiffness = 1e9
friction_angle = {friction}
{blocks}
"""

IN_PLANE = """
[[block]]
name = "plane"
kind = "fixed"
material = "stone"
vertices = [[-5, -1], [10, -1], [10, 0], [-5, 0]]

[[block]]
name = "block"
material = "stone"
vertices = [[0, 0], [{width}, 0], [{width}, 2], [0, 2]]
"""

IN_SPACE = """
[[block]]
name = "plane"
kind = "fixed"
material = "stone"
vertices = [[-5, -5, -1], [5, -5, -1], [5, 5, -1], [-5, 5, -1], [-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0]]

[[block]]
name = "block"
material = "stone"
vertices = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0], [0, 0, 2], [2, 0, 2], [2, 1, 2], [0, 1, 2]]
"""

# A mesh on a plane is pushed along it by a traction on its left side.
PUSHED = """
[[block]]
name = "plane"
kind = "fixed"
material = "stone"
vertices = [[-5, -1], [10, -1], [10, 0], [-5, 0]]

[[mesh]]
name = "block"
material = "stone"
box = [[0, 0], [4, 1]]
cells = [4, 1]
cell = "quad"

[[mesh.load]]
box = [[0, 0], [0, 1]]
traction = [1e4, 0]
"""


def in_plane(width, friction):
    return BLOCK.format(dimension=2, gravity=[0, -10], friction=friction, blocks=IN_PLANE.format(width=width))


class Limit(SceneTest):
    def bracket(self, text, *arguments, code=0):
        """The stable and the falling end."""
        report = self.run_scene(text, *arguments, code=code, command="limit").stdout
        self.assertEqual((self.output / "limit.txt").read_text(), report)
        return [float(value) for value in re.search(r"between (\S+) \(stable\) and (\S+) \(falls\)", report).groups()]

    def assert_within(self, bracket, exact, slack=0.0):
        """The exact limit is in the bracket, to a slack for the springs."""
        self.assertGreater(exact, min(bracket) - slack)
        self.assertLess(exact, max(bracket) + slack)

    def test_a_wide_block_slides_at_its_friction_angle(self):
        bracket = self.bracket(in_plane(5, 30), "--tilt")
        self.assertAlmostEqual(bracket[1] - bracket[0], 90 / 1024, delta=1e-3)
        self.assert_within(bracket, 30)
        self.assertTrue((self.output / "falls.svg").exists())

    def test_a_slim_block_topples_at_its_slenderness(self):
        # The springs give by m g / (k b) = 5e-5 m, so that the pivot is that much within the base at most.
        self.assert_within(self.bracket(in_plane(1, 40), "--tilt"), math.degrees(math.atan(0.5)), slack=0.01)
        self.assert_within(self.bracket(in_plane(1, 40), "--tilt", "--axis=-z"), math.degrees(math.atan(0.5)), slack=0.01)

    def test_a_block_in_space_topples_over_its_shorter_side(self):
        text = BLOCK.format(dimension=3, gravity=[0, 0, -10], friction=50, blocks=IN_SPACE)
        self.assert_within(self.bracket(text, "--tilt"), math.degrees(math.atan(0.5)), slack=0.01)
        self.assert_within(self.bracket(text, "--tilt", "--axis", "y", "--low", 20), 45, slack=0.01)

    def test_the_smallest_friction_angle_that_holds(self):
        text = in_plane(5, 30).replace("[0, -10]", "[5, -8.660254037844387]")
        bracket = self.bracket(text, "--smallest", "--set", "default_law.friction_angle=5:60", "--resolution", 0.1)
        self.assertGreater(bracket[0], bracket[1])
        self.assert_within(bracket, 30)

    def test_the_largest_load(self):
        # It slides at 1e4 Pa m f = W tan 30 = 1e5 N/m * tan 30.
        text = BLOCK.format(dimension=2, gravity=[0, -10], friction=30, blocks=PUSHED)
        exact = 10 * math.tan(math.radians(30))
        for name in (), ("block",):
            self.assert_within(self.bracket(text, "--load", *name, "--resolution", 0.05), exact)
        answer = self.run_scene(text, "--load", "blok", code=1, command="limit")
        self.assertIn("no such load: \"blok\" (did you mean 'block'?)", answer.stderr)

    def test_resuming_takes_the_known_trials(self):
        text = in_plane(5, 30)
        report = self.run_scene(text, "--tilt", command="limit").stdout
        trials = self.output / "trials.csv"
        whole = trials.read_text()
        self.assertTrue(whole.splitlines()[1].startswith("degrees,"))
        trials.write_text("\n".join(whole.splitlines()[:6]) + "\n")
        self.scene.write_text(text)
        again = halfspace("limit", self.scene, "-o", self.output, "--tilt", "--resume")
        self.assertEqual((again.returncode, again.stdout), (0, report), again.stderr)
        self.assertEqual(trials.read_text(), whole)
        other = halfspace("limit", self.scene, "-o", self.output, "--tilt", "--axis=-z", "--resume")
        self.assertIn("cannot resume from", other.stderr)

    def test_what_is_not_found_and_wrong_usage(self):
        text = in_plane(5, 30)
        self.assertIn("above 20: the scene is stable there",
                      self.run_scene(text, "--tilt", "--high", 20, code=1, command="limit").stdout)
        self.assertIn("below 40: the scene falls there",
                      self.run_scene(text, "--tilt", "--low", 40, code=1, command="limit").stdout)
        for arguments, told in (((), "required: one of --tilt"), (("--tilt", "--load"), "required: one of --tilt"),
                                (("--tilt", "--low", 5, "--high", 4), "the low end must be below"),
                                (("--tilt", "--axis", "x"), "not an axis: x; allowed: z, -z"),
                                (("--load", "--axis", "x"), "only with --tilt")):
            with self.subTest(arguments=arguments):
                self.assertIn(told, self.run_scene(text, *arguments, code=2, command="limit").stderr)
        self.assertIn("out of range: 95", self.run_scene(text, "--set", "default_law.friction_angle=5:95", code=1,
                                                         command="limit").stderr)


if __name__ == "__main__":
    main()
