"""Beams: calibration on some packings, tests on others, and the printed bonds of a paper."""

from collections.abc import Iterator

from book.chapters.andre_tables import FOUR, SILICA, unseen
from book.chapters.calibration import COVERAGE
from book.chapters.protocol import PROTOCOL
from book.forms import Form
from book.quoting import Quoted

GPA, SIGNED = Form("GPa", 1e9, ".0f"), Form("%", 1e-2, "+.1f")


def quoted() -> Iterator[Quoted]:
    """All quoted numbers of beams."""
    held_out = COVERAGE.at("held_out")
    size = f"{COVERAGE.at('count')} spheres, {COVERAGE.at('calibrating')} packings calibrate, {held_out} are tested"
    yield Quoted("beams.covered", "unseen packings whose E is in the 95 % interval", size, COVERAGE,
        (COVERAGE.at("quantities", "E", "covered"),))  # fmt: skip
    yield Quoted("beams.held_out", "unseen packings", size, COVERAGE, (held_out,))
    for name, record in (("one", SILICA), ("four", FOUR)):
        packings = record.at("packings")
        tested = sum(not one["calibrating"] for one in packings)
        mean = unseen(record, "E")
        yield Quoted(f"beams.{name}", "E of unseen packings of silica less that entered: mean ± standard deviation",
            f"10 000 spheres, {len(packings) - tested} calibrate, {tested} are tested", record, mean.values, SIGNED,
            scatter=mean.scatter)  # fmt: skip
    shear = PROTOCOL.at("summary", "shear")
    yield Quoted("beams.printed", "E of silica with the bonds printed by André et al. (2012)",
        f"{PROTOCOL.at('count')} spheres, {shear['packings']} packings", PROTOCOL,
        (shear["printed_E_paper"]["mean"],), GPA)  # fmt: skip
