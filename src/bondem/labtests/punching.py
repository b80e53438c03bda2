"""The shear test of Celigueta et al. (2020): the core of a cylinder, between two ring borings, is pushed out."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from bondem._checks import number
from bondem._progress import staged
from bondem._types import Floats, Ints
from bondem.errors import InputError
from bondem.labtests.probing import walls_along
from bondem.labtests.rig import (
    DENSITY,
    Rig,
    StrengthTest,
    check_traverses,
    require_cells,
    run_to_failure,
    softenings_of,
)
from bondem.laws.failure.softening import Softening
from bondem.model.boundary import BoundaryCondition, Drive, Fix
from bondem.model.cell_constants import CellAssignment
from bondem.model.failure_assignment import FailureAssignment
from bondem.model.model import Model
from bondem.model.schedules import Ramp
from bondem.solve.static import solve_static
from bondem.specimen.geometry import Cylinder
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face, Index, Region
from bondem.specimen.shape import Cut, Shape

# The borings of the paper: mean diameter, width and depth [m].
_RING, _WIDTH, _DEPTH = 45e-3, 4e-3, 10e-3
# The motion at which a test ends at the latest, over that of the expected peak.
_REACH = 6.0


def punch_specimen(
    *,
    diameter: float = 150e-3,
    height: float = 80e-3,
    ring: float = _RING,
    width: float = _WIDTH,
    depth: float = _DEPTH,
) -> Shape:
    """A cylinder, axis x, with a ring boring from each end: the face "boring".

    Args:
        diameter: of the cylinder [m].
        height: of the cylinder [m].
        ring: mean diameter of the borings [m].
        width: of the borings [m].
        depth: of the borings [m].

    Raises:
        InputError: borings that do not fit.

    Reference: Celigueta, Latorre, Arrufat and Oñate (2020), §4.3.
    """
    sizes = {"diameter": diameter, "height": height, "ring": ring, "width": width, "depth": depth}
    size, length, mean, wide, deep = (
        number("labtests.punch_specimen", name, value, unit="m", above=0.0) for name, value in sizes.items()
    )
    if not (wide < mean and mean + wide < size and 2.0 * deep < length):
        raise InputError(
            f"labtests.punch_specimen: borings of mean diameter {mean:.4g} m, {wide:.4g} m wide, {deep:.4g} m deep"
            f" do not fit into a cylinder of {size:.4g} × {length:.4g} m; take smaller ones"
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
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    density: float | None = None,
    traverses: float = 60.0,
    ending: float = 0.5,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Push the core of a `punch_specimen` along x out of the ring around it, until the load has dropped.

    A smooth piston presses on x_max inside of its boring, a smooth holed plate bears x_min outside of its boring. The
    stress is the mean shear stress P / (π D h) on the cylinder of height h between the middles D of both borings, and
    the strain the motion of the piston over h. Cracks run where stresses drive them: the peak is a limit load of the
    specimen and no strength of the material, and has no closed form. E is that of an elastic body of the same cells
    as stiff as the slope of the curve.

    Args:
        body: cells of a `punch_specimen`.
        law: its material, or laws by region, the first of which, of the matrix, sets the speed of the test.
        failure: `bd.MohrCoulomb` with a fracture energy, or another criterion with a tensile strength; or by region.
        density: of the material [kg/m³]; no result depends on it.
        traverses: how often sound runs along the diameter until the expected peak; the more, the slower.
        ending: share of the peak to which the load has to drop [-].
        progress: called now and then with the share done, 0 … 1.

    Raises:
        InputError: a body without such borings, a lattice without cells, or a criterion that knows no strength.
        UnstableRunError: the run became unstable.
    """
    owner = "labtests.shear"
    check_traverses("shear", traverses)
    share = number(owner, "ending", ending, least=0.0, below=1.0)
    matrix = require_cells("shear", body, law, density)
    found = softenings_of("shear", body, failure, "bd.MohrCoulomb with a fracture_energy")
    core = _Core.of(body)
    plate, piston = core.plate, core.piston
    lower, upper = body.particles.envelope.bounds
    section = math.pi * core.ring * core.height
    compliance = _compliance(body, law, plate, piston) * section
    strengths = [_expected(one) for one in found]
    expected = min(strengths)

    def sides(speed: float, begin: float) -> list[BoundaryCondition]:
        return [Fix(plate, translation="x", rotation=""), Drive(piston, vx=Ramp(0.0, speed, begin))]

    rig = Rig(
        axis=0, sign=-1.0, near=plate, far=piston, section=section, torn=section, length=core.height,
        size=float(upper[1] - lower[1]),
        expected=expected, way=compliance * expected, reach=_REACH * compliance * strengths[0], ending=share,
        traverses=traverses, boundary=sides,
    )  # fmt: skip
    test = run_to_failure("shear", body, law, failure, rig, density=density, progress=progress)
    return replace(test, E=test.E * matrix.E * compliance / core.height)


