"""Slow loading of a specimen of cells to failure along x, between smooth platens."""

from collections.abc import Callable
from dataclasses import dataclass

from bondem.labtests.rig import Moduli, Rig, StrengthTest, check_traverses, run_to_failure
from bondem.model.boundary import BoundaryCondition, Drive, Fix
from bondem.model.cell_constants import CellAssignment
from bondem.model.failure_assignment import FailureAssignment
from bondem.model.loads import Pressure
from bondem.model.schedules import Ramp
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face


@dataclass(frozen=True, eq=False)
class Loading:
    """How a specimen is loaded along x: what its curve is expected to be, and when the test ends.

    Attributes:
        sign: 1 for tension, -1 for compression.
        expected: stress at the peak [Pa].
        reach: strain at which the test ends at the latest [-], beside the opening of a crack:
        opening: [m].
        ending: share of the peak at which it ends, once it has fallen that far [-].
        pressure: on the sides [Pa].
        traverses: how often sound runs along the specimen until the expected peak.
    """

    sign: float
    expected: float
    reach: float
    opening: float
    ending: float
    pressure: float
    traverses: float


def load_to_failure(
    test: str,
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    loading: Loading,
    *,
    density: float | None,
    progress: Callable[[float], None] | None,
) -> StrengthTest:
    """Load a specimen between smooth platens, slowly.

    Raises:
        InputError: a lattice without cells, or a shape without faces x_min and x_max.
        UnstableRunError: the run became unstable.
    """
    check_traverses(test, loading.traverses)
    moduli = Moduli.of(test, body, law, density)
    lower, upper = body.particles.envelope.bounds
    length = float(upper[0] - lower[0])
    section = body.particles.envelope.section()

    def platens(speed: float, begin: float) -> list[BoundaryCondition]:
        return _platens(body, loading, speed, begin)

    rig = Rig(
        axis=0, sign=loading.sign, near=Face("x_min"), far=Face("x_max"), section=section, torn=section,
        length=length, size=length, expected=loading.expected, way=loading.expected / moduli.stiff * length,
        reach=loading.reach * length + loading.opening, ending=loading.ending, traverses=loading.traverses,
        boundary=platens,
    )  # fmt: skip
    return run_to_failure(test, body, law, failure, rig, density=density, progress=progress)


def _platens(body: Lattice, loading: Loading, speed: float, begin: float) -> list[BoundaryCondition]:
    """Smooth platens, and the pressure on the sides."""
    sides = [name for name in body.particles.envelope.faces if name not in ("x_min", "x_max")]
    found: list[BoundaryCondition] = [
        Fix(Face("x_min"), translation="x", rotation=""),
        Drive(Face("x_max"), vx=Ramp(0.0, speed, begin)),
    ]
    if loading.pressure > 0.0:
        rise = Ramp(0.0, 1.0, begin)
        found += [Pressure(Face(name), loading.pressure, schedule=rise, follows=True) for name in sides]
    return found
