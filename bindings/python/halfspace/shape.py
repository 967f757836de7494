"""Convex polygons and polyhedra."""
from __future__ import annotations

import ctypes
from typing import Any, Callable, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw
from ._arrays import as_pose, floats, indices, mutable_view_of, require_above_0, vector, view_of
from ._library import library
from ._record import empty_record
from .context import Context, Handle, default_context, held, made
from .records import CleanReport, Fault, FitReport, RayHit, ShapeProperties


class Shape(Handle):
    """A convex polygon (2D) or polyhedron (3D), for any number of blocks; only `set_vertices` changes it.

    Created by `polygon`, `polyhedron`, `hull`, `from_halfspaces`, `boundary`, `rectangle` or `box`. Faulty input is
    refused (`GeometryError`), and repaired only within a given tolerance. Arrays of float64 are not copied, also if
    strided.

    Examples
    --------
    >>> square = Shape.polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> square.volume, square.centroid
    (1.0, array([0.5, 0.5]))
    """

    def __init__(self, context: Context, pointer: Any) -> None:
        super().__init__(context, pointer, library.hs_shape_destroy)
        self._properties: Optional[ShapeProperties] = None
        self._fit_report: Optional[FitReport] = None

    @classmethod
    def _make(
        cls, context: Optional[Context], create: Callable[..., int], *arguments: Any, behind: Tuple[Any, ...] = ()
    ) -> "Shape":
        return made(cls, context, create, *arguments, behind=behind)

    @classmethod
    def polygon(cls, vertices: ArrayLike, *, context: Optional[Context] = None) -> "Shape":
        """Creates a convex polygon.

        Parameters
        ----------
        vertices : array_like, shape (n, 2)
            Vertices, m, clockwise or counter-clockwise, 3 or more.
        context : Context, optional
            The owner; the default context if there is none given.

        Raises
        ------
        GeometryError
            The text names fault and vertex.
        """
        return cls._make(context, library.hs_polygon_create, view_of(vertices, 2, "vertices"))

    @classmethod
    def _fitted(
        cls,
        vertices: ArrayLike,
        faces: Sequence[Sequence[int]],
        tolerance: float,
        context: Optional[Context],
    ) -> "Shape":
        report, written = empty_record(FitReport)
        given = *_outline_of(vertices, faces), tolerance
        shape = cls._make(context, library.hs_polyhedron_create_fitted, *given, behind=(written,))
        shape._fit_report = report
        return shape

    @classmethod
    def polyhedron(
        cls,
        vertices: ArrayLike,
        faces: Sequence[Sequence[int]],
        *,
        tolerance: Optional[float] = None,
        context: Optional[Context] = None,
    ) -> "Shape":
        """Creates a convex polyhedron.

        Parameters
        ----------
        vertices : array_like, shape (n, 3)
            Its corners.
        faces : sequence of sequences of int
            Vertex indices of each face in outline order; all faces counter-clockwise seen from outside, or all
            clockwise. A face may have any number of vertices; neighbour faces must not be coplanar.
        tolerance : float, optional
            Distance, m, within which facets are plane and convex: facets within it of a common plane form one face
            with a fitted plane. `fit_report` has the changes. Without it faces must be plane and convex to rounding.
        """
        if tolerance is not None:
            return cls._fitted(vertices, faces, tolerance, context)
        return cls._make(context, library.hs_polyhedron_create, *_outline_of(vertices, faces))

    @classmethod
    def hull(
        cls, points: ArrayLike, *, tolerance: Optional[float] = None, context: Optional[Context] = None
    ) -> "Shape":
        """Creates the convex hull of points: a polygon from shape (n, 2), a polyhedron from (n, 3). Inner and
        repeated points are allowed. In 3D facets within the `tolerance` of a common plane are one face, see
        `polyhedron`."""
        array = floats(points, "points")
        if tolerance is not None:
            return cls._fitted(array, [], tolerance, context)
        if array.ndim == 2 and array.shape[1] == 3:
            return cls._make(context, library.hs_polyhedron_create_hull, view_of(array, 3, "points"))
        return cls._make(context, library.hs_polygon_create_hull, view_of(array, 2, "points"))

    @classmethod
    def from_halfspaces(
        cls, normals: ArrayLike, offsets: ArrayLike, *, context: Optional[Context] = None
    ) -> "Shape":
        """Creates the polyhedron of all points p with ``normals @ p <= offsets``.

        Parameters
        ----------
        normals : array_like, shape (n, 3)
            Outer normals, of any length except 0.
        offsets : array_like, shape (n,)
            One per normal.
        """
        view = view_of(normals, 3, "normals")
        limits = np.ascontiguousarray(offsets, np.float64)
        if limits.shape != (view.count,):
            raise ValueError(f"offsets has the shape {limits.shape}; there are {view.count} normals")
        return cls._make(context, library.hs_polyhedron_create_from_halfspaces, view, limits.ctypes.data)

    @classmethod
    def boundary(
        cls,
        first: ArrayLike,
        second: ArrayLike,
        depth: float,
        *,
        before: Optional[ArrayLike] = None,
        after: Optional[ArrayLike] = None,
        context: Optional[Context] = None,
    ) -> "Shape":
        """Creates a boundary segment for a fixed or prescribed block: a virtual polygon with the segment as one edge.

        Parameters
        ----------
        first, second : array_like, shape (2,)
            Ends of the segment, m. The inside is on the left of the direction from first to second: a floor runs
            towards -x, the walls of a container run clockwise.
        depth : float
            Depth of the polygon behind the segment, m: more than twice the max overlap.
        before, after : array_like, shape (2,), optional
            In a chain, the other ends of the neighbour segments. The flanks of the polygon lie under the neighbours,
            at 60 degrees, without gaps or protrusions.
        context : Context, optional
            The owner; the default context if there is none given.

        Examples
        --------
        >>> slope = [(20, 0), (0, 0), (-10, 5)]
        >>> floor = Shape.boundary(slope[0], slope[1], 1, after=slope[2])
        >>> hillside = Shape.boundary(slope[1], slope[2], 1, before=slope[0])
        """
        ends = vector(first, "first"), vector(second, "second")
        start = None if before is None else vector(before, "before")
        end = None if after is None else vector(after, "after")
        return cls._make(context, library.hs_polygon_create_boundary, start, *ends, end, depth)

    @classmethod
    def rectangle(cls, width: float, height: float, *, context: Optional[Context] = None) -> "Shape":
        """Creates a rectangle, centered at the origin."""
        require_above_0(width=width, height=height)
        return cls._between((-0.5 * width, -0.5 * height), (0.5 * width, 0.5 * height), context)

    @classmethod
    def box(cls, width: float, depth: float, height: float, *, context: Optional[Context] = None) -> "Shape":
        """Creates a cuboid, centered at the origin, with edges along x, y and z."""
        require_above_0(width=width, depth=depth, height=height)
        half = 0.5 * np.array([width, depth, height])
        return cls._between(-half, half, context)

    @classmethod
    def _between(cls, low: Any, high: Any, context: Optional[Context]) -> "Shape":
        """A rectangle or a cuboid of two opposite corners."""
        if len(low) == 2:
            (a, b), (c, d) = low, high
            return cls.polygon([(a, b), (c, b), (c, d), (a, d)], context=context)
        are_high = [(i, j, k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
        return cls.polyhedron(np.where(are_high, high, low), faces, context=context)

    def __repr__(self) -> str:
        if self.closed:
            return "<halfspace.Shape, closed>"
        kind = "polygon" if self.dimension == 2 else "polyhedron"
        return f"<halfspace.Shape: {kind} of {self.properties.vertex_count} vertices, volume {self.volume:g}>"

    @property
    def properties(self) -> ShapeProperties:
        """Geometry and mass properties per unit density: a record of the fields of ``hs_shape_properties``."""
        if self._properties is None:
            self._properties = self._record(ShapeProperties, library.hs_shape_get_properties)
        return self._properties

    @property
    def fit_report(self) -> Any:
        """For a shape made with a tolerance, a record of the fields of ``hs_fit_report``; else None."""
        return self._fit_report

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return int(self.properties.dimension)

    @property
    def volume(self) -> float:
        """Volume, m3; in 2D area times unit thickness."""
        return float(self.properties.volume)

    @property
    def centroid(self) -> NDArray[np.float64]:
        """Centroid, m, in the coordinates that the shape was made from; shape (dimension,)."""
        return np.array(self.properties.centroid[: self.dimension])

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Vertices, m, in the coordinates that the shape was made from, shape (n, dimension); in 2D
        counter-clockwise."""
        array = np.empty((self.properties.vertex_count, self.dimension))
        self._call(library.hs_shape_get_vertices, mutable_view_of(array, self.dimension, "vertices"), None)
        return array

    @property
    def faces(self) -> List[NDArray[np.int32]]:
        """Vertex indices of each face, counter-clockwise seen from outside; in 2D the two ends of each edge."""
        faces, corners = self.properties.face_count, 2 * self.properties.edge_count
        first, vertices = np.empty(faces + 1, np.int32), np.empty(corners, np.int32)
        arrays = first.ctypes.data, faces + 1, vertices.ctypes.data, corners
        self._call(library.hs_shape_get_faces, *arrays, None, None)
        return np.split(vertices, first[1:-1])

    @property
    def edges(self) -> NDArray[np.int32]:
        """Vertex indices of the ends of each edge, shape (n, 2). Contacts use the indices of these edges."""
        array = np.empty((self.properties.edge_count, 2), np.int32)
        self._call(library.hs_shape_get_edges, array.ctypes.data, len(array), None)
        return array

    @property
    def halfspaces(self) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Outer unit normals (n, dimension) and offsets (n,), relative to the centroid: p is inside if ``normals @ p
        <= offsets``."""
        count = self.properties.face_count
        normals, offsets = np.empty((count, self.dimension)), np.empty(count)
        view = mutable_view_of(normals, self.dimension, "normals")
        self._call(library.hs_shape_get_halfspaces, view, offsets.ctypes.data, None)
        return normals, offsets

    def set_vertices(self, vertices: ArrayLike) -> None:
        """Moves the vertices in place, for hosts whose bodies deform. Pair caches remain valid; worlds keep the copies
        that they have. After an error the shape has not changed.

        Parameters
        ----------
        vertices : array_like, shape (n, dimension)
            As many as `vertices` has, in that order, m; in 2D also in the reverse order. In 3D faces must stay plane
            to rounding, and convex.

        Examples
        --------
        >>> body = Shape.rectangle(1, 1)
        >>> body.set_vertices([(0, 0), (2, 0), (2, 1), (0, 1)])
        >>> body.volume, body.centroid
        (2.0, array([1. , 0.5]))
        """
        view = view_of(vertices, self.dimension, "vertices")
        with held(self):
            self._call(library.hs_shape_set_vertices, view)
            self._properties = None

    def cast_ray(
        self, pose: ArrayLike, origin: ArrayLike, direction: ArrayLike, max_distance: float = 1e75
    ) -> Any:
        """Casts a ray at the shape at a pose. A ray that touches the shape to rounding hits it.

        Parameters
        ----------
        pose : array_like
            A position, or 7 numbers as from `pose`.
        origin, direction : array_like
            Start of the ray, m, and its direction, of any length except 0.
        max_distance : float
            Length of the ray, m.

        Returns
        -------
        numpy.record or None
            A record of `RAY_HIT`: `distance`, `point`, `normal` and `face` where the ray enters; None if it does not.

        Examples
        --------
        >>> hit = Shape.rectangle(1, 1).cast_ray((3, 0), (0, 0.25), (1, 0))
        >>> print(hit.distance, hit.face)
        2.5 3
        """
        start, along = vector(origin, "origin"), vector(direction, "direction")
        hit = self._record(RayHit, library.hs_shape_cast_ray, as_pose(pose, "pose"), start, along, max_distance)
        return hit if hit.is_hit else None

    def cut(self, point: ArrayLike, normal: ArrayLike) -> Tuple[Optional["Shape"], Optional["Shape"]]:
        """Cuts the shape by a plane (2D: a line) into two shapes. The shape does not change.

        Parameters
        ----------
        point : array_like
            A point of the plane, m, in the coordinates that the shape was made from.
        normal : array_like
            Normal of the plane, of any length except 0.

        Returns
        -------
        behind, ahead : Shape or None
            The parts on the negative and positive side of the normal; None if a part is empty.
        """
        parts = ctypes.POINTER(_raw.hs_shape)(), ctypes.POINTER(_raw.hs_shape)()
        through, along = vector(point, "point"), vector(normal, "normal")
        with held(self):
            self._call(library.hs_shape_cut, through, along, *map(ctypes.byref, parts))
            behind, ahead = (Shape(self.context, part) if part else None for part in parts)
        return behind, ahead


def _outline_of(vertices: ArrayLike, faces: Sequence[Sequence[int]]) -> Tuple[Any, ...]:
    """Vertices and faces of a polyhedron, as functions of the library take them."""
    lists = [indices(face, f"faces[{i}]") for i, face in enumerate(faces)]
    sizes = (ctypes.c_int32 * len(lists))(*map(len, lists))
    corners = np.concatenate([np.empty(0, np.int32), *lists])
    return view_of(vertices, 3, "vertices"), sizes, len(sizes), corners.ctypes.data_as(ctypes.c_void_p)


def check_polygon(vertices: ArrayLike, *, context: Optional[Context] = None) -> Fault:
    """Validates the vertices of a polygon.

    Returns
    -------
    numpy.record
        `kind` (a `Fault`, 0 if there is none) and `vertex` (-1: the whole).
    """
    owner = context or default_context()
    return owner._record(Fault, library.hs_polygon_check, view_of(vertices, 2, "vertices"))


def check_polyhedron(
    vertices: ArrayLike, faces: Sequence[Sequence[int]], *, context: Optional[Context] = None
) -> Fault:
    """Validates the vertices and faces of a polyhedron, as `check_polygon`; the record also has the `face`."""
    owner = context or default_context()
    return owner._record(Fault, library.hs_polyhedron_check, *_outline_of(vertices, faces))


def clean_polygon(
    vertices: ArrayLike, tolerance: float = 0.0, *, context: Optional[Context] = None
) -> Tuple[NDArray[np.float64], Any]:
    """Removes repeated and collinear vertices, and reverses a clockwise order.

    Parameters
    ----------
    vertices : array_like, shape (n, 2)
        In outline order.
    tolerance : float
        Distance, m, >= 0; 0 removes exact repetitions and vertices collinear to rounding.

    Returns
    -------
    vertices : numpy.ndarray, shape (m, 2)
        The remaining vertices; no vertex is moved.
    report : numpy.record
        `welded`, `straightened` and `reversed`.
    """
    view = view_of(vertices, 2, "vertices")
    cleaned, count = np.empty((view.count, 2)), ctypes.c_int64()
    given = view, tolerance, mutable_view_of(cleaned, 2, "cleaned"), ctypes.byref(count)
    report = (context or default_context())._record(CleanReport, library.hs_polygon_clean, *given)
    return cleaned[: count.value], report
