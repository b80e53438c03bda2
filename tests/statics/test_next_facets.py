"""Which facets fail next by load factors, how steps of softening follow a curve, and when an equilibrium is good."""

from dataclasses import replace

import numpy as np
import pytest

import bondem as bd
from bondem.damage.proportional_onset import onset_factors
from bondem.statics.linear import Elimination, Iteration, System
from bondem.statics.quasistatic import quasistatic_run
from bondem.statics.quasistatic.damaged_body import DamagedBody
from bondem.statics.quasistatic.equilibrium import Iterated
from bondem.statics.quasistatic.onset import StressOnset
from bondem.statics.quasistatic.sawtooth import SofteningLine, Teeth
from tests.models import pulled
from tests.specimens import uneven_bar


def begun(count: int, cut: float) -> tuple[DamagedBody, Iterated, StressOnset]:
    """A block with a cut up to a share of its height, and the way to its equilibria."""
    model = pulled(uneven_bar(count))
    system = System.of(replace(model, failure=None))
    first = Iteration(system)
    body = DamagedBody(model, system, first.root)
    search = Iterated(body.system, body.matrix, first, body.integrity)
    assert model.softening is not None
    rank = np.empty(len(body.integrity), dtype=np.int64)
    rank[model.layout.bond_order] = np.arange(len(rank))
    middle = uneven_bar(count).facets.centroid
    for k in rank[(np.abs(middle[:, 0] - 8e-3) < 1e-3) & (middle[:, 1] < cut * 8e-3)].tolist():
        body.weaken(np.array([k]), 0.0, (False, False))
    return body, search, StressOnset(body, model.softening)


@pytest.mark.parametrize("cut", [0.3, 0.9])
def test_an_equilibrium_is_good_by_the_energy_of_its_error(cut: float) -> None:
    """Of what the body stores now: what hangs together by little is no worse than a whole body."""
    body, search, _ = begun(300, cut)
    exact = Elimination(body.system).solve(body.right)[0]
    size = body.size(body.loaded(exact))
    search._renew()
    found = search.solve(body.right, np.zeros_like(exact), size)
    error = found - exact
    energy = float(error @ body.matrix.force(error))
    assert 0.0 < energy < (3.0 * 5e-5) ** 2 * size  # r·z is 0.2 to 0.8 of it
    loads = [body.loaded(u).wall[:, 0].clip(min=0.0).sum() for u in (found, exact)]
    assert loads[0] == pytest.approx(loads[1], rel=1e-3)


def test_the_size_of_a_bar_is_its_energy() -> None:
    """(1 + ν) σ² V / E of a bar in uniform tension."""
    model = pulled(uneven_bar(200))
    model = bd.Model(model.lattice, model.bond, 2500.0, failure=bd.Rankine(tension=4e6), boundary=model.boundary)
    body, _, _ = quasistatic_run._begin(model)
    found = body.loaded(Elimination(body.system).solve(body.right)[0])
    strain = 1e-6 / 16e-3
    assert body.size(found) == pytest.approx(1.2 * 40e9 * strain**2 * 16e-3 * 8e-3 * 8e-3, rel=1e-2)


@pytest.mark.parametrize("close", [0.0, 0.2])
@pytest.mark.parametrize("cut", [0.0, 0.5])
def test_no_facet_is_passed_over(cut: float, close: float) -> None:
    """What begins up to a share above the least factor is that of all facets judged one by one."""
    body, _, onset = begun(300, cut)
    found = body.loaded(Elimination(body.system).solve(body.right)[0])
    whole = np.flatnonzero(body.integrity == 1.0)
    every = onset_factors(body.facets(found), onset._strengths, whole)
    for below in (np.inf, 1.5 * float(every.min()), 0.5 * float(every.min())):
        least = min(below, float(every.min()) * (1.0 + close))
        facets, factor = onset.factors(found, whole, below, close)
        near = every <= least
        assert set(whole[near]) <= set(facets[factor <= least * (1.0 + 1e-9)])
        assert near.any() == (below > every.min())
        np.testing.assert_allclose(factor, every[np.searchsorted(whole, facets)], rtol=1e-12)
        assert factor.max(initial=0.0) <= least * (1.0 + 1e-4)


@pytest.mark.parametrize("ripple", [0.1, 0.02])
@pytest.mark.parametrize("last", [2.0, 30.0])
def test_all_steps_but_the_last_are_about_the_curve_itself(ripple: float, last: float) -> None:
    """Each ends `ripple` above it, or below the onset, and falls as far below; the last takes what is missing."""
    teeth = Teeth.of(SofteningLine(1.0, last), ripple)
    T, s = teeth.limit, teeth.integrity
    borne = (1.0 - T[:-1] / last) / (1.0 - 1.0 / last)
    np.testing.assert_allclose(s[:-2] * T[:-1], np.minimum((1.0 + ripple) * borne, 0.999), rtol=1e-9)
    np.testing.assert_allclose(s[1:-1] * T[:-1], (1.0 - ripple) * borne, rtol=1e-9)
    taken = ripple / (1.0 - ripple) * s[0] + float((s[:-1] - s[1:]) @ T**2)
    assert taken == pytest.approx(last, rel=1e-9)  # ∫ T² (-ds) of a straight line is onset × last
    assert T[-2] < T[-1] < 1.3 * last


def test_a_facet_that_begins_near_the_end_of_its_curve_breaks() -> None:
    teeth = Teeth.of(SofteningLine(1.0, 10.0), 0.1, 9.5)
    assert (len(teeth.limit), teeth.integrity.tolist()) == (0, [0.0])
