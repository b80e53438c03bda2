"""Rayleigh waves of the study `cell_rayleigh`: the shape in theory, and its celerity on a small body of cells."""

import numpy as np
import pytest

from validation.studies import cell_rayleigh as rayleigh


def test_root_of_a_quarter():
    # closed form for ν = 1/4: c² / c_S² = 2 − 2/√3
    found = rayleigh.Wave.of(0.25).celerity / np.sqrt(0.4)
    assert found == pytest.approx(np.sqrt(2.0 - 2.0 / np.sqrt(3.0)), rel=1e-12)


@pytest.mark.parametrize("nu", [0.0, 0.2, 0.4])
def test_shape_leaves_the_surface_free_and_turns_by_half_its_curl(nu):
    wave, k, h = rayleigh.Wave.of(nu), 3.0, 1e-5
    x = np.array([0.3, 0.3 + h, 0.3 - h, 0.3, 0.3])
    shape, turn = wave.shape(k, x, np.array([0.0, 0.0, 0.0, h, -h]))
    along, down = (shape[1] - shape[2]) / (2.0 * h), (shape[3] - shape[4]) / (2.0 * h)
    lame, G = nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 / (1.0 + nu)
    assert lame * along[0] - (lame + 2.0 * G) * down[2] == pytest.approx(0.0, abs=1e-8)
    assert -down[0] + along[2] == pytest.approx(0.0, abs=1e-8)
    assert turn[0, 1] == pytest.approx(0.5 * (-down[0] - along[2]), abs=1e-8)


@pytest.mark.validate
def test_celerity_on_nine_elements_a_wave():
    wave = rayleigh.Wave.of(0.2)
    body, size = rayleigh.slab(600, seed=1)
    assert 1.0 / size == pytest.approx(8.66, abs=0.01)
    found, _ = rayleigh.celerity(rayleigh.smooth(body, 0.2), 2, wave)
    assert found == pytest.approx(wave.celerity, rel=0.01)
