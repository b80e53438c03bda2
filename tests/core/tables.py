"""Write what follows from the headers of the core: named tuples of Python, names and descriptions of C++.

`python -m tests.core.tables` writes `bondem/_tables/*.py`, `core/table_names.hpp` and `core/described_tables.hpp`;
a test compares them with the headers `core/tables/*.hpp`. A field is `Type name;  // what it is [unit], (n, 8)`: the
last parentheses are its shape, in symbols that mean one length in a call (n, m, …; * for any length). A table is a
struct with a comment above it. A struct with vectors is the row of a table, and has a description only. The generator
refuses anything else. What passes are for is written by `tests/core/passes.py`, which needs the compiled library. The
command also writes the lists of `tests/core/lists.py`.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from textwrap import wrap

from tests.core import lists

SOURCE = Path(__file__).resolve().parents[2] / "src/bondem"
COLUMNS = SOURCE / "core/tables/columns.hpp"
NUMBERS = {"double": "float", "Index": "int"}
ARRAYS = {"double": "Floats", "Index": "Ints", "Short": "Uint32s", "Byte": "Bytes", "uint8_t": "Bytes",
          "int32_t": "Int32s", "float": "Singles"}  # fmt: skip
# Members of a row, and their shapes.
VECTORS = {"Vector": "3", "Quaternion<double>": "4"}
STRUCT = re.compile(r"((?:^//[^\n]*\n)+)^struct (\w+) \{\n(.*?)^\};", re.DOTALL | re.MULTILINE)
FIELD = re.compile(r"(?P<type>[\w:]+(?:<[^>]*>)?) (?P<name>\w+);(?:\s*// ?(?P<words>.*))?$")
# A function of a table, which has one line.
METHOD = re.compile(r"[\w:<>& ]+\([^()]*\) const \{.*\}")
SHAPE = re.compile(r"\((?P<axes>[^()]*)\)$")
# A constant, and an enumeration, alone or in a namespace that names it; its members.
CONSTANT = re.compile(r"^constexpr Index (\w+) = (\d+);  // (.+)$", re.MULTILINE)
ENUM = re.compile(
    r"((?:^//[^\n]*\n)+)(?:namespace (\w+) \{\s+)?enum (\w* ?): \w+ \{(.*?)\};", re.DOTALL | re.MULTILINE
)
MEMBER = re.compile(r"(\w+)(?: = (\d+))?\s*(?:,|$)")
COUNT = re.compile(r"(\w+)::count")
AXIS = re.compile(r"\*|[a-z_]*(?: \+ \d+)?|\d+")


@dataclass(frozen=True)
class Field:
    """A field of a table.

    Attributes:
        name: name of the field.
        type: type in C++.
        words: comment without the shape.
        axes: lengths of the axes; None for a number.
    """

    name: str
    type: str
    words: str
    axes: tuple[str, ...] | None

    @property
    def python(self) -> str:
        """Type in Python."""
        return NUMBERS[self.type] if self.axes is None else ARRAYS[re.sub(r"const |Array<|, \d>", "", self.type)]

    @property
    def described(self) -> str:
        """Shape in the description of C++."""
        return VECTORS.get(self.type) or " ".join(axis.replace(" ", "") for axis in self.axes or ())

    @property
    def comment(self) -> str:
        """Comment of Python, with the shape."""
        axes = self.axes or ()
        shape = f"({axes[0]},)" if len(axes) == 1 else f"({', '.join(axes)})" if axes else ""
        return ", ".join(part for part in (self.words, shape) if part)


@dataclass(frozen=True)
class Table:
    """A table: its name, the lines of its comment and its fields."""

    name: str
    words: list[str]
    fields: list[Field]

    @property
    def is_row(self) -> bool:
        """True for a row of a table, which Python does not fill by itself."""
        return any(field.type in VECTORS for field in self.fields)


def tables(path: Path) -> Iterator[Table]:
    """Yield the tables of a header."""
    for words, name, body in STRUCT.findall(path.read_text()):
        yield Table(name, [line[2:].strip() for line in words.splitlines()], list(_fields(path, name, body)))


def _fields(path: Path, table: str, body: str) -> Iterator[Field]:
    above: list[str] = []
    for line in map(str.strip, body.splitlines()):
        if line.startswith("//"):
            above.append(line[2:].strip())
            continue
        if METHOD.fullmatch(line):
            above = []
            continue
        found = FIELD.fullmatch(line)
        if found is None:
            raise SystemExit(f"{path.name}: {table}: {line!r} is no field; write one field a line, with its shape")
        words = " ".join([*above, found["words"] or ""]).strip()
        above = []
        rank = re.search(r", (\d)>$", found["type"])
        if rank is None:
            yield Field(found["name"], found["type"], words, None)
            continue
        shape = SHAPE.search(words)
        axes = () if shape is None else tuple(axis.strip() for axis in shape["axes"].rstrip(",").split(","))
        axes = tuple(COUNT.sub(lambda one: str(enumerations()[one[1]][1]["count"]), axis) for axis in axes)
        if shape is None or len(axes) != int(rank[1]) or not all(AXIS.fullmatch(axis) for axis in axes):
            raise SystemExit(f"{path.name}: {table}.{found['name']}: {words!r} does not end with {rank[1]} axes")
        yield Field(found["name"], found["type"], words[: shape.start()].rstrip(" ,"), axes)


def _python(path: Path, found: list[Table]) -> str:
    used = sorted({field.python for table in found for field in table.fields} - set(NUMBERS.values()))
    title = f'"""Tables of `core/tables/{path.name}`, written by `python -m tests.core.tables` from the header."""'
    lines = [title, "", "from typing import NamedTuple", ""]
    if used:
        lines += [f"from bondem._types import {', '.join(used)}", ""]
    for table in found:
        first, *others = _wrapped(table.words)
        end = [*(f"    {line}".rstrip() for line in others), '    """'] if others else []
        lines += ["", f"class {table.name}(NamedTuple):", f'    """{first}' + ("" if others else '"""'), *end, ""]
        for one in table.fields:
            line = f"    {one.name}: {one.python}"
            if len(line) + len(one.comment) > 113:
                lines += [*(f"    #: {part}" for part in wrap(one.comment, 110)), line]
            else:
                lines.append(f"{line}  #: {one.comment}".removesuffix("  #: "))
        lines.append("")
    return "\n".join(lines)


