"""Refreshes of ghosts that follow from what passes declare, and runs of several ranks with them."""

import numpy as np
import pytest

from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.parts.parts_of_model import parts_in_one_block
from bondem.dynamics.plan import Plan
from tests.core.ranks import Ranks
from tests.core.refreshes import layers, refreshes
from tests.device_cases import Case
from tests.device_cracks import CASES as CRACKING
from tests.device_runs import CASES as RUNS
from tests.device_yielding import CASES as YIELDING

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")
_ALL = {**RUNS, **CRACKING, **YIELDING}
_CRACKS = [
    "pose.stress relax_cracked_cells", "weight wake_cracks", "pose.stress relax_outdated_cells", "half soften_cracks",
    "pose.stress relax_outdated_cells", "slip sum_cracks",
]  # fmt: skip
#: Of each kind of model: the column, and the pass that its refresh stands behind.
WANTED = {
    "held": ["pose open_elements_and_rows"],
    "dashpots": ["motion open_elements_and_rows", "pose open_elements_and_rows"],
    "dashpots and brittle": [
        "motion open_elements_and_rows", "pose open_elements_and_rows", "motion move_resisted_rows"
    ],
    "beams break, Hertzian": ["motion open_elements_and_rows", "pose open_elements_and_rows", "motion move_rows"],
    "softening, alike": ["motion open_elements", "pose open_elements"],
    "free cells": ["pose open_elements", "pose.stress stress_cells"],
    "periodic cells": ["pose open_elements", "pose.stress stress_cells", "pose.stress add_stress_differences"],
    "layer of cells": [
        "pose open_elements_and_rows", "pose.stress stress_cells", "pose.stress add_stress_differences",
        "bend bend_layers",
    ],
    "cells with corrected mass": [
        "pose open_elements_and_rows", "pose.stress stress_cells", "pose.stress add_stress_differences",
        "acceleration find_accelerations", "inertia find_dilatation_inertia",
    ],
    "torn apart": ["pose open_elements", "tensor add_surface_stresses", "judged judge_cells", *_CRACKS],
    "crushed": [
        "pose open_elements", "tensor add_surface_stresses", "judged yield_cells", "plastic yield_cells", *_CRACKS
    ],
    "non-local, spheres": ["pose open_elements_and_rows", "space turn_stresses"],
    "non-local, bonds break": [
        "motion open_elements_and_rows", "pose open_elements_and_rows", "space turn_stresses", "space find_stresses",
        "motion move_resisted_rows",
    ],
}  # fmt: skip


def parts_of(case: Case) -> list:
    model, start, _, dt, options = case
    return parts_in_one_block(model, Plan(duration=dt, dt=dt, **options), start(model), dt)[1]


@pytest.mark.parametrize("name", WANTED)
def test_refreshes_follow_from_declarations(name: str) -> None:
    found = refreshes(parts_of(_ALL[name]()))
    assert [f"{one.column.partition('.')[2]} {one.behind}" for one in found] == WANTED[name]


def test_cracks_need_two_layers_and_facets_that_break_at_once_a_pass_that_is_divided() -> None:
    assert layers(parts_of(_ALL["torn apart"]())) == 2
    assert layers(parts_of(_ALL["non-local, bonds break"]())) == 1
    with pytest.raises(ValueError, match="break_facets reads at its ends"):
        refreshes(parts_of(_ALL["brittle cells"]()))


def differing(name: str, steps: int, left_out: int | None = None) -> int:
    """Return how many elements of three ranks, dealt at random, differ in a bit from a run of one process."""
    model, start, _, dt, options = _ALL[name]()
    options = {key: value for key, value in options.items() if key not in ("every", "gauges")}
    case = model, start, steps, dt, options
    whole = CoreLoop(model, Plan(duration=1.0, dt=dt, every=0, **options), start(model), dt)
    whole.record_present()
    state, parts = whole.state.copy(), parts_of(case)
    whole.run(steps)
    owner = np.random.default_rng(0).integers(0, 3, len(state.pose))
    wanted = [one for place, one in enumerate(refreshes(parts)) if place != left_out and "half" not in one.column]
    ranks = Ranks(case, state, owner, wanted, layers(parts))
    ranks.run(steps)
    differ = np.zeros(len(owner), dtype=bool)
    for number, rank in enumerate(ranks.ranks):
        for field in ("pose", "motion", "acceleration"):
            one, other = getattr(rank.state, field), getattr(whole.state, field)
            differ |= (owner == number) & (one != other).any(axis=1)
    return int(differ.sum())


@pytest.mark.parametrize(
    ("name", "steps"),
    [("dashpots and brittle", 20), ("layer of cells", 10), ("non-local, bonds break", 20), ("torn apart", 8)],
)
def test_ranks_have_the_bits_of_one_process(name: str, steps: int) -> None:
    assert differing(name, steps) == 0


@pytest.mark.parametrize("left_out", range(5))
def test_no_refresh_may_be_left_out(left_out: int) -> None:
    assert differing("non-local, bonds break", 40, left_out) > 0
