"""Bars whose strengths scatter after Weibull, pulled apart without inertia, as rows of a study."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bondem.boundary.conditions import Drive, Fix
from bondem.damage.criteria.rankine import Rankine
from bondem.damage.scatter import Weibull
from bondem.geometry.elementary_shapes import Box
from bondem.interactions.cells.cell_bond import CellBond
from bondem.model.model import Model
from bondem.packing import EVEN, pack
from bondem.specimen.bonding import connect
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face
from bondem.statics.quasistatic.quasistatic_run import solve_quasistatic
from validation.frame.files import plain
from validation.frame.request import Request

# Packings of a bar; fields of strengths take them in turn.
_PACKINGS = 3
# Load over its peak at which a run ends, and load factors that count as one.
_UNTIL, _TOGETHER = 0.7, 0.01
# How far the bar is pulled at a load factor of 1 [m]: nothing depends on it.
_WAY = 1e-6


@dataclass(frozen=True)
class Ceramic:
    """Brittle, with strengths after Weibull.

    Attributes:
        E, nu, rho: alumina's [Pa, -, kg/m³].
        tension: s₀, what a volume V₀ survives with probability 1/e [Pa].
        volume: V₀ [m³].
        modulus: m [-].
        correlation: length of the field of strengths [m].
    """

    E: float = 380e9
    nu: float = 0.22
    rho: float = 3900.0
    tension: float = 300e6
    volume: float = 1e-6
    modulus: float = 10.0
    correlation: float = 6e-3


@dataclass(frozen=True)
class WeibullRun(Request):
    """A bar twice as long as wide, and a field of strengths.

    Attributes:
        ceramic: what it is of.
        bar: its volume [m³].
        size: of its cells [m].
        correlated: whether strengths are a field, or know nothing of each other.
        seed: of the strengths.
    """

    ceramic: Ceramic
    bar: float
    size: float
    correlated: bool
    seed: int

    @property
    def readable(self) -> str:
        """See `Request`."""
        kind = "field" if self.correlated else "alone"
        return f"weibull_{1e9 * self.bar:.0f}mm3_cells{1e6 * self.size:.0f}um_{kind}_seed{self.seed}"

    @property
    def weight(self) -> float:
        """See `Request`."""
        return self.bar / self.size**3

    @property
    def asked(self) -> dict[str, Any]:
        """See `Request`."""
        return {
            "bar": self.bar, "size": self.size, "correlated": self.correlated, "seed": self.seed,
            "count": round(self.bar / self.size**3), "spread": 0.0,
        }  # fmt: skip

    @property
    def width(self) -> float:
        """Edge of its section [m]."""
        return float((0.5 * self.bar) ** (1.0 / 3.0))

    def body(self) -> Lattice:
        """Its cells."""
        shape = Box((2.0 * self.width, self.width, self.width))
        packed = pack(shape, count=self.asked["count"], method=EVEN, seed=1 + self.seed % _PACKINGS)
        return connect(packed, method="laguerre")

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: SI units."""
        ceramic, body = self.ceramic, self.body()
        length = ceramic.correlation if self.correlated else None
        scatter = Weibull(modulus=ceramic.modulus, volume=ceramic.volume, seed=self.seed, correlation=length)
        ends = [Fix(Face("x_min"), translation="x", rotation=""), Drive(Face("x_max"), x=_WAY)]
        law = CellBond(E=ceramic.E, nu=ceramic.nu)
        failure = Rankine(tension=ceramic.tension, scatter=scatter)
        model = Model(body, law, ceramic.rho, failure=failure, boundary=ends)
        path = solve_quasistatic(model, Face("x_max"), together=_TOGETHER, until=_UNTIL)
        section = self.width**2
        return plain({
            "strength": path.peak / section, "first": path.load[0] / section, "events": len(path.load),
            "end": path.end,
        })  # fmt: skip
