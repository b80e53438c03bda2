"""The same bonds in other shapes: cube, slender beam and bracket of five materials against finite elements."""

from book.forms import COUNT
from book.results import record
from book.row import Row, Rows
from book.tolerances import AtLeast

ANY = record("any_specimen", drawn=True)
SEED_1 = record("any_specimen", "--seed 1 --fineness ''", kept="any_specimen_seed_1")
MEASUREMENTS = (ANY, SEED_1)


def seed_1() -> Rows:
    cases = SEED_1.at("cases")
    within = sum(case["layered"]["worst"] <= case["limit"] for case in cases)
    yield Row(f"seed 1, bonds by layer, experimental: how many of {len(cases)} are within the limit",
        SEED_1.of(within), AtLeast(len(cases)), COUNT,
        note="in packings of other seeds, steel beams pass in 0 of 4, alumina and granite in 1 of 4")  # fmt: skip
