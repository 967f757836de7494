"""Contact detection of one pair or many pairs, for hosts with their own bodies."""
from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import as_pose, indices, shaped
from ._definition import filled
from ._library import library
from ._record import Records
from .context import held, pointers_of
from .records import CONTACT, PAIR_CACHE, Contact
from .shape import Shape


class PairCache:
    """Cached state of a pair between calls: detection is faster and keeps the contact plane of the first touch.

    Use one per pair. ``PairCache(other)`` is a copy.
    """

    def __init__(self, other: Optional["PairCache"] = None) -> None:
        self._struct: _raw.hs_pair_cache = (
            _raw.hs_pair_cache.from_buffer_copy(other._struct) if other else _raw.hs_pair_cache()
        )

    def __repr__(self) -> str:
        return f"<halfspace.PairCache: {('unknown', 'separated', 'in contact')[self._struct.state]}>"

    def clear(self) -> None:
        """Empties the cache."""
        self._struct = _raw.hs_pair_cache()


def _options(
    parallel_angle: Optional[float], vertex_zone: Optional[float], margin: float, without_region: bool
) -> Any:
    if parallel_angle is None and vertex_zone is None and margin == 0 and not without_region:
        return None
    given = dict(parallel_angle=parallel_angle, vertex_zone=vertex_zone, margin=margin, without_region=without_region)
    chosen = {name: value for name, value in given.items() if value is not None}
    return filled(_raw.hs_pair_options(), library.hs_pair_options_init, **chosen)


def pair_detect(
    shape_a: Shape,
    pose_a: ArrayLike,
    shape_b: Shape,
    pose_b: ArrayLike,
    *,
    cache: Optional[PairCache] = None,
    parallel_angle: Optional[float] = None,
    vertex_zone: Optional[float] = None,
    margin: float = 0.0,
    without_region: bool = False,
) -> Contact:
    """Detects the contact of two shapes.

    Parameters
    ----------
    shape_a, shape_b : Shape
        Of the same dimension; may be the same shape.
    pose_a, pose_b : array_like
        Their poses: a position, or 7 numbers as from `pose`.
    cache : PairCache, optional
        The cache of this pair from the last call.
    parallel_angle : float, optional
        Max angle of parallel edges (3D: faces, or an edge and a face), rad, [0, 0.5]; by default 0.01.
    vertex_zone : float, optional
        Distance from the end of an edge at which a vertex touches that end, divided by the length of the shorter
        edge, [0, 0.5]; by default 1e-6.
    margin : float
        Polygons are in contact up to this gap (skin), m, [0, 1e75]; 0 in 3D.
    without_region : bool
        Report only the pair of largest gap of polygons in contact, without region; False in 3D.

    Returns
    -------
    numpy.record
        A record of `CONTACT`: `type`, `normal` from a to b, `gap` (< 0 is overlap), `points` and more. The `type` of
        separated shapes is 0, and their `gap` a lower bound of the distance.

    Examples
    --------
    >>> square = Shape.rectangle(1, 1)
    >>> contact = pair_detect(square, (0, 0), square, (0.25, 0.875))
    >>> print(contact.gap, contact.area)
    -0.125 0.75
    """
    place_a, place_b = as_pose(pose_a, "pose_a"), as_pose(pose_b, "pose_b")
    options = _options(parallel_angle, vertex_zone, margin, without_region)
    with held(shape_a, shape_b):
        given = place_a, shape_b._alive, place_b, options, None if cache is None else cache._struct
        return shape_a._record(Contact, library.hs_pair_detect, *given)


def pair_caches(count: int) -> NDArray[Any]:
    """Empty caches for `pairs_detect`, one per pair."""
    return np.zeros(count, PAIR_CACHE)


def pairs_detect(
    shapes: Sequence[Shape],
    poses: ArrayLike,
    pairs: ArrayLike,
    *,
    caches: Optional[NDArray[Any]] = None,
    parallel_angle: Optional[float] = None,
    vertex_zone: Optional[float] = None,
    margin: float = 0.0,
    without_region: bool = False,
    out: Optional[NDArray[Any]] = None,
) -> NDArray[Any]:
    """Detects the contacts of many pairs.

    Parameters
    ----------
    shapes : sequence of Shape
        One per body; several bodies may use one shape.
    poses : array_like, shape (bodies, 7)
        Position and quaternion of each body; used without a copy if contiguous.
    pairs : array_like of int, shape (pairs, 2)
        Indices of the bodies a and b of each pair; used without a copy if contiguous and int32.
    caches : numpy.ndarray, optional
        One cache per pair, from `pair_caches`; updated.
    parallel_angle, vertex_zone, margin, without_region
        As for `pair_detect`.
    out : numpy.ndarray, optional
        An array of `CONTACT` for the results, one per pair. Fields without a meaning are not written.

    Returns
    -------
    numpy.ndarray
        One contact per pair; the `type` of separated pairs is 0.
    """
    owners = tuple(shapes)  # a copy, as the sequence may change
    places = shaped(np.ascontiguousarray(poses, np.float64), "poses", (len(owners), 7))
    bodies = indices(pairs, "pairs")
    if bodies.ndim != 2 or bodies.shape[1] != 2:
        raise ValueError(f"pairs has the shape {bodies.shape}; it must be (n, 2)")
    contacts = np.zeros(len(bodies), CONTACT).view(Records) if out is None else out
    for array, dtype, name in ((caches, PAIR_CACHE, "caches"), (contacts, CONTACT, "out")):
        if array is not None and (
            array.dtype != dtype or array.shape != (len(bodies),) or not array.flags.carray
        ):
            raise ValueError(f"{name} must be a contiguous, writeable array of {len(bodies)} such structs")
    if len(owners) == 0:
        if len(bodies) > 0:
            raise ValueError("pairs must be empty if shapes is empty")
        return contacts
    options = _options(parallel_angle, vertex_zone, margin, without_region)
    with held(*owners):
        given = pointers_of(owners), places.ctypes.data, len(owners), bodies.ctypes.data, len(bodies), options
        memory = None if caches is None else caches.ctypes.data
        owners[0].context._call(library.hs_pairs_detect, *given, memory, contacts.ctypes.data, None)
    return contacts
