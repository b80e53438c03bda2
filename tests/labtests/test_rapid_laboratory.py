"""Crushing, impact and spalling as users call them: what is refused, and studies of them."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StudyError
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study, read_study
from tests.drawings import only
from tests.specimens import ball, bar, spheres

LAW = bd.CellBond(E=30e9, nu=0.2)
CONCRETE = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61, fracture_energy=20.0)


SPECIMENS = {"ball": lambda: ball(150, 10e-3), "bar": lambda: bar(150, 60e-3, 8e-3)}
USUAL: dict[str, tuple[str, Any, dict[str, Any]]] = {
    "sphere_crushing": ("ball", CONCRETE, {"traverses": 40.0}),
    "sphere_impact": ("ball", None, {"density": 2400.0, "velocity": 1.0}),
    "spall": ("bar", None, {"density": 2400.0, "pressure": 1e6, "rise": 4e-6, "fall": 6e-6}),
}  # fmt: skip
PLANE = bd.PlaneWall((-9e-3, 0.0, 0.0), (1.0, 0.0, 0.0))
FAR = bd.PlaneWall((-90e-3, 0.0, 0.0), (1.0, 0.0, 0.0))
MOVING = bd.PlaneWall((-12e-3, 0.0, 0.0), (1.0, 0.0, 0.0), motion=bd.Driven(vx=1.0))
WRONG: dict[str, tuple[str, str, dict[str, Any]]] = {
    "crushing of a bar": ("sphere_crushing", "not a ball", {"specimen": "bar"}),
    "crushing of what never breaks": ("sphere_crushing", "failure = None", {"failure": None}),
    "plates too fast": ("sphere_crushing", "traverses = 0.5", {"traverses": 0.5}),
    "an ending above the peak": ("sphere_crushing", "ending = 1", {"ending": 1.0}),
    "fines larger than the ball": ("sphere_crushing", "fine = 2", {"fine": 2.0}),
    "a bar thrown": ("sphere_impact", "not a ball", {"specimen": "bar"}),
    "a plane inside of the ball": ("sphere_impact", "inside the ball", {"wall": PLANE}),
    "a plane far off": ("sphere_impact", "closer than a diameter", {"wall": FAR}),
    "a plane that moves": ("sphere_impact", "wall moves", {"wall": MOVING}),
    "another wall": ("sphere_impact", "PlaneWall", {"wall": bd.SphereWall(1.0)}),
    "a ball that flies away": ("sphere_impact", "points away", {"velocity": (1.0, 0.0, 0.0)}),
    "no speed": ("sphere_impact", "velocity = 0", {"velocity": 0.0}),
    "a ball that spalls": ("spall", "no face 'x_min'", {"specimen": "ball"}),
    "a pulse longer than there and back": ("spall", "shorter pulse", {"fall": 60e-6}),
    "no pressure": ("spall", "pressure = 0", {"pressure": 0.0}),
    "no bins": ("spall", "bins = 0", {"bins": 0}),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_refused_in_a_line(case: str) -> None:
    name, message, changed = WRONG[case]
    which, failure, usual = USUAL[name]
    asked = dict(changed)
    specimen = SPECIMENS[asked.pop("specimen", which)]()
    failure = asked.pop("failure", failure)
    with pytest.raises(InputError, match=message) as caught:
        getattr(bd.labtests, name)(specimen, LAW, failure, **(usual | asked))
    assert "\n" not in str(caught.value)


def test_spheres_do_not_spall() -> None:
    with pytest.raises(InputError, match="method='laguerre'"):
        bd.labtests.spall(spheres(bd.Box((4e-3, 4e-3, 4e-3)), 300), LAW, None, **USUAL["spall"][2])


@pytest.mark.validate
def test_balls_of_beams_are_crushed_and_thrown() -> None:
    beams = spheres(bd.Ball(10e-3), 300)
    law = bd.EulerBernoulli(E=60e9, nu=0.2, radius_ratio=0.6)
    failure = bd.PeripheralStress(tension=30e6, shear=60e6)
    crushed = bd.labtests.sphere_crushing(beams, law, failure, traverses=60.0)
    assert crushed.peak > 0.0
    assert 0.0 < crushed.broken.damage < 1.0
    assert crushed.residual < 2e-3
    thrown = bd.labtests.sphere_impact(beams, law, failure, density=2400.0, velocity=3.0)
    assert 0.0 < thrown.damage < 1.0
    assert thrown.momentum < 1e-3


def test_a_wall_that_is_given_is_the_one_that_is_left_out() -> None:
    usual = bd.labtests.sphere_impact(ball(150, 10e-3), LAW, density=2400.0, velocity=1.0)
    reach = float((bd.Model(ball(150, 10e-3), LAW, 1.0).contact_radius - ball(150, 10e-3).centre[:, 0]).max())
    wall = bd.PlaneWall((-reach, 0.0, 0.0), (1.0, 0.0, 0.0), friction=0.0)
    own = bd.labtests.sphere_impact(ball(150, 10e-3), LAW, density=2400.0, velocity=(-1.0, 0.0, 0.0), wall=wall)
    np.testing.assert_allclose(own.force, usual.force, rtol=1e-6, atol=1e-6 * usual.peak)


def test_a_spall_test_is_as_long_and_fine_as_asked() -> None:
    usual = USUAL["spall"][2]
    test = bd.labtests.spall(bar(150, 60e-3, 8e-3), LAW, None, bins=7, duration=20e-6, **usual)
    assert len(test.profile) == 7
    np.testing.assert_allclose(np.diff(test.edges), 60e-3 / 7)
    assert test.time[-1] == pytest.approx(20e-6, rel=0.01)


def test_fines_are_below_the_size_asked() -> None:
    failure = bd.Rankine(tension=2e6)
    usual = {"density": 2400.0, "velocity": 6.0}
    few, many = (
        bd.labtests.sphere_impact(ball(150, 10e-3), LAW, failure, fine=share, **usual).broken for share in (0.2, 0.9)
    )
    for one, share in ((few, 0.2), (many, 0.9)):
        small = one.sizes.diameter < share * 20e-3
        steps = np.diff(one.sizes.passing, prepend=0.0)
        assert one.fines == pytest.approx(steps[small].sum())
    assert few.fines < many.fines


STUDY: dict[str, Any] = {
    "name": "concrete", "packings": 1, "tests": ["sphere_impact"],
    "material": {"name": "concrete", "E": 40e9, "nu": 0.2, "rho": 2400.0},
    "failure": {
        "criterion": "MohrCoulomb", "tension": "4 MPa", "cohesion": "14.3 MPa", "friction_angle": "35 deg",
        "fracture_energy": 20.0,
    },
    "specimen": {"shape": "ball", "radius": "10 mm", "count": 150, "method": "even"},
    "bond": {"law": "CellBond"}, "output": {"figures": True}, "sphere_impact": {"velocity": 5.0},
}  # fmt: skip
BAR = {"shape": "box", "size": [60e-3, 8e-3, 8e-3], "count": 200, "method": "even"}


def study(**changed: Any) -> Any:
    return parse_study({key: value for key, value in (STUDY | changed).items() if value is not None})


@pytest.mark.validate
def test_a_study_crushes_and_throws_balls(tmp_path: Path) -> None:
    asked = study(tests=["sphere_crushing", "sphere_impact"], sphere_crushing={"friction": 0.3})
    with only("broken"):
        run_study(asked, tmp_path)
    results = json.loads((tmp_path / "results.json").read_text())
    crushed, thrown = (results["packings"][0]["tests"][name] for name in ("sphere_crushing", "sphere_impact"))
    assert crushed["unit"] == "Pa"
    assert crushed["measured"] > 0.0
    assert thrown["measured"] > 0.0
    assert crushed["failure"]["pieces"] + crushed["failure"]["crumbs"] > 1
    assert results["macro"]["E"] is None
    assert (tmp_path / "figures" / "broken.png").stat().st_size > 10_000
    assert "restitution" in (tmp_path / "report.html").read_text()


def test_a_study_spalls_a_bar(tmp_path: Path) -> None:
    pulse = {"pressure": "8 MPa", "rise": "4 us", "fall": "6 us"}
    asked = study(tests=["spall"], specimen=BAR, sphere_impact=None, spall=pulse, output={"figures": False})
    run_study(asked, tmp_path)
    results = json.loads((tmp_path / "results.json").read_text())
    assert results["tests"]["spall"]["theory"] == 4e6
    told = results["packings"][0]["tests"]["spall"]["told"]
    sound = np.sqrt(40e9 / 2400.0)
    assert told["highest velocity [m/s]"] == pytest.approx(2.0 * 8e6 / (2400.0 * sound), rel=0.3)  # a short pulse


REFUSED: dict[str, tuple[str, dict[str, Any]]] = {
    "no velocity": (r"sphere_impact\.velocity", {"sphere_impact": None}),
    "a bar thrown": ("ball", {"specimen": BAR}),
    "a ball pulled": ("needs a bar", {"tests": ["direct_tension"], "sphere_impact": None}),
    "a pulse without its fall": (r"spall\.fall", {
        "tests": ["spall"], "specimen": BAR, "sphere_impact": None, "spall": {"pressure": 1e6, "rise": 1e-6},
    }),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_studies_that_cannot_be_are_refused(case: str) -> None:
    message, changed = REFUSED[case]
    with pytest.raises(StudyError, match=message):
        study(**changed)


@pytest.mark.parametrize("name", ["sphere_crushing", "sphere_impact"])
def test_examples_can_be_read(name: str) -> None:
    asked = read_study(Path(__file__).parents[2] / "examples" / f"{name}.toml")
    assert asked.tests == (name,)
