"""The bond's energy, and explicit dynamics with loads, damping and a limit to its step."""

from book.forms import PERCENT, RATIO, ROUNDING, Form, Said
from book.outcomes import TESTS, holds, largest, range_of
from book.results import Measurement, record
from book.row import Row, Rows
from book.tolerances import AtMost, Near, So

DRIFT = record("energy_drift", takes="7 min on one core")
HIGHEST = Measurement("highest_frequency", "python benchmarks/highest_frequency.py", "1 min")
STATIC = Measurement("static_solve", "python benchmarks/static_solve.py 11000 --repeat 0", "20 s")
MEASUREMENTS = (DRIFT, HIGHEST, STATIC, TESTS)

ORDER = Form(style=".2f")
SAME = Said("the same bits", "other bits")


def energy() -> Rows:
    yield Row("gradient against finite differences", largest("gradient"), AtMost(1e-8), ROUNDING)
    yield Row("second derivative at rest against the 12×12 matrix", largest("hessian"), AtMost(1e-8), ROUNDING)
    yield Row("force under rigid motion", largest("rigid motion"), AtMost(1e-12), ROUNDING)
    yield Row("momentum over 10 000 steps", largest("momentum"), AtMost(1e-12), ROUNDING, note="rounding is required")
    yield Row("angular momentum over 10 000 steps", largest("angular momentum"), AtMost(1e-12), ROUNDING,
        note="rounding is required")  # fmt: skip
    yield Row("order of the energy error of a rod in large rotation", range_of("order of a tumbling rod"),
        Near(target=2.0, absolute=0.1), ORDER)  # fmt: skip
    yield Row("order of the energy balance with loads, drives, damping", range_of("order of the ledger"),
        Near(target=2.0, absolute=0.1), ORDER)  # fmt: skip
    yield Row("1 to 4 threads over 10 000 steps, any pausing, resumed runs", holds("same bits"), So(), SAME)


def drift() -> Rows:
    yield Row("order of the energy error over dt, 9200 elements", DRIFT.of(*DRIFT.at("orders")),
        Near(target=2.0, absolute=0.1), RATIO)  # fmt: skip
    yield Row("drift of the energy over 1 000 000 steps in its standard errors",
        DRIFT.number("drift, in its standard errors"), AtMost(2.0), ORDER,
        note="none beyond rounding is required")  # fmt: skip


def loads() -> Rows:
    yield Row("absorbing boundary, plane P pulse: reflected energy", largest("energy that comes back, plane wave"),
        AtMost(0.02), PERCENT)  # fmt: skip
    yield Row("absorbing boundary, pulse in a thin bar: reflected energy",
        largest("energy that comes back, thin bar"), AtMost(0.02), PERCENT)  # fmt: skip
    yield Row("heated bar, free: growth over ε*", largest("heated bar, free"), Near(target=1.0, absolute=0.01), RATIO)
    yield Row("heated bar, clamped: stress over −Eε*", largest("heated bar, clamped"),
        Near(target=1.0, absolute=0.01), RATIO)  # fmt: skip
    yield Row("heated chain, clamped: error of the stress", largest("heated chain"), AtMost(1e-9), ROUNDING)


def stability() -> Rows:
    yield Row("limit with dashpots of bonds, √(1 + ζ²) − ζ: at 0.99 of it", holds("stable at 0.99 of the limit"),
        So(), Said("stable", "unstable"))  # fmt: skip
    yield Row("limit with dashpots of bonds, √(1 + ζ²) − ζ: at 1.01 of it", holds("unstable at 1.01 of the limit"),
        So(), Said("unstable", "stable"))  # fmt: skip
    yield Row("ω_max of the lattice over its exact value, 100 000 elements",
        HIGHEST.of(*HIGHEST.at("over exact").values()), Near(target=1.0, absolute=0.01), RATIO,
        note="from above, so a step is never too long")  # fmt: skip
    yield Row("ω_max of small lattices of five laws over its exact value", range_of("highest frequency"),
        Near(target=1.0, absolute=0.01), RATIO)  # fmt: skip
    yield Row("passes of a device, carried out by the CPU, against its own: beams", largest("simulated device"),
        AtMost(1e-12), ROUNDING, note="no device was available")  # fmt: skip
    yield Row("passes of a device, carried out by the CPU, against its own: cells", largest("simulated cells"),
        AtMost(1e-12), ROUNDING, note="no device was available")  # fmt: skip


def relaxation() -> Rows:
    size = STATIC.at("sizes", {"asked": 11_000})
    yield Row("relaxation against the static solution", STATIC.of(size["relaxed from static, bent"]["displacement"]),
        AtMost(1e-5), ROUNDING)  # fmt: skip
