"""Total against incremental formulation, and what Obermayr's bond tends to."""

import math

from book.chapters.chen_tables import CASES
from book.forms import RATIO, ROUNDING, Form
from book.results import record
from book.row import Row, Rows
from book.tolerances import AtMost, Near

DRIFT = record("incremental_drift", drawn=True, takes="2 min")
MEASUREMENTS = (DRIFT, CASES)

ORDER = Form(style=".2f")


def turning() -> Rows:
    for body in ("rod", "lattice"):
        found = DRIFT.at("turning", {"body": body, "form": "total", "steps_a_turn": 2048})
        yield Row(f"{body}, total: error of the forces after ten turns", DRIFT.of(found["force_error"][-1]),
            AtMost(1e-9), ROUNDING)  # fmt: skip
        for form, order in (("incremental", 2.0), ("as printed", 1.0)):
            yield Row(f"{body}, {form}: order of the error of the forces in dt",
                DRIFT.number("orders", f"turning, {body}, {form}: order in dt"), Near(target=order, absolute=0.1),
                ORDER)  # fmt: skip
    found = DRIFT.at("turning", {"body": "rod", "form": "as printed", "steps_a_turn": 8192})
    yield Row("rod, as printed, 8192 steps per turn: error over that of a false strain 2π²N/S",
        DRIFT.of(found["force_error"][-1] / found["expected_as_printed"]), Near(target=1.0, absolute=0.05),
        ORDER)  # fmt: skip


def spinning() -> Rows:
    for body in ("rod", "lattice"):
        for form in ("total", "incremental"):
            found = DRIFT.at("spinning", {"body": body, "form": form, "share_of_critical": 0.8})
            yield Row(f"{body}, {form}: largest error of the energy", DRIFT.of(found["largest_energy_error"]),
                AtMost(1e-5), ROUNDING)  # fmt: skip
            yield Row(f"{body}, {form}: change of angular momentum", DRIFT.of(found["momentum_error"]), AtMost(1e-11),
                ROUNDING)  # fmt: skip


def cycles() -> Rows:
    small, larger = (DRIFT.at("small_rotations", {"strain": strain})["force_difference"] for strain in (1e-5, 1e-4))
    orders = DRIFT.at("orders")
    chosen = {"angle": 0.4, "steps_a_leg": 2000, "cycles": 10}
    yield Row("forces of both formulations at a strain of 1e-5, difference", DRIFT.of(small), AtMost(1e-4), ROUNDING)
    yield Row("order in the strain of the difference of both formulations, 1e-5 to 1e-4",
        DRIFT.of(math.log10(larger / small)), Near(target=1.0, absolute=0.05), ORDER)  # fmt: skip
    yield Row("ten closed cycles of 0.4 rad, total: residual forces",
        DRIFT.of(DRIFT.at("cycles", {"form": "total"} | chosen)["left"][-1]), AtMost(1e-9), ROUNDING)  # fmt: skip
    yield Row("order in the angle of the residual forces, incremental",
        DRIFT.of(orders["cycles: order of what is left in the angle"]), Near(target=1.0, absolute=0.05), ORDER,
        note="it does not fall with dt: rotations do not commute, so rates do not add up to zero")  # fmt: skip


def obermayr() -> Rows:
    yield Row("Obermayr, case 3: order of the error of the tip in the number of bonds",
        CASES.number("shear", "order_obermayr"), Near(target=2.0, absolute=0.01), RATIO)  # fmt: skip
    # the error of 160 bonds is 1e-5, and a solution has 1e-10
    yield Row("Obermayr: largest distance of the error from −(1 − s)/4n², s the share of shear",
        CASES.number("shear", "largest_distance", "Obermayr"), AtMost(1e-5), ROUNDING)  # fmt: skip
    yield Row("parallel bonds: largest distance of the error from their limit and −(1 − s)/4n²",
        CASES.number("shear", "largest_distance", "PBM"), AtMost(1e-5), ROUNDING)  # fmt: skip
