"""Chen et al. (2022), Tables 3 to 5, and what its figures say in numbers: cantilevers of bonds."""

from typing import Any

from book.chapter import Chapter, Figure, Section
from book.forms import PERCENT, ROUNDING, Form, Said
from book.results import Measurement, record
from book.row import Measured, Row
from book.tolerances import AtMost, Near, So, Spans

TABLES = record("chen_tables", takes="2 s")
CASES = record("chen", drawn=True, takes="23–47 s")
MEASUREMENTS = (TABLES, CASES)

#: Table 3, a column a case: length [m], bond slenderness λ_b, radii of particles [m], of bonds [m], gaps.
TABLE_3: dict[str, tuple[tuple[float, float], tuple[float, float], tuple[float, float], float, bool]] = {
    "1": ((4, 4), (1, 1), (0.2, 0.2), 0.2, False),
    "2": ((0.4, 4), (1, 1), (0.2, 0.2), 0.2, False),
    "3": ((4, 4), (1, 5), (0.2, 0.2), 0.2, True),
    "4": ((4, 4), (2, 20), (0.2, 2), 0.1, False),
    "5": ((4, 4), (5, 5), (0.2, 0.8), 0.2, True),
}
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
LAWS = ("TBBM", "EBBM", "PBM", "Obermayr")


def digits(printed: str) -> int:
    """Decimals of a published number."""
    return len(printed.partition(".")[2])


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="chen_tables",
        title="Chen et al. (2022): cantilevers of bonds, Tables 3 to 5",
        summary=(
            "One kernel computes Timoshenko bonds (TBBM), Euler–Bernoulli bonds (EBBM) and parallel bonds (PBM) "
            "with E_b = 200 GPa, ν_b = 0.3 and F = 100 kN. The cases are those of Table 3 (a test compares them), "
            "except that Table 5 has one bond of λ_b = 10 in case 3, where Table 3 has 1–5. All five cases, laws "
            "and figures, and the elastica, are in [validation/chen.md](validation/chen.md)."
        ),
        misses=(
            "The tip of Timoshenko bonds printed in Table 4 lies above the exact value, which our beam elements "
            "reproduce. The printed share of figure 19 belongs to another Poisson's ratio than the stated one."
        ),
        sections=(table_4(TABLES, CASES), table_5(TABLES), _figures(), _exact()),
    )


def table_3(tables: Measurement) -> Section:
    """The cases as they are and as they are printed: for the fast part, which is a test."""
    printed = "Table 5 has one bond in case 3, 4 m long with a radius of 0.2 m: λ_b = 10"
    rows = []
    for case, (length, slenderness, radius, bond, gap) in TABLE_3.items():
        ours = {name: tables.of(*tables.at("table3", case, name)) for name in
                ("length", "slenderness", "element_radius", "bond_radius")}  # fmt: skip
        rows += [
            _span(case, "beam length", length, ours["length"], "m"),
            _span(case, "bond slenderness λ_b", slenderness, ours["slenderness"], "", printed if case == "3" else ""),
            _span(case, "particle radius", radius, ours["element_radius"], "m"),
            _span(case, "bond radius", (bond, bond), ours["bond_radius"], "m"),
            Row(case=f"case {case}: gap between particles", source="Table 3", paper="yes" if gap else "no",
                form=Said(), ours=tables.number("table3", case, "gap"), tolerance=So(gap)),
        ]  # fmt: skip
    return Section(title="Table 3: the cases", rows=tuple(rows))


def _span(case: str, what: str, printed: tuple[float, float], ours: Measured, unit: str, reason: str = "") -> Row:
    form = Form(unit, style=".4g")
    words = f"{printed[0]:g}–{printed[1]:g} {unit}" if printed[0] != printed[1] else f"{printed[0]:g} {unit}"
    return Row(case=f"case {case}: {what}", source="Table 3", paper=words.strip(), ours=ours, form=form,
               tolerance=Spans(*printed), reason=reason)  # fmt: skip


