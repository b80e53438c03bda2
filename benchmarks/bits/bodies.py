"""Further cases besides those of `cases.py`: cells, the non-local law, and bodies that fail."""

from collections.abc import Callable
from functools import partial

import bondem as bd
from bits.case import ALIKE, CONTACT, NU, SHORT, Case, E, crooked, random_motion
from bits.cases import CASES

CELL = bd.CellBond(E=E, nu=NU)
CRUMBLES = {"tension": 1e5, "cohesion": 2e5, "friction_angle": 0.6}


SPLITS = bd.MohrCoulomb(**CRUMBLES)


def softens(energy: float) -> bd.MohrCoulomb:
    return bd.MohrCoulomb(**CRUMBLES, fracture_energy=energy)


def cells(size: int, law: bd.CellBond | bd.NonLocal = CELL, *, speed: float = 0.5, **model: object) -> Case:
    """Return the case of a body of cells, cut from an irregular grid, in random motion."""
    body = bd.connect(crooked(size).particles, method="laguerre")
    moved = random_motion(body, speed=speed)
    if isinstance(law, bd.CellBond):
        del moved["turn"]
    return Case(model=bd.Model(body, law, density=1000.0, **model), **moved, share=0.5)


def beams(size: int, failure: bd.Criterion, *, bond: bd.EulerBernoulli | bd.Timoshenko = ALIKE, **model) -> Case:
    """Beams of a crooked grid in random motion, which fail."""
    lattice = crooked(size)
    model = bd.Model(lattice, bond, density=1000.0, failure=failure, **model)
    return Case(model=model, **random_motion(lattice), share=0.5)


LAG = bd.NonLocal(E=E, nu=NU)
BODIES: dict[str, Callable[[int], Case]] = {
    "cells_elastic": cells,
    "cells_brittle": partial(cells, failure=SPLITS, contact=CONTACT, speed=2.0),
    "cells_softening": partial(cells, failure=softens(2e3), speed=2.0),
    "cells_softening_contact": partial(cells, failure=softens(1e3), contact=CONTACT, speed=3.0),
    "non_local": partial(cells, law=LAG),
    "non_local_breaking": partial(cells, law=LAG, failure=bd.Rankine(tension=5e4), contact=CONTACT),
    "beams_breaking": partial(beams, failure=bd.PeripheralStress(tension=8e5, shear=8e5), contact=CONTACT),
    "beams_mohr_coulomb": partial(beams, failure=SPLITS, bond=SHORT),
    "beams_softening": partial(beams, failure=bd.PeripheralStress(tension=5e5, shear=5e5, fracture_energy=3e4)),
}
#: The cases of `cases.py`, whose number is 29, and those of this file.
ALL = CASES | BODIES
