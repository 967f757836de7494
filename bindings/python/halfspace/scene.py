"""Scenes: the input of the command `halfspace`, read, run and studied by the same code."""
from __future__ import annotations

import contextlib
import ctypes
import os
import pathlib
import re
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

from . import _raw, _raw_scene, _scene
from ._callbacks import Callback, Callbacks
from ._toml import Settings, settings_of, toml_text
from .context import Context, default_context
from .errors import SceneError, TooFastError, UnstableError
from .results import RunResult, read_history
from .searches import ENDS, PathLike, Searches, output_directory
from .shape import Shape
from .sweep import Sweep, sweep_of
from .world import World
from .world_tables import tables_of


def _read(text: bytes, settings: Settings, file: str) -> "Scene":
    return Scene(text, settings, file=file)


class Scene(Searches):
    """A scene: blocks, materials, laws, stages and output, as in a TOML file (docs/scenes/index.md).

    Created by `load`, `loads` or `from_dict`. Angles in scenes are in degrees.

    Examples
    --------
    >>> scene = Scene.loads('''
    ... dimension = 2
    ... world.duration = 0.1
    ... default_law = { stiffness = "per area", normal_stiffness = 1e8, friction_angle = 30 }
    ... material = [{ name = "stone", density = 2500 }]
    ... [[block]]
    ... name = "stone"
    ... material = "stone"
    ... vertices = [[0, 1], [1, 1], [1, 2], [0, 2]]
    ... ''')
    >>> world = scene.world()
    >>> world.step()
    >>> world.names
    ['stone']
    """

    def __init__(self, text: Union[str, bytes], settings: Settings = None, *, file: PathLike = "scene") -> None:
        self._handle = _scene.SceneHandle()
        self._bytes = text.encode() if isinstance(text, str) else bytes(text)
        self._file = os.fspath(file)
        self._settings = settings_of(settings)
        encoded = [setting.encode() for setting in self._settings]
        given = (ctypes.c_char_p * len(encoded))(*encoded)
        self._handle.call("read", self._bytes, len(self._bytes), os.fsencode(self._file), given, len(encoded))
        self._properties = _raw_scene.hs_scene_properties()
        self._handle.call("get_properties", ctypes.byref(self._properties))

    @classmethod
    def load(cls, path: PathLike, settings: Settings = None) -> "Scene":
        """Reads a scene file.

        Parameters
        ----------
        path : path
            Of a TOML file.
        settings : dict or list of str, optional
            Values that replace those of the file, as ``--set`` of the command does: ``{"default_law.friction_angle":
            25}`` or ``["default_law.friction_angle=25"]``.

        Raises
        ------
        SceneError
            Its text has all faults, a line each, with line, column and key.
        """
        return cls(pathlib.Path(path).read_bytes(), settings, file=path)

    @classmethod
    def loads(cls, text: str, settings: Settings = None, *, file: PathLike = "scene") -> "Scene":
        """Reads the text of a scene. Relative file names in it refer to the folder of `file`."""
        return cls(text, settings, file=file)

    @classmethod
    def from_dict(cls, tables: Mapping[str, Any], settings: Settings = None) -> "Scene":
        """Makes a scene of tables with the keys of scene files; values may be NumPy arrays."""
        try:
            return cls(toml_text(tables), settings)
        except SceneError as error:  # the places in a text that nobody wrote say nothing
            raise SceneError(error.status, re.sub(r"(?m)^scene:\d+:\d+: ", "", error.message)) from None

    @classmethod
    def from_world(cls, world: World, duration: float = 1.0) -> "Scene":
        """Makes a scene of the blocks, materials and laws of a world, at their current poses and velocities. It runs
        for `duration` seconds.

        Raises
        ------
        ValueError
            The world has meshes, bonds, compounds, bolts, water, actions or loads, or comes from a snapshot.

        Examples
        --------
        >>> from halfspace import stack
        >>> world = World()
        >>> stone = world.add_material(density=2000)
        >>> blocks = world.add_blocks(stack((1, 1), count=2))
        >>> Scene.from_world(world).run().max_displacement > 4.9
        True
        """
        return cls.from_dict(tables_of(world, duration))

    def with_settings(self, settings: Settings) -> "Scene":
        """Returns the same scene with further settings."""
        return Scene(self._bytes, self._settings + settings_of(settings), file=self._file)

    def save(self, path: PathLike) -> None:
        """Writes the scene, with its settings, as a TOML file."""
        pathlib.Path(path).write_text(self.text, encoding="utf-8")

    @property
    def text(self) -> str:
        """The scene as TOML. With settings it is written anew, without comments."""
        return self._handle.text(_raw_scene.HS_SCENE_TEXT_TOML)

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return int(self._properties.dimension)

    @property
    def duration(self) -> float:
        """Simulated time, s; of a scene with stages the sum of those that run."""
        return float(self._properties.duration)

    @property
    def threads(self) -> int:
        """Number of threads that the scene requests."""
        return int(self._properties.threads)

    @property
    def stage_count(self) -> int:
        """Number of stages."""
        return int(self._properties.stage_count)

    def __reduce__(self) -> Tuple[Any, ...]:  # pickle and copy
        return _read, (self._bytes, self._settings, self._file)

    def __repr__(self) -> str:
        return f"<halfspace.Scene {self._file}, {self.dimension}D>"

    def check(self) -> List[str]:
        """Returns the notes of ``halfspace check``: legal but unusual input, a line each."""
        with self._in(None) as (_, context):
            self._handle.call("make_world", context, None)
            return self._handle.text(_raw_scene.HS_SCENE_TEXT_NOTES).splitlines()

    def world(self, *, context: Optional[Context] = None) -> World:
        """Returns the world at the start of the scene.

        `world.names` are the names of its blocks, `world.check()` the notes on the scene. Stages, and prescribed
        motions that start or stop later, take part in `run` only.

        Parameters
        ----------
        context : Context, optional
            The owner; by default the default context, or one with the threads of the scene.
        """
        pointer = ctypes.POINTER(_raw.hs_world)()
        with self._in(context) as (owner, address):
            self._handle.call("make_world", address, ctypes.byref(pointer))
            return self._owned(owner, pointer)

    def run(
        self,
        output: Optional[PathLike] = None,
        *,
        replace: bool = False,
        resume_from: Optional[PathLike] = None,
        callback: Optional[Callback] = None,
        every: Optional[float] = None,
        progress: bool = False,
        context: Optional[Context] = None,
    ) -> RunResult:
        """Runs the scene through its stages, as ``halfspace run`` does, with the same bits.

        Parameters
        ----------
        output : path, optional
            Directory for frames, history, pictures and checkpoints; without it only the result is kept.
        replace : bool
            Replace an earlier run in the directory; by default it is refused.
        resume_from : path, optional
            Checkpoint of an earlier run of the scene.
        callback : callable, optional
            Called with the world at the start, at each row of the history, and at the end. The world is valid
            during the call; ``copy.copy(world)`` keeps it. False ends the run.
        every : float, optional
            Interval of the history and the callback, s; by default that of the scene.
        progress : bool
            Show a progress bar, as `World.run` does.
        context : Context, optional
            The owner of the world; its threads run the scene.

        Raises
        ------
        UnstableError, TooFastError
            The time step is too large. The output up to there is kept.
        """
        scene = self if every is None else self.with_settings({"output.history_interval": every})
        with output_directory(output) as directory, scene._in(context) as (owner, address), Callbacks(
            progress, callback, scene._worlds_in(owner), scene._stopped
        ) as calls:
            start = None if resume_from is None else os.fsencode(resume_from)
            definition = _raw_scene.hs_scene_run_def(os.fsencode(directory), replace, start, calls.progress, calls.row)
            found, pointer = _raw_scene.hs_scene_run_result(), ctypes.POINTER(_raw.hs_world)()
            scene._handle.call("run", address, ctypes.byref(definition), ctypes.byref(found), ctypes.byref(pointer))
            world = scene._owned(owner, pointer)
            calls.end(ENDS[found.end])
            scene._raise_trouble(ENDS[found.end])
            return RunResult(
                end=ENDS[found.end],
                world=world,
                **{name: getattr(found, name) for name, _ in found._fields_ if name != "end"},
                history=read_history(pathlib.Path(directory) / "history.csv"),
                summary=scene._handle.text(_raw_scene.HS_SCENE_TEXT_REPORT),
                notes=world.check(),
                directory=None if output is None else pathlib.Path(output),
            )

    def sweep(
        self,
        values: Mapping[str, Sequence[Any]],
        *,
        safety: bool = False,
        jobs: Optional[int] = None,
        progress: bool = False,
    ) -> Sweep:
        """Runs the scene for all combinations of values of keys, as ``halfspace sweep`` does.

        Parameters
        ----------
        values : dict
            The values of each key, e.g. ``{"default_law.friction_angle": range(15, 45, 5)}``.
        safety : bool
            Find the factor of safety of each, instead of a run.
        jobs : int, optional
            Number of runs at once, each in a thread; by default one per core.
        progress : bool
            Show a progress bar, as `World.run` does.
        """
        return sweep_of(self, values, safety, jobs, progress)

    # ---- calls ----

    @contextlib.contextmanager
    def _in(self, context: Optional[Context]) -> Iterator[Tuple[Context, Any]]:
        """For calls in a context, which no other thread uses meanwhile, nor this scene."""
        owner = context or (Context(threads=self.threads) if self.threads > 1 else default_context())
        keeper = owner._alive
        with self._handle.lock, keeper.lock:
            yield owner, keeper.pointer

    def _owned(self, owner: Context, pointer: Any) -> World:
        world = World._of(owner, pointer, self.dimension)
        world._names = self._names_of(world)
        world._notes_of_scene = self._handle.text(_raw_scene.HS_SCENE_TEXT_NOTES).splitlines()
        return world

    def _worlds_in(self, owner: Context) -> Callable[[Any], World]:
        """A function that gives the world of a run to its callback."""
        names: Dict[int, str] = {}

        def world_at(pointer: Any) -> World:
            world = World._of(owner, pointer, self.dimension, is_owned=False)
            if not names:
                names.update(self._names_of(world))
            world._names = names
            return world

        return world_at

    def _names_of(self, world: World) -> Dict[int, str]:
        return dict(zip(map(int, world.blocks), self._handle.text(_raw_scene.HS_SCENE_TEXT_NAMES).splitlines()))

    def _raise_trouble(self, end: str) -> None:
        kinds = {"unstable": (UnstableError, _raw.HS_ERROR_UNSTABLE), "too fast": (TooFastError, _raw.HS_ERROR_TOO_FAST)}
        if end in kinds:
            kind, status = kinds[end]
            raise kind(status, self._handle.text(_raw_scene.HS_SCENE_TEXT_TROUBLE))


def shapes_of(tables: Mapping[str, Any], context: Optional[Context] = None) -> List[Shape]:
    """The shapes of all blocks that tables of a scene describe."""
    scene = Scene.from_dict(tables)
    with scene._in(context) as (owner, address):
        count = ctypes.c_int64()
        scene._handle.call("make_shapes", address, ctypes.byref(count))
        shapes = []
        for index in range(count.value):
            pointer = ctypes.POINTER(_raw.hs_shape)()
            scene._handle.call("take_shape", index, ctypes.byref(pointer))
            shapes.append(Shape(owner, pointer))
        return shapes
