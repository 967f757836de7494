"""Time of impact: when do two moving shapes first touch?"""
import ctypes
import dataclasses
from typing import Any, Optional

from numpy.typing import ArrayLike

from . import _raw
from ._arrays import IMPACT, as_pose, empty_record, tensor, turn_vector, vector
from ._library import library
from .context import held
from .shape import Shape


@dataclasses.dataclass(frozen=True)
class Motion:
    """How a shape moves: its centroid straight and its turn even. By default it rests at the origin.

    At time t the point that is at X in the shape's frame is at position + t velocity + R(t angular_velocity) Q
    (gradient + t gradient_rate) X, with position and Q those of `start`, and R(v) the turn about v by its length.

    Attributes
    ----------
    start : array_like
        Where it is at first: a position, or 7 numbers as from `pose`.
    velocity : array_like
        Of the centroid, m/s.
    angular_velocity : array_like
        rad/s; one number is about z. It may turn by up to 1e6 rad.
    gradient : array_like, optional
        How it is strained at first, before `start` turns it: 2 rows of 2 or 3 of 3. By default it is not.
    gradient_rate : array_like, optional
        Of the gradient, 1/s; by default 0.

    Examples
    --------
    >>> Motion((0, 2), velocity=(0, -300)).angular_velocity
    0.0
    """

    start: ArrayLike = (0.0, 0.0)
    velocity: ArrayLike = (0.0, 0.0)
    angular_velocity: ArrayLike = 0.0
    gradient: Optional[ArrayLike] = None
    gradient_rate: Optional[ArrayLike] = None

    def _as_struct(self) -> _raw.hs_motion_def:
        struct = _raw.hs_motion_def()
        library.hs_motion_def_init(ctypes.byref(struct), ctypes.sizeof(struct))
        struct.start = as_pose(self.start, "start")
        struct.velocity = vector(self.velocity, "velocity")
        struct.angular_velocity = turn_vector(self.angular_velocity, "angular_velocity")
        if self.gradient is not None:
            struct.gradient = tensor(self.gradient, "gradient")
        if self.gradient_rate is not None:
            struct.gradient_rate = tensor(self.gradient_rate, "gradient_rate")
        return struct


def pair_time_of_impact(
    shape_a: Shape, motion_a: Motion, shape_b: Shape, motion_b: Motion, duration: float
) -> Any:
    """When do two moving shapes first touch?

    No touch is passed over, however fast or thin the shapes are or however often they turn: they are apart at
    every time before the one told.

    Parameters
    ----------
    shape_a, shape_b : Shape
        Both of one dimension; the same one twice is legal.
    motion_a, motion_b : Motion
        How they move.
    duration : float
        Of the motions, s, >= 0.

    Returns
    -------
    numpy.record
        The fields of ``hs_impact`` (`IMPACT`): `state`, an `ImpactState`; `time` in s, never later than the
        first touch and the duration if there is none; and of a touch the potential pair, its `gap`, small to
        rounding, its `normal` from a to b, and the `point`.

    Examples
    --------
    >>> plate, bar = Shape.rectangle(1, 0.005), Shape.rectangle(0.005, 0.1)
    >>> impact = pair_time_of_impact(plate, Motion(), bar, Motion((0, 1), velocity=(0, -300)), 0.01)
    >>> ImpactState(impact.state).name, round(impact.time, 9)
    ('TOUCH', 0.003158333)
    """
    array, address = empty_record(IMPACT)
    moved_a, moved_b = motion_a._as_struct(), motion_b._as_struct()
    with held(shape_a, shape_b):
        shape_a._call(
            library.hs_pair_time_of_impact,
            moved_a,
            shape_b._alive,
            moved_b,
            duration,
            _raw.hs_impact.from_address(address),
        )
    return array[0]
