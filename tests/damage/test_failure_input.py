"""Criteria of failure that cannot be: each is refused in one line that names what is wrong and what to do."""

import math
import re
from collections.abc import Callable

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.specimens import bar, row

ROW = row(3)
LAW = bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.5)
STRESS = bd.PeripheralStress(tension=1e6, shear=1e6)
TRACTION = bd.MohrCoulomb(tension=1e6, cohesion=1e6, friction_angle=0.5)


def model(failure: object, bond: object = LAW, lattice: bd.Lattice = ROW, **others) -> bd.Model:
    return bd.Model(lattice, bond, density=1000.0, failure=failure, **others)


def mixed() -> bd.Model:
    """Beams, which are judged at their ends, beside bonds that are judged where elements touch."""
    bonds = {bd.Index([0, 1]): LAW, bd.Everything(): bd.ParallelBond(E=1e9, nu=0.3, radius_ratio=0.5)}
    return model(STRESS, bonds)


def free_model(failure: bd.Criterion | None = STRESS) -> bd.Model:
    return model(failure, boundary=[bd.Fix(bd.Index([0]))])


def other_state() -> bd.State:
    return bd.Model(bd.Lattice(ROW.particles, ROW.pairs[:1]), LAW, density=1000.0, failure=STRESS).state()


def along(stress, tension, weight=1.0):
    return weight * stress[:, 0, 0] / tension


def no_number(stress):
    return np.sqrt(stress[:, 0, 0])


def of_one(stress, tension):
    return np.linalg.eigvalsh(stress)[2] / tension


def of_numbers(stress):
    return math.sqrt(stress[0, 0])


def a_matrix(stress):
    return stress


def nothing(stress):
    pass


def a_file(stress):
    return open("index.txt")


def at_rest(stress):
    return np.full(len(stress), 2.0)


def never(stress):
    return np.full(len(stress), -1.0)


def complains(stress):
    if (stress[:, 0, 1] > 0.0).any():
        raise ValueError("no shear, please")
    return stress[:, 0, 0] / 1e6


def by_name(stress, *, tension):
    return stress[:, 0, 0] / tension


def own(function: object, **parameters: object) -> object:
    return bd.StressCriterion(function, **parameters)  # type: ignore[arg-type]


