"""Bodies of finite elements."""
from __future__ import annotations

import ctypes
import functools
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import as_pose, block_id, counted, index, indices, mutable_view_of, pose, tensor, vector, view_of
from ._choice import choice
from ._definition import filled
from ._library import library
from ._record import Records
from .affine import AffineBlocks
from .block_arrays import Floats
from .constants import CellKind
from .context import Context, Handle, held, made
from .records import BodyState, CellState, MeshProperties

_KIND_OF_WIDTH = {
    (2, 3): CellKind.TRIANGLE,
    (2, 4): CellKind.QUAD,
    (3, 4): CellKind.TETRAHEDRON,
    (3, 6): CellKind.PRISM,
    (3, 8): CellKind.HEXAHEDRON,
}


class Mesh(Handle):
    """Nodes, and cells that share them. A mesh is immutable and may be added to any number of worlds.

    Parameters
    ----------
    nodes : array_like, shape (n, 2) or (n, 3)
        Positions of the nodes, m. The number of columns is the dimension.
    cells : sequence of array_like, shape (m, k)
        Node indices of the cells, numbered as in Gmsh and VTK, one array per kind. In 2D 3 columns are triangles and
        4 quads; in 3D 4 are tetrahedra, 6 prisms, 8 hexahedra. The order of cells is that of the arrays.
    context : Context, optional
        The owner; the default context if there is none given.

    Raises
    ------
    GeometryError
        A cell is inverted or flat anywhere, a node belongs to no cell, or a face belongs to more than two cells.

    Examples
    --------
    >>> mesh = Mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [[(0, 1, 2, 3)]])
    >>> mesh.volume, mesh.cell_count
    (1.0, 1)
    """

    def __init__(
        self, nodes: ArrayLike, cells: Sequence[ArrayLike], *, context: Optional[Context] = None
    ) -> None:
        places = np.asarray(nodes, np.float64)
        if places.ndim != 2 or places.shape[1] not in (2, 3):
            raise ValueError(f"nodes has the shape {places.shape}; it must be (n, 2) or (n, 3)")
        kinds, names = _kinds_and_nodes(cells, places.shape[1])
        given = places.shape[1], view_of(places, places.shape[1], "nodes")
        cells_given = kinds.ctypes.data, len(kinds), names.ctypes.data, len(names)
        own = functools.partial(super().__init__, destroy=library.hs_mesh_destroy)
        made(own, context, library.hs_mesh_create, *given, *cells_given)
        self._properties = self._record(MeshProperties, library.hs_mesh_get_properties)

    @classmethod
    def rectangle(
        cls,
        width: float,
        height: float,
        columns: int,
        rows: int,
        *,
        kind: Union[CellKind, str] = CellKind.QUAD,
        context: Optional[Context] = None,
    ) -> "Mesh":
        """Creates a rectangle, centered at the origin, of equal quads, or of triangles, two per quad, with
        alternating diagonals."""
        cell_kind = choice(kind, CellKind, "kind")
        x, y = np.meshgrid(np.linspace(-0.5, 0.5, columns + 1) * width, np.linspace(-0.5, 0.5, rows + 1) * height)
        nodes = np.column_stack([x.ravel(), y.ravel()])
        column, row = (grid.ravel() for grid in np.meshgrid(np.arange(columns), np.arange(rows)))
        first = row * (columns + 1) + column
        quads = np.column_stack([first, first + 1, first + columns + 2, first + columns + 1])
        if cell_kind == CellKind.QUAD:
            return cls(nodes, [quads], context=context)
        if cell_kind != CellKind.TRIANGLE:
            raise ValueError(f'kind is {kind!r}; it must be "quad" or "triangle"')
        alternate = ((column + row) % 2 == 1)[:, None]
        lower = np.where(alternate, quads[:, [0, 1, 3]], quads[:, [0, 1, 2]])
        upper = np.where(alternate, quads[:, [1, 2, 3]], quads[:, [0, 2, 3]])
        return cls(nodes, [np.stack([lower, upper], axis=1).reshape(-1, 3)], context=context)

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return int(self._properties.dimension)

    @property
    def node_count(self) -> int:
        """Nodes."""
        return int(self._properties.node_count)

    @property
    def cell_count(self) -> int:
        """Cells."""
        return int(self._properties.cell_count)

    @property
    def volume(self) -> float:
        """Volume of all cells, m3; in 2D their area, m2."""
        return float(self._properties.volume)


