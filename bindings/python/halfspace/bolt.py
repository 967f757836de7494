"""Bolts and cables: lines between two places that blocks carry, or between a block and the ground."""
from __future__ import annotations

import operator
from typing import Optional

from numpy.typing import ArrayLike

from ._arrays import block_id, struct_of, vector
from ._library import library
from ._record import Records
from .bond import BondedBlocks
from .properties import Bolt
from .records import Bolt as BoltRecord


class BoltedBlocks(BondedBlocks):
    """Bolts of a world."""

    def add_bolt(
        self, bolt: Bolt, place_a: ArrayLike, place_b: ArrayLike, block_a: Optional[int], block_b: Optional[int]
    ) -> int:
        """Adds a bolt between the current positions of two places, each carried by a block, or by the ground where the
        block is None. Returns its number, which no later bolt gets. The removal of a block removes its bolts."""
        struct = struct_of(bolt, Bolt, "bolt")
        struct.block_a = 0 if block_a is None else block_id(block_a, "block_a")
        struct.block_b = 0 if block_b is None else block_id(block_b, "block_b")
        struct.place_a[:] = vector(place_a, "place_a")[:]
        struct.place_b[:] = vector(place_b, "place_b")[:]
        self._given.beyond_scenes.add("bolts")
        return self._value(library.hs_world_add_bolt, struct)

    def add_bolt_at(self, bolt: Bolt, place_a: ArrayLike, place_b: ArrayLike) -> int:
        """The same between the blocks that contain the places; a place outside of all blocks is on the ground."""
        return self.add_bolt(bolt, place_a, place_b, self.block_at(place_a), self.block_at(place_b))

    def remove_bolt(self, number: int) -> None:
        """Removes a bolt."""
        self._call(library.hs_world_remove_bolt, operator.index(number))

    def bolts(self) -> Records:
        """Returns all bolts, in ascending order of their numbers: an array of `BOLT`."""
        return self._records(BoltRecord, library.hs_world_get_bolts)

    def block_at(self, place: ArrayLike) -> Optional[int]:
        """Returns the block in which a place is deepest; None if it is outside of all blocks."""
        return self._value(library.hs_world_get_block_at, vector(place, "place")) or None
