"""Loading of the core, a library of compiled passes, and calls of passes with tables.

`core/` contains the C++ sources; installing bondem compiles them (`_core_build.py`). This module loads the library
for this CPU: the highest level of instructions that the CPU offers, or the one that BONDEM_ISA names ("v2", "v3",
"v4"). In a source tree without a library of exactly the present sources, it compiles them first. BONDEM_CORE names
another library, such as one with sanitizers.

A pass takes tables, named tuples of arrays and numbers. The C++ headers declare them, `bondem._tables` is written
from these headers, and `bondem._passes` has a function for each pass of the library. A call compares the tables with
the description of the library, and checks type, contiguity and lengths of the arrays. Passes check no arrays again.
"""

import ctypes
import functools
import os
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem._core_build import LIBRARIES, LOOPS, PROBE, SOURCES, Platform, compile_core, source_digest
from bondem._core_fields import Field, filled_table
from bondem._core_functions import address_of
from bondem._lock import alone
from bondem._passes import Call
from bondem.errors import InputError

__all__ = [
    "bound_pass", "checked_fields", "compiled_level", "core_lanes", "declared_columns", "filled_table", "index_loop",
    "pass_tables", "row_type", "run_pass", "step_pass", "table_fields", "with_room",
]  # fmt: skip

# Longest delay until another process has compiled the core [s].
_PATIENCE = 300.0
# Bytes of a number, of a pointer, and of the length of an axis.
_WORD = 8


# ---- the library


def _is_source_tree() -> bool:
    """Return True in a checkout, whose sources may change, and False for an installed wheel."""
    return (SOURCES.parents[2] / "hatch_build.py").is_file()


def _found(name: str, suffix: str, digest: str = "*") -> Path | None:
    """Return the path of the newest compiled library of a name, or None if there is none."""
    made = list((SOURCES / LIBRARIES).glob(f"{name}.{digest}{suffix}"))
    return max(made, key=lambda path: path.stat().st_mtime_ns, default=None)


def _compiled(target: Platform, name: str) -> Path:
    """Return a library compiled from the present sources.

    Raises:
        ImportError: No library exists, and none can be compiled.
    """
    if not _is_source_tree():
        found = _found(name, target.suffix)
        if found is None:
            raise ImportError(
                f"bondem was installed without the library {name}{target.suffix} of its core: install a wheel for"
                " this machine, or install bondem from its sources"
            )
        return found
    digest = source_digest()
    found = _found(name, target.suffix, digest)
    if found is not None:
        return found
    with alone(SOURCES / LIBRARIES / "lock", patience=_PATIENCE):
        found = _found(name, target.suffix, digest)
        if found is not None:
            return found
        print(f"bondem: compiling its core ({name}), whose sources have changed", file=sys.stderr)
        try:
            return compile_core(target, [name])[0]
        except (RuntimeError, OSError) as error:  # OSError: the folder of the sources is not writable
            raise ImportError(f"bondem's core cannot be compiled: {error}") from None


def _level(target: Platform) -> str:
    """Return the level of instructions to use: the highest of this CPU, or the one that BONDEM_ISA names.

    Raises:
        InputError: BONDEM_ISA names no level, or a level that this CPU does not offer.
    """
    levels = target.levels
    if len(levels) == 1:
        return levels[0]
    probe = _found(PROBE, target.suffix) or _compiled(target, PROBE)
    offered = target.offered(int(ctypes.CDLL(str(probe)).bondem_level()))
    asked = os.environ.get("BONDEM_ISA", "")
    names = {level.rpartition("_")[2]: level for level in offered}
    if asked and asked not in names:
        raise InputError(f"BONDEM_ISA = {asked}: this CPU offers {', '.join(names)}; choose one of them")
    return names[asked] if asked else offered[-1]


class _FieldDescription(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p), ("type", ctypes.c_char_p), ("shape", ctypes.c_char_p), ("offset", ctypes.c_int64)
    )  # fmt: skip


class _TableDescription(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p), ("size", ctypes.c_int64), ("fields", ctypes.POINTER(_FieldDescription)),
        ("count", ctypes.c_int64),
    )  # fmt: skip


class _PassDescription(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p), ("words", ctypes.c_char_p), ("kind", ctypes.c_int64),
        ("address", ctypes.c_void_p), ("tables", ctypes.POINTER(ctypes.c_char_p)), ("count", ctypes.c_int64),
        ("next", ctypes.c_void_p),
    )  # fmt: skip

    @property
    def named(self) -> tuple[str, tuple[str, ...]]:
        """Name of the pass, and names of its tables."""
        return self.name.decode(), tuple(self.tables[k].decode() for k in range(self.count))


