"""Bodies of cells that cannot bulge: bulk modulus between smooth platens, and what is said where ν is near ½."""

import pytest

import bondem as bd
from bondem.errors import IncompressibleWarning
from tests.specimens import cube


def bulk_error(body, nu):
    """Energy of a cube stretched by smooth platens on all six sides over that of K = E / 3 (1 - 2 ν) - 1."""
    held = [bd.Fix(bd.Face(f"{a}_min"), translation=a, rotation="") for a in "xyz"]
    driven = [bd.Drive(bd.Face(f"{a}_max"), **{a: 1e-3}) for a in "xyz"]
    energy = bd.solve_static(bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0, boundary=held + driven)).energy.total
    return energy / (0.5 * 9e-6 / (3.0 * (1.0 - 2.0 * nu))) - 1.0


@pytest.mark.filterwarnings("ignore::bondem.errors.IncompressibleWarning")
@pytest.mark.parametrize(("nu", "error"), [(0.3, 0.001), (0.45, 0.006), (0.49, 0.025)])
def test_smooth_platens_do_not_soften_a_confined_body(nu, error):
    """-0.06, -0.4 and -1.9 %; with platens along which facets slide under pressure -0.2, -1.4 and -7 %."""
    assert -error < bulk_error(cube(300), nu) < 1e-9


@pytest.mark.filterwarnings("ignore::bondem.errors.IncompressibleWarning")
def test_what_is_left_is_of_all_cells_and_not_of_the_surface():
    errors = [bulk_error(cube(count), 0.49) for count in (300, 1200)]
    assert 0.5 < errors[1] / errors[0] < 1.0


def test_nearly_incompressible_cells_are_a_warning():
    with pytest.warns(IncompressibleWarning, match="nearly incompressible.*bulk modulus"):
        bd.Model(cube(300), bd.CellBond(E=1.0, nu=0.49), 1.0)
    bd.Model(cube(300), bd.CellBond(E=1.0, nu=0.45), 1.0)
