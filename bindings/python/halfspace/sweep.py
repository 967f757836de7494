"""Runs of a scene for all combinations of values."""
from __future__ import annotations

import concurrent.futures
import csv
import dataclasses
import itertools
import os
import pathlib
import threading
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from .context import Context
from .errors import HalfspaceError
from .progress import ProgressBar

if TYPE_CHECKING:
    from .scene import Scene

_OF_RUNS = ("run_out", "max_displacement", "largest_overlap", "energy_residual")


@dataclasses.dataclass(frozen=True)
class Sweep:
    """The results of a sweep; it prints a table.

    Attributes
    ----------
    keys : list of str
        The keys that vary, then the names of the results.
    rows : list of dict
        For each combination its values and results, and `error`: the text of a failed run, else "".
    """

    keys: List[str]
    rows: List[Dict[str, Any]]

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Dict[str, Any]]:
        return iter(self.rows)

    def __getitem__(self, key: str) -> NDArray[Any]:
        """The column of a key or result."""
        return np.array([row[key] for row in self.rows])

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the table as CSV."""
        with pathlib.Path(path).open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, [*self.keys, "error"])
            writer.writeheader()
            writer.writerows(self.rows)

    def __str__(self) -> str:
        lines = [self.keys, *([_shown(row[key]) for key in self.keys] for row in self.rows)]
        widths = [max(len(line[i]) for line in lines) for i in range(len(self.keys))]
        return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in lines)


def _shown(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _results_of(scene: "Scene", safety: bool) -> Dict[str, Any]:
    with Context() as context:
        if safety:
            found = scene.safety(context=context)
            return {"factor_of_safety": found.factor, "stable": found.stable, "falls": found.falls}
        run = scene.run(context=context)
        return {name: getattr(run, name) for name in _OF_RUNS}


def sweep_of(
    scene: "Scene", values: Mapping[str, Sequence[Any]], safety: bool, jobs: Optional[int], progress: bool
) -> Sweep:
    """Runs all combinations, in the order of the values; the last key varies fastest."""
    names = ["factor_of_safety", "stable", "falls"] if safety else list(_OF_RUNS)
    for key, each in values.items():
        if isinstance(each, str) or not np.iterable(each):
            raise TypeError(f"the values of {key} are {each!r}; they must be a sequence, as [20, 30] or range(15, 45, 5)")
    combinations = [dict(zip(values, each)) for each in itertools.product(*values.values())]
    scenes = [scene.with_settings(combination) for combination in combinations]  # faults before any run
    stopped = threading.Event()  # by Ctrl-C, which only the main thread sees
    for each_scene in scenes:
        each_scene._stopped = stopped

    def row_of(number: int) -> Dict[str, Any]:
        try:
            return {**combinations[number], **_results_of(scenes[number], safety), "error": ""}
        except HalfspaceError as error:
            return {**combinations[number], **dict.fromkeys(names, np.nan), "error": str(error)}

    bar = ProgressBar() if progress else None
    with concurrent.futures.ThreadPoolExecutor(jobs or os.cpu_count()) as pool:
        futures = [pool.submit(row_of, number) for number in range(len(scenes))]
        try:
            for done, _ in enumerate(concurrent.futures.as_completed(futures), 1):
                if bar:
                    bar.show(done / len(futures), f"{done} of {len(futures)} runs")
        except BaseException:
            stopped.set()
            for future in futures:
                future.cancel()
            raise
        finally:
            if bar:
                bar.close()
    return Sweep([*values, *names], [future.result() for future in futures])
