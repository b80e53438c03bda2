"""Memory: bytes of the arrays that a model and the loop of a run keep, without what the C library keeps free."""

import types
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.plan import Plan
from tests.specimens import crooked_block, crooked_cells

CELLS = bd.CellBond(E=1e7, nu=0.2)
BEAMS = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6)


def _parts(thing: Any) -> Iterator[Any]:
    """Yield what an object refers to, but not what its class and its module have."""
    if isinstance(thing, dict):
        yield from thing.values()
    elif isinstance(thing, list | tuple | set | frozenset):
        yield from thing
    elif isinstance(thing, types.FunctionType):
        yield from (cell.cell_contents for cell in thing.__closure__ or ())
    elif isinstance(thing, types.MethodType):
        yield thing.__self__
    elif not isinstance(thing, type | types.ModuleType):
        yield from getattr(thing, "__dict__", {}).values()


def bytes_of_arrays(*roots: Any) -> int:
    """Return the bytes of all arrays that objects keep; arrays that share memory count once."""
    seen, arrays, waiting = {}, {}, list(roots)
    while waiting:
        thing = waiting.pop()
        if id(thing) in seen:
            continue
        seen[id(thing)] = thing
        if isinstance(thing, np.ndarray):
            while isinstance(thing.base, np.ndarray):
                thing = thing.base
            arrays[id(thing)] = thing
        else:
            waiting.extend(_parts(thing))
    return sum(array.nbytes for array in arrays.values())


def test_arrays_that_share_memory_count_once():
    whole = np.zeros((4, 8))

    class Owner:
        def __init__(self) -> None:
            self.view, self.call = whole[1:], lambda: whole.T

    assert bytes_of_arrays(Owner(), {"a": [whole]}) == 256
    assert bytes_of_arrays(Owner(), whole.copy()) == 512


def counted(model: bd.Model) -> int:
    """Return the bytes of the arrays of a model and a loop that has taken three steps."""
    state, dt = model.state(), 1e-9
    loop = CoreLoop(model, Plan(duration=3.0 * dt, dt=dt, every=0), state, dt)
    loop.run(3)
    return bytes_of_arrays(model, loop)


@pytest.mark.parametrize(
    ("lattice", "law", "most"),
    [(crooked_cells((6, 6, 6)), CELLS, 2892), (crooked_block((6, 6, 6)), BEAMS, 1410)],
    ids=["cells", "beams"],
)  # fmt: skip
def test_a_run_keeps_no_further_array_of_bonds(lattice, law, most):
    """The limit is in bytes per element; one more number of single precision per bond would exceed it."""
    model = bd.Model(lattice, law, 1000.0)
    n, found = len(model.mass), counted(model)
    assert found <= most * n < found + 4 * len(lattice.pairs)


def test_moments_of_facets_are_six_numbers_and_lose_no_bit():
    facets = crooked_cells((3, 3, 3)).facets
    nine = facets.moment
    assert bytes_of_arrays(facets) == 8 * len(facets.area) * (3 + 4 * 3 + 6)
    assert not nine.flags.writeable
    np.testing.assert_array_equal(nine, nine.transpose(0, 2, 1))
    lopsided = nine + np.triu(np.ones((3, 3)))
    for given in (nine, lopsided):
        again = replace(facets, moment=given)
        assert again.moment.tobytes() == given.tobytes()
        assert (bytes_of_arrays(again) == bytes_of_arrays(facets)) == (given is nine)
    assert replace(facets, moment=np.zeros((0, 3, 3))).moment.shape == (0, 3, 3)
