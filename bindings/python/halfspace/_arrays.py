"""NumPy arrays as views for the library, without copies."""
from __future__ import annotations

import ctypes
import operator
import struct
from typing import Any, Optional, SupportsIndex, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raw

_DOUBLE = ctypes.sizeof(ctypes.c_double)
_packed_view = struct.Struct("PPPqq").pack  # hs_view: three addresses, stride, count


def floats(values: ArrayLike, name: str) -> NDArray[np.float64]:
    """An array of float64. Raises TypeError or ValueError, with the name, if the values are no numbers."""
    try:
        return np.asarray(values, np.float64)
    except (TypeError, ValueError) as error:
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{name}: {error}") from None


def struct_of(value: Any, kind: Any, name: str) -> Any:
    """The struct of a definition, such as a `Law`. Raises TypeError for anything else."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} is {value!r}; it must be a {kind.__name__}")
    return value._as_struct()


def shaped(array: NDArray[Any], name: str, *shapes: Tuple[int, ...]) -> NDArray[Any]:
    """An array of one of these shapes. Raises ValueError for another one."""
    if array.shape not in shapes:
        raise ValueError(f"{name} has the shape {array.shape}; it must be {' or '.join(map(str, shapes))}")
    return array


def require_above_0(**sizes: Any) -> None:
    """Refuses sizes that are not above 0 and finite, by their names."""
    for name, size in sizes.items():
        given = floats(size, name)
        if not (np.all(given > 0) and np.all(np.isfinite(given))):
            raise ValueError(f"{name} is {size}; it must be above 0 and finite")


def _as_points(points: ArrayLike, components: Tuple[int, ...], name: str) -> NDArray[np.float64]:
    array = floats(points, name)
    if array.ndim != 2 or array.shape[1] not in components:
        wanted = " or ".join(f"(n, {c})" for c in components)
        raise ValueError(f"{name} has the shape {array.shape}; it must be {wanted}")
    return array


def _fits(array: NDArray[np.float64]) -> bool:
    """Does the library accept the strides: a multiple of 8 bytes from point to point, and not 0?"""
    return array.flags.aligned and (
        len(array) < 2 or (array.strides[0] % _DOUBLE == 0 and array.strides[0] != 0)
    )


def _view(kind: Any, array: NDArray[np.float64]) -> Any:
    """The view struct of an array; it keeps the array alive. It is packed at once, as setting single fields takes ten
    times as long."""
    x, (step, component) = array.__array_interface__["data"][0], array.strides
    z = x + 2 * component if array.shape[1] == 3 else 0
    stride = step if len(array) > 1 else 3 * _DOUBLE
    view = kind.from_buffer_copy(_packed_view(x, x + component, z, stride, len(array)))
    view.array = array
    return view


def view_of(points: ArrayLike, dimension: int, name: str) -> Any:
    """A view of points to read, of shape (n, dimension), in 2D also (n, 3). Arrays of float64 are not copied, also if
    strided."""
    array = _as_points(points, (2, 3) if dimension == 2 else (3,), name)
    return _view(_raw.hs_view, array if _fits(array) else array.copy())


def require_output(array: Any, name: str) -> None:
    """Refuses an output array that is not a writeable array of float64."""
    if not isinstance(array, np.ndarray) or array.dtype != np.float64 or not array.flags.writeable:
        raise ValueError(f"{name} must be a writeable array of float64")


def mutable_view_of(array: NDArray[np.float64], dimension: int, name: str) -> Any:
    """A view of an array that the library writes in place."""
    require_output(array, name)
    if not _fits(array):
        raise ValueError(f"{name} must have strides that are multiples of 8 bytes and not 0")
    return _view(_raw.hs_mutable_view, _as_points(array, (2, 3) if dimension == 2 else (3,), name))


def turns_view_of(turns: ArrayLike, dimension: int, name: str) -> Any:
    """A view of angular velocities to read: in 2D one number per block, about z, in 3D shape (n, 3)."""
    array = floats(turns, name)
    if dimension == 3 or array.ndim != 1:
        return view_of(array, 3, name)
    if not _fits(array):
        array = array.copy()
    # x and y are ignored in 2D, so all three components may be the numbers about z.
    return _view(
        _raw.hs_view,
        np.lib.stride_tricks.as_strided(array, (len(array), 3), (array.strides[0], 0), writeable=False),
    )


def vector(values: ArrayLike, name: str) -> Any:
    """Three doubles for C; z = 0 is added to two numbers."""
    array = floats(values, name)
    if array.shape not in ((2,), (3,)):
        raise ValueError(f"{name} has the shape {array.shape}; it must have 2 or 3 numbers")
    return (ctypes.c_double * 3)(*array)


def gravity_vector(gravity: ArrayLike, dimension: int) -> Any:
    """Gravity for C. In the plane nothing can fall along z."""
    given = vector(gravity, "gravity")
    if dimension == 2 and given[2] != 0:
        raise ValueError(f"gravity is {tuple(given)}; its z must be 0 in 2D")
    return given


def tensor(values: ArrayLike, name: str) -> Any:
    """Nine doubles for C, row by row; 2 x 2 values are completed by 0."""
    array = shaped(floats(values, name), name, (2, 2), (3, 3))
    whole = np.zeros((3, 3))
    whole[: len(array), : len(array)] = array
    return (ctypes.c_double * 9)(*whole.ravel())


def turn_vector(values: ArrayLike, name: str) -> Any:
    """An angular velocity or torque; one number is about z."""
    array = floats(values, name)
    if array.shape not in ((), (3,)):
        raise ValueError(f"{name} has the shape {array.shape}; it must be one number, about z, or 3")
    return vector((0, 0, array.item()) if array.ndim == 0 else array, name)


def indices(values: ArrayLike, name: str) -> NDArray[np.int32]:
    """Contiguous 32-bit integers for C; a contiguous int32 array is not copied."""
    given = np.asarray(values)
    array = np.ascontiguousarray(given, np.int32)
    if array is not given and not np.array_equal(array, given):
        raise ValueError(f"{name} must be 32-bit integers")
    return array


def counted(values: ArrayLike, name: str) -> Tuple[Any, int]:
    """Indices, and their number, as functions of the library take them."""
    array = indices(values, name).ravel()
    return array.ctypes.data_as(ctypes.c_void_p), array.size


def index(value: SupportsIndex, name: str) -> int:
    """A 32-bit integer; ctypes would silently truncate larger ones."""
    number = operator.index(value)
    if not -(2**31) <= number < 2**31:
        raise ValueError(f"{name} is {number}; it must be a 32-bit integer")
    return number


def block_id(value: SupportsIndex, name: str) -> int:
    """An unsigned 64-bit id; ctypes would silently truncate larger ones."""
    number = operator.index(value)
    if not 0 <= number < 2**64:
        raise ValueError(f"{name} is {number}; it must be an unsigned 64-bit integer")
    return number


def pose(
    position: ArrayLike, angle: Optional[float] = None, *, rotation: Optional[ArrayLike] = None
) -> NDArray[np.float64]:
    """Pose of a shape.

    Parameters
    ----------
    position : array_like
        Position of the centroid, m: 2 or 3 numbers.
    angle : float, optional
        Rotation about z, rad.
    rotation : array_like, optional
        Unit quaternion x, y, z, w, instead of an angle.

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
    """A pose from 7 numbers, or from a position of 2 or 3 numbers."""
    array = floats(values, name)
    if array.shape in ((2,), (3,)):
        array = pose(array)
    if array.shape != (7,):
        raise ValueError(
            f"{name} has the shape {array.shape}; it must have 7 numbers, position and quaternion"
        )
    return _raw.hs_pose.from_buffer_copy(array.tobytes())
