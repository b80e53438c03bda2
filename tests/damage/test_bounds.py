"""Bounds that save a step some work are never beyond what they bound: everything that fails is found."""

import numpy as np
import pytest

import bondem as bd
from bondem.damage import softening_table
from tests.core.law_samples import stress_bounds, yielding
from tests.specimens import ball


def tensors(count: int) -> np.ndarray:
    """Stresses of all kinds: random ones, uniaxial, hydrostatic and pure shear, both signs; (6, m)."""
    rng = np.random.default_rng(5)
    special = np.zeros((8, 6))
    special[0, 0], special[1, 1], special[2, :3], special[3, :3] = 1.0, -1.0, 1.0, -1.0
    special[4, 3], special[5, 5], special[6, :2], special[7, :2] = 1.0, -1.0, 1.0, (1.0, -1.0)
    plain, drawn = rng.standard_normal((count, 6)), rng.standard_normal((count, 6)) * [5, 1, 1, 0, 0, 0]
    return np.concatenate([special, plain, drawn]).T


def test_bounds_hold_what_bending_opens() -> None:
    rng, stress = np.random.default_rng(6), tensors(2000)
    opened, at_most = stress_bounds(stress, np.abs(rng.standard_normal(4008)) * 3.0)[2:]
    assert (opened <= at_most + 1e-12).all()
    assert 0 < (opened == at_most).sum() < 4008  # neither always sharp nor never


def test_below_an_impact_no_facet_is_missed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cells under the contact are pressed by many f_t; facets crack in the same step as if all were evaluated."""
    cracks = []
    for share in (softening_table._MARGIN, 0.0):
        monkeypatch.setattr(softening_table, "_MARGIN", share)
        model = bd.Model(
            ball(300, 0.05), bd.CellBond(E=30e9, nu=0.2), 2400.0,
            failure=bd.Rankine(tension=4e6, fracture_energy=50.0),
            contact=bd.LinearContact(E=30e9, friction=0.4), walls=[bd.PlaneWall((-0.05, 0.0, 0.0), (1.0, 0.0, 0.0))],
        )  # fmt: skip
        state = model.state()
        state.velocity = (-5.0, 0.0, 0.0)
        cracks.append(bd.solve_explicit(model, duration=6e-5, state=state).state.cracks)
    assert len(cracks[0]) > 100
    np.testing.assert_array_equal(*cracks)


def test_a_calm_cell_does_not_yield() -> None:
    """A cell with 2.01 σ:σ below the square of its strength is not evaluated in a step."""
    stress, close = tensors(2000), 0.0
    strength = np.sqrt(2.01 * ((stress**2).sum(axis=0) + (stress[3:] ** 2).sum(axis=0)))
    same = np.ones(stress.shape[1])
    for sine in (0.0, 0.5, 0.95, 1.0):
        by = np.array([strength, sine * same, 0.1 * same, same, 0.0 * same])
        bound, gamma = yielding(stress, by, cone=False)[:2]
        assert (bound <= 0.0).all()
        assert (gamma == 0.0).all()
        on_cone = yielding(stress, np.array([strength, 0.3 * sine * same, 0.1 * same, same, 0.0 * same]), cone=True)
        assert (on_cone[1] == 0.0).all()
        close = max(close, ((bound + strength) / strength).max())
    assert 0.85 < close <= 1.0  # of use; 1.26 of 1.42
