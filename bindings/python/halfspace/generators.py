"""Blocks of rock, masonry and piles: lists of shapes in place, for `World.add_blocks`."""
from __future__ import annotations

import math
from typing import Any, List, Mapping, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import floats, require_above_0
from .context import Context
from .scene import shapes_of
from .shape import Shape


def _rock(dimension: int, table: str, context: Optional[Context], keys: Mapping[str, Any]) -> List[Shape]:
    given = {key: value for key, value in keys.items() if value is not None}
    return shapes_of(
        {
            "dimension": dimension,
            "world": {"duration": 1.0},
            "default_law": {"stiffness": "per area", "normal_stiffness": 1e9, "friction_angle": 30},
            "material": [{"name": "rock", "density": 2500}],
            table: [{"name": "rock", "material": "rock", **given}],
        },
        context,
    )


def jointed_rock(
    region: ArrayLike,
    joint_sets: Sequence[Mapping[str, Any]],
    *,
    smallest: float = 0.0,
    context: Optional[Context] = None,
) -> List[Shape]:
    """Cuts a convex region by sets of parallel joints, as ``[[jointed_rock]]`` of a scene does.

    Parameters
    ----------
    region : array_like, shape (n, 2) or (n, 3)
        Corners of a convex polygon in order, or points of a convex hull, m.
    joint_sets : sequence of dict
        The keys of ``[[jointed_rock.joint_set]]``, angles in degrees: `dip`, `spacing`, in 3D `dip_direction`, and
        optionally `offset`, `jitter`, `seed`.
    smallest : float
        Smaller blocks are left out, m2 or m3.
    context : Context, optional
        The owner; the default context if there is none given.

    Examples
    --------
    >>> slabs = jointed_rock([(0, 0), (4, 0), (4, 2), (0, 2)], [dict(dip=90, spacing=1)])
    >>> len(slabs), slabs[0].volume
    (4, 2.0)
    """
    points = floats(region, "region")
    dimension = points.shape[-1] if points.ndim == 2 else 2
    keys = {"region": points, ("smallest_area" if dimension == 2 else "smallest_volume"): smallest}
    return _rock(dimension, "jointed_rock", context, {**keys, "joint_set": [dict(each) for each in joint_sets]})


def voronoi(
    region: ArrayLike, count: int, *, relaxation: int = 0, seed: int = 0, context: Optional[Context] = None
) -> List[Shape]:
    """Divides a convex region of space into Voronoi cells of random sites, as ``[[voronoi]]`` of a scene does.

    Parameters
    ----------
    region : array_like, shape (n, 3)
        Points whose convex hull is the region, m.
    count : int
        Number of blocks.
    relaxation : int
        Number of Lloyd's iterations, which make blocks rounder and more equal.
    seed : int
        Of the random sites.
    context : Context, optional
        The owner; the default context if there is none given.
    """
    keys = {"region": floats(region, "region"), "count": count, "relaxation": relaxation, "seed": seed}
    return _rock(3, "voronoi", context, keys)


def triangulated(
    lower_left: ArrayLike,
    upper_right: ArrayLike,
    count: int,
    *,
    jitter: Optional[float] = None,
    seed: int = 0,
    context: Optional[Context] = None,
) -> List[Shape]:
    """Cuts a rectangle into triangles of about equal size, as ``[[triangulated]]`` of a scene does.

    Parameters
    ----------
    lower_left, upper_right : array_like, shape (2,)
        Corners, m.
    count : int
        Number of triangles, even.
    jitter : float, optional
        Max random shift of a node, as a fraction of a cell, 0 to below 0.25; by default 0.2.
    seed : int
        Of the random shifts and diagonals.
    context : Context, optional
        The owner; the default context if there is none given.
    """
    corners = {"lower_left": floats(lower_left, "lower_left"), "upper_right": floats(upper_right, "upper_right")}
    return _rock(2, "triangulated", context, {**corners, "count": count, "jitter": jitter, "seed": seed})


