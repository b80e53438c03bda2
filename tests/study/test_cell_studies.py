"""Studies, lab tests, files and pictures of bodies of cells."""

import dataclasses
import json
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem.cli.terminal import _tests
from bondem.errors import InputError, StrengthWarning, StudyError
from bondem.labtests.faces import specimen_faces
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.labtests.tension import tension_model
from bondem.observables.cell_forces import CellForces
from bondem.observables.cell_stress import stress_fields
from bondem.report.cell_pictures import section_through
from bondem.study.pipeline import run_study
from bondem.study.programme import Programme, read
from bondem.study.study_file import TESTS, parse_study, read_study
from bondem.study.template_files import TEMPLATES, template
from tests.drawings import only
from tests.specimens import cells

E, NU, RHO = 70e9, 0.3, 2500.0
EXAMPLES = Path(__file__).parents[2] / "examples"
STUDY = {
    "name": "cells",
    "packings": 1,
    "tests": ["static_tension", "static_bending", "static_torsion"],
    "material": {"name": "glass", "E": E, "nu": NU, "rho": RHO},
    "specimen": {"shape": "cylinder", "radius": 5e-3, "length": 30e-3, "count": 500},
    "bond": {"law": "CellBond"},
}


@pytest.fixture(scope="module")
def body():
    return cells(bd.Cylinder(radius=5e-3, length=30e-3), 500, spread=0.25)


@pytest.fixture(scope="module")
def law():
    return bd.CellBond(E=E, nu=NU)


@pytest.fixture(scope="module")
def clamped(body, law):
    """A body under all that acts on facets, and its equilibrium."""
    boundary = [
        bd.Fix(bd.Face("x_min")), bd.Pressure(bd.Face("side"), 1e6),
        bd.Load(bd.Face("x_max"), force=(10.0, 3.0, 2.0), moment=(1e-2, 0.0, 2e-2)),
    ]  # fmt: skip
    model = bd.Model(body, law, RHO, boundary=boundary)
    return model, bd.solve_static(model)


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    out = tmp_path_factory.mktemp("cells")
    with only("cells", "profiles", "errors"):
        return out, run_study(parse_study(STUDY | {"output": {"vtk": True, "run_files": True}}), out)


def test_a_study_of_cells_calibrates_nothing_and_measures_what_theory_says(finished):
    out, results = finished
    micro, macro = results["micro"], results["macro"]
    assert (micro["law"], micro["E_mu"], micro["nu_mu"], micro["rho_mu"]) == ("CellBond", E, NU, RHO)
    assert micro["r_mu_ratio"] is None
    assert macro["E"] == pytest.approx(E, rel=0.01)
    assert macro["nu"] == pytest.approx(NU, abs=0.01)
    assert macro["rho"] == pytest.approx(RHO, rel=1e-9)
    assert not results["packings"][0]["calibrating"]
    # the bar is 7 cells thick; held and measured at its walls it is as long as its shape
    assert results["tests"]["static_tension"]["error"] == pytest.approx(0.0, abs=0.01)
    bending = results["packings"][0]["tests"]["static_bending"]
    assert bending["error_timoshenko"] == pytest.approx(0.0, abs=0.02)
    assert results["tests"]["static_torsion"]["error"] == pytest.approx(0.0, abs=0.03)
    assert json.loads((out / "results.json").read_text()) == results
    html = (out / "report.html").read_text()
    assert "nothing was" in html
    assert "Calibration" not in html
    assert (out / "figures" / "cells.png").stat().st_size > 20_000


def test_frequencies_and_celerity_are_those_of_the_whole_length(body, law):
    own = {"E": E, "nu": NU, "density": RHO, "rho": RHO}
    assert bd.labtests.dynamic_tension(body, law, **own).error == pytest.approx(0.0, abs=0.01)
    assert bd.labtests.dynamic_bending(body, law, **own).error_timoshenko == pytest.approx(0.0, abs=0.02)
    assert bd.labtests.dynamic_torsion(body, law, **own).error == pytest.approx(0.0, abs=0.03)
    assert bd.labtests.impact(body, law, **own).error == pytest.approx(0.0, abs=0.03)


def test_a_body_in_tension_has_the_length_of_its_shape_and_fills_its_section(body, law):
    tension = bd.labtests.static_tension(body, law)
    # between the walls, not between centres, which would be 4 % off
    assert tension.E_paper == pytest.approx(E, rel=0.005)
    assert tension.nu_paper == pytest.approx(NU, abs=0.005)
    np.testing.assert_allclose(tension.gyration, 0.25 * 5e-3**2, rtol=0.02)
    model = tension_model(body, law)
    faces = specimen_faces(body)
    ends = [faces.motion(model, tension.solution, name)[0] for name in ("x_min", "x_max")]
    assert ends[1] - ends[0] == pytest.approx(30e-3 * 1e6 / E, rel=0.005)


def test_a_body_under_uniform_stress(body, law):
    found = bd.labtests.uniform_stress(body, law)
    assert pytest.approx(E, rel=0.02) == found.E
    assert found.nu == pytest.approx(NU, abs=0.01)


