"""Representations of objects with units: at most twelve lines on a terminal, a table in a notebook.

`describe` gives public classes a `__repr__` and a `_repr_html_` made from their docstrings: the section "Attributes"
names the quantities and their units. This module imports the standard library only, as `import bondem` does.
"""

import html
import inspect
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

#: Largest number of lines of a representation, and of characters of a line.
LINES, WIDTH = 12, 118
# Largest number of characters of a value, and of numbers of a tuple that are written out.
_SHORT, _FEW = 96, 6
_ENTRY = re.compile(r"^    (\w+(?:, \w+)*): (.*)$")
_UNIT = re.compile(r"\[((?:[^\[\]]*[A-Za-zµΩ°%·/³²-][^\[\]]*))\]")


def _extent(shape: Any) -> str:
    """Format the extents of a shape along x, y and z [m]."""
    a, b, c = shape.bounds[1] - shape.bounds[0]
    return f"{a:.4g} × {b:.4g} × {c:.4g} m"


# Short descriptions of objects of some classes.
_HEADLINES: dict[str, Callable[[Any], str]] = {
    "Particles": lambda o: f"{len(o)} spheres of mean radius {o.mean_radius:.4g} m" + _in_shape(o),
    "Lattice": lambda o: (
        f"{len(o.particles)} {o.elements.name}, {len(o.pairs)} {o.elements.bond_name},"
        f" coordination number {o.coordination_number:.3g}"
    ),
    "Model": lambda o: f"{len(o.lattice.particles)} elements, {len(o.lattice.pairs)} bonds",
    "State": lambda o: (
        f"{len(o.pose)} elements, {len(o.integrity)} bonds ({int((o.integrity == 0.0).sum())} broken)"
        f" at t = {o.time:.4g} s, step {o.step}"
    ),
    "History": lambda o: f"{len(o.time)} records from {o.time[0]:.4g} to {o.time[-1]:.4g} s",
    "BrokenBonds": lambda o: f"{len(o)} broken bonds",
    "Fragments": lambda o: f"{len(o.mass)} fragments",
    "Cracking": lambda o: f"{o.mode}: {o.pieces} {'piece' if o.pieces == 1 else 'pieces'}",
    "Placed": _extent, "Joined": _extent, "Overlap": _extent, "Cut": _extent,
}  # fmt: skip
# Properties of these classes are more informative than their attributes.
_SHOWN: dict[str, tuple[str, ...]] = {
    "State": ("displacement", "velocity", "angular_velocity", "bond_integrity", "contacts", "wall_force"),
    "Model": ("bond", "density", "failure", "boundary", "contact", "walls"),
    "BrazilianTest": ("peak", "tension", "E", "work", "centre", "factor", "half_angle", "cracking", "test"),
    "SphereImpact": ("damage", "peak", "restitution", "velocity", "broken", "momentum", "residual", "run"),
    "SphereCrushing": ("peak", "force", "work", "broken", "asymmetry", "residual", "run"),
    "SpallTest": ("peak", "pull_back", "highest", "place", "first", "lengths", "residual", "run"),
    "TriaxialTest": ("peak", "deviator", "pressure", "E", "work", "cracking", "test"),
}


def describe(public: Mapping[str, Iterable[str]]) -> None:
    """Give a representation to the public classes of all modules imported so far.

    Args:
        public: names of public classes and functions by module.
    """
    for module, names in public.items():
        if module in sys.modules and module not in _done:
            _done.add(module)
            for name in names:
                _represent(getattr(sys.modules[module], name, None))


_done: set[str] = set()


def _represent(cls: object) -> None:
    """Give representations to a class and its subclasses that lack their own; exceptions and protocols get none."""
    if not isinstance(cls, type) or issubclass(cls, BaseException) or getattr(cls, "_is_protocol", False):
        return
    for one in (cls, *cls.__subclasses__()):
        if "_repr_html_" in vars(one):
            continue
        if one.__repr__ is object.__repr__ or _is_generated(vars(one).get("__repr__")):
            setattr(one, "__repr__", as_text)  # noqa: B010  a method, for type checkers
        setattr(one, "_repr_html_", as_html)  # noqa: B010
        if one is not cls:
            _represent(one)


