"""The factor of safety: a block on a plane, held by friction and by a bond, and what cannot be found."""
import math
import os
import pty
import re
import shutil
import signal
import subprocess
import time

from command import COMMAND, EXAMPLES, SCENES, SceneTest, halfspace, main

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

STOP = """
[[block]]
name = "stop"
kind = "fixed"
material = "ground"
vertices = [[7, 0], [9, 0], [9, 3], [7, 3]]
rotation = -{dip}
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

    def test_rigid_rock_slides_on_joints_that_dip_out_of_the_slope(self):
        scene = EXAMPLES / "jointed_slope" / "plane_failure.toml"
        answer = halfspace("safety", scene, "-o", self.output)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        stands, falls = (float(factor) for factor in re.search(r"between (\S+) \(stable\) and (\S+)", answer.stdout).groups())
        exact = math.tan(math.radians(42)) / math.tan(math.radians(35))
        self.assertLess(abs(0.5 * (stands + falls) / exact - 1), 0.005)

    def test_friction_alone(self):
        # tan 30 over tan 20, within half of the resolution.
        wanted = math.tan(math.radians(30)) / math.tan(math.radians(20))
        self.assertAlmostEqual(self.factor(scene_of(RIGID, 20)), wanted, delta=0.003)
        self.assertRegex((self.output / "safety.txt").read_text(), r"moving blocks +1 of 2: block by")
        self.assertTrue((self.output / "falls.svg").exists())

    def test_cohesion_and_friction_of_all_kinds_of_block(self):
        # The joint is soft against the stone, so that it is pressed together everywhere, as the formula has it:
        # (c A + W cos a tan phi) / W sin a with c = 10 kPa, A = 5 m2, W = 250 kN, a = 35 degrees: 1.1732.
        for name, body in ("rigid", RIGID), ("affine", RIGID.replace('"{kind}"', '"affine"')), ("mesh", MESH):
            with self.subTest(kind=name):
                self.assertAlmostEqual(self.factor(scene_of(body, 35, bond=BOND)), 1.1732, delta=0.006)

    def test_what_is_not_found_is_told(self):
        self.assertIn("below 2: the scene falls there", self.safety(scene_of(RIGID, 20), "--low", 2, code=1))
        self.assertIn("above 1.5: the scene is stable there", self.safety(scene_of(RIGID, 20), "--high", 1.5, code=1))
        trembling = scene_of(RIGID, 20).replace("duration = 1\n", "") + '[[stage]]\ndo = "settle"\nmax_steps = 5\n'
        self.assertRegex(self.safety(trembling, code=1), r"not at rest +unbalanced by \S+ of all forces after 5 steps: no search")
        self.assertIn("--low", self.safety(scene_of(RIGID, 20), "--low", 3, "--high", 2, code=2))

    def test_a_scene_that_falls_as_given_has_a_factor_below_1(self):
        """Without a stop the block slides off the plane and falls; at the stop it comes to rest after 2 m."""
        wanted = math.tan(math.radians(30)) / math.tan(math.radians(40))
        for stop in "", STOP:
            told = self.safety(scene_of(RIGID + stop, 40))
            self.assertRegex(told, r"falls as given +1 of \d blocks, block by \S+ m, while the scene settled; the search "
                                   r"begins at rest with 2 times the given strengths")
            self.assertNotIn("FELL AT FIRST", told)
            self.assertAlmostEqual(float(re.search(r"factor of safety +([\d.]+), between", told).group(1)), wanted, delta=0.003)
        self.assertNotIn("as given", self.safety(scene_of(RIGID + STOP, 20), "--high", 1.5, code=1))

    def test_a_scene_that_falls_at_any_strength_of_the_search_has_no_factor(self):
        """At 60 degrees twice the friction is too little. A smaller low end finds the factor."""
        told = self.safety(scene_of(RIGID + STOP, 60), code=1)
        self.assertRegex(told, r"FELL AT FIRST +1 of 3 blocks, block by \S+ m, while the scene settled, also with 2 times the "
                               r"given strengths: no search; .* halfspace limit --smallest --set")
        self.assertNotIn("factor of safety", told)
        self.assertRegex(self.safety(scene_of(RIGID + STOP, 40), "--low", 1.1, code=1), "FELL AT FIRST .*, but not with 2 times")
        wanted = math.tan(math.radians(30)) / math.tan(math.radians(60))
        told = self.safety(scene_of(RIGID + STOP, 60), "--low", 0.3)
        self.assertAlmostEqual(float(re.search(r"factor of safety +([\d.]+), between", told).group(1)), wanted, delta=0.003)

    def test_what_falls_into_place_at_any_strength_has_not_failed(self):
        """The block begins 1 m above the plane."""
        told = self.safety(scene_of(RIGID.replace("[[0, 0], [5, 0], [5, 2], [0, 2]]", "[[0, 1], [5, 1], [5, 3], [0, 3]]"), 0) +
                           RIGID.format(kind="rigid", dip=0).replace('"block"', '"other"').replace("[[0, 0], [5, 0], [5, 2], [0, 2]]", "[[5.5, 0], [9, 0], [9, 2], [5.5, 2]]"),
                           "--high", 1.5, code=1)
        self.assertRegex(told, r"falls into place +1 of 3 blocks, block by (1|1\.0\d) m, as with any strength")
        self.assertIn("above 1.5: the scene is stable there", told)

    def test_a_falling_block_ends_the_settling_early(self):
        self.scene.write_text(scene_of(RIGID, 80).replace("duration = 1\n", "") + '[[stage]]\ndo = "settle"\n')
        told = halfspace("run", self.scene, "-o", self.output).stdout
        self.assertRegex(told, r'NOT AT REST after [24]0000 steps, .*"block" has fallen out of the scene')

    def test_wedges_on_two_planes_have_the_factor_of_limit_equilibrium(self):
        """Without bonds, and with bonds whose cohesion adds to it. A wedge that slides locks after some centimetres,
        which is a failure. Normals are those of dip direction and dip."""
        def normal(direction, dip):
            a, d = math.radians(direction), math.radians(dip)
            return [math.sin(d) * math.sin(a), math.sin(d) * math.cos(a), math.cos(d)]

        def cross(a, b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

        def det(a, b, c):
            return sum(x * y for x, y in zip(a, cross(b, c)))

        first, second, up = normal(45, 60), normal(130, 75), [0, 0, 1]
        line = cross(first, second)
        line = [x / math.hypot(*line) for x in line]
        whole = det(first, second, line)
        loads = [det(up, second, line) / whole, det(first, up, line) / whole, det(first, second, up) / whole]
        friction = loads[0] * math.tan(math.radians(45)) + loads[1] * math.tan(math.radians(30))
        text = (SCENES / "wedge.toml").read_text()
        self.assertAlmostEqual(self.factor(text), friction / abs(loads[2]), delta=0.005)
        # The faces: two triangles at the line of both planes.
        top = [-0.16298596879743249, -15.220820288046358, 20], [-5.9881901830239217, 0.78379675425282047, 20]
        toe, back = [-0.50357975774613861, -0.18328804239857965, 2.0], [-10.632604985156904, -4.7512012716868881, 20]

        def minus(a, b):
            return [x - y for x, y in zip(a, b)]

        area = sum(math.hypot(*cross(minus(back, toe), minus(corner, toe))) / 2 for corner in top)
        volume = abs(det(minus(back, toe), minus(top[0], toe), minus(top[1], toe))) / 6
        for cohesion in 1e4, 2e4:
            bond = "".join(f'''
[[bond]]
between = ["rock", "{other}"]
normal_stiffness = 1e9
cohesion = {cohesion}
residual_cohesion = {cohesion}
tensile_strength = 1e6
friction_angle = {angle}
''' for other, angle in (("rock", 45), ("rock2", 30)))
            wanted = (friction + cohesion * area / (2700 * 9.81 * volume)) / abs(loads[2])
            self.assertAlmostEqual(self.factor(text + bond), wanted, delta=0.005)

    def test_the_limit_is_the_users_and_by_default_the_joints(self):
        told = self.safety(scene_of(RIGID, 20))
        # The joint yields by tan 30 W cos 20 / (1e10 Pa/m 5 m2), and is pressed in by W cos 20 / (1e10 Pa/m 5 m2): with
        # W = 250 kN ten times that is far below 1e-3 of the block's diagonal, 5.39 m.
        self.assertRegex(told, r"limit +0.00539 m")
        self.assertRegex(told, r"max displacement +block by \S+ m at 1\.\d+ \(stable\)")
        wanted = math.tan(math.radians(30)) / math.tan(math.radians(20))
        for limit in 1e-3, 0.5:
            told = self.safety(scene_of(RIGID, 20), "--limit", limit)
            self.assertRegex(told, rf"limit +{limit:g} m")
            self.assertAlmostEqual(float(re.search(r"factor of safety +([\d.]+), between", told).group(1)), wanted, delta=0.003)

    def test_what_slides_until_it_locks_has_fallen(self):
        # It slides for 8 cm and comes to rest at a stop.
        stop = RIGID + """
