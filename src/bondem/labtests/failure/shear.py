"""Punch-shear test of Celigueta et al. (2020): the core of a cylinder between two ring borings is pushed out."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from bondem._checks import number
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.conditions import Drive, Fix
from bondem.boundary.gauges import Gauge
from bondem.boundary.schedules import Ramp
from bondem.damage.cohesive_softening import Softening
from bondem.damage.failure_assignment import FailureAssignment
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Cylinder
from bondem.geometry.shape import Cut, Shape
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.bonded_platens import LEAST, REACH, RECORDS, BondedSpecimen, Side, as_cells, is_cells
from bondem.labtests.faces import means_on_face
from bondem.labtests.line_probe import walls_along
from bondem.labtests.quasi_static_rig import (
    DENSITY,
    Rig,
    RunOptions,
    StrengthTest,
    require_cells,
    run_to_failure,
    softenings_of,
)
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material
from bondem.specimen.regions import Face, Index, Region
from bondem.statics.static import solve_static

# Borings of Celigueta et al. (2020): mean diameter, width and depth [m].
_RING, _WIDTH, _DEPTH = 45e-3, 4e-3, 10e-3
# Limit of the motion of a test, over that at the expected peak.
_REACH = 6.0


def punch_specimen(
    *, diameter: float = 150e-3, height: float = 80e-3, ring: float = _RING, width: float = _WIDTH,
    depth: float = _DEPTH,
) -> Shape:  # fmt: skip
    """Create a cylinder along x with a ring boring in each end; the borings are the face "boring".

    Args:
        diameter: diameter of the cylinder [m].
        height: height of the cylinder [m].
        ring: mean diameter of the borings [m].
        width: width of the borings [m].
        depth: depth of the borings [m].

    Raises:
        InputError: a size is not positive, or the borings do not fit into the cylinder.

    Reference: Celigueta, Latorre, Arrufat and Oñate (2020), §4.3.
    """
    sizes = {"diameter": diameter, "height": height, "ring": ring, "width": width, "depth": depth}
    size, length, mean, wide, deep = (
        number("labtests.punch_specimen", name, value, unit="m", above=0.0) for name, value in sizes.items()
    )
    if not (wide < mean and mean + wide < size and 2.0 * deep < length):
        raise InputError(
            f"labtests.punch_specimen: borings of mean diameter {mean:.4g} m, {wide:.4g} m wide and {deep:.4g} m deep"
            f" do not fit into a cylinder of {size:.4g} × {length:.4g} m; give smaller borings"
        )
    shape: Shape = Cylinder(radius=0.5 * size, length=length)
    rod = Cylinder(radius=0.5 * (mean + wide), length=2.0 * deep)
    core = Cylinder(radius=0.5 * (mean - wide), length=2.0 * deep)
    for start in (-deep, length - deep):
        shape = shape.cut(Cut(rod, core).moved((start, 0.0, 0.0)), name="boring")
    return shape


@staged("shear")
def shear(
    body: Lattice,
    law: AnyLaw,
    failure: FailureAssignment,
    *,
    density: float | Material | None = None,
    contact: ContactLaw | None = None,
    traverses: float | None = None,
    ending: float = 0.5,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Push the core of a `punch_specimen` along x out of its ring, until the load has dropped.

    A smooth piston presses on x_max inside its boring, and a smooth plate with a hole supports x_min outside its
    boring. The stress is the mean shear stress P / (π D h) on the cylinder of height h and mean diameter D between
    both borings. The strain is the motion of the piston over h. Cracks follow the stresses, so that the peak is a
    limit load of the specimen without a closed form, and not a strength of the material. E is the Young's modulus
    with which an elastic model of these cells has the slope of the curve; it is NaN for bonded spheres.

    Args:
        body: cells or bonded spheres of a `punch_specimen`.
        law: cell law, bond law, or laws by region, or the non-local law; of cells the first one is the matrix.
        failure: for cells `bd.MohrCoulomb` with a fracture energy, or another criterion with a tensile strength; for
            bonded spheres a criterion of bonds such as `bd.PeripheralStress`; or criteria by region.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it. None for 2000.
        contact: contact law of fragments, piston and plate, for bonded spheres; None for the stiffness of the median
            bond and a friction of 0.4 between fragments.
        traverses: number of passes of sound along the diameter before the expected peak [-]; more is slower. None for
            60; bonded spheres have 50, and 100 or 200 if the forces of piston and plate do not balance.
        ending: share of the peak load at which the test ends [-].
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: a body without such borings, no criterion, a criterion without strength, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Warns:
        NotQuasistaticWarning: `.unbalance` is above 0.02 for bonded spheres; for cells as in `solve_explicit`.
        StrengthWarning: the load of bonded spheres still rises at the limit of the motion.
    """
    owner, options = "labtests.shear", RunOptions.of(density, traverses, out, progress)
    options.check_traverses("shear")
    share = number(owner, "ending", ending, least=0.0, below=1.0)
    if not is_cells(body, law):
        specimen = BondedSpecimen.of("shear", body, law, failure, density=options.density, contact=contact)
        return _shear_bonded(specimen, share, options)
    law = as_cells("shear", law, contact)
    matrix = require_cells("shear", body, law, options.density)
    found = softenings_of("shear", body, failure, "bd.MohrCoulomb with a fracture_energy")
    core = _Core.of(body)
    plate, piston = core.loaded(body)
    lower, upper = body.particles.envelope.bounds
    section = math.pi * core.ring * core.height
    compliance = _compliance(body, law, plate, piston) * section
    strengths = [_expected(one) for one in found]
    expected = min(strengths)

    def pushed(speed: float, begin: float) -> Model:
        sides = [Fix(plate, translation="x", rotation=""), Drive(piston, vx=Ramp(0.0, speed, begin))]
        return Model(body, law, options.density, failure=failure, boundary=sides)

    rig = Rig(
        axis=0, sign=-1.0, near=(Gauge(plate, "force"),), far=(Gauge(piston, "force"),),
        section=section, torn=section, length=core.height, size=float(upper[1] - lower[1]), expected=expected,
        way=compliance * expected, reach=_REACH * compliance * strengths[0], ending=share,
        traverses=traverses or 60.0, model=pushed,
    )  # fmt: skip
    test = run_to_failure("shear", body, law, failure, rig, options)
    return replace(test, E=test.E * matrix.E * compliance / core.height)


