"""The page of a run in a browser: it plays, picks and colours, and its pixels show what the scene must show."""
import math
import pathlib
import socket
import subprocess
import sys
import tempfile
import unittest

import matplotlib
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from browser import Browser

COMMAND = sys.argv[1]
SCENES = pathlib.Path(__file__).parent / "scenes"
GRAVITY = 9.81


def frame_at(path):
    """A frame by VTK's own reader."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def vertices_at(path):
    """The vertices of all blocks in a frame."""
    data = frame_at(path)
    blocks = vtk_to_numpy(data.GetCellData().GetArray("block"))
    corners = {}
    for cell, block in enumerate(blocks):
        points = data.GetCell(cell).GetPoints()
        corners.setdefault(int(block), []).extend(points.GetPoint(i) for i in range(points.GetNumberOfPoints()))
    return {block: np.unique(np.array(points), axis=0) for block, points in corners.items()}


class ViewerTest(unittest.TestCase):
    scene = ""
    block_count = 3

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.output = pathlib.Path(temporary.name, "out")
        answer = subprocess.run([COMMAND, "run", SCENES / cls.scene, "-o", cls.output, "--view"], capture_output=True, text=True)
        assert answer.returncode == 0, answer.stderr + answer.stdout
        assert f"view.html: 9 frames of {cls.block_count} blocks" in answer.stdout, answer.stdout
        cls.browser.open(cls.output / "view.html")

    def setUp(self):
        self.browser.run("viewer.player.pause(); viewer.setOpacity(1); viewer.setSection(-1); viewer.select(-1);"
                         "if (viewer.layers.available().includes('forces')) viewer.setLayer('forces', false); await viewer.player.goTo(0)")

    def tearDown(self):
        self.assertEqual(self.browser.problems(), [])
        self.assertEqual(self.browser.fetched(), [])

    def go_to(self, number):
        self.browser.run("await viewer.player.goTo(a[0])", number)

    def frame_path(self, number):
        return self.output / "frames" / f"frame_{number:04}.vtp"

    def colour_at(self, pixel, screenshot):
        """The median of nine pixels, so that no smoothed line between two colours counts."""
        x, y = round(pixel[0]), round(pixel[1])
        return np.median(screenshot[y - 1:y + 2, x - 1:x + 2].reshape(9, 3), axis=0)

    def assert_colour(self, found, wanted, delta=12):
        self.assertLess(np.abs(found - wanted).max(), delta, f"{found} is not {wanted}")

    def check_vertices(self):
        """The page unpacks the vertices of the frames, within the step of the lattice."""
        for number in range(9):
            self.go_to(number)
            shown = self.browser.run(
                "const {blockMesh} = viewer.picture; return viewer.recording.blocks.map((block) => "
                "blockMesh.verticesOf(block).map((vertex) => vertex.toArray()))"
            )
            for block, vertices in vertices_at(self.frame_path(number)).items():
                distances = np.linalg.norm(vertices[:, None] - np.array(shown[block])[None], axis=2)
                # Half a step of each coordinate, 1/2048 of a block, and half a step of 1/4096 in the rotation.
                self.assertLess(distances.min(axis=1).max(), 1e-3)


class Plane(ViewerTest):
    scene = "plane.toml"

    def pixel_of(self, x, y):
        """From the view: an orthographic camera that looks along z."""
        target, extent, width, height = self.browser.run(
            "const {target, distance, width, height} = viewer.picture.control;"
            "return [[target.x, target.y], distance, width, height]"
        )
        scale = height / extent
        return width / 2 + (x - target[0]) * scale, height / 2 - (y - target[1]) * scale

    def show_displacement(self, high):
        self.browser.run("await viewer.setField(viewer.fields.find((field) => field.name === 'displacement'));"
                         "viewer.setRange([0, a[0]])", high)

    def test_vertices(self):
        self.check_vertices()

    def test_pixels_have_the_colours_of_a_free_fall(self):
        drop = 0.5 * GRAVITY * 0.5**2
        self.show_displacement(4.0)
        start = self.pixel_of(4, 5.5)
        self.go_to(0)
        before = self.browser.screenshot()
        viridis = matplotlib.colormaps["viridis"]
        self.assert_colour(self.colour_at(start, before), 255 * np.array(viridis(0.0)[:3]))
        self.go_to(5)
        after = self.browser.screenshot()
        place = self.pixel_of(4, 5.5 - drop)
        self.assert_colour(self.colour_at(place, after), 255 * np.array(viridis(drop / 4)[:3]))
        background = self.colour_at(self.pixel_of(-2.5, 6), after)
        self.assert_colour(self.colour_at(self.pixel_of(4, 5.5 + 0.4), after), background)
        # The block's lower side, and the gap below it.
        self.assert_colour(self.colour_at(self.pixel_of(4, 5.1 - drop), after), 255 * np.array(viridis(drop / 4)[:3]))
        self.assert_colour(self.colour_at(self.pixel_of(4, 4.9 - drop), after), background)

    def test_picking(self):
        drop = 0.5 * GRAVITY * 0.5**2
        self.go_to(5)
        self.browser.click(*self.pixel_of(4.2, 5.7 - drop))
        text = self.browser.element("inspector").text
        self.assertIn("falling", text)
        self.assertIn("rigid", text)
        row = next(line for line in text.splitlines() if line.startswith("displacement y"))
        self.assertAlmostEqual(float(row.split()[2].replace("−", "-")), -drop, delta=0.01)
        speed = next(line for line in text.splitlines() if line.startswith("speed"))
        self.assertAlmostEqual(float(speed.split()[1]), GRAVITY * 0.5, delta=0.04)  # rounded to 1/256, and to 3 digits
        self.browser.click(*self.pixel_of(1.5, 0.75))
        self.assertIn("resting", self.browser.element("inspector").text)
        self.assertIn("with floor", self.browser.element("inspector").text)
        self.browser.click(*self.pixel_of(-2.5, 6))
        self.assertIn("Click a block", self.browser.element("inspector").text)

    def test_history_of_a_block(self):
        self.show_displacement(4.0)
        series = self.browser.run(
            "viewer.select(1); await viewer.inspector.historyShown; return viewer.inspector.chart.series"
            ".map(({times, values}) => [[...times], [...values]])")
        (times, values), = series
        self.assertEqual(len(times), 9)
        for time, value in zip(times, values):
            self.assertAlmostEqual(value, 0.5 * GRAVITY * time**2, delta=2e-3)

    def test_stresses(self):
        """Stresses of a block on the floor, where compression is negative, are those of the frames."""
        self.browser.run("await viewer.setField(viewer.fields.find((field) => field.name === 'stress yy'))")
        for number in range(9):
            self.go_to(number)
            shown = self.browser.run("return [...viewer.field.valuesIn(viewer.frame)]")
            cells = frame_at(self.frame_path(number)).GetCellData()
            blocks, stresses = (vtk_to_numpy(cells.GetArray(name)) for name in ("block", "stress"))
            np.testing.assert_allclose(np.array(shown)[blocks], stresses[:, 4], rtol=1 / 256)
        self.assertLess(stresses[:, 4].min(), -1000)

    def test_materials(self):
        self.browser.run("await viewer.setField(viewer.fields.find((field) => field.name === 'material'))")
        shown = self.browser.screenshot()
        colours = self.browser.run("return categoryColours.slice(0, 2).map(rgbOf)")
        self.assert_colour(self.colour_at(self.pixel_of(1.5, 0.75), shown), colours[0])
        self.assert_colour(self.colour_at(self.pixel_of(5, -0.5), shown), colours[1])
        self.assertEqual(self.browser.run("return viewer.recording.materials"), ["rock", "ground"])

    def test_layers(self):
        """The bolt and the water table are where they are in the scene; contact forces point up from the floor."""
        shown = self.browser.screenshot()
        along = np.array([2.5, -3.25]) / math.hypot(2.5, 3.25)
        bolt, water = (255 * np.array(self.browser.run(f"return layerColours.{name}")) for name in ("bolt", "water"))
        self.assert_colour(self.nearest(self.pixel_of(-2 + 1.5 * along[0], 4 + 1.5 * along[1]), shown, bolt), bolt, 60)
        self.assert_colour(self.nearest(self.pixel_of(4, 0.5), shown, water), water, 60)
        self.browser.run("viewer.setLayer('forces', true); viewer.layers.forceScale = 4; await viewer.player.goTo(8)")
        begin, end = self.browser.run("const {begins, ends} = viewer.layers.bars.forces; return [[...begins.slice(0, 3)], [...ends.slice(0, 3)]]")
        self.assertLess(abs(begin[0] - end[0]), 0.3 * abs(begin[1] - end[1]))
        self.assertLess(abs(begin[1] + end[1]), 0.05)  # its middle is in the joint at y = 0
        compression = 255 * np.array(self.browser.run("return layerColours.compression"))
        shown = self.browser.screenshot()
        middle = self.pixel_of((begin[0] + end[0]) / 2, 0.2)
        self.assert_colour(self.nearest(middle, shown, compression), compression, 60)

    def nearest(self, pixel, screenshot, colour):
        """The colour most like another one within three pixels."""
        x, y = round(pixel[0]), round(pixel[1])
        near = screenshot[y - 3:y + 4, x - 3:x + 4].reshape(-1, 3)
        return near[np.abs(near - colour).max(axis=1).argmin()]

    def test_energies(self):
        """The outer work begins at 0, although the ledger's includes the energy at the start; a name hides its line."""
        shown = self.browser.run("const {history} = viewer, {values} = history.series('outer_work');"
                                 "return [history.columns.get('outer_work')[0], values[0]]")
        self.assertGreater(shown[0], 1000)
        self.assertEqual(shown[1], 0)
        entry = self.browser.element("energy-legend").find_element("tag name", "button")
        self.assertEqual(entry.text, "kinetic")
        charts = [self.browser.run("if (a[0]) a[0].click(); return viewer.controls.charts[0].canvas.toDataURL()", button)
                  for button in (None, entry, entry)]
        self.assertNotEqual(charts[1], charts[0])
        self.assertEqual(charts[2], charts[0])

    def test_narrow_window(self):
        """The panel is hidden at first, and leaves the button free that hides it again; a long title ends before it."""
        size = self.browser.driver.get_window_size()
        self.addCleanup(lambda: self.browser.open(self.output / "view.html"))
        self.addCleanup(self.browser.driver.set_window_size, size["width"], size["height"])
        self.browser.driver.set_window_size(500, 800)
        self.browser.open(self.output / "view.html")
        self.assertFalse(self.browser.element("panel").is_displayed())
        for is_shown in (True, False):
            self.browser.element("panel-toggle").click()
            self.assertEqual(self.browser.element("panel").is_displayed(), is_shown)
        widths = self.browser.run("const context = document.createElement('canvas').getContext('2d');"
                                  "return [context.measureText(shortened(context, 'a '.repeat(200), 100)).width, shortened(context, 'slope', 100)]")
        self.assertLessEqual(widths[0], 100)
        self.assertEqual(widths[1], "slope")

    def test_playing(self):
        self.browser.run("document.getElementById('picture').focus()")
        self.browser.type(" ")
        self.assertTrue(self.browser.run("return viewer.player.isPlaying"))
        # However slow the machine is: it shows other frames, and begins again after the last one.
        self.browser.run(
            "const next = () => new Promise((shown) => requestAnimationFrame(() => shown(viewer.frame.number)));"
            "let largest = 0, number = 0;"
            "while (number >= largest) { largest = number; number = await next(); }")
        self.browser.type(" ")
        self.assertFalse(self.browser.run("return viewer.player.isPlaying"))
        number = self.browser.run("return viewer.player.goTo(3).then(() => viewer.frame.number)")
        self.assertEqual(number, 3)
        self.assertIn("4 / 9", self.browser.element("time").text)

    def test_saved_picture(self):
        size = self.browser.run("viewer.draw(); const blob = await viewer.picture.png(); return [blob.type, blob.size]")
        self.assertEqual(size[0], "image/png")
        self.assertGreater(size[1], 5000)


