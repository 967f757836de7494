"""Motions and loads in time: tables in scenes, their stages, checkpoints and faults, and the examples."""
from command import EXAMPLES, SceneTest, halfspace, main

SCENE = """title = "A block on ground that moves"
dimension = 2
world = { time_step = 0.01, gravity = [0, 0] }
default_law = { stiffness = "none" }
material = [{ name = "stone", density = 2000 }]
stage = [{ name = "rest", do = "run", duration = 0.5 }, { name = "shake", do = "run", duration = 1 }]
block = [
  { name = "ground", kind = "prescribed", material = "stone", vertices = [[0, 0], [1, 0], [1, 1], [0, 1]] },
  { name = "loose", material = "stone", vertices = [[0, 5], [1, 5], [1, 6], [0, 6]] },
  { name = "sled", hold = "xr", material = "stone", vertices = [[0, 9], [1, 9], [1, 10], [0, 10]] },
]
output = { tracked = ["ground", "loose", "sled"], history_interval = 0.5 }
"""
ACTION = """
[[action]]
on = "ground"
kind = "velocity"
stage = "shake"
direction = [1, 0]
table = [[0, 0], [0.125, 2], [0.5, 0]]
[[action]]
on = "loose"
kind = "force"
table = [[0, 100, 50], [0.303, 100, 50], [0.303, 0, 0]]
[[action]]
on = "sled"
kind = "velocity"
direction = [1, 0]
factor = 2
file = "table.csv"
"""
MESH = """dimension = 2
world = { duration = 0.02, gravity = [0, 0] }
default_law = { stiffness = "per area", normal_stiffness = 1e8 }
material = [{ name = "rock", density = 2000, young_modulus = 1e7, poisson_ratio = 0 }]
[[mesh]]
name = "bar"
material = "rock"
box = [[0, 0], [4, 1]]
cells = [8, 2]
cell = "quad"
[[mesh.support]]
group = "left"
axes = "x"
velocity = [1, 0]
table = [[0, 0], [0.01, 0.5], [0.02, 0]]
[[mesh.load]]
group = "right"
traction = [1e4, 0]
table = [[0, 0], [0.02, 1]]
[output]
tracked = ["bar.0"]
"""


BAR = """dimension = 2
world = { gravity = [0, 0], duration = 0.014 }
default_law = { stiffness = "per area", normal_stiffness = 1e8 }
material = [{ name = "rock", density = 2500, young_modulus = 1e10, poisson_ratio = 0 }]
[[mesh]]
name = "bar"
material = "rock"
box = [[0, 0], [20, 1]]
cells = [200, 1]
cell = "quad"
[[mesh.load]]
group = "left"
traction = [1e6, 0]
table = [[0, 0], [0.001, 1], [0.002, 0]]
[[mesh.viscous]]
group = "right"
[output]
tracked = ["bar.100"]
history_interval = 1e-4
"""


SHEAR_BOX = """dimension = 2
world = { duration = 1, gravity = [0, 0] }
default_law = { stiffness = "per area", normal_stiffness = 1e8, friction_angle = 30 }
material = [{ name = "soil", density = 2000 }]
block = [
  { name = "lower", kind = "fixed", material = "soil", vertices = [[-1, -0.2], [1, -0.2], [1, 0], [-1, 0]] },
  { name = "upper", hold = "xyr", material = "soil", vertices = [[-0.2, 0], [0.2, 0], [0.2, 0.2], [-0.2, 0.2]] },
]
[output]
tracked = ["upper"]
"""
JOINT = 'joints = [{ name = "shear", blocks = ["lower", "upper"] }]\n'
SERVO = """
[[action]]
on = "upper"
kind = "servo"
table = [[0, 1000]]
direction = [0, -1]
max_speed = 0.05
"""
SHEAR = """
[[action]]
on = "upper"
kind = "velocity"
table = [[0, 0.05]]
direction = [1, 0]
"""

PRESS = """dimension = 2
world = { duration = 2, time_step = 0.01 }
default_law = { stiffness = "none", friction_angle = 30 }
material = [{ name = "stone", density = 2000 }]
[[block]]
material = "stone"
name = "floor"
kind = "fixed"
vertices = [[-3, -1], [3, -1], [3, 0], [-3, 0]]
[[block]]
material = "stone"
name = "stone"
vertices = [[0, 0], [0.5, 0], [0.5, 0.5], [0, 0.5]]
[[block]]
material = "stone"
name = "plate"
kind = "prescribed"
vertices = [[-1, 0.6], [1, 0.6], [1, 0.8], [-1, 0.8]]
velocity = [0, -0.1]
"""


