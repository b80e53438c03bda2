"""One concrete in laboratory tests: strengths of the continuum and of bodies of cells."""

import math
from collections.abc import Callable

from book.chapter import Chapter, Figure, Section
from book.forms import PERCENT, PLAIN, Form
from book.results import record
from book.row import Measured, Row
from book.tolerances import AtMost, Between, Near

CONCRETE = record("concrete", drawn=True, takes="1 h")
BENDING = record(
    "bending_energy", "--together 0.01", "--ripples 0.02 --together 0.005",
    "--counts 10000 --seeds 1 --ripples 0.02 --together 0.005", takes="15 min",
)
MESOSCALE = record("mesoscale", "--seeds 1 --fractions 0", "--seeds 1,2 --fractions 0.2", takes="25 min")
MEASUREMENTS = CONCRETE, BENDING, MESOSCALE

#: What is asked of strengths and of stiffnesses over theory, and of the stress at the centre of a disc [-].
LIMIT, ELASTIC = 0.05, 0.03
RATIO, STRESS = Form(style=".3f"), Form(unit="MPa", scale=1e6, style=".2f")
GPA = Form(unit="GPa", scale=1e9, style=".2f")
_Ones = list[dict]


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="concrete",
        title="Concrete: laboratory tests",
        summary=(
            "One concrete is described by five numbers: E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 7.4 MPa and φ = "
            "59.8°. A Mohr–Coulomb continuum needs this c and φ for the 55 MPa in compression and 4 MPa in tension "
            "that Celigueta et al. (2020) measured; their own c = 14.5 MPa and φ = 60° are calibrated parameters "
            "of bonds. They publish no fracture energy: G_f = 100 J/m² is assumed, and G_II = 10 G_f is the "
            "default. Nothing is calibrated, and no seed was left out."
        ),
        misses=(
            "The Brazilian strength is too low, because a disc of this Mohr–Coulomb material yields at its centre "
            "before the tension reaches f_t. With a criterion whose line passes above f_t discs of 2000 cells, whose "
            "process zone is 2.5 diameters long, are too strong. The notched beam dissipates too much with the "
            "former, wide band of softening steps."
        ),
        sections=(_compression(), _tension(), _brazilian(), _bending(), _work(), _shear(), _mesoscale()),
    )


def _groups(kind: str) -> list[tuple[str, _Ones]]:
    """Results of all seeds of a kind, by pressure and size, and what they are."""
    groups: dict[tuple[float, int], _Ones] = {}
    for one in CONCRETE.at("cases"):
        if one["kind"] == kind:
            groups.setdefault((one["pressure"], one["count"]), []).append(one)
    return [(_told(pressure, ones), ones) for (pressure, _), ones in sorted(groups.items())]


def _told(pressure: float, ones: _Ones) -> str:
    confined = f"{PLAIN.bare(pressure / 1e6)} MPa, " if pressure else ""
    return f"{confined}{ones[0]['count']} cells, seeds {', '.join(str(one['seed']) for one in ones)}"


def _of(ones: _Ones, value: Callable[[dict], float]) -> Measured:
    return CONCRETE.of(*(value(one) for one in ones))


def _compression() -> Section:
    rows = [
        Row(case=f"UCS: {told}", ours=_of(ones, lambda one: one["peak"]), form=STRESS, source="§4.1", paper=55e6,
            printed="55 MPa", tolerance=Near(absolute=2e6))
        for told, ones in _groups("ucs")
    ]  # fmt: skip
    rows += [
        Row(case=f"{name}, {told}: strength over the Mohr–Coulomb line", ours=_of(ones, lambda one: one["ratio"]),
            form=RATIO, tolerance=Near(absolute=LIMIT, target=1.0))
        for kind, name in (("ucs", "UCS"), ("triaxial", "triaxial")) for told, ones in _groups(kind)
    ]  # fmt: skip
    return Section(
        title="Compression with and without lateral pressure",
        before=(
            "Cylinders of Ø100 × 200 mm are compressed between smooth platens; the cylinder of the paper has 12 "
            "000 spheres. The Mohr–Coulomb line is (2 c cos φ + p (1 + sin φ)) / (1 − sin φ): 55, 82, 124 and 192 "
            "MPa."
        ),
        rows=tuple(rows),
        figures=(
            Figure("concrete_ucs.png", "Uniaxial compression: damage of the largest specimen, curves of all"),
            Figure("concrete_triaxial.png", "Triaxial compression at 5 MPa: damage, curves of all"),
        ),
    )


def _tension() -> Section:
    rows: list[Row] = []
    for told, ones in _groups("tension"):
        rows += [
            Row(case=f"strength over f_t: {told}", ours=_of(ones, lambda one: one["ratio"]), form=RATIO,
                tolerance=Near(absolute=LIMIT, target=1.0)),
            Row(case=f"work over the section and G_f: {told}", ours=_of(ones, lambda one: one["work"] / _energy()),
                form=RATIO, tolerance=Near(absolute=LIMIT, target=1.0)),
        ]  # fmt: skip
    return Section(
        title="Direct tension",
        before="The same cylinder is pulled.",
        rows=tuple(rows),
        figures=(Figure("concrete_tension.png", "Direct tension: damage, curves of all"),),
    )


