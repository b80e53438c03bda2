"""Rehearsal of a study: the work of `bondem run` before its first step, to find errors of input early."""

from typing import cast

import numpy as np

from bondem.damage.criteria.criterion import Criterion
from bondem.damage.softening_table import require_short
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.study.pipeline import packed, to_failure
from bondem.study.specimen_step import SpecimenPlan
from bondem.study.study_file import Study

# Largest number of elements packed in a rehearsal, some seconds on a core; the cache keeps the packing for the run.
_MOST = 20_000
# Length of an element over the edge of a cube of its volume: 1.13 in packings of 2000 to 50 000 cells.
_LENGTH = 1.13


class _StartedError(Exception):
    """Signal to end the rehearsal of a test, as its run would begin."""


def rehearse(study: Study) -> str:
    """Pack the first specimen of a study and begin its tests to failure, without a time step.

    Without tests to failure, only the law is checked; above 20 000 packed elements, only law and element size.

    Returns:
        Text for the user on the extent of the check.

    Raises:
        BondemError: an error that `bondem run` would raise before or at the beginning of a test.
    """
    material = study.material
    if material is not None:
        study.bond.require_law(material)
    tests = [name for name in study.tests if name in FAILURE_TESTS]
    if material is None or not tests:
        return "keys only, as no test is to failure"
    if isinstance(study.specimen, SpecimenPlan) and study.specimen.count > _MOST:
        _require_short(study.specimen, material.E, cast(Criterion, study.failure))
        return f"keys and element sizes only, as the specimen has more than {_MOST} elements"
    body = packed(study, 0, lambda stage, share: None)
    bonds = study.bond.of_material(material, (body.lattice,), lambda stage, share: None)
    for name in tests:
        try:
            to_failure(name, study, body, bonds, _begin)
        except _StartedError:
            continue
    return f"the first specimen is packed, and {', '.join(tests)} began"


def _require_short(plan: SpecimenPlan, E: float, failure: Criterion) -> None:
    """Raise an error for elements that are too long for the fracture energy, estimated from their mean volume."""
    length = _LENGTH * (plan.shape.volume / plan.count) ** (1.0 / 3.0)
    for softening in failure._softenings:
        if softening.fracture_energy > 0.0:
            require_short(np.array([length]), np.array([E]), softening)


def _begin(share: float) -> None:
    raise _StartedError
