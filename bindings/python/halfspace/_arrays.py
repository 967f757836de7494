"""NumPy arrays as the library's borrowed views, and its structs as NumPy data types."""
import ctypes
import operator
import struct
from typing import Any, Optional, SupportsIndex, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw

_DOUBLE = ctypes.sizeof(ctypes.c_double)
_packed_view = struct.Struct("PPPqq").pack  # hs_view: three addresses, stride, count


def record_type(structure: Any) -> Any:
    """The data type of a C struct, or of fields given one by one; its elements have the fields as attributes, too."""
    return np.dtype((np.record, np.dtype(structure)))


def _with_tensors(structure: Any) -> Any:
    """As `record_type`, with nine numbers in a row as three rows."""
    plain = np.dtype(structure)
    fields = [(name, plain[name].base, plain[name].shape) for name in plain.names]
    return record_type([(name, base, (3, 3) if shape == (9,) else shape) for name, base, shape in fields])


#: One contact or the proof that there is none: the struct ``hs_contact``.
CONTACT = record_type(_raw.hs_contact)
#: What a pair remembers between calls: the struct ``hs_pair_cache``; all zero is an empty one.
PAIR_CACHE = record_type(_raw.hs_pair_cache)
#: When, where and how two moving shapes first touch: the struct ``hs_impact``.
IMPACT = record_type(_raw.hs_impact)
#: A block's motion: the struct ``hs_block_state``.
BLOCK_STATE = record_type(_raw.hs_block_state)
#: How a block is turned and strained: the struct ``hs_deformation``, with tensors of shape (3, 3).
DEFORMATION = _with_tensors(_raw.hs_deformation)
#: What a mesh is: the struct ``hs_mesh_properties``.
MESH_PROPERTIES = record_type(_raw.hs_mesh_properties)
#: How a body of finite elements moves: the struct ``hs_body_state``.
BODY_STATE = record_type(_raw.hs_body_state)
#: How a cell is strained and stressed: the struct ``hs_cell_state``, with tensors of shape (3, 3).
CELL_STATE = _with_tensors(_raw.hs_cell_state)
#: A bond now: the struct ``hs_bond``.
BOND = record_type(_raw.hs_bond)
#: A point of a bond that has failed: the struct ``hs_bond_event``.
BOND_EVENT = record_type(_raw.hs_bond_event)
#: The bonds of a world in numbers: the struct ``hs_bond_report``.
BOND_REPORT = record_type(_raw.hs_bond_report)
#: How balanced a world is: the struct ``hs_balance``; its mean is ``["mean"]``, as records have a method of that name.
BALANCE = record_type(_raw.hs_balance)
#: What strength reduction found: the struct ``hs_strength_report``.
STRENGTH_REPORT = record_type(_raw.hs_strength_report)
#: A world in numbers: the struct ``hs_world_report``.
WORLD_REPORT = record_type(_raw.hs_world_report)
#: What a world computes and costs: the struct ``hs_world_plan``.
WORLD_PLAN = record_type(_raw.hs_world_plan)
#: Geometry and mass per unit density: the struct ``hs_shape_properties``.
SHAPE_PROPERTIES = record_type(_raw.hs_shape_properties)
#: What is wrong with vertices or faces: the struct ``hs_fault``.
FAULT = record_type(_raw.hs_fault)
#: What a clean-up changed: the struct ``hs_clean_report``.
CLEAN_REPORT = record_type(_raw.hs_clean_report)
#: What a fit of planes changed: the struct ``hs_fit_report``.
FIT_REPORT = record_type(_raw.hs_fit_report)


def empty_record(dtype: Any) -> Tuple[NDArray[Any], Any]:
    """An array of one zeroed struct, to be read by ``[0]``, and its address."""
    array = np.zeros(1, dtype)
    return array, array.ctypes.data


def empty_records(count: int, dtype: Any) -> Any:
    """An array of zeroed structs, which has their fields as attributes, too: `array.gap` is `array["gap"]`."""
    return np.zeros(count, dtype).view(np.recarray)


def _as_points(points: ArrayLike, components: Tuple[int, ...], name: str) -> NDArray[np.float64]:
    array = np.asarray(points, np.float64)
    if array.ndim != 2 or array.shape[1] not in components:
        wanted = " or ".join(f"(n, {c})" for c in components)
        raise ValueError(f"{name} has the shape {array.shape}; it must be {wanted}")
    return array


def _fits(array: NDArray[np.float64]) -> bool:
    """Can the library walk through it: whole doubles from point to point, and no two points in one place?"""
    return array.flags.aligned and (
        len(array) < 2 or (array.strides[0] % _DOUBLE == 0 and array.strides[0] != 0)
    )


def _view(kind: Any, array: NDArray[np.float64]) -> Any:
    """The struct for an array that it keeps alive. Packed at once: field by field would take ten times as
    long."""
    x, (step, component) = array.__array_interface__["data"][0], array.strides
    z = x + 2 * component if array.shape[1] == 3 else 0
    stride = step if len(array) > 1 else 3 * _DOUBLE
    view = kind.from_buffer_copy(_packed_view(x, x + component, z, stride, len(array)))
    view.array = array
    return view


