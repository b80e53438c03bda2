"""Cracks that choose their path: mixed mode, splitting, a hole and interfaces, with what is known of them."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

from validation.cases.path_case import PathCase
from validation.figures.crack_paths import draw_path
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.rows.crack_paths import CASES, PathRun


@dataclass(frozen=True)
class CrackPaths(Study):
    """Cracks that choose their path: shear with tension, four-point shear, splitting, interfaces and a hole.

    Attributes:
        cases: which of them.
        seeds: packings of each.
        finer: how many times smaller cells are than the cases have them.
    """

    limits: ClassVar = {"cases": words(CASES), "seeds": numbers(least=0), "finer": numbers(above=0.0, most=10.0)}

    cases: tuple[str, ...] = tuple(CASES)
    seeds: tuple[int, ...] = (1,)
    finer: float = 1.0

    def stages(self, out: Path) -> Stages:
        yield "break", [PathRun(replace(CASES[name], finer=self.finer), seed)
                        for name in self.cases for seed in self.seeds]  # fmt: skip

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: what packings of each case gave, and a verdict on each claim."""
        cases = []
        for name in self.cases:
            some = [row for row in rows if row["case"] == name and not row["error"]]
            if some:
                cases.append(_judged(CASES[name], some))
        return {"finer": self.finer, "cases": cases}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: a figure a case."""
        for name in self.cases:
            if some := [row for row in rows if row["case"] == name]:
                draw_path(out / "figures" / f"{name}.png", CASES[name], some)


def _judged(case: PathCase, rows: Sequence[Row]) -> dict[str, Any]:
    values = {key: [row["values"][key] for row in rows] for key in rows[0]["values"]}
    claims = []
    for claim in case.claims:
        found = values[claim.quantity]
        met = "missed" if any(value is None for value in found) else claim.verdict(found)
        high = claim.high if claim.high < float("inf") else None
        claims.append(asdict(claim) | {"high": high, "verdict": met})
    return {
        "name": case.name, "title": case.title, "claims": claims, "values": values,
        **{key: [row[key] for row in rows] for key in ("seed", "count")},
    }  # fmt: skip
