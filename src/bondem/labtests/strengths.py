"""Tests to failure as rows of a report: the strength that was measured beside the one that was put in."""

import math
from collections.abc import Callable, Mapping

import numpy as np

from bondem.errors import InputError
from bondem.labtests.compression import uniaxial_compression
from bondem.labtests.confined import triaxial
from bondem.labtests.flexure import BendingTest, three_point_bending
from bondem.labtests.ledger import AnyTest, energy_ledger
from bondem.labtests.outcome import Outcome
from bondem.labtests.punching import shear
from bondem.labtests.splitting import brazilian
from bondem.labtests.tearing import direct_tension
from bondem.laws.cell_bond import CellBond
from bondem.laws.failure.criterion import Criterion
from bondem.laws.failure.softening import Softening
from bondem.specimen.lattice import Lattice

#: Tests to failure, by the names of studies, and what can be asked of each (a unit; `needed` has no default).
STRENGTH_TESTS: Mapping[str, Mapping[str, str]] = {
    "direct_tension": {}, "ucs": {}, "brazilian": {"half_angle": "rad"}, "triaxial": {"pressure": "Pa"},
    "three_point_bending": {"span": "m"}, "shear": {},
}  # fmt: skip
#: What has no default.
NEEDED = (("triaxial", "pressure"),)


def strength_outcome(
    name: str,
    body: Lattice,
    law: CellBond,
    failure: Criterion,
    *,
    density: float,
    options: Mapping[str, float] | None = None,
    progress: Callable[[float], None] | None = None,
) -> Outcome:
    """Strength in a test of `STRENGTH_TESTS` [Pa], and what the strengths of the material imply.

    That is f_t in direct tension and in the Brazilian test, and the line of the criterion in compression. Bending and
    the
    shear test have no closed form: their theory is NaN.

    Args:
        name: of the test.
        body: cut into cells.
        law, failure: its material.
        density: of the material [kg/m³].
        options: of the test, as in `STRENGTH_TESTS`.
        progress: called now and then with the share done, 0 … 1.

    Raises:
        InputError: another test, or a criterion without the strength that it needs.
    """
    softening = failure.softening
    if softening is None:
        raise InputError(f"labtests: {name} needs the strengths of a material; give its fracture_energy too")
    asked = dict(options or {})
    if name not in STRENGTH_TESTS or (needs_slip(name) and softening.slip is None):
        raise InputError(
            f"labtests: {name} is no test to failure of such a material; there are {', '.join(STRENGTH_TESTS)}"
        )
    given = {"density": density, "progress": progress}
    test: AnyTest
    match name:
        case "direct_tension":
            test = direct_tension(body, law, failure, **given)
        case "ucs":
            test = uniaxial_compression(body, law, failure, **given)
        case "triaxial":
            test = triaxial(body, law, failure, **asked, **given)
        case "brazilian":
            test = brazilian(body, law, failure, **asked, **given)
        case "shear":
            test = shear(body, law, failure, **given)
        case _:
            test = three_point_bending(body, law, failure, span=asked.get("span"), progress=progress)
    theory = _implied(name, softening, asked)
    return Outcome(
        name=name, measured=test.peak, theory=theory, unit="Pa", curves=_curves(test, body), state=test.state,
        energy=energy_ledger(test),
    )  # fmt: skip


def needs_slip(name: str) -> bool:
    """Whether a test is of a material whose cells yield."""
    return name in ("ucs", "triaxial")


def _implied(name: str, softening: Softening, asked: Mapping[str, float]) -> float:
    """What the strengths imply [Pa]."""
    if name in ("direct_tension", "brazilian"):
        return softening.tension
    if needs_slip(name) and softening.slip is not None:
        return softening.slip.compressive(asked.get("pressure", 0.0))
    return math.nan


def _curves(test: AnyTest, body: Lattice) -> dict[str, np.ndarray]:
    """Curve, and what figures show of the broken specimen."""
    state = test.state
    whole = test.path.bond_integrity if isinstance(test, BendingTest) else state.bond_integrity
    damage = np.zeros(len(body.particles))
    for end in body.pairs.T:
        np.maximum.at(damage, end, 1.0 - whole)
    slip = np.zeros(len(body.particles)) if isinstance(test, BendingTest) else state.slipped
    return {
        "strain": test.curve[:, 0], "stress": test.curve[:, 1], "work": np.array(test.work), "E": np.array(test.E),
        "displacement": state.displacement, "orientation": state.orientation, "damage": damage, "slip": slip,
    }  # fmt: skip
