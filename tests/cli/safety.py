"""The factor of safety: a block on a plane, held by friction and by a bond, and what cannot be found."""
import math
import re

from command import SceneTest, main

SLOPE = """title = "A block on a plane"
dimension = 2

[world]
duration = 1
gravity = [0, -10]

[[material]]
name = "stone"
density = 2500
young_modulus = 1e10
poisson_ratio = 0.2

[[material]]
name = "ground"
density = 2500

[default_law]
stiffness = "per area"
normal_stiffness = 1e10
friction_angle = {friction}
{bond}
[[block]]
name = "plane"
kind = "fixed"
material = "ground"
vertices = [[-5, -1], [10, -1], [10, 0], [-5, 0]]
rotation = -{dip}
{body}
"""

RIGID = """
[[block]]
name = "block"
material = "stone"
kind = "{kind}"
vertices = [[0, 0], [5, 0], [5, 2], [0, 2]]
rotation = -{dip}
"""

MESH = """
[[mesh]]
name = "block"
material = "stone"
box = [[0, 0], [5, 2]]
cells = [5, 2]
cell = "quad"
rotation = -{dip}
"""

BOND = """
[[bond]]
between = ["stone", "ground"]
normal_stiffness = 1e9
cohesion = 1e4
residual_cohesion = 1e4
tensile_strength = 1e6
friction_angle = 30
"""


def scene_of(body, dip, friction=30, bond=""):
    return SLOPE.format(friction=friction, bond=bond, dip=dip, body=body.format(kind="rigid", dip=dip))


class Safety(SceneTest):
    def safety(self, text, *arguments, code=0):
        answer = self.run_scene(text, *arguments, code=code, command="safety")
        return answer.stdout + answer.stderr

    def factor(self, text):
        return float(re.search(r"factor of safety +([\d.]+), between", self.safety(text)).group(1))

    def test_friction_alone(self):
        # tan 30 over tan 20, within half of the resolution.
        wanted = math.tan(math.radians(30)) / math.tan(math.radians(20))
        self.assertAlmostEqual(self.factor(scene_of(RIGID, 20)), wanted, delta=0.003)
        self.assertRegex((self.output / "safety.txt").read_text(), r"what moves +1 of 2: block by")
        self.assertTrue((self.output / "falls.svg").exists())

    def test_cohesion_and_friction_of_all_kinds_of_block(self):
        # The joint is soft against the stone, so that it is pressed together everywhere, as the formula has it:
        # (c A + W cos a tan phi) / W sin a with c = 10 kPa, A = 5 m2, W = 250 kN, a = 35 degrees: 1.1732.
        for name, body in ("rigid", RIGID), ("affine", RIGID.replace('"{kind}"', '"affine"')), ("mesh", MESH):
            with self.subTest(kind=name):
                self.assertAlmostEqual(self.factor(scene_of(body, 35, bond=BOND)), 1.1732, delta=0.006)

    def test_what_is_not_found_is_told(self):
        self.assertIn("below 2: the scene falls even there", self.safety(scene_of(RIGID, 20), "--low", 2, code=1))
        self.assertIn("above 1.5: the scene stands even there", self.safety(scene_of(RIGID, 20), "--high", 1.5, code=1))
        sliding = scene_of(RIGID, 40).replace("duration = 1\n", "") + '[[stage]]\ndo = "settle"\nmost_steps = 2000\n'
        self.assertIn("not at rest", self.safety(sliding, code=1))
        self.assertIn("--low", self.safety(scene_of(RIGID, 20), "--low", 3, "--high", 2, code=2))

    def test_scenes_that_run_are_refused(self):
        text = scene_of(RIGID, 20).replace("duration = 1\n", "") + '[[stage]]\ndo = "run"\nduration = 1\n'
        self.assertIn("allowed: stages that settle", self.safety(text, code=1))


if __name__ == "__main__":
    main()