def _wrapped(words: list[str]) -> list[str]:
    paragraphs = [wrap(part.replace("\n", " "), 114) for part in "\n".join(words).split("\n\n")]
    return [line for number, part in enumerate(paragraphs) for line in ([""] if number else []) + part]


@cache
def enumerations() -> dict[str, tuple[str, dict[str, int], dict[str, str]]]:
    """Return comment, members and their comments of each enumeration of `columns.hpp`, by its name."""
    found = {}
    for words, space, name, body in ENUM.findall(COLUMNS.read_text()):
        members, comments = {}, {}
        for line in body.splitlines() or [body]:
            code, _, comment = line.partition("//")
            last = None
            for member, value in MEMBER.findall(code.strip()):
                members[member] = int(value) if value else max(members.values(), default=-1) + 1
                last = member
            if last is not None and comment:
                comments[last] = comment.strip()
        text = " ".join(line[2:].strip() for line in words.splitlines())
        found[name.strip() or space] = text, members, comments
    return found


def _columns() -> str:
    lines = ['"""Numbers of `core/tables/columns.hpp`, written by `python -m tests.core.tables` from the header."""',
             "", "from enum import IntEnum", ""]  # fmt: skip
    lines += [f"{name.upper()} = {value}  #: {words}" for name, value, words in CONSTANT.findall(COLUMNS.read_text())]
    for name, (words, members, comments) in enumerations().items():
        title = name if name[0].isupper() else "".join(part.capitalize() for part in name.split("_"))
        first, *others = wrap(words, 110)
        end = [*(f"    {line}" for line in others), '    """'] if others else []
        lines += ["", "", f"class {title}(IntEnum):", f'    """{first}' + ("" if others else '"""'), *end, ""]
        for member, value in members.items():
            lines.append(f"    {member.upper()} = {value}  #: {comments.get(member, '')}".removesuffix("  #: "))
    return "\n".join([*lines, ""])


def _described(headers: list[Path], found: list[Table]) -> str:
    lines = ["// Descriptions of the fields of tables (`tables/*.hpp`), written by `python -m tests.core.tables`.",
             "#pragma once", '#include "described.hpp"', *(f'#include "tables/{path.name}"' for path in headers), "",
             "namespace bondem {", "", "#define F BONDEM_FIELD"]  # fmt: skip
    for table in found:
        inside = ", ".join(f'F({field.name}, "{field.described}")' for field in table.fields)
        lines.append(f"BONDEM_TABLE({table.name}, {inside})")
    every = [f"    described<{table.name}>()" for table in found]
    lines += ["#undef F", "", "#define BONDEM_TABLES \\", ", \\\n".join(every), "", "}  // namespace bondem", ""]
    return "\n".join(lines)


def _names(found: list[Table]) -> str:
    lines = ["// Names of all tables (`tables/*.hpp`), written by `python -m tests.core.tables`.", "#pragma once",
             "", "namespace bondem {", "", "template <class T> struct TableName;", "#define T(table) \\",
             "    struct table; \\",
             "    template <> struct TableName<table> { static constexpr const char *name = #table; };"]  # fmt: skip
    lines += [f"T({table.name})" for table in found]
    return "\n".join([*lines, "#undef T", "", "}  // namespace bondem", ""])


def written() -> dict[Path, str]:
    """Return every generated file and its text."""
    headers = sorted((SOURCE / "core/tables").glob("*.hpp"))
    made, every = lists.written(), []
    for path in headers:
        found = list(tables(path))
        every += found
        if filled := [table for table in found if not table.is_row]:
            made[SOURCE / "_tables" / f"{path.stem}.py"] = _python(path, filled)
    made[SOURCE / "_tables/columns.py"] = _columns()
    made[SOURCE / "_tables/__init__.py"] = '"""Tables of the core, written by `python -m tests.core.tables`."""\n'
    made[SOURCE / "core/table_names.hpp"] = _names(every)
    made[SOURCE / "core/described_tables.hpp"] = _described(headers, every)
    return made


def stale() -> list[Path]:
    """Return the generated files that differ from what the headers give."""
    files = written()
    left = set((SOURCE / "_tables").glob("*.py")) - set(files)
    return sorted(left) + [path for path, text in files.items() if not path.exists() or path.read_text() != text]


if __name__ == "__main__":
    (SOURCE / "_tables").mkdir(exist_ok=True)
    for old in stale():
        old.unlink(missing_ok=True)
    for new, text in written().items():
        new.write_text(text)
