"""The C interface of scenes, halfspace/scene.h, without changes. Its library is loaded at first use.

Search order: the one bundled in this package; the folder of the library of the kernel, as both are installed together;
the system's loader."""
from __future__ import annotations

import ctypes
import functools
import pathlib
import threading
import weakref
from typing import Any

from . import _raw
from ._library import declare_functions, library, open_first
from .errors import HalfspaceError, SceneError, StateError, error_of

TEXT_TOML, TEXT_NOTES, TEXT_NAMES, TEXT_REPORT, TEXT_TROUBLE = range(5)
VARY_TILT, VARY_LOADS, VARY_SETTING = range(3)

PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_double, ctypes.c_char_p)
ROW = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(_raw.hs_world))


class hs_scene(ctypes.Structure):
    pass


class hs_scene_properties(ctypes.Structure):
    _fields_ = [
        ("dimension", ctypes.c_int32),
        ("threads", ctypes.c_int32),
        ("duration", ctypes.c_double),
        ("stage_count", ctypes.c_int64),
    ]


class hs_scene_run_def(ctypes.Structure):
    _fields_ = [
        ("directory", ctypes.c_char_p),
        ("replaces", ctypes.c_int32),
        ("from_", ctypes.c_char_p),
        ("progress", PROGRESS),
        ("row", ROW),
        ("user", ctypes.c_void_p),
    ]


class hs_scene_run_result(ctypes.Structure):
    _fields_ = [
        ("end", ctypes.c_int32),
        ("time", ctypes.c_double),
        ("steps", ctypes.c_int64),
        ("run_out", ctypes.c_double),
        ("max_displacement", ctypes.c_double),
        ("largest_overlap", ctypes.c_double),
        ("energy_residual", ctypes.c_double),
    ]


class hs_scene_safety_def(ctypes.Structure):
    _fields_ = [
        ("low", ctypes.c_double),
        ("high", ctypes.c_double),
        ("resolution", ctypes.c_double),
        ("limit", ctypes.c_double),
        ("directory", ctypes.c_char_p),
        ("replaces", ctypes.c_int32),
        ("resumes", ctypes.c_int32),
        ("progress", PROGRESS),
        ("user", ctypes.c_void_p),
    ]


class hs_scene_limit_def(ctypes.Structure):
    _fields_ = [
        ("varied", ctypes.c_int32),
        ("smallest", ctypes.c_int32),
        ("name", ctypes.c_char_p),
        ("low", ctypes.c_double),
        ("high", ctypes.c_double),
        ("resolution", ctypes.c_double),
        ("limit", ctypes.c_double),
        ("directory", ctypes.c_char_p),
        ("replaces", ctypes.c_int32),
        ("resumes", ctypes.c_int32),
        ("progress", PROGRESS),
        ("user", ctypes.c_void_p),
    ]


class hs_scene_search_result(ctypes.Structure):
    _fields_ = [("end", ctypes.c_int32), ("stable", ctypes.c_double), ("falls", ctypes.c_double)]


def _declare(found: ctypes.CDLL) -> None:
    scene, status = ctypes.POINTER(hs_scene), ctypes.c_int32
    context, world = ctypes.POINTER(_raw.hs_context), ctypes.POINTER(_raw.hs_world)
    shape, text, to = ctypes.POINTER(_raw.hs_shape), ctypes.c_char_p, ctypes.POINTER
    functions = {
        "create": (status, to(scene)),
        "destroy": (None, scene),
        "last_error": (text, scene),
        "get_text": (text, scene, ctypes.c_int32),
        "read": (status, scene, text, ctypes.c_size_t, text, to(text), ctypes.c_int64),
        "get_properties": (status, scene, to(hs_scene_properties)),
        "make_world": (status, scene, context, to(world)),
        "make_shapes": (status, scene, context, to(ctypes.c_int64)),
        "take_shape": (status, scene, ctypes.c_int64, to(shape)),
        "run_def_init": (None, to(hs_scene_run_def)),
        "run": (status, scene, context, to(hs_scene_run_def), to(hs_scene_run_result), to(world)),
        "safety_def_init": (None, to(hs_scene_safety_def)),
        "find_safety": (status, scene, context, to(hs_scene_safety_def), to(hs_scene_search_result)),
        "limit_def_init": (None, to(hs_scene_limit_def)),
        "find_limit": (status, scene, context, to(hs_scene_limit_def), to(hs_scene_search_result)),
        "write_vtk": (status, scene, context, world, ctypes.c_void_p, text, text),
    }
    declare_functions(found, "hs_scene_", functions)


@functools.lru_cache(maxsize=None)
def scene_library() -> Any:
    """The library of scenes. It uses the library of the kernel that is loaded already."""
    name = _raw.SONAME.replace("libhalfspace", "libhalfspace_scene")
    beside = pathlib.Path(str(library._name)).parent
    paths = (*map(str, (beside / "_scene_library").glob(name)), str(beside / name), name)
    found = open_first(paths, "scenes")
    _declare(found)
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
        self._pointer = ctypes.POINTER(hs_scene)()
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
