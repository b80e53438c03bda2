"""What bondem costs in time and memory, beside its peers."""

from book.chapter import Chapter, Section
from book.forms import PERCENT, SECONDS, Form
from book.results import Measurement, recorded
from book.row import Measured, Row
from book.tolerances import AtLeast, AtMost

PEERS = Measurement("peers", "python benchmarks/peers/compare.py --elements 10000 100000", "20 min")
MEASUREMENTS = (PEERS,)

RATE = Form("M/s", 1e6, ".0f")
FINE_RATE = Form("M/s", 1e6, ".1f")
LONG = Form("s", style=",.0f")
RATIO = Form(style=".1f")
NANO = Form("ns", 1e-9, ".3g")
NAMES = {"lammps": "LAMMPS bpm/rotational", "yade": "Yade CohFrictMat, bonds only"}


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="cost",
        title="Cost: time, memory, peers",
        summary="Times on 2 shared cores; what was tried for the step: [decision 0001](decisions/0001-state.md).",
        sections=(_study(), _statics(), _step(), _peers(), _memory()),
    )


def _study() -> Section:
    return Section(
        title="The whole study",
        rows=(
            Row(case="whole study, cold, compilation of the explicit step apart", ours=recorded("study_cold"),
                form=SECONDS, tolerance=AtMost(180.0)),
            Row(case="whole study, warm", ours=recorded("study_warm"), form=SECONDS, tolerance=AtMost(120.0)),
            Row(case="calibration on a static tension test", ours=recorded("calibration_time"), form=SECONDS,
                tolerance=AtMost(10.0)),
            Row(case="peak memory of the study", ours=recorded("study_memory"), form=Form("GiB", 2.0**30, ".2f"),
                tolerance=AtMost(2.0 * 2.0**30)),
            Row(case="warm start of a second process, to its first result", ours=recorded("warm_start"),
                form=SECONDS, tolerance=AtMost(1.0)),
            Row(case="compilation of a first explicit run", ours=recorded("compile_first"),
                form=Form("s", style=".3g"), tolerance=AtMost(15.0)),
            Row(case="the same in a second process", ours=recorded("compile_second"), form=SECONDS,
                tolerance=AtMost(1.0)),
        ),
        after="Times of packing are in the chapter on [packings](validation/packings.md).",
    )  # fmt: skip


def _statics() -> Section:
    return Section(
        title="Statics and modes",
        rows=(
            Row(case="static solve, 10 000 elements", ours=recorded("static_10000"), form=SECONDS,
                tolerance=AtMost(0.4)),
            Row(case="static solve, 106 000 elements", ours=recorded("static_100000"), form=SECONDS,
                tolerance=AtMost(11.0)),
            Row(case="eight natural modes, 10 000 elements", ours=recorded("modes_10000"), form=SECONDS),
        ),
    )


def _step() -> Section:
    return Section(
        title="Bond-steps",
        rows=(
            Row(case="one core, 10 000 elements", ours=recorded("steps_10000"), form=RATE),
            Row(case="one core, 100 000 elements",
                ours=Measured((_best("steps_100000"),), recorded("steps_100000").origin), form=RATE,
                tolerance=AtLeast(60e6), note="best; 54–66 M/s as neighbours on the machine let it, medians 48–64"),
            Row(case="two cores, 100 000 elements", ours=recorded("steps_100000_two"), form=RATE),
            Row(case="one core, 1 000 000 elements", ours=recorded("steps_1000000"), form=RATE,
                tolerance=AtLeast(45e6)),
            Row(case="two cores, 1 000 000 elements", ours=recorded("steps_1000000_two"), form=RATE),
            Row(case="two cores over one, 10 000 elements", ours=recorded("speedup_10000"), form=Form(style=".2f"),
                tolerance=AtLeast(1.9), note="138 over 73 M/s"),
            Row(case="two cores over one, 100 000 elements and above", ours=recorded("speedup_100000"),
                form=Form(style=".2f"), tolerance=AtLeast(1.9)),
            Row(case="a Python callback each 100 steps, 10 000 elements", ours=recorded("callback"), form=PERCENT,
                tolerance=AtMost(0.01), note="0.1 ms a call; the difference of whole runs is noise"),
            Row(case="a bond in cache: 6 bonds, 4 sums, 4 motion", ours=recorded("bond_in_cache"), form=NANO),
            Row(case="a bond at 100 000 elements", ours=recorded("bond_100000"), form=NANO),
            Row(case="a bond at 1 000 000 elements", ours=recorded("bond_1000000"), form=NANO),
        ),
        after="Bytes, flops and the share of the roofline: `python benchmarks/scaling.py`.",
    )  # fmt: skip


def _best(name: str) -> float:
    return max(recorded(name).values)


def _peers() -> Section:
    rows = []
    for code, factor in (("lammps", 12.0), ("yade", 25.0)):
        for elements in (10_000, 100_000):
            found = PEERS.at("specimens", {"elements": elements}, "codes", code)
            many = f"{elements:,}".replace(",", " ")
            rows += [
                Row(case=f"bondem over {NAMES[code]}, one thread each, {many} elements", form=RATIO,
                    tolerance=AtLeast(factor), ours=PEERS.of(found["ratio_best"])),
                Row(case=f"{NAMES[code]}, bond-steps, {many} elements", form=FINE_RATE,
                    ours=PEERS.of(1e6 * found["Mbond_steps_per_s_best"])),
            ]  # fmt: skip
        rows.append(Row(case=f"{NAMES[code]}, bond-steps when the factor was set", ours=recorded(f"{code}_then"),
            form=FINE_RATE))
    return Section(
        title="Peers",
        rows=tuple(rows),
        after=(
            "The peers are faster on this machine than when the factors were set. The motion of all codes is compared"
            " before any ratio."
        ),
    )


def _memory() -> Section:
    return Section(
        title="Memory",
        rows=(
            Row(case="state and solver arrays, 100 000 elements (tracemalloc peak), an element",
                ours=recorded("memory_state"), form=Form("KB", 1e3, ".1f")),
            Row(case="the whole process with packing, an element", ours=recorded("memory_process"),
                form=Form("KB", 1e3, ".1f")),
        ),
    )  # fmt: skip
