"""Cracked plates loaded to their peak, as rows of a study: the stress intensity at which they break."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem.statics.quasistatic.quasistatic_run import solve_quasistatic
from validation.cases.toughness import PLATES, Cracked
from validation.frame.files import plain
from validation.frame.request import Request

# Steps of softening, load factors that count as one, and load over its peak at which a run ends.
_RIPPLE, _TOGETHER, _UNTIL = 0.05, 0.01, 0.9
# Events that are kept of a path, the largest of as many as come to one.
_KEPT = 200


@dataclass(frozen=True)
class ToughnessRun(Request):
    """A plate of one kind and width on one packing.

    Attributes:
        kind: of the plate (`validation.cases.toughness.PLATES`).
        over: its width over l.
        cells: size of cells at the tip over l.
        seed: of the packing.
    """

    kind: str
    over: float
    cells: float
    seed: int

    @property
    def plate(self) -> Cracked:
        """What is pulled."""
        return PLATES[self.kind][0](self.over, self.cells)

    @property
    def weight(self) -> float:
        return self.over / self.cells**3

    @property
    def asked(self) -> dict[str, Any]:
        """See `Request`; cells are of one kind, and their number follows."""
        return {"kind": self.kind, "over": self.over, "size": self.cells, "seed": self.seed}

    def measured(self, folder: Path) -> dict[str, Any]:
        plate = self.plate
        body = plate.body(self.seed)
        model, read = plate.model(body)
        path = solve_quasistatic(model, read, ripple=_RIPPLE, together=_TOGETHER, until=_UNTIL)
        step = -(-len(path.load) // _KEPT)
        most = [float(path.load[k : k + step].max()) for k in range(0, len(path.load), step)]
        return plain({
            "count": len(body.particles), "facets": len(body.pairs), "events": len(path.load), "end": path.end,
            "peak": path.peak, "over_toughness": plate.intensity(path.peak), "expected": plate.expected,
            "at": int(np.argmax(path.load)),
            "curve": [plate.intensity(load) for load in most],
        })  # fmt: skip
