"""Spheres from a LAMMPS dump in text (`dump custom`), as LAMMPS, OVITO and `bd.export` write it."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.io.raw_spheres import (
    LAMMPS_UNITS,
    RawSpheres,
    announced_count,
    chosen_frame,
    floats,
    listed,
    numbered_lines,
    require_count,
    some_axes,
)

# Columns of coordinates, and whether they are fractions of the box.
_PLACES = (
    (("x", "y", "z"), False), (("xu", "yu", "zu"), False), (("xs", "ys", "zs"), True), (("xsu", "ysu", "zsu"), True),
)  # fmt: skip


@dataclass
class _Frame:
    """Snapshot of a dump: first line, units, and by ITEM its line number, the rest of its line and lines below it."""

    line: int
    units: list[tuple[int, str]]
    items: dict[str, tuple[int, str, list[tuple[int, str]]]] = field(default_factory=dict)


def read_dump(
    path: Path, *, size: str | float | None = None, periodic: bool | None = None, frame: int = -1
) -> RawSpheres:
    """Read the spheres of one snapshot, in the order of their ids if it has ids.

    Args:
        path: a text dump with columns x y z (also xu, xs or xsu) and radius or diameter.
        size: name of the column of radii, or one radius for all; None for the columns radius or diameter.
        periodic: True to use the box as a periodic cell, moved to the origin; None does so if all of its borders are
            periodic (pp) and it is not tilted.
        frame: index of the snapshot, from 0; -1 is the last.

    Raises:
        InputError: columns missing, no such snapshot, a tilted box, or a line that does not fit.
    """
    chosen = chosen_frame(path, frame, _frames(path))
    line, names, rows = chosen.items.get("ATOMS", (0, "", []))
    columns = names.split()
    announced, _, said = chosen.items.get("NUMBER OF ATOMS", (line, "", []))
    for number, text in said[:1]:
        require_count(path, announced, "atoms", announced_count(path, number, text, "atoms"), len(rows))
    if not columns or not rows:
        raise InputError(f"'{path}', line {chosen.line}: the snapshot has no ITEM: ATOMS with rows; write it again")
    table = np.array([_row(path, number, text, len(columns)) for number, text in rows])
    by_name = dict(zip(columns, table.T, strict=True))
    if "id" in by_name:
        if not np.isfinite(by_name["id"]).all():
            raise InputError(f"'{path}', line {line}: an id below is no number; write the snapshot again")
        order = np.argsort(by_name["id"], kind="stable")
        twice = np.flatnonzero(np.diff(by_name["id"][order]) == 0)
        if twice.size:
            raise InputError(f"'{path}' has two atoms of id {int(by_name['id'][order[twice[0]]])}; write it again")
        by_name = {name: values[order] for name, values in by_name.items()}
    lower, upper, borders, tilted = _box(path, chosen)
    closed = [border == "pp" for border in borders]
    partly = some_axes(closed) if periodic is not False else ""
    if periodic is None:
        periodic = all(closed) and not tilted
    if tilted and periodic:
        raise InputError(f"'{path}', line {chosen.line}: the box is tilted; a periodic cell here has right angles")
    place = _places(path, line, by_name, lower, upper, tilted=tilted)
    radius = _radii(path, line, by_name, size)
    period = upper - lower if periodic and not partly else None
    corner = lower if periodic or partly else np.zeros(3)
    unit = LAMMPS_UNITS.get(chosen.units[0][1]) if chosen.units else None
    return RawSpheres(place - corner, radius, period, unit=unit, partly=partly)


def _frames(path: Path) -> Iterator[_Frame]:
    found: _Frame | None = None
    units: list[tuple[int, str]] = []
    rows: list[tuple[int, str]] = []
    for line, text in numbered_lines(path):
        if not text.startswith("ITEM:"):
            rows.append((line, text))
            continue
        name, behind = _item(text.removeprefix("ITEM:").strip())
        rows = []
        if name == "TIMESTEP":
            if found is not None:
                yield found
            found = _Frame(line, units)
        elif name == "UNITS":
            units = rows  # once, at the beginning
        elif found is not None:
            found.items[name] = line, behind, rows
    if found is None:
        raise InputError(f"'{path}' has no ITEM: TIMESTEP; give a dump of LAMMPS in text")
    yield found


def _item(text: str) -> tuple[str, str]:
    for name in ("ATOMS", "BOX BOUNDS"):
        if text.startswith(name):
            return name, text.removeprefix(name).strip()
    return text, ""


def _row(path: Path, line: int, text: str, count: int) -> list[float]:
    words = text.split()
    if len(words) != count:
        raise InputError(f"'{path}', line {line}: {len(words)} columns where ITEM: ATOMS names {count}; correct it")
    return [_float(word) for word in words]


def _float(word: str) -> float:
    """Return a word as a number; NaN for others, such as chemical symbols, which are not used."""
    try:
        return float(word)
    except ValueError:
        return np.nan


def _box(path: Path, frame: _Frame) -> tuple[Floats, Floats, list[str], bool]:
    """Return lower and upper corner, (3,) each, the kinds of the borders, and True if the box is tilted."""
    line, behind, rows = frame.items.get("BOX BOUNDS", (frame.line, "", []))
    bounds = [floats(path, number, text.split()) for number, text in rows]
    if len(bounds) != 3 or any(len(row) < 2 for row in bounds):
        raise InputError(f"'{path}', line {line}: ITEM: BOX BOUNDS has no three lines of two numbers; write it again")
    borders = [word for word in behind.split() if word not in ("xy", "xz", "yz")]
    table = np.array([row[:2] for row in bounds])
    tilted = any(any(row[2:]) for row in bounds)
    return table[:, 0], table[:, 1], borders or ["ff"] * 3, tilted


def _places(
    path: Path, line: int, columns: dict[str, Floats], lower: Floats, upper: Floats, *, tilted: bool
) -> Floats:
    for names, scaled in _PLACES:
        if all(name in columns for name in names):
            place = np.column_stack([columns[name] for name in names])
            if not scaled:
                return place
            if tilted:
                raise InputError(f"'{path}', line {line}: the box is tilted; dump x y z instead of {' '.join(names)}")
            return lower + place * (upper - lower)
    raise InputError(f"'{path}', line {line}: no columns x y z among {listed(columns)}; dump them")


def _radii(path: Path, line: int, columns: dict[str, Floats], size: str | float | None) -> Floats:
    count = len(next(iter(columns.values())))
    if size is not None and not isinstance(size, str):
        return np.full(count, float(size))
    for name, share in (("radius", 1.0), ("diameter", 0.5)) if size is None else ((size, 1.0),):
        if name in columns:
            return columns[name] * (0.5 if name == "diameter" else share)
    raise InputError(
        f"'{path}', line {line}: no column {size or 'radius or diameter'} among {listed(columns)}; dump it, or give"
        " radius= as its name or as one radius for all"
    )
