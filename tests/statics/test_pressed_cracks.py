"""Equilibria lose the pressure along a crack, and say so where it exceeds the tension across the crack."""

import warnings

import pytest

import bondem as bd
from bondem.errors import FractureEnergyWarning
from tests.specimens import cells

E, NU, STRENGTH, SIDE = 40e9, 0.2, 4e6, 80e-3


def stretched(pressure: float) -> bd.QuasistaticResult:
    """The first cracks of a cube that is stretched along x and pressed along y, by a share of the same stress."""
    body = cells(bd.Box((SIDE,) * 3), 100)
    boundary = [
        *(bd.Fix(bd.Face(f"{axis}_min"), translation=axis, rotation="") for axis in "xyz"),
        bd.Drive(bd.Face("x_max"), x=(1.0 + NU * pressure) * STRENGTH / E * SIDE),
        bd.Pressure(bd.Face("y_max"), max(pressure, 1e-9) * STRENGTH),
    ]
    failure = bd.Rankine(tension=STRENGTH, fracture_energy=50.0)
    model = bd.Model(body, bd.CellBond(E=E, nu=NU), 2400.0, failure=failure, boundary=boundary)
    return bd.solve_quasistatic(model, bd.Face("x_max"), most=30)


def test_cracks_beside_a_pressure_are_doubted() -> None:
    with pytest.warns(FractureEnergyWarning, match=r"along the cracks is 3\.\d times"):
        stretched(3.0)


def test_cracks_beside_no_pressure_are_not_doubted() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", FractureEnergyWarning)
        assert len(stretched(0.0).factor) == 30
