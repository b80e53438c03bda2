"""Progress of an explicit run, sent about once a second or more often to a listener such as a terminal or a log.

Laboratory tests and studies call runs through many functions. A listener belongs to the context (`contextvars`), so
that none of these functions has to pass it.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

from bondem import _progress


@dataclass(frozen=True)
class RunProgress:
    """Progress of a run at one moment.

    Attributes:
        step: number of steps done.
        steps: number of steps of the whole run.
        time: simulated time [s].
        rate: steps per second of wall time [1/s].
        broken: number of broken bonds or facets.
        error: largest error of the energy balance so far [J].
        energy: largest entry of the energy balance so far [J].
    """

    step: int
    steps: int
    time: float
    rate: float
    broken: int
    error: float = 0.0
    energy: float = 0.0

    @property
    def balance(self) -> float | None:
        """Relative error of the energy balance [-]; None while all energies are zero."""
        return self.error / self.energy if self.energy > 0.0 else None

    @property
    def left(self) -> float:
        """Wall time to the end of the run at the present rate [s]; an event may end the run sooner."""
        return (self.steps - self.step) / self.rate

    @property
    def words(self) -> str:
        """Progress of a run as one line of text."""
        words = [
            f"step {self.step} of {self.steps}", f"t = {self.time:.4g} s", f"{self.rate:.0f} steps/s",
            f"at most {_progress.span(self.left)} left",
        ]  # fmt: skip
        if self.broken:
            words.append(f"{self.broken} broken")
        if self.balance is not None:
            words.append(f"energy error {self.balance:.0e}")
        return ", ".join(words)


_listener: ContextVar[Callable[[RunProgress], None] | None] = ContextVar("listener", default=None)


@contextmanager
def listening(listener: Callable[[RunProgress], None]) -> Iterator[None]:
    """Send the progress of the runs in a `with` block to `listener`."""
    token = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(token)


def has_listener() -> bool:
    """Return True if progress has a receiver: a listener of this context, or the display of a running stage."""
    return _listener.get() is not None or _progress.noted()


def send(progress: RunProgress) -> None:
    """Send progress to the listener of this context, if any, and to the display of the running stage."""
    _progress.note(progress.words if progress.step < progress.steps else "")
    listener = _listener.get()
    if listener is not None:
        listener(progress)
