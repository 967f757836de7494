"""The thinnest semicircular arch that stands: 16 voussoirs without mortar and without contact springs.

Limit analysis gives a thickness of 0.107076 of the mean radius. A slightly thicker arch must stand, a slightly thinner
one must fall. The time step is 1/60 s.

    thinnest_arch.py [--output DIR]    writes arch.png: one arch with its line of thrust, and the other while it falls
"""
import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import halfspace as hs

VOUSSOIRS, FRICTION = 16, 1.5
STANDING, FALLING = 0.1072, 0.1068  # thickness over the mean radius, which is 1 m
FRAME = 1 / 60


def arch(thickness):
    """The world and the ids of the voussoirs, from right to left."""
    law = hs.Law(stiffness_kind=hs.StiffnessKind.NONE, friction_angle=np.arctan(FRICTION))
    world = hs.World(time_step=FRAME, law=law)
    world.add_material(density=2500)
    for x in (-1, 1):
        world.add_block(hs.Shape.rectangle(0.4, 0.2), (x, -0.1), kind=hs.BlockKind.FIXED)
    radii = 1 + thickness / 2 * np.array([-1, 1, 1, -1])
    blocks = []
    for i in range(VOUSSOIRS):
        angles = np.pi / VOUSSOIRS * np.array([i, i, i + 1, i + 1])
        corners = np.column_stack((radii * np.cos(angles), radii * np.sin(angles)))
        blocks.append(world.add_block(hs.Shape.polygon(corners)))
    return world, blocks


def crown_height(world, blocks):
    """Height of the highest corner of the voussoir left of the middle."""
    return world.block_vertices(blocks[VOUSSOIRS // 2])[:, 1].max()


def line_of_thrust(world):
    """The points where the resultants of the contacts act, from right to left."""
    points = world.contacts()["force_point"][:, :2]
    return points[np.argsort(np.arctan2(points[:, 1], points[:, 0]))].T


def draw(axes, world, color, alpha):
    outlines = [world.block_vertices(block) for block in world.blocks]
    colors = ["0.6"] * 2 + [color] * VOUSSOIRS
    axes.add_collection(PolyCollection(outlines, facecolors=colors, edgecolors="0.2", linewidths=0.5, alpha=alpha))


def stand(axes):
    """Draws the thicker arch after 5 s. Returns the displacement of its crown."""
    world, blocks = arch(STANDING)
    start = crown_height(world, blocks)
    world.step(300)
    draw(axes, world, "#cfe0f3", 1)
    axes.plot(*line_of_thrust(world), color="C3", lw=1.5, label="line of thrust")
    axes.legend(frameon=False, loc="center")
    axes.set_title(f"thickness {STANDING} of the radius: after {world.time:.0f} s", fontsize=10)
    return abs(crown_height(world, blocks) - start)


def fall(axes):
    """Draws the thinner arch at some times. Returns the displacement of its crown."""
    world, blocks = arch(FALLING)
    start = crown_height(world, blocks)
    times = []
    for steps, alpha in ((36, 0.25), (9, 0.5), (6, 1)):
        world.step(steps)
        draw(axes, world, "#f7dfbf", alpha)
        times.append(f"{world.time:.2f}")
    axes.set_title(f"thickness {FALLING}: after {', '.join(times)} s", fontsize=10)
    return abs(crown_height(world, blocks) - start)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."))
    folder = parser.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3), dpi=150, layout="tight")
    moved, fallen = stand(left), fall(right)
    for axes in (left, right):
        axes.set(aspect="equal", xlim=(-1.25, 1.25), ylim=(-0.22, 1.1))
        axes.set_axis_off()
    figure.savefig(folder / "arch.png", bbox_inches="tight")
    print(f"thickness {STANDING}: the crown has moved by {moved:.1e} m; {FALLING}: by {fallen:.2f} m")
    return int(moved > 1e-4 or fallen < 0.1)


if __name__ == "__main__":
    sys.exit(main())
