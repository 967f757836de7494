"""Cases of Zheng et al. 2020, Acta Geotechnica, sections 4 to 6."""
import math

import numpy as np

from study import GRAVITY, time_of, values_of
from wang import SMALL_EDGE, falling_at, sliders


def of_kind(names, kind):
    return {f"block__{name}__kind": kind for name in names}


def velocity_of_squares(time, touch):
    """Of square b. Two faces of 1 m that overlap by d repel each other by 2 k / H (d - d^2), and both squares yield."""
    mass, stiffness, step = 2000, 1e7, 1e-6

    def rates(state):
        depth, speed = state
        return np.array([speed, -2 * 2 * stiffness / mass * (depth - depth**2) if depth > 0 else 0])

    state, found, now = np.array([0.0, 1.0]), [], touch
    for when in time:
        while now < when:
            a = rates(state)
            b = rates(state + step / 2 * a)
            c = rates(state + step / 2 * b)
            state = state + step / 6 * (a + 2 * b + 2 * c + rates(state + step * c))
            now += step
        found.append((1 - state[1]) / 2)
    return np.array(found)


def squares(study):
    """Section 4.1, figure 8."""
    time = np.linspace(0, 0.05, 501)
    exact = velocity_of_squares(time, 0.01)
    for kind in study.kinds:
        run = study.run("papers/zheng_squares", **of_kind(("a", "b"), kind))
        study.draw(kind, run["time"], run["a.vx"], label=f"a, {kind}")
        study.draw(kind, run["time"], run["b.vx"], label=f"b, {kind}")
        study.compare(f"{kind}: momentum over mass, m/s", run["a.vx"][-1] + run["b.vx"][-1], 1, 1e-12)
        study.compare(f"{kind}: velocity of b at the end, m/s", run["b.vx"][-1], 1, 1e-4)
        if kind == "rigid":
            off = np.abs(run["b.vx"] - np.interp(run["time"], time, exact)).max()
            study.compare("rigid: largest difference from the closed form, m/s", off, 0, 2e-4)
    study.expect(time, exact, label="closed form, rigid")
    study.expect(time, 1 - exact)
    study.finish("After Zheng 2020, figure 8: two squares", "time, s", "velocity, m/s")


def group(study):
    """Section 4.2, figure 10."""
    names = ("column", "lintel", "gable")
    blocks = [f"{side}_{name}" for name in names for side in ("right", "left")] + ["beam"]
    for kind in study.kinds:
        run = study.run("papers/zheng_group", **of_kind(blocks, kind))
        for name in names:
            right, left = f"right_{name}", f"left_{name}"
            study.draw(kind, run[right + ".x"], run[right + ".y"], label=kind if name == "column" else None)
            study.draw(kind, run[left + ".x"], run[left + ".y"])
            off = max(np.abs(run[right + ".x"] + run[left + ".x"]).max(),
                      np.abs(run[right + ".y"] - run[left + ".y"]).max())
            study.compare(f"{kind}: asymmetry of the {name}s, m", off, 0, 1e-9)
        study.draw(kind, run["beam.x"], run["beam.y"])
        study.compare(f"{kind}: way of the beam to the side, m", np.abs(run["beam.x"]).max(), 0, 1e-9)
    study.finish("After Zheng 2020, figure 10: traces in 1 s", "x, m", "y, m")


def slider(study):
    """Section 4.3, figure 12."""
    # The friction turns the block a little on its springs, which moves its centroid by less than m g / k.
    sliders(study, "papers/zheng_slider", (0, 20) if study.quick else (0, 10, 20), 2, ("slider.x", "slider.y"), 2e-3)
    study.finish("After Zheng 2020, figure 12: friction of 0, 10, 20 degrees", "time, s", "displacement, m")


