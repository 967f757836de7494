"""Contacts by laws without a spring: the points that are kept apart, and by which force."""
from typing import Any

import numpy as np

from . import _raw
from ._arrays import REACTION, REACTION_REPORT, empty_record, empty_records
from ._library import library
from .bond import BondedBlocks
from .context import held


class ReactingBlocks(BondedBlocks):
    """The contacts without springs of a world."""

    def reactions(self) -> "np.recarray[Any, Any]":
        """Those at the end of the last step, in order of their blocks: a structured array of `REACTION`."""
        with held(self):
            reactions = empty_records(int(self.reaction_report.reaction_count), REACTION)
            self._call(library.hs_world_get_reactions, reactions.ctypes.data, len(reactions), None)
        return reactions

    @property
    def reaction_report(self) -> Any:
        """Their numbers, and the energy that touches have taken: a record of `REACTION_REPORT`."""
        array, address = empty_record(REACTION_REPORT)
        report = _raw.hs_reaction_report.from_address(address)
        self._call(library.hs_world_get_reaction_report, report, REACTION_REPORT.itemsize)
        return array[0]
