"""`bondem calibrate` and the study of coverage: what they print, write and refuse."""

import json

import numpy as np
import pytest

import bondem as bd
from bondem.cli import bondem as group
from bondem.errors import InputError
from bondem.study.calibration_step import CalibrationPlan, run_calibration
from tests.scripts import command
from tests.specimens import spheres
from validation.frame.runner import run
from validation.studies.coverage import Coverage


def test_from_three_numbers_to_bonds(tmp_path):
    target = ["--E", 72.5e9, "--nu", 0.17, "--rho", 2201, "--law", "euler-bernoulli"]
    done = command("calibrate", *target, "--count", 300, "--packings", 3, "--out", "fit", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert "Euler–Bernoulli bonds" in done.stdout
    found = json.loads((tmp_path / "fit" / "calibration.json").read_text())
    assert (tmp_path / "fit" / "calibration.png").stat().st_size > 10_000
    # what is written works: the same cells with these bonds have the material's moduli
    law = bd.EulerBernoulli(
        E=found["micro"]["E_mu"], nu=found["micro"]["nu_mu"], radius_ratio=found["micro"]["radius_ratio"]
    )
    cells = [spheres(bd.Cell((10e-3,) * 3), 300, seed=seed) for seed in (1, 2, 3)]
    moduli = [bd.bulk_moduli(cell, law) for cell in cells]
    assert np.mean([one.E for one in moduli]) == pytest.approx(72.5e9, rel=1e-8)
    assert np.mean([one.nu for one in moduli]) == pytest.approx(0.17, abs=1e-5)
    assert found["quantities"]["E"]["prediction_95"] == pytest.approx(
        bd.Sample(np.array([one.E for one in moduli])).interval(kind="prediction"), rel=1e-8
    )
    assert found["micro"]["rho_mu"] == pytest.approx(
        2201.0 * 3e-6 / sum(cell.particles.volume[cell.connected].sum() for cell in cells)
    )


def test_a_material_of_the_library_gets_the_recommended_law():
    plan = CalibrationPlan(material=bd.materials.granite, count=500, packings=1)
    fit, found = run_calibration(plan)
    assert found["law"] == "EulerBernoulli"
    assert "reach" in found["reason"]
    assert found["quantities"]["E"]["std"] is None
    assert found["quantities"]["nu"]["prediction_95"] is None
    assert pytest.approx(bd.materials.granite.E, rel=1e-9) == fit.E


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--E", "70e9"], "--nu and --rho missing"),
        (["--material", "granit"], "granite"),
        (["--E", "70e9", "--nu", "0.7", "--rho", "2500"], r"nu = 0\.7"),
        (["--E", "70e9", "--nu", "0.48", "--rho", "2500"], r"nu = 0\.48: no bond law reaches"),
        (["--E", "70e9", "--nu", "0.05", "--rho", "2500", "--law", "timoshenko", "--count", "300", "--packings", "1"],
         ": outside"),
    ],
)  # fmt: skip
def test_what_cannot_be_done_is_said(arguments, message):
    with pytest.raises(bd.errors.BondemError, match=message):
        group.main(["calibrate", *arguments], standalone_mode=False)


def test_bad_plans_are_refused():
    with pytest.raises(InputError, match="shape = 'ball'"):
        CalibrationPlan(material=bd.materials.granite, shape="ball")
    with pytest.raises(InputError, match="packings = 0"):
        CalibrationPlan(material=bd.materials.granite, packings=0)
    with pytest.raises(InputError, match="at least 2"):
        Coverage(calibrating=1)


@pytest.mark.validate
def test_coverage_counts_what_lies_in_the_interval(tmp_path):
    study = Coverage(count=500, calibrating=4, held_out=6, shape="cell")
    results = run(study, tmp_path, processes=1)
    for name in ("E", "nu"):
        found = results["quantities"][name]
        values = np.array(found["values"])
        low, high = bd.Sample(values[:4]).interval(kind="prediction")
        assert found["prediction"] == pytest.approx([low, high], rel=1e-4)
        assert found["covered"] == sum(low <= value <= high for value in values[4:])
        assert found["coverage"]["2"]["mean"] == pytest.approx(0.95, abs=0.05)
    # the calibrating packings have fused silica's moduli, and an unseen one is computed anew
    assert np.mean(results["quantities"]["E"]["values"][:4]) == pytest.approx(72.5e9, rel=1e-5)
    unseen = spheres(bd.Cell((10e-3,) * 3), 500, seed=7)
    law = bd.EulerBernoulli(E=results["E_mu"], nu=0.3, radius_ratio=results["value"])
    assert results["quantities"]["nu"]["values"][6] == pytest.approx(bd.bulk_moduli(unseen, law).nu, rel=1e-4)
    assert {path.name for path in tmp_path.iterdir()} >= {"results.json", "table.md", "report.html", "figures"}
