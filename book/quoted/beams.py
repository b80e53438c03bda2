"""Beams: calibration on some packings, tests on others, and the printed bonds of a paper."""

from collections.abc import Sequence

from book.chapters.andre_tables import FOUR, SILICA, unseen
from book.chapters.calibration import COVERAGE
from book.chapters.protocol import PROTOCOL
from book.forms import Form
from book.quoting import Quoted

GPA, SIGNED = Form("GPa", 1e9, ".0f"), Form("%", 1e-2, "+.1f")


def quoted() -> Sequence[Quoted]:
    """All quoted numbers of beams."""
    held_out = COVERAGE.at("held_out")
    size = f"{COVERAGE.at('count')} spheres, {COVERAGE.at('calibrating')} packings calibrate, {held_out} are tested"
    found = [
        Quoted(name="beams.covered", says="unseen packings whose E is in the 95 % interval", size=size,
               record=COVERAGE, values=(COVERAGE.at("quantities", "E", "covered"),)),
        Quoted(name="beams.held_out", says="unseen packings", size=size, record=COVERAGE, values=(held_out,)),
    ]  # fmt: skip
    for name, record in (("one", SILICA), ("four", FOUR)):
        packings = record.at("packings")
        tested = sum(not one["calibrating"] for one in packings)
        mean = unseen(record, "E")
        found.append(Quoted(
            name=f"beams.{name}", says="E of unseen packings of silica less that entered: mean ± standard deviation",
            size=f"10 000 spheres, {len(packings) - tested} calibrate, {tested} are tested", record=record,
            form=SIGNED, values=mean.values, scatter=mean.scatter,
        ))  # fmt: skip
    shear = PROTOCOL.at("summary", "shear")
    found.append(Quoted(
        name="beams.printed", says="E of silica with the bonds printed by André et al. (2012)", record=PROTOCOL,
        size=f"{PROTOCOL.at('count')} spheres, {shear['packings']} packings", form=GPA,
        values=(shear["printed_E_paper"]["mean"],),
    ))  # fmt: skip
    return found
