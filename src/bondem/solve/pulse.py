"""How far an explicit run is, told about once a second to who listens: a terminal, a log.

Runs are deep inside of tests and studies; whoever watches them does so from far above, so that what is told does not
pass through all the functions between.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

from bondem import _progress


@dataclass(frozen=True)
class Pulse:
    """A moment of a run.

    Attributes:
        step: steps done.
        steps: of the whole run.
        time: simulated [s].
        rate: steps in a second of wall time.
        broken: bonds or facets that have broken.
        error: largest error of the energy ledger so far [J].
        energy: its largest entry so far [J].
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
        """Error of the energy ledger [-]; None where there is no energy yet."""
        return self.error / self.energy if self.energy > 0.0 else None

    @property
    def left(self) -> float:
        """Wall time to the end of the run at this rate [s]; a test that ends by itself may end sooner."""
        return (self.steps - self.step) / self.rate


    @property
    def words(self) -> str:
        """The moment in a line."""
        words = [
            f"step {self.step} of {self.steps}", f"t = {self.time:.4g} s", f"{self.rate:.0f} steps/s",
            f"{_progress.span(self.left)} left at most",
        ]  # fmt: skip
        if self.broken:
            words.append(f"{self.broken} broken")
        if self.balance is not None:
            words.append(f"ledger {self.balance:.0e}")
        return ", ".join(words)


_listener: ContextVar[Callable[[Pulse], None] | None] = ContextVar("listener", default=None)


@contextmanager
def listening(listener: Callable[[Pulse], None]) -> Iterator[None]:
    """Tell `listener` about the runs of this context."""
    token = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(token)


def heard() -> bool:
    """Whether anybody listens."""
    return _listener.get() is not None or _progress.noted()


def tell(pulse: Pulse) -> None:
    """Tell who listens."""
    _progress.note(pulse.words if pulse.step < pulse.steps else "")
    listener = _listener.get()
    if listener is not None:
        listener(pulse)
