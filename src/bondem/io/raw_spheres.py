"""Spheres as a text file has them, and what readers of text files have in common."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from bondem._types import Floats, Pairs, PerElement, PerElement3
from bondem.errors import InputError
from bondem.io.text_file import encoding_of

#: Length of the unit systems of LAMMPS [m]; "lj" has none.
LAMMPS_UNITS = {
    "si": 1.0, "cgs": 1e-2, "micro": 1e-6, "nano": 1e-9, "real": 1e-10, "metal": 1e-10, "electron": 5.29177210903e-11,
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class RawSpheres:
    """What a file says, in its own unit of length.

    Attributes:
        position: centres, shape (n, 3).
        radius: radii, shape (n,).
        period: edge lengths of its periodic cell, or None.
        pairs: elements i, j of its bonds, shape (m, 2), or None where the format has none.
        unit: its unit of length [m], or None where the file does not say.
        strained: sign that its bonds are not at rest, or an empty text.
    """

    position: PerElement3
    radius: PerElement
    period: Floats | None = None
    pairs: Pairs | None = None
    unit: float | None = None
    strained: str = ""


def numbered_lines(path: Path) -> Iterator[tuple[int, str]]:
    """The lines of a text file that are not empty, stripped, with their numbers from 1."""
    try:
        with open(path, encoding=encoding_of(path)) as file:
            for number, line in enumerate(file, start=1):
                if stripped := line.strip():
                    yield number, stripped
    except UnicodeDecodeError:
        raise InputError(f"'{path}' is not a text file; give spheres in a format its suffix stands for") from None


def floats(path: Path, line: int, words: Sequence[str]) -> list[float]:
    """Words of a line as finite numbers.

    Raises:
        InputError: one is not, naming file and line.
    """
    found = []
    for word in words:
        try:
            found.append(float(word))
        except ValueError:
            raise InputError(f"'{path}', line {line}: '{word}' is not a number; correct or remove the line") from None
        if not math.isfinite(found[-1]):
            raise InputError(f"'{path}', line {line}: {word} is not finite; correct or remove the line")
    return found
