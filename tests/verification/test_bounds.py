"""Bounds that spare a step some work are never beyond what they stand for: nothing that fails is passed over."""

import numpy as np

from bondem.kernels.cell_yield import _REACH, _square, is_hot
from bondem.kernels.crack_energy import opened_at_most, opened_by
from bondem.laws.plasticity import cone_flow, invariants, yield_bound


def tensors(count: int) -> np.ndarray:
    """Stresses of all kinds: random ones, uniaxial, hydrostatic and pure shear, both signs."""
    rng = np.random.default_rng(5)
    special = np.zeros((8, 6))
    special[0, 0], special[1, 1], special[2, :3], special[3, :3] = 1.0, -1.0, 1.0, -1.0
    special[4, 3], special[5, 5], special[6, :2], special[7, :2] = 1.0, -1.0, 1.0, (1.0, -1.0)
    plain, drawn = rng.standard_normal((count, 6)), rng.standard_normal((count, 6)) * [5, 1, 1, 0, 0, 0]
    return np.concatenate([special, plain, drawn])


def test_what_bending_opens_is_at_most_its_bound() -> None:
    rng, equal = np.random.default_rng(6), 0
    for s in tensors(2000):
        bent, s = abs(rng.standard_normal()) * 3.0, tuple(s)
        exact, bound = opened_by(bent, s), opened_at_most(bent, s)
        assert exact <= bound + 1e-12
        equal += bound == exact
    assert 0 < equal < 4008  # neither always sharp nor never


def test_a_calm_cell_neither_yields_nor_begins_to_crack() -> None:
    rng, close = np.random.default_rng(7), 0.0
    for s in tensors(2000):
        s, bent = tuple(s), abs(rng.standard_normal())
        size = np.sqrt(_REACH * (_square(s) + bent))
        assert not is_hot(s, bent, 1.0000001 * size)
        p, q = invariants(s)
        for sine in (0.0, 0.5, 0.95, 1.0):
            strength = np.sqrt(_REACH * _square(s))
            assert yield_bound(p, q, sine, strength) <= 0.0
            assert cone_flow(p, q, 0.3 * sine, strength, 1.0) <= 0.0
            close = max(close, (yield_bound(p, q, sine, 0.0)) / strength)
    assert 0.85 < close <= 1.0  # of use; 1.26 of 1.42
