"""Terrain: an open surface of triangles as a fixed boundary in space."""
import math
import random
import re
import resource
import struct
import zlib

import vtk
from vtk.util.numpy_support import vtk_to_numpy

from command import SceneTest, halfspace, main

HEAD = """dimension = 3
[world]
duration = {duration}
gravity = {gravity}
time_step = {step}
potential_length = 1
[[material]]
name = "rock"
density = 2000
[default_law]
stiffness = "{stiffness}"
{springs}
friction_angle = 15
"""
TERRAIN = '[[terrain]]\nname = "ground"\nmaterial = "rock"\nfile = "{file}"\ndepth = {depth}\n'
SLOPE = [4.905, 0.3, -8.495709]  # gravity on a slope of 30 degrees, and a little across it


def box(low, high):
    return [[x, y, z] for z in (low[2], high[2]) for x, y in
            ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))]


def block(name, low, high, more=""):
    return f'[[block]]\nname = "{name}"\nmaterial = "rock"\n{more}vertices = {box(low, high)}\n'


def uneven_plane(columns, rows, low, high):
    """Vertices and triangles of a rectangle in the plane z = 0; their sizes differ by some factors."""
    chance = random.Random(3)

    def places(count, begin, end):
        steps = [chance.choice([0.4, 0.7, 1.0, 1.6]) for _ in range(count)]
        return [begin + (end - begin) * sum(steps[:i]) / sum(steps) for i in range(count + 1)]
    xs, ys = places(columns, low[0], high[0]), places(rows, low[1], high[1])
    vertices = []
    for j, y in enumerate(ys):
        for i, x in enumerate(xs):
            is_inner = 0 < i < columns and 0 < j < rows
            away = [chance.uniform(-0.3, 0.3) * min(b - a, c - b) for a, b, c in
                    (xs[i - 1:i + 2], ys[j - 1:j + 2])] if is_inner else (0, 0)
            vertices.append((x + away[0], y + away[1], 0.0))
    triangles = []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b, c, d = a + 1, a + columns + 1, a + columns + 2
            triangles += [(a, b, d), (a, d, c)] if (i + j) % 2 else [(a, b, c), (b, d, c)]
    return vertices, triangles


def obj(vertices, triangles):
    return ("".join("v {!r} {!r} {!r}\n".format(*vertex) for vertex in vertices) +
            "".join("f {} {} {}\n".format(*(i + 1 for i in triangle)) for triangle in triangles))


