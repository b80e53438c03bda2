"""Three-point bending: the flexural strength of a beam, plain or notched, and the work it takes to break it."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from bondem._checks import number
from bondem._drawing import Plotted
from bondem._progress import staged
from bondem._types import Floats
from bondem.errors import InputError
from bondem.labtests.probing import walls_along
from bondem.labtests.rig import DENSITY, require_cells, softening_of
from bondem.laws.failure.criterion import Criterion
from bondem.laws.failure.rankine import Rankine
from bondem.model.boundary import Load
from bondem.model.cell_constants import CellAssignment
from bondem.model.failure_assignment import FailureAssignment
from bondem.model.model import Model
from bondem.model.state import State
from bondem.quasistatic.solve import QuasistaticResult, solve_quasistatic
from bondem.specimen.geometry import Box
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face, Index, Region, Within

# Load at a factor of 1 [N]: nothing depends on it.
_LOAD = 1e3
# Width of the strips that bear, over the depth of the beam, and at least so many mean edges of cells.
_STRIP, _CELLS = 0.1, 1.5


@dataclass(frozen=True, eq=False)
class BendingTest(Plotted):
    """Result of a bending test, as a path of events without inertia.

    Attributes:
        peak: flexural strength 3 P L / (2 b h²) [Pa], h the ligament above the notch, or the whole depth.
        E: Young's modulus from the deflection of a plain beam, with shear [Pa]; of a notched one the apparent,
            smaller one.
        curve: deflection over the span [-] and 3 P L / (2 b h²) of each event [Pa], from (0, 0) on, shape (k, 2).
        work: of the rollers over the ligament b h [J/m²]: what was dissipated, and what is stored in the end.
        span: L, between the supports [m].
        ligament: h [m].
        path: of all events, with loads [N] and the displacement between the rollers as gauges "left" and "right" [m].
    """

    peak: float
    E: float
    curve: Floats
    work: float
    span: float
    ligament: float
    path: QuasistaticResult

    @property
    def state(self) -> State:
        """The broken beam at its last equilibrium."""
        return self.path.state


@staged("three point bending")
def three_point_bending(
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    span: float | None = None,
    strip: float | None = None,
    ripple: float = 0.02,
    together: float = 0.005,
    until: float = 0.05,
    most: int = 100_000,
    progress: Callable[[float], None] | None = None,
) -> BendingTest:
    """Bend a beam, axis x, depth y, width z, by a roller at mid-span from above and two below, until it has failed.

    Rollers are forces, each a traction along y on a strip of the surface whose resultant passes through its line:
    they neither hold the beam along x nor clamp it. It is followed by `bd.solve_quasistatic`, also where it snaps
    back, so that there is neither density nor speed. Tension alone decides: of `bd.MohrCoulomb` its tensile strength
    and fracture energy count, and cells do not yield. The deflection is that of the middle of the section (above a
    notch, of the ligament) at mid-span against the middle of the depth over the supports, without the dents of the
    rollers. E is from P / (E b) ((L/D)³/4 + (0.6 + 0.375 ν) L/D - 0.21) (Timoshenko and Goodier §40): the shear of
    beam theory, less what the roller does near by, 4 % of the whole where L = 3 D.

    Args:
        body: cells of a box along x, plain or with a notch from below at mid-span, `shape.cut(..., name="notch")`.
        law: its material, or laws by region, the first of which, of the matrix, sets the speed of the test.
        failure: `bd.Rankine`, or `bd.MohrCoulomb` with a fracture energy; or by region.
        span: between the supports [m], about the middle; None for the length less the depth.
        strip: width of the strips that bear [m]; None for a tenth of the depth, at least one and a half cells.
        ripple, together, until, most: of `bd.solve_quasistatic`; `until` is the share of the peak at which it ends.
        progress: called now and then with the share done, 0 … 1.

    Raises:
        InputError: no such beam, a span or strip that does not fit, or another criterion.
    """
    matrix = require_cells("three_point_bending", body, law, None)
    tensile = _tensile(failure)
    beam = _Beam.of(body, span, strip)
    top, loads = beam.rollers()
    model = Model(body, law, DENSITY, failure=tensile, boundary=loads)
    path = solve_quasistatic(
        model, top, ripple=ripple, together=together, until=until, most=most, gauges=beam.gauges(),
        progress=progress,
    )  # fmt: skip
    if not len(path.factor):
        raise InputError("labtests.three_point_bending: nothing fails at any load; look at the criterion")
    stress = 1.5 * path.load * beam.span / (beam.width * beam.ligament**2)
    deflection = -0.5 * (path.gauge["middle left"] + path.gauge["middle right"])[:, 1]
    stiffness = path.load[0] / deflection[0]
    rollers = -0.5 * (path.gauge["left"] + path.gauge["right"])[:, 1]
    work = path.energy.sum() + 0.5 * path.load[-1] * rollers[-1]
    curve = np.column_stack([deflection / beam.span, stress])
    return BendingTest(
        peak=float(stress.max()), E=float(stiffness * beam.compliance(matrix.nu)),
        curve=np.vstack([np.zeros((1, 2)), curve]), work=float(work) / (beam.width * beam.ligament),
        span=beam.span, ligament=beam.ligament, path=path,
    )  # fmt: skip


def _tensile(failure: FailureAssignment) -> FailureAssignment:
    """The part of a criterion that decides in bending, or of each by region.

    Raises:
        InputError: another criterion than those of the largest principal stress.
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
        raise InputError(f"labtests.three_point_bending cracks by the largest principal stress; give {wanted}")
    return Rankine(
        tension=softening.tension, fracture_energy=softening.fracture_energy or None, curve=softening.curve,
        scatter=failure.scatter,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Beam:
    """Where a beam is borne and pressed."""

    body: Lattice
    lower: Floats
    upper: Floats
    span: float
    strip: float
    ligament: float

    @classmethod
    def of(cls, body: Lattice, span: float | None, strip: float | None) -> "_Beam":
        """From the shape of the body.

        Raises:
            InputError: it is no beam, or what is given does not fit.
        """
        owner, shape = "labtests.three_point_bending", body.particles.envelope
        if not {"x_min", "x_max", "y_min", "y_max"} <= set(shape.faces):
            raise InputError(f"{owner}: {type(shape).__name__} is no beam; take a bd.Box along x, notched or not")
        lower, upper = shape.bounds
        length, depth, _ = (float(extent) for extent in upper - lower)
        assert body.cells is not None
        edge = float(np.mean(body.cells.volume)) ** (1.0 / 3.0)
        usual = max(_STRIP * depth, _CELLS * edge)
        wide = usual if strip is None else number(owner, "strip", strip, unit="m", above=0.0)
        between = length - depth if span is None else number(owner, "span", span, unit="m", above=0.0)
        if not (between >= depth and between + wide <= length):
            raise InputError(
                f"{owner}: a span of {between:.4g} m with strips of {wide:.4g} m does not suit a beam {length:.4g} m"
                f" long and {depth:.4g} m deep; give at least the depth, and leave half a strip over each end"
            )
        return cls(body, lower, upper, between, wide, _ligament(body, lower, upper))

    @property
    def width(self) -> float:
        return float(self.upper[2] - self.lower[2])

    @property
    def middle(self) -> Floats:
        return 0.5 * (self.lower + self.upper)

    def compliance(self, nu: float) -> float:
        """E times the deflection of a plain beam over its load [1/m]: bending, shear, and about the roller."""
        slender = self.span / float(self.upper[1] - self.lower[1])
        return (0.25 * slender**3 + (0.6 + 0.375 * nu) * slender - 0.21) / self.width

    def _region(self, face: str, at: float) -> Region:
        """Cells with facets within half a strip of a line, on average."""
        assert self.body.cells is not None
        free, on = self.body.cells.free, self.body.on_face(face)
        cell, area, count = free.cell[on], free.area[on], len(self.body.particles)
        total = np.bincount(cell, weights=area, minlength=count)
        away = np.bincount(cell, weights=area * (free.centroid[on, 0] - at), minlength=count)
        chosen = np.flatnonzero((total > 0.0) & (np.abs(away) <= 0.5 * self.strip * total))
        if not chosen.size:
            raise InputError(
                f"labtests.three_point_bending: no cell lies within a strip of {self.strip:.4g} m at x = {at:.4g} m;"
                " give a wider strip, or finer cells"
            )
        return Face(face) & Index(chosen)

    def _places(self) -> dict[str, tuple[str, float, float]]:
        """Face, x and share of the load of each roller."""
        x = float(self.middle[0])
        return {
            "top": ("y_max", x, -1.0), "left": ("y_min", x - 0.5 * self.span, 0.5),
            "right": ("y_min", x + 0.5 * self.span, 0.5),
        }  # fmt: skip

    def rollers(self) -> tuple[Region, list[Load]]:
        """The strip above, and the loads of all three, each through its line."""
        loads = [self._load(*place) for place in self._places().values()]
        return loads[0].region, loads

    def _load(self, face: str, at: float, share: float) -> Load:
        region, force = self._region(face, at), share * _LOAD
        off = np.array([at, 0.0, self.middle[2]]) - region.anchor(self.body)
        moment = (-float(off[2]) * force, 0.0, float(off[0]) * force)
        return Load(region, force=(0.0, force, 0.0), moment=moment)

    def gauges(self) -> Mapping[str, tuple[Region, Region]]:
        """From each support to the roller above, and the same of the middle of the section."""
        region = {name: self._region(face, at) for name, (face, at, _) in self._places().items()}
        x, y = float(self.middle[0]), float(self.middle[1])
        inside = self._about(x, float(self.upper[1]) - 0.5 * self.ligament)
        ends = {"left": self._about(x - 0.5 * self.span, y), "right": self._about(x + 0.5 * self.span, y)}
        found: dict[str, tuple[Region, Region]] = {name: (region[name], region["top"]) for name in ends}
        return found | {f"middle {name}": (end, inside) for name, end in ends.items()}

    def _about(self, x: float, y: float) -> Region:
        """Cells about a line along z, as wide and deep as a strip."""
        size = (self.strip, self.strip, 2.0 * self.width)
        corner = (x - 0.5 * self.strip, y - 0.5 * self.strip, float(self.lower[2]) - 0.5 * self.width)
        return Within(Box(size).moved(corner))


def _ligament(body: Lattice, lower: Floats, upper: Floats) -> float:
    """Depth of the section at mid-span that is there, from above [m]: less a notch from below."""
    start = 0.5 * (lower + upper)
    end, tiny = start.copy(), 1e-9 * float(upper[1] - lower[1])
    start[1], end[1] = upper[1] - tiny, lower[1] + tiny
    inside, walls = walls_along(body.particles.envelope, start, end)
    if not inside or len(walls) > 1:
        raise InputError("labtests.three_point_bending: at mid-span there are holes; cut one notch, from below")
    return float(walls[0]) if len(walls) else float(upper[1] - lower[1])
