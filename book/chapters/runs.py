"""What becomes of runs that are killed, of damaged files, and what output costs."""

from book.chapter import Chapter, Section
from book.forms import PERCENT, Form
from book.results import Measurement
from book.row import Row
from book.tolerances import AtMost, Near

SURVIVAL = Measurement("survival", "python benchmarks/survival.py --kills 200 --flips 400", "15 min")
OUTPUT = Measurement("output_cost", "python benchmarks/output_cost.py", "5 min")
MEASUREMENTS = SURVIVAL, OUTPUT

COUNT, SECONDS = Form(style=".0f"), Form("s", style=".3g")


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="runs",
        title="Runs that are killed, and what output costs",
        summary="SIGKILL at random moments, single bits flipped, and the cost of snapshots: [runs](runs.md).",
        sections=(_killed(), _flipped(), _output()),
    )


def _of(key: str) -> int:
    return int(SURVIVAL.at(key))


def _killed() -> Section:
    kills = _of("kills")
    told = f"{_of('cells')} cells, {_of('steps')} steps, {_of('broken')} facets break, kept every {_of('every')}"
    every = Near(relative=0.0)
    return Section(
        title="Killed while they run and write",
        before=(
            "Each run is a process of its own that writes a checkpoint and a snapshot every few steps; SIGKILL comes"
            " at a random moment after the first."
        ),
        rows=(
            Row(case=f"{told}: runs killed whose file bondem opens, and then VTK's own reader", paper=float(kills),
                ours=SURVIVAL.of(SURVIVAL.at("opened by both")), form=COUNT, tolerance=every),
            Row(case="that then end with the same bits as a run never stopped", paper=float(kills),
                ours=SURVIVAL.of(SURVIVAL.at("same bits")), form=COUNT, tolerance=every),
            Row(case="steps lost at most, of those told before the kill", form=COUNT, tolerance=AtMost(_of("every")),
                ours=SURVIVAL.of(SURVIVAL.at("lost at most"))),
            Row(case="of them killed while a commit was being carried out (a journal was left)", form=COUNT,
                ours=SURVIVAL.of(SURVIVAL.at("with a journal"))),
        ),
        after=(
            "All that did not open had been killed between their first snapshot, at step 0, and their first"
            " checkpoint: there was nothing to go on from. Since then a checkpoint goes with the first snapshot; the"
            " kills were not repeated. All others have the same bits. VTK alone does not read every file in which a"
            " commit was cut off, before bondem has carried it out; how many was not counted rightly."
        ),
    )  # fmt: skip


def _flipped() -> Section:
    found = SURVIVAL.at("flipped")
    return Section(
        title="Flipped bits",
        before=f"{found['flips']} single bits of a run file, each in a byte that is not zero.",
        rows=(
            Row(case="read as another state, record or mass", ours=SURVIVAL.of(found["other numbers"]), form=COUNT,
                tolerance=AtMost(0.0)),
            Row(case="refused", ours=SURVIVAL.of(found["refused"]), form=COUNT),
            Row(case="in what a run does not go on from (snapshots, what HDF5 does not use)",
                ours=SURVIVAL.of(found["harmless"]), form=COUNT),
        ),
    )  # fmt: skip


def _output() -> Section:
    rows: list[Row] = []
    for one in OUTPUT.at("cases"):
        told = f"{one['elements']} {'cells' if one['kind'] == 'cells' else 'spheres with beams'}"
        rows += [
            Row(case=f"{told}: a step", ours=OUTPUT.of(one["step"]["median"]), form=SECONDS),
            Row(case=f"{told}: once, what does not change", ours=OUTPUT.of(one["once"]["median"]), form=SECONDS),
            Row(case=f"{told}: a snapshot", ours=OUTPUT.of(one["snapshot"]["median"]), form=SECONDS),
            Row(case=f"{told}: its size", form=Form("MB", style=".1f"),
                ours=OUTPUT.of(one["bytes a snapshot"] / 1e6)),
            Row(case=f"{told}: a hundred snapshots over a run of {OUTPUT.at('long')} steps", form=PERCENT,
                ours=OUTPUT.of(one["cost"]), tolerance=AtMost(0.05)),
        ]  # fmt: skip
    return Section(
        title="Output",
        before=(
            "Snapshots every hundredth of a run; the compression test of 12 000 elements takes 55 000 steps, and"
            " finer bodies take more."
        ),
        rows=tuple(rows),
        after=(
            "Once, at the first snapshot, the polyhedra of the cells are found and written. In an earlier edition"
            " that was shared out over ten snapshots and counted a hundred times, which made 11 % of it."
        ),
    )
