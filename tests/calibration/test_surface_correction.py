"""Bodies against the bulk: affine estimate and uniform stress on crystals, exactly; the correction on packings."""

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.calibration.affine import affine_estimate, is_bar
from bondem.calibration.surface_correction import (
    ExtrapolationWarning,
    SurfaceCorrection,
    SurfaceModel,
    lattice_terms,
    law_terms,
)
from bondem.errors import InputError
from tests.specimens import chain, grid, spheres
from validation.frame.request import made_row
from validation.measures.surface_fit import Fit, bulk_means, design, law_name
from validation.rows.surface import FORMS, ModuliRequest, SpecimenRequest
from validation.studies.surface import FITTED, HELD_OUT, SurfaceStudy

LAW = bd.EulerBernoulli(E=50e9, nu=0.3, radius_ratio=0.7)
SHAPE = bd.Cylinder(radius=5e-3, length=25e-3)


def stiffness(law: bd.BondLaw) -> tuple[float, float]:
    """What kn and ks the bonds of the crystal have."""
    lattice = grid((4, 4, 4), 2.0, periodic=True)
    k = bd.Model(lattice, law, 1000.0).stiffness
    return float(k.kn[0]), float(k.ks[0])


# -- the affine estimate -----------------------------------------------------------------------------------------


def test_the_estimate_of_a_crystal_is_exact():
    # per cell of edge a = 2 one bond along each axis: C11 = kn/a, C44 = ks/(2a), C12 = 0, and nothing gives way
    kn, ks = stiffness(LAW)
    lattice = grid((4, 4, 4), 2.0, periodic=True)
    found = affine_estimate(lattice, LAW)
    np.testing.assert_allclose(found.stiffness, np.diag([kn / 2.0] * 3 + [ks / 4.0] * 3), atol=1e-9 * kn)
    np.testing.assert_allclose(found.stiffness, bd.bulk_moduli(lattice, LAW).stiffness, atol=1e-6 * kn)
    assert found.coordination == pytest.approx(6.0)
    assert found.looseness == pytest.approx(1.0 / 3.0)
    assert found.wall == 0.0
    assert found.shear == pytest.approx(ks / kn)


def test_a_bar_is_measured_in_the_middle_half_of_its_length():
    kn, _ = stiffness(LAW)
    bar = grid((12, 3, 3), 2.0, walled=True)
    assert is_bar(bar)
    found = affine_estimate(bar, LAW)
    # chains without end: the two missing half bonds at the ends do not count
    assert pytest.approx(kn / 2.0) == found.E
    assert found.nu == pytest.approx(0.0, abs=1e-12)
    # sides of a section 6 x 6: 24/36 per length, times the radius
    assert found.wall == pytest.approx(24.0 / 36.0)
    whole = affine_estimate(bar, LAW, bar=False)
    assert whole.stiffness[0, 0] == pytest.approx(kn / 2.0 * 11.0 / 12.0)
    assert whole.wall == pytest.approx(0.5 * (2.0 * 36.0 + 4.0 * 6.0 * 24.0) / (36.0 * 24.0))


def test_a_chain_is_refused():
    with pytest.raises(InputError, match="resist every strain"):
        affine_estimate(chain(20, radius=1.0), LAW)


@pytest.mark.filterwarnings("ignore::bondem.errors.FillingWarning", "ignore::bondem.errors.UnitWarning")
def test_a_plane_in_a_ball_is_refused_too():
    place = np.array([(a + 0.5 * b, 0.75**0.5 * b, 0.0) for a in range(-4, 5) for b in range(-4, 5)])
    pairs = [(k, m) for k in range(len(place)) for m in range(k) if np.linalg.norm(place[k] - place[m]) < 1.01]
    plane = bd.Lattice(bd.Particles(place, 0.5, shape=bd.Ball(20.0)), pairs)
    with pytest.raises(InputError, match="resist every strain"):
        affine_estimate(plane, LAW)


# -- uniform stress ----------------------------------------------------------------------------------------------


def test_uniform_stress_is_exact_in_a_crystal():
    """Patches that hand over their moments put the crystal under the stress it has inside, shear included."""
    kn, ks = stiffness(LAW)
    found = bd.labtests.uniform_stress(grid((5, 4, 3), 2.0, walled=True), LAW)
    np.testing.assert_allclose(found.compliance, np.diag([2.0 / kn] * 3 + [4.0 / ks] * 3), atol=1e-7 * 2.0 / kn)
    assert found.asymmetry < 1e-7
    assert found.along("y") == pytest.approx((kn / 2.0, 0.0), abs=1e-6 * kn)
    np.testing.assert_allclose(found.stiffness @ found.compliance, np.eye(6), atol=1e-12)


