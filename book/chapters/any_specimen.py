"""The same bonds in any shape: cube, slender beam and bracket of five materials against finite elements."""

from typing import Any

from book.chapter import Chapter, Figure, Section
from book.forms import COUNT, SIGNED, Form
from book.results import Measurement
from book.row import Measured, Row
from book.tolerances import AtLeast, AtMost

ANY = Measurement("any_specimen", "python benchmarks/any_specimen.py")
MEASUREMENTS = (ANY,)

LOADS = ("tension", "bending", "torsion")
WAYS = {"raw": "bonds as calibrated", "scaled": "one law, `law_for`", "layered": "bonds by layer, `calibrate_layers`"}


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
    rows = [
        Row(case=f"all cases, {words}: how many of {len(ANY.at('cases'))} are within the limit", form=COUNT,
            ours=ANY.of(sum(case[way]["worst"] <= case["limit"] for case in ANY.at("cases"))),
            tolerance=AtLeast(len(ANY.at("cases"))) if way == "layered" else None)
        for way, words in WAYS.items()
    ]  # fmt: skip
    for case in ANY.at("cases"):
        name, limit = f"{case['material']}, {case['shape']}", case["limit"]
        for way, words in _ways(case):
            tolerance = AtMost(limit) if limit is not None and way == "layered" else None
            rows.append(Row(case=f"{name}, {words}: errors of E, ν, first frequencies", form=SIGNED,
                            ours=_errors(case[way], judged=True), tolerance=tolerance))  # fmt: skip
        rows.append(Row(case=f"{name}, {WAYS['layered']}: errors of clamped tension, bending, torsion", form=SIGNED,
                        ours=_errors(case["layered"], judged=False)))  # fmt: skip
    return Section(
        title="Five materials, three shapes",
        before=(
            f"Specimens of {ANY.at('count')} elements; from the least to the largest error. 3 % is asked where the"
            " thinnest part is 25 R̄ thick or more (cube and beam), 6 % where it is 12 R̄ (bracket). The bonds of the"
            " layers have two empirical factors, found on packings of another seed and mostly of 8000 elements; these"
            " packings had no part in it. Clamped specimens are compared with a continuum held and loaded one R̄"
            " inside."
        ),
        rows=tuple(rows),
        figures=(
            Figure("any_specimen.png", "Errors in cube, beam and bracket"),
            Figure("any_specimen_bracket.png", "The bracket, and its first mode"),
        ),
    )


def _errors(found: dict[str, Any], *, judged: bool) -> Measured:
    chosen = [name for name, one in found.items() if isinstance(one, dict) and (name in LOADS) is not judged]
    return ANY.of(*(found[name]["error"] for name in chosen))


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
