"""Clouds of spheres that collide: what every law of contact keeps, whatever resists or attracts beside it."""

from dataclasses import replace

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from tests.core.contact_cases import HERTZIAN, ROLLING, STICKY, cloud, plan_of
from tests.models import momenta

LAWS = {
    "rolling, linear": ROLLING,
    "rolling, Hertzian": replace(HERTZIAN, rolling=0.3, twisting=0.2),
    "adhesion, linear": STICKY,
    "adhesion, Hertzian": replace(HERTZIAN, adhesion=STICKY.adhesion),
}
# clouds are fast and soft
pytestmark = [
    pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning"),
    pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning"),
]


@pytest.mark.parametrize("law", LAWS.values(), ids=list(LAWS))
def test_momentum_and_energy_of_a_cloud_are_kept(law: bd.ContactLaw) -> None:
    missed = []
    for share in (0.4, 0.1):
        model, state = cloud(4, law)
        before = momenta(model, state)
        plan = plan_of(model, round(200 / share), share=share, every=round(20 / share))
        result = integrate(model, plan, state=state)
        for now, then in zip(momenta(model, result.state), before, strict=True):
            np.testing.assert_allclose(now, then, rtol=0, atol=1e-11 * np.abs(model.mass).sum() * 8.0 * 9.0)
        missed.append(result.history.imbalance)
    assert missed[1] < 2e-4
    assert missed[0] / missed[1] > 6.0
