"""A free fall and a prescribed lift in space, against their closed forms, and the frames as VTK reads them.

The spin is about the principal axis of a square prism, so it stays, and turns about one axis are exact. Rounding as in
falling_block.py, for the quaternion likewise.
"""
import csv
import math
import tempfile
import unittest
from pathlib import Path

import numpy
from vtk.util.numpy_support import vtk_to_numpy

from command import SCENES, halfspace, main
from output_files import read_frame

ROUNDING = 1e-12
GRAVITY = 9.81
SPIN = math.radians(30)


def numbers_of(path):
    with open(path, newline="") as stream:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(stream)]


class FallingBlockInSpace(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as directory:
            answer = halfspace("run", SCENES / "falling_block_in_space.toml", "-o", directory)
            assert answer.returncode == 0, answer.stderr
            cls.rows = numbers_of(Path(directory, "history.csv"))
            cls.frames = [read_frame(Path(directory, "frames", f"frame_{k:04}.vtp")) for k in range(6)]
            cls.summary = Path(directory, "summary.txt").read_text()

    def check(self, row, name, values):
        for component, value in values.items():
            self.assertAlmostEqual(row[f"{name}.{component}"], value, delta=ROUNDING, msg=component)

    def test_free_fall(self):
        for row in self.rows:
            t = row["time"]
            self.check(row, "falling", {
                "x": 0.5 + 0.25 * t, "y": 0.5 - 0.125 * t, "z": 5 + 0.5 * t - GRAVITY * t * t / 2,
                "vx": 0.25, "vy": -0.125, "vz": 0.5 - GRAVITY * t, "wx": 0, "wy": 0, "wz": SPIN,
                "qx": 0, "qy": 0, "qz": math.sin(SPIN * t / 2), "qw": math.cos(SPIN * t / 2)})

    def test_a_block_of_a_file_is_scaled_turned_and_moved(self):
        for row in self.rows:
            risen = 2 * (min(max(row["time"], 0.1), 0.3) - 0.1)
            self.check(row, "lift", {"x": 9.75, "y": 0.25, "z": 0.25 + risen, "qx": 0, "qy": 0,
                                     "qz": math.sqrt(0.5), "qw": math.sqrt(0.5)})

    def test_energy_of_the_fall(self):
        for row in self.rows:
            speed2 = 0.25**2 + 0.125**2 + (0.5 - GRAVITY * row["time"])**2
            kinetic = 4000 * speed2 / 2 + 4000 / 6 * SPIN**2 / 2
            self.assertAlmostEqual(row["kinetic"], kinetic, delta=1e5 * ROUNDING)

    def test_run_out_is_horizontal(self):
        turned = 0.5 * (math.cos(SPIN * 0.5) + math.sin(SPIN * 0.5) - 1)  # the corners swing out
        expected = f"{0.125 + turned:.2f} m towards +x, {turned - 0.125:.2f} m towards -x, "
        expected += f"{turned - 0.0625:.2f} m towards +y, {turned + 0.0625:.2f} m towards -y; 0.0 %"
        self.assertIn(expected, self.summary)

    def test_frames_are_the_faces_of_the_blocks_where_they_are(self):
        for frame in self.frames:
            time = frame.GetFieldData().GetArray("TimeValue").GetValue(0)
            row = min(self.rows, key=lambda row: abs(row["time"] - time))
            self.assertEqual(row["time"], time)
            self.assertEqual((frame.GetNumberOfPolys(), frame.GetNumberOfPoints()), (6 + 6 + 4, 8 + 8 + 4))
            cells = {name: vtk_to_numpy(frame.GetCellData().GetArray(name))
                     for name in ("block", "kind", "material", "velocity", "displacement", "rotation",
                                  "angular_velocity", "contact_force")}
            self.assertEqual(list(cells["block"]), [0] * 6 + [1] * 6 + [2] * 4)
            self.assertEqual(list(cells["kind"]), [2] * 6 + [0] * 6 + [1] * 4)
            self.assertEqual(list(cells["velocity"][0]), [row[f"falling.v{axis}"] for axis in "xyz"])
            self.assertEqual(list(cells["rotation"][0]), [row[f"falling.q{axis}"] for axis in "xyzw"])
            self.assertAlmostEqual(cells["displacement"][0][2], row["falling.z"] - 5, delta=ROUNDING)
            self.check_closed_volumes(frame, [2, 25, 1 / 6], row)

    def check_closed_volumes(self, frame, volumes, row):
        """The faces of each block run counter-clockwise seen from outside and enclose its volume and centroid."""
        points = vtk_to_numpy(frame.GetPoints().GetData())
        block_of = vtk_to_numpy(frame.GetCellData().GetArray("block"))
        for block, volume in enumerate(volumes):
            sum_of_volumes, moment = 0, numpy.zeros(3)
            for cell in numpy.flatnonzero(block_of == block):
                ids = frame.GetCell(cell).GetPointIds()
                corners = points[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
                for a, b in zip(corners[1:], corners[2:]):
                    part = numpy.dot(corners[0], numpy.cross(a, b)) / 6
                    sum_of_volumes += part
                    moment += part * (corners[0] + a + b) / 4
            # Coordinates below 16 in products of three: some hundred roundings of 2^-53 * 4000.
            self.assertAlmostEqual(sum_of_volumes, volume, delta=1e-10)
            name = {0: "falling", 2: "lift"}.get(block)
            if name:
                centroid = [row[f"{name}.{axis}"] for axis in "xyz"]
                numpy.testing.assert_allclose(moment / sum_of_volumes, centroid, atol=1e-9)


if __name__ == "__main__":
    main()
