#!/usr/bin/env python3
"""Writes tunnel.msh: a square of rock with a round tunnel, in quads, as Gmsh does (MSH 2.2).

Physical groups: "tunnel" and "rock", the cells; "left", "right", "bottom" and "top", the outer edges.
"""
import math
from pathlib import Path

GROUPS = {(1, 1): "left", (1, 2): "right", (1, 3): "bottom", (1, 4): "top", (2, 5): "tunnel", (2, 6): "rock"}


def mesh(radius, half_width, core=8, rings_inside=3, rings_outside=14):
    """A core of core x core quads, rings from it to the wall at the radius, and rings from there to the square."""
    around = 4 * core
    nodes, tags = [], {}

    def node(point):
        key = tuple(round(c / radius, 9) for c in point)
        if key not in tags:
            nodes.append(point)
            tags[key] = len(nodes)
        return tags[key]

    def on_square(k, half):
        """Point k of a walk around a square, counter-clockwise from its lower right corner."""
        side, step = divmod(k % around, core)
        along = half * (2 * step / core - 1)
        return [(half, along), (-along, half), (-half, -along), (along, -half)][side]

    def on_circle(k, r):
        x, y = on_square(k, 1)
        angle = math.atan2(y, x)
        return (r * math.cos(angle), r * math.sin(angle))

    def between(p, q, share):
        return tuple(a + share * (b - a) for a, b in zip(p, q))

    half_core = 0.5 * radius
    cells = []
    at = [half_core * (2 * i / core - 1) for i in range(core + 1)]
    for i in range(core):
        for j in range(core):
            corners = (at[i], at[j]), (at[i + 1], at[j]), (at[i + 1], at[j + 1]), (at[i], at[j + 1])
            cells.append((5, [node(corner) for corner in corners]))
    loops = [[between(on_square(k, half_core), on_circle(k, radius), ring / rings_inside) for k in range(around)]
             for ring in range(rings_inside + 1)]
    # Rings grow outwards, so that their cells stay about square.
    growth = [((1 + half_width / radius) ** (ring / rings_outside) - 1) / (half_width / radius)
              for ring in range(1, rings_outside + 1)]
    loops += [[between(on_circle(k, radius), on_square(k, half_width), share) for k in range(around)]
              for share in growth]
    for ring, (inner, outer) in enumerate(zip(loops, loops[1:])):
        for k in range(around):
            m = (k + 1) % around
            group = 5 if ring < rings_inside else 6
            cells.append((group, [node(p) for p in (inner[k], outer[k], outer[m], inner[m])]))
    edges = []
    for k in range(around):
        ends = [node(loops[-1][k]), node(loops[-1][(k + 1) % around])]
        edges.append(((2, 4, 1, 3)[k // core], ends))
    return text(nodes, edges, cells)


def text(nodes, edges, cells):
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(GROUPS))]
    lines += [f'{dimension} {group} "{name}"' for (dimension, group), name in GROUPS.items()]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{tag} {x:.9g} {y:.9g} 0" for tag, (x, y) in enumerate(nodes, 1)]
    lines += ["$EndNodes", "$Elements", str(len(edges) + len(cells))]
    elements = [(1, *edge) for edge in edges] + [(3, *cell) for cell in cells]
    for tag, (kind, group, corners) in enumerate(elements, 1):
        lines.append(" ".join(map(str, [tag, kind, 2, group, group, *corners])))
    return "\n".join(lines + ["$EndElements", ""])


if __name__ == "__main__":
    Path(__file__).with_name("tunnel.msh").write_text(mesh(radius=3, half_width=20))
