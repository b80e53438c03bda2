"""Refreshes of ghosts that follow from what passes declare, and runs of several ranks with them."""

from collections.abc import Callable

import numpy as np
import pytest

import bondem as bd
from bondem.damage.crack_columns import FACET, SPENT
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.parts.parts_of_model import parts_in_one_block
from bondem.dynamics.plan import Plan
from tests.core.ranks import Ranks
from tests.core.refreshes import layers, refreshes
from tests.device_cases import Case
from tests.device_cracks import CASES as CRACKING
from tests.device_cracks import RANKINE, STEP, free, pushed, sliding, thrown
from tests.device_runs import CASES as RUNS
from tests.device_yielding import CASES as YIELDING
from tests.device_yielding import COULOMB, pressed

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")
_ALL = {**RUNS, **CRACKING, **YIELDING}
_CRACKS = [
    "pose.stress relax_cracked_cells", "pose.stress relax_outdated_cells", "leader relax_outdated_cells",
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
    "planes": ["pose open_elements", "tensor add_surface_stresses", "judged judge_cells", *_CRACKS],
    "planes that shear": [
        "motion open_elements", "pose open_elements", "tensor add_surface_stresses", "plastic yield_cells",
        "judged yield_cells", *_CRACKS,
    ],
    "crushed": [
        "pose open_elements", "tensor add_surface_stresses", "plastic yield_cells", "judged yield_cells", *_CRACKS
    ],
    "warming and crushed": [
        "pose open_elements_and_rows", "tensor add_surface_stresses", "plastic yield_cells", "judged yield_cells",
        *_CRACKS,
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


def test_cracks_declare_three_layers_and_facets_that_break_at_once_a_pass_that_is_divided() -> None:
    assert layers(parts_of(_ALL["torn apart"]())) == (3, 0)
    assert layers(parts_of(_ALL["torn apart"]()), energies=True) == (4, 1)
    assert layers(parts_of(_ALL["sliding on a joint"]())) == (4, 1)
    assert layers(parts_of(_ALL["non-local, bonds break"]())) == (1, 0)
    with pytest.raises(ValueError, match="break_facets reads at its ends"):
        refreshes(parts_of(_ALL["brittle cells"]()))


# The bars of cracking bodies, three times as long, so that a rank with its ghosts is not the whole body.
_TOUCH = bd.LinearContact(E=40e9, friction=0.4)
_LONG: dict[str, Callable[[], Case]] = {
    "torn apart": lambda: (free(RANKINE, 24), thrown((6.0, -1.2, 1.8)), 60, STEP, {}),
    "driven together and touching": lambda: (
        free(RANKINE, 24, contact=_TOUCH), thrown((-120.0, -36.0, -36.0), 10.0), 440, 0.25 * STEP, {}
    ),
    "crushed": lambda: (free(COULOMB, 24), thrown((-12.0, 1.5, 2.4)), 100, STEP, {}),
    "crushed between walls": lambda: (pressed(COULOMB, 24), thrown((-12.0, 1.5, 2.4)), 100, STEP, {}),
    "sliding on a joint": lambda: (sliding(24), pushed, 440, 0.8 * STEP, {}),
}  # fmt: skip


def cuts(model: bd.Model, seed: int = 0) -> np.ndarray:
    """Return one of three ranks for each element: parts along the body, with a random cut between them."""
    x = model.lattice.centre[model.layout.order][:, 0]
    ragged = np.random.default_rng(seed).uniform(-1.5, 1.5, len(x))
    share = (x - x.min()) / np.ptp(x) + ragged * 4e-3 / np.ptp(x)
    return np.searchsorted([1 / 3, 2 / 3], share)


def dealt(model: bd.Model, seed: int = 0) -> np.ndarray:
    """Return one of three ranks for each element, at random."""
    return np.random.default_rng(seed).integers(0, 3, len(model.lattice.centre))


class Sides:
    """A run of one process and one of three ranks, from the same state.

    Args:
        case: model, state, steps, time step and options.
        owner: rank of each element, internal order.
        left_out: place of a refresh that is left out, or None.
        given: layers of ghosts, and of those of which ranks have all bonds, or None for what motions need.
    """

    def __init__(
        self, case: Case, owner: np.ndarray, left_out: int | None = None, given: tuple[int, int] | None = None
    ) -> None:
        model, start, _, dt, options = case
        options = {key: value for key, value in options.items() if key not in ("every", "gauges")}
        case, plan = (*case[:4], options), Plan(duration=1.0, dt=dt, every=0, **options)
        self.owner, self.whole = owner, CoreLoop(model, plan, start(model), dt)
        self.whole.record_present()
        parts = parts_of(case)
        wanted = [one for place, one in enumerate(refreshes(parts)) if place != left_out]
        self.ranks = Ranks(case, self.whole.state.copy(), owner, wanted, given or layers(parts))

    def differing(self, steps: int) -> int:
        """Take steps, and return how many elements of ranks differ in a bit from those of the one process."""
        self.whole.run(steps)
        self.ranks.run(steps)
        differ = np.zeros(len(self.owner), dtype=bool)
        for number, rank in enumerate(self.ranks.ranks):
            for field in ("pose", "motion", "acceleration"):
                one, other = getattr(rank.state, field), getattr(self.whole.state, field)
                differ |= (self.owner == number) & (one != other).any(axis=1)
        return int(differ.sum())

    @property
    def between_ranks(self) -> int:
        """How many facets that crack have cells of two ranks."""
        rank, facet = self.ranks.ranks[0], self.whole.state.cracks[:, FACET].astype(int)
        return int((self.owner[rank.i[facet]] != self.owner[rank.j[facet]]).sum())

    @property
    def other_energies(self) -> int:
        """How many cracks of ranks, by their cell j, have dissipated another energy than in the one process."""
        differ, whole = 0, dict(self.whole.state.cracks[:, [FACET, SPENT]])
        for number, rank in enumerate(self.ranks.ranks):
            cracks = rank.state.cracks[self.owner[rank.j[rank.state.cracks[:, FACET].astype(int)]] == number]
            differ += sum(whole.get(facet) != spent for facet, spent in cracks[:, [FACET, SPENT]])
        return differ


@pytest.mark.parametrize(
    ("name", "steps"),
    [
        ("dashpots and brittle", 20), ("layer of cells", 10), ("non-local, bonds break", 20),
        ("beams break, Hertzian", 400),
    ],
)
def test_ranks_have_the_bits_of_one_process(name: str, steps: int) -> None:
    case = _ALL[name]()
    assert Sides(case, dealt(case[0])).differing(steps) == 0


def test_ranks_share_the_sums_of_loads_on_walls(monkeypatch) -> None:
    case = _ALL["beams break, Hertzian"]()
    monkeypatch.setattr(Ranks, "share_wall_loads", lambda self, entries: None)
    assert Sides(case, dealt(case[0])).differing(400) > 0


@pytest.mark.parametrize("name", _LONG)
def test_ranks_crack_by_the_bits_of_one_process(name: str) -> None:
    case = _LONG[name]()
    owner, energies = cuts(case[0]), layers(parts_of(case), energies=True)
    assert Sides(case, owner).differing(case[2]) == 0
    sides = Sides(case, owner, given=energies)
    assert all((~rank.ghosts & ~rank.own).sum() > 60 for rank in sides.ranks.ranks)
    assert (sides.differing(case[2]), sides.other_energies) == (0, 0)
    assert sides.between_ranks > 40


# One layer with all of its bonds, or without where pairs of contact make ghosts of the second layer.
@pytest.mark.parametrize(
    ("name", "given"),
    [(name, (1, int("touching" not in name and "sliding" not in name))) for name in _LONG]
    + [("sliding on a joint", (3, 0))],
)
def test_fewer_layers_are_wrong(name: str, given: tuple[int, int]) -> None:
    case = _LONG[name]()
    assert Sides(case, cuts(case[0]), given=given).differing(case[2]) > 0


@pytest.mark.parametrize("given", [(3, 0), (3, 1), (4, 1), (5, 2)])
def test_more_layers_change_nothing(given: tuple[int, int]) -> None:
    case = _LONG["crushed"]()
    assert Sides(case, cuts(case[0]), given=given).differing(case[2]) == 0


_STEPS = {"dashpots and brittle": 10, "beams break, Hertzian": 400, "layer of cells": 3,
          "cells with corrected mass": 3, "non-local, bonds break": 40, "planes": 20}  # fmt: skip
_JUDGED = WANTED["planes that shear"].index("judged yield_cells")


@pytest.mark.parametrize(
    ("name", "steps", "left_out"),
    [(name, steps, place) for name, steps in _STEPS.items() for place in range(len(WANTED[name]))]
    + [("planes that shear", 20, _JUDGED)],
)
def test_no_refresh_may_be_left_out(name: str, steps: int, left_out: int) -> None:
    case = _ALL[name]()
    assert Sides(case, dealt(case[0]), left_out).differing(steps) > 0


def test_plastic_strains_of_ghosts_are_refreshed_for_cells_near_them() -> None:
    case = _LONG["crushed"]()
    assert Sides(case, cuts(case[0]), WANTED["crushed"].index("plastic yield_cells")).differing(60) > 0


def test_energies_of_cracks_that_part_need_the_bonds_of_ghosts() -> None:
    case = _ALL["planes that shear"]()
    motions, energies = (Sides(case, dealt(case[0]), given=given) for given in ((3, 0), (3, 1)))
    assert [one.differing(120) for one in (motions, energies)] == [0, 0]
    assert (motions.other_energies > 0, energies.other_energies) == (True, 0)
    case = _LONG["driven together and touching"]()
    sides = Sides(case, cuts(case[0]), given=(2, 0))
    assert (sides.differing(case[2]), sides.other_energies > 0) == (0, True)
