"""Detection for hosts that keep their own bodies: one pair, or many."""
import ctypes
from typing import Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import CONTACT, PAIR_CACHE, as_pose, empty_record, empty_records, indices
from ._library import library
from .context import held
from .shape import Shape


class PairCache:
    """What a pair remembers between calls: makes the next answer faster and, in contact, keeps the plane
    through which the pair met.

    Give each pair one of its own. Copy it with ``PairCache(other)``.
    """

    def __init__(self, other: Optional["PairCache"] = None) -> None:
        self._struct: _raw.hs_pair_cache = (
            _raw.hs_pair_cache.from_buffer_copy(other._struct) if other else _raw.hs_pair_cache()
        )

    def __repr__(self) -> str:
        return f"<halfspace.PairCache: {('unknown', 'separated', 'in contact')[self._struct.state]}>"

    def clear(self) -> None:
        """Forgets everything."""
        self._struct = _raw.hs_pair_cache()


def _options(
    parallel_angle: Optional[float], vertex_zone: Optional[float], margin: float, without_region: bool
) -> Any:
    if parallel_angle is None and vertex_zone is None and margin == 0 and not without_region:
        return None
    options = _raw.hs_pair_options()
    library.hs_pair_options_init(ctypes.byref(options), ctypes.sizeof(options))
    if parallel_angle is not None:
        options.parallel_angle = parallel_angle
    if vertex_zone is not None:
        options.vertex_zone = vertex_zone
    options.margin = margin
    options.without_region = without_region
    return ctypes.byref(options)


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
) -> Any:
    """Are two shapes in contact, and how?

    Parameters
    ----------
    shape_a, shape_b : Shape
        Both of one dimension; the same one twice is legal.
    pose_a, pose_b : array_like
        Where their centroids are and how they are turned: a position, or 7 numbers as from `pose`.
    cache : PairCache, optional
        The pair's memory from the last call.
    parallel_angle : float, optional
        Edges (3D: faces, or an edge and a face) closer to parallel than this share a region; rad, [0, 0.5],
        0.01 by default.
    vertex_zone : float, optional
        How near the end of an edge a vertex meets the end: share of the shorter edge, [0, 0.5], 1e-6 by
        default.
    margin : float
        Polygons are apart only when their gap exceeds it; for hosts whose blocks wear a skin. m, [0, 1e75],
        in space 0.
    without_region : bool
        A contact between polygons is the pair of largest gap and no more, for hosts that make their own
        points; in space False.

    Returns
    -------
    numpy.record
        The fields of ``hs_contact`` (`CONTACT`): `type`, `normal` from a to b, `gap` (< 0 is overlap),
        `points` and more. A `type` of 0 says that the shapes are apart; the `gap` is then a lower bound of
        the distance.

    Examples
    --------
    >>> square = Shape.rectangle(1, 1)
    >>> contact = pair_detect(square, (0, 0), square, (0.25, 0.875))
    >>> print(contact.gap, contact.area)
    -0.125 0.75
    """
    array, address = empty_record(CONTACT)
    place_a, place_b = as_pose(pose_a, "pose_a"), as_pose(pose_b, "pose_b")
    options = _options(parallel_angle, vertex_zone, margin, without_region)
    with held(shape_a, shape_b):
        shape_a._call(
            library.hs_pair_detect,
            place_a,
            shape_b._alive,
            place_b,
            options,
            None if cache is None else cache._struct,
            _raw.hs_contact.from_address(address),
        )
    return array[0]


def pair_caches(count: int) -> NDArray[Any]:
    """Empty memories for `pairs_detect`, one for each pair."""
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
    """Detects many pairs in one call.

    Parameters
    ----------
    shapes : sequence of Shape
        That of each body.
    poses : array_like, shape (bodies, 7)
        Position and quaternion of each body; used without a copy if contiguous.
    pairs : array_like of int, shape (pairs, 2)
        The bodies a and b of each pair; used without a copy if contiguous and int32.
    caches : numpy.ndarray, optional
        One memory for each pair, from `pair_caches`; brought up to date.
    parallel_angle, vertex_zone, margin, without_region
        As for `pair_detect`.
    out : numpy.ndarray, optional
        An array of `CONTACT` to write into, one for each pair. Fields without a meaning are left as they are.

    Returns
    -------
    numpy.ndarray
        One contact for each pair, separated ones with `type` 0.
    """
    owners = tuple(shapes)  # the same ones throughout, whatever the sequence does
    places = np.ascontiguousarray(poses, np.float64)
    if places.shape != (len(owners), 7):
        raise ValueError(f"poses has the shape {places.shape}; it must be ({len(owners)}, 7)")
    bodies = indices(pairs, "pairs")
    if bodies.ndim != 2 or bodies.shape[1] != 2:
        raise ValueError(f"pairs has the shape {bodies.shape}; it must be (n, 2)")
    contacts = empty_records(len(bodies), CONTACT) if out is None else out
    for array, dtype, name in ((caches, PAIR_CACHE, "caches"), (contacts, CONTACT, "out")):
        if array is not None and (
            array.dtype != dtype or array.shape != (len(bodies),) or not array.flags.carray
        ):
            raise ValueError(f"{name} must be a contiguous, writeable array of {len(bodies)} such structs")
    if len(owners) == 0:
        if len(bodies) > 0:
            raise ValueError("pairs: there are no bodies")
        return contacts
    options = _options(parallel_angle, vertex_zone, margin, without_region)
    with held(*owners):
        handles = (ctypes.c_void_p * len(owners))(
            *(ctypes.cast(shape._alive, ctypes.c_void_p).value for shape in owners)
        )
        keeper = owners[0]._keeper
        keeper.call(
            library.hs_pairs_detect,
            keeper.pointer,
            handles,
            places.ctypes.data,
            len(owners),
            bodies.ctypes.data,
            len(bodies),
            options,
            None if caches is None else caches.ctypes.data,
            contacts.ctypes.data,
            None,
        )
    return contacts
