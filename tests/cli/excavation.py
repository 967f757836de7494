"""Ground under its own weight from the start, excavation at once, in portions and by a ramp, loads that change."""
import importlib.util
import math
import re

import vtk

from command import EXAMPLES, SceneTest, halfspace, main

DENSITY, GRAVITY, MODULUS, HEIGHT = 2000, 10, 1e8, 4

GROUND = f"""title = "Ground"
dimension = 2

[world]
gravity = [0, -{GRAVITY}]

[[material]]
name = "soil"
density = {DENSITY}
young_modulus = {MODULUS}
poisson_ratio = 0
damping_time = 1e-3

[default_law]
stiffness = "per area"
normal_stiffness = 1e9

[[mesh]]
name = "ground"
material = "soil"
box = [[0, -{HEIGHT}], [4, 0]]
cells = [4, 8]
cell = "quad"
normal_stress = [0, 0]
normal_stress_by_height = [{0.5 * DENSITY * GRAVITY}, {DENSITY * GRAVITY}]

[[mesh.support]]
group = "bottom"

[[mesh.support]]
group = "left"
axes = "x"

[[mesh.support]]
group = "right"
axes = "x"

[[mesh.load]]
group = "top"
traction = [0, 0]

[output]
tracked = ["ground.12"]

[[stage]]
name = "as it is"
do = "settle"
"""

UPPER = ", ".join(f'"ground.{cell}"' for cell in range(16, 32))
# The lower half loses the weight of the upper one: its cell at 1.75 m above the bottom heaves by so much.
HEAVE = 1.75 * DENSITY * GRAVITY * (HEIGHT / 2) / MODULUS


