"""Bodies against the bulk: what walls, or cut faces, do to E and ν, and how well that is predicted."""

from book.chapter import Chapter, Figure, Section
from book.forms import PERCENT, Form
from book.results import study
from book.row import Row
from book.tolerances import AtMost

SURFACE = study("surface", {"surface": "surface"})
MEASUREMENTS = (SURFACE,)

RATIO = Form(style=".3f")
SYMBOLS = {"E": "E", "nu": "ν"}
TARGETS = {"contacts": "6.2 contacts", "jamming": "onset of jamming", "carved": "cut from a larger packing"}
#: The count at which a body is thick enough for the 3 % that is asked of specimens.
FINE = 20_000


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="surface",
        title="Bodies against the bulk: the surface correction",
        summary=(
            "Bonds that are calibrated in a cell without walls give a body another E and ν, in proportion to its "
            "surface per volume: a body packed to 6.2 contacts is stiffer, a body packed to jamming or cut from a "
            "larger packing is softer. A correction predicts this from the body's own lattice."
        ),
        sections=(_bodies(), _accuracy()),
    )


def _bodies() -> Section:
    return Section(
        title="Effect of surfaces",
        before=(
            "Bodies have Euler–Bernoulli bonds with r̃ = 0.7 and are measured in tension, between ends where "
            "forces act."
        ),
        figures=(Figure("surface.png", "E and ν of bodies over those of the bulk, measured and predicted"),),
    )


def _accuracy() -> Section:
    rows = []
    for one in SURFACE.at("accuracy"):
        size = f" of {_spaced(one['count'])}" if one["count"] else ""
        where = TARGETS.get(one["target"], "all bodies")
        fine = one["count"] == FINE and "only" not in one["what"]
        rows += [
            Row(case=f"{SYMBOLS[one['quantity']]}, {where}{size}, {one['what']}: rms", ours=SURFACE.of(one["rms"]),
                form=PERCENT, tolerance=AtMost(0.03) if fine else None),
            Row(case=f"{SYMBOLS[one['quantity']]}, {where}{size}, {one['what']}: largest", form=PERCENT,
                ours=SURFACE.of(one["largest"]), tolerance=AtMost(0.03) if fine else None),
        ]  # fmt: skip
    return Section(
        title="Accuracy of the correction",
        before=(
            "The correction is fitted without the shape, or without the law, that it then predicts. 3 % is "
            "required at 20 000 elements."
        ),
        rows=tuple(rows),
    )


def _spaced(count: int) -> str:
    return f"{count:,}".replace(",", " ")
