"""Chen et al. (2022): the unbonded component of the parallel bond, and damping component by component."""

from typing import Any

import numpy as np

from book.forms import COUNT, ROUNDING, Form, Said
from book.results import record
from book.row import Row, Rows
from book.tolerances import AtLeast, AtMost, Near, So

UNBONDED = record("chen_unbonded", takes="2–8 min")
DAMPING = record("chen_damping", takes="3–10 min")
MEASUREMENTS = (UNBONDED, DAMPING)

MILLIMETRES = Form("mm", 1e-3, ".4f")
FINE = Form("%", 1e-2, ".4f")
RATE = Form("1/s", style=".4g")
RESTS = Said("comes to rest", "does not")
#: PBM in Table 4, and one unit of its last digit [m].
TABLE_4, DIGIT = 8.508e-3, 0.001e-3


def _explicit(component: str, **wanted: Any) -> list[dict[str, Any]]:
    where = {"component": component} | wanted
    return [one for one in UNBONDED.at("explicit") if all(one[key] == value for key, value in where.items())]


def table_4() -> Rows:
    static = UNBONDED.at("static", {"case": "1"})["tip"]
    yield Row("bond alone, tip of case 1, static", UNBONDED.of(static["bonded"]), Near(absolute=DIGIT), MILLIMETRES,
        source="Table 4", paper=TABLE_4, printed="8.508 mm")  # fmt: skip
    yield Row("how far that is from 8.508 mm, in units of its last digit",
        UNBONDED.of(abs(static["pressed"] - TABLE_4) / DIGIT), AtLeast(1.0), Form(style=".1f"))  # fmt: skip
    one_sided = f"one-sided component, μ = {UNBONDED.at('friction'):g}"
    for gamma in (0.5, 0.001):
        for name, words in (("bonded", "bond alone"), ("one-sided", one_sided)):
            (run,) = _explicit(name, case="1", push=0.0, gamma=gamma)
            yield Row(f"{words}, explicit at 1 kN × 100, γ = {gamma:g}", UNBONDED.of(100.0 * run["tip"]),
                Near(absolute=DIGIT), MILLIMETRES, source="Table 4", paper=TABLE_4, printed="8.508 mm")  # fmt: skip
    ten = UNBONDED.at("static", {"case": "3", "parameter": 10})["shear"]
    shear = Form("GN/m", 1e9, ".2f")
    yield Row("10 bonds: shear stiffness, bond alone", UNBONDED.of(ten["bonded"]), Near(absolute=0.01e9), shear,
        source="Table 5", paper=24.17e9)  # fmt: skip


def cases() -> Rows:
    across = _explicit("one-sided", push=0.0)
    alone = {(one["case"], one["parameter"], one["gamma"]): one["tip"] for one in _explicit("bonded", push=0.0)}
    changed = [abs(one["tip"] / alone[one["case"], one["parameter"], one["gamma"]] - 1.0) for one in across]
    pushed = _explicit("one-sided", push=5e3)
    before = {(one["case"], one["parameter"]): one["tip"] for one in _explicit("bonded", push=5e3)}
    ratio = [
        one["tip"] / before[one["case"], one["parameter"]] * one["static"]["bonded"] / one["static"]["pressed"] - 1.0
        for one in pushed
    ]
    static = [one for one in UNBONDED.at("static") if one["touching"]]
    exact = max(abs(one["tip"][name] / one["exact"][name] - 1.0) for one in static for name in ("bonded", "pressed"))
    yield Row("static, every case that touches, against the chain of springs", UNBONDED.of(exact), AtMost(1e-6),
        ROUNDING)  # fmt: skip
    yield Row("explicit, the load alone: bonds under pressure at rest, all cases",
        UNBONDED.of(float(sum(one["closed_at_rest"] for one in across))), AtMost(0.0), COUNT)  # fmt: skip
    yield Row("explicit, the load alone, all cases: largest change of the tip by the component",
        UNBONDED.of(max(changed)), AtMost(1e-4), ROUNDING)  # fmt: skip
    yield Row("explicit, the load alone: opening of the bonds of case 4 against F sin θ / kn",
        UNBONDED.of(max(one["gap_error"] for one in across if one["case"] == "4")), AtMost(1e-3),
        ROUNDING)  # fmt: skip
    yield Row("explicit, pushed along by 5 kN before: tip over that of the bond alone, against static, pressed",
        UNBONDED.of(max(map(abs, ratio))), AtMost(1e-4), ROUNDING)  # fmt: skip


def gamma() -> Rows:
    particles = DAMPING.at("particles")
    for law in ("TBBM", "PBM"):
        yield Row(f"{law}, γ_b from 0.001 to 0.5: largest change of the tip",
            DAMPING.of(max(abs(one["error"]) for one in particles if one["law"] == law)), AtMost(DIGIT / TABLE_4),
            FINE, source="§3", paper="negligible",
            reason="the stop rule evaluates one instant, here a turning point of the vibration")  # fmt: skip
    (held,) = _explicit("bonded", case="1", push=0.0, gamma=0.001)
    yield Row("PBM, γ_b = 0.001, slow for a quarter of a period: change of the tip",
        UNBONDED.of(held["tip"] / held["static"]["bonded"] - 1.0), AtMost(DIGIT / TABLE_4), ROUNDING, source="§3",
        paper="negligible")  # fmt: skip
    for law in ("TBBM", "PBM"):
        weak = [one for one in particles if one["law"] == law and one["gamma"] <= 0.03]
        loss = [np.log((1.0 + one["gamma"]) / (1.0 - one["gamma"])) for one in weak]
        slope = float(np.polyfit(np.log(loss), np.log([one["time"] - 1.0 for one in weak]), 1)[0])
        yield Row(f"{law}: power of ln((1 + γ)/(1 − γ)) in the time after the ramp, γ ≤ 0.03", DAMPING.of(slope),
            Near(target=-1.0, absolute=0.15), Form(style="+.2f"))  # fmt: skip
    for name, words, rests in (
        ("component", "the size of F_i with the sign of U_i: `LocalDamping`", True),
        ("printed", "F_i U_i/U_i as printed (which is F_i)", False),
        ("signed", "F_i with the sign of U_i", False),
    ):
        found = DAMPING.at("readings", {"reading": name})
        yield Row(f"eq (11) with γ_b = 0.1, PBM, within 6 s: {words}",
            DAMPING.of(float(found["status"] == "STOPPED")), So(rests), RESTS)  # fmt: skip


def eta() -> Rows:
    for one in DAMPING.at("bonds"):
        eta = " · ".join(f"{value:.3g}" for value in one["eta"].values())
        name = {"all": "η_b in all", "printed": "as printed"}.get(one["component"], f"η alone, of {one['component']}")
        idle = one["theory"] == 0.0
        yield Row(f"{name}: {eta}", DAMPING.of(one["rate"]),
            AtMost(0.05) if idle else Near(target=one["theory"], relative=0.05), RATE)  # fmt: skip
    printed = DAMPING.at("bonds", {"component": "printed"})
    yield Row("case 1, as printed with η_b = 0.5: tip at rest against static", DAMPING.of(printed["error"]),
        AtMost(1e-4), ROUNDING)  # fmt: skip
