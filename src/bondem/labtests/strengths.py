"""Tests to failure as rows of a report: the measured strength beside the strength of the material."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from bondem.errors import InputError
from bondem.fracture.fragments import fragments
from bondem.labtests.ball import BrokenBall
from bondem.labtests.compression import uniaxial_compression
from bondem.labtests.confined import triaxial
from bondem.labtests.crushing import sphere_crushing
from bondem.labtests.flexure import BendingTest, three_point_bending
from bondem.labtests.ledger import AnyTest, energy_ledger
from bondem.labtests.outcome import Outcome
from bondem.labtests.punching import shear
from bondem.labtests.rig import softening_of
from bondem.labtests.spalling import spall
from bondem.labtests.splitting import brazilian
from bondem.labtests.tearing import direct_tension
from bondem.labtests.throwing import sphere_impact
from bondem.laws.cell_bond import CellBond
from bondem.laws.failure.criterion import Criterion
from bondem.laws.failure.softening import Softening
from bondem.model.cell_constants import CellAssignment
from bondem.model.failure_assignment import FailureAssignment
from bondem.model.state import State
from bondem.specimen.lattice import Lattice

#: Tests to failure by their names in studies, with options and units; `NEEDED` lists options without a default.
STRENGTH_TESTS: Mapping[str, Mapping[str, str]] = {
    "direct_tension": {}, "ucs": {}, "brazilian": {"half_angle": "rad"}, "triaxial": {"pressure": "Pa"},
    "three_point_bending": {"span": "m"}, "shear": {}, "sphere_crushing": {"friction": "-"},
    "sphere_impact": {"velocity": "m/s", "friction": "-"}, "spall": {"pressure": "Pa", "rise": "s", "fall": "s"},
}  # fmt: skip
#: Options without a default.
NEEDED = (
    ("triaxial", "pressure"), ("sphere_impact", "velocity"), ("spall", "pressure"), ("spall", "rise"),
    ("spall", "fall"),
)  # fmt: skip
#: Tests of a ball; their outcome describes fragments and has no E.
OF_BALLS = ("sphere_crushing", "sphere_impact")


def strength_outcome(
    name: str,
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    density: float,
    options: Mapping[str, float] | None = None,
    progress: Callable[[float], None] | None = None,
) -> Outcome:
    """Run a test of `STRENGTH_TESTS` and compare its strength [Pa] with that implied by the material.

    The implied strength is f_t in direct tension, the Brazilian test and the spall test. In compression it follows
    from the criterion. Bending, the shear test and crushing have no closed form; their theory is NaN. An impact has
    no strength; its measured value is the share of broken facets [-].

    Args:
        name: name of the test.
        body: specimen of cells.
        law, failure: cell law and criterion, or mappings by region whose first value is the matrix; theory is then
            NaN.
        density: density of the material [kg/m³].
        options: options of the test, as in `STRENGTH_TESTS`.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: an unknown test, or a criterion without the required strength.
    """
    softening = softening_of(name, failure, "a criterion with its fracture_energy")
    asked = dict(options or {})
    if name not in STRENGTH_TESTS or (needs_slip(name) and softening.slip is None):
        raise InputError(
            f"labtests: test = {name}: not a test to failure of this material; give one of"
            f" {', '.join(STRENGTH_TESTS)}"
        )
    given = {"density": density, "progress": progress}
    if name in (*OF_BALLS, "spall"):
        return _dynamic(name, body, law, failure, asked, **given)
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
    theory = math.nan if isinstance(failure, Mapping) else _implied(name, softening, asked)
    return Outcome(
        name=name, measured=test.peak, theory=theory, unit="Pa", curves=_curves(test, body), state=test.state,
        energy=energy_ledger(test),
    )  # fmt: skip


def _dynamic(
    name: str, body: Lattice, law: CellAssignment, failure: FailureAssignment, asked: Mapping[str, float],
    **given: Any,
) -> Outcome:  # fmt: skip
    """Outcome of a ball or of a spall test: the curve, and further numbers as `told`."""
    if name == "spall":
        if not isinstance(law, CellBond) or not isinstance(failure, Criterion):
            raise InputError("labtests.spall: law or failure is given by region; give one law and one criterion")
        bar = spall(body, law, failure, **asked, **given)
        told = {"pull-back [m/s]": bar.pull_back, "highest velocity [m/s]": bar.highest, "spall at [m]": bar.place,
                "first failure [s]": bar.first, "energy error [-]": bar.residual}  # fmt: skip
        assert failure.softening is not None
        curve = bar.time, bar.velocity
        return _outcome(name, body, bar.state, bar.peak, failure.softening.tension, "Pa", curve, told)
    if name == "sphere_crushing":
        crushed = sphere_crushing(body, law, failure, **asked, **given)
        told = {"F [N]": crushed.force, "F/D² [Pa]": crushed.jaeger} | _of_pieces(crushed.broken)
        told |= {"difference of plate forces [-]": crushed.asymmetry, "energy error [-]": crushed.residual}
        return _outcome(name, body, crushed.state, crushed.peak, math.nan, "Pa", tuple(crushed.curve.T), told)
    thrown = sphere_impact(body, law, failure, **asked, **given)
    told = {"largest force [N]": thrown.peak, "restitution [-]": thrown.restitution} | _of_pieces(thrown.broken)
    told |= {"momentum [-]": thrown.momentum, "energy error [-]": thrown.residual}
    return _outcome(name, body, thrown.state, thrown.damage, math.nan, "-", (thrown.time, thrown.force), told)


def _of_pieces(broken: BrokenBall) -> dict[str, float | None]:
    return {"damage [-]": broken.damage, "fragments [-]": float(len(broken.sizes.diameter)),
            "heaviest fragment [-]": broken.largest, "fines [-]": broken.fines}  # fmt: skip


def _outcome(
    name: str, body: Lattice, state: State, measured: float, theory: float, unit: str,
    curve: Sequence[np.ndarray], told: Mapping[str, float | None],
) -> Outcome:  # fmt: skip
    curves = {"strain": curve[0], "stress": curve[1]} | _damaged(body, state, state.bond_integrity, state.slipped)
    curves["piece"] = fragments(body, state).label
    known = {key: value for key, value in told.items() if value is not None}
    return Outcome(
        name=name, measured=measured, theory=theory, unit=unit, curves=curves, told=known, state=state,
    )  # fmt: skip


def needs_slip(name: str) -> bool:
    """True for tests of a material whose cells yield."""
    return name in ("ucs", "triaxial")


def _implied(name: str, softening: Softening, asked: Mapping[str, float]) -> float:
    """Strength implied by the material [Pa]."""
    if name in ("direct_tension", "brazilian", "spall"):
        return softening.tension
    if needs_slip(name) and softening.slip is not None:
        return softening.slip.compressive(asked.get("pressure", 0.0))
    return math.nan


def _curves(test: AnyTest, body: Lattice) -> dict[str, np.ndarray]:
    """Curve of the test, and fields of the broken specimen for figures."""
    state = test.state
    bent = isinstance(test, BendingTest)
    whole = test.path.bond_integrity if isinstance(test, BendingTest) else state.bond_integrity
    slip = np.zeros(len(body.particles)) if bent else state.slipped
    return {
        "strain": test.curve[:, 0], "stress": test.curve[:, 1], "work": np.array(test.work), "E": np.array(test.E),
        **_damaged(body, state, whole, slip),
    }  # fmt: skip


def _damaged(body: Lattice, state: State, whole: np.ndarray, slip: np.ndarray) -> dict[str, np.ndarray]:
    """Motion, damage and slip of the cells."""
    damage = np.zeros(len(body.particles))
    for end in body.pairs.T:
        np.maximum.at(damage, end, 1.0 - whole)
    return {"displacement": state.displacement, "orientation": state.orientation, "damage": damage, "slip": slip}
