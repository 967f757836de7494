"""Scenes in stages: a wall of bonded blocks settles, is shaken, and breaks."""
import re

from command import SceneTest, halfspace, main

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
        self.assertRegex(told, r"stage settling +settled until \S+ s, at rest after \d+ steps, unbalanced ratio")
        self.assertRegex(told, r"stage shaking +ran until \S+ s\n")
        self.assertRegex(told, r"bonds +1 made, \d broken; cracks of \S+ m, fracture energy \S+ J")
        held = self.run_scene(WALL.format(strength=1e7)).stdout
        self.assertRegex(held, r"bonds +1 made, 0 broken; cracks of 0 m\n")

    def test_what_does_not_come_to_rest_is_told(self):
        text = WALL.format(strength=1e7).replace('do = "settle"', 'do = "settle"\nmax_steps = 20')
        self.assertRegex(self.run_scene(text).stdout, r"stage settling +settled until \S+ s, NOT AT REST after 20 steps")

    def test_a_run_stage_lasts_as_long_as_it_says(self):
        told = self.run_scene(WALL.format(strength=1e7)).stdout
        begin, end = (float(re.search(rf"stage {name} +\w+ until (\S+) s", told).group(1))
                      for name in ("settling", "shaking"))
        self.assertAlmostEqual(end - begin, 0.3, delta=2e-3)

    def test_stages_end_at_their_times_whatever_the_step(self):
        given = WALL.format(strength=1e7).replace("[world]\n", "[world]\ntime_step = 1e-4\n")
        for text in (given, WALL.format(strength=1e7)):
            base = text[:text.index("[[stage]]")] + "[output]\nhistory_interval = 1\nframe_interval = 1\n"
            # Each is some steps and a half long, so that none would end at its time by whole steps, and the last ones
            # are shorter than any step.
            self.run_scene(base + '[[stage]]\ndo = "run"\nduration = 1.25e-3\n' * 40 +
                           '[[stage]]\ndo = "run"\nduration = 1e-7\n' * 3)
            self.assertAlmostEqual(float(self.rows()[-1]["time"]), 40 * 1.25e-3 + 3e-7, delta=1e-12)

    def test_a_step_that_is_shortened_is_not_told_as_the_step(self):
        text = WALL.format(strength=1e7).replace("[world]\n", "[world]\ntime_step = 1e-4\n")
        text = text[:text.index("[[stage]]")]
        told = self.run_scene(text + '[[stage]]\ndo = "run"\nduration = 1.23e-3\n').stdout
        self.assertRegex(told, r"simulated +0.00123 s in 13 steps of 0.0001 s")
        whole = self.run_scene(text + '[[stage]]\ndo = "run"\nduration = 0.3\n').stdout
        self.assertRegex(whole, r"simulated +0.3 s in 3000 steps of 0.0001 s")

    def test_what_settles_leaves_a_row_and_on_request_each_stage_a_picture(self):
        text = WALL.format(strength=1e7) + "[output]\nhistory_interval = 10\n"
        told = self.run_scene(text).stdout
        settled = float(re.search(r"stage settling +settled until (\S+) s", told).group(1))
        times = [float(row["time"]) for row in self.rows()]
        self.assertEqual(len(times), 3)
        self.assertAlmostEqual(times[1] / settled, 1, delta=1e-3)  # told with four digits
        self.assertAlmostEqual(times[2] - times[1], 0.3, delta=1e-9)
        self.assertEqual(list(self.output.glob("stage_*.svg")), [])
        self.run_scene(text + "[output.picture]\nstages = true\n")
        self.assertEqual(sorted(path.name for path in self.output.glob("stage_*.svg")), ["stage_0.svg", "stage_1.svg"])
        self.assertEqual((self.output / "stage_1.svg").read_text(), (self.output / "last.svg").read_text())
        self.assertNotEqual((self.output / "stage_0.svg").read_text(), (self.output / "last.svg").read_text())

    def test_rows_tell_their_stage_and_the_time_in_it(self):
        text = WALL.format(strength=1e7).replace('name = "shaking"', 'name = "shaking, \\"hard\\""')
        self.run_scene(text + '[output]\nhistory_interval = 0.1\n' + '[[stage]]\ndo = "run"\nduration = 0.1\n')
        rows = self.rows()
        names = [row["stage"] for row in rows]
        self.assertEqual(list(dict.fromkeys(names)), ["settling", 'shaking, "hard"', "2"])
        settled = float(rows[names.count("settling") - 1]["time"])
        starts = {"settling": 0, 'shaking, "hard"': settled, "2": settled + 0.3}
        for row in rows:
            self.assertAlmostEqual(float(row["stage_time"]), float(row["time"]) - starts[row["stage"]], delta=1e-9)

    def test_variants_start_from_the_checkpoint_of_a_stage(self):
        text = WALL.format(strength=1e7)
        self.run_scene(text)
        self.assertEqual(sorted(path.name for path in self.output.glob("*checkpoint")),
                         ["checkpoint", "stage_0.checkpoint", "stage_1.checkpoint"])
        settled = self.directory / "settled"
        self.output.rename(settled)
        variant = text.replace("gravity = [12.0, -9.81]", "gravity = [-5.0, -9.81]")
        self.run_scene(variant)
        whole = (self.output / "history.csv").read_bytes()
        self.run_scene(variant, "--from", settled / "stage_0.checkpoint")
        self.assertEqual((self.output / "history.csv").read_bytes(), whole)
        self.assertIn("stage 1, which it had begun, differs",
                      self.run_scene(variant, "--from", settled / "stage_1.checkpoint", code=1).stderr)
        self.assertIn("its blocks differ", self.run_scene(
            variant.replace("[0.5, 4]", "[0.5, 5]"), "--from", settled / "stage_0.checkpoint", code=1).stderr)
        shorter = text[:text.index('[[stage]]\nname = "shaking"')]
        self.scene.write_text(shorter)
        self.assertEqual(halfspace("run", self.scene, "-o", settled, "--from", settled / "stage_0.checkpoint").returncode, 0)
        self.assertFalse((settled / "stage_1.checkpoint").exists())

    def test_what_stands_on_a_support_that_moves_is_told_early(self):
        text = WALL.format(strength=1e7).replace('kind = "fixed"', 'kind = "prescribed"\nangular_velocity = 9')
        told = self.run_scene(text).stdout
        steps = re.search(r'NOT AT REST after (\d+) steps, .*; "floor" never stops; give it a stop', told).group(1)
        self.assertLessEqual(int(steps), 20000)
        stopping = text.replace("angular_velocity = 9", "velocity = [0, 0.1]\nstop = 0.05")
        self.assertRegex(self.run_scene(stopping).stdout, r"stage settling +settled until \S+ s, at rest after")

    def test_pictures_are_told_as_late_where_that_is_known(self):
        picture = "[output.picture]\ntimes = [0.1, {}]\n"
        settling = WALL.format(strength=1e7)
        late = self.run_scene(settling + picture.format(1e6))
        self.assertNotIn("picture is not drawn", late.stderr)  # before it has settled, the end is unknown
        self.assertRegex(late.stdout, r"pictures +none at 1e\+06 s, after the end of the run\n")
        self.assertNotIn("pictures  ", self.run_scene(settling + picture.format(0.3)).stdout)  # settling takes time, too
        self.assertTrue((self.output / "at_0.3s.svg").exists())
        known = settling.replace('do = "settle"', 'do = "run"\nduration = 0.1')
        self.assertIn("5 s is after the end of the run, 0.4 s", self.run_scene(known + picture.format(5)).stderr)

    def test_faults_name_their_key(self):
        whole = WALL.format(strength=1)
        for old, new, fault in [
            ('do = "run"', 'do = "walk"', r'stage\[1\]\.do'),
            ("duration = 0.3\n", "", r"stage\[1\]\.duration"),
            ("cohesion = 5e6", "cohesion = 5e6\nresidual_cohesion = 6e6", r"bond\[0\]\.residual_cohesion"),
            ('between = ["stone", "stone"]', 'between = ["stone", "stoen"]', r"bond\[0\]\.between"),
            ("[world]\n", "[world]\nrest_speed = 1\n", r"world\.rest_speed: not allowed with stages"),
            ("[world]\n", "[world]\nduration = 1\n", r"world\.duration: not allowed with stages; allowed: duration in a \[\[stage\]\] that runs"),
        ]:
            self.check_fault(whole.replace(old, new, 1), fault)


if __name__ == "__main__":
    main()
