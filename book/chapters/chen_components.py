"""Chen et al. (2022): the unbonded component of the parallel bond, and damping component by component."""

from typing import Any

import numpy as np

from book.chapter import Chapter, Section
from book.forms import COUNT, ROUNDING, Form, Said
from book.results import record
from book.row import Row
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


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="chen_components",
        title="Chen et al. (2022): the unbonded component of the parallel bond, and damping by component",
        summary=(
            "The paper sets the unbonded component of PFC's parallel bond to zero in all of its cases (§3) and "
            "damps case 1 with γ_b = 0.001 alone; it gives no value of η_b. Here both are active for the cases of "
            "Table 3. `validation/measures/chen_one_sided.py` steps a row of spheres with bondem's own forces, "
            "because `bd.LinearContact` ignores bonded pairs and `bd.BondDamping` has one η for all components."
        ),
        misses=(
            "With the smallest damping the stop rule of the paper stops a run at a turning point of the vibration, "
            "so the tip changes by more than the last printed digit."
        ),
        sections=(_table_4(), _cases(), _gamma(), _eta()),
    )


def _explicit(component: str, **wanted: Any) -> list[dict[str, Any]]:
    where = {"component": component} | wanted
    return [one for one in UNBONDED.at("explicit") if all(one[key] == value for key, value in where.items())]


def _table_4() -> Section:
    static = UNBONDED.at("static", {"case": "1"})["tip"]
    rows = [
        Row(case="bond alone, tip of case 1, static", source="Table 4", paper=TABLE_4, printed="8.508 mm",
            ours=UNBONDED.of(static["bonded"]), form=MILLIMETRES, tolerance=Near(absolute=DIGIT)),
        Row(case="how far that is from 8.508 mm, in units of its last digit",
            ours=UNBONDED.of(abs(static["pressed"] - TABLE_4) / DIGIT), form=Form(style=".1f"),
            tolerance=AtLeast(1.0)),
    ]  # fmt: skip
    one_sided = f"one-sided component, μ = {UNBONDED.at('friction'):g}"
    for gamma in (0.5, 0.001):
        for name, words in (("bonded", "bond alone"), ("one-sided", one_sided)):
            (run,) = _explicit(name, case="1", push=0.0, gamma=gamma)
            rows.append(
                Row(case=f"{words}, explicit at 1 kN × 100, γ = {gamma:g}", source="Table 4", paper=TABLE_4,
                    printed="8.508 mm", ours=UNBONDED.of(100.0 * run["tip"]), form=MILLIMETRES,
                    tolerance=Near(absolute=DIGIT))
            )  # fmt: skip
    ten = UNBONDED.at("static", {"case": "3", "parameter": 10})["shear"]
    shear = Form("GN/m", 1e9, ".2f")
    rows.append(
        Row(case="10 bonds: shear stiffness, bond alone", source="Table 5", paper=24.17e9, form=shear,
            ours=UNBONDED.of(ten["bonded"]), tolerance=Near(absolute=0.01e9))
    )  # fmt: skip
    return Section(
        title="Tables 4 and 5 with the component and without",
        before=(
            "PFC's linear contact acts beside the bond where spheres touch: it is one-sided, has friction, and "
            "applies a force at the contact point without a moment of its own. In compression without slip it adds "
            "k = E′ π min(R_i, R_j)² / (R_i + R_j) to kn and k/κ′ to ks; E′ = E_b and κ′ = κ are our choice. The "
            "other cases of Table 5 have gaps, and no component. Explicit runs end when no sphere is faster than "
            "1e-9 m/s for a quarter of a period."
        ),
        rows=tuple(rows),
    )


def _cases() -> Section:
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
    rows = [
        Row(case="static, every case that touches, against the chain of springs", ours=UNBONDED.of(exact),
            form=ROUNDING, tolerance=AtMost(1e-6)),
        Row(case="explicit, the load alone: bonds under pressure at rest, all cases", form=COUNT,
            ours=UNBONDED.of(float(sum(one["closed_at_rest"] for one in across))), tolerance=AtMost(0.0)),
        Row(case="explicit, the load alone, all cases: largest change of the tip by the component",
            ours=UNBONDED.of(max(changed)), form=ROUNDING,
            tolerance=AtMost(1e-4)),
        Row(case="explicit, the load alone: opening of the bonds of case 4 against F sin θ / kn", form=ROUNDING,
            tolerance=AtMost(1e-3),
            ours=UNBONDED.of(max(one["gap_error"] for one in across if one["case"] == "4"))),
        Row(case="explicit, pushed along by 5 kN before: tip over that of the bond alone, against static, pressed",
            ours=UNBONDED.of(max(map(abs, ratio))), form=ROUNDING, tolerance=AtMost(1e-4)),
    ]  # fmt: skip
    return Section(
        title="Where the component acts",
        before=(
            "A transverse load stretches every bond of the bent beam by F sin θ: the contact opens and transmits "
            "nothing. A push along the beam closes the contact, and friction then transmits the shear."
        ),
        rows=tuple(rows),
    )


