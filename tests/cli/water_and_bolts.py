"""Water that stages change, and bolts that stages install: draught, tensions, files, faults, and resumed runs."""
import csv

import vtk

from command import EXAMPLES, SceneTest, main

POND = """dimension = 2
[world]
[[material]]
name = "wood"
density = 600
[default_law]
stiffness = "per contact"
normal_stiffness = 1e7
friction_angle = 30
[[block]]
name = "raft"
material = "wood"
vertices = [[0, 0], [4, 0], [4, 1], [0, 1]]
[output]
tracked = ["raft"]
[water]
level = 0.5
[[stage]]
do = "settle"
ratio = 1e-8
"""
POOL = """dimension = 3
[world]
duration = 0.001
[[material]]
name = "stone"
density = 2500
[default_law]
stiffness = "per contact"
normal_stiffness = 1e8
friction_angle = 30
[water]
file = "heights.csv"
spacing = 1
shift = [0, 0, 0]
[[block]]
name = "bed"
kind = "fixed"
material = "stone"
vertices = [[-3, -2, -1], [3, -2, -1], [-3, 2, -1], [3, 2, -1], [-3, -2, 0], [3, -2, 0], [-3, 2, 0], [3, 2, 0]]
[[block]]
name = "block"
material = "stone"
vertices = [[-1, -1, 0], [1, -1, 0], [-1, 1, 0], [1, 1, 0], [-1, -1, 2], [1, -1, 2], [-1, 1, 2], [1, 1, 2]]
"""
LAMP = """dimension = 2
[world]
[[material]]
name = "iron"
density = 8000
[default_law]
stiffness = "per contact"
normal_stiffness = 1e9
friction_angle = 30
[[block]]
name = "ceiling"
kind = "fixed"
material = "iron"
vertices = [[-2, 4], [2, 4], [2, 5], [-2, 5]]
[[block]]
name = "lamp"
material = "iron"
vertices = [[-0.5, 0], [0.5, 0], [0.5, 1], [-0.5, 1]]
[[bolt]]
name = "cable"
from = [0, 4.5]
to = [0, 0.5]
stiffness = 1e7
pretension = 78480
"""
STAGES = """[[stage]]
do = "run"
duration = 0.2
[[stage]]
do = "run"
duration = 0.2
install = ["rod"]
[[bolt]]
name = "rod"
from = [1, 4.5]
to = [0.3, 0.5]
blocks = ["ground", "lamp"]
stiffness = 1e6
bears = "both"
yield_force = 2e4
pretension = 1e4
"""


