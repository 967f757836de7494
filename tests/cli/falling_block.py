"""A free fall and a prescribed lift, against their closed forms.

Velocity Verlet is exact under constant acceleration, so only rounding is left. In each of the 500 steps a coordinate
below 8 and a speed below 8 take at most four roundings of half a unit in the last place, 2^-51 = 4.4e-16: 500 * 4 *
4.4e-16 < 1e-12.
"""
import csv
import math
import tempfile
import unittest
from pathlib import Path

from command import SCENES, halfspace, main

ROUNDING = 1e-12
GRAVITY = 9.81


class FallingBlock(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as directory:
            answer = halfspace("run", SCENES / "falling_block.toml", "-o", directory)
            assert answer.returncode == 0, answer.stderr
            with open(Path(directory, "history.csv"), newline="") as stream:
                cls.rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(stream)]

    def test_rows_come_at_their_interval(self):
        self.assertEqual([row["steps"] for row in self.rows], [50 * k for k in range(11)])
        for k, row in enumerate(self.rows):
            self.assertAlmostEqual(row["time"], 0.05 * k, delta=ROUNDING)

    def test_free_fall(self):
        worst = 0
        for row in self.rows:
            t = row["time"]
            expected = {"falling.x": 0.5 + 0.25 * t, "falling.y": 4.5 + 0.5 * t - GRAVITY * t * t / 2,
                        "falling.angle": math.radians(30) * t, "falling.vx": 0.25, "falling.vy": 0.5 - GRAVITY * t,
                        "falling.angular_velocity": math.radians(30)}
            for name, value in expected.items():
                self.assertAlmostEqual(row[name], value, delta=ROUNDING, msg=name)
                worst = max(worst, abs(row[name] - value))
        print(f"largest deviation from free fall {worst:.2g}, allowed {ROUNDING:.2g}")

    def test_prescribed_motion_starts_and_stops(self):
        for row in self.rows:
            t = row["time"]
            risen = 2 * (min(max(t, 0.1), 0.3) - 0.1)
            self.assertAlmostEqual(row["lift.y"], 1 / 3 + risen, delta=ROUNDING)
            self.assertEqual(row["lift.x"], self.rows[0]["lift.x"])

    def test_energy_of_the_fall(self):
        # The energies are of the order of 2000 kg * 9.81 m/s2 * 5 m = 1e5 J; their rounding grows with the steps
        # likewise.
        for row in self.rows:
            speed2 = 0.25**2 + (0.5 - GRAVITY * row["time"])**2
            kinetic = 2000 * speed2 / 2 + 2000 / 6 * math.radians(30)**2 / 2
            self.assertAlmostEqual(row["kinetic"], kinetic, delta=1e5 * ROUNDING)
            self.assertEqual(row["contacts"], 0)


if __name__ == "__main__":
    main()
