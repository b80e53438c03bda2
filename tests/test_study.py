"""Studies: what a file says, and what the pipeline makes of it."""

import json
import runpy
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.io.runfile import read_run
from bondem.study.pipeline import run_study
from bondem.study.results import deviation
from bondem.study.study import TESTS, Study, parse_study, read_study

EXAMPLE = Path(__file__).parents[1] / "examples" / "silica.toml"

SMALL = {
    "name": "small",
    "seed": 7,
    "packings": 2,
    "tests": ["static_tension", "static_bending"],
    "material": {"name": "glass", "E": 70e9, "nu": 0.2, "rho": 2500.0},
    "specimen": {"shape": "cylinder", "radius": 5e-3, "length": 30e-3, "count": 500},
    "output": {"figures": False, "vtk": True, "run_files": True},
}


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    out = tmp_path_factory.mktemp("study") / "deep" / "out"
    stages = []
    results = run_study(parse_study(SMALL), out, progress=lambda stage, share: stages.append((stage, share)))
    return out, results, stages


def test_the_example_says_what_the_issue_asks_for():
    study = read_study(EXAMPLE)
    assert study.material == bd.Material("fused silica", E=72.5e9, nu=0.17, rho=2201.0)
    assert study.specimen.shape == bd.Cylinder(radius=5e-3, length=40e-3)
    assert (study.specimen.count, study.specimen.spread, study.packings, study.calibrating) == (10_000, 0.25, 2, 1)
    assert study.tests == TESTS
    assert study.bond.law is bd.EulerBernoulli
    assert study.reference is not None
    assert study.reference.errors["dynamic_bending"] == 0.0663


def test_defaults_are_those_of_the_dataclass():
    bare = {key: SMALL[key] for key in ("name", "material", "specimen")}
    study = parse_study(bare)
    assert study == Study(name="small", material=study.material, specimen=study.specimen)


def test_every_option_is_read():
    data = SMALL | {
        "specimen": {
            "shape": "box", "size": [1e-2, 1e-2, 4e-2], "count": 800, "spread": 0.1, "coordination_number": 6.0,
        },
        "bond": {"law": "Timoshenko", "nu_mu": 0.2, "reach": 1.05, "radius_rule": "pair_min"},
        "calibration": {"packings": 2},
        "tests": [],
    }  # fmt: skip
    study = parse_study(data)
    assert study.specimen.shape == bd.Box((1e-2, 1e-2, 4e-2))
    assert study.specimen.coordination_number == 6.0
    assert (study.bond.law, study.bond.reach, study.bond.tolerance) == (bd.Timoshenko, 1.05, None)
    assert (study.calibrating, study.tests) == (2, ())


def test_the_command_line_overrules():
    study = read_study(EXAMPLE)
    assert study.changed() == study
    assert study.changed(packings=5, seed=9).packings == 5
    assert study.changed(seed=9).seed == 9


def test_results_have_the_pinned_layout(finished):
    out, results, _ = finished
    text = (out / "results.json").read_text()
    assert json.loads(text) == results
    assert "NaN" not in text
    assert "Infinity" not in text
    assert set(results["specimen"]) == {
        "elements", "bonds", "volume_fraction", "coordination_number", "isotropy_error", "rattlers",
    }  # fmt: skip
    assert set(results["micro"]) == {"law", "E_mu", "nu_mu", "r_mu_ratio", "rho_mu"}
    assert set(results["macro"]) == {"E", "nu", "rho", "E_std", "nu_std"}
    assert list(results["tests"]) == SMALL["tests"]
    for row in results["tests"].values():
        assert set(row) == {"measured", "theory", "theory_timoshenko", "error", "scatter", "unit"}
    assert set(results["timing"]) == {"pack_s", "calibrate_s", "tests_s"}
    assert (results["version"], results["seed"]) == (bd.__version__, 7)


def test_the_specimen_is_calibrated_and_its_mass_is_right(finished):
    _, results, _ = finished
    macro = results["macro"]
    assert macro["E"] == pytest.approx(70e9, rel=2e-3)
    assert macro["nu"] == pytest.approx(0.2, abs=1e-3)
    assert macro["rho"] == pytest.approx(2500.0, rel=1e-12)


def test_aggregates_are_those_of_the_packings(finished):
    _, results, _ = finished
    packings = results["packings"]
    assert [one["seed"] for one in packings] == [7, 8]
    assert [one["calibrating"] for one in packings] == [True, False]
    assert results["macro"]["E_std"] == pytest.approx(np.std([one["E"] for one in packings], ddof=1))
    for name, row in results["tests"].items():
        errors = [one["tests"][name]["measured"] / one["tests"][name]["theory"] - 1.0 for one in packings]
        assert row["error"] == pytest.approx(np.mean(errors))
        assert row["scatter"] == pytest.approx(np.std(errors, ddof=1))
    assert packings[0]["E"] != packings[1]["E"]


def test_stages_are_told_and_end_at_one(finished):
    _, _, stages = finished
    last = {}
    for stage, share in stages:
        assert 0.0 <= share <= 1.0
        last[stage] = share
    assert list(last) == ["pack 1 of 2", "pack 2 of 2", "calibrate", "test 1 of 2", "test 2 of 2", "report"]
    assert set(last.values()) == {1.0}


def test_output_is_complete_and_nothing_else(finished):
    out, _, _ = finished
    assert sorted(path.name for path in out.iterdir()) == [
        "report.html", "results.json", "specimen.vtkhdf", "specimen_7.h5", "specimen_8.h5",
    ]  # fmt: skip


def test_a_kept_specimen_is_the_calibrated_one(finished):
    out, results, _ = finished
    model = read_run(out / "specimen_8.h5").model
    tension = bd.labtests.static_tension(model.lattice, model.bond)
    assert pytest.approx(results["packings"][1]["E"], rel=1e-9) == tension.E
    assert model.density == results["micro"]["rho_mu"]
    assert bd.resume(out / "specimen_8.h5").steps == 0


def test_a_single_packing_has_no_scatter(tmp_path):
    study = parse_study(SMALL | {"packings": 1, "tests": ["static_torsion"]})
    results = run_study(study, tmp_path)
    assert results["macro"]["E_std"] is None
    assert results["tests"]["static_torsion"]["scatter"] is None
    assert deviation([1.0]) is None


def test_the_python_example():
    path = Path(__file__).parents[1] / "examples" / "silica.py"
    answer = runpy.run_path(str(path))["main"](count=800)
    assert answer.E == pytest.approx(72.5e9, rel=2e-3)  # noqa: SIM300
    assert answer.nu == pytest.approx(0.17, abs=1e-3)
    assert 0.6 < answer.radius_ratio < 0.8
    assert abs(answer.frequency_error) < 0.1
    assert abs(answer.frequency_error_timoshenko) < 0.05
