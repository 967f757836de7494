"""Normal impact of two bars, with and without contact springs: force over time compared with theory.

Prints the max force and the duration of contact, divided by those of theory.

    impact_of_bars.py [--output DIR]    writes bars.png: the force over time for each law
"""
import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import halfspace as hs

LENGTH, DENSITY, MODULUS, SPEED, GAP = 1.0, 1000.0, 1e9, 1.0, 1e-3
WAVE_SPEED = np.sqrt(MODULUS / DENSITY)
COLUMNS = 40
HEIGHT = LENGTH / COLUMNS
FORCE = DENSITY * WAVE_SPEED * SPEED / 2 * HEIGHT  # force of a wave in each bar
DURATION = 2 * LENGTH / WAVE_SPEED  # until both waves have returned

LAYER = MODULUS / HEIGHT  # Pa/m: as stiff as a layer of elements
LAWS = {
    "no spring": hs.Law(stiffness_kind=hs.StiffnessKind.NONE),
    "springs per area, as stiff as an element": hs.Law(
        normal_stiffness=LAYER, stiffness_kind=hs.StiffnessKind.PER_AREA, normal_damping=0, shear_damping=0
    ),
    "the same, 10 times stiffer": hs.Law(
        normal_stiffness=10 * LAYER, stiffness_kind=hs.StiffnessKind.PER_AREA, normal_damping=0, shear_damping=0
    ),
}


def impact(law):
    """Times since the theoretical touch, force on the second bar divided by that of theory, and number of steps."""
    world = hs.World(gravity=(0, 0), law=law)
    world.add_material(DENSITY)
    world.set_elasticity(0, hs.Elasticity(young_modulus=MODULUS, poisson_ratio=0))
    bar = hs.Mesh.rectangle(LENGTH, HEIGHT, COLUMNS, 1)
    world.add_mesh(bar, (-LENGTH / 2 - GAP, 0), velocity=(SPEED, 0, 0))
    struck = world.add_mesh(bar, (LENGTH / 2, 0))
    times, forces = [], []
    while world.time < GAP / SPEED + 1.4 * DURATION:
        world.step()
        contacts = world.contacts()
        is_impact = len(contacts) and contacts["touched_at"].max() > world.time - world.report.time_step
        force = 0.0 if is_impact else sum_of_forces(world, contacts, struck)
        times.append(world.time - GAP / SPEED)
        forces.append(force / FORCE)
    return np.array(times), np.array(forces), int(world.report.steps)


def sum_of_forces(world, contacts, body):
    """The force along x on a body; the force of a contact acts on its block b."""
    total = 0.0
    for contact in contacts:
        on, against = (world.body_of_block(int(contact[name]))[0] for name in ("block_b", "block_a"))
        total += contact["force"][0] * ((on == body) - (against == body))
    return total


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."))
    folder = parser.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(figsize=(8, 3.6), dpi=150)
    axes.plot([-0.2, 0, 0, 1, 1, 1.4], [0, 0, 1, 1, 0, 0], color="0.6", lw=4, label="theory of waves")
    for (name, law), color in zip(LAWS.items(), ("C3", "C0", "C2")):
        times, forces, steps = impact(law)
        touching = times[forces > 1e-3]
        print(
            f"{name}: {steps} steps, largest force {forces.max():.3f} of theory, "
            f"in touch for {(touching[-1] - touching[0]) / DURATION:.3f} of theory"
        )
        axes.plot(times / DURATION, forces, color=color, lw=1, label=name)
    axes.set(xlim=(-0.1, 1.4), xlabel="time since the touch over 2 L / c", ylabel="force over ρ c v / 2")
    axes.legend(frameon=False, fontsize=8, loc="upper right")
    figure.tight_layout()
    figure.savefig(folder / "bars.png")


if __name__ == "__main__":
    main()
