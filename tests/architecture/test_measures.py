"""Measures of the tree that have a limit; `python -m tests.architecture.measures` prints them all."""

import ast

from tests.architecture import measures

# Tables of a pass of the core, at most.
MOST_TABLES = 8


def test_no_modules_import_each_other_in_a_circle():
    assert not measures.import_cycles()


def test_a_circle_is_found():
    graph = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a", "d"}, "e": set()}
    assert measures.circles(graph) == [("b", "c"), ("d",)]


def test_imports_of_a_module_are_those_it_names():
    own = "from bondem.dynamics import plan\nfrom bondem.model.state import State"
    text = f"import numpy\nimport bondem.errors\n{own}"
    assert measures.imports("bondem.run", ast.parse(text)) == {
        "bondem.errors", "bondem.dynamics.plan", "bondem.model.state"
    }  # fmt: skip


def test_a_public_name_stands_for_one_thing():
    known = {"bd.pack", "bd.labtests.static_tension", "bd.errors.InputError", "bd.materials.granite"}
    assert known <= set(measures.public_interface())
    assert not measures.names_reached_twice()
    assert not measures.modules_like_public_names()


def test_no_public_name_is_defined_twice():
    assert not measures.names_defined_twice()


def test_no_pass_has_many_tables():
    long = [str(m) for m in measures.argument_lists() if m.count > MOST_TABLES]
    assert not long


def test_tables_are_counted():
    counted = {m.name: m.count for m in measures.argument_lists()}
    assert counted["steps.beam_loads.add_beam_loads"] == 3
