"""Scenes that a user has mistyped, each legal: they get a note with its place, the value and the usual one, and are not refused."""
import re
import tempfile
import unittest
from pathlib import Path

from command import EXAMPLES, SCENES, halfspace, main

PILE = """title = "Two stones on a floor"
dimension = 2
[world]
gravity = [0, -9.81]
duration = 1
[[material]]
name = "stone"
density = 2700
young_modulus = 5e9
poisson_ratio = 0.25
damping_time = 1e-4
[[material]]
name = "soil"
density = 2000
[default_law]
stiffness = "per area"
normal_stiffness = 1e9
shear_stiffness = 5e8
friction_angle = 30
normal_damping = 0.3
shear_damping = 0.3
[[law]]
between = ["stone", "soil"]
friction_angle = 25
[[block]]
name = "floor"
material = "soil"
kind = "fixed"
vertices = [[-2, -1], [3, -1], [3, 0], [-2, 0]]
[[block]]
name = "lower"
material = "stone"
kind = "affine"
vertices = [[0, 0], [1, 0], [1, 1], [0, 1]]
[[block]]
name = "upper"
material = "stone"
vertices = [[0, 1], [1, 1], [1, 2], [0, 2]]
"""

IN_SPACE = """dimension = 3
[world]
gravity = [0, 0, -9.81]
duration = 1
[[material]]
name = "stone"
density = 2700
[default_law]
stiffness = "per contact"
normal_stiffness = 1e8
friction_angle = 30
[[block]]
name = "floor"
material = "stone"
kind = "fixed"
vertices = [[-2, -2, -1], [3, -2, -1], [3, 3, -1], [-2, 3, -1], [-2, -2, 0], [3, -2, 0], [3, 3, 0], [-2, 3, 0]]
[[block]]
name = "cube"
material = "stone"
file = "cube.obj"
"""

CUBE = """v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""

BEAM = """dimension = 2
[world]
gravity = [0, -9.81]
duration = 0.1
[[material]]
name = "rock"
density = 2500
young_modulus = 1e10
poisson_ratio = 0.25
[[material]]
name = "ore"
density = 2500
young_modulus = 1e10
poisson_ratio = 0.25
[default_law]
stiffness = "per area"
normal_stiffness = 1e9
[[bond]]
between = ["rock", "ore"]
normal_stiffness = 1e12
tensile_strength = 1e6
cohesion = 2e6
friction_angle = 30
tensile_fracture_energy = 50
[[mesh]]
name = "beam"
material = "rock"
box = [[0, 0], [4, 1]]
cells = [4, 1]
cell = "quad"
normal_stress = [-1e5, -2e5]
normal_stress_by_height = [12000, 24525]
[[mesh.support]]
group = "left"
[[mesh.load]]
group = "bottom"
traction = [0, -1e5]
[[block]]
name = "vein"
material = "ore"
kind = "affine"
vertices = [[0, 1], [4, 1], [4, 2], [0, 2]]
"""

GROUND = """dimension = 2
[world]
[[material]]
name = "rock"
density = 2500
young_modulus = 1e10
poisson_ratio = 0.25
[default_law]
stiffness = "per area"
normal_stiffness = 1e9
[[mesh]]
name = "ground"
material = "rock"
box = [[0, 0], [5, 5]]
cells = [5, 5]
cell = "quad"
[[mesh.support]]
group = "bottom"
[[stage]]
do = "settle"
excavate = ["ground.12"]
"""

SQUARES = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
6
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
$EndNodes
$Elements
3
1 1 2 7 1 1 4
2 3 2 0 1 1 2 5 4
3 3 2 0 1 2 3 6 5
$EndElements
"""

FILE_MESH = """dimension = 2
[world]
duration = 0.1
[[material]]
name = "rock"
density = 2500
young_modulus = 1e10
poisson_ratio = 0.25
[default_law]
stiffness = "per area"
normal_stiffness = 1e9
[[mesh]]
name = "beam"
material = "rock"
file = "squares.msh"
[[mesh.support]]
group = "7"
[[block]]
name = "stone"
material = "rock"
vertices = [[0, 1], [1, 1], [1, 2], [0, 2]]
"""


def edited(text, *changes):
    """The text with each old part, which has to be in it, in its new form."""
    for old, new in zip(changes[::2], changes[1::2]):
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def only(text, name):
    """Without the other blocks."""
    head, *blocks = re.split(r"(?=\[\[block\]\])", text)
    return head + "".join(block for block in blocks if f'name = "{name}"' in block)