class Cracks(ViewerTest):
    scene = "cracks.toml"

    def cracks(self):
        """The ends of the bars: begin and end, x and y."""
        ends = self.browser.run("const {begins, ends, count} = viewer.layers.bars.cracks;"
                                "return [begins, ends].map((points) => count > 0 ? [...points.slice(0, 3 * count)] : [])")
        return np.array(ends).reshape(2, -1, 3)[:, :, :2]

    def test_broken_joint(self):
        """The cracks fill the joint as it breaks, and stay on both sides of it when the brick has fallen."""
        self.assertEqual(self.cracks().size, 0)
        self.go_to(8)
        begins, ends = self.cracks()
        at_wall = begins[:, 1] > 3.9  # the brick has fallen by 3 m
        self.assertEqual(2 * at_wall.sum(), len(begins))
        np.testing.assert_allclose([begins[at_wall, 0], ends[at_wall, 0]], 1, atol=5e-3)
        heights = np.sort(np.array([begins[at_wall, 1], ends[at_wall, 1]]), axis=0)
        lower, upper = heights[:, heights[0].argsort()]
        np.testing.assert_allclose(lower[1:], upper[:-1], atol=5e-3)
        np.testing.assert_allclose([lower[0], upper[-1]], [4, 5], atol=5e-3)
        corners = np.array(self.browser.run(
            "return viewer.picture.blockMesh.verticesOf(viewer.recording.blocks[1]).map((v) => [v.x, v.y])"))
        side = corners[[0, 3]]
        for point in np.concatenate((begins[~at_wall], ends[~at_wall])):
            around = np.linalg.norm(side - point, axis=1).sum()  # 1, the length of the side, on it
            self.assertLess(around, 1.005)


