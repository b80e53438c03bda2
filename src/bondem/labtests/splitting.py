"""Brazilian test: tensile strength of a cylinder or disc that is compressed across a diameter."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import number
from bondem._drawing import Plotted
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.conditions import BoundaryCondition, Drive, Fix
from bondem.boundary.gauges import StrainGauge
from bondem.boundary.schedules import Ramp
from bondem.damage.cohesive_softening import Softening
from bondem.damage.failure_assignment import FailureAssignment
from bondem.errors import InputError
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.labtests.cracking import Cracking
from bondem.labtests.quasi_static_rig import (
    DENSITY,
    Rig,
    StrengthTest,
    check_traverses,
    require_cells,
    run_to_failure,
    softenings_of,
)
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_stress import cell_stress
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant
from bondem.specimen.regions import Face, Index, Region
from bondem.statics.static import solve_static

# Half the angle of the strips of a plain cylinder [rad], and at least so many mean edges of cells for half of one.
_STRIP, _CELLS = math.radians(5.0), 0.75
_WIDEST = math.radians(20.0)
# Stress and strain at the centre are read within these shares of the radius.
_CENTRE, _GAUGE = 0.25, 0.5
# The motion at which a test ends at the latest, over that of the expected peak.
_REACH = 4.0


@dataclass(frozen=True, eq=False)
class BrazilianTest(Plotted):
    """Result of a Brazilian test.

    Attributes:
        test: result of the test to failure. Its curve is 2 P / (π D t) over the approach of the platens over D, and
            its work is that of the platens per area D t.
        centre: elastic stress across the loaded diameter at the centre over 2 P / (π D t) [-], to compare with
            `factor`.
        factor: theoretical value of `centre`, for platens that press on flats or strips [-].
        half_angle: half the angle of the flats or strips seen from the axis [rad].
    """

    test: StrengthTest
    centre: float
    factor: float
    half_angle: float

    @property
    def peak(self) -> float:
        """Brazilian strength 2 P / (π D t) [Pa], which assumes a line load."""
        return self.test.peak

    @property
    def tension(self) -> float:
        """Elastic tensile stress at the centre at the peak, factor · 2 P / (π D t) [Pa]."""
        return self.factor * self.test.peak

    @property
    def E(self) -> float:
        """Young's modulus from the strains of the middle [Pa], with the ν of the law."""
        return self.test.E

    @property
    def curve(self) -> Floats:
        """Approach of the platens over the diameter [-] and 2 P / (π D t) [Pa], (k, 2)."""
        return self.test.curve

    @property
    def table(self) -> dict[str, Floats]:
        """Curve, with time and energies of its records, by name and unit, (k,) each."""
        return self.test.table

    @property
    def work(self) -> float:
        """Work of the platens until the end, per area D t of the section [J/m²]."""
        return self.test.work

    @property
    def cracking(self) -> Cracking:
        """Cracks and pieces, and the energy that they took."""
        return self.test.cracking

    @property
    def state(self) -> State:
        """State of the broken specimen."""
        return self.test.state


