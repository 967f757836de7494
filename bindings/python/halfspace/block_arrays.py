"""Arrays of all blocks of a world."""
from __future__ import annotations

from typing import Any, Callable, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import mutable_view_of, require_output, turns_view_of, view_of
from ._library import library
from ._record import Records
from .check import Given
from .context import Context, Handle, held
from .records import BlockState

Floats = NDArray[np.float64]

_TURNS_OUT = "angular_out or torques_out"


class BlockArrays(Handle):
    """Arrays of all blocks of a world, in the order of `blocks`.

    In 2D vectors have 2 components, angular velocities and torques 1; in 3D both have 3.
    """

    def __init__(
        self, context: Context, pointer: Any, destroy: Callable[[Any], None], dimension: int
    ) -> None:
        super().__init__(context, pointer, destroy)
        self._dimension = dimension
        self._given = Given()
        self._turns = np.empty((0, 3))  # buffer of 2D angular velocities or torques

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self._dimension

    def __len__(self) -> int:
        return self._value(library.hs_world_get_blocks, None, 0)

    @property
    def blocks(self) -> NDArray[np.uint64]:
        """Ids of all blocks. All arrays of blocks have this order."""
        return self._array(np.uint64, library.hs_world_get_blocks)

    @property
    def poses(self) -> Floats:
        """Positions, m, and quaternions of all blocks, shape (n, 7). Assignment sets them."""
        return self.get_poses()

    @poses.setter
    def poses(self, poses: ArrayLike) -> None:
        array = np.ascontiguousarray(poses, np.float64)
        if array.ndim != 2 or array.shape[1] != 7:
            raise ValueError(f"poses has the shape {array.shape}; it must be (n, 7)")
        self._call(library.hs_world_set_poses, array.ctypes.data, len(array))

    def get_poses(self, out: Optional[Floats] = None) -> Floats:
        """As `poses`; `out` is an optional array for the result: C-contiguous, float64, shape (n, 7)."""
        with held(self):
            count = len(self)
            array = np.empty((count, 7)) if out is None else out
            if (
                array.dtype != np.float64
                or array.shape[1:] != (7,)
                or not array.flags.carray
                or len(array) < count
            ):
                raise ValueError(
                    f"out must be a contiguous, writeable array of float64 of the shape ({count}, 7)"
                )
            self._call(library.hs_world_get_poses, array.ctypes.data, len(array), None)
        return array

    @property
    def positions(self) -> Floats:
        """Centroids of all blocks, m, shape (n, dimension)."""
        return self.get_poses()[:, : self.dimension]

    @property
    def velocities(self) -> Floats:
        """Velocities of all centroids, m/s, shape (n, dimension). Assignment sets them; fixed blocks are ignored."""
        return self.get_velocities()[0]

    @velocities.setter
    def velocities(self, velocities: ArrayLike) -> None:
        with held(self):
            self.set_velocities(velocities, self.angular_velocities)

    @property
    def angular_velocities(self) -> Floats:
        """Angular velocities of all blocks, rad/s, shape (n,) in 2D, (n, 3) in 3D. Assignment sets them."""
        return self.get_velocities()[1]

    @angular_velocities.setter
    def angular_velocities(self, angular_velocities: ArrayLike) -> None:
        with held(self):
            self.set_velocities(self.velocities, angular_velocities)

    def set_velocities(self, velocities: ArrayLike, angular_velocities: ArrayLike) -> None:
        """Sets velocities and angular velocities of all blocks; strided arrays of float64 are not copied."""
        view = view_of(velocities, self.dimension, "velocities")
        turns = turns_view_of(angular_velocities, self.dimension, "angular_velocities")
        self._call(library.hs_world_set_velocities, view, turns)

    def get_velocities(
        self, out: Optional[Floats] = None, angular_out: Optional[Floats] = None
    ) -> Tuple[Floats, Floats]:
        """Returns velocities and angular velocities; `out` and `angular_out` are optional arrays for the results,
        which may be strided."""
        return self._vectors_and_turns(library.hs_world_get_velocities, (), out, angular_out)

    def states(self) -> Records:
        """Returns the motion of all blocks: an array of `BLOCK_STATE`. ``states().force`` are the contact forces of
        the last step, ``states().mass`` the masses."""
        return self._records(BlockState, library.hs_world_get_block_states)

    @property
    def contact_forces(self) -> Floats:
        """Forces of contacts, bonds, bolts and water on all blocks at the last step, N, shape (n, dimension)."""
        return np.ascontiguousarray(self.states()["force"][:, : self.dimension])

    @property
    def contact_torques(self) -> Floats:
        """Their torques about the centroids, N m, shape (n,) in 2D, (n, 3) in 3D."""
        torques = self.states()["torque"]
        return np.ascontiguousarray(torques[:, 2] if self.dimension == 2 else torques)

    def set_applied_forces(self, forces: ArrayLike, torques: Optional[ArrayLike] = None) -> None:
        """Sets the external forces, N, shape (n, dimension), and torques, N m, shape (n,) in 2D, (n, 3) in 3D, of all
        rigid and affine blocks, until set again; without torques these are 0. Those of other blocks are ignored.
        Strided arrays of float64 are not copied."""
        view = view_of(forces, self.dimension, "forces")
        about = _raw.hs_view() if torques is None else turns_view_of(torques, self.dimension, "torques")
        self._call(library.hs_world_set_applied_forces, view, about)
        self._given.beyond_scenes.add("applied forces")

    def _vectors_and_turns(
        self, function: Any, before: Tuple[Any, ...], out: Optional[Floats], turns_out: Optional[Floats]
    ) -> Tuple[Floats, Floats]:
        with held(self):
            count, flat = len(self), self.dimension == 2
            vectors = np.empty((count, self.dimension)) if out is None else out
            turns = np.empty(count if flat else (count, 3)) if turns_out is None else turns_out
            for array, name in ((vectors, "out"), (turns, _TURNS_OUT)):
                require_output(array, name)
                if len(array) != count:
                    raise ValueError(f"{name} has the length {len(array)}; the world has {count} blocks")
            written = turns
            if flat and turns.ndim == 1:
                if len(self._turns) != count:
                    self._turns = np.empty((count, 3))
                written = self._turns
            self._call(
                function,
                *before,
                mutable_view_of(vectors, self.dimension, "out"),
                mutable_view_of(written, 3, _TURNS_OUT),
            )
            if written is not turns:
                turns[:] = written[:, 2]
        return vectors, turns
