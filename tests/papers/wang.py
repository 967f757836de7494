"""Cases of Wang et al. 2021, Computers and Geotechnics, section 4."""
import math
import sys

import numpy as np

from study import EXAMPLES, GRAVITY, LINE

TYPES = ["vertex-vertex", "vertex-edge", "edge-edge", "edge-face", "face-face", "vertex-face"]  # HS_CONTACT_, from 1
PICTURE = 2  # m, the side of a picture of blocks of 1 m
SMALL_EDGE = {"case 1": 0, "case 2": 0.03}  # m, where the vertex falls: on the small edge, or beside it


def slide(friction, time):
    """Equation 41 on a slope of 30 degrees."""
    dip = math.radians(30)
    return (math.sin(dip) - math.cos(dip) * math.tan(math.radians(friction))) * GRAVITY * time**2 / 2


def sliders(study, scene, angles, duration, centroid, tolerance):
    """Blocks that slide, beside the formula of both papers."""
    for friction in angles:
        is_first = friction == angles[0]
        for kind in study.kinds:
            run = study.run(scene, stage__slide__default_law__friction_angle=friction, block__slider__kind=kind)
            way = np.hypot(*(run[axis] - run[axis][0] for axis in centroid))
            study.draw(kind, run["time"], way, label=kind if is_first else None)
            # The first row is some hundredths of a second after the start of the slide.
            study.compare(f"{friction} degrees, {kind}: way in {duration:g} s, m", way[-1],
                          slide(friction, run["time"][-1]) - slide(friction, run["time"][0]), tolerance)
        time = np.linspace(0, duration, 100)
        study.expect(time, slide(friction, time), label="closed form" if is_first else None)


def slider(study):
    """Section 4.1, figure 14."""
    sliders(study, "papers/wang_slider", (15, 30) if study.quick else (15, 20, 25, 30), 5,
            ("slider.x", "slider.z"), 1e-6)
    study.finish("After Wang 2021, figure 14: friction of 15, 20, 25, 30 degrees", "time, s", "displacement, m")


def types_in_order(run):
    """Contact types in the order in which they come first."""
    return list(dict.fromkeys(TYPES[kind - 1] for kind in run.contact_types() if kind))


def cube(study):
    """Section 4.2, figure 16."""
    for kind in study.kinds:
        run = study.run("papers/wang_cube", block__cube__kind=kind)
        study.draw(kind, run["time"], run["cube.z"], label=kind)
        study.agree(f"{kind}: contact types", types_in_order(run), ["vertex-face", "edge-face", "face-face"])
        overlap = 2500 * GRAVITY / 2e10
        study.compare(f"{kind}: overlap at rest, m", run["largest_overlap"][-1], overlap, 1e-3 * overlap)
    start = run["cube.z"][0]
    time = np.linspace(0, math.sqrt(2 * (start - 0.8) / GRAVITY), 20)
    study.expect(time, start - GRAVITY * time**2 / 2, label="free fall")
    study.expect([1.4, run["time"][-1]], [0.5, 0.5])
    study.finish("After Wang 2021, figure 16: a cube falls on a block", "time, s", "height of the centroid, m")


def edges(study):
    """Section 4.2, figure 18. A cube of 1 m has an inertia of a sixth of its mass."""
    speed, arm, height = math.sqrt(2 * GRAVITY * 0.1), 0.3, math.sqrt(0.5)
    touch = math.sqrt(2 * 0.1 / GRAVITY)
    smooth = 2 / (1 + 6 * arm**2) - 1  # rebound of an impact without loss and without friction, over the speed
    # The same where friction holds the edge: its impulse is 0.32 of the normal one, which tan 30 degrees permits.
    rough = 2 / (1 + 6 * arm**2 - (6 * arm * height)**2 / (1 + 6 * height**2)) - 1
    for kind in study.kinds:
        run = study.run("papers/wang_edges", block__upper__kind=kind)
        study.draw(kind, run["time"], run["upper.z"], label=kind)
        study.agree(f"{kind}: first contact type", types_in_order(run)[:1], ["edge-edge"])
        study.exceeds(f"{kind}: height at the impact and at the end, m", run.at(touch, "upper.z"), run["upper.z"][-1])
        found = run.at(touch + 0.02, "upper.vz") + 0.02 * GRAVITY
        if kind == "rigid":
            study.compare("rigid: velocity after the impact, m/s", found, speed * rough, 0.01 * speed)
        else:
            study.tell(f"affine: velocity after the impact: {found:.3f} m/s")
    without = study.run("papers/wang_edges", default_law__friction_angle=0)
    study.compare("without friction: velocity after the impact, m/s",
                  without.at(touch + 0.02, "upper.vz") + 0.02 * GRAVITY, speed * smooth, 0.01 * speed)
    time = np.linspace(0, touch, 20)
    study.expect(time, run["upper.z"][0] - GRAVITY * time**2 / 2, label="free fall")
    study.finish("After Wang 2021, figure 18: an edge falls on an edge", "time, s", "height of the centroid, m")


