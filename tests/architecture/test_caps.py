"""Counts of the sources that may only fall; `python -m tests.architecture.caps` prints them."""

import ast

import pytest

from tests.architecture import caps


@pytest.mark.parametrize("cap", caps.CAPS, ids=lambda cap: cap.name)
def test_a_count_is_its_cap(cap):
    if cap.fault:
        pytest.fail(cap.fault, pytrace=False)


@pytest.mark.parametrize(("count", "fault"), [(10, ""), (6, ""), (11, "above the cap of 10"), (5, "Write 5 into")])
def test_a_cap_refuses_more_and_follows_less(count, fault):
    cap = caps.Cap("lines", lambda: ["line"] * count, 10, step=5)
    assert fault in cap.fault
    assert bool(cap.fault) == bool(fault)


@pytest.mark.parametrize(
    ("text", "whom"),
    [
        ("model.cells is None", "model"),
        ("self.model.non_local is not None", "model"),
        ("run.lattice.cells is None", "lattice"),
        ("study.bond.cells is None", "study"),
        ("(facets := body.facets) is not None", "lattice"),
        ("cells is None", ""),
    ],
)
def test_a_question_is_counted_by_whom_it_asks(text, whom):
    ((_, _, asked, _),) = caps.compared("bondem.run", ast.parse(text))
    assert caps.asked_of("bondem.run", asked) == whom


@pytest.mark.parametrize(
    ("text", "whom"),
    [
        ("def f(body):\n    one, cells = 1, body.cells\n    return cells is None", "lattice"),
        ("def f(cells: CellConstants | None):\n    return cells is None", "model"),
    ],
)
def test_a_variable_asks_what_it_stands_for(text, whom):
    ((_, name, asked, _),) = caps.compared("bondem.run", ast.parse(text))
    assert (name, caps.asked_of("bondem.run", asked)) == ("cells", whom)
