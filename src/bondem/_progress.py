"""Progress of long calls: bars on a terminal and in a notebook, one line per stage elsewhere, and `logging`.

Only the outermost call is shown. A call with its own `progress=` is shown by that function alone.
"""

import functools
import importlib.util
import inspect
import logging
import os
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any, ParamSpec, TypeVar

from bondem._checks import shown
from bondem._outlets import OUTLETS
from bondem.errors import InputError

P = ParamSpec("P")
R = TypeVar("R")

#: Logger that records the beginning and the end of stages at level INFO.
LOG = logging.getLogger("bondem")
_MODES = ("auto", "bars", "lines", "off")
# Duration of a call from which on it is shown, and interval of lines about its progress [s].
_DELAY, _EVERY = 1.0, 30.0


class _Chosen:
    """Present display: the mode, the board of the outermost call, and the number of open `quiet` blocks."""

    mode = os.environ.get("BONDEM_PROGRESS", "auto")
    board: "Board | None" = None
    hidden = 0


def show_progress(mode: str = "auto") -> None:
    """Set the display of progress; the environment variable BONDEM_PROGRESS sets the initial mode.

    The logger "bondem" receives the beginning and the end of each stage at level INFO in every mode.

    Args:
        mode: "auto", "bars", "lines" (one per stage on stderr) or "off". "auto" shows bars on a terminal and in
            Jupyter with ipywidgets, and lines in Jupyter without it. Elsewhere it shows lines, or nothing if the
            logger "bondem" has a handler for level INFO.

    Raises:
        InputError: an unknown mode.
    """
    if not isinstance(mode, str) or mode not in _MODES:
        raise InputError(f"show_progress: mode = {shown(mode)} is unknown; give one of {', '.join(_MODES)}")
    _Chosen.mode = mode


def span(seconds: float) -> str:
    """Format a time for readers: "12.3 s", "4 min 05 s", "2 h 31 min"."""
    if seconds < 59.95:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"