class OpenJoints(ViewerTest):
    scene = "joints.toml"

    def test_opening(self):
        """A brick leaves a wall at 0.1 m/s, and their joint is drawn in the middle between them, as wide as it is. Far
        from the origin of the run, places on the page have an origin of their own."""
        x, y = (start - own for start, own in zip((500000, 5000000), self.browser.run("return viewer.recording.origin")))
        self.assertLess(max(abs(x), abs(y)), 1000)
        self.browser.run("await viewer.setLayer('joints', true)")
        for number in range(9):
            self.go_to(number)
            bars = np.array(self.browser.run(
                "const {begins, ends, widths, count} = viewer.layers.bars.joints;"
                "return count === 0 ? [] : [...begins.slice(0, 2), ...ends.slice(0, 2), widths[1], count]"))
            opening = 0.01 * number
            middle = x + 2 + opening / 2
            wanted = [middle, y + 1, middle, y + 2, opening, 1] if number > 0 else []
            np.testing.assert_allclose(bars, wanted, atol=1e-3)  # the other brick stays, so its joint is no bar

    def test_parted_blocks_have_no_joint(self):
        self.browser.run("await viewer.setLayer('joints', true); viewer.picture.blockMesh.states[8] += 0.2;"
                         "viewer.layers.show(viewer.frame)")
        self.assertEqual(self.browser.run("return viewer.layers.bars.joints.count"), 0)


