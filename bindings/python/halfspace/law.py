"""Contact laws."""
import ctypes
import dataclasses
from typing import Union

from . import _raw
from ._library import library
from .constants import StiffnessKind, choice


@dataclasses.dataclass(frozen=True)
class Law:
    """Normal force with Mohr-Coulomb friction between two materials: a penalty spring or a potential.

    Attributes
    ----------
    normal_stiffness, shear_stiffness : float
        N/m, or Pa/m when the stiffness is per area; of a potential Pa and N/m; > 0 and >= 0. A shear stiffness
        of 0 stands for the number of the normal one.
    friction_angle : float
        rad, from 0 to below pi/2.
    cohesion, tensile_strength : float
        Pa, >= 0; of contacts that exist when a block's first step begins, until they fail. A potential takes
        neither.
    normal_damping, shear_damping : float
        Share of critical viscous damping, >= 0. Without any, friction feeds the vibration of what it should hold.
    stiffness_kind : StiffnessKind or its name
        What the stiffnesses refer to: "per contact", "per area" or "potential"; "none" for a law without springs.

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
    stiffness_kind: Union[StiffnessKind, str] = StiffnessKind.PER_CONTACT

    def __post_init__(self) -> None:
        object.__setattr__(self, "stiffness_kind", choice(self.stiffness_kind, StiffnessKind, "stiffness_kind"))

    def _as_struct(self) -> _raw.hs_law_def:
        struct = _raw.hs_law_def()
        library.hs_law_def_init(ctypes.byref(struct), ctypes.sizeof(struct))
        for field in dataclasses.fields(self):
            setattr(struct, field.name, getattr(self, field.name))
        return struct
