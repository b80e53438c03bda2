"""Rattlers: loads and supports leave them out; motions, strains, laws and means of a region include them."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import EmptyRegionError

# A chain of three spheres along x, and beside it a loose pair that just touches none of them.
BODY = bd.Lattice(
    bd.Particles([[0, 0, 0], [2, 0, 0], [4, 0, 0], [0, 2.1, 0], [2, 2.1, 0]], 1.0), [(0, 1), (2, 1), (3, 4)]
)
LAW = bd.EulerBernoulli(E=1e9, nu=0.25, radius=0.5)
STRONG = bd.PeripheralStress(tension=1e5, shear=1e5)
V, W = np.array([0.0, 50.0, 0.0]), np.array([0.0, 0.0, 3.0])


def test_a_body_with_rattlers_flies_as_a_rigid_body() -> None:
    """v + ω × (x - x_c) in every element, with the momentum M v; in flight nothing touches and no bond breaks."""
    model = bd.Model(BODY, LAW, 1000.0, contact=bd.LinearContact(E=1e9), failure=STRONG)
    state = model.state()
    state.set_velocity(bd.Everything(), (0.0, 50.0, 0.0), spin=(0.0, 0.0, 3.0))
    x = BODY.centre
    np.testing.assert_allclose(state.velocity, V + np.cross(W, x - x.mean(axis=0)), atol=1e-12)
    np.testing.assert_array_equal(state.angular_velocity, np.tile(W, (5, 1)))
    np.testing.assert_allclose(model.mass @ state.velocity, model.mass.sum() * V, atol=1e-6)
    state.set_velocity(bd.Body(0), (0.0, 50.0, 0.0))
    run = bd.solve_explicit(model, state=state, duration=0.1)
    np.testing.assert_allclose(run.state.velocity, np.tile(V, (5, 1)), rtol=1e-9, atol=1e-9)
    assert not len(run.events)


def test_rattlers_alone_are_a_region_that_moves_and_that_nothing_can_support() -> None:
    state = bd.Model(BODY, LAW, 1000.0, boundary=bd.Gravity(region=bd.Index([3, 4]))).state()
    state.set_velocity(bd.Index([3, 4]), (0.0, 50.0, 0.0))
    assert state.velocity[:, 1].tolist() == [0.0, 0.0, 0.0, 50.0, 50.0]
    with pytest.raises(EmptyRegionError, match="no connected element"):
        bd.Model(BODY, LAW, 1000.0, boundary=bd.Fix(bd.Index([3, 4])))
    with pytest.raises(EmptyRegionError, match="selects no element"):
        state.set_velocity(bd.Within(bd.Ball(0.1).moved((9.0, 9.0, 9.0))), (0.0, 50.0, 0.0))


def test_laws_criteria_and_strains_of_everything_are_those_of_all_bonds() -> None:
    whole = bd.Model(BODY, LAW, 1000.0, failure=STRONG, boundary=bd.Eigenstrain([1e-3] * 5))
    parts = bd.Model(
        BODY, {bd.Everything(): LAW}, 1000.0, failure={bd.Everything(): STRONG}, boundary=bd.Eigenstrain(1e-3)
    )
    assert (parts.stiffness.kn > 0.0).all()
    np.testing.assert_array_equal(parts.stiffness.kn, whole.stiffness.kn)
    np.testing.assert_array_equal(bd.Eigenstrain(1e-3).parts(BODY), [1e-3] * 3)
    ends = []
    for model in (whole, parts):
        state = model.state()
        state.set_velocity(bd.Index([4]), (5000.0, 0.0, 0.0))  # tears the loose pair apart
        ends.append(bd.solve_explicit(model, state=state, duration=2e-3).state)
    assert ends[0].bond_integrity.tolist() == ends[1].bond_integrity.tolist()
    assert ends[1].bond_integrity[2] == 0.0


def test_the_mean_stress_counts_the_volume_of_rattlers() -> None:
    """Pulled by F over a length L: the mean over the body of volume V is F L / V, with loose spheres within it."""
    held = [bd.Fix(bd.Index([0])), bd.Load(bd.Index([2]), (7.0, 0.0, 0.0))]
    model = bd.Model(BODY, LAW, 1000.0, boundary=held)
    found = bd.element_stress(model, bd.solve_static(model))
    assert found.mean(bd.Everything())[0, 0] == pytest.approx(7.0 * 4.0 / found.volume.sum(), rel=1e-9)
    assert not found.mean(bd.Index([3, 4])).any()
    assert not found.mean_couple(bd.Index([3, 4])).any()
