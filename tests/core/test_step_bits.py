"""Bits of steps by the core: those of the former loop."""

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from tests.core.former_loop import FormerLoop, digest, movement
from tests.core.test_steps import HELD, LAWS, crooked, moving_state, plan_of

STATE = "pose", "motion", "acceleration", "reaction", "work", "loss"


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("damping", [None, bd.LocalDamping(0.1)], ids=["free", "damped"])
def test_the_bits_are_those_of_the_former_loop(law, damping):
    """Numbers agree on any machine, and bits where the machine gives the model and the time step the same bits."""
    model = bd.Model(crooked((5, 2, 3)), LAWS[law], density=1e3, boundary=HELD)
    plan = plan_of(model, 250, every=20, damping=damping)
    state, bonds = moving_state(model), model.bonds
    given = digest(state.pose, state.motion, bonds.kn, bonds.ks, bonds.kt, bonds.kb, np.array([plan.dt]))
    result = integrate(model, plan, state=state, loop_of=CoreLoop)
    former = FormerLoop("steps", f"{law}, {'free' if damping is None else 'damped'}")
    former.assert_close(1e-12, **movement(result.state), work=result.state.work, reaction=result.state.reaction)
    former.assert_records(1e-12, result.history.records[:-1])  # its runs did not record their end
    if given == former.numbers["given"]:
        former.assert_same(bits=np.concatenate([getattr(result.state, name).ravel() for name in STATE]))
