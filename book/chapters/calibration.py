"""Automatic calibration: intervals that keep their word, and the same bonds in any shape."""

from typing import Any

from book.chapter import Chapter, Figure, Section
from book.forms import COUNT, PERCENT, Form
from book.results import Measurement, study
from book.row import Row
from book.tolerances import AtLeast, AtMost

COVERAGE = study("coverage", {"coverage": "coverage"})
ANY = Measurement("any_specimen", "python benchmarks/any_specimen.py")
MEASUREMENTS = (COVERAGE, ANY)

SYMBOLS = {"E": "E", "nu": "ν"}
WAYS = {"raw": "bonds as calibrated", "scaled": "corrected by the surface", "layered": "corrected at walls"}


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="calibration",
        title="Calibration: intervals, and any specimen",
        summary=(
            "Bonds are calibrated in cells or on specimens, with intervals; the same bonds are then used in other"
            " packings and in other shapes, against theory and three-dimensional finite elements."
        ),
        sections=(_coverage(), _shapes(), _convergence()),
    )


def _coverage() -> Section:
    unseen = COVERAGE.at("held_out")
    rows = []
    for name, symbol in SYMBOLS.items():
        found = COVERAGE.at("quantities", name)
        rows += [
            Row(case=f"{symbol}: unseen packings in the 95 % prediction interval, of {unseen}", form=COUNT,
                ours=COVERAGE.of(found["covered"]), tolerance=AtLeast(35.0)),
            Row(case=f"{symbol}: scatter over all packings", form=PERCENT, ours=COVERAGE.of(found["scatter"])),
        ]  # fmt: skip
        for size, share in found["coverage"].items():
            rows.append(Row(case=f"{symbol}: share of unseen packings covered, calibrated on {size}", form=PERCENT,
                            ours=COVERAGE.of(share["mean"]), tolerance=AtLeast(35.0 / 40.0)))  # fmt: skip
    return Section(
        title="Do the intervals keep their word?",
        before=(
            f"Calibrated on {COVERAGE.at('calibrating')} packings of {COVERAGE.at('count')} elements; shares are"
            " means over random choices of the calibrating packings."
        ),
        rows=tuple(rows),
        figures=(Figure("coverage.png", "Unseen packings and the interval"),),
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
        title="Calibrated once, used on any shape",
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