class Actions(SceneTest):
    def test_a_servo_presses_while_the_block_is_sheared(self):
        """Motions along different axes act together, whichever comes first."""
        for actions in SERVO + SHEAR, SHEAR + SERVO:
            answer = self.run_scene(SHEAR_BOX + JOINT + actions)
            self.assertNotIn("note", answer.stderr)
            last = self.rows()[-1]
            self.assertAlmostEqual(float(last["upper.x"]), 0.05 * float(last["time"]), delta=1e-12)
            self.assertAlmostEqual(float(last["shear.normal_force"]), 1000, delta=1)
            self.assertAlmostEqual(abs(float(last["shear.shear_force"])), 577.4, delta=1)

    def test_two_motions_along_one_axis_are_a_fault_that_names_both(self):
        names_both = r'action\[1\]\.on: "upper" has a motion along y by action\[0\] of the same stage; allowed'
        self.check_fault(SHEAR_BOX + SERVO + SHEAR.replace("[1, 0]", "[1, 1]"), names_both)
        self.check_fault(SHEAR_BOX + SERVO + SERVO.replace("1000", "500"), names_both)
        self.check_fault(SHEAR_BOX + SERVO + SHEAR.replace("direction = [1, 0]", "").replace("0.05]", "0.05, 0]"),
                         names_both)
        everywhere = '[[action]]\nkind = "acceleration"\ndirection = [1, 0]\ntable = [[0, 1]]\n'
        self.check_fault(SHEAR_BOX + everywhere + everywhere,
                         r"action\[1\]\.on: all blocks have a motion along x by action\[0\]")
        turn = '[[action]]\non = "upper"\nkind = "angular_velocity"\ntable = [[0, 1]]\n'
        prescribed = SHEAR_BOX.replace('hold = "xyr"', 'kind = "prescribed"').replace("world = { ", "world = { time_step = 0.001, ")
        self.check_fault(prescribed + turn + turn, r'"upper" has a rotation about z by action\[0\]')
        self.scene.write_text(prescribed + turn + SHEAR)
        self.assertEqual(halfspace("check", self.scene).returncode, 0)

    def test_a_later_stage_replaces_motions_along_its_axes_only(self):
        stages = "".join(f'[[stage]]\nname = "{name}"\ndo = "run"\nduration = 0.2\n' for name in ("press", "shear", "back"))
        later = SHEAR + 'stage = "shear"\n' + SHEAR.replace("0.05]", "-0.05]") + 'stage = "back"\n'
        self.run_scene(SHEAR_BOX.replace("duration = 1, ", "") + JOINT + stages + SERVO + later)
        last = self.rows()[-1]
        self.assertAlmostEqual(float(last["upper.x"]), 0, delta=1e-4)
        self.assertAlmostEqual(float(last["shear.normal_force"]), 1000, delta=1)

    def test_a_servo_that_meets_no_force_is_noted(self):
        def notes(text):
            self.scene.write_text(text)
            answer = halfspace("check", self.scene)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            return [line for line in answer.stdout.splitlines() if "the servo of" in line]

        self.assertEqual(notes(SHEAR_BOX + SERVO), [])
        prescribed = SHEAR_BOX.replace('hold = "xyr"', 'kind = "prescribed"').replace("world = { ", "world = { time_step = 0.001, ")
        note, = notes(prescribed + SERVO)
        self.assertRegex(note, r'action\[0\]\.on: the servo of "upper" meets no force: neither it nor "lower" ahead')
        self.assertEqual(notes(prescribed.replace('kind = "fixed"', 'kind = "rigid"') + SERVO), [])
        self.assertEqual(notes(prescribed + SERVO.replace("[0, -1]", "[0, 1]")), [])  # nothing is ahead
        no_spring = ('[[material]]\nname = "steel"\ndensity = 7800\n[[law]]\nbetween = ["soil", "steel"]\n'
                     'stiffness = "none"\nfriction_angle = 30\n')
        tables = SHEAR_BOX.replace('material = [{ name = "soil", density = 2000 }]\n', "").replace(
            'hold = "xyr", material = "soil"', 'hold = "xyr", material = "steel"')
        soil = '[[material]]\nname = "soil"\ndensity = 2000\n'
        note, = notes(tables + soil + no_spring + SERVO)
        self.assertIn('the law towards "lower" ahead has no springs', note)

    def test_a_jam_names_its_blocks(self):
        answer = self.run_scene(PRESS, code=3)
        self.assertRegex(answer.stderr, r'prescribed block "plate" presses on blocks that cannot move away; the force between '
                                        r'blocks "(floor|stone)" and "(stone|plate)" would exceed')

    def run_with_table(self, *arguments, **options):
        (self.directory / "table.csv").write_text("time; value\n# a comment\n0; 0\n1.5; 3\n")
        return self.run_scene(SCENE + ACTION, *arguments, **options)

    def test_the_acceleration_of_a_prescribed_block(self):
        """Its velocity is that of the action from step to step, whatever the steps between two rows of the history."""
        text = SCENE + '[[action]]\non = "ground"\nkind = "acceleration"\ndirection = [1, 0]\nstage = "shake"\n'
        for interval in 0.5, 0.01:
            self.run_scene(text.replace("history_interval = 0.5", f"history_interval = {interval}") + "table = [[0, 3]]\n")
            last = self.rows()[-1]
            self.assertAlmostEqual(float(last["ground.vx"]), 3, delta=1e-9)
            self.assertAlmostEqual(float(last["ground.x"]), 0.5 + 1.5, delta=1e-9)

    def test_blocks_follow_their_tables(self):
        self.run_with_table()
        rest, last = self.rows()[1], self.rows()[-1]
        self.assertEqual(float(rest["ground.x"]), 0.5)
        self.assertAlmostEqual(float(last["ground.x"]), 1.0, delta=1e-12)
        self.assertAlmostEqual(float(last["loose.vx"]), 0.303 * 100 / 2000, delta=1e-14)
        self.assertAlmostEqual(float(last["loose.vy"]), 0.303 * 50 / 2000, delta=1e-14)
        self.assertAlmostEqual(float(last["sled.vx"]), 6, delta=1e-12)
        self.assertAlmostEqual(float(last["sled.x"]), 0.5 + 4.5, delta=1e-11)

    def test_a_resumed_run_is_the_same(self):
        self.run_with_table()
        whole = self.rows()[-1]
        (self.directory / "table.csv").write_text("0 0\n1.5 3\n")
        self.run_scene((SCENE + ACTION).replace("duration = 1 ", "duration = 0.3 "))
        self.scene.write_text(SCENE + ACTION)
        answer = halfspace("run", self.scene, "-o", self.output, "--from", self.output / "checkpoint")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(self.rows()[-1], whole)
        self.scene.write_text((SCENE + ACTION).replace("[0.125, 2]", "[0.125, 3]"))
        answer = halfspace("run", self.scene, "-o", self.output, "--from", self.output / "checkpoint")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("stage 1, which it had begun, differs", answer.stderr)

    def test_meshes_follow_their_tables(self):
        self.run_scene(MESH)
        outer_work = float(self.rows()[-1]["outer_work"])
        self.assertGreater(outer_work, 0)
        self.assertLess(abs(float(self.rows()[-1]["residual"])), 1e-3 * outer_work)

    def test_a_wave_leaves_a_viscous_end(self):
        """It passes the middle of the bar at 5 to 7 ms, and would come back at 15 ms."""
        self.run_scene(BAR.replace("duration = 0.014", "duration = 0.018"))
        speed = [(float(row["time"]), abs(float(row["bar.100.vx"]))) for row in self.rows()]
        incoming = max(v for _, v in speed)
        self.assertAlmostEqual(incoming, 1e6 / (2500 * 2000), delta=0.015)
        self.assertLess(max(v for time, v in speed if time > 0.013), 0.02 * incoming)
        self.assertLess(float(self.rows()[-1]["kinetic"]), 1e-3 * 66.7)

    def test_a_wave_in_rigid_blocks_leaves_a_quiet_base(self):
        """It passes a block in the middle until 9.5 ms, and what the base reflects comes from 12 ms on."""
        scene = (EXAMPLES / "coming_from" / "quiet_base.toml").read_text()
        viscous = '[[mesh.viscous]]\ngroup = "bottom"\n'
        self.assertIn(viscous, scene)
        answer = halfspace("check", EXAMPLES / "coming_from" / "quiet_base.toml")
        self.assertNotRegex(answer.stdout, " falls?")  # the load below bears it

        def reflected(text):
            self.run_scene(text)
            speed = [(float(row["stage_time"]), abs(float(row["column.20.vy"])))
                     for row in self.rows() if row["stage"] == "wave"]
            incoming = max(v for time, v in speed if time < 0.0095)
            self.assertAlmostEqual(incoming, 2e4 / (2500 * 2000), delta=4e-4)
            return max(v for time, v in speed if 0.012 < time < 0.022) / incoming

        self.assertLess(reflected(scene), 0.03)
        self.assertGreater(reflected(scene.replace(viscous, '[[mesh.support]]\ngroup = "bottom"\n')), 0.9)

    def test_faults_name_the_key_and_what_is_allowed(self):
        for old, new, fault in [
            ('on = "ground"', 'on = "grund"', r"action\[0\]\.on: no such block: .grund. .did you mean .ground"),
            ('on = "loose"', "", r"action\[1\]\.on: missing"),
            ('on = "loose"', 'on = ""', r"action\[1\]\.on: empty; allowed: a string"),
            ('file = "table.csv"', 'file = ""', r"action\[.\]\.file: empty; allowed: a string"),
            ('kind = "force"', 'kind = "push"', r'action\[1\]\.kind: unknown word: "push"'),
            ('on = "ground"', 'on = "loose"', r'action\[0\]\.on: "loose" cannot follow it; allowed: a prescribed'),
            ("[0.303, 100, 50], [0.303, 0, 0]", "[-1, 0, 0]", r"row 1 is at -1 s; allowed: times that ascend"),
            ("[0.303, 100, 50], [0.303, 0, 0]", "[1, 2]", r"action\[1\]\.table\[1\]: not a row"),
            ("[[0, 0], [0.125, 2], [0.5, 0]]", "[[0, 1, 2, 3]]", r"rows of 4 numbers; allowed: rows \[time, value\] or"),
            ('stage = "shake"', 'stage = "shak"', r'no stage is called "shak"'),
            ('file = "table.csv"', 'file = "other.csv"', r"no such file"),
            ("direction = [1, 0]\nfactor", "direction = [0, 0]\nfactor", r"no direction"),
            ('hold = "xr"', 'hold = "xz"', r'hold: "xz"; allowed: some of the letters x and y, and r'),
        ]:
            (self.directory / "table.csv").write_text("0 0\n1.5 3\n")
            with self.subTest(new):
                self.assertIn(old, SCENE + ACTION)
                self.check_fault((SCENE + ACTION).replace(old, new), fault)

    def test_a_faulty_file_is_the_only_fault(self):
        for content, fault in (
                ("0;0\n0,5;x\n", r't\.csv:2: not a finite number: "x"'), ("time;value\n", "no rows"),
                ("0 1 2 3\n", "rows of 4 numbers"), ("1;0\n0;0\n", "row 1 is at 0 s"), (None, "no such file")):
            with self.subTest(content):
                if content is None:
                    (self.directory / "t.csv").unlink()
                else:
                    (self.directory / "t.csv").write_text(content)
                text = (SCENE + ACTION).replace('"table.csv"', '"t.csv"')
                self.check_fault(text, rf"^.*: action\[2\]\.file: {fault}.*\n1 fault in ")

    def test_a_table_in_milliseconds_is_noted(self):
        (self.directory / "table.csv").write_text("0 0\n1500 3\n")
        self.scene.write_text(SCENE + ACTION)
        answer = halfspace("check", self.scene)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(answer.stdout, r"note: action\[2\]\.file: its last row is at 1500 s, and the run ends at ")

    def test_the_examples_run(self):
        for example, result in [
            ("spreading_supports/arch.toml", r"outcome +complete"),
            ("biaxial_test/biaxial.toml", r"stage shear +ran until 0\.3 s"),
        ]:
            with self.subTest(example):
                answer = halfspace("run", EXAMPLES / example, "-o", self.output, "--force")
                self.assertEqual(answer.returncode, 0, answer.stderr)
                self.assertRegex(answer.stdout, result)
        self.assertEqual(halfspace("check", EXAMPLES / "earthquake/slope.toml").returncode, 0)


if __name__ == "__main__":
    main()
