"""Cases of Li et al. 2015, Science China Technological Sciences, sections 3 and 6."""
import numpy as np

from subdivision import STEP, momentum_of_bars

SPEED, GAP = 3, 1
TOUCH = GAP / SPEED


def two_stages(study):
    """Section 3, figure 6: a corner meets a wall within a step."""
    run = study.run("papers/li_two_stages")
    since = 1e3 * (run["time"] - TOUCH)  # ms
    near = abs(since) < 2
    study.expect([-2, 0], [-2e-3 * SPEED, 0], label="free motion, contact")
    study.expect([0, 2], [0, 0])
    study.expect([0, 1], [0, 1e-3 * SPEED], label="without stages", style="--")
    study.draw("mesh", since[near], run["corner.x"][near] - GAP, label="at the ends of steps")
    study.compare("place after the step in which they meet, m", run.at(0.3335, "corner.x"), GAP, 1e-12)
    study.compare("place before it, m", run.at(0.333, "corner.x"), SPEED * 0.333, 1e-11)
    study.finish("After Li 2015, figure 6: contact at 1/3 s, within a step of 0.5 ms", "time since 1/3 s, ms",
                 "place of the corner, from the wall, m")


def prisms(study):
    """Section 6, figure 16: displacements, and velocities by finer meshes."""
    sizes = (10,) if study.quick else (10, 5, 2.5)
    struck = []
    for size in sizes:
        settings = {"block__striker__cell_size": size, "block__struck__cell_size": size}
        run = study.run("papers/li_prisms", **settings, **({} if size == 10 else {"world__time_step": ""}))
        time = run["time"]
        if size == 10:
            study.draw("rigid", time, run["i.ux"], 0, "block i")
            study.draw("affine", time, run["j.ux"], 0, "block j")
            study.compare("contacts before 1/3 s", run.at(0.333, "contacts"), 0, 0)
            study.exceeds("contacts after it, and before", run.at(0.3335, "contacts"), run.at(0.333, "contacts"))
        after = time > 0.4
        rates = [np.polyfit(time[after], run[f"{name}.x"][after], 1)[0] for name in "ij"]
        study.compare(f"cells of {size} m: velocity of i after contact, m/s", rates[0], SPEED - rates[1], 3e-3)
        study.exceeds(f"cells of {size} m: velocities of j and of i, m/s", rates[1], rates[0])
        struck.append(rates[1])
    study.expect([0, TOUCH, 0.5], [0, GAP, GAP], 0, "exchange of velocities")
    study.expect([0, TOUCH, 0.5], [0, 0, SPEED * (0.5 - TOUCH)], 0)
    if not study.quick:
        for finer, coarser, size in zip(struck[1:], struck, sizes[1:]):
            study.exceeds(f"velocity of j by cells of {size} m, and of twice that, m/s", finer, coarser)
        study.compare("velocity of j by the finest cells, m/s", struck[-1], SPEED, 0.02 * SPEED)
        study.draw("mesh", sizes, struck, 1, "block j after contact")
        study.expect([0, 10], [SPEED, SPEED], 1, "initial velocity of block i")
    study.finish(["After Li 2015, figure 16", "finer meshes"], ["time, s", "size of the cells, m"],
                 ["displacement along x, m", "velocity, m/s"])


def two_scales(study):
    """Section 5: elements that are subdivided lose or make momentum where mass counts twice."""
    for kind, lengths in (("rigid", (20, 20)), ("affine", (20, 10)), ("mesh", (10, 20))):
        momenta = momentum_of_bars(lengths, 1 / 3)
        study.draw(kind, STEP * 1e3 * np.arange(1, len(momenta) + 1), momenta,
                   label=f"{lengths[0]} m strikes {lengths[1]} m")
        off = abs(momenta[-1] - 1)
        name = f"bars of {lengths[0]} and {lengths[1]} m: momentum lost or made when they separate, of the striker's"
        if lengths[0] == lengths[1]:
            study.compare(name, off, 0, 1e-12)  # mirror images
        else:
            study.exceeds(name + "; 0.2", off, 0.2)
    study.finish("After Li 2015, section 5: momentum of subdivided bars", "time since the step of the touch began, ms",
                 "momentum, of that of the striker")
