"""Searches of a scene: the factor of safety, and limits of tilts, loads and keys."""
from __future__ import annotations

import contextlib
import ctypes
import math
import os
import tempfile
import threading
from typing import Any, ContextManager, Iterator, Mapping, Optional, Tuple, Union

from . import _raw_scene, _scene
from ._callbacks import Callbacks
from .context import Context
from .results import LimitResult, SafetyResult

PathLike = Union[str, "os.PathLike[str]"]
#: Words for the HS_SCENE_ values of an end.
ENDS = ("complete", "at rest", "interrupted", "unstable", "too fast", "not found")


class Searches:
    """The searches of a scene. Each bisects a value, and brings the scene to rest with it."""

    _handle: _scene.SceneHandle
    _stopped: Optional[threading.Event] = None  # set when all studies of a sweep are to end

    def _in(self, context: Optional[Context]) -> ContextManager[Tuple[Context, Any]]:
        raise NotImplementedError

    def safety(
        self,
        output: Optional[PathLike] = None,
        *,
        low: float = 0.5,
        high: float = 5.0,
        resolution: float = 0.005,
        limit: float = 0.0,
        replace: bool = False,
        resume: bool = False,
        progress: bool = False,
        context: Optional[Context] = None,
    ) -> SafetyResult:
        """Finds the factor of safety, as ``halfspace safety`` does. If the last stage runs, each trial is this stage.

        Parameters
        ----------
        output : path, optional
            Directory for trials and pictures.
        low, high : float
            The bracket: the scene is stable with all strengths divided by `low`, and falls with `high`.
        resolution : float
            Final width of the bracket.
        limit : float
            Displacement of a block that counts as failure, m; 0: ten times the elastic displacement of all joints and
            bodies, from a thousandth to a tenth of the block's size; in a stage that runs the latter.
        replace, resume : bool
            Replace an earlier search in the directory, or continue it.
        progress, context :
            As in `run`.
        """
        with output_directory(output) as directory, self._in(context) as (_, address), Callbacks(
            progress, stopped=self._stopped
        ) as calls:
            definition = _raw_scene.hs_scene_safety_def(
                low, high, resolution, limit, os.fsencode(directory), replace, resume, calls.progress
            )
            return SafetyResult(*self._search("find_safety", address, definition, calls))

    def limit(
        self,
        output: Optional[PathLike] = None,
        *,
        tilt: Union[bool, str] = False,
        loads: Union[bool, str] = False,
        values: Optional[Mapping[str, Tuple[float, float]]] = None,
        low: Optional[float] = None,
        high: Optional[float] = None,
        resolution: float = 0.0,
        limit: float = 0.0,
        smallest: bool = False,
        replace: bool = False,
        resume: bool = False,
        progress: bool = False,
        context: Optional[Context] = None,
    ) -> LimitResult:
        """Finds the largest tilt, load or value of a key at which the scene is stable, as ``halfspace limit`` does.
        One of `tilt`, `loads` and `values` is given.

        Parameters
        ----------
        output : path, optional
            Directory for trials and pictures.
        tilt : bool or str
            Turn gravity, by an angle in degrees, about this axis: "x", "-y", ...; True: z in 2D, x in 3D.
        loads : bool or str
            Multiply the loads of this group, mesh or mesh/group by a factor; True: all loads.
        values : dict
            A key with the ends of its bracket, e.g. ``{"default_law.friction_angle": (5, 60)}``.
        low, high : float
            The bracket of a tilt, by default 0 to 90 degrees, or of the factor, by default 0 to 10.
        resolution : float
            Final width of the bracket; 0: a thousandth of it.
        limit : float
            Displacement of a block that counts as failure, m; 0: as in `safety`, and a tenth of the block's size in
            motion.
        smallest : bool
            Find the smallest value instead, below which the scene falls.
        replace, resume, progress, context :
            As in `safety`.

        Examples
        --------
        >>> from halfspace import Scene
        >>> scene = Scene.loads('''
        ... dimension = 2
        ... world.duration = 1
        ... default_law = { stiffness = "per area", normal_stiffness = 1e9, friction_angle = 30 }
        ... material = [{ name = "stone", density = 2500 }]
        ... [[block]]
        ... name = "slab"
        ... material = "stone"
        ... vertices = [[0, 0], [5, 0], [5, 2], [0, 2]]
        ... [[block]]
        ... name = "plane"
        ... material = "stone"
        ... kind = "fixed"
        ... vertices = [[-5, -1], [10, -1], [10, 0], [-5, 0]]
        ... ''')
        >>> round(scene.limit(tilt=True, resolution=0.5).value)  # it slides at its friction angle
        30
        """
        if bool(tilt) + bool(loads) + (values is not None) != 1:
            raise ValueError("one of tilt, loads and values must be given")
        varied, name = _raw_scene.HS_SCENE_VARY_TILT if tilt else _raw_scene.HS_SCENE_VARY_LOADS, tilt or loads
        if values is not None:
            if low is not None or high is not None:
                raise ValueError("low and high: the bracket of a key is its value")
            varied, (name, low, high) = _raw_scene.HS_SCENE_VARY_SETTING, _bracket_of(values)
        with output_directory(output) as directory, self._in(context) as (_, address), Callbacks(
            progress, stopped=self._stopped
        ) as calls:
            definition = _raw_scene.hs_scene_limit_def(
                varied,
                smallest,
                name.encode() if isinstance(name, str) else None,
                math.nan if low is None else low,
                math.nan if high is None else high,
                resolution,
                limit,
                os.fsencode(directory),
                replace,
                resume,
                calls.progress,
            )
            return LimitResult(*self._search("find_limit", address, definition, calls))

    def _search(self, function: str, address: Any, definition: Any, calls: Callbacks) -> Tuple[str, float, float, str]:
        """End, bracket and report of a search."""
        found = _raw_scene.hs_scene_search_result()
        self._handle.call(function, address, ctypes.byref(definition), ctypes.byref(found))
        calls.end(ENDS[found.end])
        return ENDS[found.end], found.stable, found.falls, self._handle.text(_raw_scene.HS_SCENE_TEXT_REPORT)


def _bracket_of(values: Mapping[str, Tuple[float, float]]) -> Tuple[str, float, float]:
    if len(values) != 1:
        raise ValueError(f"values has {len(values)} keys; a search varies one")
    [(key, ends)] = values.items()
    if len(ends) != 2:
        raise ValueError(f"values[{key!r}] is {ends!r}; it must be (low, high)")
    return key, float(ends[0]), float(ends[1])


@contextlib.contextmanager
def output_directory(output: Optional[PathLike]) -> Iterator[str]:
    """The directory of the output; without one a temporary directory."""
    if output is not None:
        yield os.fspath(output)
        return
    with tempfile.TemporaryDirectory(prefix="halfspace") as directory:
        yield directory
