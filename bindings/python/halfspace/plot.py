"""Pictures of 2D worlds and contacts by matplotlib, an optional dependency."""
from __future__ import annotations

import io
from typing import Any, Callable, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .shape import Shape

_FIXED, _FREE, _OUTLINE, _CONTACT = "#c9c6bf", "#9db8cf", "#2f3b45", "#b5442e"


def _axes(ax: Any) -> Any:
    if ax is None:
        import matplotlib.pyplot

        ax = matplotlib.pyplot.gca()
    return ax


def force_lines(
    blocks: NDArray[np.uint64], vertices: Sequence[NDArray[np.float64]], contacts: Any, dimension: int
) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A line along each contact force, shape (n, 2, dimension), and its width, proportional to the magnitude."""
    size = np.linalg.norm(contacts["force"], axis=1)
    contacts, size = contacts[size > 0], size[size > 0]
    if len(contacts) == 0:
        return np.empty((0, 2, dimension)), size
    middle, direction = contacts["force_point"][:, :dimension], contacts["force"][:, :dimension] / size[:, None]
    # As long as the width of the smaller block, so that the lines form force chains.
    reach = dict(zip(blocks, (np.ptp(each, axis=0).min() for each in vertices)))
    half = np.array([0.5 * min(reach[c["block_a"]], reach[c["block_b"]]) for c in contacts])[:, None] * direction
    return np.stack((middle - half, middle + half), axis=1), 0.4 + 3.6 * size / size.max()


def plot_blocks(
    blocks: NDArray[np.uint64],
    outlines: Sequence[NDArray[np.float64]],
    are_free: Sequence[bool],
    contacts: Any,
    ax: Any = None,
) -> Any:
    """Draws 2D blocks, with fixed and prescribed blocks in grey, and contact forces: a line along each force, with a
    width proportional to its magnitude.

    Parameters
    ----------
    blocks : numpy.ndarray
        Ids of the blocks.
    outlines, are_free : sequence
        Vertices of each block, and whether it moves freely.
    contacts : numpy.ndarray
        From `World.contacts`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw into; by default the current axes.

    Returns
    -------
    matplotlib.axes.Axes
    """
    ax = _axes(ax)
    from matplotlib.collections import LineCollection, PolyCollection

    colours = [_FREE if is_free else _FIXED for is_free in are_free]
    ax.add_collection(PolyCollection(outlines, facecolors=colours, edgecolors=_OUTLINE, linewidths=0.6))
    lines, widths = force_lines(blocks, outlines, contacts, 2)
    if len(lines) > 0:
        ax.add_collection(LineCollection(lines, colors=_CONTACT, linewidths=widths))
    ax.set_aspect("equal")
    ax.autoscale_view()
    return ax


def plot_pair(
    shape_a: Shape, pose_a: ArrayLike, shape_b: Shape, pose_b: ArrayLike, contact: Any, ax: Any = None
) -> Any:
    """Draws two polygons and their contact from `pair_detect`: its points and normal.

    Returns
    -------
    matplotlib.axes.Axes
    """
    ax = _axes(ax)
    from matplotlib.collections import PolyCollection

    outlines = [_placed(shape_a, pose_a), _placed(shape_b, pose_b)]
    colours = (_FIXED, _FREE)
    ax.add_collection(
        PolyCollection(outlines, facecolors=colours, edgecolors=_OUTLINE, linewidths=0.8, alpha=0.8)
    )
    if contact.point_count > 0:
        points = contact.points[: contact.point_count, :2]
        length = 0.25 * min(np.ptp(outline, axis=0).max() for outline in outlines)
        ax.plot(*points.T, "o-", color=_CONTACT, markersize=4)
        ax.annotate(
            "",
            contact.center[:2] + length * contact.normal[:2],
            contact.center[:2],
            arrowprops=dict(arrowstyle="->", color=_CONTACT),
        )
    ax.set_aspect("equal")
    ax.autoscale_view()
    return ax


def _placed(shape: Shape, pose: ArrayLike) -> Any:
    place = np.asarray(pose, np.float64)
    outline = shape.vertices - shape.centroid
    if place.size == 7:
        z, w = place[5], place[6]
        cosine, sine = w * w - z * z, 2 * z * w
        outline = outline @ np.array([[cosine, sine], [-sine, cosine]])
    return outline + place[:2]


def picture_by(plot: Callable[[Any], Any], dimension: int = 2) -> Optional[bytes]:
    """A PNG of the axes drawn by `plot`, for notebooks; None without matplotlib."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        return None
    figure = Figure(figsize=(6, 4), layout="tight")
    FigureCanvasAgg(figure)
    plot(figure.add_subplot() if dimension == 2 else figure.add_subplot(projection="3d"))
    stored = io.BytesIO()
    figure.savefig(stored, format="png", dpi=100, bbox_inches="tight")
    return stored.getvalue()
