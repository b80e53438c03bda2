"""Total against incremental formulation, and what Obermayr's bond tends to."""

import math

from book.chapter import Chapter, Figure, Section
from book.chapters.chen_tables import CASES
from book.forms import ROUNDING, Form
from book.results import record
from book.row import Row
from book.tolerances import AtMost, Near

DRIFT = record("incremental_drift", drawn=True, takes="2 min")
MEASUREMENTS = (DRIFT, CASES)

ORDER = Form(style=".2f")
TIMES = Form(style=".3g")


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="formulations",
        title="Total against incremental formulation, and Obermayr's bond",
        summary=(
            "The papers add rates of force step by step. Evaluated at the start of a step, these drift when a body "
            "turns; evaluated at the middle of a step, as in bondem's incremental formulation, the drift is of "
            "second order. After a closed cycle rates leave a residual force for any step; the energy of bondem's "
            "bonds does not. At small rotations both formulations agree. Details are in "
            "[validation/incremental.md](validation/incremental.md)."
        ),
        sections=(_turning(), _spinning(), _cycles(), _obermayr()),
    )


def _turning() -> Section:
    rows = []
    for body in ("rod", "lattice"):
        for form, tolerance in (("total", AtMost(1e-9)), ("incremental", None), ("as printed", None)):
            found = DRIFT.at("turning", {"body": body, "form": form, "steps_a_turn": 2048})
            style = ROUNDING if tolerance else TIMES
            rows.append(Row(case=f"{body}, {form}: error of the forces after ten turns", tolerance=tolerance,
                            ours=DRIFT.of(found["force_error"][-1]), form=style))  # fmt: skip
        for form, order in (("incremental", 2.0), ("as printed", 1.0)):
            rows.append(Row(case=f"{body}, {form}: order of the error of the forces in dt", form=ORDER,
                            ours=DRIFT.number("orders", f"turning, {body}, {form}: order in dt"),
                            tolerance=Near(target=order, absolute=0.1)))  # fmt: skip
    found = DRIFT.at("turning", {"body": "rod", "form": "as printed", "steps_a_turn": 8192})
    rows.append(
        Row(case="rod, as printed, 8192 steps per turn: error over that of a false strain 2π²N/S", form=ORDER,
            ours=DRIFT.of(found["force_error"][-1] / found["expected_as_printed"]),
            tolerance=Near(target=1.0, absolute=0.05))
    )  # fmt: skip
    return Section(
        title="Ten turns as a rigid body",
        before=(
            "The bodies are stretched, bent and twisted; every element is then driven along its exact circle, 2048 "
            "steps per turn."
        ),
        rows=tuple(rows),
        figures=(Figure("incremental_drift.png", "Where the incremental formulation drifts"),),
    )


def _spinning() -> Section:
    rows = []
    for body in ("rod", "lattice"):
        for form in ("total", "incremental"):
            found = DRIFT.at("spinning", {"body": body, "form": form, "share_of_critical": 0.8})
            rows += [
                Row(case=f"{body}, {form}: largest error of the energy", ours=DRIFT.of(found["largest_energy_error"]),
                    form=ROUNDING, tolerance=AtMost(1e-5)),
                Row(case=f"{body}, {form}: change of angular momentum", ours=DRIFT.of(found["momentum_error"]),
                    form=ROUNDING, tolerance=AtMost(1e-11)),
            ]  # fmt: skip
    return Section(
        title="Spinning freely through ten turns",
        before="Bodies spin freely at 0.8 of the critical step.",
        rows=tuple(rows),
    )


def _cycles() -> Section:
    small, larger = (DRIFT.at("small_rotations", {"strain": strain})["force_difference"] for strain in (1e-5, 1e-4))
    orders = DRIFT.at("orders")
    chosen = {"angle": 0.4, "steps_a_leg": 2000, "cycles": 10}
    return Section(
        title="Small rotations, closed cycles",
        rows=(
            Row(case="forces of both formulations at a strain of 1e-5, difference", form=ROUNDING,
                tolerance=AtMost(1e-4), ours=DRIFT.of(small)),
            Row(case="order in the strain of the difference of both formulations, 1e-5 to 1e-4", form=ORDER,
                tolerance=Near(target=1.0, absolute=0.05), ours=DRIFT.of(math.log10(larger / small))),
            Row(case="ten closed cycles of 0.4 rad, total: residual forces", form=ROUNDING,
                tolerance=AtMost(1e-9), ours=DRIFT.of(DRIFT.at("cycles", {"form": "total"} | chosen)["left"][-1])),
            Row(case="order in the angle of the residual forces, incremental", form=ORDER,
                tolerance=Near(target=1.0, absolute=0.05),
                ours=DRIFT.of(orders["cycles: order of what is left in the angle"]),
                note="it does not fall with dt: rotations do not commute, so rates do not add up to zero"),
        ),
        figures=(Figure("incremental_drift_cycles.png", "Residual forces after closed cycles"),),
    )  # fmt: skip


def _obermayr() -> Section:
    rows = [
        Row(case="Obermayr, case 3: order of the error of the tip in the number of bonds",
            ours=CASES.number("shear", "order_obermayr"),
            form=Form(style=".3f"), tolerance=Near(target=2.0, absolute=0.01)),
        # the error of 160 bonds is 1e-5, and a solution has 1e-10
        Row(case="Obermayr: largest distance of the error from −(1 − s)/4n², s the share of shear", form=ROUNDING,
            tolerance=AtMost(1e-5),
            ours=CASES.number("shear", "largest_distance", "Obermayr")),
        Row(case="parallel bonds: largest distance of the error from their limit and −(1 − s)/4n²", form=ROUNDING,
            tolerance=AtMost(1e-5), ours=CASES.number("shear", "largest_distance", "PBM")),
    ]  # fmt: skip
    return Section(
        title="Obermayr's bond, α_s = 9/10",
        before=(
            "Obermayr's bond is the limit of Timoshenko's bond for short bonds; it is exact in the limit of many "
            "bonds."
        ),
        rows=tuple(rows),
        figures=(Figure("chen_refinement.png", "Error of the tip over the number of bonds"),),
    )
