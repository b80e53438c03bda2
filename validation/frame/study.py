"""The frame of every study: rows stage by stage, then numbers, tables and figures.

A study says what is to be made, what its rows mean and how to draw it; `validation.frame.runner.run` does the rest,
and goes on where it was when it is called again with the same folder.
"""

from abc import ABC, abstractmethod
from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from validation.frame.limits import Limit
from validation.frame.request import Request

Row = dict[str, Any]
#: Yields the name and the requests of a stage, and is sent its rows.
Stages = Generator[tuple[str, Sequence[Request]], list[Row], None]


@dataclass(frozen=True)
class Study(ABC):
    """A study of packings; its subclasses are frozen dataclasses, whose fields are the options of its command.

    Attributes:
        name: of the command and its module, and in its results.
        limits: what options may be, by name.
    """

    name: ClassVar[str]
    limits: ClassVar[dict[str, Limit]] = {}

    def __init_subclass__(cls) -> None:
        cls.name = cls.__module__.rpartition(".")[2]

    def __post_init__(self) -> None:
        for option, limit in self.limits.items():
            limit(self.name, option, getattr(self, option))

    @abstractmethod
    def stages(self, out: Path) -> Stages:
        """The stages, one after the other; later ones may need what earlier ones left in the folder `out`."""

    @abstractmethod
    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """What `results.json` says beside the rows of the last stage, some of which may have an error."""

    @abstractmethod
    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures, into the folder `figures` of `out`, from the rows without error; data files, into `out`."""
