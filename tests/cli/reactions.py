"""Scenes whose bodies meet without a spring."""
import csv
import re

from command import SceneTest, halfspace, main

BARS = """title = "Two bars meet"
dimension = 2

[world]
gravity = [0, 0]
duration = 2e-3

[[material]]
name = "steel"
density = 1000
young_modulus = 1e9
poisson_ratio = 0

[default_law]
stiffness = "none"
{law}

[[mesh]]
name = "striker"
material = "steel"
box = [[-1.001, 0], [-0.001, 0.1]]
cells = [10, 1]
velocity = [1, 0]

[[mesh]]
name = "struck"
material = "steel"
box = [[0, 0], [1, 0.1]]
cells = [10, 1]

[output]
contacts = true
"""


BLOCKS = """title = "A block falls onto a plate"
dimension = 2

[world]
duration = 0.1
time_step = 1e-3

[[material]]
name = "stone"
density = 2500

[default_law]
stiffness = "none"

[[block]]
name = "falling"
material = "stone"
vertices = [[0, 0.01], [1, 0.01], [1, 1], [0, 1]]

[[block]]
name = "plate"
material = "stone"
kind = "fixed"
vertices = [[-2, -1], [3, -1], [3, 0], [-2, 0]]
"""


class Reactions(SceneTest):
    def test_bars_rebound_and_what_touches_took_is_told(self):
        told = self.run_scene(BARS.format(law="friction_angle = 20")).stdout
        touches = re.search(r"touches +(\d+) without a spring, impact loss (\S+) J", told)
        self.assertGreaterEqual(int(touches.group(1)), 2)
        self.assertAlmostEqual(float(touches.group(2)), 0.025 * 50, delta=1e-3)
        with open(self.output / "contacts.csv", newline="") as file:
            contacts = len(list(csv.DictReader(file)))
        self.assertGreater(contacts, 0)
        self.assertEqual(int(self.rows()[-1]["contacts"]), contacts)

    def test_a_law_without_a_spring_has_no_stiffness(self):
        self.check_fault(BARS.format(law="normal_stiffness = 1e9"), r"default_law\.normal_stiffness")
        self.check_fault(BARS.format(law="normal_damping = 0.1"), r"default_law\.normal_damping")

    def test_the_plan_names_them(self):
        self.scene.write_text(BLOCKS)
        answer = halfspace("plan", self.scene)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("springless contacts", answer.stdout)


if __name__ == "__main__":
    main()