def _is_generated(method: object) -> bool:
    """Return True if a representation is the one that dataclasses write."""
    code = getattr(inspect.unwrap(method), "__code__", None) if callable(method) else None
    return code is not None and code.co_filename == "<string>"


def as_text(thing: object) -> str:
    """Return a representation of at most twelve lines: one line for a small object, else one line per quantity."""
    name, rows = type(thing).__name__, _rows(thing)
    simple = [f"{row.name}={row.value}{row.unit}" for row in rows if row.value != "None"]
    line = f"{name}({', '.join(simple)})"
    if name not in _HEADLINES and all(row.simple for row in rows) and len(line) <= WIDTH:
        return line
    lines = [_title(thing), *(f"  {row.name}: {row.value}{row.unit}" for row in rows)]
    if len(lines) > LINES:
        rest = ", ".join(row.name for row in rows[LINES - 2 :])
        lines = [*lines[: LINES - 1], f"  and {rest}"]
    return "\n".join(one if len(one) <= WIDTH else f"{one[: WIDTH - 1]}…" for one in lines)


def as_html(thing: object) -> str:
    """Return an HTML table of the quantities, their values and their meaning, for notebooks."""
    described = _described(type(thing))
    cells = "".join(
        f"<tr><th style='text-align:left'>{html.escape(row.name)}</th>"
        f"<td style='text-align:left'>{html.escape(row.value + row.unit)}</td>"
        f"<td style='text-align:left'>{html.escape(described.get(row.name, ''))}</td></tr>"
        for row in _rows(thing)
    )
    return (
        f"<table><caption style='text-align:left'><b>{html.escape(_title(thing))}</b></caption>"
        f"<tbody>{cells}</tbody></table>"
    )


class _Row:
    """Quantity of an object, as a row of its representation.

    Attributes:
        name: name of the attribute.
        value: value as text.
        unit: unit with a blank before it, or an empty text.
        simple: True if the text is the complete value.
    """

    def __init__(self, name: str, value: object, meaning: str) -> None:
        self.name = name
        self.value, self.simple = _summary(value)
        units = _UNIT.findall(meaning) or ["-"]
        several = hasattr(value, "dtype") and len(set(units)) > 1  # columns of different units
        numeric = isinstance(value, int | float) or hasattr(value, "dtype") or self.value.startswith("(")
        shown = numeric and not several and not isinstance(value, bool) and units[0] != "-"
        self.unit = f" {units[0]}" if shown else ""


def _rows(thing: object) -> list[_Row]:
    kind, described = type(thing), _described(type(thing))
    names = _SHOWN.get(kind.__name__)
    if names is None:
        names = tuple(one.name for one in fields(thing)) if is_dataclass(thing) else _attributes(kind)
        names = tuple(one for one in names if not one.startswith("_"))
    found = []
    for name in names:
        try:
            value = getattr(thing, name)
        except Exception:
            continue
        if not callable(value) or is_dataclass(value):
            found.append(_Row(name, value, described.get(name, "")))
        else:
            found.append(_Row(name, getattr(value, "__name__", type(value).__name__), ""))
    return found


def _title(thing: object) -> str:
    """Return the name of the class and, if it has one, the headline of the object."""
    name = type(thing).__name__
    headline = _HEADLINES.get(name)
    try:
        return f"{name}: {headline(thing)}" if headline is not None else name
    except Exception:
        return name


