"""Strain gauges: relative changes of length of lines of material, whatever the rotation of the body."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import bondem as bd
from tests.specimens import grid

LATTICE = grid((4, 3, 3))
MODEL = bd.Model(LATTICE, bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5), 2500.0)
GAUGES = {"strain": bd.StrainGauge(bd.Everything())}
STRAINS = {"none": (0.0, 0.0, 0.0), "small": (1e-7, -3e-8, 2e-8), "large": (0.2, -0.1, 0.05)}


@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.0), (0.0, 0.0, 0.022), (0.3, -0.8, 0.5)])
@pytest.mark.parametrize("strain", STRAINS.values(), ids=STRAINS)
def test_a_body_that_is_stretched_and_turned_shows_its_stretch(strain, turn) -> None:
    state, turned = MODEL.state(), Rotation.from_rotvec(turn)
    deformation = turned.as_matrix() @ np.diag(1.0 + np.array(strain))
    state.position = LATTICE.centre @ deformation.T + 1e-3
    state.orientation = turned.as_quat(scalar_first=True)
    run = bd.solve_explicit(MODEL, duration=0.0, state=state, gauges=GAUGES)
    np.testing.assert_allclose(run.history["strain"][0], strain, rtol=0.0, atol=1e-13)


def test_a_sheared_body_shows_the_length_of_its_lines() -> None:
    """A simple shear γ moves x by γ y: lines along y grow to √(1 + γ²), those along x and z keep their length."""
    state, shear = MODEL.state(), 0.3
    state.displacement = shear * LATTICE.centre[:, [1]] * [1.0, 0.0, 0.0]
    run = bd.solve_explicit(MODEL, duration=0.0, state=state, gauges=GAUGES)
    np.testing.assert_allclose(run.history["strain"][0], [0.0, np.hypot(1.0, shear) - 1.0, 0.0], rtol=0.0, atol=1e-13)