class WaterAndBolts(SceneTest):
    def vtk_file(self, name):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(self.output / name))
        reader.Update()
        return reader.GetOutput()

    def test_a_raft_rises_with_the_level(self):
        text = POND + '[[stage]]\ndo = "settle"\nratio = 1e-8\nportions = 4\n[stage.water]\nlevel = 2.5\n'
        self.run_scene(text)
        heights = [float(row["raft.y"]) for row in self.rows()]
        self.assertAlmostEqual(heights[-1], 2.5 - 0.1, delta=1e-5)
        self.assertTrue(any(abs(height - 0.4) < 1e-5 for height in heights), heights)
        self.assertGreater(float(self.rows()[-1]["water"]), 0)

    def test_a_sloping_table_replaces_a_level_gradually(self):
        text = POND + '[[stage]]\ndo = "run"\nduration = 1\nramp = 0.5\n[stage.water]\ntable = [[0, 0.5], [4, 0.7]]\n'
        self.run_scene(text)
        self.assertLess(abs(float(self.rows()[-1]["residual"])), 1)
        self.assertIn("<line", (self.output / "last.svg").read_text())

    def test_a_cable_carries_the_weight(self):
        self.run_scene(LAMP + '[[stage]]\ndo = "settle"\n')
        last = self.rows("bolts.csv")[-1]
        self.assertEqual(last["bolt"], "cable")
        self.assertAlmostEqual(float(last["tension"]), 8000 * 9.81, delta=1)
        self.assertRegex((self.output / "summary.txt").read_text(), r"bolts +1 installed, 0 yielded, 0 ruptured")
        bolts = self.vtk_file("frames/bolts_0000.vtp")
        self.assertEqual(bolts.GetNumberOfLines(), 1)
        self.assertAlmostEqual(bolts.GetCellData().GetArray("tension").GetValue(0), 78480, delta=1e-6)

    def test_a_resumed_run_installs_the_same_bolts(self):
        self.run_scene(LAMP + STAGES)
        expected = self.rows("bolts.csv")
        self.assertEqual({row["bolt"] for row in expected}, {"cable", "rod"})
        self.assertEqual(expected[0]["bolt"], "cable")
        # The second stage has begun, and its end may change.
        self.run_scene((LAMP + STAGES).replace("duration = 0.2\ninstall", "duration = 0.1\ninstall"))
        checkpoint = self.directory / "checkpoint"
        checkpoint.write_bytes((self.output / "checkpoint").read_bytes())
        self.run_scene(LAMP + STAGES, "--from", checkpoint)
        resumed = self.rows("bolts.csv")
        for of_resumed, of_whole in zip(resumed[-2:], expected[-2:]):
            self.assertEqual(of_resumed["bolt"], of_whole["bolt"])
            self.assertAlmostEqual(float(of_resumed["tension"]) / float(of_whole["tension"]), 1, delta=1e-3)

    def test_a_block_that_has_moved_away_carries_its_bolt(self):
        """Both ends are at the border of their blocks, and the lamp hangs lower when the stage begins."""
        text = (LAMP + STAGES).replace('blocks = ["ground", "lamp"]\n', "")
        text = text.replace("from = [1, 4.5]", "from = [0.3, 4]").replace("to = [0.3, 0.5]", "to = [0.3, 1]")
        self.run_scene(text.replace("pretension = 78480", "pretension = 0"))
        self.assertEqual({row["bolt"] for row in self.rows("bolts.csv")}, {"cable", "rod"})

    def test_files_of_a_height_map(self):
        """It goes on level to the ends of the blocks, and a cell is divided from its smallest to its largest corner."""
        (self.directory / "heights.csv").write_text("1,2,4\n1,1,1\n")
        self.run_scene(POOL)
        surface = self.vtk_file("frames/water_0000.vtp")
        points = [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]
        self.assertEqual([min(p[axis] for p in points) for axis in range(3)], [-3, -2, 1])
        self.assertEqual([max(p[axis] for p in points) for axis in range(3)], [3, 2, 4])
        self.assertEqual(surface.GetNumberOfPolys(), 2 * 4 * 3)
        locator = vtk.vtkCellLocator()
        locator.SetDataSet(surface)
        locator.BuildLocator()
        for place, height in (((1.75, 0.25), 1.75), ((1.25, 0.75), 2.25), ((-2.5, -1), 1), ((2.5, 0.5), 2.5)):
            hit = [0.0] * 3
            locator.IntersectWithLine((*place, -9), (*place, 9), 1e-9, vtk.reference(0.0), hit, [0.0] * 3,
                                      vtk.reference(0))
            self.assertAlmostEqual(hit[2], height, delta=1e-12)

    def test_faults_name_the_key(self):
        for old, new, fault in [
            ("from = [0, 4.5]", "from = [0, 3]", r":\d+:8: bolt\[0\]\.from: \[0, 3\] is outside of all blocks"),
            ("to = [0, 0.5]", "to = [0.5, 4.5]", r"bolt\[0\]\.to: both ends are in one block"),
            ("to = [0, 0.5]", "to = [0, 4.5]", r"bolt\[0\]\.to: the same place"),
            ("to = [0, 0.5]", 'to = [0, 0.5]\nblocks = ["lamp", "lmp"]', r'bolt\[0\]\.blocks: no such block: "lmp"'),
            ("to = [0, 0.5]", 'to = [0, 0.5]\nblocks = ["lamp"]', r"bolt\[0\]\.blocks: 1 blocks; allowed: two"),
            ("pretension = 78480", "pretension = -1", r"bolt\[0\]\.pretension: out of range: -1"),
            ("pretension = 78480", 'bears = "push"', r"bolt\[0\]\.bears: unknown word"),
        ]:
            self.check_fault(LAMP.replace(old, new).replace("[world]", "[world]\nduration = 1"), fault)
        self.check_fault(LAMP + '[[stage]]\ndo = "settle"\ninstall = ["cabel"]\n', r"did you mean 'cable'")
        later = LAMP + STAGES
        self.check_fault(later.replace('blocks = ["ground", "lamp"]', 'blocks = ["ground", "lmp"]'), r'bolt\[1\]\.blocks: no such block: "lmp"')
        hole = later.replace('blocks = ["ground", "lamp"]\n', "")
        self.check_fault(hole.replace("from = [1, 4.5]", "from = [1, 3]"),
                         r'bolt\[1\]\.from: \[1, 3\] is outside of all blocks; the nearest is "ceiling", 1 m away; allowed: ')
        self.check_fault(hole.replace("from = [1, 4.5]", "from = [0.2, 0.3]"), r'bolt\[1\]\.to: both ends are in "lamp"')
        excavated = hole.replace('install = ["rod"]', 'install = ["rod"]\nexcavate = ["lamp"]')
        self.check_fault(excavated, r'bolt\[1\]\.to: \[0\.3, 0\.5\] is outside of all blocks once "lamp" is excavated; ')
        self.check_fault(later.replace('install = ["rod"]', 'install = ["rod"]\nexcavate = ["lamp"]'),
                         r'bolt\[1\]\.blocks: "lamp" is excavated by then')
        self.check_fault(POND.replace("level = 0.5", ""), r"water\.table: missing")
        self.check_fault(POND.replace("level = 0.5", "table = [[1, 0], [0, 0]]"), r"water\.table: point 1 is to the left")
        three = POND.replace("level = 0.5", "table = [[0, 0], [1, 0], [2, 0]]")
        self.check_fault(three + '[[stage]]\ndo = "settle"\n[stage.water]\ntable = [[0, 0], [1, 0]]\n',
                         r"stage\[1\]\.water: a table of 2 points after one of 3")

    def test_a_wet_slope_stands_with_bolts_only(self):
        text = (EXAMPLES / "wet_slope" / "wet_slope.toml").read_text()
        self.run_scene(text)
        self.assertLess(float(self.rows()[-1]["largest_speed"]), 0.01)
        self.run_scene(text.replace("stiffness = 2e7", "stiffness = 1").replace("pretension = 2e5", "pretension = 0"))
        self.assertGreater(float(self.rows()[-1]["largest_speed"]), 0.5)

    def test_bolts_hold_slices_on_a_plane_that_is_steeper_than_their_friction(self):
        text = (EXAMPLES / "bolted_slope" / "bolted_slope.toml").read_text()
        run = self.run_scene(text)
        self.assertRegex(run.stdout, r"stage bolted +settled .*, at rest")
        self.assertLess(float(self.rows()[-1]["largest_speed"]), 1e-3)
        with open(self.output / "bolts.csv", newline="") as file:
            last = list(csv.DictReader(file))[-3:]
        # The slices follow their bolts by less than a millimetre.
        for bolt in last:
            self.assertAlmostEqual(float(bolt["tension"]), 1e5, delta=2e7 * 1e-3)
        loose = text.replace("stiffness = 2e7", "stiffness = 1").replace("pretension = 1e5", "pretension = 0")
        self.run_scene(loose.replace('do = "settle"', 'do = "run"\nduration = 0.1'))
        self.assertGreater(float(self.rows()[-1]["largest_speed"]), 1)


main()
