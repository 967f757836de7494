"""What the CSVs of box2d_comparison hold, and which of two figures is the better one."""
import csv
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Optional

STOCK, HALFSPACE, IMPULSES, FORCES = "box2d", "halfspace", "impulses", "forces"
NAMES = {STOCK: "Box2D", HALFSPACE: "half-space", IMPULSES: "impulse mode", FORCES: "force mode"}
SUFFIXES = ("", "_nudged", "_nudged_back")  # of the three runs of a world; of force mode, where it is run so


@dataclass(frozen=True)
class Figure:
    """A column of summary.csv.

    `floor` is what nobody sees: figures that are both below it count as equal. `noise` is the share by which two
    measurements of the same may differ.
    """

    column: str
    words: str
    unit: str
    more_is_better: bool = False
    is_count: bool = False
    floor: float = 0.0
    noise: float = 0.0


COST = (
    Figure("frames_per_second", "frames per second of processor time", "", more_is_better=True, noise=0.05),
    Figure("ns_per_pair", "time for one pair", "ns", noise=0.1),
)
PAIRS = (
    Figure("wrong_verdicts", "wrong verdicts (touching or not)", "", is_count=True),
    Figure("worst_wrong_verdict", "farthest that a wrong verdict was off", "m", floor=1e-9),
    Figure("mean_depth_error", "mean error of the depth", "m", floor=1e-8, noise=0.1),
    Figure("worst_depth_error", "worst error of the depth", "m", floor=1e-7, noise=0.1),
    Figure("worst_normal_error", "worst error of the normal", "rad", floor=1e-6),
    Figure("flicker", "points that came or went while nothing moved", "", is_count=True, floor=10, noise=0.1),
)
MOTION = (
    Figure("rest_time", "time until all are at rest", "s", floor=0.05, noise=0.1),
    Figure("drift", "drift of the farthest block", "m", floor=1e-3, noise=0.1),
    Figure("median_drift", "drift of the usual block", "m", floor=1e-3, noise=0.1),
    Figure("creep", "creep of the farthest block, second half", "m/s", floor=1e-5, noise=0.1),
    Figure("energy_gained", "energy gained out of nothing", "J", floor=1e-2, noise=0.1),
    Figure("jitter", "jitter in the last second", "m/s", floor=1e-5, noise=0.1),
)


def has_range(figure: Figure) -> bool:
    """Does each run have such a figure? Pairs are asked about in one world only."""
    return figure in MOTION or figure is COST[0]


@dataclass(frozen=True)
class Scene:
    name: str
    title: str
    stands_for: str
    stands: bool  # all is to stay where it is
    on_slopes: bool  # where friction alone holds the blocks
    stiffness: Optional[float]  # of force mode, N/m; None where it is not run
    why_no_forces: str  # where it is not
    summary: dict  # of each world, by column; None where there is nothing
    steps: dict  # of each world: lists by column

    def of(self, world: str, figure: Figure) -> Optional[float]:
        return self.summary[world][figure.column] if world in self.summary else None

    def runs(self, world: str) -> list:
        """The names of a world's runs: itself, and with everything 0.1 mm aside if there are such."""
        return [world + suffix for suffix in SUFFIXES if world + suffix in self.summary]

    def worlds(self) -> list:
        """The kinds of worlds, without their nudged runs."""
        return [world for world in self.summary if not world.endswith(SUFFIXES[1:])]

    def has_fallen(self, world: str) -> bool:
        """Has a block of a scene that is to stay gone by more than half its size, 1 m in these scenes?"""
        return self.stands and self.summary[world]["drift"] > 0.5

    def falls_in_all(self, world: str = HALFSPACE) -> bool:
        """Of Box2D's runs and of another world's."""
        return all(self.has_fallen(run) for either in (STOCK, world) for run in self.runs(either))


def _number(text: str) -> Optional[float]:
    return float(text) if text else None


def _rows(path: Path, key: Callable) -> dict:
    with path.open(newline="") as file:
        found: dict = {}
        for row in csv.DictReader(file):
            found.setdefault(key(row), []).append(row)
        return found


def read(folder: Path) -> list:
    """The scenes of a folder, in the order in which they were run."""
    titles = _rows(folder / "scenes.csv", lambda row: row["scene"])
    summaries = _rows(folder / "summary.csv", lambda row: row["scene"])
    steps = _rows(folder / "steps.csv", lambda row: (row["scene"], row["world"]))

    def columns(rows: list) -> dict:
        return {name: [float(row[name]) for row in rows] for name in rows[0] if name not in ("scene", "world")}

    def summary(row: dict) -> dict:
        return {name: _number(text) for name, text in row.items() if name not in ("scene", "world")}

    return [
        Scene(
            name,
            rows[0]["title"],
            rows[0]["stands_for"],
            rows[0]["stands"] == "1",
            rows[0]["on_slopes"] == "1",
            _number(rows[0]["stiffness"]),
            rows[0]["why_no_forces"],
            {row["world"]: summary(row) for row in summaries[name]},
            {row["world"]: columns(steps[name, row["world"]]) for row in summaries[name]},
        )
        for name, rows in titles.items()
    ]


def extremes(scene: Scene, world: str, figure: Figure) -> Optional[tuple]:
    """The least and the largest of a world's runs, where each has such a figure; of others the figure twice. None
    when there is none. A run that never rests has an infinite time of rest."""
    runs = scene.runs(world) if has_range(figure) else [world]
    values = [scene.of(run, figure) for run in runs]
    if figure.column == "rest_time":
        values = [math.inf if value is None else value for value in values]
    return None if None in values else (min(values), max(values))


def judge(scene: Scene, figure: Figure, world: str = HALFSPACE) -> str:
    """'better', 'worse', or 'same' for a world against Box2D's.

    Where there are three runs, only when all of them are better or worse than all of Box2D's: else the difference is
    luck. So it is with motion where all have fallen.
    """
    if figure in MOTION and scene.falls_in_all(world):
        return "same"
    stock, ours = extremes(scene, STOCK, figure), extremes(scene, world, figure)
    if stock is None or ours is None:
        return "same"

    def margin(value: float) -> float:
        return max(figure.noise * abs(value), figure.floor) if math.isfinite(value) else 0.0

    if ours[0] > stock[1] + margin(stock[1]):
        return "better" if figure.more_is_better else "worse"
    if ours[1] < stock[0] - margin(stock[0]):
        return "worse" if figure.more_is_better else "better"
    return "same"
