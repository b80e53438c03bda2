"""Pages of prose whose numbers are measured: `book/texts`, in which `{{ subject.name }}` is a number of a record.

A measured number is named, and `book/quoted` says which record holds it. A number that was not measured is a literal
in braces, `{{ 30 }}`: an input, a size, a published value. Numbers in code, links and comments stay as they are.
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from jinja2 import Environment, StrictUndefined, TemplateError

from book.errors import BookError
from book.forms import PLAIN, Form, listed, seeds, spaced, span, text, worst
from book.results import ROOT, Measurement

TEXTS = Path(__file__).parent / "texts"
_FRONT_MATTER = re.compile(r"---\n.*?\n---\n", re.DOTALL)


@dataclass(frozen=True)
class Quoted:
    """A number that a page of prose quotes.

    Attributes:
        name: subject and name, as pages write it: "bars.work".
        says: quantity, as the page of all quoted numbers states it.
        size: size of what was measured: elements, packings, steps.
        record: measurement whose results hold the number.
        values: the number, or several of one kind.
        form: how it is printed.
        scatter: standard deviation over packings.
    """

    name: str
    says: str
    size: str
    record: Measurement
    values: tuple[float, ...]
    form: Form = PLAIN
    scatter: float | None = None

    @property
    def text(self) -> str:
        """The number; of several the least and the largest; with its scatter where that is known."""
        ends = [self.form.bare(value) for value in (min(self.values), max(self.values))]
        if ends[0] != ends[1]:
            return f"{ends[0]} to {self.form.text(max(self.values))}"
        return self.record.of(self.values[0], scatter=self.scatter).text(self.form)


@dataclass
class _Subject:
    """The numbers of a subject, by name; it notes which were asked for."""

    quoted: Mapping[str, Quoted]
    asked: set[str] = field(default_factory=set)

    def __getattr__(self, name: str) -> str:
        found = self.quoted.get(name)
        if found is None:
            raise AttributeError(name)
        self.asked.add(found.name)
        return found.text


def ceiling(value: float) -> float:
    """The least number of one digit that is not below a positive number: what a value "is within"."""
    power = 10.0 ** math.floor(math.log10(value))
    return math.ceil(value / power) * power


def templates() -> list[Path]:
    """The texts; the page of each has the same place in the repository as the text in its folder."""
    return sorted(TEXTS.rglob("*.md"))


def target(template: Path) -> Path:
    """The page that a text becomes."""
    return ROOT / template.relative_to(TEXTS)


def written(template: Path, quoted: Sequence[Quoted], words: Mapping[str, Any]) -> tuple[str, set[str]]:
    """A text with its numbers, and the names of those.

    Args:
        template: the text.
        quoted: all numbers that it may name.
        words: what else it may name.

    Raises:
        BookError: the text asks for a number that no file of `book/quoted` has, or it is no template.
    """
    parts: dict[str, dict[str, Quoted]] = {}
    for one in quoted:
        subject, _, name = one.name.partition(".")
        parts.setdefault(subject, {})[name] = one
    subjects = {name: _Subject(found) for name, found in parts.items()}
    text = rendered(template, {**words, **subjects})
    return _marked(text, template), set().union(*(subject.asked for subject in subjects.values()))


def rendered(template: Path, names: Mapping[str, Any]) -> str:
    """A text with its expressions worked out.

    Raises:
        BookError: the text names what is not there, or it is no template.
    """
    environment = Environment(
        undefined=StrictUndefined, keep_trailing_newline=True, autoescape=False, trim_blocks=True, lstrip_blocks=True
    )
    filters = (listed, seeds, spaced, span, text, worst)
    environment.filters |= {"style": format} | {one.__name__: one for one in filters}
    try:
        return environment.from_string(template.read_text(encoding="utf-8")).render(names)
    except TemplateError as error:
        where = "name it in book/quoted, or in the module of the chapter"
        raise BookError(f"{template.relative_to(ROOT)}: {error}; {where}") from None


def _marked(text: str, template: Path) -> str:
    """A page that says where it is edited, at its top or below its front matter."""
    front = _FRONT_MATTER.match(text)
    end = front.end() if front else 0
    comment = f"<!-- Written by `python -m book`; edit {template.relative_to(ROOT).as_posix()}, not this file. -->\n"
    return text[:end] + comment + text[end:]
