"""Brazilian test: tensile strength of a cylinder or disc that is compressed across a diameter."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import number
from bondem._names import warn_user
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.conditions import Drive, Fix
from bondem.boundary.gauges import Gauge, StrainGauge
from bondem.boundary.schedules import Ramp
from bondem.damage.cohesive_softening import Softening
from bondem.damage.failure_assignment import FailureAssignment
from bondem.errors import InputError, StrengthWarning
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.bonded_platens import BondedSpecimen, as_cells, is_cells
from bondem.labtests.bonded_splitting import split_bonded
from bondem.labtests.disc import WIDEST, Disc, centre_stress, flattened, middle_of_disc, require_disc, stamped
from bondem.labtests.faces import means_on_face
from bondem.labtests.one_test import OfOneTest
from bondem.labtests.quasi_static_rig import DENSITY, Rig, RunOptions, require_cells, run_to_failure, softenings_of
from bondem.model.model import Model
from bondem.observables.cell_stress import cell_stress
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material
from bondem.specimen.regions import Face, Index, Region
from bondem.statics.static import solve_static

# Half angle of the strips of a plain cylinder [rad], and lower limit of half their width in mean edges of cells.
_STRIP, _CELLS = math.radians(5.0), 0.75
# Limit of the motion of a test, over that at the expected peak.
_REACH = 4.0


@dataclass(frozen=True, eq=False)
class BrazilianTest(OfOneTest):
    """Result of a Brazilian test.

    Attributes:
        test: result of the test to failure. Its curve has the approach of the platens over D [-] and 2 P / (π D t)
            [Pa]. The peak is the Brazilian strength, which assumes a line load. E follows from the strains of the
            middle, for cells with the ν of the law. The work is that of the platens per area D t.
        centre: elastic stress across the loaded diameter at the centre over 2 P / (π D t) [-], to compare with
            `factor`; NaN for the non-local law.
        factor: theoretical value of `centre`, for platens that press on flats or strips [-].
        half_angle: half the angle of the flats or strips seen from the axis [rad].
    """

    centre: float
    factor: float
    half_angle: float

    @property
    def tension(self) -> float:
        """Elastic tensile stress at the centre at the peak, factor · 2 P / (π D t) [Pa]."""
        return self.factor * self.peak


@staged("brazilian")
def brazilian(
    body: Lattice,
    law: AnyLaw,
    failure: FailureAssignment,
    *,
    half_angle: float | None = None,
    platen_friction: float = 0.0,
    density: float | Material | None = None,
    contact: ContactLaw | None = None,
    traverses: float | None = None,
    ending: float | None = None,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> BrazilianTest:
    """Compress a cylinder along x across a diameter along y between rigid platens, until the load has dropped.

    On a plain `bd.Cylinder` the platens constrain the free facets in two strips of the side, only along y. The stress
    across the diameter at the centre is then below that of a line load, by a factor of 0.983 at α = 5° and 0.933 at
    10°. The factor is the mean of cos β (1 - 4 sin² β) over the pressure ∝ 1 / √(sin² α - sin² β) under a smooth
    rigid stamp. This superposes chords after Timoshenko and Goodier §41; a uniform traction along y would give 0.989
    and 0.955.

    For a disc whose shape has flats "top" and "bottom", the platens constrain the flats, and the factor is that of
    Wang et al. (2004), 0.960 at 10°.

    Strips of bonded spheres are as deep as a mean radius. Planes press the flats of a disc. Flats with a half angle
    below 15° may lose single spheres before the disc splits.

    `.peak` is 2 P / (π D t) without the factor, `.tension` includes it. E follows from Hooke's law and the strains
    within half the radius. There the mean of σ_yy + σ_zz equals its value at the centre, -4 P / (π D t). With the ν
    of a cell law E is valid for discs of any thickness. E of bonded spheres assumes a disc without axial stress, as
    -4 P / (π D t) over ε_yy + ε_zz - ε_xx; in the middle of a long cylinder it is up to 1/((1 + ν)(1 - 2ν)) times E.

    Args:
        body: cells or bonded spheres of a cylinder along x, or of one with flats "top" and "bottom" across y.
        law: cell law, bond law, or laws by region, or the non-local law; of cells the first one is the matrix.
        failure: for cells a criterion with a tensile strength, or `bd.MohrCoulomb` with a fracture energy; for
            bonded spheres a criterion of bonds such as `bd.PeripheralStress`; or criteria by region.
        half_angle: half angle α of the strips [rad]; None for 5° (10° for bonded spheres), or for a half width of
            three quarters of a cell (one and a half mean radii) if this is larger.
        platen_friction: coefficient of friction between platens and disc [-]; 0 for smooth platens, for which the
            factor holds. Strips of bonded spheres are smooth.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it. None for 2000.
        contact: contact law of fragments and platens, for bonded spheres; None for the stiffness of the median bond
            and a friction of 0.4 between fragments.
        traverses: number of passes of sound along the diameter before the expected peak [-]; more is slower. None for
            100; bonded spheres have 50, and 100 or 200 if the forces of both platens do not balance.
        ending: share of the peak load at which the test ends [-], as the disc has split. With a lower share, `peak`
            may be that of the two halves, which can carry a higher load afterwards. None for 0.9, or 0.7 for bonded
            spheres, where single ones break off at the platens before the peak.
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: another shape, no criterion, a criterion that this stress never reaches, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Warns:
        NotQuasistaticWarning: `.test.unbalance` is above 0.02 for bonded spheres; for cells as in `solve_explicit`.
        StrengthWarning: the load of bonded spheres still rises at the limit of the motion, or cells yield in shear
            and the disc does not split.

    Reference: ISRM, Int. J. Rock Mech. Min. Sci. 15 (1978) 99–103; Wang et al., ibid. 41 (2004) 245–253.
    """
    owner, options = "labtests.brazilian", RunOptions.of(density, traverses, out, progress)
    options.check_traverses("brazilian")
    share = None if ending is None else number(owner, "ending", ending, least=0.0, below=1.0)
    rough = number(owner, "platen_friction", platen_friction, least=0.0) or None
    if not is_cells(body, law):
        rho = options.density
        specimen = BondedSpecimen.of("brazilian", body, law, failure, density=rho, contact=contact)
        test, centre, factor, angle = split_bonded(
            specimen, half_angle=half_angle, friction=rough or 0.0, ending=share, options=options
        )
        return BrazilianTest(test=test, centre=centre, factor=factor, half_angle=angle)
    law = as_cells("brazilian", law, contact)
    matrix = require_cells("brazilian", body, law, options.density)
    found = softenings_of("brazilian", body, failure, "bd.Rankine, or bd.MohrCoulomb with a fracture_energy")
    strengths = [strength for strength in map(splitting_strength, found) if math.isfinite(strength)]
    expected = min(strengths, default=math.inf)
    if not math.isfinite(expected):
        raise InputError(
            f"{owner}: failure = {failure}: no load reaches it; give a criterion with a tensile strength"
        )
    jaws = _Jaws.of(body, half_angle)
    disc = jaws.disc
    way, centre = _elastic(body, law, jaws)
    reach = _REACH * way * strengths[0]
    way *= expected

    def pressed(speed: float, begin: float) -> Model:
        pairs = (jaws.top, 0.5 * speed), (jaws.bottom, -0.5 * speed)
        platens = [Drive(jaw, vy=Ramp(0.0, each, begin), friction=rough) for jaw, each in pairs]
        return Model(body, law, options.density, failure=failure, boundary=platens)

    near, far = (Gauge(jaw, "force") for jaw in (jaws.bottom, jaws.top))
    rig = Rig(
        axis=1, sign=-1.0, near=(near,), far=(far,), section=0.5 * math.pi * disc.diameter * disc.thickness,
        torn=disc.diameter * disc.thickness, length=disc.diameter, size=disc.diameter, expected=expected, way=way,
        reach=reach, ending=0.9 if share is None else share, traverses=traverses or 100.0, model=pressed,
        gauge=StrainGauge(middle_of_disc(body, disc)), strain=_strained(matrix.nu),
    )  # fmt: skip
    test = run_to_failure("brazilian", body, law, failure, rig, options)
    if test.cracking.pieces == 1 and test.cracking.slipped > test.cracking.dissipated:
        warn_user(
            f"{owner}: the peak of {test.peak:.4g} Pa is no splitting strength: the disc yields in shear and does not"
            " split; give a larger cohesion in failure=",
            StrengthWarning,
        )
    return BrazilianTest(test=test, centre=centre, factor=jaws.factor, half_angle=jaws.half_angle)


def splitting_strength(softening: Softening) -> float:
    """Return the stress s at which the principal stresses (0, -3 s, s) reach a criterion [Pa]; inf if they never do.

    This is the stress state at the centre of a disc. The result is at most the tensile strength; cells with
    Mohr–Coulomb yield at c cos φ / (2 - sin φ).
    """
    found = softening.tension
    if softening.surface is not None:
        found = float(softening.surface.reached(np.diag([0.0, -3.0, 1.0])[None])[0])
    for slip in softening.slips:
        # √J2 = √(13/3) s and I1 = -2 s; (σ1 - σ3)/2 = 2 s and (σ1 + σ3)/2 = -s
        size, mean = (math.sqrt(13.0 / 3.0), -2.0) if slip.cone else (2.0, -1.0)
        bears = size + mean * slip.slope
        found = min(found, slip.strength / bears if bears > 0.0 else math.inf)
    return found


@dataclass(frozen=True, eq=False)
class _Jaws:
    """Regions of a disc on which the platens press, half angle [rad], and theoretical `BrazilianTest.centre` [-]."""

    top: Region
    bottom: Region
    disc: Disc
    half_angle: float
    factor: float

    @classmethod
    def of(cls, body: Lattice, half_angle: float | None) -> "_Jaws":
        """Select the flats of a disc, or two strips of the side of a cylinder of a half angle [rad].

        Raises:
            InputError: the body is not such a disc, or the angle is out of range.
        """
        disc = require_disc(body)
        disc.refuse_angle(half_angle)
        if disc.flat is not None:
            return cls(Face("top"), Face("bottom"), disc, disc.flat, flattened(disc.flat))
        if half_angle is None:
            half_angle = max(_STRIP, math.asin(min(_CELLS * body.elements.size / (0.5 * disc.diameter), 1.0)))
        advice = f"half an angle in (0, {WIDEST:.3g}) rad; finer cells allow for narrow strips"
        angle = number("labtests.brazilian", "half_angle", half_angle, above=0.0, below=WIDEST, advice=advice)
        top, bottom = (_strip(body, disc.middle, sign, angle) for sign in (1.0, -1.0))
        return cls(top, bottom, disc, angle, stamped(angle))


def _strip(body: Lattice, middle: Floats, sign: float, half_angle: float) -> Region:
    """Select the cells of the side whose mean facet position is within a half angle [rad] of sign · y."""
    cells, y = means_on_face(body, "side", lambda place: place[:, 1] - middle[1])
    _, z = means_on_face(body, "side", lambda place: place[:, 2] - middle[2])
    chosen = cells[np.abs(np.arctan2(z, sign * y)) < half_angle]
    if not chosen.size:
        raise InputError(
            f"labtests.brazilian: half_angle = {half_angle:.3g} rad contains no cell; give a larger"
            " half_angle or finer cells"
        )
    return Face("side") & Index(chosen)


def _elastic(body: Lattice, law: CellAssignment, jaws: _Jaws) -> tuple[float, float]:
    """Solve the elastic problem for approach of the platens [m/Pa] and centre stress [-], both over 2 P / (π D t)."""
    closing = 1e-6 * jaws.disc.diameter
    position = body.particles.position - jaws.disc.middle
    # the platens leave rigid motion along x and z and about y free; fixing it at one cell needs no reaction
    inmost = Index([int(np.argmin(np.linalg.norm(position, axis=1)))])
    boundary = [
        Drive(jaws.top, y=-0.5 * closing), Drive(jaws.bottom, y=0.5 * closing),
        Fix(inmost, translation="xz", rotation="y"),
    ]  # fmt: skip
    model = Model(body, law, DENSITY, boundary=boundary)
    static = solve_static(model)
    pressed = [float(static.reaction[jaw.select(body), 1].sum()) for jaw in (jaws.bottom, jaws.top)]
    stress = (pressed[0] - pressed[1]) / (math.pi * jaws.disc.diameter * jaws.disc.thickness)
    across = cell_stress(model, static)[:, 2, 2]
    return closing / stress, centre_stress(position, body.element_volume, across, jaws.disc) / stress


def _strained(nu: float) -> Callable[[Floats], Floats]:
    """Return a function of the normal strains in the middle, (k, 3), whose value times E is 2 P / (π D t)."""

    def measure(strains: Floats) -> Floats:
        volume = nu / ((1.0 + nu) * (1.0 - 2.0 * nu)) * strains.sum(axis=1)
        return -(volume + 0.5 * (strains[:, 1] + strains[:, 2]) / (1.0 + nu))

    return measure
