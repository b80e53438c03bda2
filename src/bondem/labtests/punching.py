"""The shear test of Celigueta et al. (2020): the core of a cylinder, between two ring borings, is pushed out."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from bondem._checks import number
from bondem._types import Ints
from bondem.errors import InputError
from bondem.labtests.rig import (
    DENSITY,
    Rig,
    StrengthTest,
    check_traverses,
    require_cells,
    run_to_failure,
    softening_of,
)
from bondem.laws.cell_bond import CellBond
from bondem.laws.failure.criterion import Criterion
from bondem.laws.failure.softening import Softening
from bondem.model.boundary import BoundaryCondition, Drive, Fix
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
    borings = _Borings.of("punch_specimen", ring, width, depth)
    size = number("labtests.punch_specimen", "diameter", diameter, unit="m", above=0.0)
    length = number("labtests.punch_specimen", "height", height, unit="m", above=0.0)
    if not (borings.outer < 0.5 * size and 2.0 * depth < length):
        raise InputError(
            f"labtests.punch_specimen: borings of outer diameter {2.0 * borings.outer:.4g} m, {depth:.4g} m deep, do"
            f" not fit into a cylinder of {size:.4g} × {length:.4g} m; take smaller ones"
        )
    shape: Shape = Cylinder(radius=0.5 * size, length=length)
    for start in (-depth, length - depth):
        rod, core = (Cylinder(radius=radius, length=2.0 * depth) for radius in (borings.outer, borings.inner))
        tube = Cut(rod, core)
        shape = shape.cut(tube.moved((start, 0.0, 0.0)), name="boring")
    return shape


def shear(
    body: Lattice,
    law: CellBond,
    failure: Criterion,
    *,
    ring: float = _RING,
    width: float = _WIDTH,
    depth: float = _DEPTH,
    density: float | None = None,
    traverses: float = 60.0,
    ending: float = 0.5,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Push the core of a `punch_specimen` along x out of the ring around it, until the load has dropped.

    A smooth piston presses on x_max inside of its boring, a smooth holed plate bears x_min outside of its boring. The
    stress is the mean shear stress P / (π ring h) on the cylinder between both borings, h = height - 2 depth, and the
    strain the motion of the piston over h. Cracks run where stresses drive them: the peak is a limit load of the
    specimen and no strength of the material, and has no closed form. E is that of an elastic body of the same cells
    as stiff as the slope of the curve.

    Args:
        body: cells of a `punch_specimen`.
        law: its material.
        failure: `bd.MohrCoulomb` with a fracture energy, or another criterion with a tensile strength.
        ring: mean diameter of its borings [m].
        width: of its borings [m].
        depth: of its borings [m].
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
    borings = _Borings.of("shear", ring, width, depth)
    require_cells("shear", body, law, density)
    softening = softening_of("shear", failure, "bd.MohrCoulomb with a fracture_energy")
    plate, piston = borings.sides(body)
    lower, upper = body.particles.envelope.bounds
    height, size = float(upper[0] - lower[0]) - 2.0 * depth, float(upper[1] - lower[1])
    section = math.pi * ring * height
    compliance = _compliance(body, law, plate, piston) * section
    expected = _expected(softening)

    def sides(speed: float, begin: float) -> list[BoundaryCondition]:
        return [Fix(plate, translation="x", rotation=""), Drive(piston, vx=Ramp(0.0, speed, begin))]

    rig = Rig(
        axis=0, sign=-1.0, near=plate, far=piston, section=section, torn=section, length=height, size=size,
        expected=expected, way=compliance * expected, reach=_REACH * compliance * expected, ending=share,
        traverses=traverses, boundary=sides,
    )  # fmt: skip
    test = run_to_failure("shear", body, law, failure, rig, density=density, progress=progress)
    return replace(test, E=test.E * law.E * compliance / height)


@dataclass(frozen=True)
class _Borings:
    """Inner and outer radius of the borings [m], and their depth [m]."""

    inner: float
    outer: float
    depth: float

    @classmethod
    def of(cls, test: str, ring: object, width: object, depth: object) -> "_Borings":
        mean, wide, deep = (
            number(f"labtests.{test}", name, value, unit="m", above=0.0)
            for name, value in (("ring", ring), ("width", width), ("depth", depth))
        )
        if wide >= mean:
            raise InputError(f"labtests.{test}: width = {wide:.4g} m; give less than the ring's {mean:.4g} m")
        return cls(0.5 * (mean - wide), 0.5 * (mean + wide), deep)

    def sides(self, body: Lattice) -> tuple[Region, Region]:
        """The face x_min outside of its boring, and x_max inside.

        Raises:
            InputError: the body has no such borings.
        """
        faces = body.particles.envelope.faces
        found: list[Ints] = []
        if {"x_min", "x_max"} <= set(faces):
            for name in ("x_min", "x_max"):
                cells, radius = self._on_face(body, name)
                between = (radius > self.inner) & (radius < self.outer)
                found.append(cells[radius > self.outer] if name == "x_min" else cells[radius < self.inner])
                if between.any() or not len(found[-1]):
                    found.clear()
                    break
        if len(found) < 2:
            raise InputError(
                "labtests.shear: the body has no ring borings between diameters of"
                f" {2e3 * self.inner:.4g} and {2e3 * self.outer:.4g} mm in both ends; make it from"
                " bd.labtests.punch_specimen, and give shear the same ring, width and depth"
            )
        outside, inside = found
        return Face("x_min") & Index(outside), Face("x_max") & Index(inside)

    def _on_face(self, body: Lattice, name: str) -> tuple[Ints, np.ndarray]:
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


def _compliance(body: Lattice, law: CellBond, plate: Region, piston: Region) -> float:
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
