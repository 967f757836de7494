"""The valley of Zheng et al. 2020, section 6.2: one slope slumps, the other topples, and which one is up to the joints."""
import csv
import math
import tempfile
import unittest
from pathlib import Path

import vtk
from vtk.util.numpy_support import vtk_to_numpy

from command import EXAMPLES, halfspace, main

SCENE = (EXAMPLES / "rock_valley" / "valley.toml").read_text()
FIXED = 0


def area_and_middle(points):
    """Of a polygon; its middle is the mean of its corners."""
    area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1])) / 2
    return area, sum(p[0] for p in points) / len(points)


class Slope:
    """Means over the blocks that lie on one side at the start, each counting as much as its area."""

    def __init__(self, start, end, side):
        cells = {name: vtk_to_numpy(end.GetCellData().GetArray(name)) for name in ("kind", "angle", "displacement")}
        total = turned = moved = 0
        for i in range(start.GetNumberOfCells()):
            corners = start.GetCell(i).GetPoints()
            area, middle = area_and_middle([corners.GetPoint(k) for k in range(corners.GetNumberOfPoints())])
            if cells["kind"][i] != FIXED and middle * side > 0:
                total += area
                turned += area * cells["angle"][i] * side
                moved -= area * cells["displacement"][i][0] * side
        self.forward_turn = turned / total  # towards the valley, rad
        self.advance = moved / total  # likewise, m


def first_and_last_frame(directory):
    frames = []
    for path in (min(directory.glob("frames/*.vtp")), max(directory.glob("frames/*.vtp"))):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        frames.append(reader.GetOutput())
    return frames


class RockValley(unittest.TestCase):
    def run_scene(self, text, directory):
        scene = Path(directory, "scene.toml")
        scene.write_text(text)
        answer = halfspace("run", scene, "-o", Path(directory, "out"))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(answer.stdout, "potential length +3 m")
        return Path(directory, "out")

    def slopes(self, text):
        with tempfile.TemporaryDirectory() as directory:
            frames = first_and_last_frame(self.run_scene(text, directory))
        return {name: Slope(*frames, side) for name, side in (("left", -1), ("right", 1))}

    def check(self, slopes, slumping, toppling):
        """Both advance by more than the slip of an uncut slope. A slump turns back, a topple forward, and by far."""
        for name, slope in slopes.items():
            print(f"{name} slope: turned forward by {slope.forward_turn:.4f} rad, advanced by {slope.advance:.3f} m")
            self.assertGreater(slope.advance, 0.5)
        self.assertLess(slopes[slumping].forward_turn, -0.01)
        self.assertGreater(slopes[toppling].forward_turn, 0.5)

    def test_the_left_slope_slumps_and_the_right_one_topples(self):
        self.check(self.slopes(SCENE), slumping="left", toppling="right")

    def test_joints_that_dip_to_the_left_change_their_parts(self):
        self.check(self.slopes(SCENE.replace("dip = 75", "dip = -75")), slumping="right", toppling="left")

    def test_uncut_each_slope_comes_to_rest(self):
        # The weight W is there all at once. Until its share sin(30) W on the base is taken up by the shear spring the
        # slope has gathered speed, it passes the limit cos(30) W tan(32) at the slip s = limit / k_t, and slides until
        # friction has spent what was left: (share - limit / 2) s = (limit - share) further. From then on it swings in
        # the spring.
        weight = 2700 * 9.81 * (63.9615 - 29.3205) * 30 / 2
        shear_stiffness = 1e8
        share = weight * math.sin(math.radians(30))
        limit = weight * math.cos(math.radians(30)) * math.tan(math.radians(32))
        slip = limit / shear_stiffness
        slip += (share - limit / 2) * slip / (limit - share)
        swing = (limit - share) / shear_stiffness * math.sqrt(shear_stiffness / (weight / 9.81))  # m/s
        with tempfile.TemporaryDirectory() as directory:
            text = SCENE.replace("spacing = 3", "spacing = 1000\noffset = 500")
            text = text.replace("normal_damping = 0.3\n", "normal_damping = 0.3\nshear_damping = 0\n")
            text = text.replace("[output]\n", '[output]\ntracked = ["left.0", "right.0"]\n')
            with open(self.run_scene(text, directory) / "history.csv", newline="") as stream:
                rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(stream)]
        for name in ("left.0", "right.0"):
            farthest = max(math.hypot(row[f"{name}.x"] - rows[0][f"{name}.x"], row[f"{name}.y"] - rows[0][f"{name}.y"])
                           for row in rows)
            speed = max(math.hypot(row[f"{name}.vx"], row[f"{name}.vy"]) for row in rows if row["time"] > 3)
            print(f"{name}: slips {farthest:.4f} m, expected {slip:.4f} m; then no faster than {speed:.4f} m/s, "
                  f"of {swing:.4f} m/s at most")
            # The limit swings at first, as the slope settles on its base: with 119 rad/s, where its slip takes 8.4
            # rad/s.
            self.assertAlmostEqual(farthest / slip, 1, delta=0.02)
            self.assertLess(speed, swing)
            self.assertLess(abs(rows[-1][f"{name}.angle"]), 1e-4)


if __name__ == "__main__":
    main()
