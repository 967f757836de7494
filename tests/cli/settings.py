"""Settings of the command line, --set, which replace values of a scene."""
import re

from command import EXAMPLES, SceneTest, halfspace, main

SCENE = """title = "A block on a plane"
dimension = 2

[world]
duration = 0.1
gravity = [0, -10]

[[material]]
name = "stone"
density = 2500

[default_law]
stiffness = "per area"
normal_stiffness = 1e9
friction_angle = 30

[[block]]
name = "plane"
kind = "fixed"
material = "stone"
vertices = [[-5, -1], [10, -1], [10, 0], [-5, 0]]

[[block]]
name = "block.0"
material = "stone"
vertices = [[0, 0], [1, 0], [1, 1], [0, 1]]
"""


class Settings(SceneTest):
    def check(self, *settings):
        self.scene.write_text(SCENE)
        return halfspace("check", self.scene, *(word for setting in settings for word in ("--set", setting)))

    def test_a_setting_does_as_the_file_with_its_value(self):
        for setting, line, changed in (
                ("default_law.friction_angle=20", "friction_angle = 30", "friction_angle = 20"),
                ("material.stone.density=2000", "density = 2500", "density = 2000"),
                ("world.gravity[1]=-9", "gravity = [0, -10]", "gravity = [0, -9]"),
                ("block[1].vertices[2]=[1, 2]", "[1, 1]", "[1, 2]"),
                ("block.block.0.material=stone", "", ""),
                ("block.block.0.velocity=[1, 0]", '"block.0"', '"block.0"\nvelocity = [1, 0]'),
                ("output.tracked=['block.0']", "dimension = 2", 'dimension = 2\noutput = {tracked = ["block.0"]}')):
            with self.subTest(setting=setting):
                self.run_scene(SCENE, "--set", setting)
                histories = [(self.output / "history.csv").read_text()]
                summary = (self.output / "summary.txt").read_text()
                self.assertIn(f"set                 {setting}\n", summary)
                self.run_scene(SCENE.replace(line, changed, 1))
                histories.append((self.output / "history.csv").read_text())
                self.assertEqual(*histories)

    def test_faults_name_their_setting(self):
        for setting, fault in (
                ("default_law.friction_angle=95", "default_law.friction_angle: out of range: 95; allowed"),
                ("default_law.frictionangle=5", r"unknown key \(did you mean 'friction_angle'\?\)"),
                ("materal.stone.density=5", r"materal: unknown key \(did you mean 'material'\?\)"),
                ("block.plan.kind=fixed", "no such block: \"plan\" \\(did you mean 'plane'\\?\\)"),
                ("block.plane.kind=fixd", "block\\[0\\].kind: unknown word: \"fixd\" \\(did you mean 'fixed'\\?\\)"),
                ("block[2].velocity=[1, 0]", r"no such element of block; allowed: \[0\] to \[1\]"),
                ("law[0].friction_angle=5", "no such list: law"),
                ("world.duration.x=5", "world.duration has no keys"),
                ("world.duration=[1", r"not a value: \[1"),
                ("world.duration=1\nx = 2", "not a value: "),
                ("world.duration", "no value; allowed: key=value"),
                ("=5", "not a key"),
                ("a.b.c.d.e.f.g.h.i=5", "more than 8 names")):
            with self.subTest(setting=setting):
                answer = self.check(setting)
                self.assertEqual(answer.returncode, 1)
                self.assertRegex(answer.stderr, re.escape(f"{self.scene}: --set {setting}: ") + f".*{fault}")
                self.assertIn(f"1 fault in {self.scene}", answer.stderr)

    def test_a_setting_without_a_value_removes_it(self):
        for setting, removed in (("default_law.friction_angle=", "friction_angle = 30\n"),
                                 ("world.gravity=", "gravity = [0, -10]\n"),
                                 ("block.block.0=", SCENE[SCENE.index('[[block]]\nname = "block.0"'):]),
                                 ("block[1].vertices[2]= ", ", [1, 1]")):
            with self.subTest(setting=setting):
                self.scene.write_text(SCENE.replace(removed, ""))
                expected = halfspace("check", self.scene)
                answer = self.check(setting)
                self.assertEqual(re.sub(r":\d+:\d+:", ":", answer.stdout + answer.stderr),
                                 re.sub(r":\d+:\d+:", ":", expected.stdout + expected.stderr))
        self.assertIn("no such key: default_law.cohesion; allowed: ", self.check("default_law.cohesion=").stderr)

    def test_keys_that_do_not_fit_a_set_kind_are_left_out(self):
        law = '[[law]]\nbetween = ["stone", "stone"]\nshear_stiffness = 1e8\n'
        self.scene.write_text(SCENE + law)
        answer = halfspace("check", self.scene, "--set", "default_law.stiffness=none", "--set", "world.time_step=0.01")
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        for key in ("default_law.normal_stiffness", r"law\[0\].shear_stiffness"):
            self.assertRegex(answer.stdout, rf":\d+:1: note: {key}: left out; it does not fit the kind that --set gives")
        # A misspelt key is still a fault, and so is one that a setting gives.
        for setting in ("default_law.frictionangle=5", "default_law.normal_stiffness=1e9"):
            answer = halfspace("check", self.scene, "--set", "default_law.stiffness=none", "--set", setting)
            self.assertIn("unknown key", answer.stderr)

    def test_later_settings_win_and_notes_name_them(self):
        self.assertEqual(self.check("world.duration=-1", "world.duration=2").returncode, 0)
        self.assertIn("--set default_law.friction_angle=0.5: note: ", self.check("default_law.friction_angle=0.5").stdout)

    def test_a_checkpoint_takes_a_setting_as_a_change_of_the_file(self):
        self.run_scene(SCENE)
        checkpoint = self.output / "checkpoint"
        self.run_scene(SCENE, "--from", checkpoint, "--set", "world.duration=0.2")
        self.assertRegex((self.output / "summary.txt").read_text(), r"simulated +0\.2000")
        answer = self.run_scene(SCENE, "--from", checkpoint, "--set", "default_law.friction_angle=5", code=1)
        self.assertIn("the checkpoint is not of this scene", answer.stderr)

    def test_all_commands_take_them(self):
        self.scene.write_text(SCENE)
        for command in "plan", "safety", "trade", "sweep", "limit":
            answer = halfspace(command, self.scene, "--set", "world.duration=-1", "--set", "world.skin=0.1,0.2",
                               *(() if command == "plan" else ("-o", self.output)),
                               *(("--tilt",) if command == "limit" else ()))
            self.assertEqual(answer.returncode, 1, command)
            self.assertIn("--set world.duration=-1: world.duration: out of range", answer.stderr)
            self.assertFalse(self.output.exists())

    def test_examples_take_settings_of_generators(self):
        answer = halfspace("check", EXAMPLES / "rock_collapse" / "friction_15.toml", "--set",
                           "jointed_rock[0].joint_set[0].spacing=-1")
        self.assertIn("jointed_rock[0].joint_set[0].spacing: out of range: -1", answer.stderr)


if __name__ == "__main__":
    main()
