"""What several verifications share."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest

import bondem as bd
from bondem._compile import threads


@pytest.fixture
def one_thread() -> Iterator[None]:
    """Small models: threads would only wait for each other."""
    with threads(1):
        yield


@pytest.fixture
def rod(request: pytest.FixtureRequest) -> Callable[..., bd.Model]:
    """Makes straight rods of touching elements along x, of unequal radii, with LAW and RHO of the module."""

    def make(count: int, **options) -> bd.Model:
        radius = 0.5 * (1.0 + 0.2 * np.cos(np.arange(count)))
        x = np.concatenate([[0.0], np.cumsum(radius[1:] + radius[:-1])])
        pairs = np.column_stack([np.arange(count - 1), np.arange(1, count)])
        particles = bd.Particles(np.column_stack([x, 0 * x, 0 * x]), radius)
        return bd.Model(
            bd.Lattice(particles, pairs), bond=request.module.LAW, density=request.module.RHO, **options
        )

    return make
