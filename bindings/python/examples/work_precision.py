"""Error against cost for different time steps.

Two motions with known results. A block oscillates on its contact spring: the error of velocity Verlet decreases with
the square of the step. Two squares collide (Zheng et al. 2020, section 4.1): the contact begins and ends within a
step, which is another error.

    work_precision.py [--output DIR]    writes work_precision.png
"""
import argparse
import pathlib
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import halfspace as hs

DENSITY, STIFFNESS = 2000.0, 1e7


def swing(step):
    """A square of 1 m oscillates about its equilibrium on the spring, with half the static deflection as amplitude,
    for 1 s."""
    world = hs.World(gravity=(0, -9.81), time_step=step, law=hs.Law(normal_stiffness=STIFFNESS))
    world.add_material(DENSITY)
    world.add_block(hs.Shape.rectangle(4, 1), (0, -0.5), kind=hs.BlockKind.FIXED)
    sag = DENSITY * 9.81 / STIFFNESS
    world.add_block(hs.Shape.rectangle(1, 1), (0, 0.5 - 1.5 * sag))
    world.step(round(1 / step))
    frequency = np.sqrt(STIFFNESS / DENSITY)
    exact = 0.5 - sag - 0.5 * sag * np.cos(frequency * world.time)
    return abs(world.positions[1, 1] - exact) / (0.5 * sag)


def collision(step):
    """A square with 1 m/s hits one at rest; they exchange their velocities."""
    world = hs.World(gravity=(0, 0), time_step=step, law=hs.Law(normal_stiffness=STIFFNESS))
    world.add_material(DENSITY)
    square = hs.Shape.rectangle(1, 1)
    world.add_block(square, (0, 0), velocity=(1, 0))
    world.add_block(square, (1.005, 0))
    world.step(round(0.1 / step))
    return abs(world.velocities[1, 0] - 1)


def measure(motion, steps):
    """Step, seconds and error of each run; the cost is that of the fastest of five runs."""
    rows = []
    for step in steps:
        seconds = []
        for _ in range(5):
            start = time.perf_counter()
            error = motion(step)
            seconds.append(time.perf_counter() - start)
        rows.append((step, min(seconds), error))
    return np.array(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."))
    folder = parser.parse_args().output

    figure, (against_step, against_cost) = plt.subplots(1, 2, figsize=(9, 4), sharey=True, layout="tight")
    for motion, label, mark in ((swing, "swing on a spring", "o"), (collision, "collision", "s")):
        runs = measure(motion, 1 / 2.0 ** np.arange(9, 17))
        order = np.polyfit(*np.log(runs[:, ::2]).T, 1)[0]
        for step, seconds, error in runs[[0, -1]]:
            print(f"{label}: steps of {step:.1e} s, {seconds:.1e} s of work, error {error:.1e}")
        against_step.loglog(runs[:, 0], runs[:, 2], mark + "-", label=f"{label}, order {order:.1f}")
        against_cost.loglog(runs[:, 1], runs[:, 2], mark + "-", label=label)
    against_step.set(xlabel="time step (s)", ylabel="relative error")
    against_cost.set(xlabel="cost (s)")
    against_step.legend()
    figure.savefig(folder / "work_precision.png", dpi=120)


if __name__ == "__main__":
    main()
