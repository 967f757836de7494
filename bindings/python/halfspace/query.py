"""Queries without contact: closest points, rays into worlds, pairs of overlapping boxes, and an order of points."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import as_pose, floats, vector, view_of
from ._library import library
from .context import Context, default_context, held
from .records import ClosestPoints, RayHit
from .relax import Statics
from .shape import Shape


def pair_distance(shape_a: Shape, pose_a: ArrayLike, shape_b: Shape, pose_b: ArrayLike) -> Any:
    """Finds the closest points of two shapes, by GJK. Shapes with parallel faces may have many; one pair is returned.

    Parameters
    ----------
    shape_a, shape_b : Shape
        Of the same dimension; may be the same shape.
    pose_a, pose_b : array_like
        Their poses: a position, or 7 numbers as from `pose`.

    Returns
    -------
    numpy.record
        A record of `CLOSEST_POINTS`: `distance`, `point_a`, `point_b`, and the unit `normal` from a to b. The distance
        of shapes in contact is 0; the depth of an overlap is the gap of `pair_detect`.

    Examples
    --------
    >>> square = Shape.rectangle(1, 1)
    >>> closest = pair_distance(square, (0, 0), square, (4, 5))
    >>> print(closest.distance, closest.normal)
    5.0 [0.6 0.8 0. ]
    """
    place_a, place_b = as_pose(pose_a, "pose_a"), as_pose(pose_b, "pose_b")
    with held(shape_a, shape_b):
        return shape_a._record(ClosestPoints, library.hs_pair_distance, place_a, shape_b._alive, place_b)


def boxes_find_pairs(
    lower: ArrayLike, upper: ArrayLike, *, context: Optional[Context] = None
) -> NDArray[np.int32]:
    """Broad phase alone: finds all pairs of overlapping boxes, at any ratio of sizes, in time linear in boxes and
    pairs.

    Parameters
    ----------
    lower, upper : array_like, shape (n, 2) or (n, 3)
        Lower and upper corners of the boxes, m.
    context : Context, optional
        Allocates temporary memory; the default context if there is none given.

    Returns
    -------
    numpy.ndarray, shape (pairs, 2)
        Indices a < b of each pair, in an order that depends on the boxes only.

    Examples
    --------
    >>> boxes_find_pairs([(0, 0), (0.5, 0.5), (3, 0)], [(1, 1), (1.5, 1.5), (4, 1)])
    array([[0, 1]], dtype=int32)
    """
    corners = floats(lower, "lower")
    dimension = 3 if corners.ndim == 2 and corners.shape[1] == 3 else 2
    low, high = view_of(corners, dimension, "lower"), view_of(upper, dimension, "upper")
    owner, pairs = context or default_context(), np.empty((len(corners), 2), np.int32)
    while True:
        count = owner._value(library.hs_boxes_find_pairs, dimension, low, high, pairs.ctypes.data, len(pairs))
        if count <= len(pairs):
            return pairs[:count]
        pairs = np.empty((count, 2), np.int32)


def points_order_along_curve(points: ArrayLike, *, context: Optional[Context] = None) -> NDArray[np.int32]:
    """Orders points along a Hilbert curve through their box. Blocks that are added in this order have their neighbours
    close in memory, so that steps of large worlds take less time.

    Parameters
    ----------
    points : array_like, shape (n, 2) or (n, 3)
        E.g. the centroids of blocks, m.
    context : Context, optional
        Allocates temporary memory; the default context if there is none given.

    Returns
    -------
    numpy.ndarray, shape (n,)
        Indices of the points: the first is the first along the curve. Points in one place keep their order.

    Examples
    --------
    >>> points_order_along_curve([(0, 0), (1, 1), (1, 0), (0, 1)])
    array([0, 3, 1, 2], dtype=int32)
    """
    array = floats(points, "points")
    dimension = 3 if array.ndim == 2 and array.shape[1] == 3 else 2
    view = view_of(array, dimension, "points")
    order = np.empty(len(array), np.int32)
    (context or default_context())._call(library.hs_points_order_along_curve, dimension, view, order.ctypes.data)
    return order


class QueriedBlocks(Statics):
    """Queries of a world."""

    def cast_ray(self, origin: ArrayLike, direction: ArrayLike, max_distance: float = 1e75) -> Any:
        """Casts a ray into the world and returns the first block that it meets: fixed ones, parts of compounds, and
        cells at the surfaces of meshes, as they are deformed now.

        Parameters
        ----------
        origin, direction : array_like
            Start of the ray, m, and its direction, of any length except 0.
        max_distance : float
            Length of the ray, m.

        Returns
        -------
        numpy.record or None
            A record of `RAY_HIT`: `block`, `distance`, `point`, `normal` and `face`; None if it meets no block.
        """
        start, along = vector(origin, "origin"), vector(direction, "direction")
        hit = self._record(RayHit, library.hs_world_cast_ray, start, along, max_distance)
        return hit if hit.is_hit else None
