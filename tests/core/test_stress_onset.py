"""Facets that begin to crack by a function of the stress: against the loops of Numba, bits, errors of functions."""

import numpy as np
import pytest

import bondem as bd
from bondem._compile import threads
from bondem.solve import loop_core
from bondem.solve.explicit import ExplicitResult, integrate
from bondem.solve.loop_core import CoreLoop
from bondem.solve.loop_cpu import CpuLoop
from bondem.solve.plan import Plan
from bondem.solve.timestep import critical_step
from tests.bits import assert_same_bits


def largest(stress, tension):
    return np.linalg.eigvalsh(stress)[:, 2] / tension


FAILURES = {
    "cone": bd.DruckerPrager(
        tension=2e6, compression=8e6, fracture_energy=2.0, dilatancy=0.1,
        scatter=bd.Weibull(modulus=8.0, volume=1e-9),
    ),
    "mean stress": bd.Hydrostatic(tension=1e6, fracture_energy=2.0),
    "function": bd.StressCriterion(largest, tension=2.2e6),
}  # fmt: skip


def torn(failure: bd.Criterion, kind: type, *, count: int = 250, steps: int = 110, every: int = 20) -> ExplicitResult:
    """A body torn fast."""
    particles = bd.pack(bd.Box((20e-3, 10e-3, 10e-3)), count=count, method="even", seed=1)
    boundary = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=0.6)]
    law = bd.CellBond(E=50e9, nu=0.2)
    model = bd.Model(bd.connect(particles, method="laguerre"), law, density=2e3, failure=failure, boundary=boundary)
    dt = 0.9 * critical_step(model, bd.VelocityVerlet())
    return integrate(model, Plan(duration=steps * dt, dt=dt, every=every, gauges={}), loop_of=kind)


@pytest.mark.parametrize("name", FAILURES)
def test_cracks_are_those_of_the_loops_of_numba(name):
    with threads(1):
        old, new = (torn(FAILURES[name], kind) for kind in (CpuLoop, CoreLoop))
    assert len(new.state.cracks) > 100
    a, b = (one.state.cracks[np.argsort(one.state.cracks[:, 0])] for one in (new, old))
    np.testing.assert_array_equal(a[:, 0], b[:, 0])
    np.testing.assert_allclose(a[:, 1], b[:, 1], rtol=1e-8)  # strengths in the direction of cracks
    for x, y in ((new.state.position, old.state.position), (new.state.released, old.state.released)):
        np.testing.assert_allclose(x, y, rtol=0.0, atol=1e-10 * np.abs(y).max())
    energies = np.abs(old.history.records[:, 1:14]).max()
    np.testing.assert_allclose(
        new.history.records[:, 1:], old.history.records[:, 1:], rtol=0.0, atol=1e-10 * energies
    )


@pytest.mark.parametrize("name", ["cone", "function"])
def test_threads_and_pauses_change_no_bit(monkeypatch, name):
    results = []
    for count, every in ((1, 50), (3, 7)):
        monkeypatch.setattr(loop_core, "current_threads", lambda count=count: count)
        results.append(torn(FAILURES[name], CoreLoop, count=600, steps=120, every=every))
    assert len(results[0].state.cracks) > 100
    assert_same_bits(*results)