class Excavation(SceneTest):
    def heights(self):
        return [float(row["ground.12.y"]) for row in self.rows()]

    def last_frame(self):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(sorted((self.output / "frames").glob("frame_*.vtp"))[-1]))
        reader.Update()
        return reader.GetOutput()

    def test_ground_stays_where_its_stress_bears_it(self):
        self.run_scene(GROUND)
        self.assertAlmostEqual(self.heights()[-1], -HEIGHT + 1.75, delta=1e-12)

    def test_excavation_in_one_portion_or_several(self):
        for portions in 1, 5:
            with self.subTest(portions=portions):
                self.run_scene(GROUND + f'[[stage]]\ndo = "settle"\nratio = 1e-8\nportions = {portions}\n'
                               f'excavate = [{UPPER}]\n')
                # The strain is 4e-4.
                self.assertAlmostEqual((self.heights()[-1] + HEIGHT - 1.75) / HEAVE, 1, delta=1e-3)
                self.assertEqual(self.last_frame().GetNumberOfCells(), 16)

    def test_excavation_by_a_ramp_does_not_overshoot(self):
        # The ground swings with the period 4 H / c, 36 ms for half of it; a ramp of ten periods leaves it calm.
        def highest_and_fastest(ramp):
            self.run_scene(GROUND.replace("[output]", "[output]\nhistory_interval = 1e-3")
                           + f'[[stage]]\ndo = "run"\nduration = 0.5\nramp = {ramp}\nexcavate = [{UPPER}]\n')
            speeds = [abs(float(row["ground.12.vy"])) for row in self.rows()]
            return (max(self.heights()) + HEIGHT - 1.75) / HEAVE, max(speeds)
        self.assertGreater(highest_and_fastest(0)[0], 1.5)
        highest, fastest = highest_and_fastest(0.36)
        self.assertAlmostEqual(highest, 1, delta=0.05)
        # It heaves evenly, twice as fast at times as its swing adds to that: no jolt as the ramp begins or ends.
        self.assertLess(fastest, 2.2 * HEAVE / 0.36)

    def test_a_ramp_is_over_before_a_stage_is_at_rest(self):
        told = self.run_scene(GROUND + f'[[stage]]\nname = "ramp"\ndo = "run"\nduration = 0.5\nramp = 0.2\n'
                              f'rest_speed = 1e3\nexcavate = [{UPPER}]\n').stdout
        begin, end = (float(re.search(rf"stage {name} +\w+ until (\S+) s", told).group(1)) for name in ("as it is", "ramp"))
        self.assertGreater(end - begin, 0.2)

    def test_loads_on_what_is_excavated_go_with_it(self):
        loaded = GROUND.replace("traction = [0, 0]", "traction = [0, -4e4]").replace(
            'do = "settle"\n', 'do = "settle"\nratio = 1e-8\n')
        self.run_scene(loaded + '[[stage]]\ndo = "settle"\nratio = 1e-8\n'
                       'excavate = ["ground.28", "ground.29", "ground.30"]\n')
        stress = self.last_frame().GetCellData().GetArray("stress")
        row = sum(stress.GetComponent(cell, 4) for cell in range(12, 16))  # each 1 m wide, its middle 2.25 m deep
        weight = DENSITY * GRAVITY * (4 * 2.25 - 3 * 0.5)
        self.assertAlmostEqual(row / -(weight + 4e4), 1, delta=2e-3)

    def test_bonded_cells_and_whole_bodies_are_taken_away_and_the_run_goes_on(self):
        bonded = GROUND.replace('cell = "quad"', 'cell = "quad"\nbodies = "cells"').replace("[[mesh]]", """[[bond]]
between = ["soil", "soil"]
normal_stiffness = 1e12
tensile_strength = 1e9
cohesion = 1e9

[[mesh]]""")
        first = bonded + f'[[stage]]\ndo = "settle"\nexcavate = [{UPPER}]\n'
        told = self.run_scene(first).stdout
        self.assertIn("bonds", told)
        self.assertEqual(self.last_frame().GetNumberOfCells(), 16)
        self.assertEqual(self.rows("cracks.csv"), [])
        self.scene.write_text(first + '[[stage]]\ndo = "run"\nduration = 0.01\n')
        answer = halfspace("run", self.scene, "-o", self.output, "--from", self.output / "checkpoint")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(self.last_frame().GetNumberOfCells(), 16)

    def test_names_with_dots_are_not_those_of_members(self):
        self.run_scene(GROUND + '[[mesh]]\nname = "ground.above"\nmaterial = "soil"\nbox = [[0, 1], [4, 2]]\n'
                       'cells = [4, 1]\ncell = "quad"\n[[mesh.support]]\ngroup = "top"\n'
                       '[[stage]]\ndo = "settle"\nexcavate = ["ground"]\n')
        self.assertEqual(self.last_frame().GetNumberOfCells(), 4)

    def test_loads_change_by_their_factor(self):
        text = GROUND.replace("traction = [0, 0]", "traction = [0, -1e4]").replace(
            'do = "settle"\n', 'do = "settle"\nratio = 1e-9\n')
        self.run_scene(text)
        once = self.heights()[-1]
        self.run_scene(text + '[[stage]]\ndo = "settle"\nratio = 1e-9\nloads = 3\nportions = 2\n')
        thrice = self.heights()[-1]
        self.assertAlmostEqual((thrice - (-HEIGHT + 1.75)) / (once - (-HEIGHT + 1.75)), 3, delta=3e-3)

    def test_displacements_are_counted_anew(self):
        self.run_scene(GROUND + f'[[stage]]\ndo = "settle"\nratio = 1e-8\nexcavate = [{UPPER}]\n'
                       '[[stage]]\ndo = "settle"\nreset_displacement = true\n')
        moved = self.last_frame().GetCellData().GetArray("displacement")
        self.assertLess(max(abs(moved.GetComponent(i, 1)) for i in range(16)), 1e-3 * HEAVE)

    def test_blocks_are_taken_away_and_what_they_bore_falls(self):
        text = GROUND + '[[stage]]\ndo = "run"\nduration = 0.3\nexcavate = ["prop"]\n'
        for name, low in ("prop", 0), ("roof", 1):
            text += (f'[[block]]\nname = "{name}"\nmaterial = "soil"\n'
                     f'vertices = [[1, {low}], [3, {low}], [3, {low + 1}], [1, {low + 1}]]\n')
        self.run_scene(text.replace('tracked = ["ground.12"]', 'tracked = ["ground.12", "roof", "prop"]'))
        last = self.rows()[-1]
        self.assertAlmostEqual(float(last["roof.y"]), 1.5 - 0.5 * GRAVITY * 0.3**2, delta=0.02)
        self.assertEqual(last["prop.y"], "nan")
        self.assertEqual(self.last_frame().GetNumberOfCells(), 33)

    def test_a_tunnel_closes_as_kirsch_says(self):
        """A round hole of radius 1 under an even pressure p, in rock that is held 10 away."""
        source = importlib.util.spec_from_file_location("make_mesh", EXAMPLES / "tunnel" / "make_mesh.py")
        make_mesh = importlib.util.module_from_spec(source)
        source.loader.exec_module(make_mesh)
        self.scene.with_name("tunnel.msh").write_text(
            make_mesh.mesh(radius=1, half_width=10, rings_outside=24))
        pressure, modulus, poisson = 1e6, 1e10, 0.25
        supports = "".join(f'[[mesh.support]]\ngroup = "{side}"\n' for side in ("left", "right", "bottom", "top"))
        self.run_scene(f"""title = "A hole"
dimension = 2
[world]
gravity = [0, 0]
[[material]]
name = "rock"
density = 2500
young_modulus = {modulus}
poisson_ratio = {poisson}
[default_law]
stiffness = "per area"
normal_stiffness = 1e10
[[mesh]]
name = "ground"
material = "rock"
file = "tunnel.msh"
normal_stress = [-{pressure}, -{pressure}]
{supports}
[[stage]]
do = "settle"
ratio = 1e-8
excavate = ["ground/tunnel"]
""")
        frame = self.last_frame()
        radii = [math.hypot(*frame.GetPoint(i)[:2]) for i in range(frame.GetNumberOfPoints())]
        wall = [r for r in radii if r < 1.01]
        closure = 1 - sum(wall) / len(wall)
        # u = p a (1 + nu) / E far from any support. One at b, between the sides of the square and its corners, takes
        # 3 a2 / b2 of it, 1.5 to 3 %, and the mesh of 32 cells around some.
        self.assertAlmostEqual(closure / (pressure * (1 + poisson) / modulus), 0.978, delta=0.02)
        stress = frame.GetCellData().GetArray("stress")
        for i in range(frame.GetNumberOfCells()):
            corners = frame.GetCell(i).GetPoints()
            x, y = (sum(corners.GetPoint(k)[axis] for k in range(4)) / 4 for axis in (0, 1))
            r = math.hypot(x, y)
            if r > 1.5:
                continue
            sxx, sxy, syy = (stress.GetComponent(i, k) for k in (0, 1, 4))
            hoop = (sxx * y * y - 2 * sxy * x * y + syy * x * x) / r**2
            self.assertAlmostEqual(hoop / -(pressure * (1 + 1 / r**2)), 1, delta=0.03)

    def test_what_is_excavated_has_no_run_out(self):
        block = '[[block]]\nname = "{}"\nmaterial = "soil"\nvertices = [[{}, 0], [{}, 0], [{}, 1], [{}, 1]]\n'
        text = GROUND[:GROUND.index("[[mesh]]")] + """[[block]]
name = "floor"
material = "soil"
kind = "fixed"
vertices = [[-20, -1], [20, -1], [20, 0], [-20, 0]]
""" + "".join(block.format(name, x, x + 1, x + 1, x) for name, x in (("left", -9), ("middle", 0), ("right", 9)))
        told = self.run_scene(text + """[[stage]]
do = "run"
duration = 0.1
excavate = ["left", "right"]
""").stdout
        self.assertRegex(told, r"run-out +0.00 m to the right, 0.00 m to the left; 0.0 % of the mass")
        self.assertIn("2 of them excavated", told)

    def test_faults_name_their_key(self):
        for stage, fault in [
            ('excavate = ["rock"]', r'stage\[1\]\.excavate: no such block: "rock"'),
            ("portions = 0", r"stage\[1\]\.portions"),
            ("ramp = 1", r"stage\[1\]\.ramp"),
            ('reset_displacement = "yes"', r"stage\[1\]\.reset_displacement: not a boolean"),
        ]:
            self.check_fault(GROUND + f'[[stage]]\ndo = "settle"\n{stage}\n', fault)


if __name__ == "__main__":
    main()
