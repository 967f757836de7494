"""What a failed call raises. Every text is the library's own: it names the function, the argument and its
value."""
from typing import Any, Dict, Tuple, Type

from . import _raw


class HalfspaceError(Exception):
    """A call of the library failed; nothing was changed.

    Attributes
    ----------
    status : int
        The library's status code, below 0; ``halfspace.status_text(status)`` describes it.
    message : str
        What was wrong: function, argument and value.
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
    """Vertices, faces or half-spaces do not describe a convex shape."""


class StaleIdError(HalfspaceError, LookupError):
    """An id does not name a living block, material or contact."""


class OutOfMemoryError(HalfspaceError, MemoryError):
    """There is no memory left."""


class StateError(HalfspaceError, RuntimeError):
    """The world or the block is not in a state that allows this call."""


class UnstableError(HalfspaceError, ArithmeticError):
    """The time step is too large. The world stays at the last good step."""


class TooFastError(HalfspaceError, ArithmeticError):
    """Two blocks meet too fast for the time step against their thickness, and the world was made to refuse that. It
    stays at the last good step."""


class InvertedError(HalfspaceError, ArithmeticError):
    """A cell of a mesh would be turned inside out. The world stays at the last good step."""


class FormatError(HalfspaceError, ValueError):
    """The bytes are not a snapshot that this library can read."""


class InternalError(HalfspaceError, RuntimeError):
    """A defect of the library: please report it."""


class ClosedError(StateError):
    """A shape, world or context is used after its end."""

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
    _raw.HS_ERROR_FORMAT: FormatError,
    _raw.HS_ERROR_INTERNAL: InternalError,
}


def error_of(status: int, message: str) -> HalfspaceError:
    """The exception for a status below 0."""
    return _ERROR_OF_STATUS.get(status, HalfspaceError)(status, message)
