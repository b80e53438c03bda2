"""Tests with plates of Celigueta et al. (2020), with their own law."""

from book.chapters import celigueta_open
from book.chapters.celigueta_open import AREAS, OF_PLATES, packings
from book.forms import MPA, RATIO, SIGNED, Form
from book.results import grouped, record, study
from book.row import Row, Rows
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
    options="--count 20000 --seeds 1,2,3,4,5 --areas weighted --tests shear --processes 1",
)  # fmt: skip
CONE = study(
    "celigueta", {}, kept="celigueta_shear_cone",
    options="--count 0 --seeds 1 --areas weighted --tests shear --failures Mohr-Coulomb --processes 1 --threads 1",
)  # fmt: skip
SURFACES = record("yield_surfaces", drawn=True)
ELASTIC = record("non_local", "--count 500 --packings 5", takes="6 min")
MEASUREMENTS = (
    CELIGUETA, FULL, FACETS, SHEAR, CONE, SMALLER, *celigueta_open.MEASUREMENTS, SURFACES, ELASTIC
)  # fmt: skip
# What the tests are to take on two threads, compression and splitting, and shear after packing [s].
_MINUTES, _HOUR = 600.0, 3600.0
# What is asked of Laguerre areas up to this ν: E, and ν itself.
_UP_TO, _OF_E, _OF_NU = 0.4, 0.01, 0.005

MODULUS = Form("GPa", 1e9, ".2f")
SECONDS = Form("s", style=".0f")


def full() -> Rows:
    """The paper's sizes."""
    for kept, one in ((source, case) for source in (FULL, FACETS) for case in source.at("cases")):
        words = f"{one['test']}, {one['failure']}, {AREAS[one['areas']]}, {one['count'][0]} elements, {packings(one)}"
        yield Row(f"{words}: peak", kept.of(*one["peak"]), Near(relative=kept.at("limit")), MPA, source="§4",
            paper=one["measured"])  # fmt: skip
        if one["mean_E"]:
            yield Row(f"{words}: E of the curve", kept.of(*one["E_plates"]), Near(relative=kept.at("limit")), MODULUS,
                paper=38e9, source="§5.3")  # fmt: skip
        yield Row(f"{words}: force on the other plate over that at the peak", kept.of(*one["other"]),
            Near(absolute=OF_PLATES, target=1.0), RATIO)  # fmt: skip
        yield Row(f"{words}: time", kept.of(*one["run_seconds"]), AtMost(_MINUTES), SECONDS)


def shear() -> Rows:
    """The test of which the paper prints no number."""
    for kept, one in ((source, case) for source in (SHEAR, CONE, SMALLER) for case in source.at("cases")):
        words = f"{one['failure']}, {one['count'][0]} elements, {packings(one)}"
        yield Row(f"{words}: force on the other plate over that at the peak", kept.of(*one["other"]),
            Near(absolute=OF_PLATES, target=1.0), RATIO)  # fmt: skip
        if kept is not SMALLER:
            threads = "two threads, before its loop was vectorised" if kept is SHEAR else "one thread"
            yield Row(f"{words}: time on {threads}, packed", kept.of(*one["run_seconds"]), AtMost(_HOUR), SECONDS)


def surfaces() -> Rows:
    """Figure 9 of the paper."""
    for one in SURFACES.at("cases"):
        if one["closed"] is not None:
            off = one["found"] / one["closed"] - 1.0
            words = f"{one['criterion']}, {one['state']}: off {MPA.text(one['closed'])} of eqs (8), (9)"
            yield Row(words, SURFACES.of(off), AtMost(1e-9), Form(style=".0e"))


def elastic() -> Rows:
    """E and ν of bodies without walls."""
    found = [one for one in ELASTIC.at("elastic") if one["law"] == "facets" and one["nu_given"] <= _UP_TO]
    for (nu,), mine in sorted(grouped(found, "nu_given").items()):
        yield Row(f"Laguerre facets, ν = {nu:g}: error of E",
            ELASTIC.of(*(one["E"] / ELASTIC.at("E") - 1.0 for one in mine)), AtMost(_OF_E), SIGNED)  # fmt: skip
        yield Row(f"Laguerre facets, ν = {nu:g}: ν less that entered", ELASTIC.of(*(one["nu"] - nu for one in mine)),
            AtMost(_OF_NU), Form(style="+.4f"))  # fmt: skip


def strengths() -> Rows:
    for one in CELIGUETA.at("cases"):
        yield Row(f"{one['test']}, {one['failure']}, {AREAS[one['areas']]}: peak, {packings(one)}",
            CELIGUETA.of(one["mean"]["mean"], scatter=one["mean"]["std"]), Near(relative=CELIGUETA.at("limit")), MPA,
            source="§4", paper=one["measured"])  # fmt: skip


def moduli() -> Rows:
    for one in CELIGUETA.at("cases"):
        if one["mean_E"]:
            yield Row(f"{one['failure']}, {AREAS[one['areas']]}: E",
                CELIGUETA.of(one["mean_E"]["mean"], scatter=one["mean_E"]["std"]),
                Near(relative=CELIGUETA.at("limit")), MODULUS, paper=38e9, source="§5.3")  # fmt: skip
