"""Files of blocks, regions and boundaries in a scene, as `halfspace check` counts them. What the readers make of them is tested with the command's parts."""
import math
import tempfile
import unittest
from pathlib import Path

import vtk

from command import halfspace, main

HEAD = """
[world]
duration = 1
time_step = 1e-3
[[material]]
name = "rock"
density = 2700
[default_law]
stiffness = "per contact"
normal_stiffness = 1e8
shear_stiffness = 1e8
"""
TETRAHEDRON = "OFF 4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
TWO_SOLIDS = TETRAHEDRON.replace("4 4 6", "8 8 12").replace(
    "\n3 0 2 1", "\n2 0 0\n3 0 0\n2 1 0\n2 0 1\n3 0 2 1", 1) + "3 4 6 5\n3 4 5 7\n3 5 6 7\n3 6 4 7\n"


class Sources(unittest.TestCase):
    def check(self, scene, **files):
        with tempfile.TemporaryDirectory() as directory:
            folder = Path(directory, "scene")
            folder.mkdir()
            for name, content in files.items():
                Path(folder, name.replace("_", ".")).write_text(content)
            head = "dimension = 3\n" + HEAD
            if scene.startswith("dimension = 2\n"):
                head, scene = "dimension = 2\n" + HEAD, scene.removeprefix("dimension = 2\n")
            Path(folder, "scene.toml").write_text(head + scene)
            return halfspace("check", "scene/scene.toml", cwd=directory)  # files are relative to the scene

    def check_count(self, count, scene, **files):
        answer = self.check(scene, **files)
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))
        self.assertIn(f"no faults, {count} blocks", answer.stdout)

    BLOCK = '[[block]]\nname = "rock"\nmaterial = "rock"\nfile = "rocks.off"\n'

    def test_a_file_of_one_block_has_its_name(self):
        self.check_count(1, self.BLOCK + '[output]\ntracked = ["rock"]\n', rocks_off=TETRAHEDRON)

    def test_blocks_of_a_file_are_numbered(self):
        self.check_count(2, self.BLOCK + '[output]\ntracked = ["rock.0", "rock.1"]\n', rocks_off=TWO_SOLIDS)
        answer = self.check(self.BLOCK + '[output]\ntracked = ["rock"]\n', rocks_off=TWO_SOLIDS)
        self.assertIn('no such block: "rock"', answer.stderr)

    BOUNDARY = 'dimension = 2\n[[block]]\nname = "ground"\nmaterial = "rock"\nkind = "fixed"\n'

    def test_boundaries_are_blocks_numbered_if_there_are_several(self):
        floor = self.BOUNDARY + "boundary = [[9, 0], [-9, 0]]\ndepth = 1\n"
        self.check_count(1, floor + '[output]\ntracked = ["ground"]\n')
        chain = floor.replace("[-9, 0]", "[0, 0], [-9, 4]")
        self.check_count(2, chain + '[output]\ntracked = ["ground.0", "ground.1"]\n')
        self.check_count(2, chain.replace("fixed", "prescribed"))

    def test_segments_of_a_boundary_know_their_neighbours(self):
        # Down a wall, over a floor, down a step: the floor reaches on behind the wall by 1 / tan(60), and its other
        # flank is the bisector at the ridge. The wall, whose other end is free, has a flank of 60 degrees there.
        scene = self.BOUNDARY + "boundary = [[5, 3], [5, 0], [0, 0], [0, -3]]\ndepth = 1\n"
        with tempfile.TemporaryDirectory() as directory:
            path, output = Path(directory, "scene.toml"), Path(directory, "out")
            path.write_text("dimension = 2\n" + HEAD.replace("duration = 1", "duration = 1e-3")
                            + scene.removeprefix("dimension = 2\n"))
            answer = halfspace("run", path, "-o", output)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(str(output / "frames" / "frame_0000.vtp"))
            reader.Update()
        cells = (reader.GetOutput().GetCell(i).GetPoints() for i in range(3))
        wall, floor, step = ([points.GetPoint(i)[:2] for i in range(points.GetNumberOfPoints())] for points in cells)
        reach = 1 / math.sqrt(3)
        for block, expected in ((wall, [(5, 3), (5, -reach), (6, -reach), (6, 3 + reach)]),
                                (floor, [(5 + reach, 0), (0, 0), (1, -1), (5 + reach, -1)]),
                                (step, [(0, 0), (0, -3), (1, -3 - reach), (1, -1)])):
            self.assertEqual(len(block), len(expected))
            for corner in expected:
                self.assertLess(min(math.dist(corner, found) for found in block), 1e-14)

    def test_faults_of_boundaries(self):
        floor = self.BOUNDARY + "boundary = [[9, 4], [0, 4], [-9, 4]]\ndepth = 1\n"
        for change, fault in ((("depth = 1\n", ""), "block[0].depth: missing; required: a number above 0"),
                              (("depth = 1", "depth = 0"), "block[0].depth: out of range: 0"),
                              ((", [0, 4], [-9, 4]", ""), "block[0].boundary: too few points"),
                              (("fixed", "rigid"), "block[0].boundary: a boundary does not move freely; allowed: with kind"),
                              (("[0, 4]", "[9, 4]"), "block[0].boundary: segment 0: second is (9, 4); it must differ from"),
                              (("depth = 1", "depth = 1e-20"), "block[0].boundary: segment 0: depth is 1e-20")):
            answer = self.check(floor.replace(*change))
            self.assertIn(fault, answer.stderr)
            self.assertIn("1 fault in", answer.stderr)
        self.assertIn("block[0].boundary: unknown key", self.check(floor.removeprefix("dimension = 2\n")).stderr)

    def test_a_faulty_file_is_told_once_with_its_line(self):
        scene = self.BLOCK + '[output]\ntracked = ["rock.0"]\n'
        answer = self.check(scene, rocks_off=TETRAHEDRON.replace("0 1 0", "0 1 O"))
        self.assertIn('block[0].file: rocks.off:4: not a finite number: "O"', answer.stderr)
        self.assertIn("1 fault in", answer.stderr)

    def test_regions_are_boxes_hulls_and_parts(self):
        joints = "[[jointed_rock.joint_set]]\ndip = 90\ndip_direction = 90\nspacing = 1\n"
        rock = '[[jointed_rock]]\nname = "slope"\nmaterial = "rock"\n'
        self.check_count(4, rock + "box = [[-0.5, 0, 0], [2.5, 1, 1]]\n" + joints)
        self.check_count(2, rock + "region = [[0.5, 0, 0], [1.5, 0, 0], [0.5, 1, 0], [0.5, 0, 1]]\n" + joints)
        parts = "[[jointed_rock.part]]\nbox = [[0.5, 0, 0], [1.5, 1, 1]]\n"
        parts += "[[jointed_rock.part]]\nbox = [[0.5, 0, 1], [2.5, 1, 2]]\n"
        self.check_count(2 + 3, rock + parts + joints)
        answer = self.check(rock + "box = [[0, 0, 0], [1, 1, 1]]\n" + parts + joints)
        self.assertIn("jointed_rock[0].box: unknown key", answer.stderr)

    def test_regions_in_the_plane_are_boxes_polygons_and_parts(self):
        joints = "[[jointed_rock.joint_set]]\ndip = 90\nspacing = 1\n"
        rock = 'dimension = 2\n[[jointed_rock]]\nname = "slope"\nmaterial = "rock"\n'
        self.check_count(4, rock + "box = [[-0.5, 0], [2.5, 1]]\n" + joints)
        self.check_count(2, rock + "region = [[0.5, 0], [1.5, 0], [0.5, 1]]\n" + joints)
        parts = "[[jointed_rock.part]]\nbox = [[0.5, 0], [1.5, 1]]\n"
        parts += "[[jointed_rock.part]]\nregion = [[0.5, 1], [2.5, 1], [2.5, 2]]\n"
        self.check_count(2 + 3, rock + parts + joints)

    def test_joints_without_number_are_a_fault_and_not_lost(self):
        rock = 'dimension = 2\n[[jointed_rock]]\nname = "slope"\nmaterial = "rock"\nbox = [[0, 0], [1, 1]]\n'
        joints = "[[jointed_rock.joint_set]]\ndip = 0\nspacing = {}\noffset = {}\n"
        for spacing in (5e-324, 1e-300, 1e-20, 1e-12, 1e-9):
            answer = self.check(rock + joints.format(spacing, 0) + '[output]\ntracked = ["slope.0"]\n')
            self.assertEqual(answer.returncode, 1)
            self.assertIn("jointed_rock[0].joint_set[0].spacing: about ", answer.stderr)
            self.assertIn("1 fault in", answer.stderr)
        self.assertIn("joint_set[0].spacing: below the rounding", self.check(rock + joints.format(0.1, 1e20)).stderr)
        column = rock.replace("[1, 1]", "[5e-5, 1]")
        self.check_count(20_000, column + joints.format(5e-5, 0))  # each block is cut by its own joints only

    def test_cells_fill_a_region(self):
        self.check_count(25, '[[voronoi]]\nname = "cell"\nmaterial = "rock"\ncount = 25\nrelaxation = 3\n'
                             "box = [[0, 0, 0], [1, 2, 3]]\n")


if __name__ == "__main__":
    main()
