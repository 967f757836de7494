"""`halfspace trade`: errors against answers that are known, and runs that are left out, interrupted and resumed."""
import csv
import math
import re
import signal
import subprocess
import time
import tomllib
from pathlib import Path

from command import COMMAND, EXAMPLES, SceneTest, halfspace, main

SLIDE = EXAMPLES / "trade" / "slide.toml"

STONE = """
dimension = 2
[[material]]
name = "stone"
density = 2500
[default_law]
stiffness = "per contact"
normal_stiffness = 1e8
"""

# A block falls by 0.1 m onto a plate without damping: m g + (m g)^2 + 2 k m g h under the root is the largest force.
FALL = STONE + """normal_damping = 0
[world]
duration = 0.2
[[block]]
name = "falling"
material = "stone"
vertices = [[0, 0.1], [1, 0.1], [1, 1.1], [0, 1.1]]
[[block]]
name = "plate"
material = "stone"
kind = "fixed"
vertices = [[-2, -1], [3, -1], [3, 0], [-2, 0]]
[reference]
quantity = "force"
block = "plate"
"""

ON_SLOPE = STONE + """
[world]
duration = 0.5
[[block]]
name = "slope"
material = "stone"
kind = "fixed"
vertices = [[-2, -1], [2, -1], [2, 0], [-2, 0]]
rotation = -25
[[block]]
name = "block"
material = "stone"
vertices = [[0, 0], [1, 0], [1, 1], [0, 1]]
rotation = -25
[reference]
quantity = "friction angle"
limit = 0.001
value = 25
"""

# Two bars of cells meet without a spring; theory tells how far the struck one has gone.
BARS = (EXAMPLES / "trade" / "bars.toml").read_text()

# The same with a block that is cut into cells, whose kind may be another one.
STRUCK_BLOCK = BARS[:BARS.index('[[mesh]]\nname = "struck"')] + """[[block]]
name = "struck"
material = "steel"
kind = "mesh"
cell_size = 0.2
vertices = [[0, 0], [1, 0], [1, 0.1], [0, 0.1]]
""" + BARS[BARS.index("[reference]"):]


# A column settles under its weight: its middle goes down by rho g L^2 / (3 E). Nodes are where they should be, and what
# lies between them by the trapezoidal rule.
COLUMN = """
dimension = 2
[world]
[[material]]
name = "rubber"
density = 2000
young_modulus = 1e9
poisson_ratio = 0
[default_law]
stiffness = "none"
[[mesh]]
name = "column"
material = "rubber"
box = [[0, 0], [1, 4]]
cells = [1, 4]
cell = "quad"
[[mesh.support]]
group = "bottom"
[[stage]]
do = "settle"
ratio = 1e-9
[reference]
quantity = "position"
block = "column"
axis = "y"
value = "2 - 2000 * 9.81 * 4^2 / (3 * 1e9)"
"""

# A block stands on a prop, and falls for 0.1 s when that is taken away.
PROPPED = STONE + """
[world]
[[block]]
name = "floor"
material = "stone"
kind = "fixed"
vertices = [[-2, -1], [2, -1], [2, 0], [-2, 0]]
[[block]]
name = "prop"
material = "stone"
vertices = [[0, 0], [1, 0], [1, 1], [0, 1]]
[[block]]
name = "block"
material = "stone"
vertices = [[0, 1], [1, 1], [1, 2], [0, 2]]
[[stage]]
do = "settle"
[[stage]]
do = "run"
duration = 0.1
excavate = ["prop"]
reset_displacement = true
[reference]
quantity = "position"
block = "block"
axis = "y"
"""


def rows_of(directory):
    text = Path(directory, "trade.csv").read_text()
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def value_at(rows, **wanted):
    """The value of the run with this setting, all else as in the scene."""
    setting = {"step": "0.25", "stiffness": "1", "cells": "1", "disturbance": "0"}
    setting |= dict.fromkeys(("law", "kind", "damping", "skin", "tolerance"), "")
    setting |= wanted
    found = [row for row in rows if all(row[key] == value for key, value in setting.items())]
    assert len(found) == 1, (setting, found)
    return float(found[0]["value"])