@dataclass(frozen=True)
class _Library:
    """Loaded library with its descriptions of tables and passes.

    Attributes:
        level: level of its instructions.
        tables: fields of each table.
        passes: function, names of tables, and names of outcomes of each pass.
        step_passes: address, kind and tables of each pass of a step.
        columns: columns of elements that each pass of a step reads and writes, as text.
        index_passes: tables of each pass that a device runs with one thread per index.
        index_loops: CPU loop of each of these passes; empty for a wheel.
        lanes: number of lanes of a vector register.
    """

    level: str
    tables: dict[str, tuple[Field, ...]]
    passes: dict[str, tuple[Any, tuple[str, ...], tuple[str, ...]]]
    step_passes: dict[str, tuple[tuple[int, int], tuple[str, ...]]]
    columns: dict[str, str]
    index_passes: dict[str, tuple[str, ...]]
    index_loops: dict[str, Any]
    lanes: int


@functools.cache
def _library() -> _Library:
    """Load the library for this CPU.

    Raises:
        ImportError: No library exists, or its layout of tables differs from that of this module.
        InputError: BONDEM_ISA does not name a level that this CPU offers.
    """
    target = Platform.named(None)
    level = _level(target)
    named = level + LOOPS if _is_source_tree() else level
    loaded = ctypes.CDLL(os.environ.get("BONDEM_CORE") or str(_compiled(target, named)))
    tables = {}
    for table in _described(loaded.bondem_tables, _TableDescription):
        fields = tuple(Field.of(table.fields[k]) for k in range(table.count))
        _check_layout(table.name.decode(), fields, table.size)
        tables[table.name.decode()] = fields
    passes, step_passes, columns = {}, {}, {}
    for one in _registered(loaded.bondem_passes):
        name, names = one.named
        if one.kind >= 0:
            step_passes[name], columns[name] = ((one.address, one.kind), names), one.words.decode()
        else:
            kind = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64, *[ctypes.c_void_p] * one.count)
            passes[name] = kind(one.address), names, tuple(one.words.decode().split())
    index_passes = dict(one.named for one in _described(loaded.bondem_index_passes, _PassDescription))
    index_loops = {}
    if hasattr(loaded, "bondem_index_loops"):
        loop = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p)
        loaded.bondem_index_loops.restype = ctypes.POINTER(ctypes.c_void_p)
        addresses = loaded.bondem_index_loops()
        index_loops = {name: loop(addresses[k]) for k, name in enumerate(index_passes)}
    lanes = int(loaded.bondem_lanes())
    return _Library(level, tables, passes, step_passes, columns, index_passes, index_loops, lanes)


def _described(function: Any, kind: type[ctypes.Structure]) -> Iterable[Any]:
    """Read the array of descriptions that a function of the library returns."""
    function.restype = ctypes.POINTER(kind)
    count = ctypes.c_int64()
    first = function(ctypes.byref(count))
    return [first[k] for k in range(count.value)]


def _registered(function: Any) -> Iterator[_PassDescription]:
    """Yield the passes of the linked list in which they register themselves (`core/registered.hpp`)."""
    function.restype = ctypes.c_void_p
    place = function()
    while place:
        one = _PassDescription.from_address(place)
        yield one
        place = one.next


def _check_layout(name: str, fields: tuple[Field, ...], size: int) -> None:
    """Raise ImportError for a library whose tables are not laid out word by word."""
    offset = 0
    for field in fields:
        if field.offset != offset:
            raise ImportError(f"bondem's core: {name}.{field.name} is at byte {field.offset}, not at {offset}")
        offset += _WORD * field.words
    if size != offset:
        raise ImportError(f"bondem's core: {name} has {size} bytes, not {offset}; describe all fields in index.cpp")


def compiled_level() -> str:
    """Return the level of instructions of the library in use, such as "x86_64_v3"."""
    return _library().level


def core_lanes() -> int:
    """Return the number of lanes of vector registers in the library in use, the fewest rows of a table of bonds."""
    return _library().lanes


def table_fields(name: str) -> tuple[str, ...]:
    """Return the names of the fields of a table of the core."""
    return tuple(field.name for field in _library().tables[name])


@functools.cache
def row_type(name: str) -> np.dtype[Any]:
    """Return the structured type of the rows of a table, with fields as the header declares them.

    `numbers.view(row_type(name))[:, 0]` is a view of a contiguous array of numbers as such rows.
    """
    fields = _library().tables[name]
    return np.dtype([(field.name, field.dtype, tuple(length for _, length in field.shape)) for field in fields])


# ---- passes


