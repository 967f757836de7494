"""The files of a run, read by other people's readers: VTK's for the series, an XML parser for the pictures."""
import csv
import resource
import signal
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from time import sleep

import vtk
from vtk.util.numpy_support import vtk_to_numpy

from command import COMMAND, SCENES, halfspace, main

FALLING = SCENES / "falling_block.toml"


def read_frame(path):
    problems = []
    reader = vtk.vtkXMLPolyDataReader()
    reader.AddObserver("ErrorEvent", lambda *event: problems.append(event))
    reader.AddObserver("WarningEvent", lambda *event: problems.append(event))
    reader.SetFileName(str(path))
    reader.Update()
    assert not problems and reader.GetErrorCode() == 0, path
    return reader.GetOutput()


def centroid(polygon):
    """Of a polygon's area, by triangles from its first corner."""
    area, x, y = 0.0, 0.0, 0.0
    (ax, ay), rest = polygon[0], polygon[1:]
    for (bx, by), (cx, cy) in zip(rest, rest[1:]):
        part = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        area, x, y = area + part, x + part * (ax + bx + cx) / 3, y + part * (ay + by + cy) / 3
    return x / area, y / area


class OutputFiles(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.output = Path(temporary.name, "out")

    def run_falling(self, *options):
        return halfspace("run", FALLING, "-o", self.output, *options)

    def test_a_file_that_cannot_be_written_is_named_with_the_reason(self):
        """A limit of the size of files, as a full disk needs rights of an administrator."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
        answer = halfspace("run", FALLING, "-o", self.output, preexec_fn=limit)
        self.assertEqual(answer.returncode, 1)
        self.assertRegex(answer.stderr, rf"^halfspace: cannot write {self.output}/\S+: File too large\n$")
        self.assertEqual(list(self.output.rglob("*.part")), [])

    def test_lost_output_is_a_failure(self):
        with open("/dev/full", "w") as full:
            answer = subprocess.run([COMMAND, "check", str(FALLING)], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(answer.returncode, 1)
        self.assertEqual(answer.stderr, "halfspace: cannot write the standard output: No space left on device\n")

    def test_a_second_run_into_a_directory_is_refused_until_the_first_ends(self):
        long = ("run", FALLING, "-o", self.output, "--set", "world.duration=1e4")
        first = subprocess.Popen([COMMAND, *map(str, long)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(first.kill)
        while not (self.output / "frames" / "frame_0000.vtp").exists():
            sleep(0.01)
        for options in ((), ("--force",)):
            answer = self.run_falling(*options)
            self.assertEqual(answer.returncode, 1)
            self.assertIn(f"the directory {self.output} is in use by another run; give each run", answer.stderr)
        first.kill()
        first.wait()
        self.assertEqual(self.run_falling("--force").returncode, 0)

    def test_series_for_paraview(self):
        self.assertEqual(self.run_falling().returncode, 0)
        with open(self.output / "history.csv", newline="") as stream:
            history = {round(float(row["time"]), 6): row for row in csv.DictReader(stream)}
        entries = ElementTree.parse(self.output / "run.pvd").getroot().findall("Collection/DataSet")
        self.assertEqual([round(float(entry.get("timestep")), 6) for entry in entries], [0, 0.1, 0.2, 0.3, 0.4, 0.5])
        for entry in entries:
            data = read_frame(self.output / entry.get("file"))
            row = history[round(float(entry.get("timestep")), 6)]
            self.assertEqual(data.GetFieldData().GetArray("TimeValue").GetValue(0), float(row["time"]))
            self.check_frame(data, row)

    def check_frame(self, data, row):
        self.assertEqual((data.GetNumberOfPolys(), data.GetNumberOfPoints()), (3, 4 + 4 + 3))
        cells = {name: vtk_to_numpy(data.GetCellData().GetArray(name))
                 for name in ("block", "kind", "material", "velocity", "displacement", "angle", "angular_velocity",
                              "contact_force")}
        self.assertEqual(list(cells["block"]), [0, 1, 2])
        self.assertEqual(list(cells["kind"]), [2, 0, 1])
        self.assertEqual(list(cells["material"]), [0, 0, 0])
        for cell, name in ((0, "falling"), (2, "lift")):
            number = {column: float(row[f"{name}.{column}"]) for column in ("x", "y", "vx", "vy", "angle")}
            self.assertEqual(list(cells["velocity"][cell]), [number["vx"], number["vy"], 0])
            self.assertEqual(cells["angle"][cell], number["angle"])
            points = data.GetCell(cell).GetPoints()
            x, y = centroid([points.GetPoint(i)[:2] for i in range(points.GetNumberOfPoints())])
            # Coordinates below 16 and some ten operations: 10 * 2^-50.
            self.assertAlmostEqual(x, number["x"], delta=1e-14)
            self.assertAlmostEqual(y, number["y"], delta=1e-14)
        start = {"falling": (0.5, 4.5)}
        self.assertAlmostEqual(cells["displacement"][0][1], float(row["falling.y"]) - start["falling"][1], delta=1e-14)
        self.assertEqual(list(cells["displacement"][1]), [0, 0, 0])

    def test_pictures_are_svg_with_axes_title_and_time(self):
        self.assertEqual(self.run_falling().returncode, 0)
        for name, time in (("first.svg", "t = 0.000 s"), ("last.svg", "t = 0.500 s")):
            root = ElementTree.parse(self.output / name).getroot()
            space = "{http://www.w3.org/2000/svg}"
            texts = [element.text for element in root.iter(space + "text")]
            for text in ("A block falls onto a plate", time, "x (m)", "y (m)", "displacement (m)"):
                self.assertIn(text, texts)
            self.assertEqual(len(list(root.iter(space + "path"))), 3, "one outline for each block")

    def test_every_file_is_whole_and_told(self):
        answer = self.run_falling()
        told = {"run.pvd", "blocks.csv", "show_in_paraview.py", "checkpoint", "history.csv", "first.svg", "last.svg",
                "summary.txt"}
        self.assertEqual({path.name for path in self.output.iterdir()}, told | {"frames"})
        self.assertEqual({path.name for path in (self.output / "frames").iterdir()},
                         {f"frame_{k:04}.vtp" for k in range(6)})
        for name in told:
            self.assertIn(str(self.output / name), answer.stdout)
        self.assertIn("(6 frames)", answer.stdout)
        self.assertTrue(answer.stdout.startswith((self.output / "summary.txt").read_text()))

    def test_blocks_have_numbers_names_kinds_and_materials(self):
        self.assertEqual(self.run_falling().returncode, 0)
        self.assertEqual((self.output / "blocks.csv").read_text(),
                         "number,name,kind,material_number,material\n0,falling,rigid,0,stone\n"
                         "1,plate,fixed,0,stone\n2,lift,prescribed,0,stone\n")

    def test_the_script_for_paraview_is_python(self):
        self.assertEqual(self.run_falling().returncode, 0)
        script = (self.output / "show_in_paraview.py").read_text()
        compile(script, "show_in_paraview.py", "exec")
        self.assertIn('Text(Text="A block falls onto a plate")', script)

    def test_a_view_of_what_is_no_run_is_refused(self):
        self.output.mkdir()
        for directory, text in ((self.output, "has no run.pvd"), (self.output / "missing", "there is no directory")):
            answer = halfspace("view", directory)
            self.assertEqual(answer.returncode, 1)
            self.assertIn(text, answer.stderr)
        self.assertEqual(list(self.output.iterdir()), [])

    def test_a_damaged_frame_is_named(self):
        self.assertEqual(self.run_falling().returncode, 0)
        frame = self.output / "frames" / "frame_0002.vtp"
        for content in (frame.read_bytes()[:-100], b"", b"<VTKFile/>"):
            frame.write_bytes(content)
            answer = halfspace("view", self.output)
            self.assertEqual(answer.returncode, 1)
            self.assertIn("frame_0002.vtp", answer.stderr)
        self.assertFalse((self.output / "view.html").exists())

    def test_a_directory_with_files_is_not_touched_unless_forced(self):
        self.output.mkdir()
        (self.output / "notes.txt").write_text("mine")
        (self.output / "frames").mkdir()
        (self.output / "frames" / "frame_0099.vtp").write_text("of an earlier run")
        refused = self.run_falling()
        self.assertEqual(refused.returncode, 1)
        self.assertIn("--force", refused.stderr)
        self.assertEqual({path.name for path in self.output.iterdir()}, {"notes.txt", "frames"})
        self.assertEqual(self.run_falling("--force").returncode, 0)
        self.assertEqual((self.output / "notes.txt").read_text(), "mine")
        self.assertFalse((self.output / "frames" / "frame_0099.vtp").exists())

    def test_what_an_earlier_run_could_not_have_written_stays(self):
        (self.output / "frames").mkdir(parents=True)
        kept = [self.output / "at_homes.svg", self.output / "frames" / "frame_of_mind.vtp"]
        gone = [self.output / "at_1e-05s.svg", self.output / "frames" / "frame_12345.vtp"]
        for path in kept + gone:
            path.write_text("mine")
        self.assertEqual(self.run_falling("--force").returncode, 0)
        self.assertEqual([path.exists() for path in kept + gone], [True, True, False, False])

    def test_links_are_replaced_and_what_they_lead_to_is_left_alone(self):
        elsewhere = self.output.with_name("elsewhere")
        elsewhere.mkdir()
        (elsewhere / "frame_0099.vtp").write_text("of another run")
        victim = elsewhere / "victim"
        victim.write_text("keep")
        self.output.mkdir()
        (self.output / "frames").symlink_to(elsewhere)
        for name in ("summary.txt.part", "history.csv.part", "history.csv", "last.svg", "at_1s.svg"):
            (self.output / name).symlink_to(victim)
        (self.output / "first.svg.part").symlink_to(elsewhere / "new")  # leads nowhere yet
        (self.output / "run.pvd.part").hardlink_to(victim)
        self.assertEqual(self.run_falling("--force").returncode, 0)
        self.assertEqual({path.name for path in elsewhere.iterdir()}, {"frame_0099.vtp", "victim"})
        self.assertEqual(victim.read_text(), "keep")
        written = [path for path in self.output.rglob("*")]
        self.assertEqual([path.name for path in written if path.is_symlink()], [])
        self.assertEqual(len([path for path in written if path.suffix == ".vtp"]), 6)
        self.assertFalse((self.output / "at_1s.svg").exists())


if __name__ == "__main__":
    main()
