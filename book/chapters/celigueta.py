"""Tests with plates of Celigueta et al. (2020), with their own law."""

from typing import Any

from book.chapter import Chapter, Figure, Section
from book.forms import Form
from book.results import Measurement, study
from book.row import Row
from book.tolerances import AtMost, Near

CELIGUETA = study(
    "celigueta",
    {"compression": "celigueta_compression", "splitting": "celigueta_splitting", "broken": "celigueta_broken"},
    options="--seeds 1,2,3",
)
FULL = study(
    "celigueta",
    {"compression": "celigueta_full_compression", "splitting": "celigueta_full_splitting",
     "broken": "celigueta_full_broken"},
    options="--count 0 --seeds 1,2,3,4,5 --areas weighted --processes 1", kept="celigueta_full",
)  # fmt: skip
FACETS = study(
    "celigueta", {}, options="--count 0 --seeds 1 --areas facet --processes 1", kept="celigueta_full_facets"
)
SHEAR = study(
    "celigueta", {"broken": "celigueta_shear_broken"}, kept="celigueta_shear",
    options="--count 0 --seeds 1 --areas weighted --tests shear --failures Rankine --processes 1 --threads 2",
)  # fmt: skip
SMALLER = study(
    "celigueta", {"shear": "celigueta_shear"}, kept="celigueta_shear_smaller",
    options="--count 20000 --seeds 1,2,3 --areas weighted --tests shear --processes 1",
)  # fmt: skip
CONE = study(
    "celigueta", {}, kept="celigueta_shear_cone",
    options="--count 0 --seeds 1 --areas weighted --tests shear --failures Mohr-Coulomb --processes 1 --threads 1",
)  # fmt: skip
SLOWER = study("celigueta", {}, options="--seeds 1 --areas weighted --slower 1,2,4", kept="celigueta_slower")
FULL_SLOWER = study(
    "celigueta", {}, options="--count 0 --seeds 1 --areas weighted --slower 1,2 --processes 1",
    kept="celigueta_full_slower",
)  # fmt: skip
REACH = Measurement(
    "non_local_reach", "python benchmarks/non_local_reach.py && python benchmarks/non_local_reach.py --summary",
    "8 min",
)  # fmt: skip
PLATENS = study(
    "celigueta", {}, kept="celigueta_platens",
    options="--count 1000 --seeds 1,2,3 --areas weighted --failures Rankine --platens 0,0.1,0.3 --processes 1",
)  # fmt: skip
NOISE = Measurement("non_local_noise", "python benchmarks/non_local_noise.py", "3 min")
SURFACES = Measurement("yield_surfaces", "python benchmarks/yield_surfaces.py --figures docs/figures")
ELASTIC = Measurement("non_local", "python benchmarks/non_local.py --count 500 --packings 5", "6 min")
MEASUREMENTS = (
    CELIGUETA, FULL, FACETS, SHEAR, CONE, SMALLER, SLOWER, FULL_SLOWER, PLATENS, NOISE, REACH, SURFACES, ELASTIC
)  # fmt: skip
# What is asked of plates half as fast: how far peaks may change, and forces of both plates differ.
_OF_SPEED, _OF_PLATES = 0.03, 0.02
# What the tests are to take on two threads, compression and splitting, and shear after packing [s].
_MINUTES, _HOUR = 600.0, 3600.0
# What is asked of Laguerre areas up to this ν: E, and ν itself.
_UP_TO, _OF_E, _OF_NU = 0.4, 0.01, 0.005

STRESS, MODULUS = Form("MPa", 1e6, ".2f"), Form("GPa", 1e9, ".2f")
SECONDS = Form("s", style=".0f")
SHARE, RATIO = Form(style=".3f"), Form(style=".2f")
_AREAS = {"weighted": "the authors' areas", "facet": "Laguerre facets"}


