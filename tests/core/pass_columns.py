"""Columns of elements that the passes of a step declare, behind their definition (`core/registered.hpp`).

The declaration is text: uses with names of columns, "own swelling; writes pose.stress". A column is a field of one of
the tables of the pass, with its table where two of them have such a field (`StepBlocks.sums`). `pose.stress` is the
column of a pose that holds the stress of a cell, and `pose` the others.
"""

from functools import cache

import numpy as np

from bondem import _core
from bondem._core import pass_tables

#: Uses in their order, and their words.
USES = {
    "own": "reads {} of an element",
    "ends": "reads {} at both ends",
    "around": "reads {} at both ends and at their neighbours",
    "still": "reads {} at both ends, of elements that are postponed",
    "energy": "reads {} at both ends, for the energy of an event",
    "adds": "adds {} to elements",
    "changes": "changes {} of an element",
    "writes": "writes {} of an element",
}
#: First axes of columns of elements, `*` for some of them. Columns of bonds are not declared: ranks that share a bond
#: compute the same for it.
OF_ELEMENTS = {"n", "sums", "rows", "supports", "layered", "halves", "*"}


@cache
def columns_of(name: str) -> dict[str, tuple[str, ...]]:
    """Return the columns of elements that a pass declares, as `Moving.motion` or `Moving.pose.stress`, by their use.

    What it changes it reads of its own element and writes.

    SystemExit for a use or a column that does not exist, a column of bonds, or one that a header lets nobody write.
    """
    known, written = _known(pass_tables("steps")[name])
    found: dict[str, tuple[str, ...]] = {}
    for part in filter(None, _core.declared_columns(name).split("; ")):
        use, *columns = part.split()
        for column in columns:
            if use not in USES or len(known.get(column, [])) != 1:
                raise SystemExit(f"{name}: {use} {column}: not a use and one column of elements of its tables")
            if use in ("adds", "changes", "writes") and known[column][0] not in written:
                raise SystemExit(f"{name}: {use} {column}: the header declares it as read only")
        found[use] = tuple(known[column][0] for column in columns)
    if list(found) != [use for use in USES if use in found] or not all(found.values()):
        raise SystemExit(f"{name}: declare {', '.join(USES)} in this order")
    changed = found.pop("changes", ())
    merged = found | {use: (*found.get(use, ()), *changed) for use in ("own", "writes")}
    return {use: merged[use] for use in USES if merged.get(use)}


def words_of(name: str) -> str:
    """Return the declaration of a pass as words; empty for a pass that declares nothing."""
    columns_of(name)
    parts = [part.split() for part in filter(None, _core.declared_columns(name).split("; "))]
    said = "; ".join(USES[use].format(", ".join(f"`{one}`" for one in columns)) for use, *columns in parts)
    return f"{said[:1].upper()}{said[1:]}"


def _known(tables: tuple[str, ...]) -> tuple[dict[str, list[str]], set[str]]:
    """Return the columns of elements of tables by the names that may stand for them, and which may be written."""
    known: dict[str, list[str]] = {}
    written = set()
    for table in dict.fromkeys(tables):
        for field in _core._library().tables[table]:
            if field.written is None or field.shape[0][0] not in OF_ELEMENTS or field.dtype == np.int64:
                continue
            full = f"{table}.{field.name}"
            for one in (full, f"{full}.stress") if field.name == "pose" else (full,):
                known.setdefault(one.partition(".")[2], []).append(one)
                known[one] = [one]
                written |= {one} if field.written else set()
    return known, written
