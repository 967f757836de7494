"""Runs of a world in time, and files of its blocks."""
from __future__ import annotations

import ctypes
import os
import time
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Union, cast

import numpy as np
from numpy.typing import ArrayLike

from . import _raw, _scene
from ._arrays import shaped
from ._library import library
from .block_arrays import BlockArrays
from .context import held
from .progress import ProgressBar
from .records import Energy, WorldReport

if TYPE_CHECKING:
    from .world import World

_PORTION_TIME = 0.1  # s of wall time, between two looks at signals and the progress bar


class Runs(BlockArrays):
    """A world that runs to a time, and whose blocks have names."""

    def __init__(self, *arguments: Any, **others: Any) -> None:
        super().__init__(*arguments, **others)
        self._names: Dict[int, str] = {}
        self._notes_of_scene: Optional[List[str]] = None  # of the scene that the world was made of

    @property
    def report(self) -> WorldReport:
        """Time, time step, counts and energies: a record of `WORLD_REPORT`."""
        return self._record(WorldReport, library.hs_world_get_report)

    @property
    def energy(self) -> Energy:
        """Energy ledger: a record of the fields of ``hs_energy``."""
        return self.report.energy

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return float(self.report.time)

    @property
    def names(self) -> List[str]:
        """Names of all blocks, in the order of `blocks`: those of a scene, else their ids as text."""
        return [self._names.get(int(block), str(block)) for block in self.blocks]

    def block(self, name: str) -> int:
        """Returns the id of the block of a name."""
        for block, other in self._names.items():
            if other == name:
                return block
        raise KeyError(f"no block has the name {name!r}")

    def run(
        self,
        duration: Optional[float] = None,
        *,
        until: Optional[float] = None,
        every: Optional[float] = None,
        callback: Optional[Callable[["World"], Optional[bool]]] = None,
        progress: bool = False,
    ) -> None:
        """Steps the world to the step nearest to a time. The steps are those of `step`.

        Parameters
        ----------
        duration : float, optional
            Time to run, s; or give `until`.
        until : float, optional
            Time of the end, s. Nothing happens if it has passed.
        every : float, optional
            Interval of the callback, s, from the start of the run; by default after each portion of about 0.1 s of
            wall time.
        callback : callable, optional
            Called with the world; False ends the run.
        progress : bool
            Show a progress bar, in a terminal or a notebook; nothing elsewhere, as in a log.

        Raises
        ------
        UnstableError
            The time step is too large. The world keeps the last valid state.

        Examples
        --------
        >>> from halfspace import Shape, World
        >>> world = World(time_step=1e-3)
        >>> stone = world.add_material(density=2000)
        >>> block = world.add_block(Shape.rectangle(1, 1))
        >>> world.run(until=0.2, every=0.1, callback=lambda world: print(f"{world.time:.1f} s"))
        0.1 s
        0.2 s
        """
        if (duration is None) == (until is None):
            raise ValueError("give either duration or until")
        if every is not None and not every > 0:
            raise ValueError(f"every is {every}; it must be above 0")
        if duration is not None and not 0 <= duration < np.inf:
            raise ValueError(f"duration is {duration}; it must be at least 0 and finite")
        if until is not None and not np.isfinite(until):
            raise ValueError(f"until is {until}; it must be finite")
        start = float(self.report.time)
        end = start + duration if duration is not None else float(until or 0.0)
        bar = ProgressBar() if progress else None
        steps, calls = 1, 0
        try:
            while not self._reached(end):
                due = end if every is None else min(end, start + (calls + 1) * every)
                before = time.perf_counter()
                done = self._step_towards(due, steps)
                took = time.perf_counter() - before
                steps = max(1, int(done * min(2.0, _PORTION_TIME / max(took, 1e-9))))
                now = float(self.report.time)
                if bar:
                    fraction = 1.0 if self._reached(end) else (now - start) / (end - start)
                    bar.show(fraction, f"t = {now:.4g} of {end:.4g} s")
                is_due = self._reached(due)
                if is_due and every is not None:
                    calls += 1
                if callback and (is_due or every is None) and callback(cast("World", self)) is False:
                    return
        finally:
            if bar:
                bar.close()

    def _step_length(self) -> float:
        """The time step; before the first step that of the settings."""
        report = self.report
        return float(report.time_step if report.time_step > 0 else report.stable_time_step)

    def _reached(self, end: float) -> bool:
        return bool(end - float(self.report.time) < 0.5 * self._step_length())

    def _step_towards(self, end: float, steps: int) -> int:
        report = self.report
        left = (end - float(report.time)) / float(report.time_step) if report.time_step > 0 else 1
        done = min(max(1, round(left)), steps)
        self._call(library.hs_world_step, done)
        return done

    def write_vtk(
        self, path: Union[str, "os.PathLike[str]"], *, contacts: bool = False, start: Optional[ArrayLike] = None
    ) -> None:
        """Writes the blocks as a file for ParaView (VTK XML PolyData, *.vtp), with the fields of the command's frames.

        Parameters
        ----------
        path : path
            Of the file. Files with numbers before the dot, as ``frame_0000.vtp``, are one series in ParaView.
        contacts : bool
            Write the contacts, too, into a file whose name ends in ``_contacts.vtp``.
        start : array_like, shape (n, 7), optional
            Earlier `poses`, from which displacements are measured; without them displacements are 0.
        """
        file = os.fspath(path)
        root, ending = os.path.splitext(file)
        beside = os.fsencode(f"{root}_contacts{ending}") if contacts else None
        poses = None
        if start is not None:
            origin = shaped(np.ascontiguousarray(start, np.float64), "start", (len(self), 7))
            poses = origin.ctypes.data_as(ctypes.POINTER(_raw.hs_pose))
        with held(self):
            given = self._keeper.pointer, self._alive, poses
            _scene.SceneHandle().call("write_vtk", *given, os.fsencode(file), beside)