def chapter() -> Chapter:
    """The chapter."""
    cases: list[dict[str, Any]] = CELIGUETA.at("cases")
    pressed = [one for one in cases if one["mean_E"]]
    return Chapter(
        name="celigueta",
        title="Celigueta et al. (2020)",
        summary=(
            "A concrete cylinder pressed along its axis and across it, with the non-local law and the criteria and"
            " parameters of the paper: at its sizes, 12 000 and 9000 elements, and more of it at"
            f" {CELIGUETA.at('count')}. The paper prints what was measured on the concrete, and shows its own peaks,"
            " in figures, in good agreement; rows are held against what was measured, within 10 %. Of its shear test"
            " no number is printed."
        ),
        sections=(
            _full(),
            _shear(),
            Section(
                title="Strengths at 1000 elements",
                before=(
                    "Rankine with 6 MPa, Mohr and Coulomb with 14.5 MPa and 60°; friction 0.1; plates at 0.05 and 0.1"
                    " m/s. Local damping 0.3, contacts with a tenth of critical damping (the paper: restitution 0),"
                    " 2400 kg/m³ and a reach of 1.3 are not from the paper. The splitting stress is that of eq (7) at"
                    " the largest force of the run, which ends after 0.25 mm: with facets it falls at the first crack"
                    " and rises again until then (figure)."
                ),
                rows=tuple(
                    Row(case=f"{one['test']}, {one['failure']}, {_AREAS[one['areas']]}: peak, {_seeds(one)}",
                        source="§4", paper=one["measured"], form=STRESS,
                        ours=CELIGUETA.of(one["mean"]["mean"], scatter=one["mean"]["std"]),
                        tolerance=Near(relative=CELIGUETA.at("limit")))
                    for one in cases
                ),
                figures=(
                    Figure("celigueta_compression.png", "Uniaxial compression: stress over strain between plates"),
                    Figure("celigueta_splitting.png", "Splitting: stress of eq (7) over time"),
                    Figure("celigueta_broken.png", "Slices through the middle of the first packing after each test"),
                ),
            ),
            Section(
                title="Young's modulus of the curve",
                before="Between the plates, contact with them included, from 20 to 50 % of the peak; 40 GPa go in.",
                rows=tuple(
                    Row(case=f"{one['failure']}, {_AREAS[one['areas']]}: E", paper=38e9, source="§5.3",
                        ours=CELIGUETA.of(one["mean_E"]["mean"], scatter=one["mean_E"]["std"]), form=MODULUS,
                        tolerance=Near(relative=CELIGUETA.at("limit")))
                    for one in pressed
                ),
            ),
            _speed(),
            _platens(),
            _noise(),
            _reach(),
            _surfaces(),
            _elastic(),
        ),
    )  # fmt: skip


def _seeds(one: dict[str, Any]) -> str:
    seeds = ", ".join(str(seed) for seed in one["seed"])
    return f"packing{'s' if len(one['seed']) > 1 else ''} {seeds}"


def _full() -> Section:
    """The paper's sizes."""
    rows = []
    for kept, one in ((source, case) for source in (FULL, FACETS) for case in source.at("cases")):
        words = f"{one['test']}, {one['failure']}, {_AREAS[one['areas']]}, {one['count'][0]} elements, {_seeds(one)}"
        rows.append(Row(case=f"{words}: peak", source="§4", paper=one["measured"], form=STRESS,
                        ours=kept.of(*one["peak"]), tolerance=Near(relative=kept.at("limit"))))  # fmt: skip
        if one["mean_E"]:
            rows.append(Row(case=f"{words}: E of the curve", paper=38e9, source="§5.3", form=MODULUS,
                            ours=kept.of(*one["E_plates"]), tolerance=Near(relative=kept.at("limit"))))  # fmt: skip
        rows += [
            Row(case=f"{words}: force on the other plate over that at the peak", ours=kept.of(*one["other"]),
                form=SHARE, tolerance=Near(absolute=_OF_PLATES, target=1.0)),
            Row(case=f"{words}: time", ours=kept.of(*one["run_seconds"]), form=SECONDS, tolerance=AtMost(_MINUTES)),
        ]  # fmt: skip
    return Section(
        title="The paper's sizes",
        before=(
            "Plates at 0.05 and 0.1 m/s; what the paper leaves open is as below. Times are of two threads or of one,"
            " beside other work."
        ),
        rows=tuple(rows),
        figures=(
            Figure("celigueta_full_compression.png", "Compression of 12 000 elements: stress over strain"),
            Figure("celigueta_full_splitting.png", "Splitting of 9000 elements: stress of eq (7) over time"),
            Figure("celigueta_full_broken.png", "Slices through the middle of the first packing after each test,"
                   " coloured by what has moved to the left and to the right, motion drawn twenty times"),
        ),
    )  # fmt: skip


