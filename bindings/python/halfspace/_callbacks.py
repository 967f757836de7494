"""Callbacks of the library of scenes."""
from __future__ import annotations

import signal
import threading
from typing import Any, Callable, Optional

from . import _raw_scene
from .progress import ProgressBar
from .world import World

#: Called with the world of a run; False ends the run.
Callback = Callable[[World], Optional[bool]]


class Callbacks:
    """The callbacks of a run: of its progress, and of each row of its history.

    An exception in one of them, also of Ctrl-C, ends the run and is raised after it."""

    def __init__(
        self,
        shows_progress: bool,
        callback: Optional[Callback] = None,
        world_at: Optional[Callable[[Any], World]] = None,
        stopped: Optional[threading.Event] = None,
    ) -> None:
        self._bar = ProgressBar() if shows_progress else None
        self._callback, self._world_at, self._stopped = callback, world_at, stopped
        self._error: Optional[BaseException] = None
        # Without a bar, too, as Python handles signals during these calls.
        self.progress = _raw_scene.hs_scene_progress(self._on_progress)
        row: Any = self._on_row if callback else 0
        self.row = _raw_scene.hs_scene_row(row)
        self._where = ""
        self._is_calling = False
        self._handler: Any = None  # of Ctrl-C, before

    def __enter__(self) -> "Callbacks":
        # Python's own handler raises as soon as a callback is entered, where C would drop the exception.
        is_main = threading.current_thread() is threading.main_thread()
        if is_main and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            self._handler = signal.signal(signal.SIGINT, self._interrupt)
        return self

    def _interrupt(self, *_: object) -> None:
        if self._is_calling:
            raise KeyboardInterrupt
        self._error = self._error or KeyboardInterrupt()

    def __exit__(self, *_: object) -> None:
        if self._handler:
            signal.signal(signal.SIGINT, self._handler)
        if self._bar:
            self._bar.close()

    def _on_progress(self, _: Any, fraction: float, where: bytes) -> int:
        self._where = where.decode()
        return self._ends(lambda: self._show(fraction))

    def _show(self, fraction: float) -> None:
        if self._bar:
            self._bar.show(fraction, self._where)

    def _on_row(self, _: Any, pointer: Any) -> int:
        assert self._callback and self._world_at
        callback, world_at = self._callback, self._world_at

        def follow() -> Any:
            with world_at(pointer) as world:
                return callback(world)

        return self._ends(follow)

    def _ends(self, call: Callable[[], Any]) -> int:
        if self._error is not None or (self._stopped and self._stopped.is_set()):
            return 1
        try:
            self._is_calling = True
            return 1 if call() is False else 0
        except BaseException as error:  # whatever it is, it must not pass through C
            self._error = error
            return 1
        finally:
            self._is_calling = False

    def end(self, end: str) -> None:
        """Raises the exception of a callback, or completes the bar of work that was not interrupted."""
        if self._error is not None:
            raise self._error
        if end != "interrupted":
            self._show(1.0)
