"""Stages that change contact laws: a box on a slope slides as the friction of each stage says."""
import math

from command import SceneTest, main

SCENE = """dimension = 2
[world]
gravity = [4.905, -8.495709]
time_step = 1e-4
[[material]]
name = "rock"
density = 2000
[[material]]
name = "ground"
density = 2000
[default_law]
stiffness = "{stiffness}"
{springs}
friction_angle = 40
{laws}
[[block]]
name = "slope"
material = "ground"
kind = "fixed"
vertices = [[-1, -1], [9, -1], [9, 0], [-1, 0]]
[[block]]
name = "box"
material = "rock"
vertices = [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]
[output]
history_interval = 0.05
tracked = [{{name = "toe", at = [1, 0.2]}}]
"""
SPRINGS = {"per area": "normal_stiffness = 1e9", "per contact": "normal_stiffness = 1e9", "none": ""}
RUN = '[[stage]]\ndo = "run"\nduration = 0.4\n'
OF_ALL = "[stage.default_law]\n"
OF_PAIR = '[[stage.law]]\nbetween = ["rock", "ground"]\n'


class StageLaws(SceneTest):
    def gains(self, stiffness, stages, laws="", **options):
        """What each stage adds to the speed down the slope, over g."""
        self.run_scene(SCENE.format(stiffness=stiffness, springs=SPRINGS[stiffness], laws=laws) + stages, **options)
        at_end = [0] + [max((row for row in self.rows() if row["stage"] == str(stage)),
                            key=lambda row: float(row["time"])) for stage in range(stages.count("[[stage]]"))]
        speeds = [0] + [float(row["toe.vx"]) for row in at_end[1:]]
        return [(after - before) / 0.4 / 9.81 for before, after in zip(speeds, speeds[1:])]

    def check_gains(self, gains, angles):
        self.assertEqual(len(gains), len(angles))
        for gain, angle in zip(gains, angles):
            # At 40 degrees the box is held, if it is at rest; springs take some time to give way.
            expected = 0 if angle == 40 else 0.5 - math.sqrt(0.75) * math.tan(math.radians(angle))
            self.assertAlmostEqual(gain, expected, delta=2e-3)

    def test_friction_changes_from_stage_to_stage(self):
        for stiffness in SPRINGS:
            for table in OF_ALL, OF_PAIR:
                with self.subTest(stiffness=stiffness, table=table):
                    stages = RUN + RUN + table + "friction_angle = 15\n" + RUN + RUN + table + "friction_angle = 0\n"
                    self.check_gains(self.gains(stiffness, stages), [40, 15, 15, 0])

    def test_a_pair_with_a_law_of_its_own_keeps_it(self):
        stages = RUN + OF_PAIR + "friction_angle = 15\n" + RUN + OF_ALL + "friction_angle = 0\n"
        self.check_gains(self.gains("per area", stages), [15, 15])
        given = '[[law]]\nbetween = ["ground", "rock"]\nfriction_angle = 20\n'
        self.check_gains(self.gains("per area", RUN + OF_ALL + "friction_angle = 0\n", given), [20])

    def test_values_that_are_not_given_stay(self):
        given = '[[law]]\nbetween = ["ground", "rock"]\nfriction_angle = 20\n'
        stages = RUN + OF_PAIR + "normal_stiffness = 2e9\n" + RUN + OF_PAIR + "friction_angle = 10\n"
        self.check_gains(self.gains("per area", stages, given), [20, 10])

    def test_another_stiffness_from_a_stage_on(self):
        stages = RUN + RUN + OF_ALL + 'stiffness = "none"\nfriction_angle = 10\n'
        self.check_gains(self.gains("per contact", stages), [40, 10])

    def test_a_run_resumes_with_the_laws_of_its_stage(self):
        stages = RUN + OF_PAIR + "friction_angle = 15\n" + RUN
        self.gains("per area", stages)
        whole, first = (self.output / "history.csv").read_bytes(), self.directory / "first"
        self.output.rename(first)
        self.gains("per area", stages, code=0)
        text = self.scene.read_text()
        self.run_scene(text, "--from", first / "stage_0.checkpoint")
        self.assertEqual((self.output / "history.csv").read_bytes(), whole)
        refused = self.run_scene(text.replace("angle = 15", "angle = 16"), "--from", first / "stage_0.checkpoint", code=1)
        self.assertIn("stage 0, which it had begun, differs", refused.stderr)

    def test_faults(self):
        text = SCENE.format(stiffness="per area", springs=SPRINGS["per area"], laws="") + RUN
        for table, fault in [
            (OF_ALL + "friction_angle = 95\n", r"stage\[0\]\.default_law\.friction_angle: out of range: 95"),
            (OF_ALL + "friction = 5\n", r"stage\[0\]\.default_law\.friction: unknown key"),
            (OF_ALL + 'stiffness = "per contact"\n', r"stage\[0\]\.default_law\.normal_stiffness: missing"),
            (OF_PAIR.replace("rock", "rok"), r'stage\[0\]\.law\[0\]\.between: no such material: "rok"'),
            (OF_PAIR + OF_PAIR, r'stage\[0\]\.law\[1\]\.between: a law between "rock" and "ground" was given before'),
        ]:
            self.check_fault(text + table, fault)


if __name__ == "__main__":
    main()
