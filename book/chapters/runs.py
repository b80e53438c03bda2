"""What becomes of runs that are killed, of damaged files, and what output costs."""

from book.forms import PERCENT, Form
from book.results import Measurement
from book.row import Row, Rows
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

COUNT = Form(style=".0f")


def killed() -> Rows:
    every = Near(relative=0.0)
    for kept in (SURVIVAL, LARGE):
        kills = float(kept.at("kills"))
        told = (
            f"{kept.at('cells')} cells, {kept.at('steps')} steps, {kept.at('broken')} facets break, kept every"
            f" {kept.at('every')}"
        )
        yield Row(f"{told}: killed runs whose file bondem opens, and then VTK's own reader",
            kept.number("opened by both"), every, COUNT, paper=kills)  # fmt: skip
        yield Row(f"{told}: killed runs whose file VTK's own reader opens directly",
            kept.of(kept.at("kills") - kept.at("not read by VTK as left")), every, COUNT, paper=kills)  # fmt: skip
        yield Row(f"{told}: killed runs that end with the bits of a run never stopped", kept.number("same bits"),
            every, COUNT, paper=kills)  # fmt: skip
        yield Row(f"{told}: steps lost at most, of those reported before the kill", kept.number("lost at most"),
            AtMost(kept.at("every")), COUNT)  # fmt: skip


def flipped() -> Rows:
    yield Row("read as another state, record or mass", SURVIVAL.number("flipped", "other numbers"), AtMost(0.0),
        COUNT)  # fmt: skip


def fuzzed() -> Rows:
    for key, words in (("study", "studies, as text"), ("run", "run files, as bytes")):
        yield Row(f"{words}: tracebacks, hangs, crashes, wrong numbers accepted", FUZZING.number(key, "bad"),
            AtMost(0.0), COUNT)  # fmt: skip


def output() -> Rows:
    for one in OUTPUT.at("cases"):
        told = f"{one['elements']} {'cells' if one['kind'] == 'cells' else 'spheres with beams'}"
        yield Row(f"{told}: a hundred snapshots over a run of {OUTPUT.at('long')} steps", OUTPUT.of(one["cost"]),
            AtMost(0.05), PERCENT)  # fmt: skip


def campaign() -> Rows:
    found = CAMPAIGN.at("killed")
    wanted = float(found["specimens"])
    yield Row("specimens that arrived", CAMPAIGN.of(found["arrived"]), Near(relative=0.0), COUNT, paper=wanted)
    yield Row("specimens: computed twice or failed or left unfinished",
        CAMPAIGN.of(found["twice"] + found["failed"] + found["unfinished folders"]), AtMost(0.0), COUNT)  # fmt: skip
    yield Row("specimens: finished before the coordinator was killed and computed again",
        CAMPAIGN.of(found["done again"]), AtMost(0.0), COUNT)  # fmt: skip
    yield Row(f"speed-up on two workers, {CAMPAIGN.at('few')} specimens of {CAMPAIGN.at('cells')} cells, start"
        " of the cluster counted", CAMPAIGN.number("speed-up"), AtLeast(1.8), Form(style=".2f"))  # fmt: skip
