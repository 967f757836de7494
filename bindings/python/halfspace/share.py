"""Shares of a world, for hosts that spread one world over processes."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import TYPE_CHECKING, Any, List, Sequence, Tuple, Union, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import shaped
from ._choice import choice
from ._library import library
from ._record import Floats
from .block_arrays import BlockArrays
from .constants import Role
from .context import Context, held, made
from .records import ShareInfo, SharePlan

if TYPE_CHECKING:
    from .world import World


def _as_keys(values: ArrayLike) -> NDArray[np.int64]:
    """Contiguous keys for C; an array of int64 is not copied."""
    given = np.asarray(values)
    array = np.ascontiguousarray(given, np.int64).ravel()
    if not np.array_equal(array, given.ravel()):
        raise ValueError("keys must be 64-bit integers")
    return array


@dataclasses.dataclass(frozen=True)
class Packed:
    """A block of a share to be assembled.

    Attributes
    ----------
    key : int
        Name of the block in all shares.
    role : Role or its name
        OWN, NEIGHBOR or EVERYWHERE.
    data : bytes, optional
        From `World.pack` of the share that owns the block. None: as the world that assembles the share has it, of
        which the block is its own or everywhere.
    """

    key: int
    role: Union[Role, str] = Role.OWN
    data: Union[bytes, bytearray, memoryview, None] = None

    def _as_struct(self) -> _raw.hs_packed:
        key, role = _as_keys(self.key).item(), choice(self.role, Role, "role")
        if self.data is None:
            return _raw.hs_packed(key, None, 0, role)
        stored = np.frombuffer(self.data, np.uint8)
        return _raw.hs_packed(key, stored.ctypes.data, stored.nbytes, role)


class Shares(BlockArrays):
    """A world of which each process holds a share: its own blocks, and copies of their neighbours.

    All processes make the same calls, and the host carries packed blocks and loads between them, e.g. by mpi4py::

        plan ──▶ does any need a list or an assembly? ── yes: pack, carry, assemble, plan; renew the lists
          └────▶ move ──▶ loads, carry, set_loads ──▶ end_step

    The motion has the same bits as by `step` of the whole world, for any number of shares. Shares hold rigid and
    affine blocks, laws with springs and potential laws, water, applied forces, and motions and loads in time; the
    world needs a given time step.
    """

    _load_length = 0  # of a row of loads; 0: to be asked for, as its computation visits all blocks

    @property
    def keys(self) -> NDArray[np.int64]:
        """Names of all blocks in all shares, ascending; by default places in `blocks`. Assignment sets those of a
        whole world. Blocks that are added or removed later end these keys."""
        return self._array(np.int64, library.hs_world_get_keys)

    @keys.setter
    def keys(self, keys: ArrayLike) -> None:
        array = _as_keys(keys)
        self._call(library.hs_world_set_keys, array.ctypes.data, array.size)

    @property
    def roles(self) -> NDArray[np.int32]:
        """Roles of all blocks, values of `Role`. In a whole world fixed and prescribed blocks are everywhere, all
        others own."""
        return self._array(np.int32, library.hs_world_get_roles)

    def share_info(self) -> ShareInfo:
        """Returns numbers of blocks, and how far copies must reach, after `plan_motion`: a record of `SHARE_INFO`."""
        return self._record(ShareInfo, library.hs_world_get_share_info)

    def pack(self, keys: ArrayLike, with_shapes: bool = True) -> List[bytes]:
        """Packs blocks for other shares: their motion, and the memory of their pairs.

        Parameters
        ----------
        keys : array_like
            Of own blocks, or of blocks that are everywhere, in any order.
        with_shapes : bool
            With their outlines, for shares that do not have the block.

        Returns
        -------
        list of bytes
            Per key, in the machine's format of numbers.
        """
        array = _as_keys(keys)
        ends, needed = np.zeros(array.size, np.uintp), ctypes.c_size_t()
        with held(self):
            given = (array.ctypes.data, array.size, int(with_shapes))
            self._call(library.hs_world_pack, *given, None, 0, None, ctypes.byref(needed))
            room = np.empty(needed.value, np.uint8)
            written = (room.ctypes.data, room.nbytes, ends.ctypes.data)
            self._call(library.hs_world_pack, *given, *written, ctypes.byref(needed))
        return [block.tobytes() for block in np.split(room, ends[:-1].astype(np.intp))[: array.size]]

    def assemble(self, blocks: Sequence[Packed]) -> "World":
        """Makes a world of blocks, in the same context: a share, or the whole world again where all its blocks are own
        ones. This world does not change.

        Parameters
        ----------
        blocks : sequence of Packed
            In ascending order of keys: all own blocks of the share, copies of all blocks within its halo, packed in
            the present motion, and all blocks that are everywhere.

        Returns
        -------
        World
            Its settings, laws, clock, list of pairs and losses are those of this world.
        """
        structs = (_raw.hs_packed * len(blocks))(*[block._as_struct() for block in blocks])

        def own(owner: Context, pointer: Any) -> "World":
            share: "World" = cast(Any, type(self))._of(owner, pointer, self.dimension)
            share._given = self._given.copy()
            return share

        with held(self):
            return made(own, self.context, library.hs_world_assemble, self._alive, structs, len(blocks))

    @property
    def sums(self) -> Floats:
        """Energies and losses (16, J), powers (5, W), linear momentum (3, N s) and angular momentum about the origin
        (3, N m s), as numbers that add up over shares to those of the whole world. Assignment sets them, all but the
        momentum: to the sums over the shares whose blocks the world has taken over, as it continues their losses."""
        sums = np.empty(_raw.HS_SUM_COUNT)
        self._call(library.hs_world_get_sums, sums.ctypes.data)
        return sums

    @sums.setter
    def sums(self, sums: ArrayLike) -> None:
        array = shaped(np.ascontiguousarray(sums, np.float64), "sums", (_raw.HS_SUM_COUNT,))
        self._call(library.hs_world_set_sums, array.ctypes.data)

    # ---- a step ----

    def begin(self) -> None:
        """Begins after blocks were added, or laws, velocities or forces changed: computes contacts and forces where
        blocks are. Then loads are carried, and `end_begin` follows."""
        self._call(library.hs_world_begin)

    def end_begin(self) -> None:
        """Computes accelerations and energies of the beginning, from the loads."""
        self._call(library.hs_world_end_begin)

    def plan_motion(self) -> SharePlan:
        """Plans the motion of a step, without moving any block, and returns its needs: a record of `SHARE_PLAN`. The
        host combines those of all shares: the maximum of `needs_list` and of `needs_assembly`, the minimum of
        `refusal`."""
        return self._record(SharePlan, library.hs_world_plan_motion)

    def renew_list(self) -> SharePlan:
        """Renews the list of pairs for the planned motion, in all shares if the plan of any needs it. Returns the plan
        with the new list, whose `refusal` counts."""
        return self._record(SharePlan, library.hs_world_renew_list)

    def move(self) -> None:
        """Makes the planned motion, which must be without a refusal, and computes contacts and forces after it."""
        self._call(library.hs_world_move)

    def loads(self, keys: ArrayLike) -> Floats:
        """Returns the loads of the contacts on own blocks, for the shares that have copies: a row per key with force,
        torque, and in worlds with elastic materials the virial."""
        array = _as_keys(keys)
        with held(self):
            loads = np.empty(self._shape_of_loads(array))
            self._call(library.hs_world_get_loads, array.ctypes.data, array.size, loads.ctypes.data)
        return loads

    def set_loads(self, keys: ArrayLike, loads: ArrayLike) -> None:
        """Sets the loads of the contacts on copies, as `loads` of their owner returned them."""
        array, rows = _as_keys(keys), np.ascontiguousarray(loads, np.float64)
        with held(self):
            shaped(rows, "loads", self._shape_of_loads(array))
            self._call(library.hs_world_set_loads, array.ctypes.data, array.size, rows.ctypes.data)

    def end_step(self) -> None:
        """Ends the step: computes velocities and energies at the end of the motion, from the loads."""
        self._call(library.hs_world_end_step)

    def _shape_of_loads(self, keys: NDArray[np.int64]) -> Tuple[int, int]:
        if self._load_length == 0:
            self._load_length = self.share_info().load_length
        return keys.size, self._load_length
