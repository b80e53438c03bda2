"""Every table of every pass refuses an array that does not fit, whatever is wrong with it and in whichever field."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from bondem import _core
from bondem._core import filled_table
from bondem.errors import InputError

LIBRARY = _core._library()
KINDS = [np.float64, np.float32, np.int64, np.uint32, np.int32, np.uint8, bool, complex, object]


def fitting(table: str, lengths: dict[str, int]) -> dict[str, Any]:
    """Arrays and numbers that a table takes, with the given lengths of its axes."""
    values: dict[str, Any] = {}
    for field in LIBRARY.tables[table]:
        shape = [lengths.setdefault(symbol, 3) + more if symbol else more for symbol, more in field.shape]
        values[field.name] = 1 if field.written is None else np.zeros(shape, field.dtype)
    return values


def faults(field: Any, right: np.ndarray, others: set[str]) -> Iterator[Any]:
    """Values that do not fit a field; `others` are the lengths that other fields fix."""
    yield None
    yield right.tolist()
    yield right[None]
    yield from (right.astype(kind) for kind in KINDS if np.dtype(kind) != field.dtype)
    scattered = np.zeros((*right.shape[:-1], 2 * right.shape[-1]), field.dtype)[..., ::2]
    if not scattered.flags.c_contiguous:
        yield scattered
    for axis, (symbol, _) in enumerate(field.shape):
        if symbol == "" or symbol in others:  # else no other array has this length
            yield np.zeros([size + (k == axis) for k, size in enumerate(right.shape)], field.dtype)
    if field.written:
        fixed = right.copy()
        fixed.setflags(write=False)
        yield fixed


def shared_lengths(table: str, name: str) -> set[str]:
    return {symbol for field in LIBRARY.tables[table] if field.name != name for symbol, _ in field.shape} - {"", "*"}


@pytest.mark.parametrize("table", sorted(LIBRARY.tables))
def test_arrays_that_do_not_fit_are_refused(table):
    lengths: dict[str, int] = {}
    right, fields = fitting(table, lengths), LIBRARY.tables[table]
    filled_table(table, fields, tuple(right.values()), {})
    for field in fields:
        if field.written is None:
            continue
        for wrong in faults(field, right[field.name], shared_lengths(table, field.name)):
            with pytest.raises(InputError, match=f"{table}.{field.name} = |an axis has to be"):
                filled_table(table, fields, tuple({**right, field.name: wrong}.values()), {})


@pytest.mark.parametrize("name", sorted(LIBRARY.passes) + sorted(LIBRARY.step_passes))
def test_tables_of_one_pass_agree_on_their_lengths(name):
    """A symbol is one length in all tables of a call, so that an index of one table is valid in another."""
    tables = LIBRARY.passes[name][1] if name in LIBRARY.passes else LIBRARY.step_passes[name][1]
    lengths: dict[str, int] = {}
    right = [fitting(table, lengths) for table in tables]
    used = [{symbol for field in LIBRARY.tables[table] for symbol, _ in field.shape} - {"", "*"} for table in tables]
    for second in range(1, len(tables)):
        for symbol in used[second] & set.union(*used[:second]):
            known: dict[str, tuple[int, str]] = {}
            for table, values in zip(tables[:second], right[:second], strict=True):
                filled_table(table, LIBRARY.tables[table], tuple(values.values()), known)
            longer = fitting(tables[second], {**lengths, symbol: 4})
            with pytest.raises(InputError, match="an axis has to be"):
                filled_table(tables[second], LIBRARY.tables[tables[second]], tuple(longer.values()), known)
