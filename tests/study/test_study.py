"""Studies: what a file says, and what the pipeline makes of it."""

import json
import runpy
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.packing import METHODS
from bondem.study.keys import STUDY
from bondem.study.pipeline import run_study
from bondem.study.results import deviation
from bondem.study.specimen_step import SpecimenPlan
from bondem.study.strength_tests import read_options
from bondem.study.study_file import TESTS, Study, parse_study, read_study
from bondem.study.toml_table import TomlTable

EXAMPLE = Path(__file__).parents[2] / "examples" / "silica.toml"

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
    assert (study.specimen.count, study.specimen.sizes) == (10_000, bd.Uniform(0.25))
    assert (study.packings, study.calibrating) == (2, 1)
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
    assert (study.specimen.sizes, study.specimen.target) == (bd.Uniform(0.1), {"coordination_number": 6.0})
    assert (study.bond.law, study.bond.reach, study.bond.tolerance) == (bd.Timoshenko, 1.05, None)
    assert (study.calibrating, study.tests) == (2, ())


BALL = {"name": "ball", "packings": 1, "specimen": {"shape": "ball", "radius": 5e-3, "count": 300, "spread": 0.2}}


def specimen(**keys):
    """What a study reads from [specimen], a cylinder if nothing else is said."""
    if not {"shape", "particles"} & set(keys):
        keys = {"shape": "cylinder", "radius": 5e-3, "length": 30e-3} | keys
    return parse_study({"name": "s", "specimen": {"count": 500} | keys}).specimen


def tetrahedron(path, edge):
    """An STL file of a corner of a cube, with a flat end at x = 0 only."""
    corner = edge * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    lines = ["solid part"]
    for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)):
        corners = ["vertex {} {} {}".format(*corner[k]) for k in face]
        lines += ["facet normal 0 0 0", "outer loop", *corners, "endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid part\n"]))


def test_sizes_methods_and_targets_are_read():
    assert specimen().sizes == bd.Uniform(0.25)
    assert specimen(sizes={"law": "uniform", "spread": 0.4}).sizes == bd.Uniform(0.4)
    assert specimen(sizes={"law": "lognormal", "cv": 0.2}).sizes == bd.Lognormal(0.2)
    assert specimen(sizes={"law": "lognormal", "cv": 0.2, "cut": 2}).sizes == bd.Lognormal(0.2, cut=2.0)
    sieve = {"law": "sieve", "diameters": [1e-3, 2e-3, 4e-3], "mass_passing": [0, 0.4, 1]}
    assert specimen(sizes=sieve).sizes == bd.Sieve((1e-3, 2e-3, 4e-3), (0.0, 0.4, 1.0))
    for method in METHODS:
        assert specimen(method=method).method == method
    assert (specimen().method, specimen().target) == ("quench", {})
    assert (specimen(method="even").sizes, specimen(method="even").target) == (None, {})
    assert specimen(jamming=True).target == {"jamming": True}
    assert specimen(jamming=False, volume_fraction=0.6).target == {"volume_fraction": 0.6}


def test_shapes_are_read(tmp_path):
    assert specimen(shape="ball", radius=1e-3).shape == bd.Ball(1e-3)
    assert specimen(shape="cell", size=[1e-3, 2e-3, 3e-3]).shape == bd.Cell((1e-3, 2e-3, 3e-3))
    tetrahedron(tmp_path / "part.stl", 20.0)
    data = {"name": "s", "specimen": {"shape": "surface", "file": "part.stl", "unit": "mm", "count": 500}}
    (tmp_path / "study.toml").write_text(
        'name = "s"\n[specimen]\nshape = "surface"\nfile = "part.stl"\nunit = "mm"\ncount = 500\n'
    )
    for study in (read_study(tmp_path / "study.toml"), parse_study(data, folder=tmp_path)):
        assert study.specimen.shape.volume == pytest.approx(0.02**3 / 6.0)


CYLINDER = {"shape": "cylinder", "radius": 5e-3, "length": 30e-3, "count": 500}