class UnusualScenes(unittest.TestCase):
    def notes(self, text, **files):
        with tempfile.TemporaryDirectory() as directory:
            for name, content in files.items():
                Path(directory, name.replace("_", ".")).write_text(content)
            scene = Path(directory, "scene.toml")
            scene.write_text(text)
            answer = halfspace("check", scene)
            self.assertEqual((answer.returncode, answer.stderr), (0, ""))
            return [line.removeprefix(f"{scene}:") for line in answer.stdout.splitlines()[1:]]

    def assert_one(self, text, pattern, **files):
        notes = self.notes(text, **files)
        self.assertEqual(len([note for note in notes if re.search(pattern, note)]), 1, (pattern, notes))

    def test_scenes_that_are_meant_so_get_none(self):
        for text in (PILE, BEAM, GROUND):
            self.assertEqual(self.notes(text), [])
        self.assertEqual(self.notes(IN_SPACE, cube_obj=CUBE), [])
        self.assertEqual(self.notes(FILE_MESH, squares_msh=SQUARES), [])

    def test_examples_and_scenes_of_tests_get_none(self):
        scenes = [*EXAMPLES.glob("*/*.toml"), *SCENES.glob("*.toml")]
        self.assertGreater(len(scenes), 10)
        known = {"unstable.toml"}  # its time step is above the stable one on purpose
        for scene in scenes:
            answer = halfspace("check", scene)
            if answer.returncode == 0 and scene.name not in known:
                with self.subTest(scene=scene.name):
                    self.assertNotRegex(answer.stdout, r"usual|sinks|falls|fall |no bond|no block is of")

    def test_values_in_other_units(self):
        for key, old, values, usual in (
                ("material[0].density", "density = 2700", (2.7, 2.7e-6, 26.5, 2.7e6, 26500), r"50 to 19500 kg/m3"),
                ("default_law.friction_angle", "friction_angle = 30", (0.5, 0.6, 1.2, 89), "0, or 2 to 75 degrees"),
                ("law[0].friction_angle", "friction_angle = 25", (0.5,), "0, or 2 to 75 degrees"),
                ("default_law.normal_damping", "normal_damping = 0.3", (30, 5), "0 to 1, a fraction of critical damping"),
                ("default_law.shear_damping", "shear_damping = 0.3", (30,), "0 to 1"),
                ("default_law.normal_stiffness", "normal_stiffness = 1e9", (5, 1e18), "1e3 to 1e14"),
                ("material[0].young_modulus", "young_modulus = 5e9", (50, 5e4), "1e6 to 2e12 Pa"),
                ("material[0].poisson_ratio", "poisson_ratio = 0.25", (-0.25, 0.4999), r"0 to 0\.49"),
                ("material[0].damping_time", "damping_time = 1e-4", (0.05,), r"up to 0\.02 s"),
                ("world.mass_damping", "duration = 1", (1e4,), "up to 100 1/s"),
                ("world.rest_speed", "duration = 1", (5,), r"up to 0\.1 m/s")):
            for value in values:
                name = key.rsplit(".", 1)[1]
                added = f"{old}\n" if old.startswith("duration") else ""
                text = edited(PILE, old, f"{added}{name} = {value}")
                line = next(i for i, each in enumerate(text.splitlines(), 1) if each == f"{name} = {value}")
                self.assert_one(text, rf"^{line}:\d+: note: {re.escape(key)}: \S+ is unusual; usual: {usual}")
        self.assert_one(edited(PILE, "friction_angle = 30", "friction_angle = 30\ncohesion = 5"),
                        r"default_law\.cohesion: 5 is unusual; usual: 0, or 100 to 1e9 Pa")
        for key, old in (("tensile_strength", "1e6"), ("cohesion", "2e6"), ("friction_angle", "30"),
                         ("normal_stiffness", "1e12"), ("tensile_fracture_energy", "50")):
            self.assert_one(edited(BEAM, f"{key} = {old}", f"{key} = 0.05"),
                            rf"bond\[0\]\.{key}: 0\.05 is unusual; usual: ")
        self.assert_one(edited(BEAM, "[0, -1e5]", "[0, -5]"), r"mesh\[0\]\.load\[0\]\.traction: \[0, -5\] is unusual")
        self.assert_one(edited(BEAM, "traction = [0, -1e5]", "pressure = 5"), r"pressure: 5 is unusual")
        self.assert_one(edited(BEAM, "[-1e5, -2e5]", "[-0.1, -0.2]"), r"normal_stress: \[-0\.1, -0\.2\] is unusual")
        self.assert_one(edited(BEAM, "[-1e5, -2e5]", "[1e5, 2e5]"), "normal_stress above 0, tension")
        for value in (-24525, 24.5):
            self.assert_one(edited(BEAM, "24525", str(value)),
                            rf"normal_stress_by_height of {value} Pa/m upwards; usual: density times gravity, 2\.45\de\+04 Pa/m")

    def test_angles_in_radians(self):
        self.assert_one(edited(PILE, 'name = "floor"', 'name = "floor"\nrotation = 0.5236'),
                        r"rotation: 0\.5236 is 30 degrees in radians; usual: degrees")
        rock = '[[jointed_rock]]\nname = "rock"\nmaterial = "stone"\nbox = [[-1, 0], [-0.2, 2]]\n[[jointed_rock.joint_set]]\n'
        self.assert_one(PILE + rock + "dip = 0.6\nspacing = 0.5\n", r"dip: 0\.6 is unusual; usual: 0, or 2 to 90 degrees")
        self.assertEqual(self.notes(PILE + rock + "dip = 30\nspacing = 0.5\n"), [])

    def test_gravity(self):
        for value in ("[0, -9810]", "[0, -981]", "[0, -32.2]", "[0, -0.00981]"):
            self.assert_one(edited(PILE, "[0, -9.81]", value), r"^4:11: note: world\.gravity: .* is unusual; usual: 9\.81 m/s2")
        self.assert_one(edited(PILE, "[0, -9.81]", "[0, 9.81]"), r"gravity: \[0, 9\.81\] points upwards; usual: along -y")
        self.assert_one(edited(IN_SPACE, "[0, 0, -9.81]", "[0, -9.81, 0]"),
                        r"^3:11: note: world\.gravity: \[0, -9\.81, 0\] has no component along z; usual: along -z, as z is up", cube_obj=CUBE)
        self.assertEqual(self.notes(edited(PILE, "[0, -9.81]", "[4, -9.81]")), [])
        self.assertEqual(self.notes(edited(PILE, "[0, -9.81]", "[0, 0]")), [])

    def test_times(self):
        self.assert_one(edited(PILE, "duration = 1", "duration = 1e-6"), r"^5:12: note: world\.duration: 1e-06 s is shorter than")
        self.assert_one(edited(PILE, "duration = 1", "duration = 1e8"), r"world\.duration: 1e\+08 s takes \S+ steps")
        self.assert_one(edited(PILE, "duration = 1", "duration = 1\ntime_step = 1e-12"), "far below the stable time step")
        self.assert_one(PILE + "[output]\nframe_interval = 50\n", r"frame_interval: 50 s is longer than the run, 1 s")
        self.assert_one(PILE + "[output]\nframe_interval = 1e-7\n", r"frame_interval: 1e-07 s is short for 1 s")
        self.assert_one(edited(PILE, "duration = 1", "duration = 1\nrest_speed = 1e-3", "normal_damping = 0.3", "normal_damping = 0"),
                        "may never be reached without damping")
        moved = edited(PILE, 'kind = "fixed"', 'kind = "prescribed"\nvelocity = [0.1, 0]\nstart = 1000')
        self.assert_one(moved, "starts to move at 1000 s, after the end of the run, 1 s")

    def test_scenes_that_nothing_holds_up(self):
        self.assert_one(edited(PILE, 'kind = "fixed"\n', ""),
                        r'^26:8: note: block\[0\]: "floor" and 2 blocks with it fall: no block is fixed or prescribed, .*kind = "fixed"')
        self.assert_one(edited(BEAM, '[[mesh.support]]\ngroup = "left"\n', ""), r"mesh is held along gravity; usual: a floor")
        self.assert_one(edited(BEAM, 'group = "left"\n', 'group = "left"\naxes = "x"\n'), "mesh is held along gravity")
        low = "[[-2, -1], [3, -1], [3, 0], [-2, 0]]"
        self.assert_one(edited(PILE, low, "[[-2, -1.5], [3, -1.5], [3, -0.5], [-2, -0.5]]"),
                        r'"lower" and 1 block with it fall 0\.5 m at the start, onto the nearest support')
        self.assert_one(edited(PILE, low, "[[12, -1], [13, -1], [13, 0], [12, 0]]"), "fall out of the scene; usual: a fixed, prescribed or supported block below")
        beside = '[[block]]\nname = "beside"\nmaterial = "stone"\nvertices = [[8, 0], [9, 0], [9, 1], [8, 1]]\n'
        self.assert_one(PILE + beside, r'block\[3\]: "beside" falls out of the scene')
        self.assertEqual(self.notes(edited(PILE + beside, "duration = 1", "duration = 0.01")), [])
        self.assertEqual(self.notes(PILE + beside + 'hold = "y"\n'), [])
        cable = '[[bolt]]\nname = "cable"\nfrom = [8.5, 0.5]\nto = [8.5, 9]\nblocks = ["beside", "ground"]\nstiffness = 1e6\n'
        self.assertEqual(self.notes(PILE + beside + cable), [])
        to_the_pile = edited(cable, "[8.5, 9]", "[0.5, 1.5]", 'blocks = ["beside", "ground"]\n', "")
        self.assertEqual(self.notes(PILE + beside + to_the_pile), [])
        self.assertEqual(self.notes(PILE + beside + "[water]\nlevel = -5\ndensity = 3000\n"), [])
        self.assert_one(PILE + beside + "[water]\nlevel = -5\n", r'"beside" falls out of the scene')
        self.assertEqual(self.notes(PILE + beside + "velocity = [-5, 5]\n"), [])
        self.assertEqual(self.notes(only(PILE, "floor") + edited(beside, "8, 0", "1, 1", "9, 0", "2, 1", "9, 1", "2, 2", "8, 1", "1, 2")), [])
        carried = edited(BEAM, "[0, -9.81]", "[0, 0]", '[[mesh.support]]\ngroup = "left"\n', "")
        self.assert_one(carried, r'"beam\.0" has no support against its loads, 4e\+05 N in all')

    def test_bonds_that_are_not_made(self):
        self.assert_one(edited(BEAM, "[[0, 1], [4, 1], [4, 2], [0, 2]]", "[[0, 1.0001], [4, 1.0001], [4, 2], [0, 2]]"),
                        r'^19:11: note: bond\[0\]\.between: no two blocks .* so that no bond is made; the nearest two, .* are 0\.0001 m apart')
        self.assert_one(edited(BEAM, '"rock", "ore"', '"rock", "rock"'), "no two blocks of these materials have a common face")
        self.assert_one(edited(BEAM, 'material = "ore"\n', 'material = "rock"\n'), 'no block is of "ore", so that no bond is made')
        self.assert_one(edited(BEAM, "tensile_strength = 1e6\ncohesion = 2e6\n", ""), "neither tensile_strength nor cohesion")
        twice = re.search(r"\[\[bond\]\](.|\n)*?(?=\[\[mesh)", BEAM).group(0)
        self.assert_one(edited(BEAM, "[[bond]]", twice + "[[bond]]"), r"bond\[1\]\.between: an earlier \[\[bond\]\]")
        pillar = '[[block]]\nname = "other"\nmaterial = "rock"\nvertices = [[0, 2.0001], [4, 2.0001], [4, 3], [0, 3]]\n'
        self.assert_one(BEAM + pillar, r'1 pair of blocks without a bond, up to 0\.0001 m apart, as "other" and "vein"')

    def test_lengths_in_other_units(self):
        in_mm = re.sub(r"(?m)^v (.*)$", lambda line: "v " + " ".join(f"{1000 * float(x):g}" for x in line.group(1).split()), CUBE)
        self.assert_one(IN_SPACE, r'block\[1\]: "cube" has an extent of 1\.73e\+03 m, .* times larger than all others; usual: lengths in m', cube_obj=in_mm)
        self.assertEqual(self.notes(IN_SPACE + "scale = 0.001\n", cube_obj=in_mm), [])
        self.assert_one(IN_SPACE + "scale = 0.001\n", "times smaller than all others", cube_obj=CUBE)
        self.assert_one(edited(BEAM, "[[0, 0], [4, 1]]", "[[0, 0], [4000, 1000]]"), r"mesh\[0\]: \"beam\" has an extent of 4\.12e\+03 m")
        speck = '[[block]]\nname = "speck"\nmaterial = "stone"\nvertices = [[2, 0], [2.000001, 0], [2.000001, 0.000001], [2, 0.000001]]\n'
        self.assert_one(PILE + speck, "thick, and .* usual: a ratio up to 1e5")
        self.assert_one(edited(PILE, "duration = 1", "duration = 1\nsleep_tolerance = 1"),
                        r"^6:19: note: world\.sleep_tolerance: 1 m is 1 times the thinnest block's thickness; usual: below 1 %")

    def test_surfaces_and_elements_inside_out_or_unjoined(self):
        turned = re.sub(r"(?m)^f (\d) (\d) (\d) (\d)$", r"f \4 \3 \2 \1", CUBE)
        self.assert_one(IN_SPACE, r"^20:8: note: block\[1\]\.file: cube\.obj:9: 1 surface inside out: reversed", cube_obj=turned)
        for old, new, pattern in (
                ("1 2 3 6 5\n", "1 2 5 6 3\n", r"squares\.msh:17: 1 element inside out: reversed; usual: nodes counter-clockwise"),
                ("3\n1 1 2 7", "4\n4 3 2 0 1 1 2 5 4\n1 1 2 7", r"squares\.msh:17: 1 element with the nodes of an earlier one"),
                ("6\n1 0 0 0", "8\n7 1 0 0\n8 1 1 0\n1 0 0 0", None)):
            text = edited(SQUARES, old, new)
            if pattern is None:
                text = edited(text, "1 2 3 6 5\n", "1 7 3 6 8\n")
                pattern = r"squares\.msh: 2 nodes at the place of another, the first at \[1, [01]\]"
            self.assert_one(FILE_MESH, rf"^15:8: note: mesh\[0\]\.file: {pattern}", squares_msh=text)
        hanging = edited(SQUARES, "6\n1 0 0 0", "8\n7 1 0.5 0\n8 2 0.5 0\n1 0 0 0", "3\n1 1 2 7", "4\n4 3 2 0 1 7 8 6 5\n1 1 2 7",
                         "1 2 3 6 5\n", "1 2 3 8 7\n")
        self.assert_one(FILE_MESH, r"1 node in the middle of another element's face or edge, the first at \[1, 0\.5\]", squares_msh=hanging)
        self.assert_one(edited(FILE_MESH, '"squares.msh"', '"squares.msh"\nbodies = "groups"'),
                        r"1 node in the middle of another element's", squares_msh=hanging)

    def test_a_file_in_millimetres_beside_larger_blocks(self):
        """Blocks of 20 m, a mesh of 2 m in mm: 70 times their size."""
        in_mm = re.sub(r"(?m)^(\d) (\d) (\d) 0$", lambda node: f"{node[1]} {node[2]}000 {node[3]}000 0", SQUARES)
        large = edited(FILE_MESH, "[[0, 1], [1, 1], [1, 2], [0, 2]]", "[[0, 1], [20, 1], [20, 21], [0, 21]]")
        self.assert_one(large, r"mesh\[0\]: \"beam\" has an extent of 2\.24e\+03 m, 79\.1 times larger than all others; "
                               r".*scale = 0\.001 for a file in mm", squares_msh=in_mm)

    def test_check_and_run_refuse_a_scene_without_a_time_step(self):
        all_fixed = PILE.replace('kind = "affine"', 'kind = "fixed"').replace('name = "upper"', 'name = "upper"\nkind = "fixed"')
        rigid = PILE.replace('kind = "affine"\n', "")
        springs = rigid[rigid.index("normal_stiffness"):rigid.index("friction_angle = 30")]
        rigid = edited(rigid, "duration = 1", "duration = 1\nsleep_tolerance = 1e-4", springs, "",
                       'stiffness = "per area"', 'stiffness = "none"',
                       "normal_damping = 0.3\nshear_damping = 0.3\n", "")
        with tempfile.TemporaryDirectory() as directory:
            scene = Path(directory, "scene.toml")
            for text in (all_fixed, rigid):
                scene.write_text(text)
                answers = [halfspace("check", scene), halfspace("run", scene, "-o", Path(directory, "out"))]
                for answer in answers:
                    self.assertEqual(answer.returncode, 1)
                    self.assertRegex(answer.stderr, r"world\.time_step: no time step is given and none can be derived: .*\n1 fault in ")
                self.assertEqual(answers[0].stderr, answers[1].stderr)
        self.assert_one(edited(all_fixed, "duration = 1", "duration = 1\ntime_step = 1e-3"), r"all blocks are fixed: nothing moves")

    def test_tables_without_an_effect(self):
        force = '[[action]]\non = "upper"\nkind = "force"\ndirection = [0, 1]\ntable = [[0, %s], [1, 0]]\n'
        shaking = '[[action]]\nkind = "acceleration"\ndirection = [1, 0]\ntable = [[0, 0], [1, %s]]\n'
        water, window = "[water]\nlevel = %s\n", "[output.picture]\nwindow = [[%s, -1], [9, 9]]\n"
        for added, usual, unusual, pattern in (
                (force, 5, 0, r"action\[0\]\.table: all values are 0"),
                (shaking, 3, 300, r"action\[0\]\.table: 300 m/s2 is unusual; usual: up to 100"),
                (water, 0.5, -500, r"water: the table lies 499 m below all blocks; usual: heights in m"),
                (water, 2.5, 2500, r"water: the table lies 2\.5e\+03 m above all blocks; usual: heights in m"),
                (window, -2, 8, r"output\.picture\.window: no block is in it")):
            self.assertEqual(self.notes(PILE + added % usual), [])
            self.assert_one(PILE + added % unusual, pattern)
        mesh = '[[block]]\nname = "third"\nmaterial = "stone"\nkind = "mesh"\ncell_size = %s\nvertices = [[0, 2], [1, 2], [1, 3], [0, 3]]\n'
        for usual in (0.05, 0.5):
            self.assertEqual(self.notes(PILE + mesh % usual), [])
        flat = mesh.replace("3]", "2.1]").replace("[1, 2", "[4, 2")
        self.assertEqual(self.notes(PILE + flat % 1), [])  # divided along, not across
        self.assert_one(PILE + mesh % 50, r'block\[3\]\.cell_size: 50 m is larger than the block')
        rock = ('[[jointed_rock]]\nname = "rock"\nmaterial = "stone"\nsmallest_area = %s\n'
                "region = [[0, 2], [1, 2], [1, 3], [0, 3]]\njoint_set = [{dip = 0, spacing = 0.5}]\n")
        self.assertEqual(self.notes(PILE + rock % 0.1), [])
        self.assert_one(PILE + rock % 100, r'jointed_rock\[0\]: "rock" has no block')

    def test_excavation_of_all_or_around_something(self):
        self.assert_one(edited(GROUND, '"ground.12"', '"ground"'), r"^21:12: note: stage\[0\]\.excavate: excavates all free blocks")
        row = ", ".join(f'"ground.{i}"' for i in range(10, 15))
        self.assert_one(edited(GROUND, '"ground.12"', row), r'leaves 10 blocks without support, such as "ground\.15"')
        ring = ", ".join(f'"ground.{i}"' for i in (6, 7, 8, 11, 13, 16, 17, 18))
        self.assert_one(edited(GROUND, '"ground.12"', ring), r'leaves 1 block without support, such as "ground\.12"')
        again = '[[stage]]\ndo = "settle"\nexcavate = ["ground.12"]\n'
        self.assert_one(GROUND + again, r"stage\[1\]\.excavate: excavates blocks that an earlier stage has excavated")

    def test_materials_laws_and_strengths_that_nothing_uses(self):
        unused = '[[material]]\nname = "clay"\ndensity = 1900\n'
        self.assert_one(edited(PILE, "[default_law]", unused + "[default_law]"), r'material\[2\]\.name: no block is of "clay"')
        law = '[[law]]\nbetween = ["clay", "soil"]\nfriction_angle = 20\n'
        self.assert_one(edited(PILE, "[default_law]", unused + "[default_law]") + law, r'law\[1\]\.between: no block is of "clay"')
        apart = edited(PILE, "friction_angle = 25", "friction_angle = 25\ncohesion = 1e5", "[[0, 0], [1, 0]", "[[0, 0.5], [1, 0.5]")
        self.assert_one(apart, r"law\[0\]: cohesion and tensile_strength act in contacts that exist at the start, and there is none")

    def test_a_run_tells_them_and_goes_on(self):
        with tempfile.TemporaryDirectory() as directory:
            scene = Path(directory, "scene.toml")
            scene.write_text(edited(PILE, "density = 2700", "density = 2.7", "duration = 1", "duration = 0.01"))
            answer = halfspace("run", scene, "-o", Path(directory, "out"))
            self.assertEqual(answer.returncode, 0)
            self.assertIn(f"{scene}:8:11: note: material[0].density: 2.7 is unusual", answer.stderr)
            self.assertIn("scene:8:11: note: material[0].density: 2.7", Path(directory, "out", "summary.txt").read_text())


if __name__ == "__main__":
    main()
