"""Tests to failure in Python and in a study: strengths come out as they went in, and what is missing is told."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StudyError
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study
from tests.drawings import only
from tests.elastic_energy import elastic_energy
from tests.specimens import bar, spheres

LAW = bd.CellBond(E=40e9, nu=0.2)
FAILURE = bd.MohrCoulomb(
    tension=4e6, cohesion=14.3e6, friction_angle=math.radians(35.0), fracture_energy=20.0,
    fracture_energy_shear=2000.0,
)  # fmt: skip
UCS = 54.94e6  # 2 c cos φ / (1 - sin φ)
STUDY = {
    "name": "prism", "packings": 1, "tests": ["direct_tension", "ucs"],
    "material": {"name": "concrete", "E": 40e9, "nu": 0.2, "rho": 2400.0},
    "failure": {
        "criterion": "MohrCoulomb", "tension": "4 MPa", "cohesion": "14.3 MPa", "friction_angle": "35 deg",
        "fracture_energy": 20.0,
    },
    "specimen": {"shape": "box", "size": [20e-3, 10e-3, 10e-3], "count": 250, "method": "even"},
    "bond": {"law": "CellBond"}, "output": {"figures": True},
}  # fmt: skip


def test_a_prism_has_the_tensile_strength_and_fracture_energy_put_in() -> None:
    test = bd.labtests.direct_tension(bar(250, 20e-3), LAW, FAILURE)
    assert test.peak == pytest.approx(4e6, rel=0.05)
    assert test.work == pytest.approx(20.0, rel=0.08)
    assert pytest.approx(LAW.E, rel=0.01) == test.E
    assert test.residual < 1e-3
    assert test.curve[-1, 1] < 0.01 * test.peak  # remnants of facets may still join both halves


@pytest.mark.parametrize("pressure", [0.0, 10e6])
def test_a_prism_has_the_strength_of_a_mohr_coulomb_continuum(pressure: float) -> None:
    test = bd.labtests.uniaxial_compression(bar(250, 20e-3), LAW, FAILURE, pressure=pressure, reach=1.5)
    sine = math.sin(math.radians(35.0))
    assert test.peak == pytest.approx(UCS + pressure * (1.0 + sine) / (1.0 - sine), rel=0.05)
    assert test.residual < 2e-3
    slip = test.state.slipped
    assert slip.shape == (250,)
    assert (slip > 0.0).mean() > 0.5


@pytest.mark.parametrize("pressure", [0.0, pytest.param(3e6, marks=pytest.mark.validate)])
def test_a_prism_has_the_strength_of_a_drucker_prager_continuum(pressure: float) -> None:
    """(k + p (1/√3 + 2 α)) / (1/√3 - α): 54.94 MPa, and 115.25 MPa at 3 MPa; no facet cracks under pressure."""
    cone = bd.DruckerPrager(tension=4e6, compression=UCS, fracture_energy=20.0, fracture_energy_shear=2000.0)
    test = bd.labtests.uniaxial_compression(bar(1000, 20e-3), LAW, cone, pressure=pressure, reach=1.5)
    third = 1.0 / math.sqrt(3.0)
    slope, k = third * (UCS - 4e6) / (UCS + 4e6), 2.0 * third * UCS * 4e6 / (UCS + 4e6)
    assert test.peak == pytest.approx((k + pressure * (third + 2.0 * slope)) / (third - slope), rel=0.03)
    assert test.residual < 2e-3
    assert (test.state.slipped > 0.0).mean() > 0.5
    assert (test.state.bond_integrity < 1.0).mean() < 0.01


def test_a_prism_is_torn_as_the_cone_has_it() -> None:
    cone = bd.DruckerPrager(tension=4e6, compression=UCS, fracture_energy=20.0)
    test = bd.labtests.direct_tension(bar(250, 20e-3), LAW, cone)
    assert test.peak == pytest.approx(4e6, rel=0.05)
    assert test.work == pytest.approx(20.0, rel=0.08)
    assert not (test.state.slipped > 0.0).any()


def test_stresses_of_a_failing_body_are_in_equilibrium_with_its_platens() -> None:
    """Mean axial stress of the cells, where they have yielded: that of the platens; the pressure on the sides."""
    test = bd.labtests.uniaxial_compression(bar(250, 20e-3), LAW, FAILURE, pressure=5e6, reach=1.2)
    state = test.state
    assert isinstance(state.model, bd.Model)
    stress, volume = bd.cell_stress(state.model, state), state.model.lattice.cells.volume
    mean = np.einsum("n,nab->ab", volume / volume.sum(), stress)
    assert mean[0, 0] == pytest.approx(-test.curve[-1, 1], rel=0.01)
    assert mean[1, 1] == pytest.approx(-5e6, rel=0.02)
    assert mean[2, 2] == pytest.approx(-5e6, rel=0.02)
    with pytest.raises(ValueError, match=r"run\.history\.energy"):
        elastic_energy(state.model, state)
    state.set_motion(velocity=np.zeros((250, 3)))
    bd.cell_stress(state.model, state)  # velocities change no stress
    state.set_pose(position=state.position)
    with pytest.raises(InputError, match="run a step first"):
        bd.cell_stress(state.model, state)


def test_nothing_depends_on_the_density_of_a_strength_test() -> None:
    light, heavy = (bd.labtests.direct_tension(bar(60, 20e-3), LAW, FAILURE, density=rho) for rho in (1.0, 9e3))
    assert heavy.peak == pytest.approx(light.peak, rel=1e-6)
    np.testing.assert_allclose(heavy.curve[:100], light.curve[:100], rtol=1e-5, atol=1.0)


def test_what_a_test_to_failure_needs_is_told() -> None:
    brittle = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.6)
    with pytest.raises(InputError, match="fracture_energy"):
        bd.labtests.uniaxial_compression(bar(60, 20e-3), LAW, brittle)
    with pytest.raises(InputError, match=r"bd\.Rankine"):
        bd.labtests.direct_tension(bar(60, 20e-3), LAW, brittle)
    with pytest.raises(InputError, match="method='laguerre'"):
        bd.labtests.direct_tension(spheres(bd.Box((4e-3, 4e-3, 4e-3)), 300), LAW, FAILURE)
    with pytest.raises(InputError, match="pressure"):
        bd.labtests.uniaxial_compression(bar(60, 20e-3), LAW, FAILURE, pressure=-1.0)
    for wrong in ({"fracture_energy": -1.0}, {"dilatancy": 0.7, "fracture_energy": 1.0}, {"dilatancy": 0.1}):
        with pytest.raises(InputError, match="MohrCoulomb"):
            bd.MohrCoulomb(**({"tension": 4e6, "cohesion": 14e6, "friction_angle": 0.6} | wrong))
    with pytest.raises(InputError, match="Rankine"):
        bd.Rankine(tension=4e6, friction=-0.1)


@pytest.mark.validate
def test_a_study_tears_and_crushes(tmp_path: Path) -> None:
    with only("strength", "broken"):
        results = run_study(parse_study(STUDY), tmp_path)
    assert results["tests"]["direct_tension"]["error"] == pytest.approx(0.0, abs=0.05)
    assert results["tests"]["ucs"]["theory"] == pytest.approx(UCS, rel=1e-3)
    assert results["tests"]["ucs"]["error"] == pytest.approx(0.0, abs=0.1)
    assert json.loads((tmp_path / "results.json").read_text()) == results
    for name in ("strength", "broken"):
        assert (tmp_path / "figures" / f"{name}.png").stat().st_size > 10_000
    assert "Tests to failure" in (tmp_path / "report.html").read_text()


def test_a_study_knows_the_criteria_of_the_stress() -> None:
    """Their keys, with units; a brittle cone has no shear strength to crush."""
    cone = {"criterion": "DruckerPrager", "tension": "4 MPa", "hydrostatic": "3 MPa", "fracture_energy": 20.0}
    found = parse_study(STUDY | {"failure": cone}).failure
    assert found == bd.DruckerPrager(tension=4e6, hydrostatic=3e6, fracture_energy=20.0)
    mean = {"criterion": "Hydrostatic", "tension": "2 MPa", "friction": 0.2}
    found = parse_study(STUDY | {"failure": mean, "tests": ["direct_tension"]}).failure
    assert found == bd.Hydrostatic(tension=2e6, friction=0.2)


REFUSED = {
    "no table": ("needs \\[failure\\]", {"failure": None}),
    "no test": ("no test needs it", {"tests": ["static_tension"]}),
    "no shear": ("MohrCoulomb", {"failure": {"criterion": "Rankine", "tension": 4e6, "fracture_energy": 20.0}}),
    "no pressure": ("key 'triaxial.pressure' is missing", {"tests": ["triaxial"]}),
    "brittle cone": (
        "DruckerPrager", {"failure": {"criterion": "DruckerPrager", "tension": 4e6, "compression": 4e7}}
    ),
    "one strength": ("give two of", {"failure": {"criterion": "DruckerPrager", "tension": 4e6}}),
    "misspelt": ("unknown key 'failure.cohesio'", {"failure": STUDY["failure"] | {"cohesio": 1.0}}),
    "unit": ("failure.tension", {"failure": STUDY["failure"] | {"tension": "4 mm"}}),
    "angle": ("friction_angle", {"failure": STUDY["failure"] | {"friction_angle": 2.0}}),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_studies_that_cannot_be_are_refused(name: str) -> None:
    message, changed = REFUSED[name]
    data = {key: value for key, value in (STUDY | changed).items() if value is not None}
    with pytest.raises(StudyError, match=message):
        parse_study(data)