def test_uniform_stress_turns_with_the_body():
    """A packing measured as it lies and turned by a right angle: the same compliance, axes exchanged."""
    shape = bd.Box(size=(0.01, 0.014, 0.018))
    lattice = spheres(shape, 500, spread=0.0, seed=4)
    plain = bd.labtests.uniform_stress(lattice, LAW)
    turned = shape.rotated("x", math.pi / 2.0)
    position = lattice.particles.position @ np.array(turned.turn).T
    particles = bd.Particles(position, lattice.particles.radius, shape=turned)
    other = bd.labtests.uniform_stress(bd.Lattice(particles, lattice.pairs), LAW)
    assert other.along("z") == pytest.approx(plain.along("y"), rel=1e-6)
    assert pytest.approx(plain.E, rel=1e-6) == other.E
    with pytest.raises(InputError, match="bulk_moduli"):
        bd.labtests.uniform_stress(grid((4, 4, 4), 2.0, periodic=True), LAW)


@pytest.mark.parametrize("form", [pytest.param("ball", marks=pytest.mark.validate), "bracket"])
def test_bodies_without_a_gauge_have_about_the_moduli_of_the_bulk(form, tmp_path):
    for part in ("rows", "packings"):
        (tmp_path / part).mkdir()
    specimen = SpecimenRequest(form, 500, "contacts", 1)
    assert made_row(specimen, tmp_path)["error"] == ""
    row = made_row(ModuliRequest(specimen, LAW, "stress"), tmp_path)
    assert row["error"] == ""
    # the bulk has 0.278 and 0.173; so few elements are up to a quarter off
    assert row["E"] == pytest.approx(0.3, rel=0.2)
    assert row["nu"] == pytest.approx(0.15, rel=0.25)
    assert row["wall"] == pytest.approx(0.5 * row["surface_ratio"])
    # the estimate of the whole body knows about the skin: within a few percent, where the bulk is 15 % off
    model = SurfaceCorrection.default(LAW).model
    predicted = math.exp(float(law_terms(row["shear"], row["bending"]) @ model.E
                               @ lattice_terms(row["coordination"], row["looseness"], row["wall"])))  # fmt: skip
    assert row["E"] > 1.08 * 0.2784
    assert predicted * row["E_affine"] == pytest.approx(row["E"], rel=0.06)


def test_the_bracket_is_what_its_docstring_says():
    bracket = FORMS["bracket"]
    assert bracket.volume == pytest.approx((24.0 * 8.0 + 16.0 * 8.0) * 10.0 * 1e-9)
    assert set(bracket.faces) == {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max", "side"}


# -- the correction ----------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def cell() -> bd.Lattice:
    return spheres(bd.Cell((0.01, 0.01, 0.01)), 1500, seed=5)


@pytest.fixture(scope="module")
def bodies() -> dict[str, bd.Lattice]:
    jammed = bd.pack(SHAPE, count=1500, spread=0.25, seed=5, jamming=True)
    return {"contacts": spheres(SHAPE, 1500, seed=5), "jamming": bd.connect(jammed)}


@pytest.mark.parametrize(
    "law", [LAW, pytest.param(bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.7), marks=pytest.mark.validate)]
)
def test_it_predicts_packings_it_was_not_fitted_to(bodies, cell, law):
    correction, bulk = SurfaceCorrection.default(law), bd.bulk_moduli(cell, law)
    assert affine_estimate(cell, law).E > 1.1 * bulk.E  # without the factor it would be an upper bound
    # thin bodies are stiffer at z = 6.2 over all elements and softer at jamming, by more than what is allowed below
    for target, low, high in (("contacts", 1.08, 1.3), ("jamming", 0.6, 0.85)):
        lattice = bodies[target]
        pulled = bd.labtests.static_tension(lattice, law)
        wanted = {"E": pulled.E / bulk.E, "nu": pulled.nu / bulk.nu}
        assert low < wanted["E"] < high
        for name in ("E", "nu"):
            ratio, error = getattr(correction, name), getattr(correction, f"{name}_error")
            both = math.hypot(error(lattice), error(cell))
            assert ratio(lattice) / ratio(cell) == pytest.approx(wanted[name], rel=2.5 * both)
            assert both < {"E": 0.05, "nu": 0.07}[name]


