"""Named tuples of Python and descriptions of C++ are what the headers of tables give."""

from tests.core import tables


def test_generated_tables_are_those_of_the_headers():
    assert not [path.name for path in tables.stale()], "run: python -m tests.core.tables"
