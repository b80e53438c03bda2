"""Slow loading of a specimen between two sides to failure: common parts of the quasi-static tests."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import cast

import numpy as np

from bondem._checks import instance, number
from bondem._types import Floats
from bondem.boundary.gauges import AnyGauge, StrainGauge, WallGauge
from bondem.damage.cohesive_softening import Softening
from bondem.damage.criteria.criterion import Criterion
from bondem.damage.failure_assignment import FailureAssignment, failure_parts
from bondem.dynamics.damping import AnyDamping, MassDamping
from bondem.dynamics.events import LoadDrop
from bondem.dynamics.history import History
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import InputError
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.interactions.law_catalogue import kind_of
from bondem.labtests.arguments import check
from bondem.labtests.cracking import CRACKED, Cracking, dissipated_in
from bondem.labtests.recorded_run import OfOneRun, run_test, step_of
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant

# Share of critical damping of the first axial vibration; brings broken parts to rest.
_DAMPING = 0.05
# Number of records of a test, from which the slope and the peak of its curve are evaluated.
_RECORDS = 400
#: Default density of a test [kg/m³]. Results do not depend on it, as speeds are shares of the speed of sound.
DENSITY = 2000.0
# Shares of the peak between which a curve is assumed straight.
_STRAIGHT = (0.1, 0.5)
# Share of the time until the expected peak in which the speed of the walls grows.
_BEGIN = 0.2


@dataclass(frozen=True, eq=False)
class StrengthTest(OfOneRun):
    """Result of a test to failure.

    Attributes:
        peak: largest stress [Pa], positive in tension and in compression: force over the nominal section of the test.
        E: slope of the stress over the strain of the curve, or over that of a gauge, between a tenth and half of the
            peak [Pa]; NaN for too few records. Some tests derive a modulus from it.
        curve: strain [-] and stress [Pa] of each record, positive along the load, shape (k, 2).
        work: work of platens and loads until the end, per area of the broken section [J/m²].
        asymmetry: largest difference of the forces on both platens until the peak, over the peak [-].
        unbalance: root mean square of that difference until the peak, over the peak [-], near 0 for quasi-static
            loading. Single breaks of brittle bonds increase `asymmetry` at any speed, but hardly `unbalance`.
        kinetic: largest kinetic energy up to the peak over the elastic energy at the peak [-].
        residual: error of the energy balance over its largest term [-].
        cracking: cracks and pieces, and the dissipated energy; `cracking.single` is True if one crack dissipated it.
        run: result of the explicit run.
    """

    peak: float
    E: float
    curve: Floats
    work: float
    asymmetry: float
    unbalance: float
    kinetic: float
    residual: float
    cracking: Cracking
    run: ExplicitResult

    @property
    def table(self) -> dict[str, Floats]:
        """Curve, with time and energies of its records, by name and unit, (k,) each."""
        return {"strain [-]": self.curve[:, 0], "stress [Pa]": self.curve[:, 1]} | dict(self.run.table)


@dataclass(frozen=True, eq=False)
class Rig:
    """Loading of a specimen between two sides, with the evaluation of forces and motions and the end of the test.

    Attributes:
        axis: axis of the load, 0, 1 or 2.
        sign: 1 if the sides move apart, -1 if they approach.
        near, far: gauges of the forces on both sides, whose sums are the loads; the far side moves along the axis
            relative to the near one.
        section: area over which the force is a stress [m²].
        torn: area of the broken section, for the work [m²].
        length: length over which the motion is a strain [m].
        size: length of one pass of sound [m].
        expected: expected stress at the peak [Pa].
        way: elastic motion at the expected peak [m].
        reach: limit of the motion [m].
        ending: share of the peak at which the test ends [-].
        traverses: number of passes of sound before the expected peak [-].
        model: function of the signed speed of the far side [m/s] and its rise time [s] that returns the model.
        gauge: strain gauge for the slope E; None to use the motion over `length`.
        strain: function of normal strains of the gauge, (k, 3), that returns the strain for the slope E [-], (k,).
        more: further gauges, by name.
        least: share of the expected stress that a peak must exceed [-].
        records: number of records until the limit of the motion.
    """

    axis: int
    sign: float
    near: tuple[AnyGauge, ...]
    far: tuple[AnyGauge, ...]
    section: float
    torn: float
    length: float
    size: float
    expected: float
    way: float
    reach: float
    ending: float
    traverses: float
    model: Callable[[float, float], Model]
    gauge: StrainGauge | None = None
    strain: Callable[[Floats], Floats] = lambda strains: strains[:, 0]
    more: Mapping[str, AnyGauge] = field(default_factory=dict)
    least: float = 0.5
    records: int = _RECORDS

    @property
    def _sides(self) -> dict[str, tuple[AnyGauge, float]]:
        """Gauges of the forces on both sides by name, each with the sign that gives the force on the specimen."""
        found: dict[str, tuple[AnyGauge, float]] = {}
        for side, gauges in (("near", self.near), ("far", self.far)):
            for k, gauge in enumerate(gauges):
                # a gauge of a wall records the force of the elements on it
                found[side if not k else f"{side} {k + 1}"] = gauge, -1.0 if isinstance(gauge, WallGauge) else 1.0
        return found

    @property
    def gauges(self) -> dict[str, AnyGauge]:
        """Gauges of the run by name: forces on both sides, strain if it is measured, and further ones."""
        found = {name: gauge for name, (gauge, _) in self._sides.items()}
        return (found if self.gauge is None else found | {"strain": self.gauge}) | dict(self.more)

    @property
    def end(self) -> LoadDrop:
        """End of the test: the load has dropped to a share of its peak."""
        load = {}
        for name, (_, taken) in self._sides.items():
            half = 0.5 if name.startswith("far") else -0.5
            x, y, z = (half * taken * self.sign * np.eye(3)[self.axis]).tolist()
            load[name] = x, y, z
        return LoadDrop(load, self.ending, self.least * self.expected * self.section)

    def forces(self, history: History) -> tuple[Floats, Floats]:
        """Return the forces of the near and of the far side on the specimen along the axis [N], (k,) each."""
        near, far = np.zeros((2, len(history)))
        for name, (_, taken) in self._sides.items():
            side = far if name.startswith("far") else near
            side += taken * history[name][:, self.axis]
        return near, far


def softening_of(test: str, failure: object, wanted: str) -> Softening:
    """Return the softening law of a criterion; for criteria by region that of the first one, the matrix.

    Raises:
        InputError: no criterion, or one without a required fracture energy.
    """
    found = instance(f"labtests.{test}", "failure", matrix_of(failure), Criterion, wanted).softening
    if found is None:
        raise InputError(
            f"labtests.{test}: failure has no softening law, so that strengths are unknown; give {wanted}"
        )
    return found


def softenings_of(test: str, body: Lattice, failure: FailureAssignment, wanted: str) -> tuple[Softening, ...]:
    """Return the softening laws of the criteria of any bond or element but open joints, in their order in `failure`.

    Raises:
        InputError: no criterion, or one without a required fracture energy.
    """
    softening_of(test, failure, wanted)
    there = [part for part in failure_parts(body, failure) if len(part.bonds) + len(part.elements) and not part.open]
    return tuple(softening_of(test, part.criterion, wanted) for part in there)


@dataclass(frozen=True)
class Moduli:
    """Averages of Young's modulus over the cells of a body, weighted by volume.

    Attributes:
        stiff: arithmetic mean [Pa], an upper bound of the modulus of the specimen.
        soft: harmonic mean [Pa], a lower bound of the modulus of the specimen.
        sound: (mean of E^-1/2)^-2 [Pa]; √(sound / ρ) is the speed of sound through all cells in series.
    """

    stiff: float
    soft: float
    sound: float

    @classmethod
    def of(cls, test: str, body: Lattice, law: CellAssignment, density: float) -> "Moduli":
        """Compute the averages for a body of cells with a given density [kg/m³]; errors as for `require_cells`."""
        matrix = require_cells(test, body, law, density)
        if not isinstance(law, Mapping):
            return cls(matrix.E, matrix.E, matrix.E)
        cells = Model(body, law, DENSITY).cell_constants
        E = cells.G * (3.0 * cells.lame + 2.0 * cells.G) / (cells.lame + cells.G)
        if len(set(E.tolist())) == 1:  # one modulus under several keys: exactly as given, without rounding
            return cls(matrix.E, matrix.E, matrix.E)
        share = cells.volume / cells.volume.sum()
        return cls(float(share @ E), float(1.0 / (share @ (1.0 / E))), float((share @ E**-0.5) ** -2.0))


@dataclass(frozen=True)
class RunOptions:
    """Options that tests to failure share.

    Attributes:
        density: density of the material [kg/m³].
        traverses: passes of sound until the expected peak [-]; None for the usual number of a test.
        out: run file from which a test continues; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.
    """

    density: float
    traverses: float | None
    out: str | Path | None
    progress: Callable[[float], None] | None

    @classmethod
    def of(
        cls, density: float | Material | None, traverses: float | None, out: str | Path | None,
        progress: Callable[[float], None] | None,
    ) -> "RunOptions":  # fmt: skip
        """Create the options of a test from its arguments; the density is 2000 kg/m³ for None."""
        given = constant("density", density)
        return cls(DENSITY if given is None else given, traverses, out, progress)

    def check_traverses(self, test: str) -> None:
        """Raise InputError if `traverses` is below one pass of sound."""
        if self.traverses is not None:
            number(f"labtests.{test}", "traverses", self.traverses, least=1.0, advice="a number of at least 1")


def require_cells(test: str, body: Lattice, law: object, density: float = DENSITY) -> CellBond:
    """Check a body of cells, its law and a density [kg/m³].

    Returns:
        The cell law; for laws by region the first one, of the matrix.

    Raises:
        InputError: no cells, several bodies, turned ends x_min or x_max, another law, or a density not above 0.
    """
    check(test, body, density=density)
    matrix = matrix_of(law)
    refusal = f"labtests.{test}: the lattice or its law is not of cells; connect with method='laguerre' and give"
    body.elements.require_cells(f"{refusal} bd.CellBond")
    kind_of(matrix).require_facets(f"{refusal} bd.CellBond")
    return cast(CellBond, matrix)


def matrix_of(given: object) -> object:
    """Return the first value of a mapping by region, that of the matrix (None if empty); return others unchanged."""
    return next(iter(given.values()), None) if isinstance(given, Mapping) else given


def run_to_failure(
    test: str, body: Lattice, law: CellAssignment, failure: FailureAssignment, rig: Rig, options: RunOptions
) -> StrengthTest:
    """Load a body of cells slowly until it has failed, with mass damping; errors as for `run_test`."""
    sound = math.sqrt(Moduli.of(test, body, law, options.density).sound / options.density)
    damping = MassDamping(alpha=2.0 * _DAMPING * math.pi * sound / rig.size)
    G = softening_of(test, failure, "a criterion with its fracture_energy").fracture_energy
    return load_rig(test, body, rig, sound=sound, damping=damping, G=G, options=options)


def load_rig(
    test: str, body: Lattice, rig: Rig, *, sound: float, damping: AnyDamping, G: float, options: RunOptions
) -> StrengthTest:
    """Load a specimen in a rig until it has failed; errors as for `run_test`.

    Args:
        test: name of the calling function.
        body: the specimen.
        rig: loading and evaluation.
        sound: speed of sound [m/s].
        damping: damping of the run.
        G: fracture energy G_f of the material [J/m²]; NaN for brittle bonds, which have none.
        options: run file and progress.
    """
    rise = rig.traverses * rig.size / sound  # time until the expected peak
    speed = rig.sign * rig.way / rise
    begin = _BEGIN * rise
    model = rig.model(speed, begin)
    duration = rig.reach / abs(speed) + 0.5 * begin
    dt = step_of(model, damping=damping, softening=0.75)
    every = max(1, round(duration / rig.records / dt))
    found = run_test(
        test, model, lambda run: _read(run, body, rig, speed, begin, G), duration=duration, dt=dt, every=every,
        out=options.out, damping=damping, until=rig.end, gauges=rig.gauges, progress=options.progress,
    )  # fmt: skip
    found.cracking.warn(test)
    return found


def initial_slope(motion: Floats, load: Floats) -> float:
    """Fit the slope of a load over a motion, (k,) each, between a tenth and half of the peak, in their units.

    Only records before the peak count. The result is NaN for fewer than three of them.
    """
    top = int(np.argmax(load))
    low, high = (share * load[top] for share in _STRAIGHT)
    straight = np.flatnonzero((np.arange(len(load)) < top) & (load > low) & (load < high))
    return float(np.polyfit(motion[straight], load[straight], 1)[0]) if len(straight) > 2 else math.nan


def _read(run: ExplicitResult, body: Lattice, rig: Rig, speed: float, begin: float, G: float) -> StrengthTest:
    history = run.history
    t = history.time
    moved = np.where(t < begin, 0.5 * t**2 / begin, t - 0.5 * begin) * abs(speed)
    near, far = rig.forces(history)
    stress = rig.sign * (0.5 * (far - near) / rig.section)
    top = int(np.argmax(stress))
    peak = float(stress[top])
    strain = moved / rig.length if rig.gauge is None else rig.strain(history["strain"])
    energy = history.parts
    kinetic, elastic = energy["kinetic"], energy["elastic"]
    both = np.abs(far + near)[: top + 1] / rig.section
    cracking = Cracking(
        body=body, state=run.state, integrity=CRACKED, stored=float(elastic[top]), fracture_energy=G,
        section=rig.torn if rig.sign > 0.0 else math.nan, axis=rig.axis, ended=float(stress[-1]) / peak,
        **dissipated_in(history),
    )  # fmt: skip
    return StrengthTest(
        peak=peak, E=initial_slope(strain, stress), curve=np.column_stack([moved / rig.length, stress]),
        work=float(energy["work"][-1]) / rig.torn, asymmetry=float(both.max() / peak),
        unbalance=float(np.sqrt(np.mean(both**2)) / peak),
        kinetic=float(kinetic[: top + 1].max() / elastic[top]), residual=run.residual, cracking=cracking, run=run,
    )  # fmt: skip
