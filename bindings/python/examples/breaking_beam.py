"""A beam of bonded elements settles on two supports; then a block falls onto it.

Prints the deflection under its own weight and that of theory, then the failed bonds.

    breaking_beam.py [--output DIR]    writes beam.png: the stress along the beam, and the cracks
"""
import argparse
import dataclasses
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import halfspace as hs

LENGTH, HEIGHT, COLUMNS, ROWS = 6.0, 0.75, 24, 3
SPAN = 5.75


def beam_mesh():
    """Quads without shared nodes, connected by bonds."""
    whole = np.array([(i, j) for j in range(ROWS) for i in range(COLUMNS)])
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    nodes = (whole[:, None, :] + corners).reshape(-1, 2) * (LENGTH / COLUMNS, HEIGHT / ROWS)
    return hs.Mesh(nodes - (LENGTH / 2, 0), [np.arange(len(nodes)).reshape(-1, 4)])


def beam_on_supports():
    """The world, and the body of the beam."""
    law = hs.Law(normal_stiffness=2e11, stiffness_kind=hs.StiffnessKind.PER_AREA, friction_angle=np.radians(30))
    world = hs.World(law=law)
    concrete, steel = world.add_material(2400), world.add_material(7800)
    world.set_law(concrete, steel, dataclasses.replace(law, friction_angle=0))  # supports without friction
    world.set_elasticity(concrete, hs.Elasticity(young_modulus=30e9, poisson_ratio=0.2, plane=hs.Plane.STRESS))
    for x in (-SPAN / 2, SPAN / 2):
        world.add_block(hs.Shape.rectangle(0.05, 0.5), (x, -0.25), kind=hs.BlockKind.FIXED, material=steel)
    body = world.add_mesh(beam_mesh(), material=concrete)
    mortar = hs.Bond(
        normal_stiffness=2e13,
        tensile_strength=3e6,
        cohesion=9e6,
        friction_angle=np.radians(35),
        residual_friction_angle=np.radians(35),
        tensile_fracture_energy=100,
    )
    world.bond_materials(concrete, concrete, mortar)
    return world, body, steel


def draw(world, body, path):
    """The stress along the beam in each element, and the positions of failed bonds."""
    figure, axes = plt.subplots(figsize=(9, 3.2), dpi=150)
    stress = world.cells(body)["stress"][:, 0, 0] / 1e6
    quads = world.node_positions(body).reshape(-1, 4, 2)
    cells = PolyCollection(quads, array=stress, cmap="RdBu_r", edgecolors="0.4", linewidths=0.3)
    cells.set_clim(-10, 10)
    axes.add_collection(cells)
    for block in world.blocks:
        if world.state(int(block)).kind != hs.BlockKind.MESH:
            axes.fill(*np.array(world.block_vertices(int(block))).T, color="0.6", ec="0.3")
    events = world.bond_events()
    across = np.column_stack([-events["normal"][:, 1], events["normal"][:, 0]])
    for place, way, area in zip(events["position"][:, :2], across, events["area"]):
        axes.plot(*np.transpose([place - way * area / 2, place + way * area / 2]), color="black", lw=2)
    axes.set(aspect="equal", xlim=(-3.3, 3.3), ylim=(-0.6, 1.9))
    axes.set_axis_off()
    figure.colorbar(cells, label="stress along the beam, MPa", shrink=0.8)
    figure.savefig(path, bbox_inches="tight")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path)
    output = parser.parse_args().output
    world, body, steel = beam_on_supports()
    at_rest, balance = world.relax()
    middle = world.node_positions(body).reshape(ROWS, COLUMNS, 4, 2)[0, COLUMNS // 2 - 1 : COLUMNS // 2 + 1]
    sag = -middle[:, :2, 1].mean() * 1e6
    weight, stiffness = 2400 * 9.81 * HEIGHT, 30e9 * HEIGHT**3 / 12
    bending, shear = 5 * weight * SPAN**4 / (384 * stiffness), weight * SPAN**2 / 8 / (12.5e9 * HEIGHT * 5 / 6)
    theory = (bending + shear) * 1e6
    print(f"at rest: {at_rest} after {balance.steps} steps; sag {sag:.1f} um, of a beam by theory {theory:.1f} um")
    world.add_block(hs.Shape.rectangle(0.5, 0.5), (0, HEIGHT + 0.26), velocity=(0, -3), material=steel)
    end = world.report.time + 0.02
    while world.report.time < end:
        world.step(200)
    report = world.bond_report
    print(f"cracks of {report.crack_area:.2f} m took {report.fracture_loss:.0f} J; {report.joint_count} bonds of "
          f"{report.bond_count} still hold or rub")
    if output:
        output.mkdir(parents=True, exist_ok=True)
        draw(world, body, output / "beam.png")


if __name__ == "__main__":
    main()
