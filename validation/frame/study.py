"""The frame of every study: rows stage by stage, then numbers, tables and figures.

A study says what is to be made, what its rows mean and how to draw it; `validation.frame.runner.run` does the rest,
and goes on where it was when it is called again with the same folder.
"""

from abc import ABC, abstractmethod
from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, ClassVar

from validation.frame.limits import Limit
from validation.frame.request import Request

Row = dict[str, Any]
#: Yields the name and the requests of a stage, and is sent its rows.
Stages = Generator[tuple[str, Sequence[Request]], list[Row], None]


def of_text(value: object) -> bool:
    """Whether an option is one that the text of a command can give: a number, a word, or some of them."""
    plain = value if isinstance(value, tuple) else (value,)
    return bool(plain) and all(isinstance(one, int | float | str) for one in plain)


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

    @property
    def options(self) -> dict[str, Any]:
        """What its command was told: numbers, words, and lists of them."""
        told = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: value for name, value in told.items() if of_text(value)}

    @abstractmethod
    def stages(self, out: Path) -> Stages:
        """The stages, one after the other; later ones may need what earlier ones left in the folder `out`."""

    @abstractmethod
    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """What `results.json` says beside options and rows of the last stage, some of which may have an error."""

    @abstractmethod
    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures, into the folder `figures` of `out`, from the rows without error; data files, into `out`."""
