"""The paper's own protocol: Tables 1 to 4 of André et al. (2012), measured as they measure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from bondem._checks import choice, count
from bondem.packing.sizes import SPREAD
from bondem.specimen.materials import fused_silica
from validation.figures.protocol import draw_protocol
from validation.frame.failures import complain
from validation.frame.files import in_percent, mean_and_scatter, table
from validation.frame.study import Row, Stages, Study
from validation.rows.packings import PackingRequest
from validation.rows.protocol import MEASURES, PRINTED, ProtocolTest

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
_WORDS = {"paper": "eqs (12)–(15)", "affine": "affine fit"}


@dataclass(frozen=True)
class Protocol(Study):
    """The paper's own protocol on packings of both kinds: Tables 1 to 4 of André et al. (2012).

    Attributes:
        count: spheres of a packing.
        packings: of each kind, seeds 1 … packings.
        steps: of each explicit run.
        methods: of `bd.pack`; the paper's is "shear".
    """

    name: ClassVar[str] = "protocol"

    # slow: shear compaction of a packing takes about half an hour
    count: int = 10_000
    packings: int = 4
    steps: int = 50_000
    methods: tuple[str, ...] = tuple(METHODS)

    def __post_init__(self) -> None:
        count("", "count", self.count, least=500, advice="at least 500 spheres, or the cylinder is no bar")
        count("", "packings", self.packings, least=1, advice="at least 1")
        count("", "steps", self.steps, least=1000, advice="at least 1000")
        for method in self.methods:
            choice(self.name, "method", method, tuple(METHODS))

    @property
    def bars(self) -> list[PackingRequest]:
        """What is packed, one kind after the other."""
        return [
            PackingRequest(self.count, SPREAD, method, "contacts", seed, form="bar")
            for method in self.methods
            for seed in range(1, self.packings + 1)
        ]

    def stages(self, out: Path) -> Stages:
        """See `Study`."""
        complain((yield "pack", self.bars), out)
        yield "test", [ProtocolTest(packing, self.steps) for packing in self.bars]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: means and scatter over the packings of each kind."""
        good = [row for row in rows if not row["error"]]
        kinds = {method: [row for row in good if row["method"] == method] for method in self.methods}
        return {
            "count": self.count,
            "steps": self.steps,
            "summary": {method: _summary(found) for method, found in kinds.items() if found},
            "paper": {name: printed for name, (_, printed) in TESTS.items()},
        }

    def table(self, results: Mapping[str, Any]) -> str:
        """See `Study`."""
        return "\n".join([_bonds(results["summary"]), _errors(results["summary"])])

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Errors of the seven tests."""
        draw_protocol(out / "figures" / "protocol_errors.png", results["summary"], METHODS, TESTS)


def _summary(rows: Sequence[Row]) -> dict[str, Any]:
    measured = [name for name, value in rows[0].items() if isinstance(value, float) and name not in _NOT_MEASURED]
    return {
        "packings": len(rows),
        **{name: mean_and_scatter([row[name] for row in rows]) for name in measured},
        "errors": {name: mean_and_scatter([row["errors"][name] for row in rows]) for name in rows[0]["errors"]},
        "swings": {name: max(row["swings"][name] for row in rows) for name in rows[0]["swings"]},
    }


def _number(value: Mapping[str, float], pattern: str, unit: float = 1.0) -> str:
    text = f"{value['mean'] / unit:{pattern}}"
    return text if value["std"] is None else f"{text} ± {value['std'] / unit:{pattern}}"


def _bonds(summary: Mapping[str, Any]) -> str:
    columns: list[list[str]] = [[METHODS[kind]] for kind in summary]
    head = ["packing"]
    quantities = [("coordination number", "coordination_number", ".2f", 1.0)]
    for measure in MEASURES:
        by = _WORDS[measure]
        quantities += [
            (f"r̃, {by}", f"r_mu_ratio_{measure}", ".4f", 1.0), (f"E_μ [GPa], {by}", f"E_mu_{measure}", ".1f", 1e9),
            (f"E [GPa] with the printed bonds, {by}", f"printed_E_{measure}", ".2f", 1e9),
            (f"ν with them, {by}", f"printed_nu_{measure}", ".4f", 1.0),
        ]  # fmt: skip
    for words, name, pattern, unit in quantities:
        head.append(words)
        for column, found in zip(columns, summary.values(), strict=True):
            column.append(_number(found[name], pattern, unit))
    printed = ["the paper", "above 6.2"]
    for _ in MEASURES:
        printed += [f"{PRINTED.radius_ratio}", f"{PRINTED.E / 1e9:.0f}", f"{fused_silica.E / 1e9}",
                    f"{fused_silica.nu}"]  # fmt: skip
    return table("Bonds calibrated on each packing", head, [printed, *columns])


def _errors(summary: Mapping[str, Any]) -> str:
    rows = [
        [words, f"{100.0 * printed:.2f}", *(in_percent(found["errors"][name]) for found in summary.values())]
        for name, (words, printed) in TESTS.items()
    ]
    timoshenko = "bending frequency against Timoshenko's theory"
    rows.append(
        [timoshenko, "", *(in_percent(found["errors"]["dynamic_bending_timoshenko"]) for found in summary.values())]
    )
    return table("Errors, per cent", ["test", "the paper", *(METHODS[kind] for kind in summary)], rows)

