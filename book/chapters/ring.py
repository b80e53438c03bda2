"""Fragments of an expanding ring."""

from typing import Any

from book.chapter import Figure, Section
from book.forms import Form
from book.results import Measurement, study
from book.row import Row
from book.tolerances import Near

RING = study("ring", {"ring": "fracture_ring"})
RING_FINE = study("ring", {}, options="--size 0.08e-3 --seeds 1", kept="ring_fine")
RING_THIN = study("ring", {}, options="--side 0.15e-3 --size 0.06e-3 --seeds 1", kept="ring_thin")
MEASUREMENTS = (RING, RING_FINE, RING_THIN)

RATIO = Form(style=".3f")


def section() -> Section:
    """The section of the chapter on published fracture tests."""
    return Section(
        title="Expanding ring",
        before=(
            "The ring has a circumference of 50 mm, a section of 0.3 × 0.3 mm and radial velocities; the ceramic "
            "has E = 275 GPa, σ_c = 300 MPa and G = 100 J/m². The size of fragments is compared with 4.5 s₀ / (1 + "
            "4.5 (ε̇/ε̇₀)^(2/3)) of Zhou, Molinari and Ramesh (2006), within 10 %."
        ),
        rows=tuple(
            _pieces(measured, one) for measured in (RING, RING_FINE) for one in measured.at("rates")
        ),
        after=_cause(),
        figures=(Figure("fracture_ring.png", "Mean size of fragments over the rate of strain, without dimension"),),
    )  # fmt: skip


def _cause() -> str:
    """What the other rings show of the cause."""
    usual, fine, thin = (
        f"{min(found):.2f} to {max(found):.2f}"
        for found in ([one["ratio"] for one in some.at("rates")] for some in (RING, RING_FINE, RING_THIN))
    )
    first, taken = RING.at("rates", 0), [one["dissipated"] for one in RING.at("rates")]
    less = [one["dissipated"] for one in RING_THIN.at("rates")]
    braked = [one["ratio_slowed"] for one in RING_THIN.at("rates")]
    return (
        f"The formula assumes a ring without width, and the width is the cause of the miss: in a section of half the"
        f" width sizes are {thin} of the formula, here {usual}; with finer cells in the same section they are"
        f" {fine} (one packing of each). Wide sections dissipate {min(taken):.2f} to {max(taken):.2f} times G per"
        f" separated section, thin ones {min(less):.2f} to {max(less):.2f}, because of cracks that begin beside"
        " others and stop. The rate of the formula may also be the rate at failure: hoop stress slows the slowest"
        f" ring from {first['rate']:g} to {first['slowed']:.0f} /s until it reaches σ_c (a thin elastic ring:"
        f" {first['slowed_thin']:.0f}). This changes the ratio from {first['ratio']:.2f} to"
        f" {first['ratio_slowed']:.2f} there and not at high rates; for the thin section it gives"
        f" {min(braked):.2f} to {max(braked):.2f}."
    )


def _pieces(measured: Measurement, one: dict[str, Any]) -> Row:
    """Sizes of fragments at a rate."""
    over, rate = measured.of(one["over"]["mean"], scatter=one["over"]["std"]), f"{one['rate']:g} /s"
    cells = f"{one['count'][0]} cells, seed{'s' * (len(one['seed']) > 1)} {', '.join(map(str, one['seed']))}"
    return Row(case=f"{rate}, {cells}: mean size of fragments over s₀", paper=one["formula"], ours=over, form=RATIO,
               tolerance=Near(relative=RING.at("limit")))  # fmt: skip