@dataclass(frozen=True, eq=False)
class _Core:
    """What is pushed out: under the piston, beside the holed plate; and the surface between both borings."""

    piston: Region
    plate: Region
    ring: float
    height: float

    @classmethod
    def of(cls, body: Lattice) -> "_Core":
        """From the shape of the body.

        Raises:
            InputError: it has no ring boring in each end.
        """
        shape = body.particles.envelope
        lower, upper = shape.bounds
        if not {"x_min", "x_max"} <= set(shape.faces):
            raise _no_borings()
        below, above = (_boring(shape, lower, upper, end) for end in (lower[0], upper[0]))
        if abs(below[0] - above[0]) + abs(below[1] - above[1]) > 1e-6 * float(upper[1] - lower[1]):
            raise InputError("labtests.shear: the ring borings of both ends differ; give both the same radii")
        regions = []
        for name, keep_core, radius in (("x_max", True, above[0]), ("x_min", False, below[1])):
            cells, distance = _on_face(body, name)
            chosen = cells[(distance < radius) == keep_core]
            if not len(chosen):
                raise _no_borings()
            regions.append(Face(name) & Index(chosen))
        height = float(upper[0] - lower[0]) - below[2] - above[2]
        return cls(regions[0], regions[1], below[0] + below[1], height)


def _boring(shape: Shape, lower: Floats, upper: Floats, end: float) -> tuple[float, float, float]:
    """Inner and outer radius of the ring boring in an end, and its depth [m]."""
    middle, length = 0.5 * (lower + upper), float(upper[0] - lower[0])
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
        "labtests.shear: the body has no ring boring about the axis x in each end; make it from"
        " bd.labtests.punch_specimen"
    )


def _on_face(body: Lattice, name: str) -> tuple[Ints, Floats]:
    """Cells of an end, and how far from the axis each is there [m]."""
    assert body.cells is not None
    lower, upper = body.particles.envelope.bounds
    free, on = body.cells.free, body.on_face(name)
    y, z = (free.centroid[on, axis] - 0.5 * (lower + upper)[axis] for axis in (1, 2))
    count = len(body.particles)
    area = np.bincount(free.cell[on], weights=free.area[on], minlength=count)
    radius = np.bincount(free.cell[on], weights=free.area[on] * np.hypot(y, z), minlength=count)
    cells = np.flatnonzero(area > 0.0)
    return cells, radius[cells] / area[cells]


def _expected(softening: Softening) -> float:
    """Roughly the shear stress at the peak [Pa], for the speed: the cohesion, or the tensile strength."""
    if softening.slip is None:
        return softening.tension
    return 0.5 * math.sqrt(softening.tension * softening.slip.compressive())


def _compliance(body: Lattice, law: CellAssignment, plate: Region, piston: Region) -> float:
    """Motion of the piston over its force, as long as all is elastic [m/N]."""
    lower, upper = body.particles.envelope.bounds
    distance = np.linalg.norm(body.particles.position - 0.5 * (lower + upper), axis=1)
    motion = 1e-6 * float(upper[0] - lower[0])
    boundary = [
        Fix(plate, translation="x", rotation=""), Drive(piston, x=-motion),
        Fix(Index([int(np.argmin(distance))]), translation="yz", rotation="x"),
    ]  # fmt: skip
    static = solve_static(Model(body, law, DENSITY, boundary=boundary))
    return motion / abs(float(static.reaction[piston.select(body), 0].sum()))