def test_stresses_of_cells_add_up_to_the_moment_of_what_acts_on_the_surface(clamped):
    model, static = clamped
    body = model.lattice
    forces = CellForces.of(model, static)
    held = body.cells.free.centroid[model.cell_constants.supports.fixed.facet]
    outside = body.cells.free.centroid.T @ forces.load + held.T @ forces.wall
    stress = bd.cell_stress(model, static)
    inside = np.einsum("n,nab->ab", body.cells.volume, stress)
    np.testing.assert_allclose(inside, 0.5 * (outside + outside.T), atol=1e-9 * np.abs(outside).max())


def test_stress_and_dilatation_in_tension(body, law):
    model = tension_model(body, law)
    static = bd.solve_static(model)
    stress = bd.cell_stress(model, static)
    wanted = np.zeros((3, 3))
    wanted[0, 0] = 1e6
    mean = np.average(stress, axis=0, weights=body.cells.volume)
    np.testing.assert_allclose(mean, wanted, atol=1e-6 * 1e6)
    assert np.sqrt(((stress - wanted) ** 2).mean(axis=0)).max() < 0.03e6
    expected = (1.0 - 2.0 * NU) * 1e6 / E
    found = stress_fields(model, static)["dilatation"]
    assert np.average(found, weights=body.cells.volume) == pytest.approx(expected, rel=1e-6)


def test_stress_of_a_state_turns_with_the_body(clamped):
    model, static = clamped
    small = 1e-3
    whole = Rotation.from_rotvec([0.3, -0.8, 0.5])
    own = Rotation.from_rotvec(small * static.rotation)
    bare = model.with_boundary([])
    stresses = []
    for turn in (Rotation.identity(), whole):
        state = bare.state()
        state.set_pose(
            position=turn.apply(state.position + small * static.displacement),
            orientation=(turn * own).as_quat()[:, [3, 0, 1, 2]],
        )
        stresses.append(bd.cell_stress(bare, state))
    R = whole.as_matrix()
    np.testing.assert_allclose(stresses[1], R @ stresses[0] @ R.T, rtol=0.0, atol=1e-6 * np.abs(stresses[0]).max())
    inner = np.bincount(model.lattice.cells.free.cell, minlength=500) == 0
    still = bd.cell_stress(model, static)
    # the loads that belong to the small motion
    less = [replace(one, schedule=bd.Constant(small)) if hasattr(one, "schedule") else one for one in model.boundary]
    model = model.with_boundary(less)
    state = model.state()
    state.set_pose(position=state.position + small * static.displacement, orientation=own.as_quat()[:, [3, 0, 1, 2]])
    held = bd.cell_stress(model, state)
    np.testing.assert_allclose(held[inner], small * still[inner], atol=1e-5 * small * np.abs(still).max())


def test_stress_of_what_is_no_state_is_refused(body, law):
    with pytest.raises(InputError, match="result"):
        bd.cell_stress(bd.Model(body, law, RHO), 3.0)


def test_a_run_of_cells_goes_on_to_the_bit(body, law, tmp_path):
    boundary = [
        bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 1.0, 1e-5)),
        bd.Pressure(bd.Face("side"), 1e6),
    ]  # fmt: skip
    model = bd.Model(body, law, RHO, boundary=boundary)
    gauges = {}
    whole = bd.solve_explicit(model, duration=6e-6, every=5, gauges=gauges)

    def stop(state, record):
        return state.step >= 10

    part = bd.solve_explicit(
        model, duration=6e-6, every=5, gauges=gauges, save_every=10, out=tmp_path / "run.h5", callback=stop
    )
    assert part.state.step < whole.state.step
    kept = bd.read_run(tmp_path / "run.h5")
    _same_body(kept.model.lattice, body)
    again = bd.resume(tmp_path / "run.h5")
    for name in again.state.ARRAYS:
        np.testing.assert_array_equal(getattr(again.state, name), getattr(whole.state, name))
    np.testing.assert_array_equal(again.history.records, whole.history.records)


def test_a_body_in_a_packing_file_comes_back_to_the_bit(body, tmp_path):
    bd.save_particles(tmp_path / "body.h5", body)
    _same_body(bd.read_lattice(tmp_path / "body.h5"), body)
    assert len(bd.load_particles(tmp_path / "body.h5")) == 500
    with pytest.raises(InputError, match="leave out shape="):
        bd.read_lattice(tmp_path / "body.h5", shape=bd.Box((1.0, 1.0, 1.0)))


def _same_body(found, wanted):
    np.testing.assert_array_equal(found.pairs, wanted.pairs)
    for one, other in (
        (found.facets, wanted.facets), (found.cells, wanted.cells), (found.cells.free, wanted.cells.free)
    ):  # fmt: skip
        for item in dataclasses.fields(one):
            if item.name != "free":
                np.testing.assert_array_equal(getattr(one, item.name), getattr(other, item.name))