def _shear() -> Section:
    """The test of which the paper prints no number."""
    rows = []
    for kept, one in ((source, case) for source in (SHEAR, CONE, SMALLER) for case in source.at("cases")):
        words = f"{one['failure']}, {one['count'][0]} elements, {_seeds(one)}"
        rows.append(Row(case=f"{words}: mean shear stress at the peak", form=STRESS, ours=kept.of(*one["peak"])))
        rows.append(Row(case=f"{words}: force on the other plate over that at the peak", ours=kept.of(*one["other"]),
                        form=SHARE, tolerance=Near(absolute=_OF_PLATES, target=1.0)))  # fmt: skip
        if kept is not SMALLER:
            threads = "two threads, before its loop was vectorised" if kept is SHEAR else "one thread"
            rows.append(Row(case=f"{words}: time on {threads}, packed", ours=kept.of(*one["run_seconds"]),
                            form=SECONDS, tolerance=AtMost(_HOUR)))  # fmt: skip
    return Section(
        title="Shear",
        before=(
            "A cylinder Ø150 × 80 mm with ring borings 4 mm wide and 10 mm deep at Ø45 mm; a piston pushes its core"
            " out at 0.1 m/s. The paper draws the test and prints neither the width of the piston nor that of the"
            " hole, nor a strength: here they are as wide as the inner and the outer edge of a boring, 41 and 49 mm."
            " The stress is the force over π · 45 mm · 60 mm. A ring tears open first, and then the core is sheared"
            " off: the peak is a limit load. Packings of 2000 and 5000 elements, tried first, had no more than two"
            " elements under the piston, by a defect of the shape that is mended."
        ),
        rows=tuple(rows),
        figures=(
            Figure("celigueta_shear.png", "Mean shear stress over the strain between the plates"),
            Figure("celigueta_shear_broken.png", "161 000 elements after the test, a slice through the middle,"
                   " coloured by what has moved to the left and to the right, motion drawn twenty times"),
        ),
    )  # fmt: skip


def _slower(kept: Measurement) -> list[Row]:
    cases = kept.at("cases")
    first = {(one["test"], one["failure"]): one["peak"][0] for one in cases if one["slower"] == 1.0}
    rows = []
    for one in cases:
        speed = "the paper's speed" if one["slower"] == 1.0 else f"{one['slower']:g} times slower"
        words = f"{one['test']}, {one['failure']}, {one['count'][0]} elements, {speed}"
        if one["slower"] != 1.0:
            change = one["peak"][0] / first[one["test"], one["failure"]] - 1.0
            rows.append(Row(case=f"{words}: change of the peak", ours=kept.of(change), form=Form("%", 1e-2, "+.1f"),
                            tolerance=AtMost(_OF_SPEED) if one["slower"] == 2.0 else None))  # fmt: skip
        rows.append(Row(case=f"{words}: force on the other plate over that at the peak", form=SHARE,
                        ours=kept.of(*one["other"]), tolerance=Near(absolute=_OF_PLATES, target=1.0)))  # fmt: skip
    return rows


