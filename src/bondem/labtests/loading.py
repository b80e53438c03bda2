"""Slow loading of a specimen of cells to failure along x, between smooth platens."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number
from bondem._types import Floats
from bondem.errors import InputError, UnstableRunError
from bondem.labtests.arguments import check
from bondem.laws.cell_bond import CellBond
from bondem.laws.damping import MassDamping
from bondem.laws.failure.criterion import Criterion
from bondem.laws.failure.softening import Softening
from bondem.model.boundary import BoundaryCondition, Drive, Fix
from bondem.model.gauges import Gauge
from bondem.model.loads import Pressure
from bondem.model.model import Model
from bondem.model.schedules import Ramp
from bondem.model.state import State
from bondem.run import solve_explicit
from bondem.solve.history import History
from bondem.solve.plan import ExplicitResult, Status
from bondem.solve.schemes import VelocityVerlet
from bondem.solve.timestep import choose_step
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face

# Share of the critical damping of the first axial vibration, by which what breaks comes to rest.
_DAMPING = 0.05
# Records of a test, of which the slope of its curve and its peak are read.
_RECORDS = 400
# The density of a test where none is given [kg/m³]. Nothing depends on it, as speeds are shares of that of sound.
_DENSITY = 2000.0
# Between these shares of the peak a curve is straight.
_STRAIGHT = (0.1, 0.5)


@dataclass(frozen=True, eq=False)
class StrengthTest:
    """Result of a test to failure.

    Attributes:
        peak: largest stress [Pa], positive in tension and in compression; over the section at mid-length.
        E: slope of the curve between a tenth and half of the peak [Pa].
        curve: strain [-] and stress [Pa] of each record, positive along the load, shape (k, 2).
        work: of the platens over the section at mid-length, until the end [J/m²].
        asymmetry: largest difference of the forces on both platens over the peak [-]: how far from statics it was.
        kinetic: largest kinetic energy up to the peak over the elastic energy at the peak [-].
        residual: of the energy ledger, over its largest entry [-].
        run: the explicit run.
    """

    peak: float
    E: float
    curve: Floats
    work: float
    asymmetry: float
    kinetic: float
    residual: float
    run: ExplicitResult

    @property
    def state(self) -> State:
        """The broken specimen."""
        return self.run.state


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


def softening_of(test: str, failure: object, wanted: str) -> Softening:
    """How a material softens.

    Raises:
        InputError: no criterion, or one without a fracture energy where one is needed.
    """
    found = instance(f"labtests.{test}", "failure", failure, Criterion, wanted).softening
    if found is None:
        raise InputError(f"labtests.{test} needs the strength of a material; give {wanted}")
    return found


def load_to_failure(
    test: str,
    body: Lattice,
    law: CellBond,
    failure: Criterion,
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
    rho = _DENSITY if density is None else density
    number(f"labtests.{test}", "traverses", loading.traverses, least=1.0, advice="a number of at least 1")
    check(test, body, density=rho)
    if not isinstance(law, CellBond) or body.cells is None:
        raise InputError(
            f"labtests.{test} loads bodies of cells: connect with method='laguerre' and give bd.CellBond"
        )
    lower, upper = body.particles.envelope.bounds
    length = float(upper[0] - lower[0])
    section = body.particles.envelope.section()
    sound = math.sqrt(law.E / rho)
    rise = loading.traverses * length / sound  # time until the expected peak
    speed = loading.sign * loading.expected / law.E * length / rise
    begin = 0.2 * rise
    model = Model(body, law, rho, failure=failure, boundary=_platens(body, loading, speed, begin))
    duration = (loading.reach * length + loading.opening) / abs(speed) + 0.5 * begin
    damping = MassDamping(alpha=2.0 * _DAMPING * math.pi * sound / length)
    dt = choose_step(model, VelocityVerlet(), None, safety=0.9, damping=damping).dt
    every = max(1, round(duration / _RECORDS / dt))
    peak = [0.0]

    def ended(_: State, record: History) -> bool:
        now = loading.sign * float(_stress(record, section)[-1])
        peak[0] = max(peak[0], now)
        return peak[0] > 0.5 * loading.expected and now < loading.ending * peak[0]

    run = solve_explicit(
        model, duration=duration, dt=dt, every=every, damping=damping, callback=ended, progress=progress,
        gauges={"near": Gauge(Face("x_min"), "force"), "far": Gauge(Face("x_max"), "force")},
    )  # fmt: skip
    if run.status is Status.UNSTABLE:
        raise UnstableRunError(f"labtests.{test}: {run.message}")
    return _read(run, loading, section, length, speed, begin)


def _platens(body: Lattice, loading: Loading, speed: float, begin: float) -> list[BoundaryCondition]:
    """Smooth platens, and the pressure on the sides."""
    sides = [name for name in body.particles.envelope.faces if name not in ("x_min", "x_max")]
    found: list[BoundaryCondition] = [
        Fix(Face("x_min"), translation="x", rotation=""),
        Drive(Face("x_max"), vx=Ramp(0.0, speed, begin)),
    ]
    if loading.pressure > 0.0:
        rise, follows = Ramp(0.0, 1.0, begin), body.cells is not None
        found += [Pressure(Face(name), loading.pressure, schedule=rise, follows=follows) for name in sides]
    return found


def _stress(history: History, section: float) -> Floats:
    """Mean of both platens, tension positive [Pa]."""
    return 0.5 * (history["far"][:, 0] - history["near"][:, 0]) / section


def _read(
    run: ExplicitResult, loading: Loading, section: float, length: float, speed: float, begin: float
) -> StrengthTest:
    history = run.history
    t = history.time
    moved = np.where(t < begin, 0.5 * t**2 / begin, t - 0.5 * begin) * abs(speed)
    stress = loading.sign * _stress(history, section)
    top = int(np.argmax(stress))
    peak = float(stress[top])
    low, high = (share * peak for share in _STRAIGHT)
    rising = np.arange(len(stress)) < top
    straight = rising & (stress > low) & (stress < high)
    E = np.polyfit(moved[straight] / length, stress[straight], 1)[0] if straight.sum() > 2 else math.nan
    energy = history.energy
    kinetic = energy["translation"] + energy["rotation"]
    elastic = energy["normal"] + energy["shear"] + energy["bending"] + energy["twisting"]
    both = np.abs(history["far"][:, 0] + history["near"][:, 0])[: top + 1] / section
    return StrengthTest(
        peak=peak, E=float(E), curve=np.column_stack([moved / length, stress]),
        work=float(energy["work"][-1]) / section, asymmetry=float(both.max() / peak),
        kinetic=float(kinetic[: top + 1].max() / elastic[top]), residual=run.residual, run=run,
    )  # fmt: skip