def braked_by_equation_26(duration, step=1e-5):
    """Way of a block at 1 m/s whose weight is constant: friction of equations 24 to 26."""
    mass, stiffness = 2000, 1e7
    bound = mass * GRAVITY * math.tan(math.radians(20))
    way, velocity, stick, force, slides = 0.0, 1.0, 0.0, 0.0, False
    ways = []
    for _ in range(round(duration / step)):
        slides = force * stick < 0 if slides else stiffness * abs(stick) >= bound
        force = -math.copysign(bound, stick) if slides else -stiffness * stick
        if slides:
            stick = 0.0
        velocity += force / mass * step
        way += velocity * step
        stick += velocity * step
        ways.append(way)
    return np.array(ways)


def brake(study):
    """Equations 24 to 26 beside the incremental spring of the library."""
    run = study.run("papers/zheng_brake")
    # The middle of the base, half a metre below the centroid: friction makes the block lean. The first row is some
    # microseconds after the start of the stage.
    base = run["block.x"] - run["block.x"][0] + run["time"][0] + 0.5 * np.sin(run["block.angle"])
    theirs = braked_by_equation_26(run["time"][-1])
    study.draw("rigid", run["time"], base, label="incremental spring, base of the block")
    study.expect(1e-5 * np.arange(1, len(theirs) + 1), theirs, label="equation 26, a point")
    study.axes[0].set_xlim(0.2, 0.6)
    study.axes[0].set_ylim(0.134, 0.142)
    bound = GRAVITY * math.tan(math.radians(20))
    wound = 2000 * bound / 1e7
    # The spring is wound over the first part of the way, and brakes by half the bound there.
    study.compare("way until it stops, equation 26, m", theirs.max(), 1 / (2 * bound) + wound / 2, 1e-5)
    study.compare("way back after that, equation 26, m", theirs.max() - theirs[-1], 0, 1e-5)
    # The normal force rises and falls by some percent while the block leans.
    study.compare("way of the base back, incremental spring, m", base.max() - base[-1], wound, 0.05 * wound)
    study.finish("After Zheng 2020, equation 26: a block is braked until it sticks", "time, s", "displacement, m")


def sizes(study):
    """Section 5.1, figure 14. The previous approach of the paper has the radii of circles in the blocks for H."""
    for kind in study.kinds:
        of_blocks = of_kind(("on_low", "on_high"), kind)
        one = study.run("papers/zheng_sizes", **of_blocks)
        low = study.run("papers/zheng_sizes", world__potential_length=0.05, **of_blocks)
        high = study.run("papers/zheng_sizes", world__potential_length=0.5, **of_blocks)
        study.draw(kind, one["time"], one["on_low.y"], 0, f"on the low block, {kind}")
        study.draw(kind, low["time"], low["on_low.y"], 1, f"on the low block, {kind}")
        by_one = np.abs(one["on_low.y"] - one["on_high.y"]).max()
        study.compare(f"{kind}: difference of low and high by one H, m", by_one, 0, 1e-9)
        study.exceeds(f"{kind}: difference by the radii of the blocks for H, and a tenth of the fall, m",
                      np.abs(low["on_low.y"] - high["on_high.y"]).max(), 0.01)
        if kind == "rigid":
            study.expect(one["time"], one["on_high.y"], 0, "on the high block")
            study.expect(high["time"], high["on_high.y"], 1, "on the high block")
    study.finish(["After Zheng 2020, figure 14: H = 1 m", "H = 0.05 m for the low block, 0.5 m for the high one"],
                 "time, s", "y of the centroid, m")


def angles(study):
    """Section 5.2, figure 16."""
    for kind in study.kinds:
        run = study.run("papers/zheng_angles", **of_kind(("upper", "lower"), kind))
        for point in ("upper", "lower", "upper_tip", "lower_tip"):
            study.draw(kind, run[point + ".x"], run[point + ".y"], label=kind if point == "upper" else None)
        off = max(np.abs(run[f"upper{end}.{axis}"] + run[f"lower{end}.{axis}"]).max()
                  for end in ("", "_tip") for axis in "xy")
        study.compare(f"{kind}: largest asymmetry, m", off, 0, 1e-9)
        study.exceeds(f"{kind}: turn of the upper one, rad", abs(run["upper.angle"][-1]), 0.01)
    study.finish("After Zheng 2020, figure 16: centroids and tips in 0.2 s", "x, m", "y, m")


