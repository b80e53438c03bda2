"""The coarse correction of a cracked body: clumps do not reach across its cracks."""

from dataclasses import replace

import numpy as np

from bondem.statics.coarse_space import parted
from bondem.statics.linear import Iteration, System
from bondem.statics.quasistatic.damaged_body import DamagedBody
from bondem.statics.quasistatic.equilibrium import Iterated
from tests.models import pulled
from tests.specimens import uneven_bar


def _row(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Elements in two rows along x, joined along and across."""
    position = np.stack([np.repeat(np.arange(count), 2), np.tile([0, 1], count), np.zeros(2 * count)], axis=1)
    along = np.arange(2 * count - 2)
    across = np.arange(0, 2 * count, 2)
    return position.astype(float), np.concatenate([along, across]), np.concatenate([along + 2, across + 1])


def test_what_no_bond_joins_is_a_clump_of_its_own():
    position, i, j = _row(8)
    clump, lost = np.zeros(16, dtype=np.int64), np.zeros(len(i))
    assert len(np.unique(parted(clump, position, i, j, lost))) == 1
    lost[np.isin(i, [6, 7]) & (j > i + 1)] = 1.0  # between the fourth and the fifth of each row
    found = parted(clump, position, i, j, lost)
    assert len(np.unique(found)) == 2
    assert (found[:8] == found[0]).all()
    assert (found[8:] == found[15]).all()


def test_a_clump_that_is_cracked_in_part_is_cut_along_its_crack():
    position, i, j = _row(8)
    clump, lost = np.zeros(16, dtype=np.int64), np.zeros(len(i))
    lost[(i == 6) & (j == 8)] = 0.9  # one row of two
    found = parted(clump, position, i, j, lost)
    assert len(np.unique(found)) == 2
    assert (found == (position[:, 0] > 3.5) * (found[15] - found[0]) + found[0]).all()


def test_clumps_stay_apart():
    position, i, j = _row(8)
    clump = np.repeat([0, 1], 8)
    lost = np.zeros(len(i))
    lost[(i == 2) & (j == 4)] = 1.0
    found = parted(clump, position, i, j, lost)
    assert len(np.unique(found)) == 3
    assert not set(found[:8]) & set(found[8:])


def test_a_crack_across_clumps_takes_fewer_iterations():
    """A bar is cut nearly through where clumps would lie across the cut."""
    model = pulled(uneven_bar(800))
    system = System.of(replace(model, failure=None))
    begun = Iteration(system)
    body = DamagedBody(model, system, begun.root)
    x = model.lattice.centre[model.layout.order, 0]
    cut = 0.35 * 16e-3
    facets = np.flatnonzero((x[body.i] < cut) != (x[body.j] < cut))
    for k in facets[: int(0.9 * len(facets))]:
        body.weaken(np.array([k]), 0.01, (False, False))
    right, start = body.right - body.pull, np.zeros(6 * len(x))
    rounds = []
    for integrity in (np.ones(len(body.i)), body.integrity):
        search = Iterated(body.system, body.matrix, begun, integrity)
        search._renew()
        found = search.solve(right, start)
        rounds.append(search.rounds)
    assert np.isfinite(found).all()
    assert rounds[1] < 0.6 * rounds[0]
