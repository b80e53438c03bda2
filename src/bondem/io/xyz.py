"""Import of spheres from XYZ, plain and extended (OVITO, ASE, LAMMPS)."""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from bondem._checks import shown
from bondem._types import Floats
from bondem.errors import InputError
from bondem.io.raw_spheres import (
    RawSpheres,
    announced_count,
    chosen_frame,
    floats,
    listed,
    numbered_lines,
    require_count,
    some_axes,
)

_Rows = list[tuple[int, list[str]]]
_SETTING = re.compile(r"(\w+)=(\"[^\"]*\"|\S+)")
# Names of the property of sizes in lower case, and the factor from size to radius.
_SIZES = {"radius": 1.0, "radii": 1.0, "diameter": 0.5}
_TRUE = ("t", "true", "1")


def read_xyz(
    path: Path, columns: Sequence[str | int] | None = None, *, size: str | float | None = None,
    diameters: bool = False, periodic: bool | None = None, frame: int = -1,
) -> RawSpheres:  # fmt: skip
    """Read the spheres of one snapshot in the order of the file.

    Args:
        path: the file. A snapshot is the number of atoms, a comment, and a line of name, x, y, z per atom. The
            comment of an extended file names its columns (Properties=) and may have a cell (Lattice=).
        columns: numbers from 0 of the columns of x, y, z and radius; those of a plain file have no names.
        size: one radius for all, or the property of radii in an extended file.
        diameters: True to halve the sizes of the file.
        periodic: True to use the cell as a periodic one; None does so if the comment states it (pbc=).
        frame: index of the snapshot, from 0; -1 is the last.

    Raises:
        InputError: no radii, no such snapshot, or an invalid line; the message states file and line.
    """
    line, comment, rows = chosen_frame(path, frame, _frames(path), f"'{path}' holds no atoms; write it again")
    said = {key.lower(): value.strip('"') for key, value in _SETTING.findall(comment)}
    chosen, share = _columns(path, line, said.get("properties"), columns, size)
    least = max(chosen) + 1
    table = []
    for number, words in rows:
        if len(words) < least:
            raise InputError(f"'{path}', line {number}: {len(words)} columns where {least} are needed; complete it")
        table.append(floats(path, number, [words[k] for k in chosen]))
    numbers = np.array(table)
    one = size if size is not None and not isinstance(size, str) else None
    share = 0.5 if diameters else share
    radius = np.full(len(numbers), float(one)) if one is not None else share * numbers[:, 3]
    period, partly = _period(path, line, said, periodic)
    return RawSpheres(numbers[:, :3], radius, period, partly=partly)


def _frames(path: Path) -> Iterator[tuple[int, str, _Rows]]:
    lines = list(numbered_lines(path))
    at = 0
    while at < len(lines):
        line, text = lines[at]
        count = announced_count(path, line, text, "atoms")
        # an empty comment is missing among the lines
        comment = lines[at + 1][1] if at + 1 < len(lines) and lines[at + 1][0] == line + 1 else ""
        skip = 2 if comment else 1
        rows = [(number, words.split()) for number, words in lines[at + skip : at + skip + count]]
        require_count(path, line, "atoms", count, len(rows))
        yield line + 1, comment, rows
        at += skip + count


def _columns(
    path: Path, line: int, properties: str | None, columns: Sequence[str | int] | None, size: str | float | None
) -> tuple[list[int], float]:
    """Return the columns of x, y, z and of any size, and the factor from size to radius."""
    number_given = size is not None and not isinstance(size, str)
    if columns is not None:
        numbers = [one for one in columns if isinstance(one, int) and not isinstance(one, bool) and 0 <= one < 10_000]
        if len(columns) != 4 or len(numbers) != 4:
            raise InputError(f"columns = {shown(columns)}; give four numbers from 0, of x, y, z and radius")
        return numbers, 1.0
    if properties is None:
        if number_given:
            return [1, 2, 3], 1.0
        raise InputError(
            f"'{path}', line {line}: an XYZ file without Properties= does not say where radii are; give columns="
            " (1, 2, 3, 4) if the fifth column has them, or radius= for all"
        )
    at, found = 0, dict[str, tuple[int, int]]()
    words = properties.split(":")
    for name, width in zip(words[::3], words[2::3], strict=False):
        if not width.isdecimal() or len(width) > 4:
            raise InputError(f"'{path}', line {line}: Properties={shown(properties)} is no list of name:type:columns")
        found[name.lower()] = at, int(width)
        at += int(width)
    if found.get("pos", (0, 0))[1] != 3:
        raise InputError(f"'{path}', line {line}: Properties= has no pos:R:3; add it")
    place = [found["pos"][0] + k for k in range(3)]
    if number_given:
        return place, 1.0
    for name in _SIZES if size is None else (str(size).lower(),):
        if name in found:
            return [*place, found[name][0]], _SIZES.get(name, 1.0)
    raise InputError(
        f"'{path}', line {line}: no property {size or 'radius'} among {listed(found)}; give radius= as the name of"
        " one, or as one radius for all"
    )


def _period(
    path: Path, line: int, said: dict[str, str], periodic: bool | None
) -> tuple[Floats | None, str]:
    """Return the edges of a fully periodic cell, (3,), or None, and the periodic axes of a partly periodic one."""
    borders = [border in _TRUE for border in said.get("pbc", "").lower().split()]
    partly = some_axes(borders) if periodic is not False else ""
    if partly or not (bool(borders) and all(borders) if periodic is None else periodic):
        return None, partly
    cell = np.array(floats(path, line, said.get("lattice", "").split()))
    if cell.shape != (9,) or np.any(cell.reshape(3, 3) - np.diag(cell[::4])):
        raise InputError(f"'{path}', line {line}: Lattice= is no cell with edges along the axes; leave pbc= out")
    return cell[::4], ""
