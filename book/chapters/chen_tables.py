"""Chen et al. (2022), Tables 3 to 5, and what its figures say in numbers: cantilevers of bonds."""

from book.forms import PERCENT, ROUNDING, Form
from book.results import record
from book.row import Measured, Row, Rows
from book.tolerances import AtMost, Near

TABLES = record("chen_tables", takes="2 s")
CASES = record("chen", drawn=True, takes="23–47 s")
MEASUREMENTS = (TABLES, CASES)

#: Table 4: law → tip [mm] and its distance from Timoshenko theory [%], as printed.
TABLE_4 = {"TBBM": ("8.537", "0.04"), "EBBM": ("8.489", "0.53"), "PBM": ("8.508", "0.30")}
#: Table 5: bonds → axial stiffness, shear stiffness of PBM, EBBM, TBBM [GN/m], as printed.
TABLE_5 = {
    1: ("6.283", "2.416", "0.04712", "0.04612"),
    2: ("12.56", "4.833", "0.3769", "0.3469"),
    4: ("25.13", "9.66", "3.016", "2.240"),
    6: ("37.69", "14.50", "10.18", "5.718"),
    8: ("50.26", "19.33", "24.13", "10.11"),
    10: ("62.83", "24.17", "47.12", "14.88"),
}


def table_4() -> Rows:
    """Tips by statics and by explicit dynamics."""
    millimetres = Form("mm", 1e-3, ".4f")
    above = "the paper's number lies above the exact value that beam elements reproduce"
    for law, (tip, error) in TABLE_4.items():
        found = TABLES.at("table4", {"law": law})
        yield Row(f"{law}, tip, static", TABLES.of(found["tip"]), Near(absolute=0.001e-3), millimetres,
            source="Table 4", paper=1e-3 * float(tip), printed=f"{tip} mm", reason=above)  # fmt: skip
        yield Row(f"{law}, distance from Timoshenko", TABLES.of(abs(found["error_timoshenko"])), Near(absolute=1e-4),
            PERCENT, source="Table 4", paper=1e-2 * float(error), reason=above)  # fmt: skip
        tip_run = 100.0 * CASES.at("explicit", {"case": "1", "law": law})["tip"]
        yield Row(f"{law}, tip, explicit at 1 kN × 100", CASES.of(tip_run), Near(absolute=0.001e-3), millimetres,
            source="Table 4", paper=1e-3 * float(tip), printed=f"{tip} mm", reason=above)  # fmt: skip


def table_5() -> Rows:
    """Stiffnesses of a bond."""
    for n, printed in TABLE_5.items():
        found = TABLES.at("table5", {"bonds": n})
        for name, number in zip(("axial", "PBM", "EBBM", "TBBM"), printed, strict=True):
            places = len(number.partition(".")[2])
            words = "axial" if name == "axial" else f"shear, {name}"
            yield Row(f"{n} bond{'s' * (n > 1)}: {words}", TABLES.of(found[name]), Near(absolute=1e9 * 10.0**-places),
                Form("GN/m", 1e9, f".{places}f"), source="Table 5", paper=1e9 * float(number))  # fmt: skip
    least, most = (TABLES.at("table5", {"bonds": n}) for n in (1, 10))
    for what, paper, ratio, room in (
        ("PBM over TBBM, 1 bond", 52.0, least["PBM"] / least["TBBM"], 0.5),
        ("PBM over TBBM, 10 bonds", 1.6, most["PBM"] / most["TBBM"], 0.05),
        ("EBBM over TBBM, 10 bonds", 3.1, most["EBBM"] / most["TBBM"], 0.07),
    ):
        yield Row(f"shear stiffness, {what}", TABLES.of(ratio), Near(absolute=room), Form(style=".3g"), source="§4.1",
            paper=paper)  # fmt: skip


