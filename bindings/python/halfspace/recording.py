"""Recordings of worlds, which the viewer plays."""
import ctypes
import os
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._viewer import viewer_library, viewer_page
from .constants import BlockKind, BondFailure
from .context import held
from .errors import ArgumentError
from .records import Energy
from .shape import Shape
from .world import World

_DEFORMING = (BlockKind.AFFINE, BlockKind.MESH)
_TENSOR: Dict[int, Dict[str, Tuple[int, int]]] = {
    2: {"xx": (0, 0), "yy": (1, 1), "xy": (0, 1)},
    3: {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "yz": (1, 2), "zx": (2, 0), "xy": (0, 1)},
}
_REPORTED = ("time", "steps", "contact_count", "largest_overlap", "largest_speed")
_ENERGIES = tuple(Energy.__annotations__)


def _checked(result: Any) -> Any:
    """The result of a function of the viewer's library. Raises ArgumentError if it failed."""
    failed = not result if isinstance(result, ctypes._Pointer) else result is not None and result < 0
    if failed:
        raise ArgumentError(_raw.HS_ERROR_ARGUMENT, viewer_library().hs_recording_error().decode())
    return result


def _in_c(argument: Any) -> Any:
    """Texts and arrays as C has them; the others as they are."""
    if isinstance(argument, np.ndarray):
        return np.ascontiguousarray(argument).ctypes.data_as(ctypes.c_void_p)
    return argument.encode() if isinstance(argument, str) else argument