def view_of(points: ArrayLike, dimension: int, name: str) -> Any:
    """Points to read, of shape (n, dimension), in 2D also (n, 3). An array of float64 is not copied, however
    it is strided."""
    array = _as_points(points, (2, 3) if dimension == 2 else (3,), name)
    return _view(_raw.hs_view, array if _fits(array) else array.copy())


def require_output(array: Any, name: str) -> None:
    """An array that results are written into is one of float64 that can be written."""
    if not isinstance(array, np.ndarray) or array.dtype != np.float64 or not array.flags.writeable:
        raise ValueError(f"{name} must be a writeable array of float64")


def mutable_view_of(array: NDArray[np.float64], dimension: int, name: str) -> Any:
    """An array that the library writes into, as it is."""
    require_output(array, name)
    if not _fits(array):
        raise ValueError(f"{name} must have a step of whole numbers of float64")
    return _view(_raw.hs_mutable_view, _as_points(array, (2, 3) if dimension == 2 else (3,), name))


def turns_view_of(turns: ArrayLike, dimension: int, name: str) -> Any:
    """Angular velocities to read: in 2D one number for each block, about z, else (n, 3)."""
    array = np.asarray(turns, np.float64)
    if dimension == 3 or array.ndim != 1:
        return view_of(array, 3, name)
    if not _fits(array):
        array = array.copy()
    # x and y are not looked at in 2D, so that all three may point to the numbers about z.
    return _view(
        _raw.hs_view,
        np.lib.stride_tricks.as_strided(array, (len(array), 3), (array.strides[0], 0), writeable=False),
    )


def vector(values: ArrayLike, name: str) -> Any:
    """Three doubles for C; two are completed by z = 0."""
    array = np.asarray(values, np.float64)
    if array.shape not in ((2,), (3,)):
        raise ValueError(f"{name} has the shape {array.shape}; it must have 2 or 3 numbers")
    return (ctypes.c_double * 3)(*array)


def tensor(values: ArrayLike, name: str) -> Any:
    """Nine doubles for C, row by row; of the plane 2 rows of 2 are completed by 0."""
    array = np.asarray(values, np.float64)
    if array.shape not in ((2, 2), (3, 3)):
        raise ValueError(f"{name} has the shape {array.shape}; it must be (2, 2) or (3, 3)")
    whole = np.zeros((3, 3))
    whole[: len(array), : len(array)] = array
    return (ctypes.c_double * 9)(*whole.flat)


def turn_vector(values: ArrayLike, name: str) -> Any:
    """Angular velocity or torque: one number is about z."""
    array = np.asarray(values, np.float64)
    if array.shape not in ((), (3,)):
        raise ValueError(f"{name} has the shape {array.shape}; it must be one number, about z, or 3")
    return vector((0, 0, array.item()) if array.ndim == 0 else array, name)


def indices(values: ArrayLike, name: str) -> NDArray[np.int32]:
    """Whole numbers in a row for C; an int32 array that is contiguous is not copied."""
    given = np.asarray(values)
    array = np.ascontiguousarray(given, np.int32)
    if array is not given and not np.array_equal(array, given):
        raise ValueError(f"{name} must be whole numbers of 32 bits")
    return array


def index(value: SupportsIndex, name: str) -> int:
    """One such number: ctypes would drop the bits that do not fit."""
    number = operator.index(value)
    if not -(2**31) <= number < 2**31:
        raise ValueError(f"{name} is {number}; it must be a whole number of 32 bits")
    return number


def block_id(value: SupportsIndex, name: str) -> int:
    """A block's id, for the same reason."""
    number = operator.index(value)
    if not 0 <= number < 2**64:
        raise ValueError(f"{name} is {number}; it must be a whole number of 64 bits without a sign")
    return number


def pose(
    position: ArrayLike, angle: Optional[float] = None, *, rotation: Optional[ArrayLike] = None
) -> NDArray[np.float64]:
    """Where a shape is.

    Parameters
    ----------
    position : array_like
        Where the shape's centroid is: 2 or 3 numbers.
    angle : float, optional
        Turn about z in radians.
    rotation : array_like, optional
        Instead of an angle: unit quaternion x, y, z, w.

    Returns
    -------
    numpy.ndarray
        Seven numbers: position and quaternion.

    Examples
    --------
    >>> pose((1, 2))
    array([1., 2., 0., 0., 0., 0., 1.])
    """
    if angle is not None and rotation is not None:
        raise ValueError("give an angle or a rotation, not both")
    result = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    result[: np.size(position)] = position if np.size(position) in (2, 3) else vector(position, "position")
    if angle is not None:
        result[5], result[6] = np.sin(0.5 * angle), np.cos(0.5 * angle)
    if rotation is not None:
        result[3:] = rotation
    return result


def as_pose(values: ArrayLike, name: str) -> _raw.hs_pose:
    """Seven numbers, or a position of two or three, as a pose."""
    array = np.asarray(values, np.float64)
    if array.shape in ((2,), (3,)):
        array = pose(array)
    if array.shape != (7,):
        raise ValueError(
            f"{name} has the shape {array.shape}; it must have 7 numbers, position and quaternion"
        )
    return _raw.hs_pose.from_buffer_copy(array.tobytes())