def _energy() -> float:
    return CONCRETE.number("material", "fracture_energy").values[0]


def _brazilian() -> Section:
    onset = CONCRETE.number("onset").values[0]
    reason = (
        "at the centre of a disc, where the stress is (0, −3 s, s), the line through 55 and 4 MPa is reached at"
        f" s = c cos φ / (2 − sin φ) = {STRESS.text(onset)}: cells yield before the tension reaches f_t. Other rows"
        " compare with that stress, and with c = 14.3 MPa, φ = 35°, whose line passes above f_t, with f_t"
    )
    rows: list[Row] = []
    for told, ones in _groups("brazilian"):
        rows += [
            Row(case=f"2 P / (π D t): {told}", ours=_of(ones, lambda one: one["peak"]), form=STRESS, source="§4.2",
                paper=4e6, printed="4 MPa", tolerance=Near(absolute=0.3e6), reason=reason),
            Row(case=f"tension at the centre at the peak over {STRESS.text(onset)}: {told}", form=RATIO,
                ours=_of(ones, lambda one: one["tension"] / one["onset"]),
                tolerance=Near(absolute=LIMIT, target=1.0)),
        ]  # fmt: skip
    rows += [
        Row(case=f"c = 14.3 MPa, φ = 35°, 2 P / (π D t) over f_t: {told}", form=RATIO,
            ours=_of(ones, lambda one: one["ratio"]), tolerance=Near(absolute=0.075, target=1.0),
            note="with cohesive cracks, discs of ordinary concrete of 0.1 m carry up to 25 % more than f_t between"
                 " strips wider than 4 % of the diameter (Rocco et al. 1999); this one has D = 0.4 E G_f / f_t²")
        for told, ones in _groups("cut_off")
    ]  # fmt: skip
    for kind, name in (("brazilian", ", the default"), ("narrow", ""), ("wide", "")):
        for told, ones in _groups(kind):
            off = _of(ones, lambda one: abs(one["centre"] / one["factor"] - 1.0))
            degrees = f"{math.degrees(ones[0]['half_angle']):.1f}°"
            strips = f"strips of α = {degrees}{name}"
            rows.append(
                Row(case=f"{strips}, {told}: elastic stress at the centre off that under stamps", ours=off,
                    form=PERCENT, tolerance=AtMost(ELASTIC))
            )  # fmt: skip
    return Section(
        title="Brazilian test",
        before=(
            "The same cylinder is compressed across a diameter, as in the paper (9000 spheres there). Smooth "
            "platens hold two strips of its side along the load. The strips span 5° to both sides, or three "
            "quarters of a cell where that is more; they lower the stress at the centre by the factor of a smooth "
            "rigid stamp."
        ),
        rows=tuple(rows),
        figures=(Figure("concrete_brazilian.png", "Brazilian test: damage of the largest specimen, curves of all"),),
    )


def _bending() -> Section:
    rows: list[Row] = []
    for kind, what in (("bending", "plain"), ("notched", "notched")):
        for told, ones in _groups(kind):
            rows.append(Row(case=f"work over the ligament and G_f, {what}: {told}", form=RATIO,
                            ours=_of(ones, lambda one: one["work"] / _energy()),
                            tolerance=Near(absolute=2.0 * LIMIT, target=1.0)))  # fmt: skip
            if kind == "bending":
                rows.append(Row(case=f"E by beam theory over that entered: {told}", form=RATIO,
                                ours=_of(ones, lambda one: one["E"]),
                                tolerance=Near(absolute=ELASTIC, target=1.0)))  # fmt: skip
    return Section(
        title="Three-point bending",
        before=(
            "Beams of 400 × 100 × 100 mm over a span of 300 mm, plain and with a notch of a third of the depth, "
            "are computed by load factors, without speed and inertia. The flexural strength exceeds f_t because "
            "the ligament softens (E G_f / f_t² is 2.5 times the depth); it has no closed form. Cells are a sixth "
            "of the depth."
        ),
        rows=tuple(rows),
        figures=(
            Figure("concrete_bending.png", "Bending of a plain beam: damage, curves of all"),
            Figure("concrete_notched.png", "Bending of a notched beam: damage, curves of all"),
        ),
    )


