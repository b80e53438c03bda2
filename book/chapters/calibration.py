"""Automatic calibration: intervals that keep their word, and the time it takes."""

from book.dates import is_older
from book.forms import COUNT, PERCENT, SECONDS, Form
from book.results import Measurement, study
from book.row import Row, Rows
from book.tolerances import AtLeast, AtMost

COVERAGE = study("coverage", {"coverage": "coverage"})
TIMES = Measurement("calibration", "python -m benchmarks.calibration", "4 min")
MEASUREMENTS = (COVERAGE, TIMES)
OLD = is_older(TIMES, "the compiled core")

RATIO = Form(style=",.0f")


def coverage() -> Rows:
    unseen = COVERAGE.at("held_out")
    for name, symbol in (("E", "E"), ("nu", "ν")):
        found = COVERAGE.at("quantities", name)
        yield Row(f"{symbol}: unseen packings in the 95 % prediction interval, of {unseen}",
            COVERAGE.of(found["covered"]), AtLeast(35.0), COUNT)  # fmt: skip
        for size, share in found["coverage"].items():
            yield Row(f"{symbol}, calibrated on {size}: share of unseen packings covered", COVERAGE.of(share["mean"]),
                AtLeast(35.0 / 40.0), PERCENT)  # fmt: skip


def times() -> Rows:
    yield Row("`bondem calibrate` without a packing, three cells of 10 000 elements, median",
        TIMES.number("from_nothing", "3 cells", "median"), AtMost(30.0), SECONDS)  # fmt: skip
    for name, words in (
        ("figs 15 and 16", "the curves of figs 15 and 16"), ("whole study", "all its curves, figs 11 to 16"),
    ):  # fmt: skip
        yield Row(f"the paper's way, {words}: its time over the calibration of one cylinder",
            TIMES.number("paper_way_extrapolated", name, "ratio"), AtLeast(100.0), RATIO)  # fmt: skip
    nothing = TIMES.at("from_nothing", "1 cylinder", "median")
    before = nothing - TIMES.at("warm", "1 cylinder", "median")
    whole = TIMES.at("paper_way_extrapolated", "whole study", "seconds")
    yield Row("all its curves over one cylinder, both without a packing", TIMES.of((whole + before) / nothing),
        AtLeast(100.0), RATIO,
        note=f"{before:.1f} s of {nothing:.1f} s of ours are spent on what both methods need: start and packing")
