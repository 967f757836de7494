"""Dynamic relaxation, changes of settings, and strength reduction."""
from __future__ import annotations

import ctypes
import operator
from typing import Tuple, Union

from numpy.typing import ArrayLike

from . import _raw
from ._arrays import gravity_vector
from ._choice import choice
from ._definition import filled
from ._library import library
from ._record import empty_record
from .constants import Unbalanced
from .context import held
from .records import Balance, StrengthReport
from .water import WetBlocks

_STEPS_OF_PIECE = 20000  # as of bindings/cli/run/settle.h


class Statics(WetBlocks):
    """Relaxation, changes of settings, and strength reduction."""

    def relax(
        self,
        ratio: float = 1e-5,
        *,
        measure: Union[Unbalanced, str] = Unbalanced.MEAN,
        max_steps: int = 1000000,
        local_damping: float = 0.1,
        adaptive: bool = True,
        hold_bonds: bool = True,
    ) -> Tuple[bool, Balance]:
        """Steps the world under strong damping until static equilibrium, then sets all velocities to 0. Damping and
        the state of `hold_bonds` are restored afterwards. As stages of a scene do, it begins anew after each 20000
        steps; there Ctrl-C interrupts it.

        Parameters
        ----------
        ratio : float
            Unbalanced ratio of equilibrium, > 0.
        measure : Unbalanced or its name
            "mean": sum of unbalanced forces over sum of all forces; "largest": largest ratio of a single block or node.
        max_steps : int
            Max number of steps, at least 1.
        local_damping : float
            [0, 1); use 0.8 without adaptive damping.
        adaptive : bool
            Critical mass damping of the slowest mode; False: the world's mass damping.
        hold_bonds : bool
            Bonds cannot fail during the relaxation.

        Returns
        -------
        tuple
            True in equilibrium, and a record of `BALANCE`.
        """
        given = dict(ratio=ratio, local_damping=local_damping, is_adaptive=int(adaptive), hold_bonds=int(hold_bonds))
        struct = filled(_raw.hs_relaxation_def(), library.hs_relaxation_def_init, **given)
        struct.measure = choice(measure, Unbalanced, "measure")
        final, balance = empty_record(Balance)
        done, left = 0, operator.index(max_steps)
        with held(self):
            while True:
                struct.max_steps = min(left, _STEPS_OF_PIECE)
                status = self._call(library.hs_world_relax, struct, balance, ctypes.sizeof(balance))
                done += balance.steps
                left -= balance.steps
                if status != _raw.HS_NOTE_NOT_AT_REST or left <= 0 or balance.steps < struct.max_steps:
                    break
        balance.steps = done
        return status != _raw.HS_NOTE_NOT_AT_REST, final

    @property
    def balance(self) -> Balance:
        """Current balance of forces: a record of `BALANCE`. It costs as much as a step."""
        return self._record(Balance, library.hs_world_get_balance)

    def set_gravity(self, gravity: ArrayLike) -> None:
        """Sets gravity, m/s2. The change of potential energy counts as external work."""
        self._call(library.hs_world_set_gravity, gravity_vector(gravity, self.dimension))

    def set_damping(self, local_damping: float = 0.0, mass_damping: float = 0.0) -> None:
        """Sets local and mass damping, see `World`."""
        self._call(library.hs_world_set_damping, local_damping, mass_damping)

    def set_time_step(self, time_step: float) -> None:
        """Sets the time step, s; 0: `safety` times the stable time step."""
        self._call(library.hs_world_set_time_step, time_step)

    def set_strength_factor(self, factor: float) -> None:
        """Divides the given friction (tangent of its angle), cohesion and tensile strength of all laws and bonds by a
        factor, from 1e-75 to 1e75. Calls do not accumulate."""
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
    ) -> StrengthReport:
        """Computes the factor of safety by bisection. Each trial relaxes a copy of the world with reduced strength,
        in which bonds can fail. The world, which should be in equilibrium, does not change.

        Parameters
        ----------
        low, high, resolution : float
            Initial bracket, and width of the final one.
        ratio : float
            Unbalanced ratio of a stable world.
        max_displacement : float
            Displacement of a block, divided by its size, that is failure.
        max_steps : int
            A world not in equilibrium after these steps has failed.

        Returns
        -------
        numpy.record
            A record of `STRENGTH_REPORT`, with `factor`, `low` and `high`.
        """
        bracket = dict(low=low, high=high, resolution=resolution)
        trial = dict(ratio=ratio, max_displacement=max_displacement, max_steps=max_steps)
        struct = filled(_raw.hs_strength_def(), library.hs_strength_def_init, **bracket, **trial)
        report, written = empty_record(StrengthReport)
        self._call(library.hs_world_find_strength_factor, struct, written, ctypes.sizeof(written), None)
        return report