# What is wrong, in the words of the message; what to do, likewise; how to get there.
REFUSED: dict[str, tuple[str, str, Callable[[], object]]] = {
    "a number": ("4000000", "a criterion such as bd.PeripheralStress", lambda: model(4e6)),
    "a class": ("PeripheralStress", "a criterion such as", lambda: model(bd.PeripheralStress)),
    "a beam's stress in the non-local law": (
        "PeripheralStress is not a criterion on principal stresses", "use bd.Rankine(tension=) or bd.MohrCoulomb",
        lambda: model(STRESS, bd.NonLocal(E=1e9, nu=0.2), bar(12, 4e-3)),
    ),
    "a cone in the non-local law": (
        "DruckerPrager is not a criterion on principal stresses", "use bd.Rankine(tension=) or bd.MohrCoulomb",
        lambda: model(bd.DruckerPrager(tension=1e6, compression=1e7), bd.NonLocal(E=1e9, nu=0.2), bar(12, 4e-3)),
    ),
    "softening in the non-local law": (
        "Rankine: NonLocal bonds break at once", "leave out fracture_energy=",
        lambda: model(bd.Rankine(tension=1e6, fracture_energy=10.0), bd.NonLocal(E=1e9, nu=0.2), bar(12, 4e-3)),
    ),
    "friction of a criterion in the non-local law": (
        "Rankine: friction= of NonLocal bonds", "contact=bd.LinearContact",
        lambda: model(bd.Rankine(tension=1e6, friction=0.3), bd.NonLocal(E=1e9, nu=0.2), bar(12, 4e-3)),
    ),
    "the incremental form": (
        "needs bonds of the total formulation", "use formulation='total'",
        lambda: model(STRESS, bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.5, formulation="incremental")),
    ),
    "contact": (
        "failure= of cells beside contact=", "needs stress_free=True",
        lambda: model(
            TRACTION, bd.CellBond(E=1e9, nu=0.2), bar(12, 4e-3), contact=bd.LinearContact(E=1e9, stress_free=False)
        ),
    ),
    "a beam's stress in cells": (
        "PeripheralStress applies to beams", "use bd.MohrCoulomb",
        lambda: model(STRESS, bd.CellBond(E=1e9, nu=0.2), bar(12, 4e-3)),
    ),
    "a sum of forces in cells": (
        "LinearSum applies to beams", "use bd.MohrCoulomb",
        lambda: model(
            bd.LinearSum(force=1.0, shear=1.0, bending=1.0, twisting=1.0), bd.CellBond(E=1e9, nu=0.2), bar(12, 4e-3)
        ),
    ),
    "an ellipse in cells": (
        "Elliptic applies to beams", "use bd.MohrCoulomb",
        lambda: model(bd.Elliptic(elongation=0.1, rotation=0.1), bd.CellBond(E=1e9, nu=0.2), bar(12, 4e-3)),
    ),
    "bonds of two kinds": ("at the ends or at contact points", "give bonds of one kind", mixed),
    "a stress of the material in beams": (
        "DruckerPrager with softening or stresses", "use bd.CellBond",
        lambda: model(bd.DruckerPrager(tension=1e6, compression=1e7)),
    ),
    "one strength of a cone": (
        "DruckerPrager: tension given", "give two of", lambda: bd.DruckerPrager(tension=1e6)
    ),
    "no strength of a cone": ("no strength given", "give two of", lambda: bd.DruckerPrager()),
    "three strengths of a cone": (
        "tension, compression, hydrostatic given", "give two of",
        lambda: bd.DruckerPrager(tension=1e6, compression=1e7, hydrostatic=1e6),
    ),
    "a cone upside down": (
        "compression = 1e+06 Pa is below tension", "give at least as much",
        lambda: bd.DruckerPrager(tension=2e6, compression=1e6),
    ),
    "a cone that never ends": (
        "hydrostatic = 2.6e+07 Pa is no more than 2/3 of tension", "give more",
        lambda: bd.DruckerPrager(tension=40e6, hydrostatic=26e6),
    ),
    "more dilatancy than friction": (
        "dilatancy = 0.5", "give β in [0, α]",
        lambda: bd.DruckerPrager(tension=1e6, compression=1e7, fracture_energy=1.0, dilatancy=0.5),
    ),
    "a brittle cone that slips": (
        "apply to cells that yield", "give fracture_energy too",
        lambda: bd.DruckerPrager(tension=1e6, compression=1e7, fracture_energy_shear=5.0),
    ),
    "no function": ("function = 3", "give a function of stresses (k, 3, 3)", lambda: own(3)),
    "a class for a function": ("function = <class", "give a function of stresses", lambda: own(bd.Box)),
    "a function of Python's": ("function = <built-in", "give a function of stresses", lambda: own(len)),
    "an argument by name alone": (
        "by_name(stress, *, tension)", "give a function", lambda: own(by_name, tension=1.0)
    ),
    "a parameter missing": ("along needs 'tension'", "give tension=", lambda: own(along)),
    "a parameter misspelt": (
        "along has no parameter 'tensio'", "give tension, weight", lambda: own(along, tension=1e6, tensio=1e6)
    ),
    "a parameter that is no number": ("tension = 'high'", "give a finite number", lambda: own(along, tension="high")),
    "an index that is no number": ("no_number is nan at a stress", "return a finite number", lambda: own(no_number)),
    "an index of one stress": (
        "of_one returns an array (3,) for stresses (57, 3, 3)", "returns 57 indices", lambda: own(of_one, tension=1e6)
    ),
    "an index of numbers": ("of_numbers raises 'only", "many stresses (k, 3, 3)", lambda: own(of_numbers)),
    "an index that is a matrix": ("a_matrix returns an array (57, 3, 3)", "57 indices", lambda: own(a_matrix)),
    "an index that is nothing": ("nothing returns an array ()", "57 indices", lambda: own(nothing)),
    "what is no number": ("a_file raises '", "returns k indices", lambda: own(a_file)),
    "an index that fails at rest": ("at_rest is 2 without stress", "give an index below 1", lambda: own(at_rest)),
    "an index that never fails": ("never stays below 1", "give an index that reaches 1", lambda: own(never)),
    "an index of the wrong sign": ("along stays below 1", "tension positive", lambda: own(along, tension=-1e6)),
    "an index that raises": ("complains raises 'no shear, please'", "returns k indices", lambda: own(complains)),
    "statics": ("solve_quasistatic", "leave failure= out", lambda: bd.solve_static(free_model())),
    "modes": ("solve_quasistatic", "leave failure= out", lambda: bd.solve_modes(free_model(), count=1)),
    "relaxation": ("solve_quasistatic", "leave failure= out", lambda: bd.solve_relaxed(free_model())),
    "an index without a criterion": (
        "failure_index: the model has no criterion", "give it failure=",
        lambda: bd.failure_index(free_model(None), free_model(None).state()),
    ),
    "an index of another lattice": (
        "the state belongs to another", "give one of this model",
        lambda: bd.failure_index(free_model(), other_state()),
    ),
    "an index of no state": ("state", "model.state()", lambda: bd.failure_index(free_model(), None)),
    "an index of no model": ("model", "bd.Model(...)", lambda: bd.failure_index(None, free_model().state())),
}  # fmt: skip
# Parameters: the class and the parameter are named, and what would do.
PERIPHERAL, COULOMB = {"tension": 1.0, "shear": 1.0}, {"tension": 1.0, "cohesion": 1.0, "friction_angle": 0.5}
LINEAR = {"force": 1.0, "shear": 1.0, "bending": 1.0, "twisting": 1.0}
CONE, OWN = {"tension": 1e6, "compression": 9e6, "fracture_energy": 1.0}, {"function": along, "tension": 1e6}
ELLIPTIC, WEIBULL = {"elongation": 0.1, "rotation": 0.1}, {"modulus": 5.0, "volume": 1.0}
WRONG = [
    *((bd.PeripheralStress, PERIPHERAL, name, bad, "in Pa") for name in PERIPHERAL for bad in (0.0, -1.0, math.nan)),
    *((bd.PeripheralStress, PERIPHERAL, "beta", bad, "[0, 1]") for bad in (-0.1, 1.1)),
    *((bd.MohrCoulomb, COULOMB, name, bad, "in Pa") for name in ("tension", "cohesion") for bad in (0.0, math.inf)),
    *((bd.MohrCoulomb, COULOMB, "friction_angle", bad, "[0, π/2) rad") for bad in (-0.1, 0.5 * math.pi, 35.0)),
    *((bd.LinearSum, LINEAR, name, bad, "a positive N") for name in LINEAR for bad in (0.0, -1.0, "strong")),
    *((bd.Elliptic, ELLIPTIC, name, bad, "") for name in ELLIPTIC for bad in (0.0, -1.0)),
    *((bd.Weibull, WEIBULL, name, bad, "") for name in WEIBULL for bad in (0.0, -1.0)),
    *((bd.DruckerPrager, CONE, name, bad, "") for name in CONE for bad in (0.0, -1.0, math.nan, "strong")),
    *((bd.DruckerPrager, CONE, name, bad, "") for name in ("dilatancy", "friction") for bad in (-0.1, math.inf)),
    (bd.DruckerPrager, CONE, "fracture_energy_shear", 0.0, "J/m²"),
    *((bd.Hydrostatic, {"tension": 1.0}, "tension", bad, "in Pa") for bad in (0.0, -1.0, math.nan)),
    (bd.Hydrostatic, {"tension": 1.0}, "fracture_energy", 0.0, "None for brittle"),
    (bd.Hydrostatic, {"tension": 1.0}, "friction", -0.1, "zero or more"),
    (bd.StressCriterion, OWN, "fracture_energy", 0.0, "None for brittle"),
    (bd.StressCriterion, OWN, "friction", -0.1, "zero or more"),
    (bd.StressCriterion, OWN, "scatter", 0.1, "bd.Weibull(...), bd.Normal(...) or None"),
    (bd.Weibull, WEIBULL, "seed", 1.5, "whole number"),
    *((bd.Normal, {"deviation": 0.1}, "deviation", bad, "[0, 1/3)") for bad in (-0.1, 0.34)),
    (bd.PeripheralStress, PERIPHERAL, "scatter", 0.1, "bd.Weibull(...), bd.Normal(...) or None"),
]


