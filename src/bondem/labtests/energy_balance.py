"""Energy balance of a test to failure along its curve."""

import numpy as np

from bondem._types import Floats
from bondem.labtests.failure.brazilian import BrazilianTest
from bondem.labtests.failure.three_point_bending import BendingTest
from bondem.labtests.failure.triaxial import TriaxialTest
from bondem.labtests.quasi_static_rig import StrengthTest
from bondem.statics.quasistatic.quasistatic_run import QuasistaticResult

AnyTest = StrengthTest | BrazilianTest | TriaxialTest | BendingTest
#: Parts of the energy balance, in the order of their areas in figures.
PARTS = ("elastic", "kinetic", "fracture", "crushing", "plastic", "friction", "damping")


def energy_ledger(test: AnyTest) -> dict[str, Floats]:
    """Compute the energies at each point of the curve of a test [J], (k,) each.

    The parts are "elastic", "kinetic", "fracture", "crushing", "plastic", "friction" and "damping". Further keys are
    "work" of the load and "balance": the sum of the parts less the work, less its initial value. The balance vanishes
    for an exact solution, except for the non-local law, whose extra work is in no part. A bending test of cells has
    no inertia: "fracture" is the dissipation of its events, and all parts but this and "elastic" are zero. Its "work"
    and "elastic" use the motion of the loaded cells, whose mean position deviates slightly from the line of the load.
    """
    if isinstance(test, BendingTest):
        run = test.path
    else:
        run = test.run if isinstance(test, StrengthTest) else test.test.run
    found = _of_path(run) if isinstance(run, QuasistaticResult) else run.history.parts
    balance = np.sum([found[name] for name in PARTS], axis=0) - found["work"]
    return found | {"balance": balance - balance[:1]}


def _of_path(path: QuasistaticResult) -> dict[str, Floats]:
    """Compute the energies along a path of k events [J], (k + 1,) each, from the load and the motion of the rollers.

    Each failure event occurs at constant load. Between events, motion and load are proportional.
    """
    load, moved = path.load, -0.5 * (path.gauge["left"] + path.gauge["right"])[:, 1]
    compliance = moved / load
    first = 0.5 * load[:1] * moved[:1]
    softer = load[:-1] ** 2 * np.diff(compliance)
    further = 0.5 * np.diff(load**2) * compliance[1:]
    spent = np.cumsum(path.energy)[:-1]  # the energy of an event is dissipated after its point of the curve
    none = np.zeros(len(load) + 1)
    return dict.fromkeys(PARTS, none) | {
        "elastic": np.append(0.0, 0.5 * load * moved), "fracture": np.concatenate([[0.0, 0.0], spent]),
        "work": np.concatenate([[0.0], np.cumsum(np.concatenate([first, softer + further]))]),
    }  # fmt: skip
