"""Time of impact of two moving shapes."""
from __future__ import annotations

import dataclasses
from typing import Optional

from numpy.typing import ArrayLike

from . import _raw
from ._arrays import as_pose, struct_of, tensor, turn_vector, vector
from ._definition import filled
from ._library import library
from .context import held
from .records import Impact
from .shape import Shape


@dataclasses.dataclass(frozen=True)
class Motion:
    """Motion of a shape with constant linear and angular velocity and constant rate of deformation. By default it is
    at rest at the origin.

    At time t the material point X (in the shape's frame) is at position + t velocity + R(t angular_velocity) Q
    (gradient + t gradient_rate) X, with position and rotation Q of `start`, and R(v) the rotation about v by the
    angle |v|.

    Attributes
    ----------
    start : array_like
        Pose at time 0: a position, or 7 numbers as from `pose`.
    velocity : array_like
        Velocity of the centroid, m/s.
    angular_velocity : array_like
        rad/s; one number is about z. Times the duration at most 1e6 rad.
    gradient : array_like, optional
        Deformation gradient at time 0, before the rotation of `start`: shape (2, 2) or (3, 3). By default the identity.
    gradient_rate : array_like, optional
        Rate of the gradient, 1/s; by default 0.

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
        start, velocity = as_pose(self.start, "start"), vector(self.velocity, "velocity")
        motion = dict(velocity=velocity, angular_velocity=turn_vector(self.angular_velocity, "angular_velocity"))
        gradients = dict(gradient=self.gradient, gradient_rate=self.gradient_rate)
        given = {name: tensor(value, name) for name, value in gradients.items() if value is not None}
        return filled(_raw.hs_motion_def(), library.hs_motion_def_init, start=start, **motion, **given)


def pair_time_of_impact(
    shape_a: Shape, motion_a: Motion, shape_b: Shape, motion_b: Motion, duration: float
) -> Impact:
    """Computes the time of impact of two moving shapes by conservative advancement.

    The shapes are separated at all times before the reported one, whatever their speed, thickness or number of
    revolutions.

    Parameters
    ----------
    shape_a, shape_b : Shape
        Of the same dimension; may be the same shape.
    motion_a, motion_b : Motion
        Their motions.
    duration : float
        s, >= 0.

    Returns
    -------
    numpy.record
        A record of `IMPACT`: `state`, an `ImpactState`; `time` in s, never later than the first touch, or the
        duration if there is none; and for a touch the potential contact pair, its `gap`, close to rounding, its
        `normal` from a to b, and the `point`.

    Examples
    --------
    >>> plate, bar = Shape.rectangle(1, 0.005), Shape.rectangle(0.005, 0.1)
    >>> impact = pair_time_of_impact(plate, Motion(), bar, Motion((0, 1), velocity=(0, -300)), 0.01)
    >>> ImpactState(impact.state).name, round(impact.time, 9)
    ('TOUCH', 0.003158333)
    """
    moved_a, moved_b = struct_of(motion_a, Motion, "motion_a"), struct_of(motion_b, Motion, "motion_b")
    with held(shape_a, shape_b):
        return shape_a._record(Impact, library.hs_pair_time_of_impact, moved_a, shape_b._alive, moved_b, duration)
