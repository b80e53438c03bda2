"""Bodies against the bulk: what walls, or cut faces, do to E and ν, and how well that is predicted."""

from book.forms import PERCENT, spaced
from book.results import study
from book.row import Row, Rows
from book.tolerances import AtMost

SURFACE = study("surface", {"surface": "surface"})
MEASUREMENTS = (SURFACE,)

SYMBOLS = {"E": "E", "nu": "ν"}
TARGETS = {"contacts": "6.2 contacts", "jamming": "onset of jamming", "carved": "cut from a larger packing"}
#: The count at which a body is thick enough for the 3 % that is asked of specimens.
FINE = 20_000


def accuracy() -> Rows:
    for one in SURFACE.at("accuracy"):
        if one["count"] == FINE and "only" not in one["what"]:
            where = f"{TARGETS.get(one['target'], 'all bodies')} of {spaced(FINE)}"
            for key in ("rms", "largest"):
                yield Row(f"{SYMBOLS[one['quantity']]}, {where}, {one['what']}: {key}", SURFACE.of(one[key]),
                    AtMost(0.03), PERCENT)  # fmt: skip
