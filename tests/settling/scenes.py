"""Scenes that come to rest under their own weight, at three sizes or so: masonry, jointed rock and packings. Each is a
function of a law's text that returns the text of a scene; files of blocks are written beside it."""
import math

STONE = """
dimension = {dimension}
[world]
[[material]]
name = "stone"
density = 2400
[default_law]
{law}
friction_angle = 35
"""
SETTLE = """
[[stage]]
do = "settle"
ratio = 1e-6
max_steps = {max_steps}
[output]
frame_interval = 1e9
"""
FALL = """
[[stage]]
do = "run"
duration = {duration}
local_damping = 0.3
"""


def scene(dimension, law, parts, fall="", max_steps=100000):
    return STONE.format(dimension=dimension, law=law) + "".join(parts) + fall + SETTLE.format(max_steps=max_steps)


def block(name, vertices, kind="rigid"):
    return f'[[block]]\nname = "{name}"\nmaterial = "stone"\nkind = "{kind}"\nvertices = {[list(v) for v in vertices]}\n'


def rectangle(name, low, high, kind="rigid"):
    (x, y), (u, v) = low, high
    return block(name, [(x, y), (u, y), (u, v), (x, v)], kind)


def cuboid(name, low, high, kind="rigid"):
    return block(name, [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])],
                 kind)


def polar(radius, angle):
    return radius * math.cos(angle), radius * math.sin(angle)


def arch(law, folder, count):
    """A half circle of voussoirs, its thickness 0.15 of its mean radius: 1.4 times what it needs."""
    inner, outer = 0.925, 1.075
    parts = [rectangle("ground", (-2, -0.5), (2, 0), "fixed")]
    for i in range(count):
        a, b = math.pi * i / count, math.pi * (i + 1) / count
        parts.append(block(f"voussoir.{i}", [polar(inner, a), polar(outer, a), polar(outer, b), polar(inner, b)]))
    return scene(2, law, parts)


def vault(law, folder, rings, count):
    """A barrel vault: rings of voussoirs side by side, every other one turned by half a stone."""
    inner, outer, width = 0.9, 1.1, 0.4
    parts = [cuboid("ground", (-2, -1, -0.5), (2, rings * width + 1, 0), "fixed")]
    for ring in range(rings):
        joints = [math.pi * i / count for i in range(count + 1)]
        if ring % 2:
            joints = [0] + [math.pi * (i + 0.5) / count for i in range(count)] + [math.pi]
        for i, (a, b) in enumerate(zip(joints, joints[1:])):
            parts.append(block(f"voussoir.{ring}.{i}", [(x, y, z) for y in (ring * width, (ring + 1) * width)
                                                        for x, z in (polar(inner, a), polar(outer, a),
                                                                     polar(outer, b), polar(inner, b))]))
    return scene(3, law, parts)


def dome(law, folder, courses, count, digits):
    """A spherical dome up to 78 degrees, of an OBJ file with so many decimals."""
    inner, outer, vertices, lines = 4.0, 4.4, 0, []
    level = [math.radians(78) * i / courses for i in range(courses + 1)]
    for a, b in zip(level, level[1:]):
        for k in range(count):
            lines.append("o stone")
            sides = [2 * math.pi * (k + i) / count for i in (0, 1)]
            for elevation in (a, b):
                for radius, turn in ((inner, sides[0]), (outer, sides[0]), (outer, sides[1]), (inner, sides[1])):
                    place = (radius * math.cos(elevation) * math.cos(turn),
                             radius * math.cos(elevation) * math.sin(turn), radius * math.sin(elevation))
                    lines.append("v " + " ".join(f"{x:.{digits}f}" for x in place))
            for face in ((1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)):
                lines.append("f " + " ".join(str(vertices + corner) for corner in face))
            vertices += 8
    (folder / "dome.obj").write_text("\n".join(lines) + "\n")
    parts = [cuboid("ground", (-6, -6, -1), (6, 6, 0), "fixed"),
             '[[block]]\nname = "dome"\nmaterial = "stone"\nfile = "dome.obj"\n']
    return scene(3, law, parts)


def wall(law, folder, courses, length):
    """A wall in running bond of stones 0.4 by 0.2, with a door and a window that a lintel spans."""
    parts = [rectangle("ground", (-1, -0.5), (0.4 * length + 1, 0), "fixed")]
    width = 0.4 * length
    door, window = (0.2 * width, 0.35 * width, 0, 8), (0.6 * width, 0.8 * width, 4, 10)
    for course in range(courses):
        low, high = 0.2 * course, 0.2 * (course + 1)
        joints = [0.4 * i - 0.2 * (course % 2) for i in range(length + 2)]
        gaps = []
        for left, right, from_course, to_course in (door, window):
            if from_course <= course < to_course:
                gaps.append((left, right))
            elif course == to_course:
                parts.append(rectangle(f"lintel.{course}", (left - 0.3, low), (right + 0.3, high)))
                gaps.append((left - 0.3, right + 0.3))
        for i, (x, u) in enumerate(zip(joints, joints[1:])):
            x, u = max(x, 0), min(u, width)
            for k, (a, b) in enumerate(outside(x, u, gaps)):
                if b - a > 0.05:
                    parts.append(rectangle(f"stone.{course}.{i}.{k}", (a, low), (b, high)))
    return scene(2, law, parts)


