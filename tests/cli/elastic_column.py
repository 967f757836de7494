"""Elastic blocks in a scene: their stress at the start, at rest under their weight, and where it is told."""
import csv
import tempfile
import unittest
from pathlib import Path

import vtk
from vtk.util.numpy_support import vtk_to_numpy

from command import SCENES, halfspace, main

WEIGHT = 2000 * 9.81  # per m of height


class ElasticColumn(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.directory = Path(temporary.name, "out")
        answer = halfspace("run", SCENES / "elastic_column.toml", "-o", cls.directory)
        assert answer.returncode == 0, answer.stderr
        with open(cls.directory / "history.csv", newline="") as stream:
            cls.rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(stream)]

    def test_the_stress_at_the_start_is_that_of_the_scene(self):
        for block in range(3):
            self.assertAlmostEqual(self.rows[0][f"column.{block}.syy"], -5e4, delta=1e-6)
            self.assertAlmostEqual(self.rows[0][f"column.{block}.sxx"], 0, delta=1e-6)

    def test_at_rest_each_block_carries_what_lies_on_it_and_half_of_itself(self):
        for block in range(3):
            expected = -WEIGHT * (2.5 - block)
            # The strain is 5e-4 and the stress Cauchy's, of a width that grows by a quarter of that; what is left of
            # the motion is less.
            self.assertAlmostEqual(self.rows[-1][f"column.{block}.syy"] / expected, 1, delta=1e-3)
            self.assertAlmostEqual(self.rows[-1][f"column.{block}.sxx"] / expected, 0, delta=1e-3)

    def test_energies_of_the_blocks_are_told_and_fixed_blocks_have_no_stress(self):
        self.assertGreater(self.rows[-1]["block_strain"], 0)
        self.assertEqual(self.rows[-1]["block_damping_loss"], 0)
        self.assertNotIn("floor.syy", self.rows[0])

    def test_frames_hold_stress_and_strain(self):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(max((self.directory / "frames").iterdir())))
        reader.Update()
        cells = reader.GetOutput().GetCellData()
        stress, strain = (vtk_to_numpy(cells.GetArray(name)).reshape(-1, 3, 3) for name in ("stress", "strain"))
        for block in range(3):
            self.assertEqual(stress[block + 1][1, 1], self.rows[-1][f"column.{block}.syy"])
            self.assertEqual(strain[block + 1][0, 1], strain[block + 1][1, 0])
        self.assertTrue((stress[0] == 0).all())

    def test_pictures_and_summary_tell_of_it(self):
        self.assertIn("mean stress (MPa)", (self.directory / "last.svg").read_text())
        self.assertIn("(0 rigid, 1 fixed, 0 prescribed, 3 affine)", (self.directory / "summary.txt").read_text())


class ElasticFaults(unittest.TestCase):
    def faults(self, replaced, by):
        text = (SCENES / "elastic_column.toml").read_text()
        assert replaced in text
        with tempfile.TemporaryDirectory() as directory:
            scene = Path(directory, "scene.toml")
            scene.write_text(text.replace(replaced, by))
            answer = halfspace("check", scene)
            self.assertEqual(answer.returncode, 1)
            return answer.stderr

    def test_an_affine_block_needs_an_elastic_material(self):
        answer = self.faults("young_modulus = 1e8\npoisson_ratio = 0.25\n", "")
        self.assertIn("jointed_rock[0].kind: the material \"rock\" is not elastic", answer)

    def test_elastic_constants_come_together_and_in_range(self):
        self.assertIn("material[0].poisson_ratio: missing", self.faults("poisson_ratio = 0.25\n", ""))
        self.assertIn("material[0].poisson_ratio: out of range: 0.5",
                      self.faults("poisson_ratio = 0.25", "poisson_ratio = 0.5"))

    def test_only_affine_blocks_have_a_stress(self):
        answer = self.faults('kind = "affine"', 'kind = "rigid"')
        self.assertIn("jointed_rock[0].normal_stress: only blocks that strain have a stress", answer)


if __name__ == "__main__":
    main()
