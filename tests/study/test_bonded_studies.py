"""Studies of bonded spheres to failure: criteria of bonds, what is refused, and one small study."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

import bondem as bd
from bondem.errors import InputError, StudyError
from bondem.study.calibration_step import CalibrationPlan
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study, read_study
from tests.drawings import only

STUDY: dict[str, Any] = {
    "name": "rock", "packings": 1, "tests": ["direct_tension"], "material": {"preset": "granite"},
    "failure": {"criterion": "PeripheralStress", "tension": "100 MPa", "shear": "100 MPa"},
    "specimen": {"shape": "cylinder", "radius": "3 mm", "length": "9 mm", "count": 250},
    "bond": {"law": "ParallelBond"}, "output": {"figures": True},
}  # fmt: skip
CRITERIA: dict[str, tuple[dict[str, Any], bd.Criterion]] = {
    "peripheral": (
        {"criterion": "PeripheralStress", "tension": "2 MPa", "shear": "3 MPa", "beta": 0.5, "fracture_energy": 10.0},
        bd.PeripheralStress(tension=2e6, shear=3e6, beta=0.5, fracture_energy=10.0),
    ),
    "sum": (
        {"criterion": "LinearSum", "force": 1.0, "shear_force": 2.0, "bending": 3e-3, "twisting": 4e-3},
        bd.LinearSum(force=1.0, shear=2.0, bending=3e-3, twisting=4e-3),
    ),
    "ellipse": (
        {"criterion": "Elliptic", "elongation": 1e-3, "rotation": "0.1 deg"},
        bd.Elliptic(elongation=1e-3, rotation=math.radians(0.1)),
    ),
    "mohr": (
        {"criterion": "MohrCoulomb", "tension": 1e7, "cohesion": 4e7, "friction_angle": "35 deg"},
        bd.MohrCoulomb(tension=1e7, cohesion=4e7, friction_angle=math.radians(35.0)),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CRITERIA)
def test_a_study_knows_the_criteria_of_bonds(name: str) -> None:
    given, made = CRITERIA[name]
    assert parse_study(STUDY | {"failure": given}).failure == made


REFUSED: dict[str, tuple[str, dict[str, Any]]] = {
    "a criterion of cells": ("one of cells", {"failure": {"criterion": "Rankine", "tension": 1e7}}),
    "a test of cells": ("a test of cells", {
        "tests": ["spall"], "spall": {"pressure": 1e6, "rise": 1e-6, "fall": 1e-6},
    }),
    "bonds in cells": ("one of bonds between spheres", {"bond": {"law": "CellBond"}}),
    "brittle cells": ("fracture_energy' is missing", {
        "bond": {"law": "CellBond"}, "failure": CRITERIA["mohr"][0],
    }),
    "half a criterion": ("shear' is missing", {"failure": {"criterion": "PeripheralStress", "tension": 1e7}}),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_what_bonds_cannot_have_is_refused_in_a_line(name: str) -> None:
    message, changed = REFUSED[name]
    with pytest.raises(StudyError, match=message) as caught:
        parse_study(STUDY | changed)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("message", "given"),
    [("belong together", {"ucs": 6e7}), ("need specimens with ends", {"ucs": 6e7, "tension": 8e6})],
)
def test_a_plan_of_strengths_needs_both_and_ends(message: str, given: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=message):
        CalibrationPlan(material=bd.materials.granite, **given)


def test_the_rock_template_is_a_study() -> None:
    study = read_study(Path(__file__).parents[2] / "examples" / "rock.toml")
    assert study.tests == ("ucs", "brazilian", "direct_tension")
    assert study.options["ucs"] == {"platen_friction": 0.3}


@pytest.mark.parametrize("figures", [False, pytest.param(True, marks=pytest.mark.validate)])
def test_a_study_tears_bonded_spheres(tmp_path: Path, figures: bool) -> None:
    with only("broken", "pieces"):
        results = run_study(parse_study(STUDY | {"output": {"figures": figures}}), tmp_path)
    test = results["tests"]["direct_tension"]
    assert 10e6 < test["measured"] < 100e6
    assert test["theory"] is None
    failed = results["packings"][0]["tests"]["direct_tension"]["failure"]
    assert failed["broken_bonds"] > 10
    assert failed["single_crack"] is None
    assert json.loads((tmp_path / "results.json").read_text()) == results
    for name in ("broken", "pieces") if figures else ():
        assert (tmp_path / "figures" / f"{name}.png").stat().st_size > 10_000
    page = (tmp_path / "report.html").read_text()
    assert "broken bonds" in page
    begin = page.index('id="failure"')
    assert "entered" not in page[begin : page.index("</table>", begin)]