@pytest.mark.parametrize(
    ("keys", "key", "remedy"),
    [
        ({"specimen": CYLINDER | {"method": "grow"}}, "'specimen.method' = 'grow'", "did you mean 'growth'"),
        ({"specimen": CYLINDER | {"method": "even", "spread": 0.2}}, "'specimen.spread' is", "leave it out"),
        ({"specimen": CYLINDER | {"jamming": True, "volume_fraction": 0.6}}, "'specimen.volume_fraction' and", "one"),
        ({"specimen": CYLINDER | {"volume_fraction": 0.9}}, "'specimen.volume_fraction' = 0.9", "between 0 and 0.8"),
        ({"specimen": CYLINDER | {"jamming": 1}}, "'specimen.jamming' = 1", "true or false"),
        ({"specimen": CYLINDER | {"spread": 0.2, "sizes": {"law": "uniform"}}}, "'specimen.spread'", "not both"),
        ({"specimen": CYLINDER | {"sizes": {"cv": 0.2}}}, "'specimen.sizes.law' is missing", "one of uniform"),
        ({"specimen": CYLINDER | {"sizes": {"law": "normal"}}}, "'specimen.sizes.law'", "lognormal"),
        ({"specimen": CYLINDER | {"sizes": {"law": "lognormal", "cv": 3.0}}}, "'specimen.sizes': cv = 3", "to 1"),
        (
            {"specimen": CYLINDER | {"sizes": {"law": "lognormal", "cv": 0.2, "spread": 0.1}}},
            "unknown key 'specimen.sizes.spread'",
            "known here",
        ),
        (
            {"specimen": CYLINDER | {"sizes": {"law": "sieve", "diameters": [2, 1], "mass_passing": [0, 1]}}},
            "'specimen.sizes': diameters",
            "each wider",
        ),
        (
            {"specimen": CYLINDER | {"sizes": {"law": "sieve", "diameters": [1, True], "mass_passing": [0, 1]}}},
            "'specimen.sizes.diameters[1]'",
            "a list of numbers",
        ),
        ({"specimen": CYLINDER | {"shape": "balls"}}, "'specimen.shape'", "did you mean 'ball'"),
        ({"specimen": {"shape": "surface", "file": "no.stl", "count": 500}}, "'specimen.file'", "check the path"),
        ({"specimen": {"particles": "no.csv"}}, "'specimen.particles'", "check the path"),
        (BALL | {"material": SMALL["material"]}, "'specimen.shape': a Ball", "leave out [material]"),
        (
            {"specimen": {"shape": "cell", "size": [1, 1, 1], "count": 500}, "material": SMALL["material"]},
            "'specimen.shape': a Cell",
            "cylinder or a box",
        ),
        (BALL | {"tests": ["impact"]}, "'tests' needs", "give [material]"),
        ({"specimen": CYLINDER, "materiel": {}, "tests": ["impact"]}, "unknown key 'materiel'", "'material'"),
        ({"specimen": CYLINDER | {"count": 10**8 + 1}}, "'specimen.count' = 100000001", "at most 100000000"),
        (BALL | {"output": {"run_files": True}}, "'output.run_files' needs", "give [material]"),
    ],
)
def test_what_cannot_be_is_refused_by_its_key(keys, key, remedy):
    with pytest.raises(bd.errors.StudyError) as refused:
        parse_study({"name": "s", **keys})
    assert key in str(refused.value)
    assert remedy in str(refused.value)


def test_known_keys_are_listed_once():
    """The list began "law, law"."""
    with pytest.raises(bd.errors.StudyError, match=r"known here: .*law") as caught:
        parse_study(SMALL | {"bond": {"law": "Timoshenko", "zzz": 1}})
    listed = str(caught.value).split("known here: ")[1].split(", ")
    assert len(listed) == len(set(listed))



def test_calibration_needs_a_prism_and_tests_need_one_with_formulas(tmp_path):
    bar = bd.Box((4.0, 1.0, 1.0)) | bd.Box((4.0, 2.0, 0.5))
    plan = SpecimenPlan(shape=bar, count=500)
    glass = bd.Material("glass", E=70e9, nu=0.2, rho=2500.0)
    assert Study(name="s", material=glass, specimen=plan, tests=()).tests == ()
    with pytest.raises(bd.errors.StudyError, match="'tests' contains impact, but a Joined is not a bar along x"):
        Study(name="s", material=glass, specimen=plan, tests=("impact",))
    waisted = bd.Box((4.0, 1.0, 1.0)).cut(bd.Box((1.0, 1.0, 0.3)).moved((1.5, 0.0, 0.0)))
    with pytest.raises(bd.errors.StudyError, match=r"'specimen\.shape': a Cut without flat ends"):
        Study(name="s", material=glass, specimen=SpecimenPlan(shape=waisted, count=500), tests=())
    tetrahedron(tmp_path / "part.stl", 0.02)
    data = {"name": "s", "specimen": {"shape": "surface", "file": "part.stl", "count": 500}}
    assert parse_study(data, folder=tmp_path).tests == ()
    with pytest.raises(bd.errors.StudyError, match="a Surface without flat ends"):
        parse_study(data | {"material": SMALL["material"]}, folder=tmp_path)


def test_without_a_material_a_study_packs_and_checks_only(tmp_path):
    told = {"name": "growth", "specimen": BALL["specimen"] | {"method": "growth", "coordination_number": 6.0}}
    study = parse_study(BALL | told | {"output": {"figures": False, "packing_files": True}})
    results = run_study(study, tmp_path)
    assert (results["micro"], results["macro"], results["tests"]) == (None, None, {})
    written = ["curves", "packing_1.h5", "report.html", "results.json"]
    assert sorted(path.name for path in tmp_path.iterdir()) == written
    lattice = bd.read_lattice(tmp_path / "packing_1.h5")
    alone = bd.pack(bd.Ball(5e-3), count=300, spread=0.2, method="growth", coordination_number=6.0, seed=1)
    np.testing.assert_array_equal(lattice.particles.position, alone.position)
    quality = bd.fabric(lattice)
    (told,) = results["packings"]
    assert told["E"] is None
    assert told["loose"] == quality.loose
    assert told["core_volume_fraction"] == quality.core_volume_fraction
    assert set(told["strata"]) >= {"density", "coordination", "size", "layers"}
    assert "nothing was calibrated or tested" in (tmp_path / "report.html").read_text()


