"""Tests of the laboratory as users call them: what they refuse, what they do not depend on, and studies of them."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StudyError
from bondem.labtests.energy_balance import energy_ledger
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study, read_study
from tests.drawings import only
from tests.specimens import cells, spheres

LAW = bd.CellBond(E=40e9, nu=0.2)
CONCRETE = bd.MohrCoulomb(tension=4e6, cohesion=14.3e6, friction_angle=math.radians(35.0), fracture_energy=20.0)
BRITTLE = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.6)
STUDY: dict[str, Any] = {
    "name": "concrete", "packings": 1, "tests": ["brazilian"],
    "material": {"name": "concrete", "E": 40e9, "nu": 0.2, "rho": 2400.0},
    "failure": {
        "criterion": "MohrCoulomb", "tension": "4 MPa", "cohesion": "14.3 MPa", "friction_angle": "35 deg",
        "fracture_energy": 20.0,
    },
    "specimen": {"shape": "cylinder", "radius": "10 mm", "length": "10 mm", "count": 250, "method": "even"},
    "bond": {"law": "CellBond"}, "output": {"figures": False},
}  # fmt: skip
BEAM = {"shape": "box", "size": [40e-3, 10e-3, 10e-3], "count": 200, "method": "even"}

SHAPES: dict[str, bd.Shape] = {
    "disc": bd.Cylinder(radius=10e-3, length=10e-3), "prism": bd.Box((20e-3, 10e-3, 10e-3)),
    "beam": bd.Box((40e-3, 10e-3, 10e-3)), "ball": bd.Ball(10e-3), "core": bd.labtests.punch_specimen(),
    "holed": bd.Box((40e-3, 10e-3, 10e-3)).cut(
        bd.Box((4e-3, 4e-3, 30e-3)).moved((18e-3, 3e-3, -10e-3)), name="notch"
    ),
    "slotted": bd.Box((40e-3, 10e-3, 10e-3)).cut(
        bd.Box((4e-3, 30e-3, 4e-3)).moved((18e-3, -10e-3, -1e-9)), name="notch"
    ),
}  # fmt: skip
TESTS = {
    "brazilian": ("disc", {}), "triaxial": ("prism", {"pressure": 5e6}), "three_point_bending": ("beam", {}),
    "shear": ("core", {}),
}  # fmt: skip


def run(name: str, specimen: bd.Lattice | None = None, failure: Any = CONCRETE, law: Any = LAW, **given: Any) -> Any:
    which, usual = TESTS[name]
    return getattr(bd.labtests, name)(specimen or cells(SHAPES[which], 250), law, failure, **(usual | given))


@pytest.mark.validate
@pytest.mark.parametrize("name", ["brazilian", "shear"])
def test_nothing_depends_on_density(name: str) -> None:
    light, heavy = (run(name, density=rho, traverses=10.0) for rho in (1.0, 9e3))
    assert heavy.peak == pytest.approx(light.peak, rel=1e-5)
    assert pytest.approx(light.E, rel=1e-5) == heavy.E


@pytest.mark.parametrize("name", TESTS)
def test_what_a_test_needs_is_told(name: str) -> None:
    with pytest.raises(InputError, match="fracture_energy"):
        run(name, failure=BRITTLE)
    with pytest.raises(InputError, match="failure = None"):
        run(name, failure=None)
    with pytest.raises(InputError, match="method='laguerre'"):
        run(name, specimen=spheres(bd.Box((4e-3, 4e-3, 4e-3)), 300))
    with pytest.raises(InputError, match=r"bd\.CellBond"):
        run(name, law=bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5))


WRONG: dict[str, tuple[str, str, dict[str, Any]]] = {
    "a prism in the Brazilian test": ("brazilian", "not a cylinder along x", {"specimen": "prism"}),
    "strips too wide": ("brazilian", "half_angle = 0.8", {"half_angle": 0.8}),
    "strips without a cell": ("brazilian", "contains no cell", {"half_angle": 1e-6}),
    "an ending above the peak": ("brazilian", "ending = 1.5", {"ending": 1.5}),
    "too fast": ("brazilian", "traverses = 0.5", {"traverses": 0.5}),
    "a density of zero": ("brazilian", "density = 0", {"density": 0.0}),
    "pressure that is never tension": ("brazilian", "tensile strength", {"failure": bd.Hydrostatic(tension=1e6)}),
    "no pressure": ("triaxial", "uniaxial_compression", {"pressure": 0.0}),
    "a text": ("triaxial", "pressure = '5 MPa'", {"pressure": "5 MPa"}),
    "cells that do not yield": ("triaxial", "shear strength", {"failure": bd.Rankine(tension=4e6)}),
    "a ball in bending": ("three_point_bending", "no face 'x_min'", {"specimen": "ball"}),
    "a hole in place of a notch": ("three_point_bending", "cut a single notch", {"specimen": "holed"}),
    "a slot in a side": ("three_point_bending", "cut a single notch", {"specimen": "slotted"}),
    "a span too long": ("three_point_bending", "half a strip beyond each support", {"span": 40e-3}),
    "a span too short": ("three_point_bending", "at least the depth", {"span": 5e-3}),
    "a strip of nothing": ("three_point_bending", "strip = 0", {"strip": 0.0}),
    "another criterion": ("three_point_bending", "principal stress", {"failure": bd.Hydrostatic(tension=1e6)}),
    "no borings": ("shear", "punch_specimen", {"specimen": "disc"}),
    "a beam in the shear test": ("shear", "punch_specimen", {"specimen": "beam"}),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_refused_in_a_line(case: str) -> None:
    name, message, given = WRONG[case]
    asked = {key: cells(SHAPES[value], 250) if key == "specimen" else value for key, value in given.items()}
    with pytest.raises(InputError, match=message) as caught:
        run(name, **asked)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "sizes", [{"ring": 160e-3}, {"width": 45e-3}, {"depth": 40e-3}, {"diameter": 0.0}, {"height": math.nan}]
)
def test_borings_have_to_fit(sizes: dict[str, float]) -> None:
    with pytest.raises(InputError, match="punch_specimen"):
        bd.labtests.punch_specimen(**sizes)


def test_a_specimen_with_borings_has_their_volume() -> None:
    shape = bd.labtests.punch_specimen(diameter=0.1, height=0.05, ring=0.04, width=0.006, depth=0.01)
    ring = math.pi * 0.04 * 0.006
    assert shape.volume == pytest.approx(math.pi * 0.05**2 * 0.05 - 2.0 * ring * 0.01, rel=2e-3)
    assert "boring" in shape.faces
    # nothing but its own surface is near: no wall within the core at the height of the borings' ends
    along = np.array([[x, 0.0, 0.0] for x in (0.001, 0.009, 0.0101, 0.0399, 0.0401, 0.045)])
    np.testing.assert_allclose(shape.depth(along), np.minimum(along[:, 0], 0.05 - along[:, 0]), atol=1e-12)


def test_bending_takes_the_tension_of_mohr_and_coulomb() -> None:
    """With its scatter and its curve; cells do not yield."""
    both = [
        run("three_point_bending", most=30, failure=failure)
        for failure in (CONCRETE, bd.Rankine(tension=4e6, fracture_energy=20.0))
    ]
    np.testing.assert_array_equal(both[0].curve, both[1].curve)
    assert both[0].curve.shape == (31, 2)
    assert both[0].E == both[1].E


@pytest.mark.validate
def test_the_work_of_the_rollers_is_stored_or_dissipated() -> None:
    """But for the distance of a strip's cells from its line, at most half a cell in half the span: 8 %."""
    test = run("three_point_bending", most=400, ripple=0.5)
    ledger = energy_ledger(test)
    assert all(len(along) == len(test.curve) for along in ledger.values())
    np.testing.assert_allclose(ledger["fracture"][2:], np.cumsum(test.path.energy)[:-1])
    assert ledger["fracture"][-1] > 0.3 * ledger["work"][-1]
    assert np.abs(ledger["balance"]).max() < 0.08 * ledger["work"][-1]


