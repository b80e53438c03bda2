"""Fragments of an expanding ring."""

from book.forms import RATIO, seeds
from book.results import study
from book.row import Row, Rows
from book.tolerances import Near

RING = study("ring", {"ring": "fracture_ring"})
RING_FINE = study("ring", {}, options="--size 0.08e-3 --seeds 1", kept="ring_fine")
RING_THIN = study("ring", {}, options="--side 0.15e-3 --size 0.06e-3 --seeds 1", kept="ring_thin")
MEASUREMENTS = (RING, RING_FINE, RING_THIN)


def rows() -> Rows:
    """Sizes of fragments at each rate."""
    for measured in (RING, RING_FINE):
        for one in measured.at("rates"):
            yield Row(
                f"{one['rate']:g} /s, {one['count'][0]} cells, {seeds(one['seed'])}: mean size of fragments over s₀",
                measured.of(one["over"]["mean"], scatter=one["over"]["std"]), Near(relative=RING.at("limit")), RATIO,
                paper=one["formula"])  # fmt: skip