def outside(x, u, gaps):
    """What gaps leave of an interval."""
    left = [(x, u)]
    for a, b in gaps:
        left = [part for p, q in left for part in ((p, min(q, a)), (max(p, b), q)) if part[1] > part[0]]
    return left


def jointed_slope(law, folder, spacing):
    """A slope in the plane, cut by two sets of joints that do not daylight."""
    parts = [f"""[[jointed_rock]]
name = "slope"
material = "stone"
region = [[0, 0], [30, 0], [22, 16], [0, 16]]
smallest_area = 0.02
[[jointed_rock.joint_set]]
dip = -20
spacing = {spacing}
[[jointed_rock.joint_set]]
dip = 75
spacing = {1.3 * spacing}
jitter = 0.3
""", rectangle("base", (-1, -1), (31, 0), "fixed"), rectangle("back", (-1, 0), (0, 17), "fixed")]
    return scene(2, law, parts)


def polygon_packing(law, folder, columns, rows):
    """Irregular polygons above each other in a bin, with gaps between them."""
    parts = [rectangle("floor", (-1, -1), (columns + 1, 0), "fixed"), rectangle("left", (-1, 0), (0, 3 * rows), "fixed"),
             rectangle("right", (columns, 0), (columns + 1, 3 * rows), "fixed")]
    for row in range(rows):
        for column in range(columns):
            number = row * columns + column
            corners = 5 + number % 3
            middle = (column + 0.5, row + 0.55)
            parts.append(block(f"grain.{number}", [
                tuple(m + p for m, p in zip(middle, polar(0.38 + 0.02 * (number * 7 % 5),
                                                          2 * math.pi * i / corners + 0.7 * number)))
                for i in range(corners)]))
    return scene(2, law, parts, FALL.format(duration=1 + 0.1 * rows), 1000000)


def polyhedron_packing(law, folder, columns, rows):
    """The same of polyhedra of twelve vertices in a box."""
    high = 3 * rows
    parts = [cuboid("floor", (-1, -1, -1), (columns + 1, columns + 1, 0), "fixed")]
    for name, low, up in (("left", (-1, -1, 0), (0, columns + 1, high)), ("front", (0, -1, 0), (columns, 0, high)),
                          ("right", (columns, -1, 0), (columns + 1, columns + 1, high)),
                          ("back", (0, columns, 0), (columns, columns + 1, high))):
        parts.append(cuboid(name, low, up, "fixed"))
    golden = (1 + math.sqrt(5)) / 2
    corners = [p for a in (-1, 1) for b in (-golden, golden) for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    for number in range(columns * columns * rows):
        middle = (number % columns + 0.5, number // columns % columns + 0.5, number // columns ** 2 + 0.55)
        size = 0.36 + 0.02 * (number * 7 % 5)
        c, s = math.cos(0.7 * number), math.sin(0.7 * number)
        points = []
        for x, y, z in corners:
            x, y, z = size / 1.902 * x, size / 1.902 * y, size / 1.902 * z
            x, y = c * x - s * y, s * x + c * y
            y, z = c * y - s * z, s * y + c * z
            points.append((middle[0] + x, middle[1] + y, middle[2] + z))
        parts.append(block(f"grain.{number}", points))
    return scene(3, law, parts, FALL.format(duration=1 + 0.1 * rows), 200000)


ALL = {
    "arch of 30": (arch, 30),
    "arch of 200": (arch, 200),
    "vault of 10 rings": (vault, 10, 15),
    "vault of 40 rings": (vault, 40, 24),
    "dome of 128, 17 decimals": (dome, 8, 16, 17),
    "dome of 128, 9 decimals": (dome, 8, 16, 9),
    "dome of 128, 6 decimals": (dome, 8, 16, 6),
    "dome of 128, 3 decimals": (dome, 8, 16, 3),
    "dome of 768, 6 decimals": (dome, 24, 32, 6),
    "wall of 14 courses": (wall, 14, 15),
    "wall of 30 courses": (wall, 30, 40),
    "slope, joints at 2 m": (jointed_slope, 2.0),
    "slope, joints at 0.6 m": (jointed_slope, 0.6),
    "packing of 100 polygons": (polygon_packing, 10, 10),
    "packing of 2000 polygons": (polygon_packing, 50, 40),
    "packing of 125 polyhedra": (polyhedron_packing, 5, 5),
    "packing of 1000 polyhedra": (polyhedron_packing, 10, 10),
}
LAWS = {
    "contact": 'stiffness = "per contact"\nnormal_stiffness = 1e9',
    "area": 'stiffness = "per area"\nnormal_stiffness = 1e10',
    "potential": 'stiffness = "potential"\nnormal_stiffness = 1e10',
}
