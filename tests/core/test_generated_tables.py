"""Named tuples of Python, descriptions of C++ and functions of passes are what headers and the library give."""

import pytest

from bondem.dynamics.on_device.counterparts import COUNTERPARTS
from tests.core import passes, tables
from tests.core.launched_passes import launched


def test_generated_tables_are_those_of_the_headers():
    assert not [path.name for path in tables.stale()], "run: python -m tests.core.tables"


def test_generated_functions_are_those_of_the_library():
    assert not passes.stale(), "run: python -m tests.core.passes"


@pytest.mark.parametrize("words", ["", "The same for beams.", "Those of all beams in any poses."])
def test_a_pass_needs_a_sentence_of_its_own(words):
    with pytest.raises(SystemExit, match="load_beams: write a comment"):
        passes.sentence("load_beams", words)


def test_launches_of_counterparts_are_read_from_the_sources():
    read = launched()
    softened = {name for name in COUNTERPARTS if "_softening_by_" in name}  # of two families in one
    assert not [name for name in set(COUNTERPARTS) - softened if not name.startswith(tuple(read))]
    assert read["stress_cells"] == {"set_stress"}
    assert read["judge_facets_by_"] > {"judge_facet_by_"}
    assert read["follow_strains"] == {"follow_strain_factors", "stretch_strained_beam", "add_work_of_strains"}
