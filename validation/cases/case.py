"""A published fracture test as data: a body that is the same along z, its supports, and what is known of it.

What publications leave open was fixed before the runs of the scorecard, after trials of how bodies are borne: rows of
cells held by their displacement clamp a body, as they are never quite straight (a peak 1.6 times as high), and cells
crack under a line of force, where experiments have plates.

Publications give f_t and G_f, and not how concrete softens between. A straight line was tried first, in bands of 0.2,
with one packing of each beam: work of Petersson's 0.755 J, peaks of Grégoire's 1365 N and García-Álvarez' 6.05 kN,
all above what is claimed. Since then the curve is Petersson's of 1981, that of concrete; the straight line is an
option. The band was narrowed as it makes work: Petersson's beam of 566 cells takes 0.627, 0.613, 0.602 J until the
load has fallen to 0.02 of its peak, with bands of 0.2, 0.1, 0.05 and `together=0.01`; 0.596 with 0.05 and 0.002.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree

import bondem as bd
from bondem._types import Floats
from bondem.errors import InputError
from validation.cases.spared import SparedRankine

#: How cracks of concrete soften: along two lines, after Petersson (1981), or along one.
CURVES: Mapping[str, bd.Bilinear | None] = {"bilinear": bd.Bilinear(), "straight": None}
# Load at a factor of 1 [N]: nothing depends on it.
_LOAD = 1e3
# How far from its level a facet of a flat surface may lie [m], and how far from the vertical its normal.
_LEVEL, _UPRIGHT = 1e-7, 1e-6
# Points of a line whose nearest facets are under it.
_POINTS = 60


@dataclass(frozen=True)
class Line:
    """A line along z on a surface that faces up or down: a roller, the edge of a plate, a knife of a gauge.

    Attributes:
        x, y: where [m].
    """

    x: float
    y: float

    def cells(self, body: bd.Lattice) -> bd.Index:
        """The elements under the line: those nearest to points along it, one row of cells across the body.

        Raises:
            InputError: no such surface there.
        """
        assert body.cells is not None
        free = body.cells.free
        flat = (np.abs(np.abs(free.normal[:, 1]) - 1.0) < _UPRIGHT) & (np.abs(free.centroid[:, 1] - self.y) < _LEVEL)
        level = np.flatnonzero(flat)
        if not level.size:
            raise InputError(f"nothing faces up or down at {self}; look at the shape of the case")
        lower, upper = body.particles.envelope.bounds
        z = lower[2] + (upper[2] - lower[2]) * (np.arange(_POINTS) + 0.5) / _POINTS
        along = np.column_stack([np.full(_POINTS, self.x), z])
        nearest = KDTree(free.centroid[level][:, [0, 2]]).query(along)[1]
        return bd.Index(np.unique(free.cell[level[nearest]]))

    def load(self, body: bd.Lattice, force: float) -> bd.Load:
        """A force along y [N] on the cells under the line, through the middle of the line exactly.

        It leaves them free to turn: a row of cells is never quite straight, and would clamp the body if it was held.
        """
        cells = self.cells(body)
        lower, upper = body.particles.envelope.bounds
        off = np.array([self.x, self.y, 0.5 * (lower[2] + upper[2])]) - cells.anchor(body)
        return bd.Load(cells, force=(0.0, force, 0.0), moment=(-off[2] * force, 0.0, off[0] * force))


@dataclass(frozen=True)
class Claim:
    """What a run is held against.

    Attributes:
        quantity: "peak" [N], or "work" with its tail [J].
        low, high: between which it is to be.
        words: where they come from, for tables.
    """

    quantity: str
    low: float
    high: float
    words: str

    def verdict(self, values: list[float]) -> str:
        """Return "met" where all values are within, "met by the mean" where that is, else "missed"."""
        if all(self.low <= value <= self.high for value in values):
            return "met"
        return "met by the mean" if self.low <= float(np.mean(values)) <= self.high else "missed"


@dataclass(frozen=True)
class Case:
    """A test to failure, in plane geometry, of a body with a thickness along z.

    Attributes:
        name: of the case, as commands have it.
        title: for tables and figures.
        E, nu: of the material [Pa, -].
        rho: density [kg/m³]; of no account without inertia and weight.
        tension: strength by `bd.Rankine` [Pa].
        fracture_energy: [J/m²].
        shape: of the body.
        about: where the crack is expected, with the places of rollers: cells are fine there.
        fine, coarse: sizes of cells at `finer=1` [m].
        path: the part of the body that a picture of the crack shows, x and y from, to [m].
        driven: the line that is pushed, and whether up (1) or down (-1).
        claim: what is published of it.
        held: two rollers that bear it, or none.
        clamped: faces that are held entirely.
        spared: lines about which nothing fails, and how far [m].
        mouth: knives of the gauge of the crack mouth, if there is one.
        curve: published load over displacement of the driven line, from the rollers [m, N].
        ripple, together, until: of `bd.solve_quasistatic`.
    """

    name: str
    title: str
    E: float
    nu: float
    rho: float
    tension: float
    fracture_energy: float
    shape: bd.Shape
    about: bd.Shape
    fine: float
    coarse: float
    path: tuple[float, float, float, float]
    driven: tuple[Line, int]
    claim: Claim
    held: tuple[Line, ...] = ()
    clamped: tuple[str, ...] = ()
    spared: tuple[tuple[Line, float], ...] = ()
    mouth: tuple[Line, Line] | None = None
    curve: tuple[tuple[float, float], ...] = ()
    ripple: float = 0.05
    together: float = 0.01
    until: float = 0.2

    def body(self, seed: int, finer: float = 1.0) -> bd.Lattice:
        """Cells, fine where the crack is expected; `finer` is how many times smaller they are."""
        size = bd.Graded(fine=self.fine / finer, coarse=self.coarse / finer, about=self.about, growth=0.3)
        return bd.connect(bd.pack(self.shape, size=size, method="even", seed=seed), method="laguerre")

    def model(self, body: bd.Lattice, curve: str = "bilinear") -> tuple[bd.Model, bd.Index]:
        """The test on a body, and the elements that are pushed; rollers are forces in balance, and nothing rubs.

        Args:
            body: cells.
            curve: how cracks soften (`CURVES`).
        """
        line, way = self.driven
        boundary: list[bd.BoundaryCondition] = [bd.Fix(bd.Face(name)) for name in self.clamped]
        boundary.append(line.load(body, way * _LOAD))
        if self.held:
            first, second = self.held
            share = (second.x - line.x) / (second.x - first.x)
            boundary += [one.load(body, -way * part * _LOAD) for one, part in ((first, share), (second, 1.0 - share))]
        lines = tuple((one.x, one.y, reach) for one, reach in self.spared)
        failure = SparedRankine(
            tension=self.tension, fracture_energy=self.fracture_energy, curve=CURVES[curve], lines=lines
        )
        model = bd.Model(body, bd.CellBond(E=self.E, nu=self.nu), self.rho, failure=failure, boundary=boundary)
        return model, line.cells(body)

    def gauges(self, body: bd.Lattice) -> dict[str, tuple[bd.Index, bd.Index]]:
        """What is measured: how far the pushed line is from each roller, and the mouth of the crack."""
        pushed = self.driven[0].cells(body)
        gauges = {f"roller {k}": (one.cells(body), pushed) for k, one in enumerate(self.held)}
        if self.mouth is not None:
            gauges["CMOD"] = self.mouth[0].cells(body), self.mouth[1].cells(body)
        return gauges

    def way(self, path: bd.QuasistaticResult) -> Floats:
        """How far the pushed line has gone at each event, from the rollers where there are any [m], (e,)."""
        if not self.held:
            return path.displacement
        moved = [path.gauge[f"roller {k}"][:, 1] for k in range(len(self.held))]
        return self.driven[1] * np.mean(moved, axis=0)
