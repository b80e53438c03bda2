"""Breakage of facets by the damage pipeline of the core: against numbers of the former loop, and closed forms."""

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import HistoryColumn
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.observables.cell_forces import CellForces
from tests.bits import assert_same_bits
from tests.core.former_loop import FormerLoop, movement, with_former_law
from tests.core.test_cells import CONDITIONS, GRID, LAW, X_MAX, X_MIN, body, run_of
from tests.elastic_energy import elastic_energy
from tests.specimens import crooked_cells

BRITTLE = bd.MohrCoulomb(tension=3e5, cohesion=6e5, friction_angle=0.5)
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")


def steady(conditions: str) -> list:
    return [one for one in CONDITIONS[conditions] if not isinstance(one, bd.Eigenstrain)]


def breaking(conditions: str, lattice: bd.Lattice | None = None, **options) -> bd.Model:
    boundary = steady(conditions)
    return bd.Model(lattice or body(120), LAW, density=2500.0, boundary=boundary, failure=BRITTLE, **options)


# Cells touch as spheres where their facets break, and press on two walls.
TOUCHING = {
    "contact": bd.LinearContact(E=1e8, friction=0.4, damping=0.1),
    "walls": [bd.PlaneWall((0, 0, 0), (0, 0, 1)), bd.PlaneWall((0, 1.0, 0), (0, -1, 0), motion=bd.Driven(vy=-3.0))],
}


def test_breakage_is_that_of_the_former_loop(monkeypatch):
    model = breaking("held", with_former_law(monkeypatch, crooked_cells(**GRID), steady("held")), **TOUCHING)
    # 54 steps: later a contact begins with less than the pressure of the former rule (decision 0071)
    result = run_of(model, 54, CoreLoop, every=50, damping=bd.BondDamping(eta=0.05))
    state, former = result.state, FormerLoop("cells", "facets break")
    assert len(state.broken) > 30
    assert len(state.touching) > 30
    # the mode is that of the criterion before other facets of the same step break
    former.assert_same(events=state.broken[:, 1:3], integrity=state.integrity)
    names = "reaction", "loss", "released"  # works of walls are by row (decision 0068); records have their sum
    walls = state.walls[:, :14]  # which did not turn
    former.assert_close(1e-9, **movement(state), walls=walls, **{name: getattr(state, name) for name in names})
    # a force gauge has the force on its face only, no longer that on all facets of its cells
    former.assert_records(1e-9, result.history.records[:, : HistoryColumn.COUNT])


def test_threads_and_pauses_change_no_bit(monkeypatch):
    model, results = breaking("held", body(450), **TOUCHING), []
    for count, every in ((1, 50), (2, 50), (3, 7), (4, 0)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        results.append(run_of(model, 200, CoreLoop, every=every, damping=bd.BondDamping(eta=0.05)))
    assert len(results[0].state.broken) > 30
    for other in results[1:]:
        assert_same_bits(results[0], other)
    np.testing.assert_array_equal(results[0].history.records, results[1].history.records)


def test_what_the_facets_release_is_what_the_body_loses():
    model = breaking("free", contact=bd.LinearContact(E=1e8))
    whole = run_of(bd.Model(body(120), LAW, density=2500.0), 300, CoreLoop, every=1)
    run = run_of(model, 300, CoreLoop, every=1)
    assert 10 < len(run.state.broken) < len(model.layout.i)
    assert run.state.broken[:, 5].sum() == pytest.approx(run.state.released[0])
    assert (run.state.broken[:, 5] > 0.0).all()

    def drift(records: np.ndarray) -> float:
        stored = records[:, HistoryColumn.TRANSLATION : HistoryColumn.TWISTING + 1].sum(axis=1)
        total = stored - records[:, HistoryColumn.WORK] + records[:, HistoryColumn.RELEASED]
        return float(np.ptp(total) / total[0])

    assert drift(run.history.records) < 1.5 * drift(whole.history.records)
    # cells weigh their dilatation by the facets that they have left
    stored = elastic_energy(model, run.state).total
    assert run.history.records[-1, 3:7].sum() == pytest.approx(stored, rel=1e-12)


def test_the_index_of_a_facet_is_its_traction_over_the_strength():
    strong = bd.MohrCoulomb(tension=1e7, cohesion=1e9, friction_angle=0.0)
    model = bd.Model(body(120), LAW, density=2500.0, failure=strong, boundary=[
        bd.Fix(X_MIN), bd.Drive(X_MAX, vx=bd.Constant(0.5)),
    ])  # fmt: skip
    run = run_of(model, 100, CoreLoop, every=0)
    forces, facets = CellForces.of(model, run.state), model.lattice.facets
    assert facets is not None
    pulled = (forces.force * facets.normal).sum(axis=1) / facets.area
    index = bd.failure_index(model, run.state)
    far = pulled > 0.1 * pulled.max()
    np.testing.assert_allclose(index[far], pulled[far] / 1e7, rtol=0.02)
