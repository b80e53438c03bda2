"""Named tuples of Python, descriptions of C++ and functions of passes are what headers and the library give."""

import pytest

from tests.core import passes, tables


def test_generated_tables_are_those_of_the_headers():
    assert not [path.name for path in tables.stale()], "run: python -m tests.core.tables"


def test_generated_functions_are_those_of_the_library():
    assert not passes.stale(), "run: python -m tests.core.passes"


@pytest.mark.parametrize("words", ["", "The same for beams.", "Those of all beams in any poses."])
def test_a_pass_needs_a_sentence_of_its_own(words):
    with pytest.raises(SystemExit, match="load_beams: write a comment"):
        passes.sentence("load_beams", words)
