"""Import of spheres and bonds from a LAMMPS data file (`read_data`, `write_data`)."""

import re
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from bondem._types import Pairs
from bondem.errors import InputError
from bondem.io.raw_spheres import LAMMPS_UNITS, RawSpheres, announced_count, floats, numbered_lines, require_count

# Columns of the diameter and of x by atom style; three image flags may follow z.
_STYLES = {"sphere": (2, 4), "bpm/sphere": (3, 5)}
_SECTION = re.compile(r"[A-Z][A-Za-z]*( [A-Z][A-Za-z]*)*$")
# Texts of the first line, a comment: a mark of bd.export, and units and step of write_data.
STRAINED = "of a strained state"
_UNITS, _STEP = re.compile(r"\bunits(?: =)? (\w+)"), re.compile(r"\btimestep = (\d+)")
_Lines = list[tuple[int, str]]


def read_lammps(path: Path, *, periodic: bool = False) -> RawSpheres:
    """Read the spheres of a LAMMPS data file in the order of their ids, with bonds if present.

    Args:
        path: data file of atom_style sphere or bpm/sphere.
        periodic: True to use the box as a periodic cell, moved to the origin. The file does not state this; in LAMMPS
            the command `boundary` does.

    Raises:
        InputError: another atom style, or an invalid line; the message states file and line.
    """
    title, head, sections = _sections(path)
    atoms = sections.get("Atoms")
    if atoms is None:
        raise InputError(f"'{path}' has no section Atoms; give a LAMMPS data file (write_data)")
    place, hint, lines = atoms
    if not lines:
        raise InputError(f"'{path}', line {place}: the section Atoms is empty; write the data file again")
    size, first = _style(path, place, hint, lines)
    ids, rows = [], []
    for line, text in lines:
        words = text.split()
        if len(words) < first + 3:
            raise InputError(f"'{path}', line {line}: {len(words)} columns where {first + 3} are needed; complete it")
        row = floats(path, line, [words[0], *words[first : first + 3], words[size]])
        if row[-1] <= 0.0:
            raise InputError(f"'{path}', line {line}: diameter {row[-1]:g}; elements need a positive one")
        ids.append(int(row[0]))
        rows.append(row[1:])
    bonds = sections["Bonds"][2] if "Bonds" in sections else []
    _require_counts(path, head, {"atoms": len(rows), "bonds": len(bonds)})
    order = np.argsort(ids, kind="stable")
    table, known = np.array(rows)[order], np.array(ids)[order]
    twice = np.flatnonzero(np.diff(known) == 0)
    if twice.size:
        raise InputError(f"'{path}' has two atoms of id {known[twice[0]]}; number them anew (reset_atoms id)")
    lower, period = _box(path, head) if periodic else (np.zeros(3), None)
    pairs, strained = None, ""
    if "Bonds" in sections:
        pairs = _bonds(path, bonds, known)
        strained = _strained(path, title, sections["Velocities"][2] if "Velocities" in sections else ())
    units = _UNITS.search(title)
    unit = LAMMPS_UNITS.get(units[1]) if units else None
    return RawSpheres(table[:, :3] - lower, 0.5 * table[:, 3], period, pairs, unit, strained)


def _require_counts(path: Path, head: _Lines, found: dict[str, int]) -> None:
    """Reject a file whose sections do not have the numbers of its header, such as "2187 atoms"."""
    for line, text in head:
        count, _, what = text.partition(" ")
        if what.strip() in found:
            require_count(path, line, what, announced_count(path, line, count, what), found[what.strip()])


def _strained(path: Path, title: str, velocities: Iterable[tuple[int, str]]) -> str:
    """Return the reason why bonds may be strained, or an empty text: LAMMPS files have no rest lengths."""
    if STRAINED in title:
        return "bd.export wrote it of a state with displacements"
    step = _STEP.search(title)
    if step and step[1].strip("0"):
        return f"it is of timestep {step[1][:18]}"
    if any(any(floats(path, line, text.split()[1:])) for line, text in velocities):
        return "its elements have velocities, which are not read"
    return ""


def _sections(path: Path) -> tuple[str, _Lines, dict[str, tuple[int, str, _Lines]]]:
    """Split a file into first line, header, and sections by name: line number, comment and lines of each."""
    title = ""
    head: _Lines = []
    sections: dict[str, tuple[int, str, _Lines]] = {}
    current = head
    for line, text in numbered_lines(path):
        title = text if line == 1 else title
        plain, _, comment = text.partition("#")
        plain = plain.strip()
        if line > 1 and _SECTION.match(plain):
            current = []
            sections[plain] = (line, comment.strip(), current)
        elif plain and line > 1:
            current.append((line, plain))
    return title, head, sections


def _style(path: Path, place: int, hint: str, lines: _Lines) -> tuple[int, int]:
    if hint in _STYLES:
        return _STYLES[hint]
    if not hint:
        # Without the comment that LAMMPS itself writes, the number of columns decides, image flags or not.
        count = len(lines[0][1].split())
        for columns in _STYLES.values():
            if count in (columns[1] + 3, columns[1] + 6):
                return columns
    raise InputError(
        f"'{path}', line {place}: atom style '{hint or 'unknown'}' has no known column of diameters; write the"
        " file with atom_style sphere or bpm/sphere ('Atoms # sphere')"
    )


def _box(path: Path, head: _Lines) -> tuple[np.ndarray, np.ndarray]:
    lower, upper = np.zeros(3), np.full(3, np.nan)
    for line, text in head:
        words = text.split()
        for k, axis in enumerate("xyz"):
            if words[2:] == [f"{axis}lo", f"{axis}hi"]:
                lower[k], upper[k] = floats(path, line, words[:2])
        if words[3:] == ["xy", "xz", "yz"] and any(floats(path, line, words[:3])):
            raise InputError(f"'{path}', line {line}: the box is tilted; a periodic cell here has right angles")
    if np.isnan(upper).any():
        raise InputError(f"'{path}' does not give xlo xhi, ylo yhi and zlo zhi; leave out periodic=True or add them")
    return lower, upper - lower


def _bonds(path: Path, lines: Iterable[tuple[int, str]], known: np.ndarray) -> Pairs:
    pairs = []
    for line, text in lines:
        words = text.split()
        if len(words) < 4:
            raise InputError(f"'{path}', line {line}: a bond is given by id, type and two atoms; complete it")
        ends = np.array([int(one) for one in floats(path, line, words[2:4])])
        at = np.searchsorted(known, ends)
        missing = ends[(at >= len(known)) | (known[np.minimum(at, len(known) - 1)] != ends)]
        if missing.size:
            raise InputError(f"'{path}', line {line}: there is no atom {missing[0]} to bond; remove the bond")
        pairs.append(at)
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)
