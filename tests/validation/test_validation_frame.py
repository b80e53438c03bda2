"""The frame of the studies: what makes a row stale, and that every study goes on where it was."""

import json
import shutil

import pytest

from validation.frame.runner import run
from validation.frame.sources import ROOTS, closure, closure_hash, commit
from validation.studies.wave import WaveStudy

ROWS = ("validation.rows.packings", "validation.rows.elastic", "validation.rows.surface", "validation.studies.wave")
# What the numbers of all of these hang on, by imports of imports.
DEEP = ("bondem/interactions/beams/bond_law.py", "bondem/interactions/beams/beam_tables.py",
        "bondem/specimen/fabric.py",
        "bondem/packing/soft_spheres.py", "bondem/labtests/isotropic.py", "bondem/statics/linear.py")  # fmt: skip


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """A copy of the sources, to be edited."""
    folder = tmp_path_factory.mktemp("copy")
    for name, root in ROOTS.items():
        shutil.copytree(root, folder / name, ignore=shutil.ignore_patterns("__pycache__", "build", "libraries"))
    return {name: folder / name for name in ROOTS}


@pytest.mark.parametrize("module", [ROWS[0], *(pytest.param(one, marks=pytest.mark.validate) for one in ROWS[1:])])
def test_a_change_in_any_imported_module_makes_rows_stale(module, copy):
    names = closure(module, copy)
    assert names == closure(module, ROOTS)
    before = closure_hash(module, copy)
    assert before == closure_hash(module, ROOTS)
    for path in {copy["bondem"].parent / name for name in DEEP}:
        imported = ".".join(path.relative_to(copy["bondem"].parent).with_suffix("").parts) in names
        text = path.read_text()
        path.write_text(text + "\n# edited\n")
        assert (closure_hash(module, copy) != before) is imported, path
        path.write_text(text)
    assert closure_hash(module, copy) == before


def test_what_measures_is_in_the_closure_and_what_draws_is_not():
    measured = closure("validation.rows.elastic", ROOTS)
    assert {"bondem.labtests.isotropic", "bondem.interactions.beams.beam_tables", "bondem._core"} <= measured
    assert not {name for name in measured if name.startswith(("bondem.report", "validation.figures", "bondem.cli"))}
    plate = closure("validation.rows.kalthoff", ROOTS)  # takes all names from the package
    assert {"bondem.damage.criteria.rankine", "bondem.packing.even", "bondem.errors"} <= plate
    assert not {name for name in plate if name.startswith(("bondem.report", "bondem.cli", "bondem.calibration"))}


def test_sources_of_the_core_count(copy):
    before = closure_hash("validation.rows.packings", copy)
    path = copy["bondem"] / "core/passes/packing/relaxation.cpp"
    text = path.read_text()
    path.write_text(text + "\n// edited\n")
    assert closure_hash("validation.rows.packings", copy) != before
    path.write_text(text)


def test_data_beside_a_module_count(copy):
    path = next(copy["bondem"].joinpath("calibration").glob("*.json"))
    before = closure_hash("bondem.calibration.surface_correction", copy)
    text = path.read_text()
    path.write_text(text + " ")
    assert closure_hash("bondem.calibration.surface_correction", copy) != before
    path.write_text(text)


@pytest.mark.validate  # `test_validation_fracture` has a study that keeps its rows
def test_a_study_of_bars_goes_on_with_what_is_there(tmp_path):
    study = WaveStudy(count=600, packings=2)
    first = run(study, tmp_path, processes=1, command="by a test")
    assert (first["command"], first["commit"]) == ("by a test", commit())
    rows = sorted((tmp_path / "rows").iterdir())
    lost = next(path for path in rows if path.name.startswith(type(study.calibrated_tests(tmp_path)[0]).__name__))
    kept = {path: path.stat().st_mtime_ns for path in rows if path != lost}
    lost.unlink()
    (tmp_path / "results.json").unlink()
    again = run(study, tmp_path, processes=1, command="by a test")
    assert lost.is_file()
    assert {path: path.stat().st_mtime_ns for path in kept} == kept

    def timeless(value):
        if isinstance(value, dict):
            return {key: timeless(one) for key, one in value.items() if "seconds" not in key}
        return [timeless(one) for one in value] if isinstance(value, list) else value

    assert timeless(again) == timeless(first)
    assert json.loads((tmp_path / "results.json").read_text()) == json.loads(json.dumps(again))
