"""Slow loading of a specimen of cells along x between smooth or rough platens, to failure."""

from dataclasses import dataclass

from bondem.boundary.conditions import BoundaryCondition, Drive, Fix
from bondem.boundary.gauges import Gauge
from bondem.boundary.loads import Pressure
from bondem.boundary.schedules import Ramp
from bondem.damage.failure_assignment import FailureAssignment
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.labtests.quasi_static_rig import Moduli, Rig, RunOptions, StrengthTest, run_to_failure
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face


@dataclass(frozen=True, eq=False)
class Loading:
    """Loading of a specimen along x: direction, expected curve and end of the test.

    Attributes:
        sign: 1 for tension, -1 for compression.
        expected: expected stress at the peak [Pa].
        reach, opening: limit of the motion, reach · length + opening: a strain [-], and an opening of a crack [m].
        ending: share of the peak stress at which the test ends [-].
        pressure: confining pressure on the sides [Pa].
        traverses: number of passes of sound along the specimen before the expected peak [-].
        friction: coefficient of friction of the platens [-], 0 for smooth ones.
    """

    sign: float
    expected: float
    reach: float
    opening: float
    ending: float
    pressure: float
    traverses: float
    friction: float = 0.0


def load_to_failure(
    test: str, body: Lattice, law: CellAssignment, failure: FailureAssignment, loading: Loading, options: RunOptions
) -> StrengthTest:
    """Load a specimen of cells slowly between platens at x_min and x_max until it has failed.

    Raises:
        InputError: a lattice without cells, or a shape without faces x_min and x_max.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.
    """
    options.check_traverses(test)
    moduli = Moduli.of(test, body, law, options.density)
    length, section = body.particles.envelope.extent, body.particles.envelope.section()

    def pressed(speed: float, begin: float) -> Model:
        platens = _platens(body, loading, speed, begin)
        return Model(body, law, options.density, failure=failure, boundary=platens)

    near, far = (Gauge(Face(name), "force") for name in ("x_min", "x_max"))
    rig = Rig(
        axis=0, sign=loading.sign, near=(near,), far=(far,), section=section, torn=section,
        length=length, size=length, expected=loading.expected, way=loading.expected / moduli.stiff * length,
        reach=loading.reach * length + loading.opening, ending=loading.ending, traverses=loading.traverses,
        model=pressed,
    )  # fmt: skip
    return run_to_failure(test, body, law, failure, rig, options)


def _platens(body: Lattice, loading: Loading, speed: float, begin: float) -> list[BoundaryCondition]:
    """Create the boundary conditions of the platens, and the pressure on the other faces if there is one."""
    rough = loading.friction or None
    sides = [name for name in body.particles.envelope.faces if name not in ("x_min", "x_max")]
    found: list[BoundaryCondition] = [
        Fix(Face("x_min"), translation="x", rotation="", friction=rough),
        Drive(Face("x_max"), vx=Ramp(0.0, speed, begin), friction=rough),
    ]
    if loading.pressure > 0.0:
        rise = Ramp(0.0, 1.0, begin)
        found += [Pressure(Face(name), loading.pressure, schedule=rise, follows=True) for name in sides]
    return found
