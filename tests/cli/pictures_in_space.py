"""Pictures of a scene in space: a drawing around an image, which VTK's PNG reader reads."""
import base64
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import vtk
from vtk.util.numpy_support import vtk_to_numpy

from command import SCENES, SceneTest, halfspace, main

SPACE = "{http://www.w3.org/2000/svg}"


def pixels_of(image_element, directory):
    """Rows from below, as VTK has them."""
    head, data = image_element.get("href").split(",")
    assert head == "data:image/png;base64"
    path = Path(directory, "image.png")
    path.write_bytes(base64.b64decode(data, validate=True))
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)


class PicturesInSpace(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        text = (SCENES / "falling_block_in_space.toml").read_text()
        scene = Path(temporary.name, "scene.toml")
        # Straight from the south, at the falling block and what is below it: 1 m is 80 pixels of the drawing, 160 of
        # the image.
        scene.write_text(text + "[output.picture]\nwindow = [[-4, -1, -1], [5, 2, 7]]\nazimuth = 180\nelevation = 0\n")
        scene.with_name("tetrahedron.off").write_text((SCENES / "tetrahedron.off").read_text())
        answer = halfspace("run", scene, "-o", Path(temporary.name, "out"))
        assert answer.returncode == 0, answer.stderr
        cls.roots = {name: ElementTree.parse(Path(temporary.name, "out", name)).getroot()
                     for name in ("first.svg", "last.svg")}
        cls.pixels = {name: pixels_of(root.find(SPACE + "image"), temporary.name) for name, root in cls.roots.items()}

    def test_title_time_scale_axes_and_colours_are_told(self):
        for name, time in (("first.svg", "t = 0.000 s"), ("last.svg", "t = 0.500 s")):
            texts = [element.text for element in self.roots[name].iter(SPACE + "text")]
            for text in ("A block falls onto a plate, in space", time, "displacement (m)", "x", "y", "z", "2 m"):
                self.assertIn(text, texts)

    def test_the_window_is_the_same(self):
        first, last = (self.roots[name].find(SPACE + "image") for name in ("first.svg", "last.svg"))
        for key in ("x", "y", "width", "height"):
            self.assertEqual(first.get(key), last.get(key))
        self.assertEqual((first.get("width"), first.get("height")), ("720.00", "640.00"))
        for pixels in self.pixels.values():
            self.assertEqual(pixels.shape, (1280, 1440, 3))

    def test_blocks_are_where_they_are_and_the_rest_is_white(self):
        first = self.pixels["first.svg"]

        def at(x, z):
            return list(first[round(160 * (z + 1)), round(160 * (x + 4))])

        self.assertEqual(at(-3.5, 3), [255, 255, 255])
        self.assertEqual(at(0.5, 6.2), [255, 255, 255])
        red, green, blue = at(0.5, 5)  # nothing has moved yet: the blue end of the colours, shaded
        self.assertLess(red, green)
        self.assertLess(green, blue)
        red, green, blue = at(0.5, -0.5)  # the plate is grey
        self.assertLess(max(red, green, blue) - min(red, green, blue), 12)
        for x, z in ((0, 5), (1, 5), (0.5, 4), (0.5, 6)):  # there are dark lines at the edges
            row, column = round(160 * (z + 1)), round(160 * (x + 4))
            self.assertLess(first[row - 2:row + 3, column - 2:column + 3].max(axis=2).min(), 60)

    def test_the_fall_is_seen(self):
        # After 0.5 s the upper face is at 6 + 0.25 - 9.81 / 8 = 5.02 m.
        last = self.pixels["last.svg"]
        self.assertEqual(list(last[round(160 * 6.5), round(160 * 4.6)]), [255, 255, 255])
        self.assertNotEqual(list(last[round(160 * 5.5), round(160 * 4.6)]), [255, 255, 255])


class ExcavatedInSpace(SceneTest):
    def test_a_block_that_has_been_excavated_is_in_no_picture_any_more(self):
        text = (SCENES / "falling_block_in_space.toml").read_text().replace("duration = 0.5\n", "")
        text = text[:text.index('[[block]]\nname = "lift"')] + """
[[stage]]
do = "run"
duration = 0.01
[[stage]]
do = "run"
duration = 0.01
excavate = ["falling"]
[output.picture]
window = [[-4, -1, -1], [5, 2, 7]]
azimuth = 180
elevation = 0
"""
        self.run_scene(text)
        row, column = 160 * (5 + 1), 80 * 9  # in the middle of the falling block
        for name, is_white in (("first.svg", False), ("last.svg", True)):
            image = ElementTree.parse(self.output / name).getroot().find(SPACE + "image")
            self.assertEqual((pixels_of(image, self.directory)[row, column] == 255).all(), is_white, name)


class Numbers(SceneTest):
    def test_blocks_that_are_seen_have_their_numbers_on_request(self):
        # A small block stands behind a large one, and one stands beside it.
        text = (SCENES / "falling_block_in_space.toml").read_text()
        text = text[:text.index("[[block]]")]
        for name, x, y, size in (("large", 0, 0, 2), ("hidden", 0.5, 3, 1), ("beside", 4, 0, 1)):
            corners = [[x + dx * size, y + dy * size, dz * size]
                       for dz in (0, 1) for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1))]
            text += f'[[block]]\nname = "{name}"\nmaterial = "stone"\nvertices = {corners}\n'
        view = "[output.picture]\nnumbers = true\nazimuth = 180\nelevation = 0\nwindow = [[-1, -1, -1], [6, 5, 3]]\n"
        self.run_scene(text + view)
        labels = {label.text: label for label in ElementTree.parse(self.output / "first.svg").iter(SPACE + "text")}
        self.assertNotIn("1", labels)
        scale = 840 / 7
        # The baseline is 0.35 of the font's size, 12, below the middle.
        for number, (x, z) in (("0", (1, 1)), ("2", (4.5, 0.5))):
            self.assertAlmostEqual(float(labels[number].get("x")), 72 + scale * (x + 1), delta=1)
            self.assertAlmostEqual(float(labels[number].get("y")), 56 + scale * (3 - z) + 0.35 * 12, delta=1)


if __name__ == "__main__":
    main()