class SpaceTest(ViewerTest):
    """The parts that pages in space share."""

    def pixel_of(self, point):
        """From the view: a perspective camera above the horizon, z up."""
        target, distance, azimuth, elevation, width, height, angle = self.browser.run(
            "const c = viewer.picture.control; return [c.target.toArray(), c.distance, c.azimuth, c.elevation, c.width,"
            "c.height, c.camera.fov * Math.PI / 180]")
        outward = np.array([math.cos(elevation) * math.sin(azimuth), -math.cos(elevation) * math.cos(azimuth),
                            math.sin(elevation)])
        right = np.array([math.cos(azimuth), math.sin(azimuth), 0])
        up = np.cross(outward, right)
        at = np.array(point) - np.array(target)
        scale = height / 2 / math.tan(angle / 2) / (distance - at @ outward)
        return width / 2 + at @ right * scale, height / 2 - at @ up * scale


class Space(SpaceTest):
    scene = "space.toml"

    def test_vertices(self):
        self.check_vertices()

    def test_picking(self):
        for azimuth, elevation in ((-0.5, 0.4), (0.7, 0.9)):
            self.browser.run("viewer.picture.control.look(a[0], a[1])", azimuth, elevation)
            for place, name in (((-1.5, 0, 1), "left"), ((1.5, 0, 4.5), "right"), ((0, -0.8, 0), "floor")):
                self.browser.click(*self.pixel_of(place))
                self.assertIn(name, self.browser.element("inspector").text)

    def test_orbit(self):
        before = self.browser.run("return viewer.picture.control.azimuth")
        self.browser.drag(600, 400, 100, 0)
        self.assertAlmostEqual(self.browser.run("return viewer.picture.control.azimuth"), before - 0.8, delta=0.01)

    def test_section(self):
        """Beyond the section there is nothing; the cut block shows its colour in the plane of the cut."""
        self.browser.run("await viewer.setField(viewer.fields.find((field) => field.name === 'material'));"
                         "viewer.picture.control.look(Math.PI / 2, 0)")
        low, high = self.browser.run("const {box} = viewer.picture.control; return [box.min.x, box.max.x]")
        self.browser.run("viewer.setSection(0, (1.5 - a[0]) / (a[1] - a[0]), false)", low, high)
        shown = self.browser.screenshot()
        right = self.colour_at(self.pixel_of((1.5, 0, 4.5)), shown)
        material = np.array(self.browser.run("return rgbOf(categoryColours[0])"))
        self.assert_colour(right / right.max(), material / material.max(), 0.06)
        background = self.colour_at((self.pixel_of((1.5, 0, 4.5))[0], 200), shown)
        self.browser.run("viewer.setSection(0, (0.5 - a[0]) / (a[1] - a[0]), false)", low, high)
        shown = self.browser.screenshot()
        self.assert_colour(self.colour_at(self.pixel_of((0.5, 0, 4.5)), shown), self.colour_at((300, 200), shown))
        self.assertGreater(np.abs(self.colour_at(self.pixel_of((-1, 0, 0.5)), shown) - background).max(), 20)

    def test_open_joint(self):
        """The joint of a block on the floor has the corners of its lower face, also where a tilt opens it."""
        bars = ("const {begins, count} = viewer.layers.bars.joints;"
                "return Array.from({length: count}, (_, i) => [...begins.slice(3 * i, 3 * i + 3)])")
        self.browser.run("await viewer.setLayer('joints', true)")
        self.assertEqual(self.browser.run(bars), [])
        self.browser.run("const {states} = viewer.picture.blockMesh; states[2] += 0.05;"
                         "states[5] = Math.sin(0.02); states[7] = Math.cos(0.02); viewer.layers.show(viewer.frame)")
        corners = np.array(sorted(self.browser.run(bars)))
        # The middle between the floor and the block, whose sides are at most 0.5 tan 0.04 higher and lower.
        np.testing.assert_allclose(corners[:, :2], [[-2, -0.5], [-2, 0.5], [-1, -0.5], [-1, 0.5]], atol=0.02)
        np.testing.assert_allclose(corners[:, 2], 0.025 + 0.01 * np.array([1, 1, -1, -1]), atol=1e-3)

    def test_forces_are_seen_through_blocks(self):
        self.browser.run("viewer.setLayer('forces', true); await viewer.player.goTo(8)")
        self.assertEqual(self.browser.run("return viewer.picture.blockMesh.uniforms.opacity.value"), 0.25)
        self.assertGreater(self.browser.run("return viewer.layers.bars.forces.count"), 0)


