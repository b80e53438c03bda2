"""Bodies of cells that cannot bulge: bulk modulus between smooth platens."""

import pytest

import bondem as bd
from tests.specimens import cube


def bulk_error(body, nu):
    """Energy of a cube stretched by smooth platens on all six sides over that of K = E / 3 (1 - 2 ν) - 1."""
    held = [bd.Fix(bd.Face(f"{a}_min"), translation=a, rotation="") for a in "xyz"]
    driven = [bd.Drive(bd.Face(f"{a}_max"), **{a: 1e-3}) for a in "xyz"]
    energy = bd.solve_static(bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0, boundary=held + driven)).energy.total
    return energy / (0.5 * 9e-6 / (3.0 * (1.0 - 2.0 * nu))) - 1.0


@pytest.mark.parametrize("nu", [0.3, 0.45, 0.49, 0.499, 0.4999])
def test_a_confined_body_has_the_bulk_modulus_of_its_material(nu):
    """Shares that leave an error of θ in each cell soften it by 0.06 to 15 % from ν = 0.3 to 0.499."""
    assert abs(bulk_error(cube(300), nu)) <= 1e-6