def small_edge(study):
    """Section 5.3, figure 18."""
    for panel, case in enumerate(SMALL_EDGE):
        settings = falling_at(SMALL_EDGE[case])
        for kind in study.kinds:
            run = study.run("papers/zheng_small_edge", block__square__kind=kind, **settings)
            study.draw(kind, run["vertex.x"], run["vertex.y"], panel, kind)
            if panel == 0:
                study.compare(f"{case}, {kind}: way to the side, m", np.abs(run["vertex.x"]).max(), 0, 1e-9)
                study.exceeds(f"{case}, {kind}: velocity upwards at 0.2 s, m/s", run["square.vy"][-1], 0)
            else:
                study.exceeds(f"{case}, {kind}: velocity to the right at 0.2 s, m/s", run["square.vx"][-1], 0)
    study.axes[0].set_xlim(-0.1, 0.1)
    study.finish([f"After Zheng 2020, figure 18: {case}" for case in SMALL_EDGE], "x of the vertex, m", "y, m")


def collapse(study):
    """Section 6.1, figure 20."""
    duration = 0.5 if study.quick else 7.5
    for kind in ("affine",) if study.quick else study.kinds:
        means = {}
        for friction in (15, 30):
            run = study.run(f"rock_collapse/potential_{friction}", jointed_rock__rock__kind=kind,
                            world__duration=duration)
            ways = [values_of(frame, "displacement")[values_of(frame, "kind") > 1, 0].mean() for frame in run.frames()]
            time = [time_of(frame) for frame in run.frames()]
            study.draw(kind, time, ways, label=f"{friction} degrees, {kind}",
                       style="-" if friction == 15 else ":")
            means[friction] = np.interp([duration / 3, duration * 2 / 3, duration], time, ways)
        for when, low, high in zip((1, 2, 3), means[15], means[30]):
            study.exceeds(f"{kind}: mean way after {when * duration / 3:.3g} s at 15 and 30 degrees, m", low, high)
    study.finish("After Zheng 2020, figure 20: the rock mass", "time, s", "mean displacement along x, m")


def is_left(frame, moves):
    """Of each block that moves, whether its middle is at x below 0."""
    ends = np.concatenate([[0], values_of(frame, "offsets")]).astype(int)
    x = values_of(frame, "points")[values_of(frame, "connectivity").astype(int), 0]
    middles = np.array([x[begin:end].mean() for begin, end in zip(ends, ends[1:])])
    return middles[moves] < 0


def valley(study):
    """Section 6.2, figure 22."""
    duration = 0.5 if study.quick else 3.5
    for kind in ("affine",) if study.quick else study.kinds:
        run = study.run("rock_valley/valley", world__duration=duration,
                        **{f"jointed_rock__{side}__kind": kind for side in ("left", "right")})
        first = run.frames()[0]
        moves = values_of(first, "kind") > 1
        left = is_left(first, moves)
        time = [time_of(frame) for frame in run.frames()]
        turns = np.array([values_of(frame, "angle")[moves] for frame in run.frames()])
        study.draw(kind, time, turns[:, left].mean(axis=1), label=f"left, {kind}")
        study.draw(kind, time, turns[:, ~left].mean(axis=1), label=f"right, {kind}")
        study.exceeds(f"{kind}: mean turn of the left slope, rad, back from the valley", turns[-1, left].mean(), 0)
        study.exceeds(f"{kind}: mean turn of the right slope, rad, into the valley; ten times that of the left",
                      turns[-1, ~left].mean(), (2 if study.quick else 10) * turns[-1, left].mean())
    study.finish("After Zheng 2020, figure 22: the valley", "time, s", "mean turn, rad")
