"""Pictures of 2D worlds and contacts, by matplotlib, which is needed here only."""
import io
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from .constants import BlockKind
from .context import held

if TYPE_CHECKING:
    from .shape import Shape
    from .world import World

_FIXED, _FREE, _OUTLINE, _CONTACT = "#c9c6bf", "#9db8cf", "#2f3b45", "#b5442e"
_PICTURE_LIMIT = 20000  # blocks: a notebook shows no picture of more by itself


def _axes(ax: Any) -> Any:
    if ax is None:
        import matplotlib.pyplot

        ax = matplotlib.pyplot.gca()
    return ax


def plot_world(world: "World", ax: Any = None, *, contacts: bool = True) -> Any:
    """Draws the blocks of a 2D world where they are, fixed and prescribed ones in grey, and its contacts.

    Parameters
    ----------
    world : World
        Of dimension 2.
    ax : matplotlib.axes.Axes, optional
        Where to; by default the present axes.
    contacts : bool
        Also draw the contacts of the last detection, once their forces are evaluated: a line along each
        force, the thicker the larger the force.

    Returns
    -------
    matplotlib.axes.Axes
    """
    if world.dimension != 2:
        raise ValueError(
            "only worlds of dimension 2 are drawn; ParaView reads what the halfspace command writes of others"
        )
    ax = _axes(ax)
    from matplotlib.collections import LineCollection, PolyCollection

    with held(world):
        blocks = world.blocks
        outlines = [world.block_vertices(block) for block in blocks]
        free = (BlockKind.RIGID, BlockKind.AFFINE)
        colours = [_FREE if world.state(block).kind in free else _FIXED for block in blocks]
        touching = world.contacts()
    ax.add_collection(PolyCollection(outlines, facecolors=colours, edgecolors=_OUTLINE, linewidths=0.6))
    if contacts:
        size = np.linalg.norm(touching["force"], axis=1)
        touching, size = touching[size > 0], size[size > 0]
        if len(touching) > 0:
            middle, direction = touching["force_point"][:, :2], touching["force"][:, :2] / size[:, None]
            # As long as the smaller block is wide, so that the lines link up to chains of force.
            reach = dict(zip(blocks, (np.ptp(outline, axis=0).min() for outline in outlines)))
            half = (
                np.array([0.5 * min(reach[c["block_a"]], reach[c["block_b"]]) for c in touching])[:, None]
                * direction
            )
            lines = np.stack((middle - half, middle + half), axis=1)
            ax.add_collection(
                LineCollection(lines, colors=_CONTACT, linewidths=0.4 + 3.6 * size / size.max())
            )
    ax.set_aspect("equal")
    ax.autoscale_view()
    return ax


def plot_pair(
    shape_a: "Shape", pose_a: ArrayLike, shape_b: "Shape", pose_b: ArrayLike, contact: Any, ax: Any = None
) -> Any:
    """Draws two polygons and what `pair_detect` says of them: the points of the contact and its normal.

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


def _placed(shape: "Shape", pose: ArrayLike) -> Any:
    place = np.asarray(pose, np.float64)
    outline = shape.vertices - shape.centroid
    if place.size == 7:
        z, w = place[5], place[6]
        cosine, sine = w * w - z * z, 2 * z * w
        outline = outline @ np.array([[cosine, sine], [-sine, cosine]])
    return outline + place[:2]


def picture_of(world: "World") -> Optional[bytes]:
    """A PNG for notebooks; None without matplotlib, in 3D, and of a world that is closed, empty or too large
    to draw in passing."""
    if world.closed or world.dimension != 2 or not 0 < len(world) <= _PICTURE_LIMIT:
        return None
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        return None
    figure = Figure(figsize=(6, 4), layout="tight")
    FigureCanvasAgg(figure)
    plot_world(world, figure.add_subplot())
    stored = io.BytesIO()
    figure.savefig(stored, format="png", dpi=100, bbox_inches="tight")
    return stored.getvalue()
