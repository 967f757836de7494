"""A complete world: polygons fall into a trough. Draws the heap and the energy over time.

    run_scene.py [--output DIR]    writes heap.png and energy.png
"""
import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import halfspace as hs

# Field of the ledger, label, colour.
TERMS = [
    ("kinetic", "kinetic", "#4878a8"),
    ("gravity", "potential", "#9db8cf"),
    ("strain", "in springs", "#5a8f5a"),
    ("friction_loss", "lost to friction", "#b5442e"),
    ("contact_damping_loss", "lost to damping", "#e0b48c"),
]


def polygon(generator, corners, radius):
    """A polygon about the origin with corners on a circle."""
    turns = (np.arange(corners) + generator.uniform(-0.3, 0.3, corners)) * 2 * np.pi / corners
    return hs.Shape.polygon(radius * np.column_stack((np.cos(turns), np.sin(turns))))


def build():
    world = hs.World(
        law=hs.Law(normal_stiffness=1e7, shear_stiffness=5e6, friction_angle=0.5, normal_damping=0.2)
    )
    world.add_material(density=2500)
    for width, height, place, angle in (
        (8, 0.5, (0, -0.25), 0),
        (4, 0.4, (-4.2, 1.2), -0.8),
        (4, 0.4, (4.2, 1.2), 0.8),
    ):
        world.add_block(hs.Shape.rectangle(width, height), place, angle, kind=hs.BlockKind.FIXED)
    generator = np.random.default_rng(4)
    for row in range(12):
        for column in range(6):
            place = (0.75 * (column - 2.5) + 0.1 * (row % 2), 1 + 0.7 * row)
            shape = polygon(generator, generator.integers(3, 8), generator.uniform(0.2, 0.32))
            world.add_block(shape, place, generator.uniform(0, 6.28))
    return world


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."))
    folder = parser.parse_args().output

    world = build()
    history = [world.report]
    while world.time < 4:
        world.step(100)
        history.append(world.report)
    report = history[-1]
    print(f"{world}, {report.steps} steps of {report.time_step:.2g} s, {report.contact_count} contacts")

    figure, axes = plt.subplots(figsize=(8, 3), layout="tight")
    world.plot(axes)
    figure.savefig(folder / "heap.png", dpi=120)

    times = [entry.time for entry in history]
    figure, axes = plt.subplots(figsize=(7, 4), layout="tight")
    fields, labels, colours = zip(*TERMS)
    amounts = [[entry.energy[field] / 1e3 for entry in history] for field in fields]
    axes.stackplot(times, amounts, labels=labels, colors=colours)
    axes.set(xlabel="time (s)", ylabel="energy (kJ/m)", xlim=(0, times[-1]))
    axes.legend(loc="center right")
    figure.savefig(folder / "energy.png", dpi=120)
    print(
        f"residual of the energy ledger: {report.energy.residual / history[0].energy.gravity:.1e} of the energy"
    )


if __name__ == "__main__":
    main()
