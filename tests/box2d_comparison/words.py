"""Figures and comparisons in plain words."""
import math
from typing import Optional

from figures import COST, HALFSPACE, MOTION, PAIRS, STOCK, Figure, Scene, extremes, judge


def number(value: Optional[float], unit: str = "") -> str:
    """Three digits, with a prefix of the unit where it has one: 0.0012 m is 1.2 mm."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    if unit in ("m", "m/s", "rad", "J"):
        for factor, prefix in ((1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")):
            if abs(value) >= factor:
                return f"{_digits(value / factor)} {prefix}{unit}"
        return f"under 1 n{unit}"
    return f"{_digits(value)} {unit}".strip()


def count(value: float) -> str:
    return f"{value:,.0f}".replace(",", "\u202f")


def _digits(value: float) -> str:
    if abs(value) < 1e-3:
        return f"{value:.2g}"
    decimals = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:,.{decimals}f}".replace(",", "\u202f")


def _figure(value: Optional[float], figure: Figure) -> str:
    return count(value) if figure.is_count and value is not None else number(value, figure.unit)


def figure_of(scene: Scene, world: str, figure: Figure) -> str:
    value = scene.of(world, figure)
    return "never" if figure.column == "rest_time" and value is None else _figure(value, figure)


def range_of(scene: Scene, world: str, figure: Figure) -> str:
    """The figure, or from the least to the largest of the world's runs."""
    between = extremes(scene, world, figure)
    if between is None:
        return "–"
    low, high = ("never" if value == math.inf else _figure(value, figure) for value in between)
    return low if low == high else f"{low} to {high}"


def ratio(scene: Scene, figure: Figure, world: str = HALFSPACE) -> str:
    stock, ours = scene.of(STOCK, figure), scene.of(world, figure)
    if stock is None or ours is None or stock <= 0 or ours < 0:
        return "–"
    if max(stock, ours) <= figure.floor:
        return "both unseen"
    quotient = ours / stock
    if quotient >= 0.01:
        return f"{quotient:.2f}" if quotient < 100 else f"{quotient:.0f}"
    if ours == 0:
        return "0"
    return f"1/{count(_two_digits(stock / ours))}" if quotient > 1e-6 else "under 1/10\u2076"


def _two_digits(value: float) -> float:
    return float(f"{value:.2g}")


def pay(scene: Scene, world: str) -> str:
    """What a world costs, in a sentence."""
    frames = COST[0]
    if judge(scene, frames, world) == "same":
        return f"Frames per second: the same within luck or {100 * frames.noise:.0f} %."
    return f"Frames per second: {_ours_instead(scene, frames, world)}."


def _ours_instead(scene: Scene, figure: Figure, world: str) -> str:
    return f"{range_of(scene, world, figure)} instead of {range_of(scene, STOCK, figure)}"


def get(scene: Scene, which: str, world: str = HALFSPACE) -> list:
    """The figures that are 'better' or 'worse' but for cost, in words."""
    return [
        f"{figure.words} {_ours_instead(scene, figure, world)}"
        for figure in PAIRS + MOTION
        if judge(scene, figure, world) == which
    ]