def table_4(tables: Measurement, runs: Measurement | None) -> Section:
    """Tips by statics and, where there are runs, by explicit dynamics."""
    millimetres = Form("mm", 1e-3, ".4f")
    above = "the paper's number lies above the exact value that beam elements reproduce"
    theory = tables.at("table4", {"law": "TBBM"})["timoshenko"]
    euler = tables.at("table4", {"law": "EBBM"})["exact"]
    theories = [
        Row(case="Timoshenko theory, eq (29)", source="Table 4", paper=8.534e-3, printed="8.534 mm",
            ours=tables.of(theory), form=millimetres, tolerance=Near(absolute=0.0005e-3)),
        Row(case="Euler–Bernoulli theory", source="Table 4", paper=8.488e-3, printed="8.488 mm",
            ours=tables.of(euler), form=millimetres, tolerance=Near(absolute=0.0005e-3)),
        Row(case="Euler–Bernoulli theory, distance from Timoshenko", source="Table 4", paper=0.0054,
            ours=tables.of(1.0 - euler / theory), form=PERCENT, tolerance=Near(absolute=5e-5)),
    ]  # fmt: skip
    # a closed form against itself is a test, not a row of the book
    rows = theories if runs is None else []
    for law, (tip, error) in TABLE_4.items():
        found = tables.at("table4", {"law": law})
        rows += [
            Row(case=f"{law}, tip, static", source="Table 4", paper=1e-3 * float(tip), printed=f"{tip} mm",
                ours=tables.of(found["tip"]), form=millimetres, tolerance=Near(absolute=0.001e-3), reason=above),
            Row(case=f"{law}, distance from Timoshenko", source="Table 4", paper=1e-2 * float(error), form=PERCENT,
                ours=tables.of(abs(found["error_timoshenko"])), tolerance=Near(absolute=1e-4), reason=above),
        ]  # fmt: skip
        if runs is not None:
            tip_run = 100.0 * runs.at("explicit", {"case": "1", "law": law})["tip"]
            rows.append(
                Row(case=f"{law}, tip, explicit at 1 kN × 100", source="Table 4", paper=1e-3 * float(tip),
                    printed=f"{tip} mm", ours=runs.of(tip_run), form=millimetres, tolerance=Near(absolute=0.001e-3),
                    reason=above)
            )  # fmt: skip
    return Section(
        title="Table 4: tip deflection of case 1",
        before="The required tolerance is one unit of the last printed digit.",
        rows=tuple(rows),
        figures=(Figure("chen_case1.png", "Case 1, deflection and error along the beam (figure 8)"),) if runs else (),
    )


def table_5(tables: Measurement) -> Section:
    """Stiffnesses of a bond."""
    rows = []
    for n, printed in TABLE_5.items():
        found = tables.at("table5", {"bonds": n})
        for name, number in zip(("axial", "PBM", "EBBM", "TBBM"), printed, strict=True):
            places = digits(number)
            words = "axial" if name == "axial" else f"shear, {name}"
            plural = "bonds" if n > 1 else "bond"
            rows.append(
                Row(case=f"{n} {plural}: {words}", source="Table 5", paper=1e9 * float(number),
                    ours=tables.of(found[name]), form=Form("GN/m", 1e9, f".{places}f"),
                    tolerance=Near(absolute=1e9 * 10.0**-places))
            )  # fmt: skip
    least, most = (tables.at("table5", {"bonds": n}) for n in (1, 10))
    for what, paper, ratio, room in (
        ("PBM over TBBM, 1 bond", 52.0, least["PBM"] / least["TBBM"], 0.5),
        ("PBM over TBBM, 10 bonds", 1.6, most["PBM"] / most["TBBM"], 0.05),
        ("EBBM over TBBM, 10 bonds", 3.1, most["EBBM"] / most["TBBM"], 0.07),
    ):
        rows.append(Row(case=f"shear stiffness, {what}", source="§4.1", paper=paper, ours=tables.of(ratio),
                        form=Form(style=".3g"), tolerance=Near(absolute=room)))  # fmt: skip
    return Section(
        title="Table 5: stiffness of a bond in case 3",
        before=(
            "The table is printed as GPa·m. Its last digit is sometimes truncated and sometimes rounded, so the "
            "tolerance is one unit of it."
        ),
        rows=tuple(rows),
    )