@staged("brazilian")
def brazilian(
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    half_angle: float | None = None,
    platen_friction: float = 0.0,
    density: float | Material | None = None,
    traverses: float = 100.0,
    ending: float = 0.9,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> BrazilianTest:
    """Compress a cylinder along x across a diameter along y between rigid platens, until the load has dropped.

    The platens of a plain `bd.Cylinder` constrain the free facets in two strips of its side along y only. The stress
    across the diameter at the centre is then below that of a line load. The factor is the mean of cos β (1 - 4 sin²
    β) over the pressure under a smooth rigid stamp, ∝ 1 / √(sin² α - sin² β): 0.983 at α = 5°, 0.932 at 10°. It
    superposes chords after Timoshenko and Goodier §41; a uniform pressure (Hondros 1959) would give 0.989 and 0.955.
    For a disc whose shape has flats "top" and "bottom", the platens constrain the flats, and the factor is that of
    Wang et al. (2004), 0.960 at 10°.

    `.peak` is 2 P / (π D t) without the factor, `.tension` includes it. E follows from Hooke's law and the strains
    within half the radius, where the mean of σ_yy + σ_zz equals its value at the centre, -4 P / (π D t).

    Args:
        body: cells of a cylinder along x, or of one with flats "top" and "bottom" across y.
        law: cell law, or cell laws by region; the first one is the matrix and sets the loading rate.
        failure: criterion with a tensile strength, `bd.MohrCoulomb` with a fracture energy, or criteria by region.
        half_angle: half angle α of the strips [rad]; None for 5°, or for three quarters of a cell if larger.
        platen_friction: coefficient of friction between platens and disc [-]; 0 for smooth platens, for which the
            factor holds.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it.
        traverses: number of passes of sound along the diameter before the expected peak [-]; more is slower.
        ending: share of the peak load at which the test ends [-]: the disc has split. With a lower share, `peak` may
            be that of the two halves, which can carry a higher load afterwards.
        out: run file (HDF5) with checkpoints and snapshots, from which the same call continues a test that was
            killed or interrupted, and evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: another shape, a lattice without cells, or a criterion that this stress never reaches.
        UnstableRunError: the run became unstable.
        RunInterrupted: Ctrl-C was pressed; its `.result` is that of the curve so far.

    Reference: ISRM, Int. J. Rock Mech. Min. Sci. 15 (1978) 99–103; Wang et al., ibid. 41 (2004) 245–253.
    """
    density = constant("density", density)
    owner = "labtests.brazilian"
    check_traverses("brazilian", traverses)
    share = number(owner, "ending", ending, least=0.0, below=1.0)
    rough = number(owner, "platen_friction", platen_friction, least=0.0) or None
    matrix = require_cells("brazilian", body, law, density)
    found = softenings_of("brazilian", body, failure, "bd.Rankine, or bd.MohrCoulomb with a fracture_energy")
    strengths = [strength for strength in map(splitting_strength, found) if math.isfinite(strength)]
    expected = min(strengths, default=math.inf)
    if not math.isfinite(expected):
        raise InputError(
            f"{owner}: failure = {failure}: no load reaches it; give a criterion with a tensile strength"
        )
    jaws = _Jaws.of(body, half_angle)
    way, centre = _elastic(body, law, jaws)
    reach = _REACH * way * strengths[0]
    way *= expected

    def platens(speed: float, begin: float) -> list[BoundaryCondition]:
        pairs = (jaws.top, 0.5 * speed), (jaws.bottom, -0.5 * speed)
        return [Drive(jaw, vy=Ramp(0.0, each, begin), friction=rough) for jaw, each in pairs]

    rig = Rig(
        axis=1, sign=-1.0, near=jaws.bottom, far=jaws.top, section=0.5 * math.pi * jaws.diameter * jaws.thickness,
        torn=jaws.diameter * jaws.thickness, length=jaws.diameter, size=jaws.diameter, expected=expected, way=way,
        reach=reach, ending=share, traverses=traverses, boundary=platens, gauge=StrainGauge(_middle(body, jaws)),
        strain=_strained(matrix.nu),
    )  # fmt: skip
    test = run_to_failure("brazilian", body, law, failure, rig, density=density, out=out, progress=progress)
    return BrazilianTest(test=test, centre=centre, factor=jaws.factor, half_angle=jaws.half_angle)


def splitting_strength(softening: Softening) -> float:
    """Stress s at which the stress (0, -3 s, s) of the centre of a disc reaches a criterion [Pa]; inf if never.

    The result is the tensile strength or less: under Mohr–Coulomb cells yield there at c cos φ / (2 - sin φ).
    """
    found = softening.tension
    if softening.surface is not None:
        found = float(softening.surface.reached(np.diag([0.0, -3.0, 1.0])[None])[0])
    slip = softening.slip
    if slip is not None:
        # √J2 = √(13/3) s and I1 = -2 s; (σ1 - σ3)/2 = 2 s and (σ1 + σ3)/2 = -s
        size, mean = (math.sqrt(13.0 / 3.0), -2.0) if slip.cone else (2.0, -1.0)
        bears = size + mean * slip.slope
        found = min(found, slip.strength / bears if bears > 0.0 else math.inf)
    return found


def stamped(half_angle: float) -> float:
    """Stress at the centre over 2 P / (π D t) [-] under smooth rigid stamps on strips of half angle α [rad]."""
    angle = math.pi * (np.arange(64) + 0.5) / 64
    sine = math.sin(half_angle) * np.cos(angle)
    return float((np.sqrt(1.0 - sine**2) * (1.0 - 4.0 * sine**2)).mean())


def flattened(half_angle: float) -> float:
    """Stress at the centre over 2 P / (π D t) [-] for flats of half angle α [rad], after Wang et al. (2004)."""
    c, s = math.cos(half_angle), math.sin(half_angle) / half_angle
    return (2.0 * c**3 + c + s) ** 2 / (8.0 * (c + s)) / s


@dataclass(frozen=True, eq=False)
class _Jaws:
    """Areas on which the platens press."""

    top: Region
    bottom: Region
    diameter: float
    thickness: float
    middle: Floats
    half_angle: float
    factor: float

    @classmethod
    def of(cls, body: Lattice, half_angle: float | None) -> "_Jaws":
        """Flats of the shape, or strips of the side of a cylinder.

        Raises:
            InputError: neither exists, or an angle is out of range.
        """
        shape = body.particles.envelope
        lower, upper = shape.bounds
        length, height, diameter = (float(extent) for extent in upper - lower)
        middle, radius = 0.5 * (lower + upper), 0.5 * diameter
        assert body.cells is not None
        if not shape.contains(middle).all():
            raise InputError(
                "labtests.brazilian: the disc has a hole at its centre, where its strength and strains are evaluated;"
                " use a solid disc, or drive a bd.Model of this one with bd.solve_explicit"
            )
        if {"top", "bottom"} <= set(shape.faces):
            if half_angle is not None:
                raise InputError(
                    "labtests.brazilian: half_angle is an option of plain cylinders; leave it out for a disc with"
                    " flats"
                )
            on = body.on_face("top")
            flat = float(np.average(body.cells.free.centroid[on, 1], weights=body.cells.free.area[on])) - middle[1]
            angle = math.acos(min(flat / radius, 1.0 - 1e-6))
            return cls(Face("top"), Face("bottom"), diameter, length, middle, angle, flattened(angle))
        if not {"side", "x_min", "x_max"} <= set(shape.faces) or abs(height - diameter) > 1e-6 * diameter:
            raise InputError(
                f"labtests.brazilian: {type(shape).__name__} is not a cylinder along x; use bd.Cylinder, or one whose"
                ' flats across y are the faces "top" and "bottom"'
            )
        edge = float(np.mean(body.cells.volume)) ** (1.0 / 3.0)
        if half_angle is None:
            half_angle = max(_STRIP, math.asin(min(_CELLS * edge / radius, 1.0)))
        advice = f"half an angle in (0, {_WIDEST:.3g}) rad; finer cells allow for narrow strips"
        angle = number("labtests.brazilian", "half_angle", half_angle, above=0.0, below=_WIDEST, advice=advice)
        top, bottom = (_strip(body, middle, sign, angle) for sign in (1.0, -1.0))
        return cls(top, bottom, diameter, length, middle, angle, stamped(angle))


def _strip(body: Lattice, middle: Floats, sign: float, half_angle: float) -> Region:
    """Cells of the side whose mean facet position is within an angle from ±y."""
    assert body.cells is not None
    free, on = body.cells.free, body.on_face("side")
    cell, area, count = free.cell[on], free.area[on], len(body.particles)
    total = np.bincount(cell, weights=area, minlength=count)
    y, z = (
        np.bincount(cell, weights=area * (free.centroid[on, axis] - middle[axis]), minlength=count) for axis in (1, 2)
    )
    chosen = (total > 0.0) & (np.abs(np.arctan2(z, sign * y)) < half_angle)
    if not chosen.any():
        raise InputError(
            f"labtests.brazilian: half_angle = {half_angle:.3g} rad contains no cell; give a larger"
            " half_angle or finer cells"
        )
    return Face("side") & Index(np.flatnonzero(chosen))


def _elastic(body: Lattice, law: CellAssignment, jaws: _Jaws) -> tuple[float, float]:
    """Approach of the platens over 2 P / (π D t) [m/Pa], and the stress at the centre over 2 P / (π D t) [-]."""
    closing = 1e-6 * jaws.diameter
    position = body.particles.position - jaws.middle
    # the platens leave motion along x and z and turning about y free, and nothing resists where that is held
    inmost = Index([int(np.argmin(np.linalg.norm(position, axis=1)))])
    boundary = [
        Drive(jaws.top, y=-0.5 * closing), Drive(jaws.bottom, y=0.5 * closing),
        Fix(inmost, translation="xz", rotation="y"),
    ]  # fmt: skip
    model = Model(body, law, DENSITY, boundary=boundary)
    static = solve_static(model)
    pressed = [float(static.reaction[jaw.select(body), 1].sum()) for jaw in (jaws.bottom, jaws.top)]
    stress = (pressed[0] - pressed[1]) / (math.pi * jaws.diameter * jaws.thickness)
    near = np.hypot(position[:, 1], position[:, 2]) < _CENTRE * 0.5 * jaws.diameter
    assert body.cells is not None
    weight = np.sqrt(body.cells.volume[near])[:, None]
    y, z = position[near, 1], position[near, 2]
    across = cell_stress(model, static)[near, 2, 2]
    columns = np.column_stack([np.ones(len(y)), y**2, z**2])
    centre = np.linalg.lstsq(weight * columns, weight[:, 0] * across, rcond=None)[0][0]
    return closing / stress, float(centre) / stress


def _middle(body: Lattice, jaws: _Jaws) -> Region:
    """Cells within half the radius."""
    position = body.centre - jaws.middle
    return Index(np.flatnonzero(np.hypot(position[:, 1], position[:, 2]) < _GAUGE * 0.5 * jaws.diameter))


def _strained(nu: float) -> Callable[[Floats], Floats]:
    """Return the strain measure of the normal strains in the middle; E times it is 2 P / (π D t)."""

    def measure(strains: Floats) -> Floats:
        volume = nu / ((1.0 + nu) * (1.0 - 2.0 * nu)) * strains.sum(axis=1)
        return -(volume + 0.5 * (strains[:, 1] + strains[:, 2]) / (1.0 + nu))

    return measure
