"""Tests whose cracks choose their path, each run a row: quantities, load curve and crack."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from validation.cases.arrea_ingraffea import ARREA_INGRAFFEA
from validation.cases.hole_arrest import HOLE_ARREST
from validation.cases.interface_crack import INTERFACES
from validation.cases.nooru_mohamed import NOORU_MOHAMED
from validation.cases.path_case import PathCase
from validation.cases.split_cube import SPLIT_CUBE
from validation.frame.files import plain, rounded, thinned
from validation.frame.request import Request
from validation.rows.fracture import DIGITS, crack_of

#: The cases, which stand here so that a row is stale where one of them has changed.
CASES: Mapping[str, PathCase] = {
    one.name: one for one in (*NOORU_MOHAMED, ARREA_INGRAFFEA, SPLIT_CUBE, *INTERFACES, HOLE_ARREST)
}


@dataclass(frozen=True)
class PathRun(Request):
    """A case on one packing.

    Attributes:
        case: what is tested.
        seed: seed of the packing.
    """

    case: PathCase
    seed: int

    @property
    def asked(self) -> dict[str, Any]:
        """See `Request`; cells are of one kind, and their number follows."""
        return {"case": self.case.name, "finer": self.case.finer, "seed": self.seed}

    def measured(self, folder: Path) -> dict[str, Any]:
        found = self.case.run(self.seed)
        curve = thinned(np.asarray(found.curve))
        return plain({
            "count": len(found.body.particles), "facets": len(found.body.pairs), "values": dict(found.values),
            "curve": {"displacement": rounded(curve[:, 0], DIGITS), "load": rounded(curve[:, 1], DIGITS)},
            "crack": crack_of(found.body, found.integrity),
        })  # fmt: skip
