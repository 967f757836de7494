"""Limits by bisection: tilts at which a block slides or topples, loads and numbers of a scene."""
import math
import re

from command import SCENES, SceneTest, halfspace, main

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
{law}
friction_angle = {friction}
{blocks}
"""

PER_AREA = 'stiffness = "per area"\nnormal_stiffness = 1e9'
WITHOUT_SPRINGS = 'stiffness = "none"'
STEP = ("--set", "world.time_step=0.01")  # which these require

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


def in_plane(width, friction, law=PER_AREA):
    return BLOCK.format(dimension=2, gravity=[0, -10], law=law, friction=friction, blocks=IN_PLANE.format(width=width))


class Limit(SceneTest):
    def bracket(self, text, *arguments, code=0):
        """The stable and the falling end."""
        report = self.run_scene(text, *arguments, code=code, command="limit").stdout
        self.assertEqual((self.output / "limit.txt").read_text(), report)
        return [float(value) for value in re.search(r"between (\S+) \(stable\) and (\S+) \(falls\)", report).groups()]

    def assert_within(self, bracket, exact):
        self.assertGreater(exact, min(bracket))
        self.assertLess(exact, max(bracket))

    def test_a_wide_block_slides_at_its_friction_angle(self):
        bracket = self.bracket(in_plane(5, 30), "--tilt")
        self.assertAlmostEqual(bracket[1] - bracket[0], 90 / 1024, delta=1e-3)
        self.assert_within(bracket, 30)
        self.assertTrue((self.output / "falls.svg").exists())

    def test_a_slim_block_topples_at_its_slenderness(self):
        for axis in "z", "-z":
            bracket = self.bracket(in_plane(1, 40, WITHOUT_SPRINGS), "--tilt", f"--axis={axis}", "--resolution", 0.1, *STEP)
            self.assert_within(bracket, math.degrees(math.atan(0.5)))

    def test_springs_let_it_topple_earlier(self):
        # On an elastic bed a width x of the base is pressed, under N = W cos a: the base turns by 2 N / (k x^2), and
        # the resultant is x / 3 from the edge. The largest tan a = (b/2 - x/3) / (h/2) - 2 N / (k x^2) is at
        # x^3 = 12 N / k for h = 2 m.
        angle = 0.4
        for _ in range(50):
            force = 2500 * 2 * 10 * math.cos(angle)
            x = (12 * force / 1e9) ** (1 / 3)
            angle = math.atan(0.5 - x / 3 - 2 * force / (1e9 * x**2))
        bracket = self.bracket(in_plane(1, 40), "--tilt", "--limit", 0.2)
        self.assertAlmostEqual(sum(bracket) / 2, math.degrees(angle), delta=0.1)

    def test_a_wedge_that_locks_after_centimetres_has_failed(self):
        """Forces on both planes over the weight, by equilibrium: 0.4667 and 0.1644, and 0.8509 along their line. The
        law of one plane has 30 degrees. With too little friction the wedge slides by a hundredth of its size."""
        exact = math.degrees(math.atan((0.85093 - 0.16439 * math.tan(math.radians(30))) / 0.46674))
        bracket = self.bracket((SCENES / "wedge.toml").read_text(), "--smallest", "--resolution", 0.2,
                               "--set", "default_law.friction_angle=40:75")
        self.assertAlmostEqual(sum(bracket) / 2, exact, delta=0.3)

    def test_the_tilt_of_an_arch_does_not_depend_on_the_time_step(self):
        """Limit analysis by linear programming: 9.506 degrees. One step of 0.02 s gives 9.30."""
        for time_step in 0.02, 0.01, 0.005:
            text = (SCENES / "pointed_arch.toml").read_text().replace("time_step = 0.01", f"time_step = {time_step}")
            bracket = self.bracket(text, "--tilt", "--low", 5, "--high", 12, "--resolution", 0.02)
            self.assertAlmostEqual(sum(bracket) / 2, 9.506, delta=0.02)
            self.assertRegex((self.output / "limit.txt").read_text(),
                             rf"time step +halved until the result stays within 0\.02: \S+ at {time_step:g} s, \S+ at")

    def test_a_block_in_space_topples_over_its_shorter_side(self):
        text = BLOCK.format(dimension=3, gravity=[0, 0, -10], law=WITHOUT_SPRINGS, friction=50, blocks=IN_SPACE)
        self.assert_within(self.bracket(text, "--tilt", "--resolution", 0.1, *STEP), math.degrees(math.atan(0.5)))
        self.assert_within(self.bracket(text, "--tilt", "--axis", "y", "--high", 89, "--resolution", 0.1, *STEP), 45)

    def test_the_smallest_friction_angle_that_holds(self):
        text = in_plane(5, 30).replace("[0, -10]", "[5, -8.660254037844387]")
        bracket = self.bracket(text, "--smallest", "--set", "default_law.friction_angle=5:60", "--resolution", 0.1)
        self.assertGreater(bracket[0], bracket[1])
        self.assert_within(bracket, 30)

    def test_the_largest_load(self):
        # It slides at 1e4 Pa m f = W tan 30 = 1e5 N/m * tan 30.
        text = BLOCK.format(dimension=2, gravity=[0, -10], law=PER_AREA, friction=30, blocks=PUSHED)
        exact = 10 * math.tan(math.radians(30))
        for name in (), ("block",):
            self.assert_within(self.bracket(text, "--load", *name, "--resolution", 0.05), exact)
        answer = self.run_scene(text, "--load", "blok", code=1, command="limit")
        self.assertIn("no such load: \"blok\" (did you mean 'block'?)", answer.stderr)

    def test_the_last_stage_runs(self):
        """Pushed for 2 s, the block slides by more than 1 cm if its friction is below 0.3 - 2 s / g t^2; the springs
        oscillate as the push begins, and give some of that."""
        run = '\n[[stage]]\ndo = "settle"\n[[stage]]\nname = "push"\ndo = "run"\nduration = 2\n'
        push = in_plane(5, 30).replace("duration = 1\n", "") + run + "gravity = [3, -10]\n"
        needed = 0.3 - 2 * 0.01 / (4 * 10)
        arguments = "--limit", 0.01
        report = self.run_scene(push, *arguments, command="safety").stdout
        self.assertIn("each trial          the last stage, 2 s\n", report)
        found = float(re.search(r"factor of safety +(\S+),", report)[1])
        self.assertAlmostEqual(found, math.tan(math.radians(30)) / needed, delta=0.01)
        friction = self.bracket(push, *arguments, "--smallest", "--set", "default_law.friction_angle=5:40")
        self.assertAlmostEqual(sum(friction) / 2, math.degrees(math.atan(needed)), delta=0.1)
        # Gravity has its angle already, the turn is added; also while it changes to a larger one.
        tilt = self.bracket(push, *arguments, "--tilt")
        self.assertAlmostEqual(sum(tilt) / 2, 30 - math.degrees(math.atan(0.3)), delta=0.1)
        ramped = push.replace("gravity = [3, -10]", "gravity = [0, -12]\nramp = 0.5")
        self.assertAlmostEqual(sum(self.bracket(ramped, *arguments, "--tilt")) / 2, 30, delta=0.1)

    def test_blocks_that_ride_on_the_ground_have_not_moved(self):
        """The ground is accelerated by 0.3 g to the left, which is a push to the right; within 2 s it moves by 6 m."""
        text = in_plane(5, 30).replace("duration = 1\n", "").replace('kind = "fixed"', 'kind = "prescribed"')
        shaken = text + """
[[stage]]
do = "settle"
[[stage]]
name = "earthquake"
do = "run"
duration = 2
[[action]]
on = "plane"
kind = "acceleration"
table = [[0, -3]]
direction = [1, 0]
stage = "earthquake"
"""
        report = self.run_scene(shaken, "--limit", 0.01, command="safety").stdout
        found = float(re.search(r"factor of safety +(\S+),", report)[1])
        self.assertAlmostEqual(found, math.tan(math.radians(30)) / (0.3 - 2 * 0.01 / (4 * 10)), delta=0.01)

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
