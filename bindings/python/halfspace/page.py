"""Pages that play runs in a browser or a notebook."""
import html
import os
import pathlib
import tempfile
import webbrowser
from typing import Any, Union

from .recording import Recording, read_run


class View:
    """A page of HTML that plays a run. In a notebook it shows itself."""

    def __init__(self, path: pathlib.Path) -> None:
        self._path = path

    @property
    def path(self) -> pathlib.Path:
        """The page."""
        return self._path

    def __repr__(self) -> str:
        return f"View({str(self.path)!r})"

    def open(self) -> None:
        """Opens the page in the browser of the system."""
        webbrowser.open(self.path.absolute().as_uri())

    def _repr_html_(self) -> str:
        page = html.escape(self.path.read_text(encoding="utf-8"), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 640px; border: 0" allowfullscreen></iframe>'


def view(run: Any, path: Union[str, "os.PathLike[str]", None] = None) -> View:
    """Writes a run as one page of HTML, which plays it and fetches nothing.

    Parameters
    ----------
    run : path, Recording, or result of a run
        An output directory of the command, frames of a world, or anything with a `directory`.
    path : path, optional
        File to write; by default view.html in the directory, for a recording a temporary file.

    Examples
    --------
    >>> world = World(law=Law(normal_stiffness=1e7))
    >>> recording = Recording(world)
    >>> for _ in range(10):
    ...     recording.add()
    >>> page = view(recording)
    >>> page.path.suffix
    '.html'
    """
    if isinstance(run, Recording):
        target = pathlib.Path(path) if path is not None else _temporary()
        run.write(target)
        return View(target)
    directory = getattr(run, "directory", run)
    if not isinstance(directory, (str, os.PathLike)):
        raise TypeError(
            f"run is {run!r}; it must be a Recording, the output directory of a run, or the result of a run with one"
        )
    directory = pathlib.Path(directory)
    target = pathlib.Path(path) if path is not None else directory / "view.html"
    read_run(directory, target)
    return View(target)


def _temporary() -> pathlib.Path:
    handle, name = tempfile.mkstemp(prefix="halfspace_", suffix=".html")
    os.close(handle)
    return pathlib.Path(name)