def test_the_bulk_needs_no_correction(cell):
    correction = SurfaceCorrection.default(LAW)
    assert correction.E(cell) == pytest.approx(1.0, abs=0.02)
    assert correction.nu(cell) == pytest.approx(1.0, abs=0.01)
    assert correction.E(0.0) == correction.nu(0.0) == 1.0
    assert 1.0 < correction.E(0.1) < correction.E(0.3)
    assert correction.E_error(0.2) > correction.E_error(cell) > 0.0


def test_only_what_is_dimensionless_counts(bodies):
    lattice = bodies["contacts"]
    plain = SurfaceCorrection.default(LAW)
    for other in (
        dataclasses.replace(LAW, E=1.0),
        dataclasses.replace(LAW, radius_ratio=None, radius=0.7 * lattice.particles.mean_radius),
    ):
        changed = SurfaceCorrection.default(other)
        assert changed.E(lattice) == pytest.approx(plain.E(lattice), rel=1e-12)
        assert changed.nu(lattice) == pytest.approx(plain.nu(lattice), rel=1e-12)


def test_without_coefficients_it_is_the_affine_estimate(bodies, cell):
    model = SurfaceCorrection.default(LAW).model
    bare = dataclasses.replace(model, E=np.zeros((4, 5)), nu=np.zeros((4, 5)))
    correction = SurfaceCorrection(LAW, bare)
    lattice = bodies["contacts"]
    wanted = affine_estimate(lattice, LAW).E / affine_estimate(cell, LAW).E
    assert correction.E(lattice) / correction.E(cell) == pytest.approx(wanted, rel=1e-12)
    # two lengths of bond stand for all in the bulk
    assert pytest.approx(affine_estimate(cell, LAW).E, rel=0.02) == bare.bulk(LAW, 1.0).E


def test_beyond_what_it_was_fitted_to_it_warns(bodies):
    stubby = bd.Obermayr(E=1e9, nu=0.3, radius_ratio=2.2, alpha_s=5.0)
    with pytest.warns(ExtrapolationWarning, match=r"shear over normal stiffness .* but the value is 1\.9"):
        SurfaceCorrection.default(stubby).E(bodies["contacts"])
    with pytest.warns(ExtrapolationWarning, match=r"R̄S/V from 0 to 0\.\d+, but the value is 3"):
        SurfaceCorrection.default(LAW).E(3.0)
    with pytest.raises(InputError, match="radius_ratio="):
        SurfaceCorrection.default(dataclasses.replace(LAW, radius_ratio=None, radius=1e-3)).E(0.1)
    with pytest.raises(InputError, match="not a bond law"):
        SurfaceCorrection.default(bd.EulerBernoulli)


# -- the fit -----------------------------------------------------------------------------------------------------


def synthetic_rows(coefficients: np.ndarray, scatter: float) -> list[dict]:
    random = np.random.default_rng(2)
    rows = []
    for form in ("cell", "cube", "beam", "plate", "cylinder"):
        for _ in range(40):
            row = {
                "form": form, "target": "contacts", "seed": 1, "count": 2000, "elements": 2000,
                "law": "EulerBernoulli", "radius_ratio": 0.7, "kappa": None, "alpha_s": None,
                "wall": 0.0 if form == "cell" else random.uniform(0.1, 0.5), "surface_ratio": 0.2,
                "coordination": random.uniform(5.5, 7.2), "looseness": random.uniform(0.28, 0.4),
                "shear": random.uniform(0.1, 0.6), "E_affine": 0.3, "nu_affine": 0.15, "nu": 0.17,
            }  # fmt: skip
            row["bending"] = row["shear"] / 12.0 * random.uniform(1.0, 3.0)
            row["E"] = 0.3 * math.exp((design([row]) @ coefficients).item() + scatter * random.standard_normal())
            rows.append(row)
    return rows


def test_the_fit_finds_what_rows_were_made_with():
    wanted = np.random.default_rng(1).uniform(-0.2, 0.2, 20)
    fit = Fit(synthetic_rows(wanted, 0.0), "E")
    np.testing.assert_allclose(fit.coefficients, wanted, atol=1e-6)
    assert np.abs(fit.held_out).max() < 1e-6
    noisy = Fit(synthetic_rows(wanted, 0.02), "E")
    a, b = noisy.scatter
    assert math.hypot(a, b / math.sqrt(2000.0)) == pytest.approx(0.022, rel=0.2)


