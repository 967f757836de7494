"""Pictures of 3D worlds by matplotlib, an optional dependency."""
from __future__ import annotations

from typing import Any, List, Sequence

import numpy as np
from numpy.typing import NDArray

from .context import Context
from .plot import _CONTACT, _FIXED, _FREE, _OUTLINE, force_lines
from .shape import Shape

_LIGHT = np.array([0.4, -0.6, 0.7])  # from where it comes; to be of unit length, nearly
_SHADOW = 0.55  # brightness of faces that the light does not reach


def _faces_of(vertices: NDArray[np.float64], context: Context) -> List[NDArray[np.float64]]:
    with Shape.hull(vertices, context=context) as hull:
        corners = hull.vertices
        return [corners[face] for face in hull.faces]


def _shaded(face: NDArray[np.float64], colour: NDArray[np.float64]) -> NDArray[np.float64]:
    normal = np.cross(face[1] - face[0], face[2] - face[1])
    light = max(0.0, float(normal @ _LIGHT) / max(float(np.linalg.norm(normal)), 1e-300))
    shaded: NDArray[np.float64] = (_SHADOW + (1 - _SHADOW) * light) * colour
    return shaded


def plot_solids(
    blocks: NDArray[np.uint64],
    vertices: Sequence[NDArray[np.float64]],
    are_free: Sequence[bool],
    contacts: Any,
    ax: Any = None,
    *,
    context: Context,
) -> Any:
    """Draws 3D blocks, and contact forces as `halfspace.plot.plot_blocks` does, over all blocks. Fixed and prescribed
    blocks are grey, and drawn behind the others.

    Parameters
    ----------
    blocks : numpy.ndarray
        Ids of the blocks.
    vertices, are_free : sequence
        Vertices of each block, and whether it moves freely.
    contacts : numpy.ndarray
        From `World.contacts`.
    ax : mpl_toolkits.mplot3d.Axes3D, optional
        Axes to draw into; by default those of a new figure. ``ax.view_init(elev, azim)`` turns them.
    context : Context
        For the faces.
    """
    from matplotlib.colors import to_rgb
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    if ax is None:
        import matplotlib.pyplot

        ax = matplotlib.pyplot.figure().add_subplot(projection="3d")
    ax.computed_zorder = False
    for is_free in (False, True):
        colour = np.array(to_rgb(_FREE if is_free else _FIXED))
        faces = [face for i, each in enumerate(vertices) if are_free[i] == is_free for face in _faces_of(each, context)]
        if faces:
            colours = [_shaded(face, colour) for face in faces]
            ax.add_collection3d(
                Poly3DCollection(faces, facecolors=colours, edgecolors=_OUTLINE, linewidths=0.4, zorder=1 + is_free)
            )
    lines, widths = force_lines(blocks, vertices, contacts, 3)
    if len(lines) > 0:
        ax.add_collection3d(Line3DCollection(lines, colors=_CONTACT, linewidths=widths, zorder=3))
    if len(vertices) == 0:
        return ax
    corners = np.concatenate(vertices)
    low, high = corners.min(axis=0), corners.max(axis=0)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]), xlabel="x", ylabel="y", zlabel="z")
    sizes = np.maximum(high - low, 1e-300)
    ax.set_box_aspect(sizes)
    for axis, size in zip("xyz", sizes):  # the labels of a short axis would overlap
        ax.locator_params(axis=axis, nbins=max(1, round(6 * size / sizes.max())))
    return ax
