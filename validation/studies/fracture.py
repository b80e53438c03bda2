"""Published fracture tests on graded bodies of cells, without inertia: a scorecard, load curves and crack paths."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, ClassVar

from validation.cases import gregoire, petersson
from validation.cases.case import CURVES, Case
from validation.cases.garcia_alvarez import GARCIA_ALVAREZ
from validation.cases.l_panel import L_PANEL
from validation.figures.fracture import draw_case
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.measures.cohesive_crack import cohesive_crack
from validation.rows.fracture import FractureRun

CASES: Mapping[str, Case] = {
    one.name: one for one in (petersson.PETERSSON, gregoire.GREGOIRE, GARCIA_ALVAREZ, L_PANEL)
}
# Beams pressed above their notch: half of them is enough for a continuum with a cohesive crack.
_HALVED = {"petersson": petersson.BEAM, "gregoire": gregoire.BEAM}
# What is read of a row, with factor and unit in tables; work is that until the end and its tail.
_UNITS: Mapping[str, tuple[Callable[[Row], float], float, str]] = {
    "peak": (lambda row: float(row["peak"]), 1e-3, "kN"),
    "work": (lambda row: float(row["work"] + row["tail"]), 1.0, "J"),
}


@dataclass(frozen=True)
class Fracture(Study):
    """Published fracture tests: load curves, peaks, work and crack paths beside what was measured.

    Attributes:
        cases: which of them.
        seeds: packings of each.
        finer: how many times smaller cells are than the cases have them.
        curve: how cracks soften: "bilinear", Petersson's curve of concrete, or "straight".
    """

    limits: ClassVar = {
        "cases": words(CASES), "seeds": numbers(least=0), "curve": words(CURVES),
        "finer": numbers(above=0.0, most=10.0),
    }  # fmt: skip

    cases: tuple[str, ...] = tuple(CASES)
    seeds: tuple[int, ...] = (1, 2, 3)
    finer: float = 1.0
    curve: str = "bilinear"

    def stages(self, out: Path) -> Stages:
        yield (
            "break",
            [FractureRun(CASES[name], seed, self.finer, self.curve) for name in self.cases for seed in self.seeds],
        )

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each case its claim, what its packings gave, and the verdict."""
        good = [row for row in rows if not row["error"]]
        groups = {name: [row for row in good if row["case"] == name] for name in self.cases}
        cases = [_judged(CASES[name], some, self.curve) for name, some in groups.items() if some]
        return {"cases": cases}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: a figure a case, load curves and the crack path of the first packing."""
        for name in self.cases:
            if some := [row for row in rows if row["case"] == name]:
                draw_case(out / "figures" / f"{name}.png", CASES[name], some)


def _judged(case: Case, rows: Sequence[Row], curve: str) -> dict[str, Any]:
    beam = _HALVED.get(case.name)
    values = [_UNITS[case.claim.quantity][0](row) for row in rows]
    return {
        "name": case.name, "title": case.title, "claim": asdict(case.claim), "values": values,
        "verdict": case.claim.verdict(values),
        "continuum": cohesive_crack(case, beam, CURVES[curve]).peak if beam else None,
        "seeds": [row["seed"] for row in rows],
        **{key: [row[key] for row in rows]
           for key in ("count", "events", "peak", "work", "tail", "dissipated", "run_seconds", "end")},
        "mean": {key: mean_and_scatter([read(row) for row in rows]) for key, (read, *_) in _UNITS.items()},
    }  # fmt: skip
