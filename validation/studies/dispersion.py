"""How a packing depends on the dispersion of its radii (André et al. 2012, figs 5–7)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from bondem.packing import METHODS
from bondem.specimen.fabric import LIMITS
from validation.figures.packing_curves import LARGEST_POSSIBLE, PRINTED_THRESHOLD, draw_dispersion
from validation.figures.packings import draw_histograms, draw_packings
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.frame.tables import summary
from validation.rows.packings import TARGETS, PackingRequest, kept_lattice

#: κ from 0 to 40 % [-].
SPREADS = tuple(5 * step / 100.0 for step in range(9))

# The two that the paper's figures 5 and 6 show.
_SHOWN = (0.0, 0.25)


@dataclass(frozen=True)
class Dispersion(Study):
    """Packings over the dispersion of their radii: figures 5 to 7 of André et al. (2012).

    Attributes:
        count: number of spheres.
        spreads: κ of each [-].
        seeds: packings of each κ, with seeds 1 … seeds.
        method: of `bd.pack`; the paper's is "shear".
        target: one of `TARGETS`.
    """

    limits: ClassVar = {
        "count": numbers(least=10), "spreads": numbers(least=0.0, below=2.0), "seeds": numbers(least=1),
        "method": words(METHODS), "target": words(TARGETS),
    }  # fmt: skip

    count: int = 3000
    spreads: tuple[float, ...] = SPREADS
    seeds: int = 1
    method: str = "shear"
    target: str = "contacts"

    @property
    def requests(self) -> list[PackingRequest]:
        """Every packing, κ by κ."""
        return [
            PackingRequest(self.count, round(spread, 6), self.method, self.target, seed)
            for spread in sorted(self.spreads)
            for seed in range(1, self.seeds + 1)
        ]

    def stages(self, out: Path) -> Stages:
        yield "pack", self.requests

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        return {
            "isotropy_error_in_print": PRINTED_THRESHOLD,
            "isotropy_error_largest_possible": LARGEST_POSSIBLE,
            "summary": summary(rows, ("spread",)),
        }

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures 5, 6 and 7."""
        figures = out / "figures"
        first = {row["spread"]: row["seed"] for row in reversed(rows)}
        # Where the paper's two are not there, those nearest to them.
        shown = sorted({min(first, key=lambda spread: abs(spread - wanted)) for wanted in _SHOWN})
        requests = {(request.spread, request.seed): request for request in self.requests}
        lattices = [kept_lattice(requests[spread, first[spread]], out) for spread in shown]
        titles = [f"κ = {100.0 * spread:g} %" for spread in shown]
        draw_packings(figures / "packings.png", lattices, titles)
        draw_histograms(figures / "histograms.png", lattices, titles)
        draw_dispersion(figures / "dispersion.png", rows, verdict=LIMITS["rms_excess"])
