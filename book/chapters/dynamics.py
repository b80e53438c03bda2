"""The bond's energy, and explicit dynamics with loads, damping and a limit to its step."""

from book.chapter import Chapter, Section
from book.forms import ROUNDING, Form, Said
from book.outcomes import TESTS, holds, largest, range_of
from book.results import Measurement, record
from book.row import Row
from book.tolerances import AtMost, Near, So

DRIFT = record("energy_drift", takes="7 min on one core")
HIGHEST = Measurement("highest_frequency", "python benchmarks/highest_frequency.py", "1 min")
STATIC = Measurement("static_solve", "python benchmarks/static_solve.py 11000 --repeat 0", "20 s")
MEASUREMENTS = (DRIFT, HIGHEST, STATIC, TESTS)

ORDER = Form(style=".2f")
SAME = Said("the same bits", "other bits")


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="dynamics",
        title="Bond energy and explicit dynamics",
        summary=(
            "Forces are the gradient of one energy to rounding. Momentum is conserved to rounding, and energy to "
            "second order without drift over a million steps. Loads, damping and boundaries keep this order, and "
            "the critical step is sharp."
        ),
        misses="Dynamic relaxation of a bent bar ends further from the static solution than required.",
        sections=(_energy(), _drift(), _loads(), _stability(), _relaxation()),
    )


def _energy() -> Section:
    return Section(
        title="Bond energy",
        rows=(
            Row(case="gradient against finite differences", ours=largest("gradient"), form=ROUNDING,
                tolerance=AtMost(1e-8)),
            Row(case="second derivative at rest against the 12×12 matrix", ours=largest("hessian"), form=ROUNDING,
                tolerance=AtMost(1e-8)),
            Row(case="force under rigid motion", ours=largest("rigid motion"), form=ROUNDING,
                tolerance=AtMost(1e-12)),
            Row(case="momentum over 10 000 steps", ours=largest("momentum"), form=ROUNDING, tolerance=AtMost(1e-12),
                note="rounding is required"),
            Row(case="angular momentum over 10 000 steps", ours=largest("angular momentum"), form=ROUNDING,
                tolerance=AtMost(1e-12), note="rounding is required"),
            Row(case="order of the energy error of a rod in large rotation", ours=range_of("order of a tumbling rod"),
                form=ORDER, tolerance=Near(target=2.0, absolute=0.1)),
            Row(case="order of the energy balance with loads, drives, damping", form=ORDER,
                ours=range_of("order of the ledger"), tolerance=Near(target=2.0, absolute=0.1)),
            Row(case="1 to 4 threads over 10 000 steps, any pausing, resumed runs", ours=holds("same bits"),
                form=SAME, tolerance=So()),
        ),
    )  # fmt: skip


def _drift() -> Section:
    return Section(
        title="The free silica cylinder over a million steps",
        rows=(
            Row(case="order of the energy error over dt, 9200 elements", ours=DRIFT.of(*DRIFT.at("orders")),
                form=Form(style=".3f"), tolerance=Near(target=2.0, absolute=0.1)),
            Row(case="drift of the energy over 1 000 000 steps in its standard errors",
                ours=DRIFT.number("drift, in its standard errors"),
                form=ORDER, tolerance=AtMost(2.0), note="none beyond rounding is required"),
        ),
    )  # fmt: skip


def _loads() -> Section:
    return Section(
        title="Loads and boundaries",
        rows=(
            Row(case="absorbing boundary, plane P pulse: reflected energy",
                ours=largest("energy that comes back, plane wave"), form=Form("%", 1e-2, ".2f"),
                tolerance=AtMost(0.02)),
            Row(case="absorbing boundary, pulse in a thin bar: reflected energy",
                ours=largest("energy that comes back, thin bar"),
                form=Form("%", 1e-2, ".2f"), tolerance=AtMost(0.02)),
            Row(case="heated bar, free: growth over ε*", ours=largest("heated bar, free"),
                form=Form(style=".3f"), tolerance=Near(target=1.0, absolute=0.01)),
            Row(case="heated bar, clamped: stress over −Eε*", ours=largest("heated bar, clamped"),
                form=Form(style=".3f"), tolerance=Near(target=1.0, absolute=0.01)),
            Row(case="heated chain, clamped: error of the stress", ours=largest("heated chain"), form=ROUNDING,
                tolerance=AtMost(1e-9)),
        ),
    )  # fmt: skip


def _stability() -> Section:
    return Section(
        title="Stability",
        rows=(
            Row(case="limit with dashpots of bonds, √(1 + ζ²) − ζ: at 0.99 of it",
                ours=holds("stable at 0.99 of the limit"), form=Said("stable", "unstable"), tolerance=So()),
            Row(case="limit with dashpots of bonds, √(1 + ζ²) − ζ: at 1.01 of it",
                ours=holds("unstable at 1.01 of the limit"),
                form=Said("unstable", "stable"), tolerance=So()),
            Row(case="ω_max of the lattice over its exact value, 100 000 elements",
                ours=HIGHEST.of(*HIGHEST.at("over exact").values()),
                form=Form(style=".3f"), tolerance=Near(target=1.0, absolute=0.01),
                note="from above, so a step is never too long"),
            Row(case="ω_max of small lattices of five laws over its exact value", ours=range_of("highest frequency"),
                form=Form(style=".3f"), tolerance=Near(target=1.0, absolute=0.01)),
            Row(case="passes of a device, carried out by the CPU, against its own: beams",
                ours=largest("simulated device"),
                form=ROUNDING,
                tolerance=AtMost(1e-12), note="no device was available"),
            Row(case="passes of a device, carried out by the CPU, against its own: cells",
                ours=largest("simulated cells"),
                form=ROUNDING,
                tolerance=AtMost(1e-12), note="no device was available"),
        ),
    )  # fmt: skip


def _relaxation() -> Section:
    size = STATIC.at("sizes", {"asked": 11_000})
    return Section(
        title="Relaxation",
        before="The bent bar has 10 000 elements; the force tolerance is 1e-6.",
        rows=(
            Row(case="relaxation against the static solution", form=ROUNDING, tolerance=AtMost(1e-5),
                ours=STATIC.of(size["relaxed from static, bent"]["displacement"])),
        ),
    )
