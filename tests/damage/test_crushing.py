"""Kinds of loss: fracture up to the fracture energy of each facet or beam, crushing beyond it, and their areas."""

import functools
import math

import numpy as np
import pytest

import bondem as bd
from bondem.damage.crack_columns import FACET, ONSET, SPENT
from bondem.damage.criteria.criterion import MODES
from bondem.dynamics.core_loop import CoreLoop
from bondem.observables.fracture_energy import fracture_energies
from tests.bits import most_threads, threads
from tests.models import slowly_torn, time_step
from tests.specimens import ball, row, two_cubes

G_F, F_T, RADIUS, CELLS = 20.0, 4e6, 25e-3, 120
ROCK = bd.MohrCoulomb(
    tension=F_T, cohesion=14.3e6, friction_angle=0.61, fracture_energy=G_F, fracture_energy_shear=2.0
)
SOFT = bd.Rankine(tension=F_T, fracture_energy=G_F)


def thrown(failure: bd.Criterion, speed: float) -> tuple[bd.Model, bd.State]:
    """A ball of concrete that hits a wall, and its state before."""
    body = ball(CELLS, RADIUS)
    wall = bd.PlaneWall(point=(body.centre[:, 0].min() - 5e-3, 0.0, 0.0), normal=(1.0, 0.0, 0.0))
    model = bd.Model(
        body, bd.CellBond(E=30e9, nu=0.2), 2400.0, failure=failure, walls=[wall], contact=bd.LinearContact(E=60e9)
    )
    state = model.state()
    state.velocity = (-speed, 0.0, 0.0)
    return model, state


@functools.cache
def broken(failure: bd.Criterion) -> bd.ExplicitResult:
    model, state = thrown(failure, 30.0)
    return bd.solve_explicit(model, duration=3e-4, every=20, state=state)


@pytest.mark.parametrize("failure", [SOFT, ROCK])
def test_an_impact_crushes_and_fractures(failure: bd.Criterion, one_thread: None) -> None:
    """Facets release more than G_f times their area: what is beyond it, and all without cohesion, is crushing."""
    run = broken(failure)
    energy, state = run.history.energy, run.state
    area = state.model.lattice.facets.area[state.layout.bond_order]
    rows = state.cracks
    facet, spent = rows[:, FACET].astype(int), rows[:, SPENT]
    # friction may give back a little of what a facet has released
    held = np.minimum(spent, np.where(rows[:, ONSET] > 0.0, G_F * area[facet], 0.0))
    assert (failure is ROCK) == (rows[:, ONSET] == 0.0).any()
    assert energy["fracture"][-1] == pytest.approx(held.sum(), rel=1e-9)
    assert energy["crushing"][-1] == pytest.approx((spent - held).sum(), rel=1e-12)
    assert energy["crushing"][-1] > energy["fracture"][-1]
    (one,) = run.fracture_energy
    assert 0.0 < one.fractured <= 1.0
    assert one.fractured * G_F * one.area == pytest.approx(held[state.integrity[facet] == 0.0].sum())
    assert (np.diff(energy["crushing"]) > -1e-12 * energy["crushing"][-1]).all()
    assert energy["fracture"][-1] + energy["crushing"][-1] == pytest.approx(state.released[0], rel=1e-15)


def test_the_balance_counts_both(one_thread: None) -> None:
    """The terms that are told apart sum to the work, as the balance states it."""
    energy = dict(broken(ROCK).history.energy)
    balance, work = energy.pop("balance"), energy.pop("work")
    total = np.sum(list(energy.values()), axis=0) - work
    np.testing.assert_allclose(total - total[0], balance, atol=1e-14 * total[0])
    assert np.abs(balance).max() < 2e-3 * total[0]


def test_what_is_broken_states_its_energy_per_area(one_thread: None) -> None:
    """Area without facets that never had cohesion, energy per area beside G_f, and a word in the message."""
    run = broken(ROCK)
    (one,) = run.fracture_energy
    state = run.state
    rows = state.cracks
    facet = rows[:, FACET].astype(int)
    chosen = (state.integrity[facet] == 0.0) & (rows[:, ONSET] > 0.0)
    area = state.model.lattice.facets.area[state.layout.bond_order][facet[chosen]].sum()
    assert run.fracture_area == one.area == pytest.approx(area)
    assert area < bd.cracks(state.model.lattice, state).area
    assert one.per_area == pytest.approx(rows[chosen, SPENT].sum() / area)
    assert (one.region, one.entered) == (None, pytest.approx(G_F))
    assert f"broken area dissipated {one.ratio:.3g} G_f" in run.message


def test_a_bar_that_is_torn_slowly_is_not_crushed(one_thread: None) -> None:
    """Its facets dissipate G_f per area projected on the crack, so less per area of their own."""
    model, dt = slowly_torn(bd.Rankine(tension=4e6, fracture_energy=50.0))
    run = bd.solve_explicit(model, duration=6000 * dt, dt=dt, every=100)
    assert run.history.energy["crushing"][-1] <= 0.02 * run.history.energy["fracture"][-1]
    (one,) = run.fracture_energy
    assert one.area > 0.0
    assert 0.5 < one.ratio < 1.0


