"""The library of scenes, which is loaded at first use.

Search order: the one bundled in this package; the folder of the library of the kernel, as both are installed together;
the system's loader."""
from __future__ import annotations

import ctypes
import functools
import pathlib
import threading
import weakref
from typing import Any

from . import _raw, _raw_scene
from ._library import library, open_first
from .errors import HalfspaceError, SceneError, StateError, error_of


@functools.lru_cache(maxsize=None)
def scene_library() -> Any:
    """The library of scenes. It uses the library of the kernel that is loaded already."""
    name = _raw.SONAME.replace("libhalfspace", "libhalfspace_scene")
    beside = pathlib.Path(str(library._name)).parent
    paths = (*map(str, (beside / "_scene_library").glob(name)), str(beside / name), name)
    found = open_first(paths, "scenes")
    _raw_scene.declare(found)
    return found


def _error_of(status: int, text: str) -> HalfspaceError:
    if status == _raw.HS_ERROR_FORMAT:
        return SceneError(status, text)
    if status == _raw.HS_ERROR_STATE:
        return StateError(status, text.replace("; --force replaces an earlier run in it", "; replace=True replaces it"))
    return error_of(status, text)


class SceneHandle:
    """A scene of the library, empty at first."""

    def __init__(self) -> None:
        self._library = scene_library()
        self.lock = threading.RLock()
        self._pointer = ctypes.POINTER(_raw_scene.hs_scene)()
        status = self._library.hs_scene_create(ctypes.byref(self._pointer))
        if status < 0:
            raise error_of(status, "hs_scene_create: out of memory")
        weakref.finalize(self, self._library.hs_scene_destroy, self._pointer)

    def call(self, name: str, *arguments: Any) -> None:
        """Calls a function of a scene; raises an exception if it fails."""
        with self.lock:
            status = getattr(self._library, f"hs_scene_{name}")(self._pointer, *arguments)
            if status < 0:
                raise _error_of(status, str(self._library.hs_scene_last_error(self._pointer), "utf-8", "replace"))

    def text(self, which: int) -> str:
        """One of the texts of a scene."""
        with self.lock:
            return str(self._library.hs_scene_get_text(self._pointer, which), "utf-8", "replace")
