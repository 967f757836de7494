"""Sweeps: a scene for all combinations of values, with runs that fail, interrupts and resuming."""
import csv
import math
import shutil
import signal
import subprocess
import time

from command import COMMAND, SCENES, SceneTest, halfspace, main

# The slope's own angle is turned into gravity, so that the file has plain numbers.
SCENE = """title = "A block on a plane"
dimension = 2

[world]
duration = 0.5
gravity = [5, -8.660254037844387]

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
vertices = [[-5, -1], [20, -1], [20, 0], [-5, 0]]

[[block]]
name = "block"
material = "stone"
vertices = [[0, 0], [2, 0], [2, 1], [0, 1]]
"""
SLIDES = ("--set", "default_law.friction_angle=5:20:5")


class Sweep(SceneTest):
    def sweep(self, *arguments, code=0, text=SCENE):
        self.scene.write_text(text)
        answer = halfspace("sweep", self.scene, "-o", self.output, *arguments)
        self.assertEqual(answer.returncode, code, answer.stderr + answer.stdout)
        return answer

    def table(self):
        with open(self.output / "table.csv", newline="") as file:
            next(file)
            return list(csv.DictReader(file))

    def test_a_sliding_block_for_each_friction_angle(self):
        self.sweep(*SLIDES)
        rows = self.table()
        self.assertEqual([row["default_law.friction_angle"] for row in rows], ["5", "10", "15", "20"])
        for row in rows:
            # g (sin 30 - cos 30 tan phi) t^2 / 2, to the settling of the springs, m g / (k A) = 2e-5 m.
            phi = math.radians(float(row["default_law.friction_angle"]))
            way = 10 * (0.5 - math.cos(math.radians(30)) * math.tan(phi)) * 0.125
            self.assertEqual(row["exit_status"], "0")
            self.assertAlmostEqual(float(row["run_out"]), way, delta=0.01 * way)
            self.assertAlmostEqual(float(row["max_displacement"]), way, delta=0.01 * way)
        self.assertTrue((self.output / "runs" / "0003" / "last.svg").exists())
        picture = (self.output / "table.svg").read_text()
        self.assertIn("default_law.friction_angle", picture)
        self.assertIn("max_displacement", picture)

    def test_a_grid_with_lists_quotes_and_no_drift(self):
        self.sweep("--set", "world.time_step=1e-4:3e-4:1e-4", "--set", "block.block.velocity=[0, 0],[1, 0]",
                   "--set", "world.duration=0.01", "--plot", "run_out", "-j", "2")
        rows = self.table()
        self.assertEqual([(row["world.time_step"], row["block.block.velocity"]) for row in rows],
                         [(step, velocity) for step in ("1e-04", "2e-04", "3e-04") for velocity in ("[0, 0]", "[1, 0]")])
        self.assertAlmostEqual(float(rows[1]["run_out"]) - float(rows[0]["run_out"]), 0.01, delta=2e-4)
        self.assertIn("[1, 0]", (self.output / "table.svg").read_text())

    def test_runs_that_fail_keep_their_exit_status(self):
        answer = self.sweep("--set", "world.time_step=2e-4,0.2", code=1, text=(SCENES / "unstable.toml").read_text())
        self.assertEqual([row["exit_status"] for row in self.table()], ["0", "3"])
        self.assertIn("1 runs failed", answer.stderr)
        self.assertIn("unstable", (self.output / "runs" / "0001" / "log.txt").read_text())

    def test_factors_of_safety(self):
        self.sweep("--safety", "--set", "default_law.friction_angle=35,40", "--set", "world.duration=1")
        for row in self.table():
            exact = math.tan(math.radians(float(row["default_law.friction_angle"]))) / math.tan(math.radians(30))
            self.assertAlmostEqual(float(row["factor_of_safety"]), exact, delta=0.006)

    def test_the_quantity_of_the_reference(self):
        reference = '\n[reference]\nquantity = "position"\nblock = "block"\naxis = "x"\ntime = 0.25\n'
        self.sweep("--set", "default_law.friction_angle=0,10", text=SCENE + reference)
        for row in self.table():
            phi = math.radians(float(row["default_law.friction_angle"]))
            way = 10 * (0.5 - math.cos(math.radians(30)) * math.tan(phi)) * 0.25**2 / 2
            self.assertAlmostEqual(float(row["reference"]), 1 + way, delta=0.01 * way)

    def test_finished_runs_are_not_run_again(self):
        self.sweep(*SLIDES)
        whole = (self.output / "table.csv").read_text()
        lines = whole.splitlines(keepends=True)
        (self.output / "table.csv").write_text("".join(lines[:3] + lines[5:]))  # without the runs 1 and 2
        before = {n: (self.output / "runs" / f"000{n}" / "results.csv").stat().st_mtime_ns for n in range(4)}
        self.sweep(*SLIDES, "--resume")
        after = {n: (self.output / "runs" / f"000{n}" / "results.csv").stat().st_mtime_ns for n in range(4)}
        self.assertEqual([n for n in range(4) if before[n] != after[n]], [1, 2])
        without_times = [[cell for i, cell in enumerate(line.split(",")) if i != 3] for line in lines]
        again = (self.output / "table.csv").read_text().splitlines(keepends=True)
        self.assertEqual([[cell for i, cell in enumerate(line.split(",")) if i != 3] for line in again], without_times)

    def test_another_scene_or_other_values_are_refused(self):
        self.sweep(*SLIDES)
        for arguments, text in (SLIDES, SCENE + "\n"), (("--set", "default_law.friction_angle=5:25:5"), SCENE):
            answer = self.sweep(*arguments, "--resume", code=1, text=text)
            self.assertIn("its runs are of another scene, of other values of --set", answer.stderr)
        self.assertIn("--force", self.sweep(*SLIDES, code=1).stderr)
        self.sweep(*SLIDES, "--force")

    def test_an_interrupted_sweep_goes_on(self):
        arguments = ("--set", "world.duration=0.5,3000", "-j", "2")
        self.scene.write_text(SCENE)
        with subprocess.Popen([COMMAND, "sweep", str(self.scene), "-o", str(self.output), *arguments],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            while process.poll() is None and (not (self.output / "table.csv").exists() or len(self.table()) < 1):
                time.sleep(0.02)
            process.send_signal(signal.SIGINT)  # to the sweep alone, which interrupts its runs
            told, error = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 1, error)
        self.assertRegex(told, "runs +1 of 2, 0 failed")
        self.assertIn("--resume continues", error)
        self.assertTrue((self.output / "runs" / "0001" / "checkpoint").exists())
        self.assertEqual([row["run"] for row in self.table()], ["0"])

    def test_a_killed_sweep_is_resumed_to_its_end(self):
        arguments = ("--set", "world.duration=1,20,40,41", "-j", "2")

        def results():
            return [[row["run"], row["exit_status"], row["run_out"], row["max_displacement"], row["energy_residual"]]
                    for row in self.table()]

        self.sweep(*arguments)
        undisturbed = results()
        self.assertEqual([row[:2] for row in undisturbed], [["0", "0"], ["1", "0"], ["2", "0"], ["3", "0"]])
        shutil.rmtree(self.output)
        with subprocess.Popen([COMMAND, "sweep", str(self.scene), "-o", str(self.output), *arguments],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            while process.poll() is None and (not (self.output / "table.csv").exists() or len(self.table()) < 1):
                time.sleep(0.02)
            process.kill()
        time.sleep(1)  # its runs end with it
        self.assertLess(len(self.table()), 4)
        self.sweep(*arguments, "--resume")
        self.assertEqual(results(), undisturbed)

    def test_wrong_usage(self):
        for arguments, told in ((("--set", "world.skin=0.1"), "nothing to vary"), (("--set", "world.skin=1:2"), "not a range"),
                                (("--set", "world.skin=1:2:-1"), "never reaches"), (("--set", "world.skin=1:2:0"), "never reaches"),
                                (("--set", "world.skin=a:2:1"), "not a number"),
                                (("--set", "world.skin=0:1:1e-9"), "more than 10000"),
                                ((*SLIDES, "--plot", "runout"), "did you mean 'run_out'")):
            with self.subTest(arguments=arguments):
                self.assertIn(told, self.sweep(*arguments, code=2).stderr)
                self.assertFalse(self.output.exists())
        self.assertIn("out of range: 95", self.sweep("--set", "default_law.friction_angle=30,95", code=1).stderr)
        self.assertFalse(self.output.exists())


if __name__ == "__main__":
    main()
