"""Equilibria with a pressure along a crack: it stays as the crack opens, which takes the fracture energy."""

import warnings

import numpy as np
import pytest

import bondem as bd
from bondem.damage.crack_columns import LEFT
from bondem.errors import FractureEnergyWarning
from bondem.statics.quasistatic.onset import StressOnset
from bondem.statics.quasistatic.softening_facets import SofteningFacets
from tests.models import pulled
from tests.specimens import cells, cubes
from tests.statics.test_quasistatic import damaged

E, NU, STRENGTH, ENERGY, SIDE = 40e9, 0.2, 4e6, 50.0, 80e-3


def torn(shape: bd.Shape, count: int, pressure: float, **options) -> bd.QuasistaticResult:
    """A body stretched along x and pressed along y [Pa] so that it begins to crack at a factor of 1."""
    stretch = (STRENGTH + NU * pressure) / E * shape.bounds[1][0]
    boundary = [
        *(bd.Fix(bd.Face(f"{axis}_min"), translation=axis, rotation="") for axis in "xyz"),
        bd.Drive(bd.Face("x_max"), x=stretch), bd.Pressure(bd.Face("y_max"), max(pressure, 1e-3)),
    ]  # fmt: skip
    failure = bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY)
    model = bd.Model(cells(shape, count), bd.CellBond(E=E, nu=NU), 2400.0, failure=failure, boundary=boundary)
    return bd.solve_quasistatic(model, bd.Face("x_max"), ripple=0.05, **options)


@pytest.mark.parametrize("share", [0.0, 1.0, 6.0])
def test_a_cube_pressed_along_its_crack_takes_the_fracture_energy(share: float) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", FractureEnergyWarning)
        path = torn(bd.Box((SIDE,) * 3), 100, share * STRENGTH)
    assert path.peak == pytest.approx(STRENGTH * SIDE**2, rel=0.01)
    assert path.energy.sum() == pytest.approx(ENERGY * SIDE**2, rel=0.08)
    assert path.load[-1] < 0.9 * path.peak


def test_pressure_that_grows_along_an_open_crack_is_doubted() -> None:
    with pytest.warns(FractureEnergyWarning, match=r"grows to 0\.\d times the strength"):
        torn(bd.Box((20e-3, 4e-3, 4e-3)), 24, 0.08 * STRENGTH)


def test_a_run_begins_with_the_forces_beside_a_pressure() -> None:
    state = torn(bd.Box((SIDE,) * 3), 60, 3.0 * STRENGTH, most=60).state
    one = state.cracks[:, LEFT + 3] == 1.0
    assert one.sum() > 20
    run = bd.solve_explicit(state.model, duration=0.0, state=state)
    size = np.abs(state.facet_force).max()
    np.testing.assert_allclose(run.state.facet_force, state.facet_force, atol=1e-5 * size)
    force = run.state.acceleration[:, :3] / run.state.motion[:, 3:4]
    assert np.abs(force).max() < 1e-4 * size


def test_a_crack_across_another_direction_ends_the_keeping_of_pressure() -> None:
    """A row of three cubes that is pulled along x, where one facet has softened along y alone."""
    model = pulled(cubes((3, 1, 1), 1e-3), nu=0.0)
    body, table = damaged(model), model.softening
    assert table is not None
    onset, k = StressOnset(body, table), np.array([0])
    softening = SofteningFacets(body, onset, 0.1)
    body.weaken(k, 0.5, False, np.array([[0.0, 1.0, 0.0]]))
    softening._teeth[0] = onset.teeth(body.loaded(body.motion), 1, 1.0, 0.1), 0
    x = model.lattice.centre[model.layout.order][:, 0]
    motion = np.zeros((3, 6))
    motion[:, 0] = 2.0 * STRENGTH / E * x
    found = body.loaded(motion.ravel())
    assert found.traction[0, 0] == pytest.approx(2.0 * STRENGTH, rel=1e-6)  # whole along x
    assert softening.limits(found)[0] == pytest.approx(0.5, rel=1e-6)
    left, across = softening.fail(found, k, 0.5)
    np.testing.assert_array_equal(across, 0.0)
    assert left[0] == 0.5
