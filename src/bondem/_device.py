"""Passes with one thread per element, bond or facet on a device, and the tables of a run in its memory.

A device is a GPU (`bondem._cuda`), or the CPU (`Host`), on which tests run the same passes in a loop. Tables are
those of the core, named tuples of NumPy arrays. `DeviceTables` checks them and copies them to the device.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from bondem._core import fields_of, filled_table, index_loop, pass_tables
from bondem._passes import Kernel

__all__ = ["Device", "DeviceTables", "Enqueue", "Host", "HostCall", "Launch", "in_sequence", "passes_of"]

# Size of a line of the memory of a GPU [bytes].
_LINE = 128
#: Function that enqueues one launch to a stream or a graph; None is the stream of the device.
Enqueue = Callable[[Any], None]


@dataclass(frozen=True)
class HostCall:
    """Work of the CPU between two passes of a step, such as a user's function.

    Steps with such work are not recorded as a graph.

    Attributes:
        work: function that fetches its input from tables of a run, and sends its results.
    """

    work: Callable[["DeviceTables"], None]


#: Pass with its tables and the number of its indices; or work of the CPU with a positive number.
Launch = tuple[Kernel | HostCall, int]


def passes_of(launches: Iterable[Launch]) -> list[str]:
    """Return the names of the passes of launches over at least one index."""
    return [one.name for one, count in launches if isinstance(one, Kernel) and count > 0]


class Device(Protocol):
    """Device with its own memory, whose copies and launches are executed in the order of the calls."""

    def allocate(self, size: int) -> tuple[int, object]:
        """Allocate `size` bytes of zeros; return their address and the object that owns them."""
        ...

    def send(self, array: np.ndarray, to: int) -> None:
        """Copy a contiguous array to an address of the device."""
        ...

    def fetch(self, source: int, array: np.ndarray) -> None:
        """Copy from an address of the device into a contiguous array, after all launches so far."""
        ...

    def compile(self, names: Sequence[str]) -> None:
        """Compile passes by name together; otherwise `prepared` compiles each one at its first use."""
        ...

    def prepared(self, one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
        """Return a function that enqueues a pass over 0 … count - 1 with tables at some addresses.

        Args:
            one: the pass.
            count: number of indices.
            tables: addresses of the tables.
            halted: address of a flag that makes the pass do nothing if it is not 0; 0 for no flag.
        """
        ...

    def recorded(self, work: Sequence[Enqueue]) -> Callable[[], None]:
        """Return a function that enqueues several launches as one."""
        ...


class DeviceTables:
    """Tables of a run on a device. Arrays and tables are copied once, and views of one array remain views of it.

    Args:
        device: the device.
        lengths: lengths of axes known so far, see `bondem._core.filled_table`.
    """

    def __init__(self, device: Device, lengths: dict[str, tuple[int, str]] | None = None) -> None:
        self.device = device
        self.lengths = {} if lengths is None else lengths
        self._arrays: dict[int, tuple[np.ndarray, int, object]] = {}
        self._unread: set[int] = set()
        self._written: dict[int, np.ndarray] = {}
        self._uses: dict[int, int] = {}
        self._tables: dict[int, tuple[tuple[Any, ...], int, object]] = {}

    def work_space(self, *arrays: np.ndarray) -> None:
        """Mark arrays of zeros that the CPU does not read, so that they are not copied."""
        self._unread |= {id(_whole(array)) for array in arrays}

    def address(self, array: np.ndarray) -> int:
        """Return the address of an array on the device, where it is copied at the first request."""
        whole = _whole(array)
        if id(whole) not in self._arrays:
            address, memory = self.device.allocate(whole.nbytes + _LINE)
            address += (whole.ctypes.data - address) % _LINE  # aligned in a line as on the CPU
            self._arrays[id(whole)] = whole, address, memory
            if id(whole) not in self._unread:
                self.device.send(whole, address)
        return self._arrays[id(whole)][1] + array.ctypes.data - whole.ctypes.data

    def fetch_written(self) -> None:
        """Copy from the device all arrays that passes write and the CPU may read."""
        self.fetch(*self._written.values())

    def fetch(self, *arrays: np.ndarray) -> None:
        """Copy arrays from the device."""
        for array in arrays:
            if array.size:
                self.device.fetch(self.address(array), array)

    def send(self, *arrays: np.ndarray) -> None:
        """Copy arrays to the device again, after a change."""
        for array in arrays:
            if array.size:
                self.device.send(array, self.address(array))

    def forget(self, *tables: tuple[Any, ...]) -> None:
        """Free the memory of tables, and of arrays that no other table contains; known lengths are cleared."""
        self.lengths.clear()
        for table in tables:
            if self._tables.pop(id(table), None) is None:
                continue
            for whole in _arrays_of(table):
                self._uses[id(whole)] -= 1
                if self._uses[id(whole)] == 0:
                    self._arrays.pop(id(whole))
                    self._written.pop(id(whole), None)
                    self._uses.pop(id(whole))

    def prepared(self, launches: Iterable[Launch], halted: np.ndarray | None = None) -> list[Enqueue]:
        """Return functions that enqueue launches, without launches over no index.

        Args:
            launches: launches in their order.
            halted: flag that makes launches do nothing if it is not 0, (1,); None for no flag.
        """
        flag = 0 if halted is None else self.address(halted)
        launches = list(launches)
        self.device.compile(passes_of(launches))
        return [self._prepared(launch, flag) for launch in launches if launch[1] > 0]

    def _prepared(self, launch: Launch, flag: int) -> Enqueue:
        one, count = launch
        if isinstance(one, HostCall):
            return lambda _: one.work(self)
        names = pass_tables("kernels")[one.name]
        addresses = [self._table(name, table) for name, table in zip(names, one.tables, strict=True)]
        return self.device.prepared(one, count, addresses, flag)

    def _table(self, name: str, table: tuple[Any, ...]) -> int:
        """Return the address of a table on the device, where it and its arrays are copied at the first request."""
        fields = fields_of(table, name)
        if id(table) not in self._tables:
            words = filled_table(name, fields, table, self.lengths)
            for field, value in zip(fields, table, strict=True):
                if field.written is None:
                    continue
                words[field.offset // words.itemsize] = self.address(value) if value.size else 0
                if field.written and value.size and id(_whole(value)) not in self._unread:
                    self._written[id(_whole(value))] = _whole(value)
            for whole in _arrays_of(table):
                self._uses[id(whole)] = self._uses.get(id(whole), 0) + 1
            address, memory = self.device.allocate(words.nbytes)
            self.device.send(words, address)
            self._tables[id(table)] = table, address, memory
        return self._tables[id(table)][1]


class Host:
    """CPU as a device with separate memory, for tests: passes are loops over their indices."""

    def allocate(self, size: int) -> tuple[int, object]:
        """Allocate at least `size` bytes of zeros; return their address and the array that owns them."""
        memory = np.zeros(max(size, 8) // 8 + 1)
        return memory.ctypes.data, memory

    def send(self, array: np.ndarray, to: int) -> None:
        """Copy a contiguous array to an address."""
        _bytes_at(to, array.nbytes)[:] = array.reshape(-1).view(np.uint8)

    def fetch(self, source: int, array: np.ndarray) -> None:
        """Copy from an address into a contiguous array."""
        array.reshape(-1).view(np.uint8)[:] = _bytes_at(source, array.nbytes)

    def compile(self, names: Sequence[str]) -> None:
        """Do nothing, because the passes of the CPU are compiled already."""

    def prepared(self, one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
        """Return a function that runs a pass over 0 … count - 1; arguments are those of `Device.prepared`."""
        addresses, loop = np.array(tables, dtype=np.int64), index_loop(one.name)
        return lambda _: loop(count, halted, addresses.ctypes.data)

    def recorded(self, work: Sequence[Enqueue]) -> Callable[[], None]:
        """Return a function that runs several launches in sequence."""
        return in_sequence(work)


def in_sequence(work: Sequence[Enqueue]) -> Callable[[], None]:
    """Return a function that enqueues launches one after the other to the stream of the device."""

    def run() -> None:
        for enqueue in work:
            enqueue(None)

    return run


def _whole(array: np.ndarray) -> np.ndarray:
    """Return the array that owns the numbers of an array, which may be a view of it."""
    while isinstance(array.base, np.ndarray):
        array = array.base
    return array


def _arrays_of(table: tuple[Any, ...]) -> list[np.ndarray]:
    """Return the owner (`_whole`) of each array of a table that is not empty; owners may repeat."""
    return [_whole(value) for value in table if isinstance(value, np.ndarray) and value.size]


class _Memory:
    """Array interface by which NumPy accesses the bytes at an address."""

    def __init__(self, address: int, size: int) -> None:
        self.__array_interface__ = {"version": 3, "shape": (size,), "typestr": "|u1", "data": (address, False)}


def _bytes_at(address: int, size: int) -> np.ndarray:
    return np.asarray(_Memory(address, size))
