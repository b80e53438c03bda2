"""Lac du Bonnet granite in compression, tension and the Brazilian test, as rows of a study."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bondem as bd
from validation.cases.flattened_disc import BrazilianTest
from validation.cases.lac_du_bonnet import CORE, DISC, Granite
from validation.frame.files import plain, rounded, thinned
from validation.frame.request import Request


@dataclass(frozen=True)
class GraniteRun(Request):
    """A test of a strength on one packing.

    Attributes:
        granite: what is tested.
        test: "ucs", "direct_tension" or "brazilian".
        count: of cells.
        seed: of the packing.
    """

    granite: Granite
    test: str
    count: int
    seed: int

    def measured(self, folder: Path) -> dict[str, Any]:
        test = _TESTS[self.test](self.granite, self.count, self.seed)
        curve = thinned(test.curve)
        return plain({
            "peak": test.peak, "residual": test.residual, "asymmetry": test.asymmetry,
            "E": getattr(test, "E", None), **_left(test.state),
            "curve": {"strain": rounded(curve[:, 0], 5), "stress": rounded(curve[:, 1], 5)},
        })  # fmt: skip


def _core(count: int, seed: int) -> bd.Lattice:
    return bd.connect(bd.pack(CORE, count=count, method="even", seed=seed), method="laguerre")


def _compressed(granite: Granite, count: int, seed: int) -> bd.labtests.StrengthTest:
    return bd.labtests.uniaxial_compression(_core(count, seed), granite.law, granite.failure)


def _pulled(granite: Granite, count: int, seed: int) -> bd.labtests.StrengthTest:
    return bd.labtests.direct_tension(_core(count, seed), granite.law, granite.failure)


def _split(granite: Granite, count: int, seed: int) -> BrazilianTest:
    return DISC.press(DISC.body(count, seed), granite.law, granite.failure, granite.tension)


_TESTS: dict[str, Callable[[Granite, int, int], bd.labtests.StrengthTest | BrazilianTest]] = {
    "ucs": _compressed, "direct_tension": _pulled, "brazilian": _split,
}  # fmt: skip


def _left(state: bd.State) -> dict[str, int]:
    """What has happened to a specimen: facets that have cracked and broken, cells that have slipped."""
    return {
        "cracked": int((state.bond_integrity < 1.0).sum()), "broken": int((state.bond_integrity <= 0.0).sum()),
        "slipped": int((state.slipped > 0.0).sum()),
    }  # fmt: skip
