"""Error against cost of a scene built in Python, for given settings.

Like `halfspace trade` for scene files: each setting is run to the same time, and a quantity is compared with its
reference::

    from halfspace.trade import grid, trade

    def build(safety, stiffness):
        world = hs.World(law=hs.Law(normal_stiffness=stiffness, friction_angle=0.4), safety=safety)
        ...
        return world

    found = trade(build, lambda world: world.positions[1, 0], duration=1.0, reference=0.9064,
                  settings=grid(safety=[1, 0.5, 0.25], stiffness=[1e7, 1e8, 1e9]))
    print(found.cheapest(1e-3).setting)
"""
from __future__ import annotations

import dataclasses
import itertools
import json
import math
import os
import pathlib
import time
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Union

from ._attributes import guard_attributes
from .errors import InvertedError, TooFastError, UnstableError
from .world import World

Setting = Mapping[str, Any]


@dataclasses.dataclass(frozen=True)
class Trial:
    """One setting with its result and cost."""

    setting: Dict[str, Any]
    value: float  #: NaN if the run did not reach the end
    error: float  #: deviation from the reference divided by the scale; NaN likewise
    cost: float  #: processor seconds per simulated second

    @property
    def is_whole(self) -> bool:
        return math.isfinite(self.value)


@dataclasses.dataclass(frozen=True)
class Trade:
    """The result of `trade`."""

    trials: List[Trial]
    reference: float
    scale: float
    left_out: List[Dict[str, Any]] = dataclasses.field(default_factory=list)  #: settings not run within the budget

    def front(self) -> List[Trial]:
        """The Pareto front: trials without a cheaper one of at most their error, sorted by cost."""
        best: List[Trial] = []
        for trial in sorted((t for t in self.trials if t.is_whole), key=lambda t: (t.cost, t.error)):
            if not best or trial.error < best[-1].error:
                best.append(trial)
        return best

    def cheapest(self, tolerance: float) -> Optional[Trial]:
        """The cheapest trial with an error within the tolerance; None if there is none."""
        return next((trial for trial in self.front() if trial.error <= tolerance), None)


guard_attributes([Trial, Trade])


def grid(**values: Sequence[Any]) -> List[Dict[str, Any]]:
    """All combinations of the given values."""
    return [dict(zip(values, combination)) for combination in itertools.product(*values.values())]


def trade(
    build: Callable[..., World],
    quantity: Callable[[World], float],
    *,
    duration: float,
    settings: Optional[Iterable[Setting]] = None,
    reference: Optional[float] = None,
    scale: Optional[float] = None,
    budget: Optional[float] = None,
    record: Union[str, "os.PathLike[str]", None] = None,
) -> Trade:
    """Runs a scene for each setting.

    Parameters
    ----------
    build : called with the keywords of a setting for each run; returns the initial world.
    quantity : computes the quantity of a world at the end, at the step closest to the duration.
    duration : s.
    settings : default ``grid(safety=[1, 1/2, 1/4, 1/8, 1/16])``.
    reference : reference value; by default that of the run with the largest number of steps, which is then no trial.
    scale : the error 1; by default the magnitude of the reference, or 1 if that is 0.
    budget : s; no run starts later, and `left_out` lists the remaining settings. None: no limit.
    record : a JSON file that stores each completed run. Stored runs are not repeated, so an interrupted trade, or one
        with a small budget, continues. Settings must be JSON values. The scene must be the same, which is not
        checked.

    Runs that end with UnstableError, TooFastError or InvertedError are trials without a value.
    """
    if not duration > 0:
        raise ValueError(f"duration is {duration}; it must be above 0 s")
    if budget is not None and not budget >= 0:
        raise ValueError(f"budget is {budget}; it must be 0 s or more")
    chosen = grid(safety=[1, 0.5, 0.25, 0.125, 0.0625]) if settings is None else settings
    known = _Record(record, duration)
    start = time.monotonic()
    runs: List[_Run] = []
    left_out: List[Dict[str, Any]] = []
    for setting in (dict(each) for each in chosen):
        run = known.find(setting)
        if run is None and budget is not None and time.monotonic() - start >= budget:
            left_out.append(setting)
            continue
        if run is None:
            run = _fastest(build, quantity, duration, setting)
            known.add(run)
        runs.append(run)
    if reference is None:
        whole = [run for run in runs if math.isfinite(run.value)]
        if not whole:
            raise ValueError("no run reached the end, and no reference is given")
        finest = max(whole, key=lambda run: run.steps)
        reference = finest.value
        runs = [run for run in runs if run is not finest]
    if scale is None:
        scale = abs(reference) or 1.0
    trials = [Trial(run.setting, run.value, abs(run.value - reference) / scale, run.cost) for run in runs]
    return Trade(trials, reference, scale, left_out)


@dataclasses.dataclass(frozen=True)
class _Run:
    setting: Dict[str, Any]
    value: float
    cost: float
    steps: int


class _Record:
    """Completed runs, stored in a file if there is one."""

    def __init__(self, path: Union[str, "os.PathLike[str]", None], duration: float) -> None:
        self._path = None if path is None else pathlib.Path(path)
        self._duration = duration
        self._runs: List[_Run] = []
        if self._path is None or not self._path.exists():
            return
        kept = json.loads(self._path.read_text())
        if not isinstance(kept, dict) or "runs" not in kept or kept.get("duration") != duration:
            raise ValueError(f"record is {self._path}, which holds no trade of {duration} s")
        self._runs = [_Run(**run) for run in kept["runs"]]

    def find(self, setting: Dict[str, Any]) -> Optional[_Run]:
        return next((run for run in self._runs if run.setting == setting), None)

    def add(self, run: _Run) -> None:
        self._runs.append(run)
        if self._path is None:
            return
        text = json.dumps({"duration": self._duration, "runs": [dataclasses.asdict(one) for one in self._runs]})
        new = self._path.with_name(self._path.name + ".new")
        new.write_text(text)
        os.replace(new, self._path)


def _fastest(
    build: Callable[..., World], quantity: Callable[[World], float], duration: float, setting: Dict[str, Any]
) -> _Run:
    """The fastest of up to five runs; fewer if a run is long enough to measure."""
    fastest = _run(build, quantity, duration, setting)
    for _ in range(4):
        if fastest.cost * duration > 0.05 or not math.isfinite(fastest.value):
            break
        again = _run(build, quantity, duration, setting)
        fastest = min(fastest, again, key=lambda run: run.cost)
    return fastest


def _run(
    build: Callable[..., World], quantity: Callable[[World], float], duration: float, setting: Dict[str, Any]
) -> _Run:
    world = build(**setting)
    start = time.process_time()
    try:
        world.step()  # computes the time step
        world.step(max(0, round(duration / float(world.report.time_step)) - 1))
        is_whole = True
    except (UnstableError, TooFastError, InvertedError):
        is_whole = False
    seconds = time.process_time() - start
    value = float(quantity(world)) if is_whole else math.nan
    return _Run(setting, value, seconds / (world.time or 1.0), int(world.report.steps))
