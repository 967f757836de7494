"""The collapse of Zheng et al. 2020, section 6.1, by potentials: the lower friction runs out further and faster."""
import csv
import re
import tempfile
import unittest
from pathlib import Path

from command import EXAMPLES, halfspace, main

DURATION = 1.0  # s, of the paper's 7.5


class RockCollapse(unittest.TestCase):
    def collapse(self, friction_angle):
        """Run-out and kinetic energy at the end, and the share of the energy set free that the numerics made or lost."""
        text = (EXAMPLES / "rock_collapse" / f"potential_{friction_angle}.toml").read_text()
        text = text.replace("duration = 7.5", f"duration = {DURATION}").replace("times = [2.5, 5.0]\n", "")
        with tempfile.TemporaryDirectory() as directory:
            scene, output = Path(directory, "scene.toml"), Path(directory, "out")
            scene.write_text(text)
            answer = halfspace("run", scene, "-o", output)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            summary = (output / "summary.txt").read_text()
            with open(output / "history.csv", newline="") as stream:
                kinetic = float(list(csv.DictReader(stream))[-1]["kinetic"])
        run_out = float(re.search(r"run-out +(\S+) m to the right", summary).group(1))
        residual = float(re.search(r"energy residual +\S+ J, (\S+) of", summary).group(1))
        print(f"friction angle {friction_angle} degrees: after {DURATION} s run out {run_out} m, kinetic {kinetic:.3e} J, "
              f"energy residual {residual} of what was set free")
        return run_out, kinetic, residual

    def test_lower_friction_runs_out_further_and_faster(self):
        further, faster, residual = self.collapse(15)
        run_out, kinetic, other_residual = self.collapse(30)
        self.assertGreater(further, run_out)
        self.assertGreater(faster, kinetic)
        self.assertLess(abs(residual), 0.01)
        self.assertLess(abs(other_residual), 0.01)


if __name__ == "__main__":
    main()