def _shear_bonded(specimen: BondedSpecimen, ending: float, options: RunOptions) -> StrengthTest:
    """Push the core of bonded spheres out of its ring, by a piston against a plate with a hole."""
    core = _Core.of(specimen.lattice)
    lower, upper = specimen.bounds
    distance = np.hypot(*(specimen.lattice.centre - 0.5 * (lower + upper))[:, 1:].T)
    under, above = distance < core.inside, distance > core.outside
    hole, disc = (
        partial(specimen.platen, 0, -1.0, 0.0, where=above, inner=core.outside),
        partial(specimen.platen, 0, 1.0, 0.0, where=under, outer=core.inside),
    )
    plate, piston = specimen.layer(0, -1.0, where=above), specimen.layer(0, 1.0, where=under)
    section = math.pi * core.ring * core.height
    compliance, force = specimen.response(0, plate, piston, section, 1.0, -1.0)
    near, far, model = specimen.sides(0, (Side(plate, 0.0, hole),), (Side(piston, 1.0, disc),))
    rig = Rig(
        axis=0, sign=-1.0, near=near, far=far, section=section, torn=section,
        length=core.height, size=float(upper[1] - lower[1]), expected=force / section,
        way=compliance * force, reach=REACH * compliance * force, ending=ending, traverses=math.nan, model=model,
        least=LEAST, records=RECORDS,
    )  # fmt: skip
    return replace(specimen.load(rig, options), E=math.nan)


