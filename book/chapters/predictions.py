"""A concrete, a granite and a glass: a few numbers of each, and every test that these are to predict."""

from typing import Any

from book.chapters import rapid_fracture
from book.chapters.concrete import CONCRETE
from book.chapters.fracture import FRACTURE, SIZES
from book.chapters.rapid_fracture import GRANITE
from book.forms import MPA, RATIO, Form, seeds
from book.results import grouped, record
from book.row import Row, Rows
from book.tolerances import Between, Near, Tolerance

BEAMS = record("concrete_beams", drawn=True, takes="9 min")
GLASS = record("glass", takes="3 min")
MEASUREMENTS = (CONCRETE, BEAMS, GRANITE, GLASS, FRACTURE, SIZES)

_WHOLE = Form("MPa", 1e6, ".1f")
_KN = Form("kN", 1e3, ".2f")
# Tolerance of a strength that is entered, or that a closed form gives.
_CLOSE = 0.05
_SIDES = {"uniaxial": "tension from one side", "biaxial": "from two sides", "hydrostatic": "from all sides"}
_PUT_IN = ("uniaxial", "hydrostatic")


def _peaks(what: str, kind: str, within: Tolerance, form: Form = MPA, pressure: float = 0.0, **more: Any) -> Rows:
    """Peaks of a test of the concrete, a row for each number of cells."""
    some = [one for one in CONCRETE.at("cases") if one["kind"] == kind and one["pressure"] == pressure]
    for _, ones in sorted(grouped(some, "count").items()):
        yield Row(f"{what}; {_told(ones)}", CONCRETE.each(ones, "peak"), within, form, **more)


def _told(ones: list[dict[str, Any]]) -> str:
    return f"{ones[0]['count']} cells, {seeds([one['seed'] for one in ones])}"


def concrete() -> Rows:
    """Celigueta's concrete."""
    onset = MPA.text(CONCRETE.at("onset"))
    reason = (
        f"on the line through 55 and 4 MPa the centre of a disc yields at {onset} of tension, below f_t; with such a"
        " line both tests cannot have 4 MPa"
    )
    split = {"paper": 4e6, "printed": "4 MPa", "source": "Celigueta §4.2"}
    yield from _peaks("uniaxial compression, Ø100 × 200 mm", "ucs", Near(absolute=2e6), _WHOLE, paper=55e6,
        printed="55 MPa", source="Celigueta §4.1")  # fmt: skip
    yield from _peaks("direct tension", "tension", Near(relative=_CLOSE, target=4e6))
    for pressure in (2e6, 5e6, 10e6):
        line = next(one["theory"] for one in CONCRETE.at("cases") if one["pressure"] == pressure)
        yield from _peaks(f"triaxial compression at {pressure / 1e6:g} MPa, against the line", "triaxial",
            Near(relative=_CLOSE, target=line), _WHOLE, pressure)  # fmt: skip
    yield from _peaks("Brazilian test", "brazilian", Near(absolute=0.3e6), reason=reason, **split)
    yield from _peaks("Brazilian test with c = 14.3 MPa, φ = 35°, whose line passes above f_t", "cut_off",
        Near(absolute=0.3e6), **split)  # fmt: skip


def beams() -> Rows:
    """The concrete's notched beams, alike but for their size."""
    for (depth,), ones in sorted(grouped(BEAMS.at("beams"), "depth").items()):
        yield Row(f"over a continuum with a cohesive crack, D = {1e3 * depth:g} mm; {_told(ones)}",
            BEAMS.each(ones, "over_continuum"), Near(relative=_CLOSE, target=1.0), RATIO)  # fmt: skip


def other_concretes() -> Rows:
    """Published fracture tests of concretes, each with its own numbers."""
    for name, what in (("l_panel", "Winkler's L-shaped panel"), ("gregoire", "Grégoire's beam, D = 50 mm"),
                       ("garcia_alvarez", "García-Álvarez' beam, D = 80 mm")):  # fmt: skip
        one = FRACTURE.at("cases", {"name": name})
        yield Row(f"{what}: peak; {one['count'][0]} cells, {seeds(one['seeds'])}", FRACTURE.of(*one["values"]),
            Between(one["claim"]["low"], one["claim"]["high"]), _KN, paper=one["claim"]["words"],
            reason=_why(one) if one["continuum"] else "")  # fmt: skip
    for one in SIZES.at("beams"):
        yield Row(f"notched beam of {1e3 * one['depth']:g} mm, over a continuum with a cohesive crack;"
            f" {one['count']} cells, {seeds([one['seed']])}", SIZES.of(one["over_continuum"]),
            Near(relative=0.1, target=1.0), RATIO)  # fmt: skip


def _why(one: dict[str, Any]) -> str:
    over = [value / one["continuum"] for value in one["values"]]
    return (
        f"a continuum with one cohesive crack and the same numbers has a peak of {_KN.text(one['continuum'])}, also"
        f" above the measured range; cells have {RATIO.bare(min(over))} to {RATIO.bare(max(over))} of it"
    )


def granite() -> Rows:
    reasons = {
        "brazilian": (
            "the disc splits when its centre reaches 1.1 f_t, as finite elements with one cohesive crack do; measured"
            " strengths are 1.3 times the direct tension that is entered"
        ),
        "toughness": (
            "E G_f/f_t² = 48 mm is as long as the depth of the beam, but the formula requires a sharp crack; a beam"
            " of 200 mm has 1.49 MPa√m"
        ),
    }
    return rapid_fracture.granite(reasons, beam="")


def glass() -> Rows:
    for test, words in _SIDES.items():
        mine = [one for one in GLASS.at("cases") if (one["test"], one["nu"]) == (test, GLASS.at("nu"))]
        for (slower,), ones in grouped(mine, "slower").items():
            put_in = "entered" if test in _PUT_IN else "predicted"
            slow = "" if slower == 1.0 else f"{slower:g} times slower "
            yield Row(f"{words}, {put_in}; {slow}{_told(ones)}", GLASS.each(ones, "peak"), Near(relative=_CLOSE), MPA,
                paper=GLASS.at("asked", test))  # fmt: skip
