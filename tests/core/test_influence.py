"""What the passes of a step declare of columns of elements is what they do, in states in which they have work."""

from functools import cache
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem import _core
from bondem._core import pass_tables
from bondem.interactions.step_part import RESUME
from tests.core.influence import Found, Look, Step, states
from tests.core.pass_columns import columns_of
from tests.core.test_stress_onset_on_device import mean_over_strength
from tests.device_cases import Case
from tests.device_cracks import CASES as CRACKING
from tests.device_cracks import STEP, free, thrown
from tests.device_runs import CASES as RUNS
from tests.device_yielding import CASES as YIELDING

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")
#: Cases, and numbers of steps after which passes have work. Steps go on in every second state, in others they pause.
STATES = {
    "bar": (0, 160), "dissipative": (0, 120), "dashpots": (0,), "dragged and free": (0,), "free cells": (0,),
    "held cells": (0,), "cells with corrected mass": (0,), "cells on rough platens": (0,), "layer of cells": (0,),
    "peripheral": (0, 3), "mohr coulomb": (9, 30), "linear": (10,), "elliptic": (0,), "alike and brittle": (0,),
    "dashpots and brittle": (8,), "brittle cells": (0, 3), "free brittle cells": (2,), "warming brittle cells": (0,),
    "cells break and touch": (0, 7, 60), "beams, rolling": (0, 48), "sticky spheres and walls": (0,),
    "beams soften, Hertzian": (0, 94, 200), "softening, mohr coulomb": (0,), "softening, alike": (0,),
    "softening, alike, mohr coulomb": (0, 1), "stored": (0,), "non-local": (0,), "non-local, contact": (0, 56),
    "non-local, bonds break": (15,), "non-local, spheres that break": (36,),
    "non-local, bonds break, contact": (5, 120), "torn apart": (0, 5, 8, 12), "brittle": (131,), "bilinear": (10,),
    "driven together and touching": (56, 60, 76, 318), "sliding on a joint": (2, 100, 200, 300, 440),
    "planes": (0, 140, 220), "crushed": (60,), "crushed by a cone": (98,), "crushed between walls": (120,),
    "planes that shear": (90,), "warming": (0,),
    "warming and crushed": (0, 120), "warming and cracking": (60,), "by mean stress": (0, 10), "by function": (0, 10),
}  # fmt: skip
_STRESSES: dict[str, Any] = {
    "by mean stress": bd.Hydrostatic(tension=2e6), "by function": bd.StressCriterion(mean_over_strength, tension=2e6)
}  # fmt: skip
_ALL = {**RUNS, **CRACKING, **YIELDING}


def case_of(name: str) -> Case:
    """Return a case by its name."""
    if name not in _STRESSES:
        return _ALL[name]()
    return free(_STRESSES[name]), thrown((2.0, 1.6, 1.2)), 20, STEP, {}


#: What the sources read and states need not show: few contacts begin where beams soften, and levers of cells that
#: yield are written anew with the same numbers.
_UNSEEN = {
    "begin_softened_contacts": ["does not read Moving.motion Moving.pose at its ends"],
    "begin_crack_powers": ["does not read Moving.pose at its ends"],
    "stretch_walls_and_cracks": ["does not read YieldingCells.plastic at its ends"],
}  # fmt: skip
#: Works that a pass is seen at, at least.
_WORKS = 3


def declared(name: str) -> dict[str, set[str]]:
    """Return the declaration of a pass as it is seen from outside: not whether elements are postponed."""
    columns = {use: set(of) for use, of in columns_of(name).items()}
    around = columns.get("around", set())
    ends = set().union(*(columns.get(use, set()) for use in ("ends", "still", "energy", "around")))
    adds = columns.get("adds", set())
    return {
        "ends": ends, "around": around, "adds": adds, "writes": columns.get("writes", set()) | adds,
        "own": columns.get("own", set()) | ends | adds,
    }  # fmt: skip


def faults(name: str, seen: Found) -> list[str]:
    """Return what a pass does and does not declare, and what it declares to read at ends or around and does not."""
    said = declared(name)
    found = {"ends": seen.ends | seen.around, "around": seen.around, "adds": seen.adds, "writes": seen.writes,
             "own": seen.own}  # fmt: skip
    undeclared = [f"{use} {' '.join(sorted(of - said[use]))}" for use, of in found.items() if of - said[use]]
    unseen = {where: said[use] - found[use] for use, where in (("ends", "at its ends"), ("around", "around these"))}
    return undeclared + [f"does not read {' '.join(sorted(of))} {where}" for where, of in unseen.items() if of]


@cache
def examined() -> dict[str, Found]:
    """Return what passes do in all states."""
    found, works, rng = {}, {}, np.random.default_rng(0)
    for case, steps in STATES.items():
        made = case_of(case)
        for turn, state in enumerate(states(made, steps)):
            step = Step(made, state, goes_on=turn % 2 == 0)
            for stage, before, one in step.entries():
                if stage in RESUME and one.name != "list_postponed" and not one.name.startswith("reopen"):
                    continue
                seen = found.setdefault(one.name, Found())
                look = Look(step, before, one, seen, rng)
                for half in range(3):
                    if works.get(one.name, 0) >= _WORKS and not faults(one.name, seen):
                        break
                    look.look(half)
                    works[one.name] = works.get(one.name, 0) + look.works
                    if not look.works:
                        break
                look.carry_out()
    return found


def test_passes_do_what_they_declare() -> None:
    found = {name: found for name, seen in examined().items() if (found := faults(name, seen))}
    assert {name: words for name, words in found.items() if words != _UNSEEN.get(name)} == {}
    assert set(pass_tables("steps")) == set(examined())


@pytest.mark.parametrize(
    ("name", "text", "fault"),
    [
        ("add_facet_loads", "ends pose; adds sums", "ends Moving.pose.stress"),
        ("mark_pairs", "ends moment space", "does not read LaggedStresses.moment at its ends"),
        ("measure_cracks", "ends leader; around pose tensor; adds half", "around CrackLists.leader"),
        ("measure_cracks", "around base leader pose tensor; adds half", "does not read CrackLists.base around these"),
        ("measure_cracks", "around pose tensor; adds half", "around CrackLists.leader"),
        ("stress_cells", "own given swelling weight; writes pose.stress", "writes CellDilatation.swelling"),
        ("sum_stress_differences", "own pose.stress; writes difference", "ends Moving.pose.stress"),
        ("begin_cracks", "", "adds CrackOnset.cracked"),
        ("find_cell_stresses", "own moment; writes tensor", "own StressesOfCells.carried"),
    ],
)
def test_a_wrong_declaration_is_found(name: str, text: str, fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    seen = examined()[name]  # by what the sources declare
    monkeypatch.setattr(_core, "declared_columns", lambda _: text)
    columns_of.cache_clear()
    try:
        assert fault in faults(name, seen)
    finally:
        columns_of.cache_clear()


@pytest.mark.parametrize(
    "text",
    ["ends poses", "ends pose.strain", "reads pose", "ends integrity", "adds rest", "adds sums; ends pose", "ends"],
)
def test_what_is_no_declaration_is_refused(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_core, "declared_columns", lambda _: text)
    columns_of.cache_clear()
    try:
        with pytest.raises(SystemExit, match="add_facet_loads"):
            columns_of("add_facet_loads")
    finally:
        columns_of.cache_clear()
