"""Finds and loads the shared library.

Search order: the file of the environment variable HALFSPACE_LIBRARY; the library bundled in this package; the one
installed in the same prefix; the one that the system's loader finds."""
from __future__ import annotations

import ctypes
import os
import pathlib
from typing import Iterable, Iterator

from . import _raw

_NAME = _raw.SONAME
_PACKAGE = pathlib.Path(__file__).resolve().parent


def _candidates() -> Iterator[str]:
    yield from map(str, _PACKAGE.glob(_NAME))
    # PREFIX/lib/python3/dist-packages/halfspace or PREFIX/lib/python3.11/site-packages/halfspace
    if len(_PACKAGE.parents) > 2 and _PACKAGE.parents[2].name.startswith("lib"):
        beside = _PACKAGE.parents[2]
        yield from sorted(map(str, (*beside.glob(_NAME), *beside.glob("*/" + _NAME))))
    yield _NAME


def open_library(path: str) -> ctypes.CDLL:
    """Loads a library. Those that a bundled one needs are in its folder, which the loader does not search."""
    if pathlib.Path(path).is_relative_to(_PACKAGE):
        for needed in sorted(pathlib.Path(path).parent.glob("*.so*")):
            if needed.name != pathlib.Path(path).name:
                ctypes.CDLL(str(needed))
    return ctypes.CDLL(path)


def open_first(paths: Iterable[str], content: str) -> ctypes.CDLL:
    """Loads the first of these libraries that is there; raises ImportError if none is."""
    failures = []
    for path in paths:
        try:
            return open_library(path)
        except OSError as error:
            failures.append(str(error))
    raise ImportError(f"halfspace: no library of {content}:\n  " + "\n  ".join(failures))


def _check_version(library: ctypes.CDLL, path: str) -> None:
    have = _version_of(library)
    wanted = _NAME[len("libhalfspace.so."):]
    if not have.startswith(wanted + "."):
        raise ImportError(f"halfspace: {path} has version {have}; required: {wanted}")


def _version_of(library: ctypes.CDLL) -> str:
    return str(library.hs_version(), "ascii")


def _load() -> ctypes.CDLL:
    chosen = os.environ.get("HALFSPACE_LIBRARY")
    failures = []
    for path in [chosen] if chosen else _candidates():
        try:
            found = open_library(path)
            _raw.declare(found)
            _check_version(found, path)
            return found
        except OSError as error:
            failures.append(str(error))
        except AttributeError as error:  # a function that this package needs is not there
            raise ImportError(f"halfspace: {path} has another version: {error}") from error
    where = "HALFSPACE_LIBRARY" if chosen else "the package, its prefix and the system"
    raise ImportError(f"halfspace: no shared library in {where}:\n  " + "\n  ".join(failures))


library = _load()


def version() -> str:
    """Version of the shared library, e.g. ``"0.1.0"``."""
    return _version_of(library)


def status_text(status: int) -> str:
    """The text of a status code; unknown codes are allowed."""
    return str(library.hs_status_string(status), "ascii")
