"""Scenes in stages: a wall of bonded blocks settles, is shaken, and breaks."""
import re

from command import SceneTest, main

WALL = """title = "A wall that is shaken"
dimension = 2

[world]

[[material]]
name = "stone"
density = 2400

[[material]]
name = "ground"
density = 2400

[default_law]
stiffness = "per area"
normal_stiffness = 1e9
friction_angle = 35

[[bond]]
between = ["stone", "stone"]
normal_stiffness = 2e9
tensile_strength = {strength}
cohesion = 5e6
friction_angle = 35

[[block]]
name = "floor"
material = "ground"
kind = "fixed"
vertices = [[-6, -1], [6, -1], [6, 0], [-6, 0]]

[[block]]
name = "lower"
material = "stone"
vertices = [[-0.5, 0], [0.5, 0], [0.5, 1], [-0.5, 1]]

[[block]]
name = "upper"
material = "stone"
vertices = [[-0.5, 1], [0.5, 1], [0.5, 4], [-0.5, 4]]

[[stage]]
name = "settling"
do = "settle"

[[stage]]
name = "shaking"
do = "run"
duration = 0.3
gravity = [12.0, -9.81]
"""


class Stages(SceneTest):
    def test_each_stage_is_told_and_the_bond_fails_where_it_must(self):
        told = self.run_scene(WALL.format(strength=1e3)).stdout
        self.assertRegex(told, r"stage settling +settled until \S+ s, at rest after \d+ steps, unbalanced by")
        self.assertRegex(told, r"stage shaking +ran until \S+ s\n")
        self.assertRegex(told, r"bonds +1 made, \d have come apart; cracks of \S+ m took \S+ J")
        held = self.run_scene(WALL.format(strength=1e7)).stdout
        self.assertRegex(held, r"bonds +1 made, 0 have come apart; cracks of 0 m\n")

    def test_what_does_not_come_to_rest_is_told(self):
        text = WALL.format(strength=1e7).replace('do = "settle"', 'do = "settle"\nmost_steps = 20')
        self.assertRegex(self.run_scene(text).stdout, r"stage settling +settled until \S+ s, NOT AT REST after 20 steps")

    def test_a_run_stage_lasts_as_long_as_it_says(self):
        told = self.run_scene(WALL.format(strength=1e7)).stdout
        begin, end = (float(re.search(rf"stage {name} +\w+ until (\S+) s", told).group(1))
                      for name in ("settling", "shaking"))
        self.assertAlmostEqual(end - begin, 0.3, delta=2e-3)

    def test_faults_name_their_key(self):
        whole = WALL.format(strength=1)
        for old, new, fault in [
            ('do = "run"', 'do = "walk"', r'stage\[1\]\.do'),
            ("duration = 0.3\n", "", r"stage\[1\]\.duration"),
            ("cohesion = 5e6", "cohesion = 5e6\nresidual_cohesion = 6e6", r"bond\[0\]\.residual_cohesion"),
            ('between = ["stone", "stone"]', 'between = ["stone", "stoen"]', r"bond\[0\]\.between"),
            ("[world]\n", "[world]\nrest_speed = 1\n", r"world\.rest_speed"),
        ]:
            self.check_fault(whole.replace(old, new, 1), fault)


if __name__ == "__main__":
    main()