def falling_at(x):
    """Settings of both scenes of a small edge."""
    return {"block__square__shift": f"[{x}, 0]", "output__tracked[1]__at": f"[{x}, 0.05]"}


def small_edge(study):
    """Section 4.3, figure 20: the vertex, by springs and by the potentials of Zheng 2020.

    A vertex has half of K (docs/decisions/springs_at_corners.md): with twice the stiffness it has the paper's.
    """
    for panel, case in enumerate(SMALL_EDGE):
        settings = falling_at(SMALL_EDGE[case])
        potentials = study.run("papers/zheng_small_edge", **settings)
        for kind, stiffness in (("rigid", 5e6), ("rigid", 1e7)) + (() if study.quick else (("affine", 5e6),)):
            run = study.run("papers/wang_small_edge", block__square__kind=kind,
                            default_law__normal_stiffness=stiffness, **settings)
            name = f"{kind}, K {stiffness / 1e6:g} MN/m"
            study.draw(kind, run["vertex.x"], run["vertex.y"], panel, f"{name}, 0.4 s",
                       ":" if stiffness > 5e6 else "-")
            if panel == 0:
                study.compare(f"{case}, {name}: way to the side, m", np.abs(run["vertex.x"]).max(), 0, 1e-9)
                study.exceeds(f"{case}, {name}: velocity upwards at 0.2 s, m/s", run.at(0.2, "square.vy"), 0)
            else:
                study.exceeds(f"{case}, {name}: velocity to the right at 0.2 s, m/s", run.at(0.2, "square.vx"), 0)
                off = math.hypot(*(run.at(0.2, f"vertex.{axis}") - potentials[f"vertex.{axis}"][-1] for axis in "xy"))
                study.compare(f"{case}, {name}: vertex from that by potentials at 0.2 s, m", off, 0, LINE * PICTURE)
        study.expect(potentials["vertex.x"], potentials["vertex.y"], panel, "potentials, 0.2 s")
    study.axes[0].set_xlim(-0.2, 0.2)
    study.finish([f"After Wang 2021, figure 20: {case}" for case in SMALL_EDGE], "x of the vertex, m", "y, m")


def repose(study):
    """Section 4.4, figure 22: the heap of 360 grains at the paper's stiffness, and at a tenth of it."""
    sys.path.append(str(EXAMPLES / "angle_of_repose"))
    import slope  # loads VTK, which no other case needs

    stiff = {f"default_law__{name}": 1e8 for name in ("normal_stiffness", "shear_stiffness")}
    elastic = {"material__grain__young_modulus": 1e7, "material__grain__poisson_ratio": 0.3,
               "triangulated__grain__kind": "affine"}
    slopes = []
    for kind, name, settings in (("mesh", "rigid, K 10 MN/m, 20 us", {}),
                                 ("rigid", "rigid, K 100 MN/m", {"world__time_step": "", **stiff}),
                                 ("affine", "affine, K 100 MN/m", {"world__time_step": "", **stiff, **elastic})):
        run = study.run("angle_of_repose/small", **settings)
        x, height = slope.surface(slope.read_grains(run.frames()[-1]))
        study.draw(kind, x, height, label=name)
        top = int(height.argmax())
        sides = [slope.flank_angle(x[part], height[part], height[top])[0]
                 for part in (slice(None, top + 1), slice(top, None))]
        study.tell(f"{name}: slopes {sides[0]:.1f} and {sides[1]:.1f} degrees")
        if kind != "mesh":
            slopes += sides
    # Twelve slopes of heaps of 360 grains had a standard deviation of 3.9 degrees: the mean of four has 1.95.
    study.compare("mean slope at the stiffness of the paper, degrees", np.mean(slopes), 25, 3.9)
    for side in (-1, 1):
        study.expect([0, side * 0.45], [0.21, 0.21 - 0.45 * math.tan(math.radians(25))])
    study.finish("After Wang 2021, figure 22: surface of the heap, and 25 degrees", "x, m", "y, m")