def _figures() -> Section:
    rows = []
    for law, paper in (("TBBM", 0.01), ("EBBM", 0.04), ("PBM", 0.04)):
        deflection = CASES.at("explicit", {"case": "1", "law": law})["deflection"]
        worst = max(abs(100.0 * y / _timoshenko(0.4 * k) - 1.0) for k, y in enumerate(deflection) if k)
        rows.append(Row(case=f"{law}, case 1: largest error along the beam", source="fig. 8b", paper=paper,
            printed=f"{100 * paper:.0f} %",
                        ours=CASES.of(worst), form=PERCENT, tolerance=AtMost()))  # fmt: skip
    case_5 = {d: {law: CASES.at("static", {"case": "5", "parameter": d, "law": law}) for law in LAWS} for d in (0.0,
        0.75, 1.5)}
    rows += [
        Row(case="TBBM, case 5: largest error", source="fig. 16", paper=0.001, printed="0.1 %", form=PERCENT,
            tolerance=AtMost(),
            ours=CASES.of(max(abs(found["TBBM"]["error_timoshenko"]) for found in case_5.values()))),
        Row(case="PBM, case 5, equal spheres, against 8.541 mm", source="fig. 16", paper=0.0062, form=PERCENT,
            ours=CASES.of(1.0 - case_5[0.0]["PBM"]["tip"] / 8.541e-3), tolerance=Near(absolute=1e-4),
            note="8.541 mm belongs to a form factor of 4/π; eq (29) with 10/9 is 8.534 mm, and PBM then 0.54 % off"),
    ]  # fmt: skip
    for nu, reason in ((0.3, "eq (35) itself gives 35.1 % at ν_b = 0.3; 38 % is its value at ν_b = 0.5"), (0.499999,
    "")):
        deep = CASES.at("shear", "slenderness", {"nu": nu, "slenderness": 1.0})
        rows.append(
            Row(case=f"EBBM, as long as wide, ν_b = {nu:.1f}: share of the deflection that is missing", paper=0.38,
                source="fig. 19, eq (35)", printed="38 %", ours=CASES.of(deep["missing"]), form=PERCENT,
                tolerance=Near(absolute=0.01), reason=reason)
        )  # fmt: skip
    names = {
        "chen_stiffness_ratio.png": "Axial over shear stiffness (figure 17)",
        "chen_slenderness.png": "Error of Euler–Bernoulli bonds (figure 19)",
    }
    return Section(
        title="What the figures say in numbers",
        rows=tuple(rows),
        figures=tuple(Figure(name, caption) for name, caption in names.items()),
    )


def _timoshenko(x: float) -> float:
    """Deflection of case 1 at x [m] after eq (28): E_b = 200 GPa, ν_b = 0.3, L_0 = 4 m, r_b = 0.2 m, 100 kN."""
    E, nu, L, r, F, pi = 200e9, 0.3, 4.0, 0.2, 100e3, 3.141592653589793
    bending = F * x**2 * (3.0 * L - x) / (6.0 * E * pi * r**4 / 4.0)
    return bending + 10.0 * F * x * 2.0 * (1.0 + nu) / (9.0 * E * pi * r**2)


def _exact() -> Section:
    static = max(abs(one["error"]) for one in CASES.at("static"))

    def moved(wanted: Any) -> Measured:
        return CASES.of(max(abs(one["error"]) for one in CASES.at("explicit") if wanted(one)))

    first = moved(lambda one: one["case"] == "1" and one["law"] in ("EBBM", "TBBM"))
    parallel = moved(lambda one: one["case"] == "1" and one["law"] == "PBM")
    rows = [
        Row(case="cases 1–5 static, each law against its exact value", ours=CASES.of(static), tolerance=AtMost(1e-6),
            form=ROUNDING),
        Row(case="case 1, explicit at 1 kN, the paper's ramp, γ = 0.001 and stop rule, EBBM and TBBM", ours=first,
            tolerance=AtMost(1e-3), form=Form(style=".2g")),
        Row(case="case 1, explicit at 1 kN, the paper's ramp, γ = 0.001 and stop rule, PBM", ours=parallel,
            tolerance=AtMost(1e-3), form=Form(style=".2g")),
        Row(case="cases 2–5, explicit at 1 kN", ours=moved(lambda one: one["case"] != "1"), tolerance=AtMost(1e-3),
            form=ROUNDING),
    ]  # fmt: skip
    for n, tolerance in ((1, None), (10, AtMost(1e-3)), (40, AtMost(1e-3))):
        found = CASES.at("large_rotations", {"force": 100e3, "law": "EBBM", "bonds": n})
        rows.append(Row(case=f"100 kN on a slender beam against the exact beam, {n} bond{'s' * (n > 1)}",
            ours=CASES.of(found["error"]),
                        form=Form(style="+.2g"), tolerance=tolerance))  # fmt: skip
    return Section(
        title="Against exact solutions",
        rows=tuple(rows),
        after="The error decreases with the square of the number of bonds.",
        figures=(Figure("chen_elastica.png", "Large rotations: error over the number of bonds"),),
    )