class Recording:
    """Frames of a world, for `view`. Each call of `add` records one.

    Parameters
    ----------
    world : World
        Blocks that it gets or loses later come and go in the recording.
    title : str
        Title of the page.
    names : dict, optional
        Names of blocks by their ids.
    materials : sequence of str, optional
        Names of the materials, in the order of their numbers.

    Examples
    --------
    >>> world = World(law=Law(normal_stiffness=1e7))
    >>> stone = world.add_material(density=2000)
    >>> block = world.add_block(Shape.rectangle(1, 1), (0, 1))
    >>> recording = Recording(world, names={block: "stone"})
    >>> for _ in range(3):
    ...     recording.add()
    ...     world.step(100)
    >>> len(recording)
    3
    """

    def __init__(
        self,
        world: World,
        title: str = "halfspace",
        *,
        names: Optional[Dict[int, str]] = None,
        materials: Sequence[str] = (),
    ) -> None:
        self._world = world
        self._library = viewer_library()
        self._handle = _checked(self._library.hs_recording_create(world.dimension, title.encode()))
        self._names = dict(names or {})
        self._numbers: Dict[int, int] = {}  # of blocks by their ids
        self._deforms: Dict[int, bool] = {}
        self._rows: List[List[float]] = []
        self._crack_count = 0
        encoded = [name.encode() for name in materials]
        self._call("set_materials", len(encoded), (ctypes.c_char_p * len(encoded))(*encoded))

    def __repr__(self) -> str:
        return f"<halfspace.Recording, frames: {len(self)}>"

    def __len__(self) -> int:
        return len(self._rows)

    def __reduce__(self) -> Tuple[Any, ...]:  # pickle and copy
        raise TypeError("a Recording cannot be copied or pickled; write its page")

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            self._library.hs_recording_destroy(self._handle)

    def add(self, world: Optional[World] = None) -> None:
        """Records the world now. It can be the callback of a run, which passes the world."""
        world = world or self._world
        with held(world):
            report = world.report
            blocks = [int(block) for block in world.blocks]
            for block in blocks:
                if block not in self._numbers:
                    self._add_block(world, block)
            self._call("add_frame", float(report.time))
            self._add_motion(world, blocks)
            self._add_forces(world)
            self._add_cracks(world)
        energy = report.energy
        self._rows.append([float(report[name]) for name in _REPORTED] + [float(energy[name]) for name in _ENERGIES])

    def _call(self, name: str, *arguments: Any) -> Any:
        return _checked(getattr(self._library, f"hs_recording_{name}")(self._handle, *map(_in_c, arguments)))

    def _add_block(self, world: World, block: int) -> None:
        state, vertices = world.state(block), _vertices_of(world, block)
        if len(vertices) == 0:  # a compound, whose parts are blocks
            self._numbers[block] = -1
            return
        faces = _faces_of(vertices, world.dimension)
        sizes = np.array([len(face) for face in faces], np.int32)
        corners = np.concatenate(faces).astype(np.int32)
        pose = np.concatenate((state.pose.position, state.pose.rotation))
        self._deforms[block] = BlockKind(state.kind) in _DEFORMING
        if self._deforms[block]:
            pose = np.array([*vertices.mean(axis=0), 0, 0, 0, 1])
        name = self._names.get(block, world._names.get(block, ""))
        given = name, int(state.kind), int(state.material), pose, len(vertices), vertices, len(faces), sizes, corners
        self._numbers[block] = self._call("add_block", *given)

    def _add_motion(self, world: World, blocks: List[int]) -> None:
        places = [i for i, block in enumerate(blocks) if self._numbers[block] >= 0]
        numbers = np.array([self._numbers[blocks[i]] for i in places], np.int64)
        rigid = np.array([not self._deforms[blocks[i]] for i in places], bool)
        poses = world.poses[places]
        self._call("set_poses", int(rigid.sum()), numbers[rigid], poses[rigid])
        for i, number in zip(places, numbers):
            if self._deforms[blocks[i]]:
                self._call("set_vertices", int(number), _vertices_of(world, blocks[i]))
        states = world.states()[places]
        for name, unit, vector in (
            ("speed", "m/s", "velocity"),
            ("angular speed", "rad/s", "angular_velocity"),
            ("contact force", "N", "force"),
        ):
            self._set(name, unit, numbers, np.linalg.norm(states[vector], axis=1))
        deforming = [(number, blocks[i]) for i, number in zip(places, numbers) if self._deforms[blocks[i]]]
        if deforming:
            deformed = np.array([number for number, _ in deforming], np.int64)
            deformations = [world.deformation(block) for _, block in deforming]
            for tensor, unit in (("stress", "Pa"), ("strain", "")):
                for name, (row, column) in _TENSOR[world.dimension].items():
                    values = [np.reshape(record[tensor], (3, 3))[row, column] for record in deformations]
                    self._set(f"{tensor} {name}", unit, deformed, values)

    def _set(self, name: str, unit: str, numbers: NDArray[np.int64], values: ArrayLike) -> None:
        self._call("set_values", name, unit, len(numbers), numbers, np.array(values, np.float64))

    def _add_forces(self, world: World) -> None:
        contacts = world.contacts()
        if len(contacts) > 0:
            blocks = [
                np.array([self._numbers[int(block)] for block in contacts[end]], np.int64)
                for end in ("block_a", "block_b")
            ]
            of_forces = (contacts[name] for name in ("force_point", "force", "normal_force"))
            self._call("set_contacts", len(contacts), *blocks, *of_forces)
        bolts = world.bolts()
        if len(bolts) > 0:
            names = ("number", "place_a", "place_b", "tension", "is_ruptured")
            self._call("set_bolts", len(bolts), *(bolts[name] for name in names))

    def _add_cracks(self, world: World) -> None:
        """The failures of bonds since the last frame, but for those of blocks that are not there any more."""
        events = world.bond_events(self._crack_count)
        if len(events) == 0:
            return
        self._crack_count += len(events)
        bonds = world.bonds()[events["bond"]]
        blocks_a, blocks_b = (
            np.array([self._numbers.get(int(block), -1) for block in bonds[end]], np.int64)
            for end in ("block_a", "block_b")
        )
        known = (blocks_a >= 0) & (blocks_b >= 0)
        events = events[known]
        places = (events[name] for name in ("position", "normal", "area"))
        are_shear = np.array(events["failure"] == BondFailure.SHEAR, np.int32)
        self._call("add_cracks", len(events), events["time"], blocks_a[known], blocks_b[known], *places, are_shear)

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the recording as a page of HTML. It takes no more frames then."""
        names = ["contacts" if name == "contact_count" else name for name in _REPORTED] + list(_ENERGIES)
        rows = [names, *([repr(value) for value in row] for row in self._rows)]
        self._call("set_history", "".join(",".join(row) + "\n" for row in rows))
        self._call("write", os.fsencode(viewer_page()), os.fsencode(path))


def _vertices_of(world: World, block: int) -> NDArray[np.float64]:
    """With three coordinates each, also in 2D."""
    return np.pad(world.block_vertices(block), ((0, 0), (0, 3 - world.dimension)))


def _faces_of(vertices: NDArray[np.float64], dimension: int) -> List[NDArray[np.int32]]:
    """The faces of a convex block, as loops of its vertices; in 2D the outline."""
    if dimension == 2:
        return [np.arange(len(vertices), dtype=np.int32)]
    hull = Shape.hull(vertices)
    distances = np.linalg.norm(hull.vertices[:, None] - vertices[None], axis=2)
    nearest = distances.argmin(axis=1)
    return [nearest[face] for face in hull.faces]


def read_run(directory: Union[str, "os.PathLike[str]"], path: Union[str, "os.PathLike[str]"]) -> None:
    """Writes the run in an output directory of the command as a page of HTML."""
    viewer = viewer_library()
    page = viewer_page()
    handle: Any = _checked(viewer.hs_recording_read(os.fsencode(directory)))
    try:
        _checked(viewer.hs_recording_write(handle, os.fsencode(page), os.fsencode(path)))
    finally:
        viewer.hs_recording_destroy(handle)
