"""The context, and how handles live and end."""
import ctypes
import threading
import weakref
from typing import Any, Callable, List, Optional, Tuple, TypeVar

from . import _raw
from ._library import library
from .errors import ClosedError, error_of


_Abandoned = List[Tuple[Callable[[Any], None], Any]]


def _end_all(abandoned: _Abandoned) -> None:
    while abandoned:
        destroy, pointer = abandoned.pop()
        destroy(pointer)


def _destroy_context(pointer: Any, abandoned: _Abandoned) -> None:
    _end_all(abandoned)
    library.hs_context_destroy(pointer)


class _Keeper:
    """The C context with its lock. It outlives everything made from it, as the C library asks, because each
    of these holds it.

    The library may be in one call at a time per context, and ctypes lets other Python threads run during a
    call: hence the lock. A handle that the garbage collector drops while another thread is in a call is set
    aside and ended by the next call.
    """

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self.pointer = ctypes.POINTER(_raw.hs_context)()
        self._abandoned: _Abandoned = []
        status = library.hs_context_create(None, ctypes.byref(self.pointer))
        if status < 0:
            raise error_of(status, library.hs_context_last_error(None).decode())
        weakref.finalize(self, _destroy_context, self.pointer, self._abandoned)

    def call(self, function: Callable[..., int], *arguments: Any) -> int:
        """Calls a fallible function; raises when it fails."""
        with self.lock:
            _end_all(self._abandoned)
            status = function(*arguments)
            if status < 0:
                raise error_of(status, library.hs_context_last_error(self.pointer).decode())
        return status

    def end(self, destroy: Callable[[Any], None], pointer: Any) -> None:
        if self.lock.acquire(blocking=False):
            try:
                destroy(pointer)
            finally:
                self.lock.release()
        else:
            self._abandoned.append((destroy, pointer))


class Context:
    """Owner of shapes and worlds. Simple scripts need none: without one, the default context is used.

    A context lets one thread at a time into the library; others wait. Worlds of different contexts run side
    by side, each in a thread of its own: the interpreter's lock is released during calls.

    Examples
    --------
    >>> import halfspace as hs
    >>> with hs.Context() as context:
    ...     square = hs.Shape.rectangle(1, 1, context=context)
    >>> square.closed
    True
    """

    def __init__(self) -> None:
        self._keeper: Optional[_Keeper] = _Keeper()
        self._handles: "weakref.WeakSet[Handle]" = weakref.WeakSet()

    def __enter__(self) -> "Context":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return (
            "<halfspace.Context, closed>"
            if self.closed
            else f"<halfspace.Context of {len(self._handles)} objects>"
        )

    @property
    def closed(self) -> bool:
        """Has it been closed?"""
        return self._keeper is None

    def close(self) -> None:
        """Ends everything made from this context, and the context. A second call does nothing."""
        for handle in list(self._handles):
            handle.close()
        self._keeper = None

    @property
    def _alive(self) -> _Keeper:
        if self._keeper is None:
            raise ClosedError("the context is closed")
        return self._keeper


_default: Optional[Context] = None


def default_context() -> Context:
    """The context that is used where none is given; made when first needed."""
    global _default
    if _default is None or _default.closed:
        _default = Context()
    return _default


_AnyHandle = TypeVar("_AnyHandle", bound="Handle")


class Handle:
    """Something of the library's that ends with `close()`, with a `with` block, or when it is no longer
    used."""

    def __init__(self, context: Context, pointer: Any, destroy: Callable[[Any], None]) -> None:
        self._keeper = context._alive
        self._context = context
        self._pointer = pointer
        self._finalizer = weakref.finalize(self, self._keeper.end, destroy, pointer)
        context._handles.add(self)

    def __enter__(self: _AnyHandle) -> _AnyHandle:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def closed(self) -> bool:
        """Has it been closed?"""
        return not self._finalizer.alive

    def close(self) -> None:
        """Ends it. A second call does nothing; any other use raises `ClosedError`."""
        self._pointer = None
        self._finalizer()

    @property
    def context(self) -> Context:
        """Where it was made."""
        return self._context

    @property
    def _alive(self) -> Any:
        if self._pointer is None:
            raise ClosedError(f"the {type(self).__name__.lower()} is closed")
        return self._pointer

    def _call(self, function: Callable[..., int], *arguments: Any) -> int:
        with self._keeper.lock:  # from the look at the pointer to its last use: another thread may close it
            return self._keeper.call(function, self._alive, *arguments)