def test_cells_are_polyhedra_for_paraview(finished, body, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    grid = pyvista.read(str(finished[0] / "specimen.vtkhdf"))
    assert grid.n_cells == 500
    assert set(grid.celltypes) == {42}
    volume = grid.compute_cell_sizes()["Volume"]
    np.testing.assert_allclose(volume, grid["volume"], rtol=0.05)  # curved walls are strips there
    assert volume.sum() == pytest.approx(body.particles.envelope.volume, rel=2e-3)
    assert np.average(grid["stress"][:, 0], weights=grid["volume"]) == pytest.approx(1e6, rel=1e-6)
    assert {"displacement", "dilatation", "lambda_theta"} <= set(grid.array_names)
    with pytest.raises(InputError, match="bonds="):
        bd.write_vtkhdf(tmp_path / "x.vtkhdf", body, bonds={"s": np.ones(len(body.pairs))})


def test_a_section_through_cells_has_the_area_of_the_shape(body):
    section = section_through(bd.polyhedra(body), 0, 13e-3)
    area = 0.0
    for x, y in (one.T for one in section.outline):
        area += 0.5 * abs(x @ np.roll(y, -1) - y @ np.roll(x, -1))
    assert area == pytest.approx(np.pi * 5e-3**2, rel=3e-3)


@pytest.mark.parametrize(("changed", "told"), [
    ({"calibration": {"packings": 1}}, "without calibration"),
    ({"bond": {"law": "CellBond", "nu_mu": 0.3}}, "'bond.nu_mu'"),
    ({"bond": {"law": "CellBond", "reach": 1.1}}, "'bond.reach'"),
    ({"bond": {"law": "CellBond", "facet_rotation": "twist"}}, "facet_rotation"),
    ({"bond": {"law": "Cellbond"}}, "did you mean 'CellBond'"),
    ({"bond": {}, "specimen": STUDY["specimen"] | {"method": "even"}}, 'hardly touch; set law = "CellBond"'),
    ({"failure": {"criterion": "MohrCoulomb", "cohesion": 2e7}}, "key 'failure.tension' is missing"),
    ({"failure": {"tension": 8e6, "cohesion": 2e7}}, "key 'failure.criterion' is missing"),
    (
        {"failure": {"criterion": "MohrCoulomb", "tension": 8e6, "cohesion": 2e7, "friction_angle": 59.8}},
        "'failure.friction_angle' = 59.8; .*write \"59.8 deg\"",
    ),
])  # fmt: skip
def test_keys_that_cells_do_not_have_are_refused(changed, told):
    with pytest.raises(StudyError, match=told):
        parse_study(STUDY | changed)


def test_the_report_says_that_a_disc_yields_before_it_splits(tmp_path):
    failure = {"criterion": "MohrCoulomb", "tension": 4e6, "cohesion": 7.4e6, "friction_angle": "59.8 deg",
               "fracture_energy": 100.0}  # fmt: skip
    changed = {
        "tests": ["brazilian"], "failure": failure, "material": {"name": "rock", "E": 4e10, "nu": 0.2, "rho": RHO},
        "specimen": {"shape": "cylinder", "radius": 25e-3, "length": 20e-3, "count": 150, "method": "even"},
        "output": {"figures": False},
    }  # fmt: skip
    with pytest.warns(StrengthWarning, match="the disc yields in shear"):
        run_study(parse_study(STUDY | changed), tmp_path / "out")
    report = " ".join((tmp_path / "out" / "report.html").read_text(encoding="utf-8").split())
    assert "it yields in shear and does not split: 1 piece" in report
    assert "Its peak is no splitting strength: enter a larger cohesion." in report


def test_a_share_without_a_unit_is_named_on_the_terminal():
    row = {"measured": 0.4545, "unit": "-", "theory": None, "error": None, "scatter": None}
    packing = {"tests": {"sphere_impact": {"error_timoshenko": None, "error_refined": None}}}
    table = _tests(SimpleNamespace(reference=None), {"tests": {"sphere_impact": row}, "packings": [packing]})
    assert list(table.columns[0].cells) == ["  sphere_impact, share of broken facets"]


def test_templates_are_the_examples_and_can_be_read(tmp_path):
    for name, file in TEMPLATES.items():
        path = tmp_path / f"{name}.toml"
        path.write_text(template(name, str(path)))
        asked = read(path)
        if name == "concrete":
            assert isinstance(asked, Programme)
            asked_for = {test for one in asked.series for test in one.study.tests}
            assert asked_for == set(FAILURE_TESTS) - {"sphere_crushing", "sphere_impact", "spall"}  # other bodies
        elif name == "mesoscale":
            assert isinstance(asked, Programme)
            assert all(one.study.aggregates is not None for one in asked.series)
        elif name in ("silica", "cells"):
            assert asked.tests == TESTS
        elif name == "rock":
            assert asked.tests == ("ucs", "brazilian", "direct_tension")
        else:
            assert len(asked.tests) == 1
            assert asked.tests[0] in FAILURE_TESTS
        assert (EXAMPLES / file).read_text() == template(name, f"examples/{file}")
    assert read_study(EXAMPLES / "silica_cells.toml").bond.cells is bd.CellBond
