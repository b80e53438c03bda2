"""Passes that a step calls once have the kind that their tables and sources show (`PassKind` in `steps.hpp`)."""

import re

import pytest

from bondem._core import pass_tables, step_pass
from tests.core.passes import SOURCE, kinds_of_passes

ONCE = ("of_rows", "of_cracks", "of_events", "single")
CRACKS = {"CohesiveCracks", "CrackLists"}
# Lists of what begins, changes or ends in a step; sums that elements have until their events are done.
EVENTS = {"Candidates", "CandidateFacets", "CrackOnset", "CrackLists", "EventLog"}
KEPT = {"Postponed"}
# Numbers that a body has once.
TOTALS = {"Ledger", "Travel", "HistoryRows"}
# Of each kind: tables of which a pass takes one, and those that it does not take.
RULES = {
    "of_rows": (set(), CRACKS | KEPT | {"Travel"}),
    "of_cracks": (CRACKS, KEPT | {"Candidates", "Travel"}),
    "of_events": (EVENTS, TOTALS),
    "single": (TOTALS, CRACKS | KEPT),
}
# Tables without rows of their own for a pass: all elements, time, what a record and an event are written to, sums.
COMMON = {"Moving", "Timeline", "HistoryRows", "Ledger", "EventLog", "Candidates"}


def fault(kind: str, tables: tuple[str, ...]) -> str:
    """Return what a pass of a kind takes or lacks; empty if nothing is wrong."""
    some, none = RULES[kind]
    if some and not some & set(tables):
        return f"takes none of {sorted(some)}"
    if none & set(tables):
        return f"takes {sorted(none & set(tables))}"
    return "" if set(tables) - COMMON or kind != "of_rows" else "takes no table of rows"


def test_passes_called_once_take_the_tables_of_their_kind():
    kinds = kinds_of_passes()
    found = {name: (kinds[step_pass(name)[0][1]], tables) for name, tables in pass_tables("steps").items()}
    once = {name: one for name, one in found.items() if one[0] in ONCE}
    assert {kind for kind, _ in once.values()} == set(ONCE)
    assert not {name: words for name, one in once.items() if (words := fault(*one))}


@pytest.mark.parametrize(
    ("kind", "name"),
    [("of_rows", "log_cracks"), ("of_rows", "check_travel"), ("of_rows", "write_released"),
     ("of_rows", "break_beams"), ("of_cracks", "follow_drives"), ("of_events", "load_walls"),
     ("of_events", "write_ledger"), ("single", "list_cracks"), ("single", "break_facets"),
     ("single", "follow_tractions")],
)  # fmt: skip
def test_another_kind_is_found(kind, name):
    assert fault(kind, pass_tables("steps")[name])


def kinds_with(words: str) -> set[str]:
    """Return the kinds of the passes whose sources have an expression."""
    found = set()
    for path in (SOURCE / "core/passes").rglob("*.cpp"):
        parts = re.split(r"^BONDEM_PASS(?:_AS)?\(\w+, (\w+).*$", path.read_text(), flags=re.MULTILINE)
        found |= {kind for text, kind in zip(parts[::2], parts[1::2], strict=False) if re.search(words, text)}
    return found


def test_only_passes_of_cracks_share_their_portions_among_threads():
    assert kinds_with(r"\bover_places\(|\bturn\.threads\b") == {"of_cracks"}


def test_only_single_passes_read_sums_of_the_ledger_to_which_all_may_add():
    assert kinds_with(r"\bsum_of\(ledger, \w+\)\.(?:take|value)\(") == {"single"}