class Cells(SpaceTest):
    """Blocks that joints have cut, whose faces have their vertices in any order."""
    scene = "cells.toml"
    block_count = 18

    def test_vertices(self):
        self.check_vertices()


class Terrain(SpaceTest):
    scene = "terrain.toml"
    block_count = 9

    def test_triangles_are_stored_once(self):
        """Frames have the box only; the triangles are where they are, one of them until it is excavated after 0.4 s."""
        self.assertEqual(self.browser.run("return viewer.frame.column('blocks', 'x').length"), 1)
        wanted = vertices_at(self.output / "frames" / "terrain_0000.vtp")
        for number in (0, 4, 5, 8):
            self.go_to(number)
            shown = self.browser.run(
                "const {blockMesh} = viewer.picture; return viewer.recording.blocks.map((block) => "
                "blockMesh.isPresent(block.number) && blockMesh.verticesOf(block).map((vertex) => vertex.toArray()))")
            for block, vertices in wanted.items():
                if block == 8 and number > 4:
                    self.assertFalse(shown[block])
                else:
                    distances = np.linalg.norm(vertices[:, None] - np.array(shown[block])[None], axis=2)
                    self.assertLess(distances.min(axis=1).max(), 1e-6)

    def test_picking(self):
        self.browser.click(*self.pixel_of((0.6, 0.2, 0)))
        text = self.browser.element("inspector").text
        self.assertRegex(text, r"ground\.\d")
        self.assertIn("kind fixed", text)
        self.browser.click(*self.pixel_of((1, 0.5, 0.5)))
        self.assertIn("box", self.browser.element("inspector").text)


def check_localhost():
    """Selenium reaches its driver by this name. Without an address it would only say that the driver did not start."""
    try:
        socket.getaddrinfo("localhost", None)
    except socket.gaierror as error:
        sys.exit(f"The name localhost has no address ({error}): /etc/hosts needs the line '127.0.0.1 localhost'.")


if __name__ == "__main__":
    check_localhost()
    with Browser() as ViewerTest.browser:
        unittest.main(argv=sys.argv[:1])
