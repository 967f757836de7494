"""Results of runs and searches of a scene."""
from __future__ import annotations

import csv
import dataclasses
import math
import pathlib
from typing import Any, List, Optional

import numpy as np
from numpy.typing import NDArray

from ._record import Records
from .world import World


@dataclasses.dataclass(frozen=True)
class RunResult:
    """The results of a run; they print the summary of the command.

    Attributes
    ----------
    end : str
        "complete", "at rest" or "interrupted".
    world : World
        At the end, with the names of its blocks.
    time : float
        s, at the end.
    steps : int
        Number of steps.
    run_out, max_displacement, largest_overlap : float
        m; farthest horizontal spread, largest displacement of a free block, largest overlap in the whole run.
    energy_residual : float
        J
    history : numpy.ndarray
        The columns of history.csv by name, as ``history["time"]`` or ``history.time``.
    summary : str
        The text of summary.txt.
    notes : list of str
        Notes on unusual input, and on an energy residual above 1 % of the released energy.
    directory : pathlib.Path, optional
        Of the output files.
    """

    end: str
    world: World
    time: float
    steps: int
    run_out: float
    max_displacement: float
    largest_overlap: float
    energy_residual: float
    history: Records = dataclasses.field(repr=False)
    summary: str = dataclasses.field(repr=False)
    notes: List[str] = dataclasses.field(repr=False)
    directory: Optional[pathlib.Path]

    def __str__(self) -> str:
        return self.summary


@dataclasses.dataclass(frozen=True)
class SearchResult:
    """The bracket of a search; it prints the report of the command.

    Attributes
    ----------
    end : str
        "complete", "interrupted", or "not found" if the scene does not come to rest or the bracket has no limit.
    stable, falls : float
        The values nearest to the limit at which the scene was stable, and at which it fell; NaN without any.
    report : str
        The text of safety.txt or limit.txt.
    """

    end: str
    stable: float
    falls: float
    report: str = dataclasses.field(repr=False)

    @property
    def _middle(self) -> float:
        return 0.5 * (self.stable + self.falls) if self.end == "complete" else math.nan

    def __str__(self) -> str:
        return self.report


class SafetyResult(SearchResult):
    """The factor of safety; it prints the report of the command."""

    @property
    def factor(self) -> float:
        """The factor of safety: the middle of the bracket; NaN if it was not found."""
        return self._middle


class LimitResult(SearchResult):
    """The limit of a tilt, of loads or of a key; it prints the report of the command."""

    @property
    def value(self) -> float:
        """The limit: the middle of the bracket; NaN if it was not found."""
        return self._middle


def _column(cells: List[str]) -> NDArray[Any]:
    try:
        return np.array([float(cell) for cell in cells])
    except ValueError:
        return np.array(cells)


def read_history(path: pathlib.Path) -> Records:
    """The columns of a table of CSV: numbers, or texts."""
    with path.open(newline="", encoding="utf-8") as file:
        names, *rows = list(csv.reader(line for line in file if not line.startswith("#")))
    columns = [_column([row[i] for row in rows]) for i in range(len(names))]
    table = np.empty(len(rows), np.dtype([(name, column.dtype) for name, column in zip(names, columns)]))
    for name, column in zip(names, columns):
        table[name] = column
    return table.view(Records)