[[block]]
name = "stop"
kind = "fixed"
material = "ground"
vertices = [[5.08, 0], [6, 0], [6, 1], [5.08, 1]]
rotation = -{dip}
"""
        wanted = math.tan(math.radians(30)) / math.tan(math.radians(20))
        self.assertAlmostEqual(self.factor(scene_of(stop, 20)), wanted, delta=0.003)
        self.assertIn("above 5: the scene is stable there", self.safety(scene_of(stop, 20), "--limit", 0.2, code=1))

    def test_an_interrupted_search_keeps_its_trials_and_goes_on(self):
        whole = self.safety(scene_of(RIGID, 20))
        trials = (self.output / "trials.csv").read_text()
        rows = trials.splitlines()
        self.assertGreater(len(rows), 8)
        (self.output / "trials.csv").write_text("\n".join(rows[:6]) + "\n")
        again = halfspace("safety", self.scene, "-o", self.output, "--resume")
        self.assertEqual((again.returncode, again.stdout), (0, whole))
        self.assertEqual((self.output / "trials.csv").read_text(), trials)
        shutil.rmtree(self.output)
        with subprocess.Popen([COMMAND, "safety", str(self.scene), "-o", str(self.output), "--resolution", "1e-12"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            while process.poll() is None and (not (self.output / "trials.csv").exists() or
                                              len((self.output / "trials.csv").read_text().splitlines()) < 5):
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            told, error = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 1)
        self.assertRegex(told, r"factor of safety +INTERRUPTED: ")
        self.assertIn("--resume continues", error)
        self.assertEqual((self.output / "safety.txt").read_text(), told)
        self.assertEqual(halfspace("safety", self.scene, "-o", self.output, "--resume").stdout, whole)

    def test_trials_of_another_scene_are_refused(self):
        self.safety(scene_of(RIGID, 20))
        self.scene.write_text(scene_of(RIGID, 21))
        answer = halfspace("safety", self.scene, "-o", self.output, "--resume")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("cannot resume from", answer.stderr)

    def test_progress_on_a_terminal(self):
        self.scene.write_text(scene_of(RIGID, 20))
        controller, terminal = pty.openpty()
        with subprocess.Popen([COMMAND, "safety", str(self.scene), "-o", str(self.output)], stdout=subprocess.DEVNULL,
                              stderr=terminal) as process:
            self.assertEqual(process.wait(timeout=600), 0)
        os.close(terminal)
        shown = os.read(controller, 1 << 16).decode()
        os.close(controller)
        self.assertRegex(shown, r"\[#* *\] \d+ %  (settling|trial \d+), ")

    def test_stages_that_run_before_the_search(self):
        text = scene_of(RIGID, 20).replace("duration = 1\n", "")
        settled = self.factor(text + '[[stage]]\ndo = "settle"\n')
        ran = self.factor(text + '[[stage]]\ndo = "run"\nduration = 0.5\n[[stage]]\ndo = "settle"\n')
        self.assertAlmostEqual(ran, settled, delta=0.01)


if __name__ == "__main__":
    main()