def staged(title: str, *, shares: bool = True) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Decorate a function to be shown as a stage while it is the outermost call.

    Args:
        title: name of the stage.
        shares: True if the function's argument `progress`, if any, receives shares from 0 to 1.
    """

    def decorate(function: Callable[P, R]) -> Callable[P, R]:
        accepted = shares and "progress" in inspect.signature(function).parameters

        @functools.wraps(function)
        def run(*args: P.args, **named: P.kwargs) -> R:
            if accepted and named.get("progress") is not None and not callable(named["progress"]):
                raise InputError(
                    f"{function.__name__}: progress = {shown(named['progress'])}; give a function of the completed"
                    " share, 0 … 1, or None"
                )
            if _Chosen.board is not None or _Chosen.hidden:
                return function(*args, **named)
            if accepted and named.get("progress") is not None:
                with quiet():
                    return function(*args, **named)
            with stages() as show:
                show(title, 0.0)
                if accepted:
                    given: Any = named
                    given["progress"] = functools.partial(show, title)
                return function(*args, **named)

        return run

    return decorate


@contextmanager
def stages(*, at_once: bool = False) -> Iterator[Callable[[str, float], None]]:
    """Show stages by name; yield a function of the name of a stage and its completed share, 0 … 1.

    Args:
        at_once: True to show the first stage at once, as commands do; False to show it after a second.
    """
    if _Chosen.board is not None or _Chosen.hidden:
        yield lambda stage, share: None
        return
    board = Board(delay=0.0 if at_once else _DELAY)
    _Chosen.board = board
    try:
        yield board.update
    finally:
        _Chosen.board = None
        board.close()


@contextmanager
def reported(progress: Callable[[str, float], None] | None) -> Iterator[Callable[[str, float], None]]:
    """Yield a function of a stage and its completed share, 0 … 1: `progress`, or for None one that shows stages."""
    if progress is None:
        with stages() as show:
            yield show
    elif _Chosen.board is not None:
        yield progress
    else:
        with quiet():
            yield progress


@contextmanager
def quiet() -> Iterator[None]:
    """Show no progress within the block."""
    _Chosen.hidden += 1
    try:
        yield
    finally:
        _Chosen.hidden -= 1


def note(words: str) -> None:
    """Show a remark beside the current stage, such as the step of a run."""
    if _Chosen.board is not None:
        _Chosen.board.note = words


def noted() -> bool:
    """Return True if a stage is shown that can have a remark."""
    return _Chosen.board is not None and _Chosen.board.kind != "off"


def _kind() -> str:
    """Return how stages are shown: "bars", "lines" or "off"."""
    if _Chosen.mode in ("bars", "lines", "off"):
        return _Chosen.mode
    if "ipykernel" in sys.modules:
        return "bars" if importlib.util.find_spec("ipywidgets") is not None else "lines"
    if sys.stderr is not None and sys.stderr.isatty():
        return "bars"
    logged = LOG.hasHandlers() and LOG.isEnabledFor(logging.INFO)
    return "off" if logged else "lines"


class Board:
    """Display of the stages of one call.

    Args:
        delay: time until the first stage is shown [s].
    """

    def __init__(self, *, delay: float) -> None:
        self.kind, self.note = _kind(), ""
        self._shares: dict[str, float] = {}
        self._since: dict[str, float] = {}
        self._stage = ""
        self._start, self._closed = time.monotonic(), threading.Event()
        self._view: Any = None  # _Lines or Bars
        self._lock = threading.RLock()
        self._delay = delay
        if self.kind != "off":
            if not delay:
                self._show()
            threading.Thread(target=self._watch, name="bondem progress", daemon=True).start()

    def update(self, stage: str, share: float) -> None:
        """Set the completed share of a stage, 0 … 1."""
        with self._lock:
            if stage not in self._since:
                self._since[stage] = time.monotonic()
                LOG.info("%s", stage)
            if stage != self._stage:
                self._stage, self.note = stage, ""  # the remark was on the stage before
            if share >= 1.0 > self._shares.get(stage, 0.0):
                LOG.info("%s: done in %s", stage, span(time.monotonic() - self._since[stage]))
            self._shares[stage] = share
            if self._view is not None:
                self._view.update(stage, share)

    def close(self) -> None:
        """End the display."""
        self._closed.set()
        with self._lock:
            if self._view is not None:
                self._view.close()

    def _watch(self) -> None:
        if self._closed.wait(self._delay):
            return
        self._show()
        while not self._closed.wait(_EVERY):
            with self._lock:
                if self._view is not None and not self._closed.is_set():
                    self._view.beat()

    def _show(self) -> None:
        with self._lock:
            if self._view is not None or self._closed.is_set():
                return
            view = self._view = _Lines(self)
            if self.kind == "bars":  # rich, which they need, takes 2 MB
                view = self._view = OUTLETS.bars(lambda: self.note)
            for stage, share in self._shares.items():
                view.update(stage, share)

    @property
    def seconds(self) -> float:
        """Time since the start of the call [s]."""
        return time.monotonic() - self._start


class _Lines:
    """Display of one line per stage on stderr, and of further lines at intervals in a long stage."""

    def __init__(self, board: Board) -> None:
        self._board, self._seen, self._stage, self._share = board, set[str](), "", 0.0

    def update(self, stage: str, share: float) -> None:
        self._stage, self._share = stage, share
        if stage not in self._seen:
            self._seen.add(stage)
            self._write(stage)

    def beat(self) -> None:
        far = f": {100.0 * self._share:.0f} %" if 0.0 < self._share < 1.0 else ""
        self._write(f"{self._stage}{far}" + (f", {self._board.note}" if self._board.note else ""))

    def close(self) -> None:
        """Do nothing, because nothing is open."""

    def _write(self, words: str) -> None:
        if sys.stderr is None:  # print would write to stdout
            return
        with suppress(OSError):  # a disk that is full need not end the call
            print(f"bondem: {span(self._board.seconds):>8}  {words}", file=sys.stderr, flush=True)
