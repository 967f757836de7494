"""Exceptions of failed calls. The text is that of the library: function, argument and value."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple, Type

from . import _raw


class HalfspaceError(Exception):
    """A call of the library failed. It has changed nothing.

    Attributes
    ----------
    status : int
        Status code of the library, below 0; see ``halfspace.status_text(status)``.
    message : str
        Function, argument and value.
    """

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status
        self.message = message

    def __reduce__(self) -> Tuple[Any, ...]:  # pickle
        return type(self), (self.status, self.message)


class ArgumentError(HalfspaceError, ValueError):
    """An argument is out of range or not finite."""


class GeometryError(HalfspaceError, ValueError):
    """The vertices, faces or half-spaces do not describe a convex shape."""


class StaleIdError(HalfspaceError, LookupError):
    """No living block, body, material or contact has the given id."""


class OutOfMemoryError(HalfspaceError, MemoryError):
    """Out of memory."""


class StateError(HalfspaceError, RuntimeError):
    """The world or the block is not in a state that allows this call."""


class UnstableError(HalfspaceError, ArithmeticError):
    """The time step is too large. The world keeps the last valid state."""


class TooFastError(HalfspaceError, ArithmeticError):
    """Two blocks approach too fast for the time step and their thickness. The world keeps the last valid state."""


class InvertedError(HalfspaceError, ArithmeticError):
    """A mesh cell would be inverted. The world keeps the last valid state."""


class InterruptedCallError(HalfspaceError):
    """The host has interrupted a step that was divided into many parts. The next call completes the step."""


class FormatError(HalfspaceError, ValueError):
    """The bytes are not a snapshot that this library can read."""


class SceneError(FormatError):
    """A scene has faults; `message` has a line for each, with file, line, column and key."""

    @property
    def faults(self) -> List[str]:
        """The faults, a line each."""
        return self.message.splitlines()


class InternalError(HalfspaceError, RuntimeError):
    """Internal error of the library; please report it."""


class ClosedError(StateError):
    """A shape, mesh, world or context is used after close()."""

    def __init__(self, message: str) -> None:
        super().__init__(_raw.HS_ERROR_STATE, message)

    def __reduce__(self) -> Tuple[Any, ...]:  # pickle
        return type(self), (self.message,)


_ERROR_OF_STATUS: Dict[int, Type[HalfspaceError]] = {
    _raw.HS_ERROR_ARGUMENT: ArgumentError,
    _raw.HS_ERROR_GEOMETRY: GeometryError,
    _raw.HS_ERROR_STALE_ID: StaleIdError,
    _raw.HS_ERROR_OUT_OF_MEMORY: OutOfMemoryError,
    _raw.HS_ERROR_STATE: StateError,
    _raw.HS_ERROR_UNSTABLE: UnstableError,
    _raw.HS_ERROR_TOO_FAST: TooFastError,
    _raw.HS_ERROR_INVERTED: InvertedError,
    _raw.HS_ERROR_INTERRUPTED: InterruptedCallError,
    _raw.HS_ERROR_FORMAT: FormatError,
    _raw.HS_ERROR_INTERNAL: InternalError,
}


def error_of(status: int, message: str) -> HalfspaceError:
    """The exception for a status below 0."""
    return _ERROR_OF_STATUS.get(status, HalfspaceError)(status, message)
