"""The context, and the lifetime of handles."""
from __future__ import annotations

import contextlib
import ctypes
import threading
import weakref
from typing import Any, Callable, ContextManager, Iterable, Iterator, List, Optional, Sequence, Tuple, Type, TypeVar

import numpy as np
from numpy.typing import NDArray

from . import _raw
from ._library import library
from ._record import AnyRecord, Record, Records, empty_record
from .errors import ClosedError, error_of


_Abandoned = List[Tuple[Callable[[Any], None], Any]]


def _end_all(abandoned: _Abandoned) -> None:
    while abandoned:
        destroy, pointer = abandoned.pop()
        destroy(pointer)


def _destroy_context(pointer: Any, lock: Any, abandoned: _Abandoned) -> None:
    # At the end of the interpreter a thread may still be in a call; the system releases the memory then.
    if lock.acquire(blocking=False):
        _end_all(abandoned)
        library.hs_context_destroy(pointer)
        lock.release()


def _wrong_type(error: ctypes.ArgumentError, function: Any, arguments: Tuple[Any, ...]) -> TypeError:
    """The error of ctypes, "argument 2: ...", with the value."""
    number = int(str(error).split()[1].rstrip(":"))
    return TypeError(f"{function.__name__}: {arguments[number - 1]!r} is of a wrong type")


class _Keeper:
    """The C context with its lock. Everything made from it holds a reference to it, so it is destroyed last.

    The library allows one call at a time per context, and ctypes releases the interpreter's lock during a call, so
    the context needs a lock. A handle that is closed or dropped while another thread is in a call is destroyed after
    that call or a later one.
    """

    def __init__(self, threads: int) -> None:
        self.lock = threading.RLock()
        self.pointer = ctypes.POINTER(_raw.hs_context)()
        self._abandoned: _Abandoned = []
        definition = _raw.hs_context_def()
        library.hs_context_def_init(ctypes.byref(definition), ctypes.sizeof(definition))
        definition.threads = threads
        status = library.hs_context_create(ctypes.byref(definition), ctypes.byref(self.pointer))
        if status < 0:
            what = library.hs_status_string(status).decode()  # without a context there is no error text
            raise error_of(status, f"hs_context_create: {what}: threads is {threads}; it must be from 1 to 256")
        self._finalizer = weakref.finalize(self, _destroy_context, self.pointer, self.lock, self._abandoned)

    def call(self, function: Callable[..., int], *arguments: Any) -> int:
        """Calls a function; raises an exception if it fails."""
        with self.lock:
            if not self._finalizer.alive:  # the interpreter ends
                raise ClosedError("the context is closed")
            try:
                try:
                    status = function(*arguments)
                except ctypes.ArgumentError as error:
                    raise _wrong_type(error, function, arguments) from None
                if status < 0:
                    raise error_of(status, library.hs_context_last_error(self.pointer).decode())
            finally:
                _end_all(self._abandoned)  # not before the call, as its arguments may be among them
        return status

    def end(self, destroy: Callable[[Any], None], pointer: Any) -> None:
        if self.lock.acquire(blocking=False):
            try:
                destroy(pointer)
            finally:
                self.lock.release()
        else:
            self._abandoned.append((destroy, pointer))


class _Caller:
    """What the library's functions are called with."""

    def _call(self, function: Callable[..., int], *arguments: Any) -> int:
        raise NotImplementedError

    def _value(self, function: Any, *arguments: Any) -> int:
        """The number that a function returns by its last argument."""
        value = function.argtypes[-1]._type_()
        self._call(function, *arguments, ctypes.byref(value))
        return int(value.value)

    def _record(self, kind: Type[AnyRecord], function: Any, *arguments: Any) -> AnyRecord:
        """The record that a function fills: its last argument, but for the size of those that may grow."""
        record, struct = empty_record(kind)
        is_sized = len(function.argtypes) == len(arguments) + 3
        self._call(function, *arguments, struct, *[ctypes.sizeof(struct)] * is_sized)
        return record


