"""The C interface of the viewer, halfspace/viewer.h, without changes. Its library is loaded at first use."""
import ctypes
import functools
import pathlib
import sys
from typing import Any, Iterator

from . import _raw
from ._library import declare_functions, library, open_first

_PACKAGE = pathlib.Path(__file__).resolve().parent
_PAGE = pathlib.Path("share/halfspace/viewer/viewer.html")


class hs_recording(ctypes.Structure):
    pass


def _declare(found: ctypes.CDLL) -> None:
    recording, status, text = ctypes.POINTER(hs_recording), ctypes.c_int32, ctypes.c_char_p
    count, array = ctypes.c_int64, ctypes.c_void_p
    functions = {
        "create": (recording, status, text),
        "read": (recording, text),
        "destroy": (None, recording),
        "error": (text,),
        "add_block": (count, recording, text, status, status, array, count, array, count, array, array),
        "set_materials": (status, recording, count, ctypes.POINTER(text)),
        "add_frame": (status, recording, ctypes.c_double),
        "set_poses": (status, recording, count, array, array),
        "set_vertices": (status, recording, count, array),
        "set_values": (status, recording, text, text, count, array, array),
        "set_contacts": (status, recording, count, array, array, array, array, array),
        "set_bolts": (status, recording, count, array, array, array, array, array),
        "add_cracks": (status, recording, count, array, array, array, array, array, array, array),
        "set_history": (status, recording, text),
        "write": (status, recording, text, text),
    }
    declare_functions(found, "hs_recording_", functions)


@functools.lru_cache(maxsize=None)
def viewer_library() -> Any:
    """The library of the viewer: beside that of the kernel, or where the system's loader finds it."""
    name = _raw.SONAME.replace("libhalfspace", "libhalfspace_viewer")
    found = open_first((str(pathlib.Path(str(library._name)).parent / name), name), "the viewer")
    _declare(found)
    return found


def _pages() -> Iterator[pathlib.Path]:
    yield _PACKAGE / "viewer.html"
    for folder in (pathlib.Path(str(library._name)).absolute().parents, pathlib.Path(sys.prefix, "lib").parents):
        yield from (parent / _PAGE for parent in list(folder)[:4])
    yield pathlib.Path("/usr/local") / _PAGE
    yield pathlib.Path("/usr") / _PAGE


def viewer_page() -> pathlib.Path:
    """The page that plays recordings, without one."""
    for page in _pages():
        if page.is_file():
            return page
    raise FileNotFoundError(
        "halfspace: viewer.html is missing, as this build had no three.js (Debian: libjs-three); looked in "
        + ", ".join(map(str, _pages()))
    )