@pytest.mark.parametrize("case", REFUSED)
def test_a_criterion_where_it_cannot_be_is_refused(case: str) -> None:
    wrong, advice, call = REFUSED[case]
    with pytest.raises(InputError, match=re.escape(wrong)) as refused:
        call()
    assert advice in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(("kind", "good", "name", "bad", "advice"), WRONG)
def test_a_parameter_out_of_range_is_named(kind: type, good: dict, name: str, bad: object, advice: str) -> None:
    kind(**good)
    with pytest.raises(InputError, match=rf"\b{kind.__name__}\b.*\b{name}\b") as refused:
        kind(**good | {name: bad})
    assert advice in str(refused.value)
    assert "\n" not in str(refused.value)


def test_what_can_be_is_not_refused() -> None:
    for failure in (STRESS, TRACTION, bd.Elliptic(elongation=0.1, rotation=0.1), None):
        model(failure)
    model(TRACTION, bd.CellBond(E=1e9, nu=0.2), bar(12, 4e-3))
    model(STRESS, bd.ParallelBond(E=1e9, nu=0.3, radius_ratio=0.5))
    without = bd.Model(bd.Lattice(ROW.particles, ROW.pairs[:0]), None, density=1000.0, failure=STRESS)
    assert bd.failure_index(without, without.state()).shape == (0,)
