"""Strengths and fracture energies of bodies of cells, entered and measured in tests to failure."""

import math
from statistics import fmean

from book.forms import PERCENT, PLAIN, RATIO, Form, Said, listed
from book.outcomes import TESTS, holds, range_of
from book.results import grouped, record
from book.row import Row, Rows
from book.tolerances import AtLeast, AtMost, Near, So

STRENGTH = record("strength", takes="2 h")
BRAZILIAN = record("brazilian", "--seeds 1,2,3,4,5", takes="5 min")
DISCS = record("disc_finite_elements", takes="10 s")
FACTORS = record("load_factors", "--counts 300,1000 --seeds 1,2,3,4,5 --steps 0.01 --ripples 0.02", takes="10 min")
MEASUREMENTS = (STRENGTH, BRAZILIAN, DISCS, FACTORS, TESTS)

#: What is asked for: of strengths, of the mean of the fracture energies, of each of them, and of the ledger [-].
LIMIT, EACH, CLOSES = 0.05, 0.08, 1e-3
_TITLES = {
    "tension": "plain bar", "notched": "notched bar", "slit": "bar with a slit",
    "brittle": "plain bar, brittle facets", "compression": "uniaxial compression", "triaxial": "triaxial compression",
}  # fmt: skip
SMALL = Form(style=".1e")
_KEYS = "energy", "pressure", "count"


def pairs() -> Rows:
    yes = Said("yes", "no")
    yield Row("strength agrees with the closed form to 1e-9", holds("closed form"), So(), yes)
    yield Row("a run breaks within one increment of the closed form", holds("within one increment"), So(), yes)
    yield Row("order of the energy balance through breakage, beams and cells", range_of("order"), AtLeast(1.7),
        Form(style=".2f"))  # fmt: skip


def tension() -> Rows:
    yield from _rows(("tension", "notched", "brittle"), "strength")
    yield from _rows(("tension", "notched"), "energy")


def compression() -> Rows:
    return _rows(("compression", "triaxial"), "strength")


def brazilian() -> Rows:
    for (energy, count), ones in sorted(grouped(BRAZILIAN.at("cases"), "energy", "count").items()):
        size = ones[0]["length"]
        split = next(one["strength"] for one in DISCS.at("discs") if math.isclose(one["share"], size))
        yield Row(f"G_f = {PLAIN.bare(energy)} J/m², E G_f / f_t² = {PLAIN.bare(size)} D, {count} elements,"
            f" seeds {listed(one['seed'] for one in ones)}: strength", BRAZILIAN.each(ones, "strength"),
            Near(relative=0.04), RATIO, paper=split, source="finite elements")  # fmt: skip


def _groups(*kinds: str) -> list[tuple[str, list[dict]]]:
    """What tests were, and their results for all seeds, in the order of kind, energy, pressure and size."""
    groups = grouped([one for one in STRENGTH.at("cases") if one["kind"] in kinds], "kind", *_KEYS)
    order = sorted(groups, key=lambda group: (list(_TITLES).index(group[0]), *group[1:]))
    return [(_told(groups[group]), groups[group]) for group in order]


def _told(ones: list[dict]) -> str:
    kind, energy, pressure, count = (ones[0][key] for key in ("kind", *_KEYS))
    told = [_TITLES[kind]]
    if energy:
        told.append(f"G_{'f' if kind in ('tension', 'notched') else 'II'} = {PLAIN.bare(energy)} J/m²")
    if pressure:
        told.append(f"{PLAIN.bare(pressure / 1e6)} MPa")
    return f"{', '.join(told)}, {count} elements, seeds {listed(one['seed'] for one in ones)}"


def toughness() -> Rows:
    for kind in ("slit", "notched"):
        groups = [(case, ones) for case, ones in _groups(kind) if "toughness" in ones[0]]
        mean = fmean(fmean(one["toughness"] for one in ones) for _, ones in groups)
        for case, ones in groups:
            yield Row(f"{case}: toughness over {mean:.3f}", STRENGTH.of(*(one["toughness"] / mean for one in ones)),
                Near(absolute=LIMIT, target=1.0), RATIO)  # fmt: skip


def still() -> Rows:
    for case in FACTORS.at("cases"):
        of = f"notched bar, {case['count']} cells, seed {case['seed']}"
        for bands in (0.02,), (0.05, 0.1, 0.2):
            some = [one for one in case["load factors"] if one["ripple"] in bands]
            if not some:
                continue
            steps = f"band of ± {listed(format(100.0 * one['ripple'], 'g') for one in some)} %"
            off = FACTORS.of(*(abs(one["over explicit"] - 1.0) for one in some))
            yield Row(f"{of}, {steps}: peak off that of an explicit run", off, AtMost(0.01), PERCENT)
        (grown,) = case["displacements"]
        yield Row(f"{of}, displacement steps of 1 %: peak off that of an explicit run",
            FACTORS.of(abs(grown["over explicit"] - 1.0)), AtMost(0.01), PERCENT)  # fmt: skip


def ledger() -> Rows:
    for case, ones in _groups(*_TITLES):
        yield Row(f"{case}: residual", STRENGTH.each(ones, "residual"), AtMost(CLOSES), SMALL)


def _rows(kinds: tuple[str, ...], quantity: str) -> Rows:
    for told, ones in _groups(*kinds):
        if quantity not in ones[0]["ratios"]:
            continue
        values = [one["ratios"][quantity] for one in ones]
        if quantity == "energy":
            yield Row(f"{told}: {quantity}, mean", STRENGTH.of(sum(values) / len(values)),
                Near(absolute=LIMIT, target=1.0), RATIO)  # fmt: skip
        yield Row(f"{told}: {quantity}", STRENGTH.of(*values),
            Near(absolute=EACH if quantity == "energy" else LIMIT, target=1.0), RATIO)  # fmt: skip