class Context(_Caller):
    """Owner of shapes, meshes and worlds. Without a given context the default context is used.

    One thread at a time can call the library in a context; others wait. Worlds of different contexts can run
    concurrently in different threads, as calls release the interpreter's lock. A world may also be stepped by several
    threads of the library.

    Parameters
    ----------
    threads
        Number of threads that step a world, 1 to 256. Results are bit-identical for any number.

    Examples
    --------
    >>> import halfspace as hs
    >>> with hs.Context() as context:
    ...     square = hs.Shape.rectangle(1, 1, context=context)
    >>> square.closed
    True
    """

    def __init__(self, *, threads: int = 1) -> None:
        self._keeper: Optional[_Keeper] = _Keeper(threads)
        self._handles: "weakref.WeakSet[Handle]" = weakref.WeakSet()

    def __enter__(self) -> "Context":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __reduce__(self) -> Tuple[Any, ...]:  # pickle and copy
        raise TypeError("a Context cannot be copied or pickled; make another one")

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
        """Destroys everything made from this context, and the context. A second call does nothing."""
        keeper = self._keeper
        if keeper is None:
            return
        with keeper.lock:  # another thread may be creating a handle
            for handle in list(self._handles):
                handle.close()
            self._keeper = None

    @property
    def _alive(self) -> _Keeper:
        if self._keeper is None:
            raise ClosedError("the context is closed")
        return self._keeper

    def _call(self, function: Callable[..., int], *arguments: Any) -> int:
        keeper = self._alive
        return keeper.call(function, keeper.pointer, *arguments)


_default: Optional[Context] = None


def default_context() -> Context:
    """The context that is used if none is given; created on first use."""
    global _default
    if _default is None or _default.closed:
        _default = Context()
    return _default


_AnyHandle = TypeVar("_AnyHandle", bound="Handle")
_AnyElement = TypeVar("_AnyElement", bound=np.generic)
_Made = TypeVar("_Made")


class Handle(_Caller):
    """An object of the library, destroyed by `close()`, at the end of a `with` block, or by garbage collection.

    The creator holds the context's lock from the call that returns the pointer; otherwise another thread could close
    the context in between without destroying the object."""

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

    def __reduce__(self) -> Tuple[Any, ...]:  # pickle and copy
        raise TypeError(f"a {type(self).__name__} cannot be copied or pickled; make another one of the same input")

    @property
    def closed(self) -> bool:
        """Has it been closed?"""
        return not self._finalizer.alive

    def close(self) -> None:
        """Destroys it. A second call does nothing; any other use raises `ClosedError`."""
        self._pointer = None
        self._finalizer()

    @property
    def context(self) -> Context:
        """The context that it was made from."""
        return self._context

    @property
    def _alive(self) -> Any:
        if self._pointer is None or not self._finalizer.alive:  # closed, or destroyed with the interpreter
            raise ClosedError(f"the {type(self).__name__.lower()} is closed")
        return self._pointer

    def _call(self, function: Callable[..., int], *arguments: Any) -> int:
        with self._keeper.lock:  # until the last use of the pointer, as another thread may close it
            return self._keeper.call(function, self._alive, *arguments)

    def _array(self, kind: Type[_AnyElement], function: Any, *arguments: Any) -> NDArray[_AnyElement]:
        """All that a function returns whose last arguments are an array, its capacity, and the number of elements."""
        with self._keeper.lock:
            array = np.zeros(self._value(function, *arguments, None, 0), kind)
            self._value(function, *arguments, array.ctypes.data, len(array))
        return array

    def _records(self, kind: Type[Record], function: Any, *arguments: Any) -> Records:
        """All that a function returns likewise, as records."""
        records: Records = self._array(kind._type, function, *arguments).view(Records)
        return records


def made(
    own: Callable[[Context, Any], _Made], context: Optional[Context], make: Any, *arguments: Any, behind: Any = ()
) -> _Made:
    """Makes an object by a function, behind whose arguments are its pointer and others, and a `Handle` by `own`: until
    then another thread could close the context without destroying the object."""
    owner = context or default_context()
    with owner._alive.lock:
        pointer = make.argtypes[len(arguments) + 1]._type_()
        owner._call(make, *arguments, ctypes.byref(pointer), *behind)
        return own(owner, pointer)


def pointers_of(handles: Sequence[Handle]) -> Any:
    """The pointers of handles that are held, for C."""
    return (ctypes.c_void_p * len(handles))(*(ctypes.cast(each._alive, ctypes.c_void_p).value for each in handles))


def held(*handles: Handle) -> ContextManager[Any]:
    """For a `with` block in which no other thread uses or closes these handles: from reading a pointer to its last
    use, or for several dependent calls."""
    for handle in handles:
        if not isinstance(handle, Handle):
            raise TypeError(f"{handle!r} is no object of the library, such as a Shape")
    keepers = {handle._keeper for handle in handles}
    if len(keepers) == 1:
        return keepers.pop().lock
    return _all_held(keepers)


@contextlib.contextmanager
def _all_held(keepers: Iterable[_Keeper]) -> Iterator[None]:
    with contextlib.ExitStack() as stack:
        for keeper in sorted(keepers, key=id):  # the same order in all threads prevents deadlocks
            stack.enter_context(keeper.lock)
        yield
