"""The paper's own protocol: Tables 1 to 4 of André et al. (2012), measured as they measure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from bondem.packing.sizes import SPREAD
from validation.figures.protocol import draw_protocol
from validation.frame.failures import complain
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.rows.packings import PackingRequest
from validation.rows.protocol import ProtocolTest

#: How bars are packed: the paper's way, and ours.
METHODS = {"shear": "shear compaction, as the paper", "quench": "quench, the default of bondem"}
#: Tests of Tables 3 and 4, and what the paper prints for their errors [-]; it prints no signs.
TESTS = {
    "static_tension": ("Table 3, tension", 0.0120),
    "static_bending": ("Table 3, bending", 0.0416),
    "static_torsion": ("Table 3, torsion", 0.0613),
    "dynamic_tension": ("Table 4, axial frequency", 0.0038),
    "dynamic_bending": ("Table 4, bending frequency", 0.0663),
    "dynamic_torsion": ("Table 4, torsional frequency", 0.0050),
    "impact_0.01": ("Table 4, celerity, arrival at 1 % of the first peak", 0.0040),
    "impact_0.1": ("Table 4, celerity, arrival at 10 %", 0.0040),
    "impact_0.5": ("Table 4, celerity, arrival at 50 %", 0.0040),
}
_NOT_MEASURED = ("spread", "seconds")


@dataclass(frozen=True)
class Protocol(Study):
    """The paper's own protocol on packings of both kinds: Tables 1 to 4 of André et al. (2012).

    Attributes:
        count: spheres of a packing.
        packings: of each kind, seeds 1 … packings.
        steps: of each explicit run.
        methods: of `bd.pack`; the paper's is "shear".
    """

    limits: ClassVar = {
        "count": numbers(least=500, advice="at least 500 spheres, or the cylinder is no bar"),
        "packings": numbers(least=1), "steps": numbers(least=1000), "methods": words(METHODS),
    }  # fmt: skip

    # slow: shear compaction of a packing takes about half an hour
    count: int = 10_000
    packings: int = 4
    steps: int = 50_000
    methods: tuple[str, ...] = tuple(METHODS)

    @property
    def bars(self) -> list[PackingRequest]:
        """What is packed, one kind after the other."""
        return [
            PackingRequest(self.count, SPREAD, method, "contacts", seed, form="bar")
            for method in self.methods
            for seed in range(1, self.packings + 1)
        ]

    def stages(self, out: Path) -> Stages:
        complain((yield "pack", self.bars), out)
        yield "test", [ProtocolTest(packing, self.steps) for packing in self.bars]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: means and scatter over the packings of each kind."""
        good = [row for row in rows if not row["error"]]
        kinds = {method: [row for row in good if row["method"] == method] for method in self.methods}
        return {
            "summary": {method: _summary(found) for method, found in kinds.items() if found},
        }

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Errors of the seven tests."""
        draw_protocol(out / "figures" / "protocol_errors.png", results["summary"], METHODS, TESTS)


def _summary(rows: Sequence[Row]) -> dict[str, Any]:
    measured = [name for name, value in rows[0].items() if isinstance(value, float) and name not in _NOT_MEASURED]
    return {
        "packings": len(rows),
        **{name: mean_and_scatter([row[name] for row in rows]) for name in measured},
        "errors": {name: mean_and_scatter([row["errors"][name] for row in rows]) for name in rows[0]["errors"]},
    }
