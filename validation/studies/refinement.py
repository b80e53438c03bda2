"""How a packing depends on its number of spheres (André et al. 2012, §4.3, fig. 8)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.packing import METHOD, METHODS
from bondem.packing.sizes import SPREAD
from validation.figures.packing_curves import draw_refinement
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.frame.tables import summary
from validation.measures.limit import Limit, limit
from validation.rows.packings import TARGETS, PackingRequest

#: 22 sizes in equal ratios. Below 200 spheres, six contacts a sphere between walls take overlaps of half a radius.
COUNTS = tuple(int(float(f"{count:.2g}")) for count in np.geomspace(200, 50_000, 22))

# The targets at which a quantity is free, and so has a limit to be found.
_LIMITS = {"volume_fraction": TARGETS, "coordination_number": ("jamming",)}

# Packings without walls need no more spheres than this.
_PERIODIC_COUNT = 10_000

# Below, edges and corners matter, and a quarter of all spheres touches a wall.
_ASYMPTOTIC = 1000


@dataclass(frozen=True)
class Refinement(Study):
    """Density, contacts and isotropy over the number of spheres: figure 8 of André et al. (2012).

    Attributes:
        counts: numbers of spheres.
        packings: seeds 1 … packings of each.
        spread: κ [-].
        method: of `bd.pack`.
        targets: some of `TARGETS`.
        periodic: packings of the largest size up to 10 000 in a periodic cell, seeds 1 … periodic, to hold the
            limits against: there are no walls in them.
    """

    limits: ClassVar = {
        "counts": numbers(least=10), "packings": numbers(least=1), "periodic": numbers(least=0),
        "method": words(METHODS), "targets": words(TARGETS),
    }  # fmt: skip

    counts: tuple[int, ...] = COUNTS
    packings: int = 5
    spread: float = SPREAD
    method: str = METHOD
    targets: tuple[str, ...] = TARGETS
    periodic: int = 3

    @property
    def requests(self) -> list[PackingRequest]:
        """Every packing, target by target, those without walls last."""
        large = max((count for count in self.counts if count <= _PERIODIC_COUNT), default=min(self.counts))
        cubes = [(count, seed, False) for count in sorted(self.counts) for seed in range(1, self.packings + 1)]
        cells = [(large, seed, True) for seed in range(1, self.periodic + 1)]
        return [
            PackingRequest(count, self.spread, self.method, target, seed, periodic)
            for target in self.targets
            for count, seed, periodic in (*cubes, *cells)
        ]

    def stages(self, out: Path) -> Stages:
        yield "pack", self.requests

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        good = [row for row in rows if not row["error"]]
        return {
            "limits": {
                target: {name: fit and fit.as_dict() for name, fit in _limits(good, target).items()}
                for target in self.targets
            },
            "summary": summary(rows, ("target", "periodic", "count")),
        }

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figure 8."""
        limits = {target: _limits(rows, target) for target in self.targets}
        draw_refinement(out / "figures" / "refinement.png", rows, limits)


def _limits(rows: Sequence[Row], target: str) -> dict[str, Limit | None]:
    used = [row for row in rows if row["target"] == target and not row["periodic"] and row["count"] >= _ASYMPTOTIC]
    count = np.array([row["count"] for row in used], dtype=float)
    return {
        name: limit(count, np.array([row[name] for row in used], dtype=float)) if target in free else None
        for name, free in _LIMITS.items()
    }
