"""Further cases besides those of `cases.py`: cells, the non-local law, and bodies that fail."""

from collections.abc import Callable

import bondem as bd
from bits.case import ALIKE, CONTACT, NU, SHORT, Case, E, crooked, random_motion
from bits.cases import CASES

CELL = bd.CellBond(E=E, nu=NU)
CRUMBLES = {"tension": 1e5, "cohesion": 2e5, "friction_angle": 0.6}


def cells(size: int, law: bd.CellBond | bd.NonLocal = CELL, *, speed: float = 0.5, **model: object) -> Case:
    """Return the case of a body of cells, cut from an irregular grid, in random motion."""
    body = bd.connect(crooked(size).particles, method="laguerre")
    moved = random_motion(body, speed=speed)
    if not isinstance(law, bd.CellBond):
        return Case(model=bd.Model(body, law, density=1000.0, **model), **moved, share=0.5)
    return Case(model=bd.Model(body, law, density=1000.0, **model), velocity=moved["velocity"], share=0.5)


def cells_elastic(size: int) -> Case:
    return cells(size)


def cells_brittle(size: int) -> Case:
    return cells(size, failure=bd.MohrCoulomb(**CRUMBLES), contact=CONTACT, speed=2.0)


def cells_softening(size: int) -> Case:
    return cells(size, failure=bd.MohrCoulomb(**CRUMBLES, fracture_energy=2e3), speed=2.0)


def cells_softening_contact(size: int) -> Case:
    return cells(size, failure=bd.MohrCoulomb(**CRUMBLES, fracture_energy=1e3), contact=CONTACT, speed=3.0)


def non_local(size: int) -> Case:
    return cells(size, bd.NonLocal(E=E, nu=NU))


def non_local_breaking(size: int) -> Case:
    return cells(size, bd.NonLocal(E=E, nu=NU), failure=bd.Rankine(tension=5e4), contact=CONTACT)


def beams_breaking(size: int) -> Case:
    return _failing(size, bd.PeripheralStress(tension=8e5, shear=8e5), contact=CONTACT)


def beams_mohr_coulomb(size: int) -> Case:
    return _failing(size, bd.MohrCoulomb(tension=1e5, cohesion=2e5, friction_angle=0.6), bond=SHORT)


def beams_softening(size: int) -> Case:
    return _failing(size, bd.PeripheralStress(tension=5e5, shear=5e5, fracture_energy=3e4))


def _failing(
    size: int, failure: bd.Criterion, *, bond: bd.EulerBernoulli | bd.Timoshenko = ALIKE, **model: object
) -> Case:
    lattice = crooked(size)
    model = bd.Model(lattice, bond, density=1000.0, failure=failure, **model)
    return Case(model=model, **random_motion(lattice), share=0.5)


BODIES: dict[str, Callable[[int], Case]] = {
    case.__name__: case
    for case in (
        cells_elastic, cells_brittle, cells_softening, cells_softening_contact, non_local, non_local_breaking,
        beams_breaking, beams_mohr_coulomb, beams_softening,
    )
}  # fmt: skip
#: All cases: those of `cases.py` and those of this file.
ALL = CASES | BODIES