def _gamma() -> Section:
    particles = DAMPING.at("particles")
    rows = [
        Row(case=f"{law}, γ_b from 0.001 to 0.5: largest change of the tip", source="§3", paper="negligible",
            ours=DAMPING.of(max(abs(one["error"]) for one in particles if one["law"] == law)), form=FINE,
            tolerance=AtMost(DIGIT / TABLE_4),
            reason="the stop rule evaluates one instant, here a turning point of the vibration")
        for law in ("TBBM", "PBM")
    ]  # fmt: skip
    (held,) = _explicit("bonded", case="1", push=0.0, gamma=0.001)
    rows.append(
        Row(case="PBM, γ_b = 0.001, slow for a quarter of a period: change of the tip", source="§3",
            paper="negligible", ours=UNBONDED.of(held["tip"] / held["static"]["bonded"] - 1.0), form=ROUNDING,
            tolerance=AtMost(DIGIT / TABLE_4))
    )  # fmt: skip
    for law in ("TBBM", "PBM"):
        weak = [one for one in particles if one["law"] == law and one["gamma"] <= 0.03]
        loss = [np.log((1.0 + one["gamma"]) / (1.0 - one["gamma"])) for one in weak]
        slope = float(np.polyfit(np.log(loss), np.log([one["time"] - 1.0 for one in weak]), 1)[0])
        rows.append(
            Row(case=f"{law}: power of ln((1 + γ)/(1 − γ)) in the time after the ramp, γ ≤ 0.03",
                ours=DAMPING.of(slope), form=Form(style="+.2f"), tolerance=Near(target=-1.0, absolute=0.15))
        )  # fmt: skip
    names = (
        ("component", "the size of F_i with the sign of U_i: `LocalDamping`", True),
        ("vector", "the size of F along U", None),
        ("printed", "F_i U_i/U_i as printed (which is F_i)", False),
        ("signed", "F_i with the sign of U_i", False),
    )  # fmt: skip
    for name, words, rests in names:
        found = DAMPING.at("readings", {"reading": name})
        rows.append(
            Row(case=f"eq (11) with γ_b = 0.1, PBM, within 6 s: {words}", form=RESTS,
                ours=DAMPING.of(float(found["status"] == "STOPPED")), tolerance=None if rests is None else So(rests))
        )  # fmt: skip
    return Section(
        title="γ of the particles: case 1 at 1 kN",
        before=(
            "`LocalDamping` acts on each of the six components with the sign of its own velocity, as eqs (11) and "
            "(12) intend. The runs use the paper's ramp of 1 s and its stop rule, which evaluates one instant; the "
            "paper prints neither times nor steps."
        ),
        rows=tuple(rows),
    )


def _eta() -> Section:
    rows = []
    for one in DAMPING.at("bonds"):
        eta = " · ".join(f"{value:.3g}" for value in one["eta"].values())
        name = {"all": "η_b in all", "printed": "as printed"}.get(one["component"], f"η alone, of {one['component']}")
        idle = one["theory"] == 0.0
        rows.append(Row(case=f"{name}: {eta}", ours=DAMPING.of(one["rate"]), form=RATE,
                        tolerance=AtMost(0.05) if idle else Near(target=one["theory"], relative=0.05)))  # fmt: skip
    printed = DAMPING.at("bonds", {"component": "printed"})
    rows.append(
        Row(case="case 1, as printed with η_b = 0.5: tip at rest against static",
            ours=DAMPING.of(printed["error"]), form=ROUNDING, tolerance=AtMost(1e-4))
    )  # fmt: skip
    return Section(
        title="η of the bonds, one coefficient per component",
        before=(
            "The rows show the decay of the first bending mode of case 2 with 3 parallel bonds."
            " “In general, the damping coefficients in axial, shear, twisting and bending are not necessarily equal”"
            " (§2.1); the paper uses one for all “for simplicity”, gives it no value, and runs no case with it. Here"
            " η has a value for normal, shear, bending and twisting, each with the k of its component. Eqs (9) and"
            " (10) as printed are η_b times 1, √(kn/ks), √(2 kt/kb) and √2. Theory gives the decay as"
            " ω² Σ η_c √(m_c/k_c) s_c, with s_c the share of component c in the elastic energy."
        ),
        rows=tuple(rows),
    )
