"""Automatic calibration: intervals that keep their word."""


from book.chapter import Chapter, Figure, Section
from book.forms import COUNT, PERCENT
from book.results import study
from book.row import Row
from book.tolerances import AtLeast

COVERAGE = study("coverage", {"coverage": "coverage"})
MEASUREMENTS = (COVERAGE,)

SYMBOLS = {"E": "E", "nu": "ν"}


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="calibration",
        title="Calibration: do the intervals keep their word?",
        summary=(
            "A calibration on several packings gives a confidence interval for the mean of all packings and a"
            " prediction interval for one new packing. Unseen packings say whether they hold."
        ),
        sections=(_coverage(),),
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
        title="Coverage",
        before=(
            f"Calibrated on {COVERAGE.at('calibrating')} packings of {COVERAGE.at('count')} elements; shares are"
            " means over random choices of the calibrating packings."
        ),
        rows=tuple(rows),
        figures=(Figure("coverage.png", "Unseen packings and the interval"),),
    )
