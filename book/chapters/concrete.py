"""One concrete in laboratory tests: strengths of the continuum and of bodies of cells."""

import math

from book.forms import MPA, PERCENT, PLAIN, RATIO, Form, listed, seeds
from book.results import grouped, record
from book.row import Measured, Row, Rows
from book.tolerances import AtMost, Between, Near

CONCRETE = record("concrete", drawn=True, takes="1 h")
BENDING = record(
    "bending_energy",
    "--together 0.01",
    "--ripples 0.02 --together 0.005",
    "--counts 10000 --seeds 1 --ripples 0.02 --together 0.005",
    takes="15 min",
)
MESOSCALE = record("mesoscale", "--seeds 1 --fractions 0", "--seeds 1,2 --fractions 0.2", takes="25 min")
MEASUREMENTS = CONCRETE, BENDING, MESOSCALE

#: What is asked of strengths and of stiffnesses over theory, and of the stress at the centre of a disc [-].
LIMIT, ELASTIC = 0.05, 0.03
GPA = Form(unit="GPa", scale=1e9, style=".2f")
_Ones = list[dict]


def _groups(kind: str) -> list[tuple[str, _Ones]]:
    """Results of all seeds of a kind, by pressure and size, and what they are."""
    some = [one for one in CONCRETE.at("cases") if one["kind"] == kind]
    return [
        (_told(pressure, ones), ones) for (pressure, _), ones in sorted(grouped(some, "pressure", "count").items())
    ]


def _told(pressure: float, ones: _Ones) -> str:
    confined = f"{PLAIN.bare(pressure / 1e6)} MPa, " if pressure else ""
    return f"{confined}{ones[0]['count']} cells, seeds {listed(one['seed'] for one in ones)}"


def _energies(ones: _Ones) -> Measured:
    """Works over the section and the fracture energy."""
    energy = CONCRETE.at("material", "fracture_energy")
    return CONCRETE.of(*(one["work"] / energy for one in ones))


def compression() -> Rows:
    for told, ones in _groups("ucs"):
        yield Row(f"UCS: {told}", CONCRETE.each(ones, "peak"), Near(absolute=2e6), MPA, source="§4.1", paper=55e6,
            printed="55 MPa")  # fmt: skip
    for kind, name in (("ucs", "UCS"), ("triaxial", "triaxial")):
        for told, ones in _groups(kind):
            yield Row(f"{name}, {told}: strength over the Mohr–Coulomb line", CONCRETE.each(ones, "ratio"),
                Near(absolute=LIMIT, target=1.0), RATIO)  # fmt: skip


def tension() -> Rows:
    for told, ones in _groups("tension"):
        yield Row(f"strength over f_t: {told}", CONCRETE.each(ones, "ratio"), Near(absolute=LIMIT, target=1.0), RATIO)
        yield Row(f"work over the section and G_f: {told}", _energies(ones), Near(absolute=LIMIT, target=1.0), RATIO)


def brazilian() -> Rows:
    onset = CONCRETE.at("onset")
    reason = (
        "at the centre of a disc, where the stress is (0, −3 s, s), the line through 55 and 4 MPa is reached at"
        f" s = c cos φ / (2 − sin φ) = {MPA.text(onset)}: cells yield before the tension reaches f_t. Other rows"
        " compare with that stress, and with c = 14.3 MPa, φ = 35°, whose line passes above f_t, with f_t"
    )
    for told, ones in _groups("brazilian"):
        yield Row(f"2 P / (π D t): {told}", CONCRETE.each(ones, "peak"), Near(absolute=0.3e6), MPA, source="§4.2",
            paper=4e6, printed="4 MPa", reason=reason)  # fmt: skip
        yield Row(f"tension at the centre at the peak over {MPA.text(onset)}: {told}",
            CONCRETE.of(*(one["tension"] / one["onset"] for one in ones)), Near(absolute=LIMIT, target=1.0),
            RATIO)  # fmt: skip
    for told, ones in _groups("cut_off"):
        yield Row(f"c = 14.3 MPa, φ = 35°, 2 P / (π D t) over f_t: {told}", CONCRETE.each(ones, "ratio"),
            Near(absolute=0.075, target=1.0), RATIO,
            note="with cohesive cracks, discs of ordinary concrete of 0.1 m carry up to 25 % more than f_t between"
            " strips wider than 4 % of the diameter (Rocco et al. 1999); this one has D = 0.4 E G_f / f_t²")
    for kind, name in (("brazilian", ", the default"), ("narrow", ""), ("wide", "")):
        for told, ones in _groups(kind):
            off = CONCRETE.of(*(abs(one["centre"] / one["factor"] - 1.0) for one in ones))
            degrees = f"{math.degrees(ones[0]['half_angle']):.1f}°"
            strips = f"strips of α = {degrees}{name}"
            yield Row(f"{strips}, {told}: elastic stress at the centre off that under stamps", off, AtMost(ELASTIC),
                PERCENT)  # fmt: skip


def bending() -> Rows:
    for kind, what in (("bending", "plain"), ("notched", "notched")):
        for told, ones in _groups(kind):
            yield Row(f"work over the ligament and G_f, {what}: {told}", _energies(ones),
                Near(absolute=2.0 * LIMIT, target=1.0), RATIO)  # fmt: skip
            if kind == "bending":
                yield Row(f"E by beam theory over that entered: {told}", CONCRETE.each(ones, "E"),
                    Near(absolute=ELASTIC, target=1.0), RATIO)  # fmt: skip


def work() -> Rows:
    groups = grouped(BENDING.at("cases"), "count", "ripple", "together")
    for (count, ripple, together), ones in sorted(groups.items()):
        band = f"band of {ripple:g}, {together:g} together"
        told = f"{count} cells, seeds {listed(one['seed'] for one in ones)}, {band}"
        yield Row(f"{told}: work over the ligament and G_f", BENDING.each(ones, "work"),
            Near(absolute=2.0 * LIMIT, target=1.0), RATIO)  # fmt: skip
        if count >= 10_000:
            yield Row(f"processor time to a twentieth of the peak: {told}", BENDING.each(ones, "processor seconds"),
                AtMost(600.0), Form(unit="s", style=".0f"))  # fmt: skip


def shear() -> Rows:
    for told, ones in _groups("shear"):
        yield Row(f"E of the elastic body of equal stiffness over that entered: {told}", CONCRETE.each(ones, "E"),
            Near(absolute=LIMIT, target=1.0), RATIO)  # fmt: skip


def mesoscale() -> Rows:
    """Mortar, aggregates and the interface as three materials."""
    cases = [one for one in MESOSCALE.at("cases") if one["fraction"] and one["test"] == "direct_tension"]
    for (fraction,), some in grouped(cases, "fraction").items():
        low, high = max(one["bounds"][0] for one in some), min(one["bounds"][1] for one in some)
        words = f"{some[0]['cells']} cells, {seeds([one['seed'] for one in some])}"
        yield Row(f"direct tension, {100 * fraction:g} % aggregates, {words}: E", MESOSCALE.each(some, "E"),
            Between(low, high), GPA)  # fmt: skip
