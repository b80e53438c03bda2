"""The clamped continuum of the studies: its meshes of several finenesses against closed forms."""

import math

import numpy as np
import pytest

from validation.measures import fem_cylinder as fem


@pytest.fixture(scope="module")
def cylinder():
    return fem.Continuum(4)


def test_a_disc_is_halved_without_a_change_of_its_outline():
    points, quads = fem.disc(8)
    finer, four, interpolation = fem.halved(points, quads)
    assert len(four) == 4 * len(quads)
    assert np.allclose(interpolation.sum(axis=1), 1.0)

    def area(points: np.ndarray, quads: np.ndarray) -> np.ndarray:
        diagonals = points[quads[:, 2:]] - points[quads[:, :2]]
        return 0.5 * (diagonals[:, 0, 0] * diagonals[:, 1, 1] - diagonals[:, 0, 1] * diagonals[:, 1, 0])

    assert (area(finer, four) > 0.0).all()
    assert area(finer, four).sum() == pytest.approx(area(points, quads).sum(), rel=1e-12)


def test_no_force_in_rigid_motion_and_a_uniform_stress_across_changes_of_the_mesh(cylinder):
    x, y, z = cylinder.points.T
    scale = fem.E * fem.SHAPE.radius
    for motion in ((1.0 + 0 * x, 0 * x, 0 * x), (-y / 5e-3, x / 5e-3, 0 * x)):
        assert np.abs(cylinder.K @ np.stack(motion, axis=1).ravel()).max() < 1e-9 * scale
    # u = ε (x, -ν y, -ν z): σ_xx = E ε, nothing else, so that forces act on the two end faces only
    stretch = np.stack([x, -fem.NU * y, -fem.NU * z], axis=1).ravel()
    force = (cylinder.K @ stretch).reshape(-1, 3)
    inside = (x > 1e-9) & (x < fem.SHAPE.length - 1e-9)
    assert np.abs(force[inside]).max() < 1e-9 * np.abs(force).max()
    assert -force[x < 1e-9, 0].sum() == pytest.approx(fem.E * cylinder.bar.section.area, rel=1e-9)


def test_mass_is_that_of_the_mesh(cylinder):
    assert cylinder.lumped[::3].sum() == pytest.approx(fem.RHO * cylinder.bar.section.area * fem.SHAPE.length)
    octagon = 4.0 * math.sin(0.25 * math.pi) * fem.SHAPE.radius**2
    assert cylinder.bar.section.area == pytest.approx(octagon, rel=1e-9)


@pytest.mark.validate
def test_the_first_frequencies_are_those_of_the_bar(cylinder):
    x, y, z = cylinder.points.T
    solve = cylinder.solver(x < 1e-9)
    zero = np.zeros_like(x)
    shapes = [np.stack(part, axis=1).ravel() for part in ((x, zero, zero), (zero, x**2, zero), (zero, zero, x**2),
                                                          (zero, -x * z, x * y))]  # fmt: skip
    static = np.stack([solve(cylinder.K @ shape) for shape in shapes], axis=1)
    axial, bending, torsion = cylinder.frequencies(solve, static)
    # the clamped face keeps its size, which the bar of theory does not
    assert axial == pytest.approx(cylinder.bar.axial_frequency, rel=5e-3)
    assert bending == pytest.approx(cylinder.bar.bending_frequency_timoshenko, rel=1e-2)
    assert torsion == pytest.approx(cylinder.bar.torsional_frequency, rel=5e-3)