def figures() -> Rows:
    for law, paper in (("TBBM", 0.01), ("EBBM", 0.04), ("PBM", 0.04)):
        deflection = CASES.at("explicit", {"case": "1", "law": law})["deflection"]
        worst = max(abs(100.0 * y / _timoshenko(0.4 * k) - 1.0) for k, y in enumerate(deflection) if k)
        yield Row(f"{law}, case 1: largest error along the beam", CASES.of(worst), AtMost(), PERCENT,
            source="fig. 8b", paper=paper, printed=f"{100 * paper:.0f} %")  # fmt: skip
    case_5 = {(one["parameter"], one["law"]): one for one in CASES.at("static") if one["case"] == "5"}
    worst = max(abs(case_5[d, "TBBM"]["error_timoshenko"]) for d in (0.0, 0.75, 1.5))
    yield Row("TBBM, case 5: largest error", CASES.of(worst), AtMost(), PERCENT, source="fig. 16", paper=0.001,
        printed="0.1 %")  # fmt: skip
    yield Row("PBM, case 5, equal spheres, against 8.541 mm", CASES.of(1.0 - case_5[0.0, "PBM"]["tip"] / 8.541e-3),
        Near(absolute=1e-4), PERCENT, source="fig. 16", paper=0.0062,
        note="8.541 mm belongs to a form factor of 4/π; eq (29) with 10/9 is 8.534 mm, and PBM then 0.54 % off")
    itself = "eq (35) itself gives 35.1 % at ν_b = 0.3; 38 % is its value at ν_b = 0.5"
    for nu, reason in ((0.3, itself), (0.499999, "")):
        deep = CASES.at("shear", "slenderness", {"nu": nu, "slenderness": 1.0})
        yield Row(f"EBBM, as long as wide, ν_b = {nu:.1f}: share of the deflection that is missing",
            CASES.of(deep["missing"]), Near(absolute=0.01), PERCENT, paper=0.38, source="fig. 19, eq (35)",
            printed="38 %", reason=reason)  # fmt: skip


def _timoshenko(x: float) -> float:
    """Deflection of case 1 at x [m] after eq (28): E_b = 200 GPa, ν_b = 0.3, L_0 = 4 m, r_b = 0.2 m, 100 kN."""
    E, nu, L, r, F, pi = 200e9, 0.3, 4.0, 0.2, 100e3, 3.141592653589793
    bending = F * x**2 * (3.0 * L - x) / (6.0 * E * pi * r**4 / 4.0)
    return bending + 10.0 * F * x * 2.0 * (1.0 + nu) / (9.0 * E * pi * r**2)


def exact() -> Rows:
    static = max(abs(one["error"]) for one in CASES.at("static"))

    def moved(case: bool, *laws: str) -> Measured:
        """Largest error of explicit runs of the first case, or of the others."""
        some = [one for one in CASES.at("explicit") if (one["case"] == "1") is case and one["law"] in laws]
        return CASES.of(max(abs(one["error"]) for one in some))

    yield Row("cases 1–5 static, each law against its exact value", CASES.of(static), AtMost(1e-6), ROUNDING)
    yield Row("case 1, explicit at 1 kN, the paper's ramp, γ = 0.001 and stop rule, EBBM and TBBM",
        moved(True, "EBBM", "TBBM"), AtMost(1e-3), Form(style=".2g"))  # fmt: skip
    yield Row("case 1, explicit at 1 kN, the paper's ramp, γ = 0.001 and stop rule, PBM", moved(True, "PBM"),
        AtMost(1e-3), Form(style=".2g"))  # fmt: skip
    yield Row("cases 2–5, explicit at 1 kN", moved(False, "EBBM", "TBBM", "PBM", "Obermayr"), AtMost(1e-3), ROUNDING)
    for n in (10, 40):
        found = CASES.at("large_rotations", {"force": 100e3, "law": "EBBM", "bonds": n})
        yield Row(f"100 kN on a slender beam against the exact beam, {n} bonds", CASES.of(found["error"]),
            AtMost(1e-3), Form(style="+.2g"))  # fmt: skip
