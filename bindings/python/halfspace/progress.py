"""A progress bar in a terminal or a notebook."""
from __future__ import annotations

import html
import sys
import time
from typing import Any, Optional

_WIDTH = 30
_INTERVAL = 0.1  # s, between two pictures of a bar


def _clock(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


def _notebook_display() -> Optional[Any]:
    """The function that shows objects in the notebook, or None outside of notebooks."""
    module = sys.modules.get("IPython")
    shell = module.get_ipython() if module else None
    if shell is None or not hasattr(shell, "kernel"):
        return None
    from IPython.display import display

    return display


def _is_terminal(stream: Any) -> bool:
    try:
        return bool(stream.isatty())
    except (AttributeError, ValueError):  # None, an object that takes text only, or closed
        return False


class ProgressBar:
    """Shows the completed fraction of some work, its position and the time left.

    In a notebook it is an element of the cell's output, in a terminal a line on standard error. Elsewhere, as where
    standard error is a file, it shows nothing.
    """

    def __init__(self) -> None:
        self._display = _notebook_display()
        self._is_shown = self._display is not None or _is_terminal(sys.stderr)
        self._handle: Any = None
        self._start = time.perf_counter()
        self._last = -_INTERVAL
        self._is_drawn = False

    def show(self, fraction: float, where: str) -> None:
        """Shows a fraction from 0 to 1, and the position as text. Draws at most ten times per second."""
        elapsed = time.perf_counter() - self._start
        if not self._is_shown or (fraction < 1 and elapsed - self._last < _INTERVAL):
            return
        self._last = elapsed
        done = min(max(fraction, 0.0), 1.0)
        text = f"{100 * done:.0f} %  {where}"
        if 0 < done < 1:
            text += f"  {_clock(elapsed * (1 - done) / done)} left"
        self._draw(done, text)

    def close(self) -> None:
        """Ends the line of a terminal."""
        if self._is_drawn and self._display is None:
            print(file=sys.stderr)
        self._is_drawn = False

    def _draw(self, done: float, text: str) -> None:
        self._is_drawn = True
        if self._display is None:
            filled = "#" * int(done * _WIDTH)
            print(f"\r\033[K[{filled:<{_WIDTH}}] {text}", end="", file=sys.stderr, flush=True)
            return
        bar = f'<progress value="{done:.4f}" max="1"></progress> {html.escape(text)}'
        bundle = {"text/plain": text, "text/html": bar}
        if self._handle is None:
            self._handle = self._display(bundle, raw=True, display_id=True)
        else:
            self._handle.update(bundle, raw=True)
