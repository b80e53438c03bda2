"""Loads that balance within each cell, on bodies one cell thick, against the uniform stress of a continuum."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.specimens import cells

P, NU = 5e6, 0.2
ROW, SHEET = (bd.Box((3e-3, 1e-3, 1e-3)), 3), (bd.Box((10e-3, 10e-3, 1e-3)), 100)
NEEDLE = bd.Box((40e-3, 2e-3, 2e-3)), 20
ENDS = [bd.Fix(bd.Face(f"x_{side}")) for side in ("min", "max")]
SMOOTH = [bd.Fix(bd.Face(f"x_{side}"), "x", "") for side in ("min", "max")]


def pressed(**size: float) -> list[bd.Pressure]:
    return [bd.Pressure(bd.Face(f"{k}_{side}"), p) for k, p in size.items() for side in ("min", "max")]


@pytest.mark.parametrize(
    ("body", "boundary", "stress"),
    [
        (NEEDLE, pressed(y=P), (0, -P, 0)),
        (NEEDLE, SMOOTH + pressed(y=P), (-NU * P, -P, 0)),
        (SHEET, pressed(z=P), (0, 0, -P)),
        (SHEET, SMOOTH + pressed(z=P), (-NU * P, 0, -P)),
        (ROW, ENDS[:1] + pressed(y=P), (0, -P, 0)),
        (ROW, ENDS + pressed(y=P), (-NU * P, -P, 0)),
        (ROW, pressed(x=P, y=P, z=P), (-P, -P, -P)),
        (ROW, pressed(x=-P, y=1.6 * P), (P, -1.6 * P, 0)),
    ],
)
def test_pressures_on_both_faces_of_one_cell_give_their_stress(body, boundary, stress):
    model = bd.Model(cells(*body), bd.CellBond(E=30e9, nu=NU), 2500.0, boundary=boundary)
    found = bd.solve_static(model)
    np.testing.assert_allclose(found.stress, np.broadcast_to(np.diag(stress), (body[1], 3, 3)), atol=1e-7 * P)
    assert np.abs(found.displacement).max() < 40e-3 * 2.0 * P / 30e9


def test_a_small_resultant_is_refused_all_the_same():
    """A millionth of the pressure, on one face only, drives the needle away."""
    boundary = [*pressed(y=P), bd.Pressure(bd.Face("y_max"), 1e-6 * P)]
    with pytest.raises(InputError, match="rigid motion"):
        bd.solve_static(bd.Model(cells(*NEEDLE), bd.CellBond(E=30e9, nu=NU), 2500.0, boundary=boundary))


def test_a_torque_about_a_row_of_single_facets_is_refused():
    """Facets resist no rotation about their normals, so that clamped ends leave the row free to turn about itself."""
    twist = bd.Load(bd.Index(1), moment=(1e-3, 0.0, 0.0))
    model = bd.Model(cells(*ROW), bd.CellBond(E=30e9, nu=NU), 2500.0, boundary=[*ENDS, twist])
    with pytest.raises(InputError, match="rigid motion"):
        bd.solve_static(model)
