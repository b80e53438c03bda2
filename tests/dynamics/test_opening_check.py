"""Cracks that open in few time steps: bounds of the error of their fracture energy, and the warning of a run."""

import warnings

import numpy as np
import pytest

import bondem as bd
from bondem.damage.bilinear import Bilinear
from bondem.dynamics.opening_check import doubt_about_openings, opening_error
from bondem.errors import UnresolvedOpeningWarning
from tests.specimens import two_cubes

EDGE, E, TENSION = 1e-3, 50e9, 5e6


def pair(curve: Bilinear | None = None, *, first: float = 0.01) -> bd.Model:
    """Two cells whose facet reaches its strength at the share `first` of the last opening of a straight line."""
    energy = 0.5 * TENSION**2 * EDGE / E / first
    failure = bd.Rankine(tension=TENSION, fracture_energy=energy, curve=curve)
    return bd.Model(two_cubes(EDGE), bd.CellBond(E=E, nu=0.0), density=1e7, failure=failure)


@pytest.mark.parametrize("curve", [None, bd.Bilinear()])
@pytest.mark.parametrize("first", [0.01, 0.1, 0.4])
def test_the_trapezoidal_rule_errs_by_no_more(curve: Bilinear | None, first: float) -> None:
    """Forces on the curve at the ends of steps, which begin anywhere: their work against the area."""
    table = pair(curve, first=first).softening
    assert table is not None
    start, kink, steep = table.strength[0] / table.last[0], table.kink, table.steep
    corners = [0.0, start, start + (steep - start) * (1.0 - kink), 1.0]
    force = [0.0, 1.0, kink, 0.0]
    area = np.trapezoid(force, corners)
    found = []
    for size in np.linspace(0.02, 0.4, 60):
        for phase in np.linspace(0.0, 1.0, 7):
            u = np.concatenate([[0.0], np.arange(phase, 2.0 / size) * size])
            f = np.interp(u, corners, force)
            steps = np.argmax(u >= 1.0) - np.argmax(u >= start)
            bound = float(opening_error(table, np.zeros(1, dtype=int), np.array([float(steps)]))[0])
            found.append((abs(np.trapezoid(f, u) - area) / area, bound))
    errors, bounds = np.array(found).T
    assert errors.max() > 0.1
    assert (errors < bounds + 1e-12).all()
    assert (errors > 0.1 * bounds).mean() > 0.2


def test_a_run_whose_cracks_open_in_few_steps_says_so_once() -> None:
    model = pair(bd.Bilinear())
    state = model.state()
    state.velocity = np.array([[-500.0, 0.0, 0.0], [500.0, 0.0, 0.0]])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        run = bd.solve_explicit(model, duration=5e-4, dt=1e-6, state=state, imbalance=None)
    assert len(run.events) == 1
    found = [one for one in caught if issubclass(one.category, UnresolvedOpeningWarning)]
    assert len(found) == 1
    assert issubclass(UnresolvedOpeningWarning, bd.errors.FractureEnergyWarning)
    assert "1 of 1 broken facets, with 100 % of the energy" in str(found[0].message)
    assert found[0].filename == __file__


def test_steps_of_failures_in_this_run_alone_count() -> None:
    state = pair().state()
    state.time, state.step = 2e-6, 10
    state.broken = np.array([[1.95e-6, 9, 0, 1, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0]])
    state.released[:] = 2.0
    dt = 1e-7
    assert "off by 100 %" in doubt_about_openings(state, dt)
    assert "use a step of 5e-08 s" in doubt_about_openings(state, dt)
    state.released[:] = 20.0  # a tenth of what was dissipated
    assert doubt_about_openings(state, dt) == ""
    state.released[:] = 2.0
    for column, value in ((9, 100.0), (9, np.nan), (0, 0.5e-6)):
        kept, state.broken[0, column] = state.broken[0, column], value
        assert doubt_about_openings(state, dt) == ""
        state.broken[0, column] = kept
