"""Bits of steps by the core: those of the loops of Numba that it replaces."""

import numpy as np
import pytest

import bondem as bd
from bondem._compile import threads
from bondem.solve.explicit import integrate
from bondem.solve.loop_core import CoreLoop
from bondem.solve.loop_cpu import CpuLoop
from tests.bits import assert_same_bits
from tests.core.test_steps import HELD, LAWS, crooked, moving_state, plan_of


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("damping", [None, bd.LocalDamping(0.1)], ids=["free", "damped"])
def test_the_bits_are_those_of_the_loops_of_numba(law, damping):
    model = bd.Model(crooked((5, 2, 3)), LAWS[law], density=1e3, boundary=HELD)
    plan = plan_of(model, 250, every=20, damping=damping)
    with threads(1):
        old, new = (integrate(model, plan, state=moving_state(model), loop_of=kind) for kind in (CpuLoop, CoreLoop))
    assert_same_bits(old, new)
    np.testing.assert_allclose(new.history.records, old.history.records, rtol=1e-12, atol=1e-12)
