"""Contents of a surface file, common to all formats."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bondem._types import Floats, Ints


class Contents(NamedTuple):
    """Triangles of a surface file, and the parts that the file names.

    Attributes:
        vertices: corners in the unit of the file, (v, 3).
        triangles: three corners each, (t, 3).
        named: triangles of each solid, group or object that has a name of its own.
        unit: unit of length [m]; None where the file states none.
    """

    vertices: Floats
    triangles: Ints
    named: dict[str, Ints]
    unit: float | None = None


def by_name(names: Sequence[str]) -> dict[str, Ints]:
    """Return the triangles of each name in the order of the file, given the name of each triangle, "" for none.

    A single name for all triangles is left out.
    """
    known = list(dict.fromkeys(names))
    if len(known) < 2:
        return {}
    number = {name: k for k, name in enumerate(known)}
    label = np.array([number[name] for name in names])
    return {name: np.flatnonzero(label == number[name]) for name in known if name}


def name_of(text: bytes) -> str:
    """Return a name of unknown encoding as text: UTF-8, else Latin-1, which has a letter for every byte."""
    try:
        return text.decode("utf-8").strip()
    except UnicodeDecodeError:
        return text.decode("latin-1").strip()
