"""Progress bars on a terminal and in a notebook, drawn by the package `rich`."""

from collections.abc import Callable, Iterable
from typing import Any

from rich.console import Console, RenderableType
from rich.markup import escape
from rich.progress import BarColumn, Progress, SpinnerColumn, TaskID, TextColumn, TimeElapsedColumn
from rich.text import Text


def bars(note: Callable[[], str]) -> "Bars":
    """Return a display of bars; `note` is a function that returns the remark beside the current stage."""
    return Bars(note)


class Bars:
    """Display of one bar per stage."""

    def __init__(self, note: Callable[[], str]) -> None:
        columns = SpinnerColumn(), TextColumn("{task.description:<28}"), BarColumn(), TimeElapsedColumn()
        self._progress = _Noted(note, columns)
        self._tasks: dict[str, TaskID] = {}
        self._progress.start()

    def update(self, stage: str, share: float) -> None:
        """Show the completed share of a stage, 0 … 1."""
        if stage not in self._tasks:
            self._tasks[stage] = self._progress.add_task(escape(stage), total=1.0)
        self._progress.update(self._tasks[stage], completed=share)

    def beat(self) -> None:
        """Do nothing, because bars update themselves."""

    def close(self) -> None:
        """End the display."""
        self._progress.stop()


class _Noted(Progress):
    """Bars of rich, followed by a line with the remark beside the current stage."""

    def __init__(self, note: Callable[[], str], columns: tuple[Any, ...]) -> None:
        self._note = note
        super().__init__(*columns, console=Console(stderr=True))

    def get_renderables(self) -> Iterable[RenderableType]:
        yield from super().get_renderables()
        if self._note():
            yield Text(f"  {self._note()}", style="dim")
