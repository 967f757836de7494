"""Water below a table."""
from __future__ import annotations

from typing import Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import mutable_view_of, view_of
from ._definition import filled
from ._library import library
from .bolt import BoltedBlocks
from .context import held


class WetBlocks(BoltedBlocks):
    """Water of a world."""

    def set_water(self, table: ArrayLike, density: float = 1000.0, factor: float = 1.0) -> None:
        """Sets the water, in place of the water before. The change of energy counts as external work.

        Parameters
        ----------
        table : array or float
            In 2D the corners of a polyline, shape (n, 2), in ascending order of x; it continues level beyond its ends.
            In 3D three points of a plane, shape (3, 3), or a height map: points above a rectangular grid, shape
            (rows, columns, 3), in ascending order of y, in each row of x, which goes on level beyond its border. One
            number is a level. Without points there is no water.
        density : float
            kg/m3.
        factor : float
            Multiplies the pressure.
        """
        struct = filled(_raw.hs_water_def(), library.hs_water_def_init, density=density, factor=factor)
        corners = np.asarray(table, np.float64)
        if corners.ndim == 0:
            corners = np.array([[0.0] * (self.dimension - 1) + [corners.item()]])
        if corners.size == 0:
            corners = np.empty((0, self.dimension))
        self._given.beyond_scenes.add("water")
        if corners.ndim == 3:
            struct.columns = corners.shape[1]
            corners = corners.reshape(-1, corners.shape[2])
        self._call(library.hs_world_set_water, struct, view_of(corners, self.dimension, "table"))

    def water_loads(self) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns the current loads of water on all blocks: forces, and torques about the centroids, each of shape
        (n, 3)."""
        with held(self):
            forces, torques = np.zeros((2, len(self), 3))
            views = [mutable_view_of(array, 3, "loads") for array in (forces, torques)]
            self._call(library.hs_world_get_water_loads, *views)
        return forces, torques