def _kinds_and_nodes(cells: Sequence[ArrayLike], dimension: int) -> Tuple[NDArray[np.int32], NDArray[np.int32]]:
    kinds, names = [], []
    for i, of_one_kind in enumerate(cells):
        array = indices(of_one_kind, f"cells[{i}]")
        width = array.shape[1] if array.ndim == 2 else 0
        if (dimension, width) not in _KIND_OF_WIDTH:
            raise ValueError(f"cells[{i}] has the shape {array.shape}; no kind of cell in {dimension}D has it")
        kinds.append(np.full(len(array), _KIND_OF_WIDTH[dimension, width], np.int32))
        names.append(array.ravel())
    nothing = np.zeros(0, np.int32)
    return np.concatenate([nothing, *kinds]), np.concatenate([nothing, *names])


class Bodies(AffineBlocks):
    """Bodies of a world. Arrays have the order of the nodes or cells of the mesh."""

    def add_mesh(
        self,
        mesh: Mesh,
        position: Optional[ArrayLike] = None,
        angle: Optional[float] = None,
        *,
        rotation: Optional[ArrayLike] = None,
        material: int = 0,
        cell_materials: Optional[ArrayLike] = None,
        velocity: ArrayLike = (0, 0, 0),
    ) -> int:
        """Adds a copy of a mesh to the world. Its surface cells become blocks of `BlockKind.MESH`.

        Parameters
        ----------
        mesh : Mesh
            Of the world's dimension.
        position : array_like, optional
            Position of the origin of its frame, m; by default 0.
        angle, rotation : optional
            Rotation about that origin, see `pose`.
        material : int
            Material of all cells, with an elasticity, see `set_elasticity`.
        cell_materials : array_like of int, optional
            One material per cell, instead of `material`.
        velocity : array_like
            Velocity of all nodes, m/s.

        Returns
        -------
        int
            Id of the body.
        """
        struct = filled(_raw.hs_body_def(), library.hs_body_def_init, material=index(material, "material"))
        struct.pose = as_pose(pose((0, 0) if position is None else position, angle, rotation=rotation), "pose")
        struct.velocity = vector(velocity, "velocity")
        materials = None if cell_materials is None else indices(cell_materials, "cell_materials")
        if materials is not None and materials.shape != (mesh.cell_count,):
            raise ValueError(f"cell_materials has the shape {materials.shape}; the mesh has {mesh.cell_count} cells")
        with held(self, mesh):
            given = mesh._alive, struct, None if materials is None else materials.ctypes.data
            return self._value(library.hs_world_add_mesh, *given)

    def remove_body(self, body: int) -> None:
        """Removes a body and its surface blocks from the world; its id becomes stale."""
        self._call(library.hs_world_remove_body, block_id(body, "body"))

    def body_state(self, body: int) -> BodyState:
        """Returns mass, centroid, momentum and energies of a body: a record of `BODY_STATE`."""
        return self._record(BodyState, library.hs_world_get_body_state, block_id(body, "body"))

    def body_of_block(self, block: int) -> Tuple[int, int]:
        """Returns the body and the index of the cell of a surface block; 0 and -1 for a block of another kind."""
        return self._whole_of(library.hs_world_get_body_of_block, block)

    def _whole_of(self, function: Any, block: int) -> Tuple[int, int]:
        """What a block is part of, and the index of the part."""
        whole, part = ctypes.c_uint64(), ctypes.c_int32()
        self._call(function, block_id(block, "block"), ctypes.byref(whole), ctypes.byref(part))
        return whole.value, part.value

    def _of_nodes(self, function: Any, body: int, name: str) -> Floats:
        with held(self):
            out = np.zeros((int(self.body_state(body).node_count), self.dimension))
            self._call(function, block_id(body, "body"), mutable_view_of(out, self.dimension, name), None)
        return out

    def node_positions(self, body: int) -> Floats:
        """Returns the positions of a body's nodes, m."""
        return self._of_nodes(library.hs_world_get_node_positions, body, "positions")

    def node_velocities(self, body: int) -> Floats:
        """Returns the velocities of a body's nodes, m/s."""
        return self._of_nodes(library.hs_world_get_node_velocities, body, "velocities")

    def node_forces(self, body: int) -> Floats:
        """Returns the total forces on a body's nodes at the end of the last step (cells, contacts, gravity, applied),
        N."""
        return self._of_nodes(library.hs_world_get_node_forces, body, "forces")

    def set_node_velocities(self, body: int, velocities: ArrayLike) -> None:
        """Sets the velocities of all nodes, m/s, shape (n, dimension), including held nodes."""
        view = view_of(velocities, self.dimension, "velocities")
        self._call(library.hs_world_set_node_velocities, block_id(body, "body"), view)

    def hold_nodes(
        self, body: int, nodes: ArrayLike, axes: str = "xyz", velocity: ArrayLike = (0, 0, 0)
    ) -> None:
        """Prescribes a constant velocity of nodes along axes, in addition to axes held before; or frees the nodes
        along all axes.

        Parameters
        ----------
        body : int
            From `add_mesh`.
        nodes : array_like of int
            Of the mesh.
        axes : str
            Some of "x", "y" and "z" (ignored in 2D); "" frees the nodes.
        velocity : array_like
            m/s; components along other axes are ignored.
        """
        given = block_id(body, "body"), *counted(nodes, "nodes")
        if set(axes) - set("xyz"):
            raise ValueError(f'axes is "{axes}"; it must consist of x, y and z')
        bits = sum(1 << "xyz".index(axis) for axis in set(axes) & set("xyz"[: self.dimension]))
        self._call(library.hs_world_hold_nodes, *given, bits, vector(velocity, "velocity"))
        body = int(body)
        self._given.held[body] = "".join(set(self._given.held.get(body, "")) | set(axes)) if axes else ""

    def set_node_force(self, body: int, nodes: ArrayLike, force: ArrayLike) -> None:
        """Sets the external force on each of these nodes, N, until set again."""
        given = block_id(body, "body"), *counted(nodes, "nodes")
        self._call(library.hs_world_set_node_force, *given, vector(force, "force"))

    def remove_cells(self, body: int, cells: ArrayLike) -> Floats:
        """Removes cells of a body (excavation). Indices of the other cells and nodes do not change.

        Returns
        -------
        array, shape (n, dimension)
            The force that these cells exerted on each node, N, to be applied by `set_node_force` and reduced gradually.
        """
        given = block_id(body, "body"), *counted(cells, "cells")
        with held(self):
            released = np.zeros((int(self.body_state(body).node_count), self.dimension))
            self._call(library.hs_world_remove_cells, *given, mutable_view_of(released, self.dimension, "released"))
        return released

    def set_body_stress(self, body: int, stress: ArrayLike, gradient: Optional[ArrayLike] = None) -> None:
        """Sets the current stress of the cells of a body, linear in space: each cell gets the stress at its center.

        Parameters
        ----------
        body : int
            From `add_mesh`.
        stress : array_like, shape (3, 3)
            Cauchy stress at the origin, Pa, tension > 0; in 2D also (2, 2).
        gradient : array_like, shape (3, 3, 3), optional
            Derivatives along x, y and z, Pa/m: ``gradient[k]`` along axis k; in 2D also (2, 2, 2).
        """
        at_origin = tensor(stress, "stress")
        slopes = None
        if gradient is not None:
            given = np.asarray(gradient, float)
            if given.ndim != 3 or given.shape[0] not in (2, 3):
                raise ValueError(f"gradient has the shape {given.shape}; it must be (3, 3, 3), in 2D also (2, 2, 2)")
            slopes = np.zeros((3, 3, 3))
            for axis, along in enumerate(given):
                slopes[axis] = np.reshape(tensor(along, f"gradient[{axis}]"), (3, 3))
        linear = None if slopes is None else slopes.ctypes.data
        self._call(library.hs_world_set_body_stress, block_id(body, "body"), at_origin, linear)

    def cells(self, body: int) -> Records:
        """Returns strain and stress of a body's cells: an array of `CELL_STATE`, whose ``["stress"]`` has the shape
        (m, 3, 3)."""
        return self._records(CellState, library.hs_world_get_cells, block_id(body, "body"))
