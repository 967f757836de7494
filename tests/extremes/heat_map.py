"""Draws cells that pass, are degraded or fail: a panel for each variant of a scene, a row for each varied parameter."""
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = {"passes": "#3a7d44", "degraded": "#e0a021", "reported": "#7c6a9c", "refused": "#8a95a1",
           "too slow": "#b58a5a", "fails": "#d1495b"}


def judged(error, small=1e-3, large=0.1):
    if not np.isfinite(error) or error >= large:
        return "fails"
    return "passes" if error < small else "degraded"


def short(value):
    """In few letters: 3, 0.5, 1e-7."""
    text = f"{value:g}" if 1e-3 <= value < 1e4 or value == 0 else f"{value:.0e}"
    return text.replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")


def draw_panel(axis, name, rows, verdict_of):
    """`rows` are names with their values; verdict_of(row, value) is None for a cell without a run."""
    for y, (row, values) in enumerate(rows):
        for x, value in enumerate(values):
            verdict = verdict_of(row, value)
            if verdict is None:
                continue
            axis.add_patch(plt.Rectangle((x, y), 0.96, 0.92, color=COLOURS[verdict]))
            axis.text(x + 0.48, y + 0.46, short(value), ha="center", va="center", fontsize=6, color="white")
    axis.set(xlim=(0, max(len(values) for _, values in rows)), ylim=(len(rows), 0), xticks=[])
    axis.set_title(name, fontsize=10)
    axis.set_yticks(np.arange(len(rows)) + 0.46, [row for row, _ in rows])
    axis.tick_params(length=0)
    for side in axis.spines.values():
        side.set_visible(False)


def draw(path, names, across, rows, verdict_of, classes):
    """A panel for each name, `across` of them side by side; verdict_of(row, name, value)."""
    down = -(-len(names) // across)
    figure, axes = plt.subplots(down, across, figsize=(3 + 4.7 * across, 0.6 + 0.32 * down * (len(rows) + 1)),
                                sharey=True, squeeze=False)
    figure.subplots_adjust(left=2.5 / (3 + 4.7 * across), right=0.995, top=0.96, bottom=0.05, wspace=0.03, hspace=0.1)
    for axis in axes.flat[len(names):]:
        axis.set_visible(False)
    for axis, name in zip(axes.flat, names):
        draw_panel(axis, name, rows, lambda row, value, name=name: verdict_of(row, name, value))
    handles = [plt.Rectangle((0, 0), 1, 1, color=COLOURS[name]) for name in classes]
    figure.legend(handles, classes, loc="lower center", ncol=len(classes), frameon=False)
    figure.savefig(path, dpi=100)
