"""The pictures of the page, as PNG."""
import io

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

from figures import FORCES, HALFSPACE, IMPULSES, NAMES, STOCK, Scene  # noqa: E402

COLOURS = {STOCK: "#b5442e", HALFSPACE: "#1f5f8b", IMPULSES: "#c08a1e", FORCES: "#5b8c3a"}
OTHER = "#8a5fa8"
INK, GRID = "#2f3b45", "#e3e0da"

pyplot.rcParams.update(
    {
        "font.size": 9,
        "axes.edgecolor": INK,
        "axes.labelcolor": INK,
        "axes.titlesize": 9.5,
        "axes.titlecolor": INK,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": GRID,
        "xtick.color": INK,
        "ytick.color": INK,
        "legend.frameon": False,
    }
)


def _png(figure) -> bytes:
    picture = io.BytesIO()
    figure.savefig(picture, format="png", dpi=110)
    pyplot.close(figure)
    return picture.getvalue()


def _lines(scene: Scene) -> list:
    """Run, colour, width and label; the nudged runs first and faint."""
    colours = {world: COLOURS.get(world, OTHER) for world in scene.worlds()}
    faint = [(run, colour, 0.6, None) for world, colour in colours.items() for run in scene.runs(world)[1:]]
    return faint + [(world, colour, 1.4, NAMES.get(world, world)) for world, colour in colours.items()]


def _energy_lost(steps: dict) -> list:
    energy = [k + p for k, p in zip(steps["kinetic"], steps["potential"])]
    return [energy[0] - e for e in energy]


def scene_plots(scene: Scene) -> bytes:
    """Drift, speed, energy and contact points over time; nudged runs are the thin lines."""
    figure, axes = pyplot.subplots(1, 4, figsize=(13, 2.7))
    figure.subplots_adjust(left=0.04, right=0.99, bottom=0.17, top=0.88, wspace=0.2)
    for run, colour, width, label in _lines(scene):
        steps = scene.steps[run]
        style = {"color": colour, "linewidth": width, "label": label, "alpha": 0.5 if label is None else 1}
        time = steps["time"]
        axes[0].plot(time, [1e3 * d for d in steps["drift"]], **style)
        axes[1].plot(time, steps["largest_speed"], **style)
        axes[2].plot(time, _energy_lost(steps), **style)
        axes[3].plot(time, steps["contact_points"], **style)
    axes[0].set_title("farthest drift, mm")
    axes[1].set_title("largest speed, m/s")
    axes[1].set_yscale("log")
    axes[1].set_ylim(bottom=1e-7)
    axes[2].set_title("energy lost since the first step, J")
    axes[3].set_title("contact points")
    axes[0].legend(fontsize=8)
    for ax in axes:
        ax.set_xlabel("s")
        ax.margins(x=0.01)
    return _png(figure)


def _pairs_of(scenes: list, column: str) -> list:
    """Titles and both figures of the scenes that have them."""
    both = [(s.title, s.summary[STOCK][column], s.summary[HALFSPACE][column]) for s in scenes]
    return [(title, stock, ours) for title, stock, ours in both if stock is not None and ours is not None]


def overview(scenes: list) -> bytes:
    """Over all scenes: what is paid, and how right the contacts are."""
    figure, axes = pyplot.subplots(1, 3, figsize=(13, 0.9 + 0.24 * len(scenes)), sharey=True, layout="constrained")
    columns = (
        ("frames_per_second", "frames per second, half-space over Box2D\n(right of 1: faster)"),
        ("wrong_verdicts", "wrong verdicts"),
        ("mean_depth_error", "mean error of the contact's depth, m"),
    )
    places = {scene.title: -i for i, scene in enumerate(scenes)}
    axes[0].set_yticks(list(places.values()), list(places.keys()))
    for ax, (column, title) in zip(axes, columns):
        ax.set_title(title)
        for name, stock, ours in _pairs_of(scenes, column):
            y = places[name]
            if column == "frames_per_second":
                ax.barh(y, ours / stock - 1, left=1, height=0.6, color=COLOURS[HALFSPACE if ours >= stock else STOCK])
                continue
            least = 0 if column == "wrong_verdicts" else 1e-12
            ax.plot([max(ours, least), max(stock, least)], [y, y], color="#c9c6bf", linewidth=1.2, zorder=1)
            ax.scatter(max(stock, least), y, color=COLOURS[STOCK], s=22, zorder=2)
            ax.scatter(max(ours, least), y, color=COLOURS[HALFSPACE], s=22, zorder=3)
    axes[0].axvline(1, color=INK, linewidth=0.8)
    axes[1].set_xscale("symlog", linthresh=1)
    axes[1].set_xlim(-0.3, 1e5)
    axes[2].set_xscale("log")
    for world in (STOCK, HALFSPACE):
        axes[1].scatter([], [], color=COLOURS[world], s=22, label=NAMES[world])
    axes[1].legend(fontsize=8, loc="upper right")  # where the first scenes have none wrong
    return _png(figure)


def mode_overview(run: list, world: str) -> bytes:
    """A mode against Box2D, over the scenes that are run in it: what is paid, and how far blocks go."""
    figure, axes = pyplot.subplots(1, 3, figsize=(13, 1.1 + 0.26 * len(run)), sharey=True, layout="constrained")
    columns = (
        ("frames_per_second", "frames per second", 1),
        ("drift", "drift of the farthest block at the end, m", 1e-7),
        ("jitter", "jitter in the last second, m/s", 1e-9),
    )
    axes[0].set_yticks([-i for i in range(len(run))], [scene.title for scene in run])
    for ax, (column, title, least) in zip(axes, columns):
        ax.set_title(title + (f"\n(less than {least:g} at the edge)" if column != "frames_per_second" else ""))
        ax.set_xscale("log")
        for i, scene in enumerate(run):
            stock, ours = (max(scene.summary[either][column], least) for either in (STOCK, world))
            ax.plot([stock, ours], [-i, -i], color="#c9c6bf", linewidth=1.2, zorder=1)
            ax.scatter(stock, -i, color=COLOURS[STOCK], s=22, zorder=2)
            ax.scatter(ours, -i, color=COLOURS[world], s=22, zorder=3)
    for either in (STOCK, world):
        axes[0].scatter([], [], color=COLOURS[either], s=22, label=NAMES[either])
    axes[0].legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.08), ncols=2)
    return _png(figure)
