"""Motions and loads in time: tables that blocks and nodes follow, force control, and held axes."""
from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _raw
from ._arrays import block_id, counted, index, tensor, turns_view_of, vector, view_of
from ._choice import choice
from ._definition import filled
from ._library import library
from .constants import ActionKind, ForcePlace
from .definition import Definitions

_AXES = {"x": _raw.HS_AXIS_X, "y": _raw.HS_AXIS_Y, "z": _raw.HS_AXIS_Z, "r": _raw.HS_AXIS_ROTATION}


class ActedOn(Definitions):
    """Motions and loads in time of a world."""

    def add_table(self, times: ArrayLike, values: ArrayLike) -> int:
        """Adds a table for `act`. Between its rows values are linear, before and after them constant.

        Parameters
        ----------
        times : array_like
            s, in ascending order; two equal ones are a jump.
        values : array_like
            One row per time: 2 or 3 components, or one number for all components.

        Returns
        -------
        int
            Its index.
        """
        moments = np.ascontiguousarray(times, np.float64)
        rows = np.asarray(values, np.float64)
        if rows.ndim == 1:
            rows = np.repeat(rows[:, None], 3, axis=1)
        if moments.shape != (len(rows),):
            raise ValueError(f"times has the shape {moments.shape}; values has {len(rows)} rows")
        return self._value(library.hs_world_add_table, moments.ctypes.data, view_of(rows, 2, "values"))

    def act(
        self,
        block: Optional[int],
        kind: Union[ActionKind, str],
        table: int,
        *,
        scale: ArrayLike = 1.0,
        at: Optional[ArrayLike] = None,
        carried: bool = True,
        start: float = 0.0,
        max_speed: float = 0.0,
    ) -> None:
        """Gives the values of a table to a block. Loads add up; a motion ends the earlier ones along its axes.

        Parameters
        ----------
        block : int or None
            None: all blocks that move freely, only with "acceleration".
        kind : ActionKind or its name
            Motions are of a prescribed block, or along held axes; loads are on a rigid or affine block. "servo": the
            force on its contacts.
        table : int
            From `add_table`.
        scale : array_like
            Factor of all components, or of each. A motion does not change components of scale 0.
        at : array_like
            Place of a force, m; by default the centroid.
        carried : bool
            The place moves with the block.
        start : float
            Time of the world at time 0 of the table, s.
        max_speed : float
            Of a servo, m/s, > 0.
        """
        name = None if block is None else block_id(block, "block")
        definition = self._action(kind, table, start, scale, at, carried, max_speed)
        self._given.beyond_scenes.add("actions")
        self._call(library.hs_world_add_action, name or 0, definition)

    def end_actions(self, block: Optional[int]) -> None:
        """Ends all actions on a block, or with None those on all blocks. A prescribed block keeps its velocity."""
        self._call(library.hs_world_end_actions, 0 if block is None else block_id(block, "block"))

    def act_on_nodes(
        self,
        body: int,
        nodes: ArrayLike,
        kind: Union[ActionKind, str],
        table: int,
        *,
        scales: ArrayLike,
        start: float = 0.0,
    ) -> None:
        """Gives the values of a table to nodes of a body: forces, or velocities or accelerations along held axes.

        Parameters
        ----------
        scales : array_like
            Of shape (n, dimension): factors of each node, e.g. its share of the area of a traction.
        """
        names, count = counted(nodes, "nodes")
        factors = view_of(scales, self.dimension, "scales")
        if factors.count != count:
            raise ValueError(f"scales has {factors.count} rows; there are {count} nodes")
        definition = self._action(kind, table, start)
        self._call(library.hs_world_add_node_action, block_id(body, "body"), names, factors, definition)

    def end_node_actions(self, body: int) -> None:
        """Ends all actions on the nodes of a body."""
        self._call(library.hs_world_end_node_actions, block_id(body, "body"))

    def set_node_viscosity(self, body: int, nodes: ArrayLike, viscosity: ArrayLike) -> None:
        """Connects nodes with the ground by dashpots; on a face with its impedance, waves leave the body.

        Parameters
        ----------
        viscosity : array_like
            Of each node, of shape (dimension, dimension), symmetric, N s/m; 0 removes the dashpots.
        """
        given = block_id(body, "body"), *counted(nodes, "nodes")
        self._call(library.hs_world_set_node_viscosity, *given, tensor(viscosity, "viscosity"))

    def hold(self, block: int, axes: str) -> None:
        """Holds axes of a rigid block: its velocity along them stays, whatever the forces.

        Parameters
        ----------
        axes : str
            Some of "x", "y", "z" and "r": it does not rotate; "" frees the block.
        """
        if set(axes) - set(_AXES):
            raise ValueError(f'axes is "{axes}"; it must consist of x, y, z and r')
        bits = sum(_AXES[axis] for axis in set(axes))
        self._given.beyond_scenes.add("held blocks")
        self._call(library.hs_world_hold_block, block_id(block, "block"), bits)

    def prescribe_velocities(
        self, blocks: ArrayLike, velocities: ArrayLike, angular_velocities: Optional[ArrayLike] = None
    ) -> None:
        """Sets the velocities of prescribed blocks between steps, at little cost."""
        names = np.ascontiguousarray(blocks, np.uint64)
        motions = view_of(velocities, self.dimension, "velocities")
        if motions.count != len(names):
            raise ValueError(f"velocities has {motions.count} rows; there are {len(names)} blocks")
        turns: Any = _raw.hs_view()
        if angular_velocities is not None:
            turns = turns_view_of(angular_velocities, self.dimension, "angular_velocities")
        self._call(library.hs_world_prescribe_velocities, names.ctypes.data, motions, turns)

    def _action(
        self,
        kind: Union[ActionKind, str],
        table: int,
        start: float,
        scale: ArrayLike = 1.0,
        at: Optional[ArrayLike] = None,
        carried: bool = True,
        max_speed: float = 0.0,
    ) -> Any:
        struct = filled(_raw.hs_action_def(), library.hs_action_def_init, start=start, max_speed=max_speed)
        struct.kind, struct.table = choice(kind, ActionKind, "kind"), index(table, "table")
        factors = np.asarray(scale, np.float64)
        struct.scale[:] = [float(factors)] * 3 if factors.ndim == 0 else vector(factors, "scale")[:]
        if at is not None:
            struct.place = ForcePlace.CARRIED if carried else ForcePlace.FIXED
            struct.point[:] = vector(at, "at")[:]
        return struct
