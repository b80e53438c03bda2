"""What a step must do at least, and how fast this machine could do it.

Bytes are counted from the arrays of `docs/decisions/0001-state.md`: each is taken from memory once a step and, where
it changes, put back once, however often the caches deliver it. Flops of the bond law and of a rotation are counted
from their formulas (`core/laws/beam.hpp`, `core/laws/rotations.hpp`), operation by operation.
"""

import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from threadpoolctl import threadpool_limits

import bondem as bd
from bondem.model.state import State

# Operations of force and torques of one bond, and of turning an element by a step's rotation; a square root and a
# division count as one, and a sign as none.
_LAW, _TURN = 188, 73
# Bytes of the sum a += b for each number: two read, one written back, and none that the cache fetches unasked.
_SUM_BYTES = 24
# Rows of the square matrices whose product is timed.
_SQUARE = 1024


def flops_per_bond(elements_per_bond: float) -> dict[str, float]:
    """Floating-point operations of a step, a bond; a rounding, a root and a division count as one."""
    branch = 3 * (1 + 4)  # difference, and the nearest image of it
    stiffness = 5  # over the length
    sums = 12  # force and two torques, to both ends
    # accelerations, two kicks, drift of the centre, rotation vector, and the turn by it
    element = 6 + 2 * 12 + 3 * 4 + 3 * 3 + _TURN
    return {
        "law": _LAW,
        "branch, stiffness, sums": branch + stiffness + sums,
        "motion of elements": element * elements_per_bond,
        "all": _LAW + branch + stiffness + sums + element * elements_per_bond,
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


def _best(run: Callable[[], object], repeat: int) -> float:
    times = []
    for _ in range(repeat):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return min(times)


def bandwidth(footprint: float, count: int, *, repeat: int = 7) -> float:
    """Of the sum a += b over arrays of `footprint` bytes together, on `count` threads [B/s].

    The same footprint as a step, so that what stays in a cache does so in both.
    """
    length = max(64, int(footprint / 16 / count))
    parts = [(np.zeros(length), np.ones(length)) for _ in range(count)]
    passes = max(1, int(5e8 / (count * length * _SUM_BYTES)))

    def add(part: tuple[np.ndarray, np.ndarray]) -> None:
        a, b = part
        for _ in range(passes):
            np.add(a, b, out=a)

    with ThreadPoolExecutor(count) as pool:
        seconds = _best(lambda: list(pool.map(add, parts)), repeat)
    return passes * count * length * _SUM_BYTES / seconds


def peak(count: int, *, repeat: int = 7) -> float:
    """Of the product of two matrices in double precision, on `count` threads [flop/s]."""
    a, b, c = np.ones((3, _SQUARE, _SQUARE))
    with threadpool_limits(count, user_api="blas"):
        np.matmul(a, b, out=c)
        return 2.0 * _SQUARE**3 / _best(lambda: np.matmul(a, b, out=c), repeat)
