"""What becomes of runs that are killed, of damaged files, and what output costs."""

from book.chapter import Chapter, Section
from book.forms import PERCENT, Form
from book.results import Measurement
from book.row import Row
from book.tolerances import AtLeast, AtMost, Near

SURVIVAL = Measurement("survival", "python benchmarks/survival.py --kills 200 --flips 400", "15 min")
OUTPUT = Measurement("output_cost", "python benchmarks/output_cost.py", "5 min")
LARGE = Measurement(
    "survival_large",
    "python benchmarks/survival.py --cells 100000 --kills 10 --flips 0 --steps 120 --every 20"
    " --out benchmarks/results/survival_large.json",
    "15 min",
)  # fmt: skip
CAMPAIGN = Measurement("campaign", "python benchmarks/campaign.py", "8 min")
FUZZING = Measurement("fuzzing", "python benchmarks/fuzzing.py", "5 min")
MEASUREMENTS = SURVIVAL, LARGE, FUZZING, OUTPUT, CAMPAIGN

COUNT, SECONDS = Form(style=".0f"), Form("s", style=".3g")


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="runs",
        title="Killed runs, cost of output, and campaigns",
        summary=(
            "The chapter tests runs that are killed at random moments, files with flipped bits, fuzzed readers, "
            "the cost of snapshots, and campaigns whose workers are killed. The features are described in "
            "[runs](runs.md) and [campaigns](campaigns.md)."
        ),
        sections=(_killed(), _flipped(), _fuzzed(), _output(), _campaign()),
    )


def _killed() -> Section:
    every, rows = Near(relative=0.0), []
    for kept in (SURVIVAL, LARGE):
        kills = float(kept.at("kills"))
        told = (
            f"{kept.at('cells')} cells, {kept.at('steps')} steps, {kept.at('broken')} facets break, kept every"
            f" {kept.at('every')}"
        )
        rows += [
            Row(case=f"{told}: killed runs whose file bondem opens, and then VTK's own reader", paper=kills,
                ours=kept.of(kept.at("opened by both")), form=COUNT, tolerance=every),
            Row(case=f"{told}: killed runs whose file VTK's own reader opens directly", paper=kills, form=COUNT,
                ours=kept.of(kept.at("kills") - kept.at("not read by VTK as left")), tolerance=every),
            Row(case=f"{told}: killed runs that end with the bits of a run never stopped", paper=kills,
                ours=kept.of(kept.at("same bits")), form=COUNT, tolerance=every),
            Row(case=f"{told}: steps lost at most, of those reported before the kill", form=COUNT,
                ours=kept.of(kept.at("lost at most")), tolerance=AtMost(kept.at("every"))),
        ]  # fmt: skip
    return Section(
        title="Runs killed while they write",
        before=(
            "Each run is a process that writes a checkpoint and a snapshot every few steps; SIGKILL arrives at a "
            "random moment after the first."
        ),
        rows=tuple(rows),
        after=(
            "An earlier version lost 12 of 200 runs, killed between their first snapshot and their first "
            "checkpoint. A checkpoint is now written with the first snapshot."
        ),
    )


def _flipped() -> Section:
    found = SURVIVAL.at("flipped")
    return Section(
        title="Flipped bits",
        before=(
            "In each test one bit of a run file is flipped, in a byte that is not zero; there were "
            f"{found['flips']} tests."
        ),
        rows=(
            Row(case="read as another state, record or mass", ours=SURVIVAL.of(found["other numbers"]), form=COUNT,
                tolerance=AtMost(0.0)),
        ),
    )  # fmt: skip


def _fuzzed() -> Section:
    rows = []
    for key, words in (("study", "studies, as text"), ("run", "run files, as bytes")):
        found = FUZZING.at(key)
        rows.append(
            Row(case=f"{words}: tracebacks, hangs, crashes, wrong numbers accepted", ours=FUZZING.of(found["bad"]),
                form=COUNT, tolerance=AtMost(0.0))
        )  # fmt: skip
    return Section(
        title="Fuzzing",
        before=(
            f"libFuzzer runs for {FUZZING.at('study')['seconds']} s on each reader, guided by its branches, starting"
            " from the examples and from three small runs. In earlier versions it found a run file whose damaged head"
            " ended in an error of HDF5, and one whose texts made HDF5 search without end. It also learned to insert"
            " the digest that a changed file needs; the comparison of digests no longer reveals the expected one."
        ),
        rows=tuple(rows),
    )


def _output() -> Section:
    rows: list[Row] = []
    walls = " and ".join(f"{100.0 * float(one['cost by the wall']):.1f} %" for one in OUTPUT.at("cases"))
    for one in OUTPUT.at("cases"):
        told = f"{one['elements']} {'cells' if one['kind'] == 'cells' else 'spheres with beams'}"
        rows.append(
            Row(case=f"{told}: a hundred snapshots over a run of {OUTPUT.at('long')} steps", form=PERCENT,
                ours=OUTPUT.of(one["cost"]), tolerance=AtMost(0.05))
        )  # fmt: skip
    return Section(
        title="Output",
        before=(
            "Snapshots are written every hundredth of a run; the compression test of 12 000 elements takes 55 000 "
            "steps, and finer bodies take more. Shares are of the processor time of one thread, without AVX-512: "
            "other work of the machine hardly changes them. With more threads or faster steps the share is larger, "
            "because one thread writes."
        ),
        rows=tuple(rows),
        after=(
            f"By the wall, beside other work of the machine, the shares were {walls}. "
            "The polyhedra of the cells are computed and written once, at the first snapshot. An earlier version "
            "spread this over ten snapshots and counted it a hundred times, which gave 11 %."
        ),
    )


def _campaign() -> Section:
    found = CAMPAIGN.at("killed")
    wanted = float(found["specimens"])
    return Section(
        title="Campaigns",
        before=(
            "The jobs are bars of 200 cells that are torn apart. A worker is killed by its process id about every "
            "eight seconds; the coordinator is killed once, halfway, and started again."
        ),
        rows=(
            Row(case="specimens that arrived", paper=wanted, ours=CAMPAIGN.of(found["arrived"]), form=COUNT,
                tolerance=Near(relative=0.0)),
            Row(case="specimens: computed twice or failed or left unfinished", form=COUNT, tolerance=AtMost(0.0),
                ours=CAMPAIGN.of(found["twice"] + found["failed"] + found["unfinished folders"])),
            Row(case="specimens: finished before the coordinator was killed and computed again",
                ours=CAMPAIGN.of(found["done again"]), form=COUNT, tolerance=AtMost(0.0)),
            Row(case=f"speed-up on two workers, {CAMPAIGN.at('few')} specimens of {CAMPAIGN.at('cells')} cells, start"
                " of the cluster counted",
                ours=CAMPAIGN.of(CAMPAIGN.at("speed-up")), form=Form(style=".2f"), tolerance=AtLeast(1.8)),
        ),
    )  # fmt: skip