def study(**changed: Any) -> Any:
    return parse_study({key: value for key, value in (STUDY | changed).items() if value is not None})


@pytest.mark.validate
def test_a_study_splits_and_confines(tmp_path: Path) -> None:
    asked = study(tests=["static_tension", "brazilian", "triaxial"], triaxial={"pressure": "5 MPa"})
    assert asked.options == {"brazilian": {}, "triaxial": {"pressure": 5e6}}
    results = run_study(asked, tmp_path)
    split, pressed = results["tests"]["brazilian"], results["tests"]["triaxial"]
    assert split["theory"] == 4e6
    assert 0.0 < split["error"] < 0.25  # a disc of 0.4 E G_f / f_t² redistributes stress before it splits
    sine = math.sin(math.radians(35.0))
    assert pressed["theory"] == pytest.approx(54.94e6 + 5e6 * (1.0 + sine) / (1.0 - sine), rel=1e-3)
    assert pressed["error"] == pytest.approx(0.0, abs=0.05)


@pytest.mark.parametrize("name", [pytest.param("three_point_bending", marks=pytest.mark.validate), "shear"])
def test_a_study_of_a_cut_specimen_breaks_it_only(name: str, tmp_path: Path) -> None:
    notched = BEAM | {"notch": {"width": "1 mm", "depth": "3 mm"}}
    punch = {"shape": "punch", "diameter": "0.1 m", "height": "60 mm", "count": 300, "method": "even"}
    specimen = notched if name == "three_point_bending" else punch
    with only("broken"):
        results = run_study(study(tests=[name], specimen=specimen, output={"figures": True}), tmp_path)
    row = results["tests"][name]
    assert row["theory"] is None
    assert row["error"] is None
    assert row["measured"] > 4e6
    assert results["macro"]["E"] is None
    assert (tmp_path / "figures" / "broken.png").stat().st_size > 10_000
    assert "Tests to failure" in (tmp_path / "report.html").read_text()


