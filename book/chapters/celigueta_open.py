"""What Celigueta et al. (2020) leave open: speed and friction of plates, gaps, size; and what it does."""

from typing import Any

from book.forms import RATIO, Form, grid, listed
from book.results import Measurement, grouped, record, study
from book.row import Row, Rows
from book.tolerances import AtMost, Near

SLOWER = study("celigueta", {}, options="--seeds 1 --areas weighted --slower 1,2,4", kept="celigueta_slower")
FULL_SLOWER = study(
    "celigueta", {}, options="--count 0 --seeds 1 --areas weighted --slower 1,2 --processes 1",
    kept="celigueta_full_slower",
)  # fmt: skip
REACH = record("non_local_reach", "", "--failure Mohr-Coulomb --counts 3000 --reaches 1.3,1.5", takes="12 min")
PLATENS = study(
    "celigueta", {}, kept="celigueta_platens",
    options="--count 1000 --seeds 1,2,3 --areas weighted --failures Rankine --platens 0,0.1,0.3 --processes 1",
)  # fmt: skip
NOISE = record("non_local_noise", takes="3 min")
FORCES = record("plate_forces", takes="15 min")
MEASUREMENTS = SLOWER, FULL_SLOWER, PLATENS, NOISE, REACH, FORCES

#: What is asked of plates half as fast: how far peaks may change, and forces of both plates differ.
OF_SPEED, OF_PLATES = 0.03, 0.02
AREAS = {"weighted": "the authors' areas", "facet": "Laguerre facets"}


def packings(one: dict[str, Any]) -> str:
    """The packings of a case, as words."""
    return f"packing{'s' * (len(one['seed']) > 1)} {listed(one['seed'])}"


def _slower(kept: Measurement) -> Rows:
    cases = kept.at("cases")
    first = {(one["test"], one["failure"]): one["peak"][0] for one in cases if one["slower"] == 1.0}
    for one in cases:
        speed = "the paper's speed" if one["slower"] == 1.0 else f"{one['slower']:g} times slower"
        words = f"{one['test']}, {one['failure']}, {one['count'][0]} elements, {speed}"
        if one["slower"] == 2.0:
            change = one["peak"][0] / first[one["test"], one["failure"]] - 1.0
            yield Row(f"{words}: change of the peak", kept.of(change), AtMost(OF_SPEED), Form("%", 1e-2, "+.1f"))
        yield Row(f"{words}: force on the other plate over that at the peak", kept.of(*one["other"]),
            Near(absolute=OF_PLATES, target=1.0), RATIO)  # fmt: skip


def speed() -> Rows:
    """Plates more slowly."""
    yield from _slower(SLOWER)
    yield from _slower(FULL_SLOWER)


def forces() -> Rows:
    """Lower load of the other plate."""
    for (test, damping, both), some in grouped(FORCES.at("cases"), "test", "damping", "both").items():
        seeds = packings({"seed": [one["seed"] for one in some]})
        words = (
            f"{test}, local damping {damping:g}, {'both plates move' if both else 'one plate moves'},"
            f" {some[0]['count']} elements, {seeds}"
        )
        yield Row(f"{words}: force on the other plate over that at the peak",
            FORCES.of(*(one["at_peak"] for one in some)), Near(absolute=OF_PLATES, target=1.0), RATIO)  # fmt: skip


def reach(cases: list[dict[str, Any]]) -> str:
    """A table of packings by the gap over which spheres are bonded: a line a size, three columns a gap."""
    reaches = sorted({one["reach"] for one in cases})
    heads = [head for reach in reaches for head in (f"reach {reach:g}: z", "E [GPa]", "peak [MPa]")]
    lines = (
        [
            str(count),
            *(_of(some, *column) for _, some in sorted(grouped(ones, "reach").items()) for column in _COLUMNS),
        ]
        for (count,), ones in sorted(grouped(cases, "count").items())
    )
    return grid(["elements", *heads], lines)


_COLUMNS = (("z", 1.0), ("E_plates", 1e9), ("peak", 1e6))


def _of(some: list[dict[str, Any]], key: str, unit: float) -> str:
    return ", ".join("–" if one[key] is None else format(one[key] / unit, ".1f") for one in some)