def _summary(value: object) -> tuple[str, bool]:
    """Return a value in one line, and True if the line is complete."""
    if value is None or isinstance(value, bool | int | str):
        text = repr(value) if isinstance(value, str) else str(value)
        return (text, True) if len(text) <= _SHORT else (f"{text[: _SHORT - 1]}…", False)
    if isinstance(value, float):
        return f"{value:.6g}", True
    if hasattr(value, "shape") and hasattr(value, "dtype"):
        return _of_array(value)
    if isinstance(value, Mapping):
        return f"{len(value)} of {', '.join(map(_brief, value))}"[:_SHORT] if value else "none", not value
    if isinstance(value, tuple | list):
        return _of_several(value)
    text = _brief(value)
    return text, "\n" not in repr(value) and text == repr(value)


def _brief(value: object) -> str:
    """Return a text unchanged, else the first line of the representation, or the class if that line is long."""
    if isinstance(value, str):
        return value
    text = repr(value).split("\n", 1)[0]
    return text if len(text) <= _SHORT else f"{type(value).__name__}(…)"


def _of_several(values: tuple[Any, ...] | list[Any]) -> tuple[str, bool]:
    if not values:
        return "()", True
    if len(values) <= _FEW and all(isinstance(one, bool | int | float | str) for one in values):
        return f"({', '.join(_summary(one)[0] for one in values)})", True
    if all(isinstance(one, int | float) for one in values):
        return f"{len(values)} numbers, {min(values):.4g} … {max(values):.4g}", False
    if all(isinstance(one, tuple | list) for one in values):
        return f"{len(values)} rows", False
    kinds: dict[str, int] = {}
    for one in values:
        kinds[type(one).__name__] = kinds.get(type(one).__name__, 0) + 1
    return ", ".join(f"{count} {name}" for name, count in kinds.items())[:_SHORT], False


def _of_array(value: Any) -> tuple[str, bool]:
    shape = tuple(value.shape)
    if not shape:
        return f"{value.item():.6g}" if value.dtype.kind in "fiu" else str(value.item()), True
    text = f"shape {shape}"
    if value.size == 0 or value.dtype.kind not in "fiub":
        return text, False
    if value.dtype.kind == "b":
        return f"{text}, {int(value.sum())} of {value.size} True", False
    if len(shape) == 1 and shape[0] <= _FEW:
        return f"({', '.join(f'{one:.4g}' for one in value.tolist())})", True
    finite = value[value == value]
    if not finite.size:
        return f"{text}, all NaN", False
    return f"{text}, {finite.min():.4g} … {finite.max():.4g}", False


def _in_shape(particles: Any) -> str:
    return "" if particles.shape is None else f" in {_brief(particles.shape)}"


@cache
def _described(cls: type) -> dict[str, str]:
    """Return the meaning of each attribute, with its unit, from the docstrings of a class and its base classes."""
    found: dict[str, str] = {}
    for one in cls.__mro__[:-1]:
        for name, text in _entries(inspect.cleandoc(one.__doc__ or "")):
            found.setdefault(name, text)
        for name, thing in vars(one).items():
            text = (getattr(thing, "__doc__", "") or "").split("\n", 1)[0] if hasattr(thing, "fget") else ""
            if text:
                found.setdefault(name, text)
    return found


def _attributes(cls: type) -> tuple[str, ...]:
    """Return the names in the section "Attributes" of the docstrings of a class and its base classes."""
    return tuple(name for one in cls.__mro__[:-1] for name, _ in _entries(inspect.cleandoc(one.__doc__ or "")))


def _entries(doc: str) -> Iterable[tuple[str, str]]:
    """Yield names and texts of the section "Attributes" of a docstring."""
    inside, names, text = False, "", ""
    for line in [*doc.split("\n"), ""]:
        entry = _ENTRY.match(line) if inside else None
        if inside and line.startswith("        "):
            text += " " + line.strip()
            continue
        yield from ((name, text) for name in names.split(", ") if name)
        names, text = entry.groups() if entry else ("", "")
        inside = line == "Attributes:" or (inside and entry is not None)
