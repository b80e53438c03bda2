"""Tests to failure as rows of a report: the strength that was measured beside the one that was put in."""

from collections.abc import Callable

import numpy as np

from bondem.errors import InputError
from bondem.labtests.compression import uniaxial_compression
from bondem.labtests.outcome import Outcome
from bondem.labtests.rig import StrengthTest
from bondem.labtests.tearing import direct_tension
from bondem.laws.cell_bond import CellBond
from bondem.laws.failure.criterion import Criterion
from bondem.specimen.lattice import Lattice


def strength_outcome(
    name: str,
    body: Lattice,
    law: CellBond,
    failure: Criterion,
    *,
    density: float,
    progress: Callable[[float], None] | None = None,
) -> Outcome:
    """Strength in "direct_tension" or uniaxial compression, "ucs" [Pa].

    Args:
        name: of the test.
        body: cut into cells.
        law, failure: its material.
        density: of the material [kg/m³].
        progress: called now and then with the share done, 0 … 1.

    Raises:
        InputError: another test, or a criterion without the strength that it needs.
    """
    softening = failure.softening
    if softening is None:
        raise InputError(f"labtests: {name} needs the strengths of a material; give its fracture_energy too")
    if name == "direct_tension":
        theory = softening.tension
        test = direct_tension(body, law, failure, density=density, progress=progress)
    elif name == "ucs" and softening.slip is not None:
        theory = softening.slip.compressive()
        test = uniaxial_compression(body, law, failure, density=density, progress=progress)
    else:
        raise InputError(f"labtests: {name} is no test to failure of such a material; there are direct_tension, ucs")
    return Outcome(name=name, measured=test.peak, theory=theory, unit="Pa", curves=_curves(test, body))


def _curves(test: StrengthTest, body: Lattice) -> dict[str, np.ndarray]:
    """Curve, and what figures show of the broken specimen."""
    state, whole = test.state, test.state.bond_integrity
    damage = np.zeros(len(body.particles))
    for end in body.pairs.T:
        np.maximum.at(damage, end, 1.0 - whole)
    return {
        "strain": test.curve[:, 0], "stress": test.curve[:, 1], "work": np.array(test.work),
        "displacement": state.displacement, "orientation": state.orientation, "damage": damage, "slip": state.slipped,
    }  # fmt: skip
