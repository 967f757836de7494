"""Draws cells that pass, are degraded or fail: for each varied parameter a line for all variants with the same result."""
import re
import textwrap

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


def label(variants, all_variants):
    """Names such as "2D, per area", those of one dimension together."""
    if len(variants) == len(all_variants):
        return "all"
    parts = []
    for dimension in ("2D", "3D"):
        inside = [name.removeprefix(f"{dimension}, ") for name in variants if name.startswith(dimension)]
        count = sum(name.startswith(dimension) for name in all_variants)
        if inside:
            parts.append(f"{dimension}: {'all' if len(inside) == count else '; '.join(inside)}")
    return ". ".join(parts)


def lines_of(row, values, names, verdict_of):
    """A line for all variants with the same verdicts: its label, and value and verdict of each cell."""
    groups = {}
    for name in names:
        cells = tuple((value, verdict_of(row, name, value)) for value in values)
        if any(verdict for _, verdict in cells):
            groups.setdefault(cells, []).append(name)
    tried = [name for group in groups.values() for name in group]
    return [(textwrap.wrap(unbroken_units(label(group, tried)), 40), cells) for cells, group in groups.items()]


def unbroken_units(text):
    return re.sub(r"(\d) s\b", "\\1\N{NO-BREAK SPACE}s", text)


def draw(path, names, rows, verdict_of, classes):
    """A heading for each row, below it the lines of its variants; verdict_of(row, name, value) is None without a run."""
    blocks = [(row, lines_of(row, values, names, verdict_of)) for row, values in rows]
    height = sum(0.3 + (len(lines) > 1) + sum(max(1, 0.62 * len(words)) for words, _ in lines) for _, lines in blocks)
    across = max(len(values) for _, values in rows)
    figure, axis = plt.subplots(figsize=(9.3, 0.26 * height + 0.5))
    figure.subplots_adjust(left=0.305, right=0.995, top=1 - 0.02 / figure.get_figheight(),
                           bottom=0.4 / figure.get_figheight())
    y = 0
    for row, lines in blocks:
        y += 0.3
        axis.text(-0.15, y + 0.5, row, ha="right", va="center", fontsize=10, fontweight="bold")
        if len(lines) == 1:
            lines = [([""], lines[0][1])]  # of all variants
        else:
            y += 1
        for words, cells in lines:
            tall = max(1, 0.62 * len(words))
            axis.text(-0.15, y + tall / 2, "\n".join(words), ha="right", va="center", fontsize=9, linespacing=1.1)
            for x, (value, verdict) in enumerate(cells):
                if verdict:
                    axis.add_patch(plt.Rectangle((x, y + 0.04), 0.96, tall - 0.08, color=COLOURS[verdict]))
                    axis.text(x + 0.48, y + tall / 2, short(value), ha="center", va="center", fontsize=9, color="white")
            y += tall
    axis.set(xlim=(0, across), ylim=(height, 0))
    axis.axis("off")
    handles = [plt.Rectangle((0, 0), 1, 1, color=COLOURS[name]) for name in classes]
    figure.legend(handles, classes, loc="lower center", ncol=len(classes), frameon=False, fontsize=10)
    figure.savefig(path, dpi=120)