def run_pass(call: Call, *, threads: int = 1) -> str:
    """Run a pass with its tables.

    Args:
        call: pass with its tables.
        threads: number of threads; no result depends on it.

    Returns:
        Name of the outcome, as the library declares it; "" for a pass with a single outcome.

    Raises:
        ImportError: other tables than those of the library.
        InputError: an array of another type, shape or order in memory than declared.
    """
    return bound_pass(call, threads=threads)()


def bound_pass(call: Call, *, threads: int = 1) -> Callable[[], str]:
    """Return a function that runs a pass with its tables, checked once, and returns the name of the outcome.

    The arrays of the tables are read and written in place at every call.

    Raises:
        ImportError: other tables than those of the library.
        InputError: an array of another type, shape or order in memory than declared.
    """
    function, names, outcomes = _library().passes[call.name]
    lengths: dict[str, tuple[int, str]] = {}
    filled = [
        filled_table(name, fields_of(table, name), table, lengths)
        for name, table in zip(names, call.tables, strict=True)
    ]

    def carry_out() -> str:
        assert call is not None  # the arrays live as long as this function
        ended = function(int(threads), *map(address_of, filled))
        return outcomes[ended] if outcomes else ""

    return carry_out


def fields_of(table: tuple[Any, ...], name: str) -> tuple[Field, ...]:
    """Return the fields of a table, after a check that it is the table `name` of a pass.

    Raises:
        ImportError: the table has another name, or other fields than the header.
    """
    kind = type(table)
    if kind.__name__ != name:
        raise ImportError(f"{kind.__name__} stands for {name}; run: python -m tests.core.passes")
    return checked_fields(kind)


def step_pass(name: str) -> tuple[tuple[int, int], tuple[str, ...]]:
    """Return address and kind of a pass of a step, and the names of its tables."""
    return _library().step_passes[name]


def declared_columns(name: str) -> str:
    """Return the columns of elements that a pass of a step reads and writes, as written in its `BONDEM_PASS`."""
    return _library().columns[name]


def pass_tables(kind: str) -> dict[str, tuple[str, ...]]:
    """Return the names of the tables of each pass of a kind: "calls" of Python, "steps", or "kernels" of a device."""
    library = _library()
    if kind == "kernels":
        return library.index_passes
    return {name: one[1] for name, one in (library.passes if kind == "calls" else library.step_passes).items()}


def index_loop(name: str) -> Callable[[int, int, int], Any]:
    """Return the CPU loop of a pass with one thread per index, by which tests simulate a device.

    The arguments of the loop are the number of indices, the address of a flag (or 0), and the address of a list of
    addresses of tables. A flag that is not 0 skips all indices.

    Raises:
        ImportError: bondem was installed from a wheel, which does not contain the loops.
    """
    loops = _library().index_loops
    if not loops:
        raise ImportError("bondem's core has no loops over indices: only a source tree simulates a device")
    return loops[name]


@functools.cache
def checked_fields(kind: type[tuple[Any, ...]]) -> tuple[Field, ...]:
    """Return the fields of a table from its class, a named tuple, after a check of their names.

    Raises:
        ImportError: the class has other fields than the header.
    """
    fields = _library().tables[kind.__name__]
    if kind._fields != tuple(field.name for field in fields):
        listed = ", ".join(field.name for field in fields)
        raise ImportError(f"{kind.__name__} has the fields {listed}; run: python -m tests.core.tables")
    return fields


def with_room(table: Any, *columns: str) -> Any:
    """Return a copy of a table in which the named columns have twice as many rows; the added ones are undefined."""
    now = {name: getattr(table, name) for name in columns}
    return table._replace(**{name: np.concatenate([one, np.empty_like(one)]) for name, one in now.items()})


# ---- memory of the process

# Least number of bonds for which returning freed memory is worth some milliseconds; M_ARENA_MAX of glibc.
_MANY_BONDS, _HEAPS = 20_000, -8


@functools.cache
def _of_system(name: str) -> Callable[..., int] | None:
    """Return a function of the C library by name; None if it is missing, or on other systems than Linux."""
    return getattr(ctypes.CDLL(None), name, None) if sys.platform == "linux" else None


def return_free_memory(bonds: int) -> None:
    """Return freed memory to the system after work on many bonds, if the C library supports it."""
    if bonds >= _MANY_BONDS and (trim := _of_system("malloc_trim")) is not None:
        trim(0)


# glibc keeps free memory at the end of the heap of each thread, 10 MB and more: let all threads share one heap.
if "MALLOC_ARENA_MAX" not in os.environ and (_limit := _of_system("mallopt")) is not None:
    _limit(_HEAPS, 1)