@dataclass(frozen=True, eq=False)
class _Core:
    """Dimensions of the core between both ring borings of a `punch_specimen`.

    Attributes:
        inside: radius of the core at x_max, under the piston [m].
        outside: outer radius of the boring at x_min, beyond which the plate is [m].
        ring: mean diameter of the borings [m].
        height: height between both borings [m].
    """

    inside: float
    outside: float
    ring: float
    height: float

    @classmethod
    def of(cls, body: Lattice) -> "_Core":
        """Measure the core of a body.

        Raises:
            InputError: an end has no ring boring, or the borings of both ends differ.
        """
        shape = body.particles.envelope
        lower, upper = shape.bounds
        if not {"x_min", "x_max"} <= set(shape.faces):
            raise _no_borings()
        below, above = (_boring(shape, lower, upper, end) for end in (lower[0], upper[0]))
        if abs(below[0] - above[0]) + abs(below[1] - above[1]) > 1e-6 * float(upper[1] - lower[1]):
            raise InputError("labtests.shear: the ring borings of both ends differ; give both the same radii")
        return cls(above[0], below[1], below[0] + below[1], shape.extent - below[2] - above[2])

    def loaded(self, body: Lattice) -> tuple[Region, Region]:
        """Select the cells on the plate, and those under the piston.

        Raises:
            InputError: no cell is on the plate, or none under the piston.
        """
        middle, regions = 0.5 * np.add(*body.particles.envelope.bounds), []
        for name, keep_core, radius in (("x_min", False, self.outside), ("x_max", True, self.inside)):
            cells, distance = means_on_face(body, name, lambda place: np.hypot(*(place - middle)[:, 1:].T))
            chosen = cells[(distance < radius) == keep_core]
            if not len(chosen):
                raise _no_borings()
            regions.append(Face(name) & Index(chosen))
        return regions[0], regions[1]


def _boring(shape: Shape, lower: Floats, upper: Floats, end: float) -> tuple[float, float, float]:
    """Measure inner and outer radius and depth [m] of the ring boring at x = `end` [m]; InputError if missing."""
    middle, length = 0.5 * (lower + upper), shape.extent
    way = 1.0 if end == lower[0] else -1.0
    start = np.array([end + way * 1e-6 * length, middle[1], middle[2]])
    inside, walls = walls_along(shape, start, start + np.array([0.0, 0.999 * (upper[1] - middle[1]), 0.0]))
    if not inside or len(walls) != 2:
        raise _no_borings()
    inner, outer = (float(wall) for wall in walls)
    start = start + np.array([0.0, 0.5 * (inner + outer), 0.0])
    inside, bottom = walls_along(shape, start, start + np.array([way * 0.999 * length, 0.0, 0.0]))
    if inside or len(bottom) < 1:
        raise _no_borings()
    return inner, outer, float(bottom[0]) + 1e-6 * length


def _no_borings() -> InputError:
    return InputError(
        "labtests.shear: the body has no ring boring about the axis x in each end; create it from"
        " bd.labtests.punch_specimen"
    )


def _expected(softening: Softening) -> float:
    """Estimate the shear stress at the peak [Pa], which sets speed and limit of the motion only."""
    found = softening.tension
    for slip in softening.slips:
        found = 0.5 * math.sqrt(softening.tension * slip.compressive())
    return found


def _compliance(body: Lattice, law: CellAssignment, plate: Region, piston: Region) -> float:
    """Solve for the elastic motion of the piston per force [m/N]."""
    lower, upper = body.particles.envelope.bounds
    distance = np.linalg.norm(body.particles.position - 0.5 * (lower + upper), axis=1)
    motion = 1e-6 * float(upper[0] - lower[0])
    boundary = [
        Fix(plate, translation="x", rotation=""), Drive(piston, x=-motion),
        Fix(Index([int(np.argmin(distance))]), translation="yz", rotation="x"),
    ]  # fmt: skip
    static = solve_static(Model(body, law, DENSITY, boundary=boundary))
    return motion / abs(float(static.reaction[piston.select(body), 0].sum()))