def _speed() -> Section:
    """Plates more slowly."""
    rows = [row for kept in (SLOWER, FULL_SLOWER) for row in _slower(kept)]
    return Section(
        title="Speed of the plates",
        before=(
            f"{SLOWER.at('count')} elements and the paper's numbers, packing 1, the authors' areas: the speed of the"
            " paper, half and a quarter of it. In splitting, plates of the paper's speed make the disc oscillate (its"
            " curves have waves), by which the forces of both plates differ."
        ),
        rows=tuple(rows),
    )


def _platens() -> Section:
    """Friction of the plates alone."""
    rows = [
        Row(case=f"{one['test']}, plates of friction {one['friction']:g}, elements 0.1: peak, {_seeds(one)}",
            ours=PLATENS.of(*one["peak"]), form=STRESS)
        for one in PLATENS.at("cases")
    ]  # fmt: skip
    return Section(
        title="Friction of the plates",
        before=(
            f"{PLATENS.at('count')} elements, Rankine, the authors' areas; friction between elements stays 0.1."
            " Smooth plates take a fifth off the compressive strength, more than 0.1 adds nothing, and splitting does"
            " not mind."
        ),
        rows=tuple(rows),
    )


def _noise() -> Section:
    """Why a Rankine criterion breaks what is pressed."""
    rows = []
    for areas, words in _AREAS.items():
        ones = [one for one in NOISE.at("cases") if one["areas"] == areas]
        told = f"{words}, {ones[0]['count']} elements, {_seeds({'seed': [one['seed'] for one in ones]})}"
        rows += [
            Row(case=f"{told}: σ1 over the stress of the plates that {name} of the bonds stay below", form=SHARE,
                ours=NOISE.of(*(one["quantiles"][key] for one in ones)))
            for key, name in (("0.5", "half"), ("0.99", "99 %"), ("0.999", "99.9 %"))
        ] + [Row(case=f"{told}: bonds above 6 / 55", ours=NOISE.of(*(one["above"] for one in ones)),
                 form=Form("%", 1e-2, ".2f"))]  # fmt: skip
    return Section(
        title="How much of a Rankine strength in compression is noise",
        before=(
            "In a uniform body in uniaxial compression σ1 is zero, and no pressure meets Rankine's criterion. The"
            " cylinder at 20 MPa, nothing broken, bonds of its middle half: with the authors' areas one bond in"
            " eighty has σ1 above 6 / 55 of the stress, so that 6 MPa are 55 MPa; with Laguerre facets none has,"
            " stresses scatter a quarter to a sixth as much, and the same criterion bears 2.5 times as much at full"
            " size. The compressive strength of this law with Rankine's criterion is the noise of its stresses, and"
            " the ratio of both strengths a property of the construction."
        ),
        rows=tuple(rows),
    )


def _reach() -> Section:
    """Sizes by gaps over which spheres are bonded."""
    cases = REACH.at("cases")
    counts, reaches = (sorted({one[key] for one in cases}) for key in ("count", "reach"))
    head = ("elements", *(f"reach {reach:g}: z" + " | E [GPa] | peak [MPa]" for reach in reaches))
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * (1 + 3 * len(reaches))]
    for count in counts:
        cells = [str(count)]
        for reach in reaches:
            some = [one for one in cases if (one["count"], one["reach"]) == (count, reach)]
            cells += [_of(some, "z", 1.0, ".1f"), _of(some, "E_plates", 1e9, ".1f"), _of(some, "peak", 1e6, ".1f")]
        lines.append("| " + " | ".join(cells) + " |")
    numbers = sorted({one["seed"] for one in cases})
    seeds = ", ".join(map(str, numbers))

    def ratios(above: tuple[int, float], below: tuple[int, float]) -> list[float]:
        peaks = {(one["count"], one["reach"], one["seed"]): one["peak"] for one in cases}
        return [peaks[*above, seed] / peaks[*below, seed] for seed in numbers]

    rows = [
        Row(case=f"{count} elements: peak with a reach of {reaches[-1]:g} over that with {reaches[0]:g}", form=RATIO,
            ours=REACH.of(*ratios((count, reaches[-1]), (count, reaches[0]))))
        for count in counts
    ] + [
        Row(case=f"reach of {reach:g}: peak of {counts[-1]} elements over that of {counts[0]}", form=RATIO,
            ours=REACH.of(*ratios((counts[-1], reach), (counts[0], reach))))
        for reach in reaches
    ]  # fmt: skip
    return Section(
        title="Sizes and gaps",
        rows=tuple(rows),
        before=(
            "Compression, Rankine with 6 MPa, the authors' areas: spheres at most so many (R1 + R2) apart are bonded,"
            f" z is the coordination number; packings {seeds}, one after the other. The paper does not print the"
            " gaps that it bonds. 40 GPa go in, and 55 MPa were measured.\n\n" + "\n".join(lines)
        ),
    )


