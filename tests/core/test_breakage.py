"""Breakage of beams by the damage pipeline of the core: against numbers of the former loop, and bits."""

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.model.model import Model
from tests.bits import assert_same_bits
from tests.core.former_loop import FormerLoop, movement
from tests.core.test_steps import HELD, LAWS, crooked, moving_state, plan_of

PERIPHERAL = bd.PeripheralStress(tension=4e5, shear=8e5)
MOHR_COULOMB = bd.MohrCoulomb(tension=3e5, cohesion=3e5, friction_angle=0.5)
LINEAR = bd.LinearSum(force=4e4, shear=4e4, bending=4e3, twisting=4e3)
ELLIPTIC = bd.Elliptic(elongation=0.05, rotation=0.1)


def breaking(law: str, failure: bd.Criterion, shape: tuple[int, int, int] = (6, 4, 4), **options) -> Model:
    weight = bd.BodyForce((10.0, 0.0, -50.0), schedule=bd.Ramp(0.0, 1.0, 0.01))
    return bd.Model(crooked(shape), LAWS[law], density=1e3, boundary=[*HELD, weight], failure=failure, **options)


def assert_close(result: bd.ExplicitResult, former: FormerLoop) -> None:
    """Compare positions, velocities, energies and events."""
    state = result.state
    former.assert_same(events=state.broken[:, 1:4])
    names = "work", "loss", "released", "integrity"
    former.assert_close(1e-10, **movement(state), **{name: getattr(state, name) for name in names})
    former.assert_records(1e-10, result.history.records)


@pytest.mark.parametrize(
    ("law", "failure", "damping"),
    [
        ("Timoshenko", PERIPHERAL, None),
        ("parallel", MOHR_COULOMB, bd.BondDamping(eta=0.2)),
        ("parallel", LINEAR, bd.MassDamping(20.0)),
        ("Timoshenko", ELLIPTIC, [bd.BondDamping(eta=0.1), bd.LocalDamping(0.05)]),
    ],
    ids=["peripheral stress", "Mohr–Coulomb", "linear sum", "elliptic"],
)  # fmt: skip
@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
def test_breakage_is_that_of_the_former_loop(law, failure, damping):
    model = breaking(law, failure)
    plan = plan_of(model, 300, every=20, damping=damping)
    result = integrate(model, plan, state=moving_state(model), loop_of=CoreLoop)
    assert len(result.state.broken) > 30
    assert_close(result, FormerLoop("breakage", f"{law}, {type(failure).__name__}"))


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
def test_threads_and_pauses_change_no_bit(monkeypatch):
    model = breaking("Timoshenko", PERIPHERAL, (12, 10, 10))
    results = []
    for count, every in ((1, 50), (2, 50), (3, 7), (4, 0)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        plan = plan_of(model, 150, every=every, damping=bd.BondDamping(eta=0.1))
        results.append(integrate(model, plan, state=moving_state(model), loop_of=CoreLoop))
    assert len(results[0].state.broken) > 30
    for other in results[1:]:
        assert_same_bits(results[0], other)
    np.testing.assert_array_equal(results[0].history.records, results[1].history.records)