def test_particles_from_a_file(tmp_path):
    particles = bd.pack(bd.Cylinder(5.0, 30.0), count=500, spread=0.25, seed=7)
    rows = np.column_stack([particles.position, particles.radius]).tolist()
    (tmp_path / "mm.csv").write_text("\n".join(["x,y,z,radius", *(",".join(map(repr, row)) for row in rows)]) + "\n")
    cylinder = {"shape": "cylinder", "radius": 5e-3, "length": 30e-3}
    data = SMALL | {"packings": 1, "tests": ["static_tension"], "output": {"figures": False}}
    data["specimen"] = {"particles": "mm.csv", "unit": "mm"} | cylinder
    results = run_study(parse_study(data, folder=tmp_path), tmp_path / "out")
    ours = run_study(parse_study(SMALL | {"packings": 1, "tests": ["static_tension"], "output": {"figures": False}}),
                     tmp_path / "ours")  # fmt: skip
    assert results["micro"]["E_mu"] == pytest.approx(ours["micro"]["E_mu"], rel=1e-3)
    with pytest.raises(bd.errors.StudyError, match=r"'packings' = 2, but 'specimen\.particles' is one"):
        parse_study(data | {"packings": 2}, folder=tmp_path)
    with pytest.raises(bd.errors.StudyError, match=r"unknown key 'specimen.count'"):
        parse_study(data | {"specimen": data["specimen"] | {"count": 500}}, folder=tmp_path)
    bd.save_particles(tmp_path / "ball.h5", bd.pack(bd.Ball(1.0), count=300, seed=1))
    with pytest.raises(bd.errors.StudyError, match="a Ball without flat ends"):
        run_study(parse_study(data | {"specimen": {"particles": "ball.h5"}}, folder=tmp_path), tmp_path / "out")


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
        assert set(row) == {"measured", "theory", "theory_timoshenko", "error", "error_95", "scatter", "unit"}
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
    unseen = results["unseen"]  # a single one, which has no interval
    assert unseen["packings"] == 1
    assert unseen["E"] == {"mean": packings[1]["E"], "confidence_95": None}
    low, high = results["tests"]["static_bending"]["error_95"]
    assert low < results["tests"]["static_bending"]["error"] < high


def test_the_first_beams_are_calibrated_on_some_packings_and_tested_on_others():
    study = read_study(EXAMPLE.with_name("start_beams.toml"))
    assert (study.calibrating, study.packings) == (4, 8)


@pytest.mark.parametrize(("test", "key", "right", "wrong", "wanted"), [
    ("three_point_bending", "until", (0, 0.5), (-0.1, 1, 1.5, 1e300), r"of at least 0 and below 1 \[-\]"),
    ("ucs", "platen_friction", (0.0, 2.0), (-0.1,), r"of at least 0 \[-\]"),
    ("brazilian", "half_angle", (0.1, "5 deg"), (0, "40 deg"), r"between 0 and 0.349066 \(exclusive\) \[rad\]"),
])  # fmt: skip
def test_options_of_tests_have_the_ranges_of_the_tests(test, key, right, wrong, wanted):
    for value in right:
        assert list(read_options(TomlTable({test: {key: value}}, STUDY), (test,))[test]) == [key]
    for value in wrong:
        with pytest.raises(bd.errors.StudyError, match=f"'{test}.{key}' = .*; give a number {wanted}"):
            read_options(TomlTable({test: {key: value}}, STUDY), (test,))


def test_a_measured_range_has_two_ends():
    asked = SMALL | {"reference": {"citation": "A", "peaks": {"three_point_bending": ["933 N", 1114]}}}
    assert parse_study(asked).reference.peaks == {"three_point_bending": (933.0, 1114.0)}
    for wrong in ([1.0], [2.0, 1.0]):
        with pytest.raises(bd.errors.StudyError, match=r"'reference.peaks.three_point_bending': not a range"):
            parse_study(SMALL | {"reference": {"citation": "A", "peaks": {"three_point_bending": wrong}}})


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
        "curves", "report.html", "results.json", "specimen.vtkhdf", "specimen_7.h5", "specimen_8.h5",
    ]  # fmt: skip


def test_a_kept_specimen_is_the_calibrated_one(finished):
    out, results, _ = finished
    model = bd.read_run(out / "specimen_8.h5").model
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
    path = Path(__file__).parents[2] / "examples" / "silica.py"
    answer = runpy.run_path(str(path))["main"](count=800)
    assert answer.E == pytest.approx(72.5e9, rel=2e-3)  # noqa: SIM300
    assert answer.nu == pytest.approx(0.17, abs=1e-3)
    assert 0.6 < answer.radius_ratio < 0.8
    assert abs(answer.frequency_error) < 0.1
    assert abs(answer.frequency_error_timoshenko) < 0.05