def _of(some: list[dict[str, Any]], key: str, unit: float, style: str) -> str:
    return ", ".join("–" if one[key] is None else format(one[key] / unit, style) for one in some)


def _surfaces() -> Section:
    """Figure 9 of the paper."""
    rows = []
    for one in SURFACES.at("cases"):
        if one["closed"] is not None:
            off = one["found"] / one["closed"] - 1.0
            words = f"{one['criterion']}, {one['state']}: off {STRESS.text(one['closed'])} of eqs (8), (9)"
            rows.append(Row(case=words, ours=SURFACES.of(off), form=Form(style=".0e"),
                            tolerance=AtMost(1e-9)))  # fmt: skip
    return Section(
        title="Yield surfaces",
        before=(
            "Where `bd.failure_index` says that a bond breaks, found by bisection along rays from the hydrostatic"
            " axis (and from no stress in the plane); stresses of a bond's two elements in random directions, up to"
            " 5 MPa off their mean to both sides. With 14.5 MPa and 60° a body in uniform compression would bear 108"
            " MPa, with Rankine's 6 MPa any pressure: what bodies bear above rests on stresses that are not uniform."
        ),
        rows=tuple(rows),
        figures=(Figure("celigueta_surfaces.png", "Both criteria in the space of principal stresses (figure 9 of"
                        " the paper), down to a mean stress of −46 MPa, and in the plane σ3 = 0"),),
    )  # fmt: skip


def _elastic() -> Section:
    """What comes back of E and ν where there are no walls."""
    found = ELASTIC.at("elastic")
    rows = []
    for nu in sorted({one["nu_given"] for one in found}):
        for law, words in (("facets", "Laguerre facets"), ("weighted", "the authors' areas")):
            mine = [one for one in found if (one["law"], one["nu_given"]) == (law, nu) and one["E"] is not None]
            if not mine:
                continue
            asked = law == "facets" and nu <= _UP_TO
            rows += [
                Row(case=f"{words}, ν = {nu:g}: error of E", form=Form("%", 1e-2, "+.2f"),
                    ours=ELASTIC.of(*(one["E"] / ELASTIC.at("E") - 1.0 for one in mine)),
                    tolerance=AtMost(_OF_E) if asked else None),
                Row(case=f"{words}, ν = {nu:g}: ν less that put in", form=Form(style="+.4f"),
                    ours=ELASTIC.of(*(one["nu"] - nu for one in mine)), tolerance=AtMost(_OF_NU) if asked else None),
            ]  # fmt: skip
    seeds = ", ".join(str(seed) for seed in sorted({one["seed"] for one in found}))
    return Section(
        title="E and ν in a periodic cell",
        before=(
            f"{ELASTIC.at('count')} elements, seeds {seeds}, from the least to the largest; at rest, so that no lag"
            " counts. The paper prints 38 of 40 GPa for its construction; here its spheres are bonded up to a reach"
            f" of {ELASTIC.at('reach'):g}. When explicit runs are stable, by ν and damping, is in"
            " [the page of the law](non_local.md)."
        ),
        rows=tuple(rows),
    )
