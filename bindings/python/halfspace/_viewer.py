"""The library of the viewer, which is loaded at first use."""
import functools
import pathlib
import sys
from typing import Any, Iterator

from . import _raw, _raw_viewer
from ._library import library, open_first

_PACKAGE = pathlib.Path(__file__).resolve().parent
_PAGE = pathlib.Path("share/halfspace/viewer/viewer.html")


@functools.lru_cache(maxsize=None)
def viewer_library() -> Any:
    """The library of the viewer: beside that of the kernel, or where the system's loader finds it."""
    name = _raw.SONAME.replace("libhalfspace", "libhalfspace_viewer")
    found = open_first((str(pathlib.Path(str(library._name)).parent / name), name), "the viewer")
    _raw_viewer.declare(found)
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