def _work() -> Section:
    groups: dict[tuple[int, float, float], _Ones] = {}
    for one in BENDING.at("cases"):
        groups.setdefault((one["count"], one["ripple"], one["together"]), []).append(one)
    rows: list[Row] = []
    for (count, ripple, together), ones in sorted(groups.items()):
        told = f"{count} cells, seeds {', '.join(str(one['seed']) for one in ones)}, band of {ripple:g}, {together:g}"
        told += " together"
        rows.append(
            Row(case=f"{told}: work over the ligament and G_f", ours=_mean(ones, lambda one: one["work"]), form=RATIO,
                tolerance=Near(absolute=2.0 * LIMIT, target=1.0))
        )  # fmt: skip
        if count >= 10_000:
            rows.append(Row(case=f"to a twentieth of the peak, one core: {told}", form=Form(unit="s", style=".0f"),
                            ours=_mean(ones, lambda one: one["seconds"]), tolerance=AtMost(600.0)))  # fmt: skip
    return Section(
        title="Work of a notched beam",
        before=(
            "The notched beams are computed to a twentieth of the peak. No cell yields and no closed crack slides "
            "there, so all work is that of facets and of the elastic energy at the end (0.04 to 0.06). With a band "
            "of 0.1, the former default of the test, the work was up to 1.12. Three quarters of the depth of the "
            "ligament are fully cracked in each run; shares beside the crack refer to these."
        ),
        rows=tuple(rows),
        after=(
            "The crack is not longer than the ligament and dissipates no more than G_f. The work above 1 is "
            "dissipated beside it: by facets that lose integrity and unload as the crack passes, fewer with a "
            "narrow band; by facets below the tip, as cells of the smaller bodies are three times as wide as the "
            "notch; and in the uppermost quarter, whose facets under the roller dissipate up to 1.09 of its share "
            "with a band of 0.1. Both bands end at a twentieth of the peak; the share of their difference that is "
            "due to the end was not measured. Events dissipate a few per cent more than their steps, perhaps "
            "because facets open further in the event that weakens them (not tested separately); all energies "
            "include this. Cracks away from the main crack are not the cause (none begins two cells away from it), "
            "nor are facets that begin late (0.003)."
        ),
    )


def _mean(ones: _Ones, value: Callable[[dict], float]) -> Measured:
    return BENDING.of(*(value(one) for one in ones))


def _shear() -> Section:
    rows: list[Row] = []
    for told, ones in _groups("shear"):
        rows.append(
            Row(case=f"E of the elastic body of equal stiffness over that entered: {told}",
                ours=_of(ones, lambda one: one["E"]),
                form=RATIO, tolerance=Near(absolute=LIMIT, target=1.0))
        )  # fmt: skip
    return Section(
        title="Shear test",
        before=(
            "The specimen is that of the paper, Ø150 × 80 mm with ring borings 10 mm deep and 4 mm wide at Ø45 mm "
            "in both ends (161 000 spheres there). The stress is the load over π · 45 mm · 60 mm; the paper prints "
            "no target. The core is 41 mm wide between its borings. Under 55 MPa without lateral support it would "
            "be crushed at 8.6 MPa of mean shear stress. Coarse cells (9 mm with 2000 and 4 mm with 20 000) do not "
            "resolve its ends, and the limit load still decreases with their size."
        ),
        rows=tuple(rows),
        figures=(Figure("concrete_shear.png", "Shear test: damage inside of the largest specimen, curves of all"),),
    )


def _mesoscale() -> Section:
    """Mortar, aggregates and the interface as three materials."""
    rows: list[Row] = []
    cases = MESOSCALE.at("cases")
    for test, fraction in {(one["test"], one["fraction"]): None for one in cases}:
        some = [one for one in cases if (one["test"], one["fraction"]) == (test, fraction)]
        seeds = ", ".join(str(one["seed"]) for one in some)
        what = f"{100 * fraction:g} % aggregates" if fraction else "mortar alone"
        words = f"{test.replace('_', ' ')}, {what}, {some[0]['cells']} cells, seed{'s' * (len(some) > 1)} {seeds}"
        if not fraction:
            continue
        if test == "direct_tension":
            low, high = max(one["bounds"][0] for one in some), min(one["bounds"][1] for one in some)
            rows.append(Row(case=f"{words}: E", form=GPA, ours=MESOSCALE.of(*(one["E"] for one in some)),
                            tolerance=Between(low, high)))  # fmt: skip
    return Section(
        title="Three materials in one body",
        before=(
            "The study is [mesoscale.toml](../examples/mesoscale.toml): mortar of 25 GPa, 4 MPa and 50 MPa, "
            "aggregates of 70 GPa and 12 MPa with 8 to 16 mm by a grading curve, and an interface of 2 MPa and μ = "
            "0.6. A prism of 80 × 40 × 40 mm is pulled and compressed, a disc of Ø60 × 30 mm is split; each "
            "packing has its own aggregates. E must lie within the bounds of Hashin and Shtrikman (1963). Cracks "
            "follow the aggregates and cross the mortar between them. The friction of opened interfaces decides in "
            "compression: packing 1 with smooth interfaces had 24.1 MPa (2.95 split, 2.99 pulled), less than half "
            "of its mortar. A share of aggregates of 0.3 was tried first and does not fit with cells of this size."
        ),
        rows=tuple(rows),
    )