def test_the_model_survives_its_file_and_laws_have_names():
    model = SurfaceCorrection.default(LAW).model
    assert isinstance(model, SurfaceModel)
    assert model.E.shape == model.nu.shape == (4, 5)
    rows = synthetic_rows(np.zeros(20), 0.0)
    assert law_name(rows[0]) == "EulerBernoulli r̃ 0.7"
    assert bulk_means(rows)["EulerBernoulli r̃ 0.7"]["E"] == pytest.approx(0.3)


# -- the study ---------------------------------------------------------------------------------------------------


def test_the_study_asks_for_every_shape_and_refuses_crumbs():
    study = SurfaceStudy(counts=(400,), seeds=1, other_count=400, cell_count=400)
    (_, specimens), (_, tests) = study.stages(Path())
    assert {one.form for one in specimens} == set(FORMS)
    assert {one.target for one in specimens} == {"contacts", "dense", "jamming", "carved"}
    assert {one.needs for one in tests} == set(specimens)
    assert len({one.name for one in tests}) == len(tests)
    with pytest.raises(InputError, match="give 300 or more"):
        SurfaceStudy(counts=(100,))


def test_results_tables_and_figure_follow_from_rows(tmp_path):
    """Rows made with the shipped model come back as that model, exactly predicted."""
    model = SurfaceCorrection.default(LAW).model
    random = np.random.default_rng(7)
    rows = []
    for law in (*FITTED, *HELD_OUT):
        for form in ("cell", "cube", "beam", "plate", "cylinder", "ball"):
            for seed in range(1, 13):
                wall = 0.0 if form == "cell" else random.uniform(0.1, 0.4)
                shear = random.uniform(0.1, 0.6)
                row = {
                    "form": form, "target": "contacts", "seed": seed, "count": 2000, "elements": 2000, "error": "",
                    "test": "stress" if form == "ball" else "tension", "law": type(law).__name__,
                    "radius_ratio": law.radius_ratio, "kappa": getattr(law, "kappa", None),
                    "alpha_s": getattr(law, "alpha_s", None), "wall": wall, "surface_ratio": wall, "seconds": 0.1,
                    "coordination": random.uniform(5.5, 7.2), "looseness": random.uniform(0.28, 0.4), "shear": shear,
                    "bending": shear / 12.0 * random.uniform(1.0, 3.0), "E_affine": 0.3, "nu_affine": 0.15,
                    "bond_length": 2.0, "bond_length_std": 0.1, "bond_number": 0.47,
                }  # fmt: skip
                factor = (
                    law_terms(row["shear"], row["bending"]),
                    lattice_terms(row["coordination"], row["looseness"], row["wall"]),
                )
                row["E"] = 0.3 * math.exp(factor[0] @ model.E @ factor[1])
                row["nu"] = 0.15 + float(factor[0] @ model.nu @ factor[1])
                rows.append(row)
    study = SurfaceStudy(counts=(2000,), seeds=12)
    results = study.results(tmp_path, rows)
    again = SurfaceModel.read(results["model"])
    np.testing.assert_allclose(again.E, model.E, atol=1e-4)
    np.testing.assert_allclose(again.nu, model.nu, atol=1e-4)
    assert max(one["largest"] for one in results["accuracy"] if "only" not in one["what"]) < 1e-4
    assert len(results["ends"]) == 12
    (tmp_path / "figures").mkdir()
    study.draw(tmp_path, rows, results)
    assert (tmp_path / "figures" / "surface.png").stat().st_size > 10_000
    assert (tmp_path / "surface.json").is_file()
    assert study.results(tmp_path, [])["model"] is None


def test_moduli_along_an_axis_are_those_of_the_compliance():
    E, nu = 70e9, 0.2
    compliance = np.diag([1.0 / E] * 3 + [2.0 * (1.0 + nu) / E] * 3)
    compliance[:3, :3] -= nu / E * (1.0 - np.eye(3))
    body = bd.labtests.UniformStress(compliance, 0.0)
    for axis in "xyz":
        assert body.along(axis) == pytest.approx((E, nu))
    assert (body.E, body.nu) == pytest.approx((E, nu))
    # contraction along y and z twice as large under tension along x alone
    compliance[1:3, 0] = compliance[0, 1:3] = -2.0 * nu / E
    assert bd.labtests.UniformStress(compliance, 0.0).along("x") == pytest.approx((E, 2.0 * nu))
