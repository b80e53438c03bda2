"""Three-point bending: flexural strength and work of fracture of a plain or notched beam."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from bondem._checks import instance, number
from bondem._drawing import PlottedPath
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.conditions import Load
from bondem.damage.criteria.criterion import Criterion
from bondem.damage.criteria.rankine import Rankine
from bondem.damage.failure_assignment import FailureAssignment
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import InputError, RunInterrupted
from bondem.geometry.elementary_shapes import Box
from bondem.geometry.shape_boundary import BOX_FACES
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import refuse_turned
from bondem.labtests.bonded_bending import bend_bonded
from bondem.labtests.bonded_platens import BondedSpecimen, as_cells, is_cells
from bondem.labtests.cracking import CRACKED, Cracking
from bondem.labtests.faces import means_on_face
from bondem.labtests.line_probe import ligament_of
from bondem.labtests.quasi_static_rig import DENSITY, RunOptions, require_cells, softening_of
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material
from bondem.specimen.regions import Face, Index, Region, Within
from bondem.statics.quasistatic.load_response import MeasuringPoints
from bondem.statics.quasistatic.quasistatic_run import QuasistaticResult, solve_quasistatic

# Load at a factor of 1 [N], on which no result depends.
_LOAD = 1e3
# Width of the loaded strips over the depth of the beam, and its lower limit in mean edges of cells.
_STRIP, _CELLS = 0.1, 1.5
# Name of the gauge of the opening of a notch; least component along x of the normals of its sides [-].
_MOUTH, _STEEP = "cmod", 0.5


@dataclass(frozen=True, eq=False)
class BendingTest(PlottedPath):
    """Result of a bending test: for cells a quasi-static path of failure events, for bonded spheres a run over time.

    Attributes:
        peak: flexural strength 3 P L / (2 b h²) [Pa], with h the ligament above the notch or the whole depth.
        E: Young's modulus from the deflection of a plain beam, with shear [Pa]. For a notched beam it is a smaller,
            apparent modulus.
        curve: deflection over the span [-] and 3 P L / (2 b h²) [Pa] at each event or record, from 0, shape (k, 2).
        work: work of the rollers per area b h of the ligament [J/m²]: dissipated energy and final elastic energy.
        span: distance L of the supports [m].
        ligament: height h of the ligament [m].
        path: quasi-static path of cells, with loads [N]; `path.gauge` has the displacements between the rollers,
            "left" and "right" [m], and the requested gauges. For bonded spheres the explicit run.
        load: load P at each row of the curve [N], shape (k,).
        deflection: deflection at each row of the curve [m], shape (k,).
        cracking: cracks and pieces, and the dissipated energy; `cracking.single` is True if one crack dissipated it.
        cmod: opening of the notch mouth along x at each row of the curve [m], shape (k,), as the mean over the
            width. The edges of the notch move and rotate with their cells. None for a beam without a notch.
    """

    peak: float
    E: float
    curve: Floats
    work: float
    span: float
    ligament: float
    path: QuasistaticResult | ExplicitResult
    load: Floats
    deflection: Floats
    cracking: Cracking
    cmod: Floats | None

    @property
    def state(self) -> State:
        """State of the broken beam at its last equilibrium, or at the end of the run of bonded spheres."""
        return self.path.state

    @property
    def table(self) -> dict[str, Floats]:
        """Notch opening if measured, load, deflection, deflection over span and stress, by name and unit."""
        mouth = {} if self.cmod is None else {"CMOD [m]": self.cmod}
        others = {"load [N]": self.load, "deflection over span [-]": self.curve[:, 0]}
        deflection = {"deflection [m]": self.deflection}
        both = mouth | others | deflection if mouth else deflection | others
        return both | {"3 P L / (2 b h²) [Pa]": self.curve[:, 1]}


@staged("three point bending")
def three_point_bending(
    body: Lattice,
    law: AnyLaw,
    failure: FailureAssignment,
    *,
    span: float | None = None,
    strip: float | None = None,
    ripple: float = 0.02,
    together: float = 0.005,
    until: float = 0.05,
    most: int = 100_000,
    gauges: Mapping[str, tuple[Region, Region]] | None = None,
    roller_friction: float = 0.0,
    density: float | Material | None = None,
    contact: ContactLaw | None = None,
    traverses: float | None = None,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> BendingTest:
    """Bend a beam in three-point bending until it has failed.

    The beam has the axis x, the depth along y and the width along z, with one roller above mid-span and two supports
    below. Each roller is a traction along y on a strip of the surface, whose resultant passes through the line of the
    roller. The rollers neither constrain the beam along x nor clamp it.

    `bd.solve_quasistatic` follows the equilibrium path, also through snap-back, so that density and speed do not
    enter. Tension alone decides: of `bd.MohrCoulomb` only tensile strength, fracture energy, softening curve and
    scatter are used, and cells do not yield.

    The deflection is the displacement of the middle of the section at mid-span (above a notch, of the ligament)
    relative to mid-depth over the supports. It excludes the indentation by the rollers. E follows from the
    deflection P / (E b) ((L/D)³/4 + (0.6 + 0.375 ν) L/D - 0.21) at the depth D (Timoshenko and Goodier §40). The last
    terms are the shear of beam theory, 0.6 (1 + ν) L/D, less the local effect of the roller. This effect is 4 % of
    the total at L = 3 D and ν = 0.2.

    Bonded spheres have a run over time, between rigid rods along z that touch the outermost spheres; the one above
    mid-span moves. E uses the ν of the bond law, and `cmod` is None.

    Args:
        body: cells or bonded spheres of a box along x, plain or with a notch from below at mid-span,
            `shape.cut(..., name="notch")`.
        law: cell law, bond law, or laws by region, or the non-local law; the first one sets the ν of E.
        failure: for cells `bd.Rankine`, or `bd.MohrCoulomb` with a fracture energy; for bonded spheres a criterion of
            bonds such as `bd.PeripheralStress`; or criteria by region.
        span: distance of the supports, symmetric about the middle [m]; None for the length less the depth.
        strip: width of the loaded strips of cells [m]; None for a tenth of the depth, at least one and a half cells.
        ripple, together, until, most: options of `bd.solve_quasistatic`; `until` is the share of the peak at the end
            [-], also for bonded spheres.
        gauges: for cells pairs of regions whose relative displacement is recorded in `path.gauge`, by name, such as
            {"CTOD": (bd.Within(left), bd.Within(right))}; `cmod`, the opening of the notch mouth, needs none.
        roller_friction: coefficient of friction of the rollers on bonded spheres [-]; 0 for smooth ones.
        density: density of bonded spheres [kg/m³], or a `bd.Material`; None for 2000.
        contact: contact law of bonded spheres and rollers; None for the stiffness of the median bond and a friction
            of 0.4 between fragments.
        traverses: number of passes of sound along the beam before the expected peak, for bonded spheres [-]; None for
            50, and 100 or 200 if the forces of both sides do not balance.
        out: run file (HDF5) of bonded spheres from which the same call resumes; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: an unsuitable body, a span or strip that does not fit, an unsupported criterion or option, or the
            name of a gauge used twice.
        UnstableRunError: the run of bonded spheres became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Warns:
        NotQuasistaticWarning: the forces of both sides of bonded spheres differ by more than 0.02 of the peak.
        StrengthWarning: the load of bonded spheres rises at the limit of the motion, or no facet of cells fails.
    """
    if not is_cells(body, law):
        if strip is not None or gauges:
            raise InputError(
                "labtests.three_point_bending: strip and gauges are options of cells; leave them out for bonded"
                " spheres"
            )
        options = RunOptions.of(density, traverses, out, progress)
        specimen = BondedSpecimen.of(
            "three_point_bending", body, law, failure, density=options.density, contact=contact
        )
        return _bend_bonded(specimen, span=span, friction=roller_friction, until=until, options=options)
    if traverses is not None or out is not None or roller_friction:
        raise InputError(
            "labtests.three_point_bending: traverses, out and roller_friction are options of bonded spheres; leave"
            " them out for cells, which follow a path of equilibria under smooth strips"
        )
    law = as_cells("three_point_bending", law, contact)
    matrix = require_cells("three_point_bending", body, law)
    tensile = _tensile(failure)
    beam = _Beam.of(body, span, strip)
    top, loads = beam.rollers()
    own = beam.gauges()
    asked = {} if gauges is None else instance(
        "labtests.three_point_bending", "gauges", gauges, Mapping, "a mapping of names to pairs of regions"
    )  # fmt: skip
    for name in asked:
        if name in own:
            raise InputError(f"labtests.three_point_bending: gauge '{name}' is one of its own; give another name")
    model = Model(body, law, DENSITY, failure=tensile, boundary=loads)

    def read(path: QuasistaticResult) -> BendingTest:
        if not len(path.factor):
            raise InputError("labtests.three_point_bending: no facet fails at any load; check the criterion")
        stress = 1.5 * path.load * beam.span / (beam.width * beam.ligament**2)
        deflection = -0.5 * (path.gauge["middle left"] + path.gauge["middle right"])[:, 1]
        stiffness = path.load[0] / deflection[0]
        rollers = -0.5 * (path.gauge["left"] + path.gauge["right"])[:, 1]
        work = path.energy.sum() + 0.5 * path.load[-1] * rollers[-1]
        peak, section = int(np.argmax(path.load)), beam.width * beam.ligament
        cracking = Cracking(
            body=body, state=path.state, integrity=CRACKED, dissipated=float(path.energy.sum()), slipped=0.0,
            stored=float(0.5 * path.load[peak] * rollers[peak]), section=section,
            fracture_energy=softening_of("three_point_bending", failure, "a criterion").fracture_energy,
        )  # fmt: skip
        curve = np.column_stack([deflection / beam.span, stress])
        mouth = np.append(0.0, path.gauge[_MOUTH][:, 0]) if _MOUTH in own else None
        return BendingTest(
            peak=float(stress.max()), E=float(stiffness * beam.compliance(matrix.nu)),
            curve=np.vstack([np.zeros((1, 2)), curve]), work=float(work) / section,
            span=beam.span, ligament=beam.ligament, path=path, load=np.append(0.0, path.load),
            deflection=np.append(0.0, deflection), cracking=cracking, cmod=mouth,
        )  # fmt: skip

    try:
        return read(solve_quasistatic(
            model, top, ripple=ripple, together=together, until=until, most=most, gauges={**own, **asked},
            progress=progress,
        ))  # fmt: skip
    except RunInterrupted as stop:
        raise RunInterrupted(str(stop), read(stop.result) if len(stop.result.factor) else None) from None


def _bend_bonded(
    specimen: BondedSpecimen, *, span: float | None, friction: float, until: float, options: RunOptions
) -> BendingTest:
    """Bend bonded spheres between rods, over a span [m] or the default, until a share of the peak load [-]."""
    owner = "labtests.three_point_bending"
    number(owner, "roller_friction", friction, least=0.0)
    number(owner, "until", until, above=0.0, below=1.0)
    options.check_traverses("three_point_bending")
    beam = _Beam.of(specimen.lattice, span, None)
    found = bend_bonded(
        specimen, span=beam.span, ligament=beam.ligament, friction=friction, ending=until, options=options
    )
    test, law = found.test, specimen.law
    matrix = next(iter(law.values())) if isinstance(law, Mapping) else law
    curve = np.column_stack([found.deflection / beam.span, test.curve[:, 1]])
    section = beam.width * beam.ligament
    return BendingTest(
        peak=test.peak, E=found.stiffness * beam.compliance(matrix.nu), curve=curve, work=test.work, span=beam.span,
        ligament=beam.ligament, path=test.run, load=found.load, deflection=found.deflection,
        cracking=replace(test.cracking, section=section), cmod=None,
    )  # fmt: skip


def _tensile(failure: FailureAssignment) -> FailureAssignment:
    """Return the tensile part of a criterion, or of each criterion by region.

    Raises:
        InputError: a criterion that does not limit the largest principal stress.
    """
    if isinstance(failure, Mapping):
        return {where: _of_tension(one) for where, one in failure.items()}
    return _of_tension(failure)


def _of_tension(failure: object) -> Rankine:
    wanted = "bd.Rankine, or bd.MohrCoulomb with a fracture_energy"
    if isinstance(failure, Rankine):
        return failure
    softening = softening_of("three_point_bending", failure, wanted)
    if softening.surface is not None or not isinstance(failure, Criterion):
        raise InputError(
            f"labtests.three_point_bending: failure = {type(failure).__name__}: not a criterion of the largest"
            f" principal stress; give {wanted}"
        )
    return Rankine(
        tension=softening.tension, fracture_energy=softening.fracture_energy or None, curve=softening.curve,
        scatter=failure.scatter,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Beam:
    """Beam with its corners `lower` and `upper`, span, width of the loaded strips and height of the ligament [m]."""

    body: Lattice
    lower: Floats
    upper: Floats
    span: float
    strip: float
    ligament: float

    @classmethod
    def of(cls, body: Lattice, span: float | None, strip: float | None) -> "_Beam":
        """Measure a beam, with given or default span and strip [m].

        Raises:
            InputError: the body is not a beam, or span or strip do not fit.
        """
        owner, shape = "labtests.three_point_bending", body.particles.envelope
        if not {"x_min", "x_max", "y_min", "y_max"} <= set(shape.faces):
            raise InputError(f"{owner}: {type(shape).__name__} is not a beam; use a bd.Box along x, plain or notched")
        refuse_turned("three_point_bending", body, "y_min y_max")
        lower, upper = shape.bounds
        length, depth, _ = (float(extent) for extent in upper - lower)
        usual = max(_STRIP * depth, _CELLS * body.elements.size)
        wide = usual if strip is None else number(owner, "strip", strip, unit="m", above=0.0)
        between = length - depth if span is None else number(owner, "span", span, unit="m", above=0.0)
        if not (between >= depth and between + wide <= length):
            raise InputError(
                f"{owner}: span = {between:.4g} m with strips of {wide:.4g} m does not suit a beam {length:.4g} m"
                f" long and {depth:.4g} m deep; give at least the depth, and leave half a strip beyond each support"
            )
        return cls(body, lower, upper, between, wide, ligament_of(body.particles.envelope))

    @property
    def width(self) -> float:
        return float(self.upper[2] - self.lower[2])

    @property
    def middle(self) -> Floats:
        return 0.5 * (self.lower + self.upper)

    def compliance(self, nu: float) -> float:
        """Compute E · deflection / load of a plain beam [1/m], by bending, shear and local effect of the roller."""
        slender = self.span / float(self.upper[1] - self.lower[1])
        return (0.25 * slender**3 + (0.6 + 0.375 * nu) * slender - 0.21) / self.width

    def _region(self, face: str, at: float) -> Region:
        """Select the cells of a face whose mean facet position is within half a strip of the line at x = `at` [m]."""
        cells, away = means_on_face(self.body, face, lambda place: place[:, 0] - at)
        chosen = cells[np.abs(away) <= 0.5 * self.strip]
        if not chosen.size:
            raise InputError(
                f"labtests.three_point_bending: strip = {self.strip:.4g} m contains no cell at x = {at:.4g} m;"
                " give a wider strip or finer cells"
            )
        return Face(face) & Index(chosen)

    def _places(self) -> dict[str, tuple[str, float, float]]:
        """Return face, x [m] and share of the load along y of each roller, by name."""
        x = float(self.middle[0])
        return {
            "top": ("y_max", x, -1.0), "left": ("y_min", x - 0.5 * self.span, 0.5),
            "right": ("y_min", x + 0.5 * self.span, 0.5),
        }  # fmt: skip

    def rollers(self) -> tuple[Region, list[Load]]:
        """Create the region of the upper strip and the loads, whose resultants act on the lines of the rollers."""
        loads = [self._load(*place) for place in self._places().values()]
        return loads[0].region, loads

    def _load(self, face: str, at: float, share: float) -> Load:
        region, force = self._region(face, at), share * _LOAD
        off = np.array([at, 0.0, self.middle[2]]) - region.anchor(self.body)
        moment = (-float(off[2]) * force, 0.0, float(off[0]) * force)
        return Load(region, force=(0.0, force, 0.0), moment=moment)

    def gauges(self) -> Mapping[str, tuple[Region, Region]]:
        """Create pairs of regions by name of the gauge, whose relative displacements are recorded.

        Pairs are each support and the upper roller, mid-depth above each support and the middle of the ligament, and
        the edges of a notch.
        """
        region = {name: self._region(face, at) for name, (face, at, _) in self._places().items()}
        x, y = float(self.middle[0]), float(self.middle[1])
        inside = self._about(x, float(self.upper[1]) - 0.5 * self.ligament)
        ends = {"left": self._about(x - 0.5 * self.span, y), "right": self._about(x + 0.5 * self.span, y)}
        found: dict[str, tuple[Region, Region]] = {name: (region[name], region["top"]) for name in ends}
        return found | {f"middle {name}": (end, inside) for name, end in ends.items()} | self._mouth()

    def _mouth(self) -> dict[str, tuple[Region, Region]]:
        """Create the gauge between the edges of the notch at the bottom, by name; none for a plain beam.

        A cell at the mouth has a facet on a side of the notch and one on the bottom. Its edge is the intersection of
        both planes. Its weight is the extent of the side facet along z.
        """
        free, names = self.body.elements.require_cells().cells.free, self.body.particles.envelope.faces
        low = float(self.lower[1])
        walls = [k for k, name in enumerate(names) if name not in BOX_FACES]
        bottom = np.isin(free.cell, free.cell[self.body.on_face("y_min")])
        sides = np.flatnonzero(np.isin(free.face, walls) & (np.abs(free.normal[:, 0]) > _STEEP) & bottom)
        edge = free.centroid[sides]
        edge[:, 0] += free.normal[sides, 1] / free.normal[sides, 0] * (edge[:, 1] - low)
        edge[:, 1] = low
        extent = np.sqrt(free.moment[sides, 2, 2] / free.area[sides])
        left = edge[:, 0] < self.middle[0]
        if left.all() or not left.any():
            return {}
        first, second = (
            MeasuringPoints(free.cell[sides[side]], edge[side], extent[side] / extent[side].sum())
            for side in (left, ~left)
        )
        return {_MOUTH: (first, second)}

    def _about(self, x: float, y: float) -> Region:
        """Select the cells about a line along z at x and y [m], within a square of the width of a strip."""
        size = (self.strip, self.strip, 2.0 * self.width)
        corner = (x - 0.5 * self.strip, y - 0.5 * self.strip, float(self.lower[2]) - 0.5 * self.width)
        return Within(Box(size).moved(corner))
