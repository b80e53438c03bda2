"""Every table of every pass refuses a value that does not fit, whatever is wrong with it and in whichever field."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from bondem import _core
from bondem._core import filled_table
from bondem.errors import InputError

LIBRARY = _core._library()
# Numbers that are none; those of arrays are the caller's to check.
NUMBERS = [None, "1", [1], np.ones(1), np.array(1.0), 1j, float("nan"), np.nan, np.datetime64(1, "s"), 10**400]
KINDS = [np.float64, np.float32, np.int64, np.uint32, np.int32, np.uint8, bool, complex, object]


# Tables of each pass, of every kind of pass.
PASSES = {
    **{name: one[1] for kind in (LIBRARY.passes, LIBRARY.step_passes) for name, one in kind.items()},
    **LIBRARY.index_passes,
}


def fitting(table: str, lengths: dict[str, int]) -> dict[str, Any]:
    """Arrays and numbers that a table takes, with the given lengths of its axes."""
    values: dict[str, Any] = {}
    for field in LIBRARY.tables[table]:
        shape = [lengths.setdefault(symbol, 3) + more if symbol else more for symbol, more in field.shape]
        values[field.name] = 1 if field.written is None else np.zeros(shape, field.dtype)
    return values


def faults(field: Any, right: Any, others: set[str]) -> Iterator[Any]:
    """Values that do not fit a field; `others` are the lengths that other fields fix."""
    if field.written is None:
        yield from NUMBERS
        if field.dtype == np.int64:
            yield from (1.0, np.float64(2.0), 2**63, -(2**63) - 1, np.uint64(2**63))
        return
    yield None
    yield right.tolist()
    yield right[None]
    yield from (right.astype(kind) for kind in KINDS if np.dtype(kind) != field.dtype)
    scattered = np.zeros((*right.shape[:-1], 2 * right.shape[-1]), field.dtype)[..., ::2]
    if not scattered.flags.c_contiguous:
        yield scattered
    if field.dtype.itemsize > 1:
        yield np.frombuffer(bytearray(right.nbytes + 1), np.uint8)[1:].view(field.dtype).reshape(right.shape)
        yield right.astype(field.dtype.newbyteorder())
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
        for wrong in faults(field, right[field.name], shared_lengths(table, field.name)):
            with pytest.raises(InputError, match=f"{table}.{field.name} = |an axis has to be"):
                filled_table(table, fields, tuple({**right, field.name: wrong}.values()), {})
    for values in (tuple(right.values())[:-1], (*right.values(), 1)):
        with pytest.raises(InputError, match=f"{table}: {len(values)} values; pass {len(fields)}"):
            filled_table(table, fields, values, {})


@pytest.mark.parametrize("name", sorted(PASSES))
def test_tables_of_one_pass_agree_on_their_lengths(name):
    """A symbol is one length in all tables of a call, so that an index of one table is valid in another."""
    tables = PASSES[name]
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
