"""Facets that begin to crack by a function of the stress: bits."""

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import ExplicitResult, integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from tests.bits import assert_same_bits
from tests.specimens import bar


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


def pulled() -> list:
    return [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=0.6)]


def torn(failure: bd.Criterion, lattice: bd.Lattice, *, steps: int = 110, every: int = 20) -> ExplicitResult:
    """A body torn fast."""
    law = bd.CellBond(E=50e9, nu=0.2)
    model = bd.Model(lattice, law, density=2e3, failure=failure, boundary=pulled())
    dt = 0.9 * critical_step(model, bd.VelocityVerlet())
    return integrate(model, Plan(duration=steps * dt, dt=dt, every=every, gauges={}), loop_of=CoreLoop)


@pytest.mark.parametrize("name", ["cone", "function"])
def test_threads_and_pauses_change_no_bit(monkeypatch, name):
    results = []
    for count, every in ((1, 50), (3, 7)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        results.append(torn(FAILURES[name], bar(600, 20e-3), steps=120, every=every))
    assert len(results[0].state.cracks) > 100
    assert_same_bits(*results)