def test_a_second_run_counts_from_its_own_start(one_thread: None) -> None:
    """Bonds keep what they have dissipated; neither kind of loss begins with it."""
    model, state = thrown(SOFT, 30.0)
    dt = time_step(model, 0.4)
    first = bd.solve_explicit(model, duration=2e-5, dt=dt, every=20, state=state)
    second = bd.solve_explicit(model, duration=2e-5, dt=dt, every=20, state=first.state)
    rows, lost = second.state.cracks, second.history.energy
    absorbed = G_F * model.lattice.facets.area[model.layout.bond_order][rows[:, FACET].astype(int)]
    held = np.minimum(rows[:, SPENT], absorbed)
    for kind, whole in (("fracture", held), ("crushing", rows[:, SPENT] - held)):
        assert first.history.energy[kind][-1] > 0.0
        assert lost[kind][0] == 0.0
        both = first.history.energy[kind][-1] + lost[kind][-1]
        assert both == pytest.approx(whole.sum(), rel=1e-9)


def test_kinds_of_loss_do_not_depend_on_threads() -> None:
    model, _ = thrown(ROCK, 30.0)
    records = []
    for count in (1, most_threads()):
        with threads(count):
            run = bd.solve_explicit(model, duration=5e-5, every=10, state=thrown(ROCK, 30.0)[1])
            records.append(run.history.records)
    np.testing.assert_array_equal(*records)


def test_beams_crush_beyond_the_energy_that_they_absorb(one_thread: None) -> None:
    """λ0 λf; of beams that store more as they begin, G_f A, or G_II A where shear is the larger part."""
    failure = bd.MohrCoulomb(
        tension=1e6, cohesion=1e6, friction_angle=0.5, fracture_energy=10.0, fracture_energy_shear=30.0
    )
    law = bd.EulerBernoulli(E=1e9, nu=0.3, radius=0.35e-3)
    model = bd.Model(row(4), law, 1000.0, failure=failure)
    state, area, spent = model.state(), math.pi * 0.35e-3**2, 1e-4
    state.integrity[:] = 0.0
    tension, shear = MODES.index("tension"), MODES.index("shear")
    state.softened = np.array([
        [0.0, 1e-3, 8e-3, 0.0, spent, shear, 0.0],
        [1.0, 1.0, 1.05, 0.0, spent, tension, 0.0],
        [2.0, 1.0, 1.05, 0.0, spent, shear, 0.0],
    ])
    absorbed = [8e-6, 10.0 * area, 30.0 * area]
    record = bd.History(CoreLoop(model, bd.Plan(duration=1.0, dt=1e-9, every=1), state, 1e-9).record_present())
    assert record.energy["crushing"][0] == pytest.approx(3.0 * spent - sum(absorbed), rel=1e-12)
    (one,) = fracture_energies(state)
    assert (one.area, one.dissipated) == (pytest.approx(3.0 * area), pytest.approx(3.0 * spent))
    assert one.entered == pytest.approx(sum(absorbed) / (3.0 * area))
    state.begin(model)
    again = bd.History(CoreLoop(model, bd.Plan(duration=1.0, dt=1e-9, every=1), state, 1e-9).record_present())
    assert again.energy["crushing"][0] == 0.0


def test_brittle_facets_fracture_only(one_thread: None) -> None:
    """They have no fracture energy; what they release is that which they store."""
    model, state = thrown(bd.Rankine(tension=F_T), 10.0)
    run = bd.solve_explicit(model, duration=3e-5, every=20, state=state)
    assert run.history.energy["fracture"][-1] > 0.0
    assert not run.history.energy["crushing"].any()
    assert math.isnan(run.fracture_energy[0].entered)
    assert "G_f" not in run.message


def test_each_criterion_has_its_fracture_energy(one_thread: None) -> None:
    """Criteria by region: areas and energies of each, in the order of `failure=`; a plane that slips has G_II."""
    body = two_cubes(10e-3)
    left, right = bd.Index([0]), bd.Index([1])
    joint = bd.MohrCoulomb(
        tension=1e6, cohesion=2e6, friction_angle=0.5, fracture_energy=40.0, fracture_energy_shear=90.0
    )
    failure = {bd.Everything(): ROCK, (left, right): joint}
    ends = [bd.Fix(left), bd.Drive(right, vx=bd.Ramp(0.0, 0.03, 1e-4))]
    model = bd.Model(body, bd.CellBond(E=30e9, nu=0.0), 2400.0, failure=failure, boundary=ends)
    run = bd.solve_explicit(model, duration=4e-3, every=50)
    rock, plane = run.fracture_energy
    assert (rock.area, plane.area) == (0.0, pytest.approx(1e-4))
    assert plane.region == (left, right)
    assert plane.entered == pytest.approx(90.0)
    assert plane.per_area == pytest.approx(40.0, rel=0.02)
    assert run.history.energy["crushing"][-1] == 0.0