REFUSED: dict[str, tuple[str, dict[str, Any]]] = {
    "no pressure": (r"triaxial\.pressure", {"tests": ["triaxial"]}),
    "a table without its test": ("does not contain triaxial", {"triaxial": {"pressure": 5e6}}),
    "misspelt": (r"unknown key 'brazilian\.half_angel'", {"brazilian": {"half_angel": 0.1}}),
    "a box across a diameter": ("cylinder", {"specimen": BEAM}),
    "a bent cylinder": ("box", {"tests": ["three_point_bending"]}),
    "no borings": ("punch", {"tests": ["shear"]}),
    "torn across borings": ("has a boring", {
        "tests": ["direct_tension"], "specimen": {"shape": "punch", "count": 300, "method": "even"}
    }),
    "a notch deeper than the beam": (r"notch\.depth", {
        "tests": ["three_point_bending"], "specimen": BEAM | {"notch": {"width": 1e-3, "depth": 20e-3}}
    }),
    "no shear strength": ("triaxial", {
        "tests": ["triaxial"], "triaxial": {"pressure": 5e6},
        "failure": {"criterion": "Rankine", "tension": 4e6, "fracture_energy": 20.0},
    }),
    "borings that do not fit": ("do not fit", {
        "tests": ["shear"], "specimen": {"shape": "punch", "ring": "0.2 m", "count": 300, "method": "even"}
    }),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_studies_that_cannot_be_are_refused(case: str) -> None:
    message, changed = REFUSED[case]
    with pytest.raises(StudyError, match=message):
        study(**changed)


@pytest.mark.parametrize("name", ["ucs", "brazilian", "shear"])
def test_examples_can_be_read(name: str) -> None:
    asked = read_study(Path(__file__).parents[2] / "examples" / f"{name}.toml")
    assert asked.tests == (name,)
