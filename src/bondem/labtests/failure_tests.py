"""Table of the tests to failure of studies, and the comparison of a result with the strength of the material.

A further test needs a record here, the function that runs it, and its name in `bondem.labtests`.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from bondem._types import Floats
from bondem.damage.cohesive_softening import Softening
from bondem.damage.failure_assignment import FailureAssignment
from bondem.errors import InputError
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.ball import BrokenBall
from bondem.labtests.bonded_platens import is_cells
from bondem.labtests.cracking import Cracking, dissipated_in
from bondem.labtests.disc import WIDEST
from bondem.labtests.energy_balance import AnyTest, energy_ledger
from bondem.labtests.failure.brazilian import brazilian
from bondem.labtests.failure.direct_tension import direct_tension
from bondem.labtests.failure.shear import shear
from bondem.labtests.failure.spall import SpallTest, spall
from bondem.labtests.failure.sphere_crushing import SphereCrushing, sphere_crushing
from bondem.labtests.failure.sphere_impact import SphereImpact, sphere_impact
from bondem.labtests.failure.three_point_bending import BendingTest, three_point_bending
from bondem.labtests.failure.triaxial import triaxial
from bondem.labtests.failure.uniaxial_compression import uniaxial_compression
from bondem.labtests.failure_record import Curve, FailureTest, TestFigure, TestOption
from bondem.labtests.outcome import Outcome
from bondem.labtests.quasi_static_rig import softening_of
from bondem.labtests.requirements import BALLS, BEAM, BORED, DISC
from bondem.specimen.lattice import Lattice
from bondem.statics.quasistatic.quasistatic_run import QuasistaticResult


def _compressive(softening: Softening, asked: Mapping[str, float]) -> float:
    if not softening.slips or asked.get("platen_friction"):  # rough platens confine the ends: no closed form
        return math.nan
    return softening.slips[0].compressive(asked.get("pressure", 0.0))


def _worked(test: AnyTest) -> dict[str, float]:
    return {"work": test.work, "E": test.E}


def _bend(body: Lattice, law: AnyLaw, failure: FailureAssignment, *, density: float, **asked: Any) -> BendingTest:
    """Run `three_point_bending`; density is left out for cells, whose path of equilibria does not depend on it."""
    if not is_cells(body, law):
        asked["density"] = density
    return three_point_bending(body, law, failure, **asked)


def _bent_integrity(test: BendingTest) -> Floats:
    return test.path.bond_integrity if isinstance(test.path, QuasistaticResult) else test.state.bond_integrity


def _pieces(broken: BrokenBall) -> dict[str, float | None]:
    return {"mass of the heaviest piece [%]": 100.0 * broken.largest,
            "mass of pieces below D/5 [%]": 100.0 * broken.fines}  # fmt: skip


def _crushed(test: SphereCrushing) -> dict[str, float | None]:
    return {
        "peak load F [N]": test.force, "F / D² [Pa]": test.jaeger, "broken facets [%]": 100.0 * test.broken.damage,
        **_pieces(test.broken), "difference of plate forces [%]": 100.0 * test.asymmetry,
        "energy error [%]": 100.0 * test.residual,
    }  # fmt: skip


def _thrown(test: SphereImpact) -> dict[str, float | None]:
    energy = test.run.history.energy
    moving = energy["translation"] + energy["rotation"]
    return {
        "kinetic energy before [J]": float(moving[0]), "kinetic energy after [J]": float(moving[-1]),
        **{f"{name} [J]": float(energy[name][-1]) for name in ("fracture", "crushing", "friction")},
        "largest force [N]": test.peak, "restitution of the heaviest piece [-]": test.restitution,
        **_pieces(test.broken),
        "momentum error [%]": 100.0 * test.momentum, "energy error [%]": 100.0 * test.residual,
    }  # fmt: skip


def _spalled(test: SpallTest) -> dict[str, float | None]:
    return {
        "pull-back [m/s]": test.pull_back, "highest velocity [m/s]": test.highest, "spall at [m]": test.place,
        "first failure [s]": test.first, "energy error [%]": 100.0 * test.residual,
    }  # fmt: skip


def _parted(result: Any, body: Lattice, fracture_energy: float) -> Cracking:
    """Evaluate the cracks of a run in which fragments fly apart, so that only facets of integrity 0 count."""
    energy = result.run.history.energy
    elastic = np.sum([energy[name] for name in ("normal", "shear", "bending", "twisting")], axis=0)
    return Cracking(
        body=body, state=result.state, integrity=0.0, stored=float(elastic.max()), fracture_energy=fracture_energy,
        **dissipated_in(result.run.history),
    )  # fmt: skip


def _bent(test: BendingTest) -> dict[str, float | None]:
    top = int(np.argmax(test.load))
    return {
        "peak load [N]": float(test.load[top]),
        "CMOD at the peak [m]": None if test.cmod is None else float(test.cmod[top]),
        "deflection at the peak [m]": float(test.deflection[top]), "work per ligament [J/m²]": test.work,
    }  # fmt: skip


def _load_curve(test: BendingTest) -> Curve:
    """Return the CMOD, or the deflection of a plain beam [m], and the load [N], (k,) each."""
    return (test.deflection if test.cmod is None else test.cmod), test.load


_PULSE = {"pressure": "Pa", "rise": "s", "fall": "s"}
_FRICTION = TestOption("-", closed=True)
_PLATENS = {"platen_friction": _FRICTION}
_RECORDS = (
    FailureTest(
        name="direct_tension", perform=direct_tension, theory=lambda softening, asked: softening.tension,
        more=_worked, energy=energy_ledger, details=lambda test: {"work per section [J/m²]": test.work},
        figure=TestFigure("Direct tension", quantity="tensile strength"),
    ),
    FailureTest(
        name="ucs", perform=uniaxial_compression, options=_PLATENS, yields=True, theory=_compressive, more=_worked,
        energy=energy_ledger, figure=TestFigure("Uniaxial compression", slips=True, quantity="compressive strength"),
    ),
    FailureTest(
        name="brazilian", perform=brazilian, requirements=DISC,
        options={"half_angle": TestOption("rad", below=WIDEST), **_PLATENS},
        theory=lambda softening, asked: softening.tension, more=_worked, energy=energy_ledger,
        figure=TestFigure(
            "Brazilian test", strain="closing / D", stress="2 P / (π D t)", azimuth=math.radians(62.0),
            elevation=math.radians(14.0), quantity="Brazilian strength 2 P / (π D t)",
        ),
    ),
    FailureTest(
        name="triaxial", perform=triaxial, options={"pressure": TestOption("Pa", needed=True), **_PLATENS},
        yields=True, theory=_compressive, more=_worked, energy=energy_ledger,
        figure=TestFigure(
            "Triaxial compression", stress="axial stress", slips=True, quantity="axial stress at failure, σ1"
        ),
    ),
    FailureTest(
        name="three_point_bending", perform=_bend, requirements=BEAM,
        options={"span": TestOption("m"), "until": TestOption("-", closed=True, below=1.0)},
        energy=energy_ledger, integrity=_bent_integrity, details=_bent,
        more=lambda test: _worked(test) | ({"plain": 1.0} if test.cmod is None else {}), curve=_load_curve,
        figure=TestFigure(
            "Three-point bending", strain="CMOD", plain="deflection", stress="load", across=(1e6, "µm"),
            up=(1e-3, "kN"), line=False, azimuth=math.radians(25.0), elevation=math.radians(56.0),
            quantity="flexural strength of the ligament",
        ),
    ),
    FailureTest(
        name="shear", perform=shear, requirements=BORED, more=_worked, energy=energy_ledger,
        figure=TestFigure(
            "Shear test", strain="piston / ligament", stress="mean shear stress", halved=True,
            quantity="mean shear stress at failure",
        ),
    ),
    FailureTest(
        name="sphere_crushing", perform=sphere_crushing, requirements=BALLS, options={"friction": _FRICTION},
        details=_crushed, cracking=_parted,
        figure=TestFigure(
            "Crushing of a ball", strain="closing / D", stress="2.8 F / (π D²)",
            quantity="nominal tensile strength 2.8 F / (π D²)",
        ),
    ),
    FailureTest(
        name="sphere_impact", perform=sphere_impact, requirements=BALLS,
        options={"velocity": TestOption("m/s", needed=True), "friction": _FRICTION},
        measured=lambda test: test.damage, unit="-", curve=lambda test: (test.time, test.force), details=_thrown,
        cracking=_parted,
        figure=TestFigure(
            "Impact of a ball", strain="time", stress="force on the plane", across=(1e6, "µs"), up=(1e-3, "kN"),
            quantity="share of broken facets",
        ),
    ),
    FailureTest(
        name="spall", perform=spall, uniform=True, bonded=False,
        options={key: TestOption(unit, needed=True) for key, unit in _PULSE.items()},
        theory=lambda softening, asked: softening.tension, curve=lambda test: (test.time, test.velocity),
        details=_spalled, cracking=_parted,
        figure=TestFigure(
            "Spalling", strain="time", stress="velocity of the free end", across=(1e6, "µs"), up=(1.0, "m/s"),
            line=False, quantity="spall strength",
        ),
    ),
)  # fmt: skip
#: Tests to failure by their names in studies, in the order of figures.
FAILURE_TESTS: Mapping[str, FailureTest] = {one.name: one for one in _RECORDS}
#: Tests of a ball.
OF_BALLS = tuple(one.name for one in _RECORDS if one.requirements is BALLS)


def failure_outcome(
    name: str, body: Lattice, law: AnyLaw, failure: FailureAssignment, *, density: float,
    options: Mapping[str, float] | None = None, progress: Callable[[float], None] | None = None,
) -> Outcome:  # fmt: skip
    """Run a test of `FAILURE_TESTS` and compare its strength with that implied by the material.

    The implied strength is f_t in direct tension, the Brazilian test and the spall test. In compression
    between smooth platens it follows from the criterion. Bending, the shear test and crushing have no closed form;
    their theory is NaN. An impact has no strength; its measured value is the share of broken facets [-].

    Args:
        name: name of the test in `FAILURE_TESTS`, such as "ucs".
        body: specimen of cells or of bonded spheres.
        law, failure: law and criterion, or mappings by region whose first value is the matrix. Theory is NaN for
            criteria by region and for bonded spheres.
        density: density of the material [kg/m³].
        options: options of the test by name, in SI.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: an unknown test, or a specimen, law or criterion that the test does not support.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.
    """
    asked, test = dict(options or {}), FAILURE_TESTS.get(name)
    if test is not None and test.bonded and not is_cells(body, law):
        # no closed form relates the strength of bonded spheres to that of their bonds
        result = test.perform(body, law, failure, density=density, progress=progress, **asked)
        cracking = test.cracking(result, body, math.nan)
        broken = {"broken bonds [%]": 100.0 * cracking.broken / len(body.pairs)}
        return _outcome(test, result, cracking, math.nan, broken)
    softening = softening_of(name, failure, "a criterion with its fracture_energy")
    if test is None or (test.yields and not softening.slips):
        raise InputError(
            f"labtests: test = {name}: not a test to failure of this material; give one of {', '.join(FAILURE_TESTS)}"
        )
    if test.uniform and (isinstance(law, Mapping) or isinstance(failure, Mapping)):
        raise InputError(f"labtests.{name}: law or failure is given by region; give one law and one criterion")
    result = test.perform(body, law, failure, density=density, progress=progress, **asked)
    theory = math.nan if isinstance(failure, Mapping) else test.theory(softening, asked)
    return _outcome(test, result, test.cracking(result, body, softening.fracture_energy), theory, {})


def _outcome(test: FailureTest, result: Any, cracking: Cracking, theory: float, more: Mapping[str, float]) -> Outcome:
    """Evaluate a test, with its theoretical value in the unit of the test and further numbers by name and unit."""
    return Outcome(
        name=test.name, measured=test.measured(result), unit=test.unit, theory=theory,
        curves=test.curves(result, cracking), cracking=cracking, energy=test.energy(result), axes=test.figure.axes,
        told={key: value for key, value in {**more, **test.details(result)}.items() if value is not None},
    )  # fmt: skip
