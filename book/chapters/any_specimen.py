"""The same bonds in any shape: cube, slender beam and bracket of five materials against finite elements."""

from typing import Any

from book.chapter import Chapter, Figure, Section
from book.forms import PERCENT, Form
from book.results import Measurement
from book.row import Row
from book.tolerances import AtMost

ANY = Measurement("any_specimen", "python benchmarks/any_specimen.py")
MEASUREMENTS = (ANY,)

WAYS = {"raw": "bonds as calibrated", "scaled": "corrected by the surface", "layered": "corrected at walls"}


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="any_specimen",
        title="Calibrated once, used on any shape",
        summary=(
            "Bonds are calibrated once, in cells without walls, and used in a cube, a slender beam and a bracket of"
            " five materials, against three-dimensional finite elements."
        ),
        sections=(_shapes(), _convergence()),
    )


def _shapes() -> Section:
    rows = []
    for case in ANY.at("cases"):
        for way, words in _ways(case):
            limit = case["limit"]
            tolerance = AtMost(limit) if limit is not None and way == "layered" else None
            rows.append(
                Row(case=f"{case['material']}, {case['shape']}, {words}: largest error of E, ν, first frequencies",
                    ours=ANY.of(case[way]["worst"]), form=PERCENT, tolerance=tolerance)
            )  # fmt: skip
    return Section(
        title="Five materials, three shapes",
        before=(
            f"Five materials in three shapes of {ANY.at('count')} elements: 3 % is asked where the thinnest part is"
            " 25 R̄ thick or more, 6 % where it is 12 R̄."
        ),
        rows=tuple(rows),
        figures=(
            Figure("any_specimen.png", "Errors in cube, beam and bracket"),
            Figure("any_specimen_bracket.png", "The bracket, and its first mode"),
        ),
    )


def _convergence() -> Section:
    rows = [
        Row(case=f"{case['material']}, {case['shape']} of {case['count']}, {case['thickness']:.0f} R̄ thick, {words}",
            ours=ANY.of(case[way]["worst"]), form=Form("%", 1e-2, ".1f"))
        for case in ANY.at("convergence")
        for way, words in _ways(case)
    ]  # fmt: skip
    return Section(
        title="Convergence with fineness",
        before="Largest error of E, ν and first frequencies.",
        rows=tuple(rows),
        figures=(Figure("any_specimen_convergence.png", "Errors over the thickness of the thinnest part"),),
    )


def _ways(case: dict[str, Any]) -> list[tuple[str, str]]:
    return [(way, words) for way, words in WAYS.items() if way in case]