def stack(
    size: Sequence[float], count: int, *, at: ArrayLike = (0, 0), context: Optional[Context] = None
) -> List[Shape]:
    """Stacks equal blocks on one another.

    Parameters
    ----------
    size : sequence of float
        Width and height, or width, depth and height of a block, m.
    count : int
        Number of blocks.
    at : array_like
        Middle of the underside of the first block, m.
    context : Context, optional
        The owner; the default context if there is none given.

    Examples
    --------
    >>> [block.centroid.tolist() for block in stack((1, 1), 2)]
    [[0.0, 0.5], [0.0, 1.5]]
    """
    require_above_0(size=size)
    if count < 0:
        raise ValueError(f"count is {count}; it must be at least 0")
    foot = np.zeros(len(size))
    foot[: np.size(at)] = at
    low = foot - 0.5 * np.asarray(size)
    low[-1] = foot[-1]
    up = np.eye(len(size))[-1] * size[-1]
    return [Shape._between(low + i * up, low + i * up + size, context) for i in range(count)]


def wall(
    length: float,
    courses: int,
    brick: Sequence[float],
    *,
    at: ArrayLike = (0, 0),
    context: Optional[Context] = None,
) -> List[Shape]:
    """Builds a wall in running bond: each course is shifted by half a brick, and its ends are cut.

    Parameters
    ----------
    length : float
        Along x, m.
    courses : int
        Number of courses.
    brick : sequence of float
        Length and height, or length, depth and height of a brick, m.
    at : array_like
        Lower corner at the smallest coordinates, m.
    context : Context, optional
        The owner; the default context if there is none given.

    Examples
    --------
    >>> len(wall(2, 2, (1, 0.5)))  # two bricks, then half, one and half
    5
    """
    require_above_0(length=length, brick=brick)
    corner = np.zeros(len(brick))
    corner[: np.size(at)] = at
    blocks = []
    for course in range(courses):
        shift = 0.5 * brick[0] * (course % 2)
        joints = np.arange(brick[0] - shift, length * (1 - 1e-9), brick[0])
        ends = [0.0, *joints.tolist(), length]
        for first, last in zip(ends[:-1], ends[1:]):
            low = corner.copy()
            low[0] += first
            low[-1] += course * brick[-1]
            blocks.append(Shape._between(low, low + [last - first, *brick[1:]], context))
    return blocks


def arch(
    radius: float,
    thickness: float,
    count: int,
    *,
    angle: float = math.pi,
    depth: Optional[float] = None,
    at: ArrayLike = (0, 0),
    context: Optional[Context] = None,
) -> List[Shape]:
    """Divides a circular arch into voussoirs, from its right springing to the left one.

    Parameters
    ----------
    radius : float
        Of the centre line, m.
    thickness : float
        Of the ring, m.
    count : int
        Number of voussoirs.
    angle : float
        Embraced by the arch, rad, at most 2 pi; by default a semicircle.
    depth : float, optional
        Of the voussoirs along y, for an arch in 3D, whose plane is x-z, m.
    at : array_like
        Centre of the circle, m.
    context : Context, optional
        The owner; the default context if there is none given.

    Examples
    --------
    >>> len(arch(10, 1.2, 27))
    27
    """
    require_above_0(radius=radius, thickness=thickness, count=count, angle=angle)
    if angle > 2 * math.pi:
        raise ValueError(f"angle is {angle}; it must be at most 2 pi, as it is in radians")
    if thickness >= 2 * radius:
        raise ValueError(f"thickness is {thickness}; it must be below twice the radius, {2 * radius:g}")
    centre = np.zeros(2 if depth is None else 3)
    centre[: np.size(at)] = at
    angles = 0.5 * math.pi + angle * (np.arange(count + 1) / count - 0.5)
    ray = np.column_stack((np.cos(angles), np.sin(angles)))
    inner, outer = (radius - 0.5 * thickness) * ray, (radius + 0.5 * thickness) * ray
    shapes = []
    for i in range(count):
        outline = np.array([inner[i], outer[i], outer[i + 1], inner[i + 1]])
        if depth is None:
            shapes.append(Shape.polygon(centre + outline, context=context))
            continue
        sides = [np.insert(outline, 1, y, axis=1) for y in (-0.5 * depth, 0.5 * depth)]
        shapes.append(Shape.hull(centre + np.concatenate(sides), context=context))
    return shapes