class Trade(SceneTest):
    def trade(self, text, *options):
        self.scene.write_text(text)
        return halfspace("trade", self.scene, "-o", self.output, *options)

    def rows_so_far(self):
        return len(rows_of(self.output)) if (self.output / "trade.csv").exists() else 0

    def test_of_bodies_that_are_meshes(self):
        run = self.trade(BARS)
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = rows_of(self.output)
        way = [value_at(rows, cells=cells) - 0.5 for cells in ("0.5", "1", "2")]
        errors = [abs(moved / 0.002 - 1) for moved in way]
        self.assertLess(errors[1], 0.03)
        self.assertLess(errors[1], 0.6 * errors[0])
        self.assertLess(errors[2], 0.6 * errors[1])
        # Springs as stiff as a layer of cells are worse than none.
        for law in ("0", "1"):
            self.assertGreater(abs((value_at(rows, law=law) - 0.5) / 0.002 - 1), errors[1])
        # Stiffer ones come nearer to none.
        free, soft, stiff = (value_at(rows, **knobs) for knobs in ({}, {"law": "1", "stiffness": "0.1"},
                                                                   {"law": "1", "stiffness": "100"}))
        self.assertLess(abs(stiff - free), 0.1 * abs(soft - free))
        self.assertEqual({row["kind"] for row in rows}, {""})
        self.assertIn("cells         x 0.5: ", run.stdout)
        self.assertIn("none", (self.output / "trade.svg").read_text())

    def test_of_a_block_that_is_a_mesh(self):
        run = self.trade(STRUCK_BLOCK)
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = rows_of(self.output)
        self.assertEqual({row["kind"] for row in rows}, {"", "2", "3"})
        self.assertEqual({row["end"] for row in rows}, {"whole"})
        self.assertAlmostEqual(value_at(rows), 0.502, delta=1e-4)

    def test_a_column_settles_the_nearer_to_theory_the_finer_it_is(self):
        run = self.trade(COLUMN)
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = rows_of(self.output)
        self.assertIn("position of column along y at the end of the stages", run.stdout)
        self.assertIn("CPU seconds for all stages", run.stdout)
        self.assertRegex(run.stdout, r"(?m)^cells +twice as many .* by 0\.012: MORE THAN THE TOLERANCE")
        sag = 2000 * 9.81 * 4 ** 2 / (3 * 1e9)
        for cells, count in (("0.5", 2), ("1", 4), ("2", 8)):
            error = (2 - value_at(rows, cells=cells)) / sag - 1
            self.assertAlmostEqual(error * count ** 2, -0.25, delta=0.01)
        values = [float(row["value"]) for row in rows if row["cells"] == "1" and row["end"] == "whole"]
        self.assertLess(max(values) - min(values), 1e-3 * sag)

    def test_what_a_stage_takes_away_is_gone(self):
        run = self.trade(PROPPED)
        self.assertEqual(run.returncode, 0, run.stderr)
        for row in rows_of(self.output):
            self.assertAlmostEqual(float(row["start"]) - float(row["value"]), 0.5 * 9.81 * 0.1 ** 2, delta=2e-4)
        for old, new, told in (('axis = "y"', 'axis = "y"\ntime = 1', "measured at its end; allowed: no time"),
                               ('block = "block"', 'block = "prop"', '"prop" is excavated')):
            self.assertIn(told, self.trade(PROPPED.replace(old, new), "--force").stderr)

    def test_cells_that_are_named_stay(self):
        named = STRUCK_BLOCK.replace('block = "struck"', 'block = "struck.3"')
        tracked = named.replace("[reference]", '[output]\ntracked = ["struck.0"]\n[reference]')
        run = self.trade(tracked)
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = rows_of(self.output)
        self.assertEqual({(row["kind"], row["cells"]) for row in rows}, {("", "1")})

    def test_a_block_of_cells_without_springs_is_not_tried_as_a_rigid_one(self):
        scene = STRUCK_BLOCK[:STRUCK_BLOCK.index("[[mesh]]")] + STRUCK_BLOCK[STRUCK_BLOCK.index("[[block]]"):]
        run = self.trade(scene.replace("cell_size = 0.2", "cell_size = 0.2\nvelocity = [1, 0]"))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual({row["kind"] for row in rows_of(self.output)}, {"", "3"})

    def test_a_slide_is_off_by_what_its_springs_give(self):
        run = halfspace("trade", SLIDE, "-o", self.output)
        self.assertEqual(run.returncode, 0, run.stderr)
        slope, friction = math.radians(30), math.radians(20)
        way = 0.5 * 9.81 * (math.sin(slope) - math.cos(slope) * math.tan(friction)) * math.cos(slope)
        exact = 0.5 * (math.cos(slope) + math.sin(slope)) + way
        self.assertIn(f"{exact:.6f}", run.stdout)
        rows = rows_of(self.output)
        errors = [abs(value_at(rows, stiffness=k) - exact) for k in ("0.1", "1", "10", "100")]
        for soft, stiff in zip(errors, errors[1:]):
            self.assertAlmostEqual(soft / stiff, 10, delta=0.5)  # a spring gives by the weight over its stiffness
        self.assertLess(errors[-1] / way, 1e-5)
        for name in ("trade.csv", "trade.txt", "trade.svg"):
            self.assertTrue((self.output / name).exists(), name)
        self.assertEqual((self.output / "trade.txt").read_text(), run.stdout)

    def test_the_lines_of_the_cheapest_setting_are_those_of_its_run(self):
        run = halfspace("trade", SLIDE, "-o", self.output, "--tolerance", "0.0001")
        lines = run.stdout.split("cheapest within 0.01 %")[1].split("\n\n", 1)[1]
        turned = tomllib.loads(lines)
        self.assertEqual(turned["default_law"], {"stiffness": "none", "restitution": 0})
        scene = re.sub(r'(?m)^stiffness = .*$', 'stiffness = "none"', SLIDE.read_text())
        scene = re.sub(r"(?m)^(normal|shear)_stiffness = .*$", "", scene)
        scene = scene.replace("[world]", f"[world]\ntime_step = {turned['world']['time_step']}")
        self.output = self.directory / "again"
        self.assertEqual(self.trade(scene, "--tolerance", "0.0001").returncode, 0)
        exact = float(re.search(r"reference +(\S+) m", run.stdout)[1])
        rows = rows_of(self.output)
        self.assertLess(abs(value_at(rows, step="1") - exact) / 0.785, 1e-4)
        self.assertLess(abs(value_at(rows, tolerance="0.01") - exact) / 0.785, 1e-2)

    def test_the_largest_force_of_an_impact(self):
        weight = 2500 * 9.81
        exact = weight + math.sqrt(weight ** 2 + 2 * 1e8 * weight * 0.1)
        run = self.trade(FALL)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("of the finest run (step 1/16)", run.stdout)
        self.assertIn("runs converge     yes", run.stdout)
        self.assertLess(abs(value_at(rows_of(self.output), step="0.0625") / exact - 1), 1e-4)

    def test_the_friction_angle_that_holds_a_block(self):
        run = self.trade(ON_SLOPE)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertLess(abs(value_at(rows_of(self.output), stiffness="100") - 25), 0.1)

    def test_what_the_budget_leaves_out_a_resumed_trade_does(self):
        short = self.trade(FALL, "--budget", "1s")
        self.assertEqual(short.returncode, 0, short.stderr)
        done = rows_of(self.output)
        whole = self.trade(FALL, "--resume")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        rows = rows_of(self.output)
        self.assertEqual(rows[:len(done)], done)
        self.output = self.directory / "anew"
        self.trade(FALL)
        physics = [key for key in rows[0] if key != "cpu_seconds"]
        in_order = sorted(tuple(row[key] for key in physics) for row in rows)
        self.assertEqual(in_order, sorted(tuple(row[key] for key in physics) for row in rows_of(self.output)))

    def test_an_interrupted_trade_keeps_what_is_done(self):
        scene = self.scene
        scene.write_text(FALL.replace("duration = 0.2", "duration = 20"))
        process = subprocess.Popen([COMMAND, "trade", scene, "-o", self.output], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 600
        while self.rows_so_far() < 3 and time.monotonic() < deadline:  # the finest run is no point of the front
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=600)
        self.assertEqual(process.returncode, 1)
        self.assertIn("--resume continues", errors)
        self.assertIn("Pareto front", output)
        self.assertGreaterEqual(len(rows_of(self.output)), 3)

    def test_another_scene_is_not_resumed(self):
        self.trade(FALL, "--budget", "1s")
        run = self.trade(FALL.replace("1e8", "2e8"), "--resume")
        self.assertEqual(run.returncode, 1)
        self.assertIn("its runs are of another scene", run.stderr)

    def test_a_damaged_table_is_not_resumed(self):
        self.trade(FALL, "--budget", "1s")
        table = self.output / "trade.csv"
        whole = table.read_text()
        for old, new in (("whole", "halfway"), ("1,1,,", "1,1,7,"), ("1,1,,", "0,1,,"), ("1,1,,", "nan,1,,")):
            table.write_text(whole.replace(old, new, 1))
            run = self.trade(FALL, "--resume")
            self.assertEqual(run.returncode, 1, new)
            self.assertIn("trade.csv: line ", run.stderr)
        self.output = self.directory / "nothing"
        self.assertIn("cannot resume: there is no trade.csv", self.trade(FALL, "--resume").stderr)
        self.assertFalse(self.output.exists())

    def test_scenes_without_a_result_say_why(self):
        for change, reason in ((('block = "plate"', 'block = "plate"\ntime = 1e-12'), "too few steps for the time"),
                               (("duration = 0.2", 'duration = 0.2\nfast_blocks = "refuse"\ngravity = [0, -1e9]'),
                                "refused, as blocks are too fast")):
            # A law that bonds has no run without springs: these stop the block at once.
            bonding = FALL.replace("normal_damping = 0", "normal_damping = 0\ncohesion = 1")
            run = self.trade(bonding.replace(*change), "--force")
            self.assertEqual(run.returncode, 3, run.stdout + run.stderr)
            self.assertIn("none: no run reached its end", run.stdout)
            self.assertIn(reason, run.stdout)
            self.assertFalse((self.output / "trade.svg").exists())
        level = ON_SLOPE.replace("rotation = -25\n", "")
        run = self.trade(level, "--force")
        self.assertIn("stable without friction, or not stable at 89 degrees", run.stdout)
        fixed = FALL.replace('name = "falling"', 'name = "falling"\nkind = "fixed"')
        run = self.trade(fixed, "--force")
        self.assertEqual(run.returncode, 1)
        self.assertIn("no free block", run.stderr)

    def test_free_flight_is_exact_at_any_step(self):
        flight = FALL.replace("duration = 0.2", "duration = 0.1\ngravity = [0, 0]").replace(
            'name = "falling"', 'name = "falling"\nvelocity = [3, 2]\nangular_velocity = 10')
        flight = flight.replace('quantity = "force"\nblock = "plate"', 'quantity = "run-out"')
        self.assertEqual(self.trade(flight).returncode, 0)
        half, angle = math.sqrt(0.5), math.radians(1)
        exact = 0.3 + half * math.cos(math.pi / 4 - angle) - 0.5
        rows = [row for row in rows_of(self.output) if row["end"] != "too few steps"]
        self.assertGreater(len([row for row in rows if row["law"] == "3"]), 2)  # without springs
        for row in rows:
            self.assertLess(abs(float(row["value"]) / exact - 1), 2e-5, row)

    def test_odd_options_are_wrong_usage(self):
        scene = self.scene
        scene.write_text(FALL)
        for option in ("--budget=-5s", "--budget=0s", "--budget=nan", "--tolerance=nan", "--tolerance=0"):
            self.assertEqual(halfspace("trade", scene, "-o", self.output, option).returncode, 2, option)
        self.assertEqual(halfspace("trade", scene, "-o", self.output, "--force", "--resume").returncode, 2)

    def test_faults_of_a_reference_are_told(self):
        for old, new, told in (
                ('quantity = "force"', 'quantity = "fors"', "unknown word: \"fors\" (did you mean 'force'?)"),
                ('block = "plate"', 'block = "plat"', "no such block: \"plat\" (did you mean 'plate'?)"),
                ('block = "plate"', 'block = "plate"\naxis = "x"', "unknown key"),
                ('block = "plate"', 'block = "plate"\nvalue = "2 *"', "\"2 *\" is no formula"),
                ('block = "plate"', 'block = "plate"\nvalue = "1 / (t - t)"', "has no finite value"),
                ('block = "plate"', 'block = "plate"\nvalue = "1,2"', "has no finite value"),
                ('block = "plate"', 'block = ""', "reference.block: empty"),
                ('block = "plate"', 'block = "plate"\nscale = 0', "reference.scale: out of range: 0")):
            run = self.trade(FALL.replace(old, new))
            self.assertEqual(run.returncode, 1)
            self.assertIn(told, run.stderr)
            self.assertFalse(self.output.exists())


if __name__ == "__main__":
    main()
