"""Contact laws."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import Union

from . import _raw
from ._choice import choice
from ._library import library
from .constants import StiffnessKind


@dataclasses.dataclass(frozen=True)
class Law:
    """Contact law between two materials: normal force by a penalty spring, a potential or a unilateral constraint,
    with Mohr-Coulomb friction.

    Attributes
    ----------
    normal_stiffness, shear_stiffness : float
        Per contact N/m, per area Pa/m, of a potential Pa and N/m; > 0 and >= 0. A shear stiffness of 0 is equal to
        the normal stiffness.
    friction_angle : float
        rad, [0, pi/2).
    cohesion, tensile_strength : float
        Pa, >= 0; of contacts that exist when a block's first step begins, until they fail. They must be 0 with a
        potential.
    normal_damping, shear_damping : float
        Damping ratio (fraction of critical viscous damping), >= 0. Without damping friction feeds vibrations.
    restitution : float
        Coefficient of restitution of rigid blocks, [0, 1]; only without springs, cohesion and tensile strength.
    stiffness_kind : StiffnessKind or its name
        As "per contact"; "none" is a unilateral constraint without springs.

    Examples
    --------
    >>> rock = Law(normal_stiffness=1e7, shear_stiffness=5e6, friction_angle=0.5)
    >>> rock.cohesion
    0.0
    """

    normal_stiffness: float = 1e9
    shear_stiffness: float = 0.0
    friction_angle: float = 0.0
    cohesion: float = 0.0
    tensile_strength: float = 0.0
    normal_damping: float = 0.1
    shear_damping: float = 0.1
    restitution: float = 0.0
    stiffness_kind: Union[StiffnessKind, str] = StiffnessKind.PER_CONTACT

    def __post_init__(self) -> None:
        object.__setattr__(self, "stiffness_kind", choice(self.stiffness_kind, StiffnessKind, "stiffness_kind"))

    def _as_struct(self) -> _raw.hs_law_def:
        struct = _raw.hs_law_def()
        library.hs_law_def_init(ctypes.byref(struct), ctypes.sizeof(struct))
        for field in dataclasses.fields(self):
            setattr(struct, field.name, getattr(self, field.name))
        return struct
