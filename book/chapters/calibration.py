"""Automatic calibration: intervals that keep their word, and the time it takes."""

from book.chapter import Chapter, Figure, Section
from book.dates import date, is_older
from book.forms import COUNT, PERCENT, SECONDS, Form
from book.results import Measurement, study
from book.row import Row
from book.tolerances import AtLeast, AtMost

COVERAGE = study("coverage", {"coverage": "coverage"})
TIMES = Measurement("calibration", "python -m benchmarks.calibration", "4 min")
MEASUREMENTS = (COVERAGE, TIMES)

LONG = Form("s", style=",.0f")
RATIO = Form(style=",.0f")

SYMBOLS = {"E": "E", "nu": "ν"}


def chapter() -> Chapter:
    """The chapter."""
    times = _times()
    return Chapter(
        name="calibration",
        title="Calibration: coverage of the intervals, and time",
        summary=(
            "A calibration on several packings gives a confidence interval for the mean of all packings and a "
            "prediction interval for one new packing. Packings that took no part in the calibration test both."
        ),
        misses=_missed() if times.rows[-1].verdict.is_miss else "",
        sections=(_coverage(), times),
    )


def _missed() -> str:
    then = ", in a version that compiled its loops at their first use" if is_older(TIMES, "the compiled core") else ""
    return (
        "Started without a packing, the calibration of one cylinder is less than 100 times as fast as the paper's "
        f"way, because making the packing and starting the command take most of its time{then}."
    )


def _coverage() -> Section:
    unseen = COVERAGE.at("held_out")
    rows = []
    for name, symbol in SYMBOLS.items():
        found = COVERAGE.at("quantities", name)
        rows.append(
            Row(case=f"{symbol}: unseen packings in the 95 % prediction interval, of {unseen}", form=COUNT,
                ours=COVERAGE.of(found["covered"]), tolerance=AtLeast(35.0))
        )  # fmt: skip
        for size, share in found["coverage"].items():
            rows.append(Row(case=f"{symbol}, calibrated on {size}: share of unseen packings covered", form=PERCENT,
                            ours=COVERAGE.of(share["mean"]), tolerance=AtLeast(35.0 / 40.0)))  # fmt: skip
    return Section(
        title="Coverage",
        before=(
            f"The calibration uses {COVERAGE.at('calibrating')} packings of {COVERAGE.at('count')} elements. Shares "
            "are means over random choices of the calibrating packings."
        ),
        rows=tuple(rows),
        figures=(Figure("coverage.png", "Unseen packings and the interval"),),
    )


def _first() -> str:
    """What a command without a packing has to do first."""
    if is_older(TIMES, "the compiled core"):
        then = f"when this was measured ({date(TIMES)})"
        return f'"Without a packing" includes compilation, which the first use of bondem needed {then}.'
    return '"Without a packing" means that the command also makes the packing; nothing is compiled.'


def _times() -> Section:
    rows = [
        Row(case=f"`bondem calibrate` without a packing, {words} of 10 000 elements, median", form=SECONDS,
            ours=TIMES.number("from_nothing", name, "median"), tolerance=AtMost(30.0) if name == "3 cells" else None)
        for name, words in (("3 cells", "three cells"), ("1 cylinder", "one cylinder"))
    ]  # fmt: skip
    for name, words in (
        ("figs 15 and 16", "the curves of figs 15 and 16"), ("whole study", "all its curves, figs 11 to 16"),
    ):  # fmt: skip
        found = TIMES.at("paper_way_extrapolated", name)
        rows.append(
            Row(case=f"the paper's way, {words}: its time over the calibration of one cylinder", form=RATIO,
                ours=TIMES.of(found["ratio"]),
                tolerance=AtLeast(100.0))
        )  # fmt: skip
    nothing = TIMES.at("from_nothing", "1 cylinder", "median")
    before = nothing - TIMES.at("warm", "1 cylinder", "median")
    whole = TIMES.at("paper_way_extrapolated", "whole study", "seconds")
    rows.append(
        Row(case="all its curves over one cylinder, both without a packing", form=RATIO,
            ours=TIMES.of((whole + before) / nothing), tolerance=AtLeast(100.0),
            note=f"{before:.1f} s of {nothing:.1f} s of ours are spent on what both methods need: start and packing")
    )  # fmt: skip
    return Section(
        title="Time, and the paper's own way",
        before=(
            f"{_first()} The paper's way is one explicit "
            "quasi-static test per point of a curve; one test is timed, and five points per curve are assumed."
        ),
        rows=tuple(rows),
    )
