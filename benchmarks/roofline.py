"""What a step must do at least, and how fast this machine could do it.

Bytes are counted from the arrays of `docs/decisions/0001-state.md`: each is taken from memory once a step and, where
it changes, put back once, however often the caches deliver it. Flops are counted by running the scalar functions
that the kernels compile on numbers that count.
"""

import time
from collections.abc import Callable
from types import FunctionType, SimpleNamespace
from typing import Any

import numpy as np

import bondem as bd
from bondem._compile import kernel, prange
from bondem.laws import beam_energy, rotations
from bondem.model.state import State

# Fused multiply-adds one after the other, so that loads and stores do not count.
_CHAIN = 64
# Bytes of the triad a += s b for each number: two read, one written back, and none that the cache fetches unasked.
_TRIAD_BYTES = 24


class _Counted:
    """A number that counts what is done with it; square roots and divisions count as one."""

    def __init__(self, value: float, total: list[int]) -> None:
        self.value, self.total = value, total

    def _one(self, value: float) -> "_Counted":
        self.total[0] += 1
        return _Counted(value, self.total)

    def __add__(self, other: Any) -> "_Counted":
        return self._one(self.value + float(other))

    def __sub__(self, other: Any) -> "_Counted":
        return self._one(self.value - float(other))

    def __rsub__(self, other: Any) -> "_Counted":
        return self._one(float(other) - self.value)

    def __mul__(self, other: Any) -> "_Counted":
        return self._one(self.value * float(other))

    def __truediv__(self, other: Any) -> "_Counted":
        return self._one(self.value / float(other))

    def __rtruediv__(self, other: Any) -> "_Counted":
        return self._one(float(other) / self.value)

    def __neg__(self) -> "_Counted":
        return _Counted(-self.value, self.total)  # a sign is part of the next operation

    def __lt__(self, other: Any) -> bool:
        return self.value < float(other)

    def __float__(self) -> float:
        return self.value

    __radd__, __rmul__ = __add__, __mul__


def _flops(function: Any, module: Any, arguments: int) -> int:
    """Operations of a compiled scalar function and of those of its module that it calls."""
    total = [0]

    def plain(compiled: Any) -> Callable:
        code = compiled.py_func.__code__
        inner = {name: known[name] for name in code.co_names if name in known}
        inner |= {name: value for name, value in vars(module).items() if isinstance(value, float)}
        return FunctionType(code, {**inner, "math": counting})

    counting = SimpleNamespace(sqrt=lambda x: x._one(x.value**0.5))
    known: dict[str, Any] = {}
    for name, item in vars(module).items():
        if hasattr(item, "py_func"):
            known[name] = plain(item)
    # small rotations, unit lengths: the branches that steps take
    plain(function)(*[_Counted(0.01 * (k + 1), total) for k in range(arguments)])
    return total[0]


def flops_per_bond(elements_per_bond: float) -> dict[str, float]:
    """Floating-point operations of a step, a bond; a rounding, a root and a division count as one."""
    law = _flops(beam_energy.bond_force, beam_energy, 20)
    branch = 3 * (1 + 4)  # difference, and the nearest image of it
    stiffness = 5  # over the length
    sums = 12  # force and two torques, to both ends
    # accelerations, two kicks, drift of the centre, rotation vector, and the turn by it
    element = 6 + 2 * 12 + 3 * 4 + 3 * 3 + _flops(rotations.turn, rotations, 7)
    return {
        "law": law,
        "branch, stiffness, sums": branch + stiffness + sums,
        "motion of elements": element * elements_per_bond,
        "all": law + branch + stiffness + sums + element * elements_per_bond,
    }


def bytes_per_bond(model: bd.Model, state: State) -> dict[str, float]:
    """Least traffic of a step with memory, a bond."""
    layout, bonds = model.layout, model.bonds
    m, n = len(layout.i), len(layout.order)
    columns = 4 if bonds.alike is not None else 9  # direction and length; or stiffnesses too
    ends = 2 * layout.i.nbytes + layout.j.nbytes  # i, j, and the row of the sums that the part for i goes to
    streamed = ends + columns * bonds.length.nbytes + state.integrity.nbytes
    sums = n * 64
    there_and_back = 2 * (state.pose.nbytes + state.motion.nbytes + sums)
    order = n * (4 + 8)  # which element moves next, and whether it has a boundary condition
    return {
        "constants and ends of bonds, read": streamed / m,
        "poses, motions and sums of elements, read and written": there_and_back / m,
        "order of elements, read": order / m,
        "all": (streamed + there_and_back + order) / m,
    }


def state_bytes_per_element(model: bd.Model, state: State) -> float:
    """Memory of everything a run keeps: state, constants, indices and sums."""
    bonds, layout = model.bonds, model.layout
    arrays = [getattr(state, name) for name in State.ARRAYS] + [state.rest]
    arrays += [value for value in vars(bonds).values() if isinstance(value, np.ndarray)]
    arrays += [layout.i, layout.i, layout.j, layout.order, layout.rank, layout.bond_order, layout.flipped]
    arrays += [layout.in_start, layout.out_start, layout.out_bond]
    n = len(layout.order)
    return sum(array.nbytes for array in arrays) / n + 64 + 4 + 8


@kernel(parallel=True)
def _triad(a, b, s, passes):
    for part in prange(len(a)):
        for _ in range(passes):
            for n in range(a.shape[1]):
                a[part, n] += s * b[part, n]


@kernel(parallel=True)
def _multiply_add(a, factor, rounds):
    for part in prange(len(a)):
        for _ in range(rounds):
            for n in range(a.shape[1]):
                x = a[part, n]
                for _ in range(_CHAIN):
                    x = x * factor + factor
                a[part, n] = x


def _best(run: Callable[[], object], repeat: int) -> float:
    times = []
    for _ in range(repeat):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return min(times)


def bandwidth(footprint: float, count: int, *, repeat: int = 7) -> float:
    """Of the triad a += s b over arrays of `footprint` bytes together, on `count` threads [B/s].

    The same footprint as a step, so that what stays in a cache does so in both.
    """
    length = max(64, int(footprint / 16 / count))
    a, b = np.zeros((count, length)), np.ones((count, length))
    passes = max(1, int(5e8 / (a.size * _TRIAD_BYTES)))
    _triad(a, b, 0.5, 1)
    return passes * a.size * _TRIAD_BYTES / _best(lambda: _triad(a, b, 0.5, passes), repeat)


def peak(count: int, *, repeat: int = 7) -> float:
    """Of multiply-adds in double precision, as compiled here, on `count` threads [flop/s]."""
    a = np.zeros((count, 1024))
    rounds = 400
    _multiply_add(a, 0.5, 1)
    return 2.0 * _CHAIN * rounds * a.size / _best(lambda: _multiply_add(a, 0.5, rounds), repeat)
