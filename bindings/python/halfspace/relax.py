"""A world that is brought to rest, changed while it lives, and weakened until it falls."""
import ctypes
from typing import Any, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _raw
from ._arrays import BALANCE, STRENGTH_REPORT, empty_record, vector
from ._library import library
from .bond import BondedBlocks
from .constants import Unbalanced, choice


class Statics(BondedBlocks):
    """Rest, and what leads away from it."""

    def relax(
        self,
        ratio: float = 1e-5,
        *,
        measure: Union[Unbalanced, str] = Unbalanced.MEAN,
        max_steps: int = 1000000,
        local_damping: float = 0.1,
        adaptive: bool = True,
        hold_bonds: bool = True,
    ) -> Tuple[bool, Any]:
        """Steps the world under strong damping until no force is left unbalanced. Its own damping comes back
        afterwards; at rest, velocities are set to 0.

        Parameters
        ----------
        ratio : float
            Of unbalanced forces to all, at which it is at rest.
        measure : Unbalanced or its name
            Over all forces, or the largest ratio of a single block or node.
        max_steps : int
            At least 1.
        local_damping : float
            [0, 1) meanwhile; without adaptive damping 0.8 does best.
        adaptive : bool
            Mass damping twice as fast as the slowest motion that is left swings.
        hold_bonds : bool
            Bonds do not fail meanwhile.

        Returns
        -------
        tuple
            Whether it is at rest, and a record of `BALANCE`.
        """
        struct = _raw.hs_relaxation_def()
        library.hs_relaxation_def_init(ctypes.byref(struct), ctypes.sizeof(struct))
        struct.measure, struct.ratio, struct.max_steps = choice(measure, Unbalanced, "measure"), ratio, max_steps
        struct.local_damping, struct.is_adaptive, struct.hold_bonds = local_damping, int(adaptive), int(hold_bonds)
        array, address = empty_record(BALANCE)
        balance = _raw.hs_balance.from_address(address)
        status = self._call(library.hs_world_relax, struct, balance, BALANCE.itemsize)
        return status != _raw.HS_NOTE_NOT_AT_REST, array[0]

    @property
    def balance(self) -> Any:
        """The balance of the world now: a record of `BALANCE`. Takes as long as a step."""
        array, address = empty_record(BALANCE)
        self._call(library.hs_world_get_balance, _raw.hs_balance.from_address(address), BALANCE.itemsize)
        return array[0]

    def set_gravity(self, gravity: ArrayLike) -> None:
        """Sets gravity from now on, m/s2."""
        self._call(library.hs_world_set_gravity, vector(gravity, "gravity"))
        self._given.see("gravity", np.array(vector(gravity, "gravity")[:]))

    def set_damping(self, local_damping: float = 0.0, mass_damping: float = 0.0) -> None:
        """Sets damping from now on, see `World`."""
        self._call(library.hs_world_set_damping, local_damping, mass_damping)
        self._given.see("mass_damping", mass_damping)

    def set_time_step(self, time_step: float) -> None:
        """Sets the time step from now on; 0: a share of the stable one."""
        self._call(library.hs_world_set_time_step, time_step)
        self._given.see("time_step", time_step)

    def set_strength_factor(self, factor: float) -> None:
        """Divides friction, cohesion and tensile strength of all laws and bonds, as they were given, by a factor."""
        self._call(library.hs_world_set_strength_factor, factor)

    def find_strength_factor(
        self,
        low: float = 0.5,
        high: float = 5.0,
        resolution: float = 0.005,
        *,
        ratio: float = 1e-5,
        max_displacement: float = 0.1,
        max_steps: int = 100000,
    ) -> Any:
        """Looks for the factor of safety by bisection: how many times weaker all materials could be until something
        moves. Each trial relaxes a copy of the world, which stays as it is and should be at rest.

        Parameters
        ----------
        low, high, resolution : float
            The bracket, and how narrow it has to be.
        ratio : float
            Of unbalanced forces at which a world stands.
        max_displacement : float
            Share of its size by which a block that moves has fallen.
        max_steps : int
            What is not at rest by then falls as well.

        Returns
        -------
        numpy.record
            A record of `STRENGTH_REPORT`, with `factor`, `low` and `high`.
        """
        struct = _raw.hs_strength_def()
        library.hs_strength_def_init(ctypes.byref(struct), ctypes.sizeof(struct))
        struct.low, struct.high, struct.resolution, struct.ratio = low, high, resolution, ratio
        struct.max_displacement, struct.max_steps = max_displacement, max_steps
        array, address = empty_record(STRENGTH_REPORT)
        report = _raw.hs_strength_report.from_address(address)
        self._call(library.hs_world_find_strength_factor, struct, report, STRENGTH_REPORT.itemsize, None)
        return array[0]