def frame_blocks(path):
    """The block of each cell, by VTK's own reader."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("block")).tolist()


def png(columns, rows, bits, lines):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", columns, rows, bits, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b"")


def png_of_16_bits(rows):
    lines = b"".join(b"\0" + struct.pack(f">{len(row)}H", *row) for row in rows)
    return png(len(rows[0]), len(rows), 16, lines)


class Terrain(SceneTest):
    def last_row(self, text):
        self.run_scene(text)
        return {name: value if name == "stage" else float(value) for name, value in self.rows()[-1].items()}

    def test_a_box_slides_over_a_plane_of_triangles_as_over_one_block(self):
        (self.directory / "plane.obj").write_text(obj(*uneven_plane(24, 12, (-2, -3), (12, 3))))
        one = block("ground", (-2, -3, -2), (12, 3, 0), 'kind = "fixed"\n')
        many = TERRAIN.format(file="plane.obj", depth=2)
        sliding = block("box", (0, -0.5, 0), (1, 0.6, 0.5)) + '[output]\ntracked = ["box"]\nframe_interval = 1\n'
        for stiffness, springs, step in (("per area", "normal_stiffness = 1e9", 1e-4), ("none", "", 1e-3),
                                         ("potential", "normal_stiffness = 1e9\nshear_stiffness = 1e9", 1e-4)):
            head = HEAD.format(duration=0.5, gravity=SLOPE, step=step, stiffness=stiffness, springs=springs)
            expected, found = self.last_row(head + one + sliding), self.last_row(head + many + sliding)
            path = math.hypot(expected["box.x"] - 0.5, expected["box.y"] - 0.05)
            self.assertGreater(path, 0.3)
            # Per area the friction of one face acts in its middle, that of many follows the pressure. Without
            # springs it acts in the middle of a triangle in the half step in which the box comes onto it. By
            # potentials it acts on a line of action that the edges shift by some 1e-5 of the box's size.
            delta = 2e-4 * path if stiffness == "per area" else 1e-5 * path
            for axis in "xyz":
                self.assertAlmostEqual(found["box." + axis], expected["box." + axis], delta=delta)

    def test_blocks_stand_on_peaks_in_hollows_and_on_saddles_of_a_terrain(self):
        # All but the peak are plane between the axes, so that either diagonal of a square is the same surface.
        # A box just above the highest point below it touches nothing, and does so just below.
        shapes = {"peak": lambda x, y: -0.9 * max(abs(x), abs(y)), "hollow": lambda x, y: abs(x) + abs(y),
                  "ridge": lambda x, y: -2 * abs(x), "saddle": lambda x, y: abs(x) - abs(y)}
        for name, height in shapes.items():
            rows = [",".join(repr(float(height(x, y))) for x in range(-3, 4)) for y in range(3, -4, -1)]
            (self.directory / "map.csv").write_text("\n".join(rows))
            ground = TERRAIN.format(file="map.csv", depth=1) + "spacing = 1\nshift = [-3, -3, 0]\n"
            top = max(height(x, y) for x in (-0.5, 0, 0.5) for y in (-0.5, 0, 0.5))
            for gap in (-1e-3, 1e-3):
                standing = block("box", (-0.5, -0.5, top + gap), (0.5, 0.5, top + gap + 1))
                head = HEAD.format(duration=1e-4, gravity=[0, 0, 0], step=1e-4, stiffness="per area",
                                   springs="normal_stiffness = 1e9")
                contacts = self.last_row(head + ground + standing)["contacts"]
                self.assertEqual(contacts > 0, gap < 0, (name, gap, contacts))

    def test_a_height_map_is_the_same_in_all_forms(self):
        # Plane slopes in both directions, so that a point is known everywhere.
        heights = [[6 - row - 0.5 * column for column in range(5)] for row in range(4)]  # from north to south
        (self.directory / "map.csv").write_text("\n".join("; ".join(map(str, row)) for row in heights) + "\n")
        pixels = [[round((height + 1) / 7 * 65520) for height in row] for row in heights]
        (self.directory / "map.png").write_bytes(png_of_16_bits(pixels))
        nodes = [(10 + 2 * column, 20 + 2 * (3 - row), height) for row, line in enumerate(heights)
                 for column, height in enumerate(line)]
        (self.directory / "list.csv").write_text("x;y;z\n" + "".join(
            ";".join(map(str, node)).replace(".", ",") + "\n" for node in reversed(nodes)))
        (self.directory / "map.asc").write_text(
            "ncols 5\nnrows 4\nxllcenter 10\nyllcenter 20\ncellsize 2\n" +
            "\n".join(" ".join(map(str, row)) for row in heights))
        grid = "spacing = 2\nshift = [10, 20, 0]\n"
        scale = f"lowest = -1\nhighest = {-1 + 7 * 65535 / 65520!r}\n"
        head = HEAD.format(duration=1, gravity=[0, 0, -9.81], step=1e-4, stiffness="none", springs="")
        for file, keys in (("map.csv", grid), ("map.png", grid + scale), ("list.csv", "spacing = 2\n"), ("map.asc", "")):
            # At x = 14, y = 22: column 2, row 2 of the map.
            text = head + TERRAIN.format(file=file, depth=3) + keys + '[output]\ntracked = [{name = "p", at = [14, 22, %r]}]\n'
            self.scene.write_text(text % 2.999)
            self.assertEqual(self.checked(), (0, ""))
            self.check_fault(text % 3.01, r'output\.tracked\[0\]\.at: \[14, 22, 3\.01\] is outside of all blocks; '
                                          r'the nearest is "ground\.\d+", 0\.00\d+ m away')

    def test_frames_have_the_terrain_once_and_again_where_triangles_are_excavated(self):
        (self.directory / "plane.obj").write_text(obj(*uneven_plane(3, 2, (-2, -3), (12, 3))))
        head = HEAD.format(duration=1, gravity=[0, 0, -9.81], step=1e-2, stiffness="none", springs="")
        scene = head + TERRAIN.format(file="plane.obj", depth=2) + block("box", (0, -0.5, 0), (1, 0.6, 0.5))
        stages = '[[stage]]\ndo = "run"\nduration = 0.5\n' * 2 + 'excavate = ["ground.11"]\n'
        self.run_scene(scene.replace("duration = 1\n", "") + stages + "[output]\nframe_interval = 0.2\n")
        entries = re.findall(r'timestep="([^"]+)".* file="([^"]+)"', (self.output / "terrain.pvd").read_text())
        self.assertEqual([(float(time), file) for time, file in entries],
                         [(0, "frames/terrain_0000.vtp"), (0.6, "frames/terrain_0003.vtp")])
        blocks = {name: frame_blocks(self.output / "frames" / name) for name in
                  ("terrain_0000.vtp", "terrain_0003.vtp", "frame_0000.vtp", "frame_0003.vtp")}
        self.assertEqual(blocks["terrain_0000.vtp"], list(range(1, 13)))
        self.assertEqual(blocks["terrain_0003.vtp"], list(range(1, 12)))
        self.assertEqual(blocks["frame_0000.vtp"], [0] * 6)
        self.assertEqual(blocks["frame_0003.vtp"], [0] * 6)
        self.assertIn("terrain.pvd", (self.output / "show_in_paraview.py").read_text())

    def checked(self):
        answer = halfspace("check", self.scene)
        return answer.returncode, answer.stderr

    def test_surfaces_of_stl_are_scaled_and_shifted(self):
        facet = "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n"
        corners = (((0, 0, 0), (100, 0, 0), (100, 100, 0)), ((0, 0, 0), (100, 100, 0), (0, 100, 0)))
        stl = "".join(facet.format("".join("vertex {} {} {}\n".format(*corner) for corner in three)) for three in corners)
        (self.directory / "map.stl").write_text("solid a\n" + stl + "endsolid a\n")
        head = HEAD.format(duration=0.5, gravity=[0, 0, -9.81], step=1e-3, stiffness="none", springs="")
        ground = TERRAIN.format(file="map.stl", depth=1) + "scale = 0.1\nshift = [-5, -5, 2]\n"
        last = self.last_row(head + ground + block("box", (-1, -1, 2.1), (1, 1, 3)) + '[output]\ntracked = ["box"]\n')
        self.assertAlmostEqual(last["box.z"], 2.45, delta=1e-6)

    def test_faulty_surfaces_are_refused(self):
        head = HEAD.format(duration=1, gravity=[0, 0, -9.81], step=1e-3, stiffness="none", springs="")
        square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\n"
        for name, content, fault in (
            ("t.obj", square, r"t\.obj: no triangles; required: one or more"),
            ("t.obj", square + "f 1 2 3\nf 1 4 3\n", r"t\.obj:7: a triangle that faces down or sideways, the first of 1 among 2"),
            ("t.obj", square + "f 1 2 3\nf 3 1 2\n", r"t\.obj:7: the same triangle as t\.obj:6"),
            ("t.obj", square + "f 1 2 3\nf 1 3 4\nf 1 2 4\n", r"t\.obj:8: a triangle on the same side of an edge as t\.obj:6"),
            ("t.obj", square + "v 3 0 0\nf 1 2 6\n", r"t\.obj:7: a triangle without area"),
            ("t.csv", "1, 2, 3\n4, 5\n", r"t\.csv:2: a row of 2 heights; the first row has 3"),
            ("t.csv", "1, 2, 3\n", r"t\.csv: fewer than two rows or columns"),
            ("t.csv", "1, 2\n3, x\n", r"t\.csv:2: "),
            ("t.csv", "x,y,z\n0,0,1\n2,0,1\n0,2,1\n2,2,1\n", r"t\.csv: nodes at distances of 2 m; spacing is 1 m"),
            ("t.asc", "ncols 2\nnrows 2\n1 2 3 4\n", r"t\.asc: cellsize is missing"),
            ("t.png", "no image", r"t\.png: not a PNG image"),
            ("t.xyz", "", r"t\.xyz: unknown file extension; allowed: \.stl, \.obj, \.csv, \.png"),
        ):
            (self.directory / name).write_text(content)
            keys = "spacing = 1\n" if name[-3:] in ("csv", "png") else ""
            keys += "lowest = 0\nhighest = 1\n" if name.endswith("png") else ""
            self.check_fault(head + TERRAIN.format(file=name, depth=1) + keys + block("box", (0, 0, 1), (1, 1, 2)),
                             rf"^.*: terrain\[0\]\.file: {fault}.*\n1 fault in ")
        grid = "spacing = 1\nlowest = 0\nhighest = 1\n"
        for image, fault in (
            (png(60000, 60000, 16, b""), "60000 x 60000 pixels, more than a file of 65 bytes can hold"),
            (png(10**6, 10**6, 1, b""), "1000000 x 1000000 pixels, more than a file of 65 bytes can hold"),
            (png(4096, 4096, 1, bytes(513 * 4096)), "4096 x 4096 pixels, with two triangles each; allowed: at most 10000000 blocks"),
        ):
            (self.directory / "large.png").write_bytes(image)
            self.check_fault(head + TERRAIN.format(file="large.png", depth=1) + grid, r"terrain\[0\]\.file: large\.png: " + fault)
        with open(self.directory / "large.stl", "wb") as file:
            file.truncate(2**40)  # a hole, which takes no space
        limits = resource.getrlimit(resource.RLIMIT_AS)
        self.addCleanup(resource.setrlimit, resource.RLIMIT_AS, limits)
        resource.setrlimit(resource.RLIMIT_AS, (2**36, limits[1]))
        self.check_fault(head + TERRAIN.format(file="large.stl", depth=1),
                         r"terrain\[0\]\.file: cannot read .*large\.stl: there is no memory for its 1099511627776 bytes")
        self.check_fault(head + TERRAIN.format(file="none.obj", depth=1), r"terrain\[0\]\.file: cannot read .*none\.obj")
        self.check_fault(head + TERRAIN.format(file="t.csv", depth=0) + "spacing = 1\n", r"terrain\[0\]\.depth: out of range: 0")


if __name__ == "__main__":
    main()
