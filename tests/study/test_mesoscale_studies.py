"""Bodies of several materials in tests to failure, and studies with aggregates."""

import json
from types import SimpleNamespace

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, StudyError
from bondem.fracture.lost_area import lost_area
from bondem.labtests.failure_tests import failure_outcome
from bondem.study.pipeline import run_study
from bondem.study.programme import Programme, parse_programme
from bondem.study.study_file import parse_study
from tests import specimens
from tests.drawings import only

SOFT, HARD = bd.CellBond(E=20e9, nu=0.0), bd.CellBond(E=60e9, nu=0.0)
PLAIN, STRONG = bd.Rankine(tension=3e6, fracture_energy=20.0), bd.Rankine(tension=9e6, fracture_energy=20.0)
ROCK = {"criterion": "MohrCoulomb", "tension": 4e6, "cohesion": 10e6, "friction_angle": 0.8, "fracture_energy": 60.0}
STUDY = {
    "name": "concrete", "packings": 1, "tests": ["direct_tension"],
    "material": {"name": "mortar", "E": 25e9, "nu": 0.2, "rho": 2400.0},
    "failure": {"criterion": "Rankine", "tension": 4e6, "fracture_energy": 60.0},
    "aggregates": {
        "diameters": ["8 mm", "12 mm"], "mass_passing": [0.0, 1.0], "fraction": 0.15, "gap": "3 mm", "E": "70 GPa",
        "nu": 0.2,
        "failure": {"criterion": "Rankine", "tension": 12e6, "fracture_energy": 100.0},
        "interface": {"criterion": "Rankine", "tension": 2e6, "fracture_energy": 30.0},
    },
    "specimen": {"shape": "box", "size": [36e-3, 24e-3, 24e-3], "count": 640, "method": "even"},
    "bond": {"law": "CellBond"},
}  # fmt: skip


@pytest.fixture(scope="module")
def bar():
    return specimens.bar(300, 30e-3, 10e-3)


def halves(bar):
    """The half of the bar beyond its middle, and the part of it that is hard there."""
    return bd.Within(bd.Box((15e-3, 10e-3, 10e-3)).moved((15e-3, 0.0, 0.0)))


@pytest.mark.filterwarnings("ignore::bondem.errors.RaggedInterfaceWarning")
def test_a_bar_of_two_materials_in_series_is_as_strong_as_the_weaker_and_as_stiff_as_both(bar):
    """1 / E = ½ / E1 + ½ / E2: 30 GPa. The first law, 20 GPa, sets the speed."""
    far = halves(bar)
    law, failure = {bd.Everything(): SOFT, far: HARD}, {bd.Everything(): PLAIN, far: STRONG}
    test = bd.labtests.direct_tension(bar, law, failure)
    assert test.peak == pytest.approx(3e6, rel=0.03)
    # the plane between two layers of cells is uneven: the share of the hard ones is theirs by volume
    share = bar.cells.volume[far.select(bar)].sum() / bar.cells.volume.sum()
    series = 1.0 / ((1.0 - share) / 20e9 + share / 60e9)
    assert pytest.approx(series, rel=0.02) == test.E
    broken = np.flatnonzero(test.state.bond_integrity < 0.5)
    assert len(broken)
    assert not set(bar.pairs[broken].ravel().tolist()) <= set(far.select(bar).tolist())


@pytest.mark.filterwarnings("ignore::bondem.errors.RaggedInterfaceWarning")
@pytest.mark.parametrize("name", ["direct_tension", "uniaxial_compression"])
def test_the_weakest_of_several_criteria_sets_the_speed_of_a_test(bar, name, monkeypatch):
    """A weak plane listed last had the speed that the strength of the first entry asks for: ten times its own."""
    test = getattr(bd.labtests, name)
    solid, plane = (
        bd.MohrCoulomb(tension=size * 4e6, cohesion=size * 10e6, friction_angle=0.5, fracture_energy=energy)
        for size, energy in ((1.0, 60.0), (0.1, 6.0))
    )
    rigs = []
    monkeypatch.setattr("bondem.labtests.loading.run_to_failure", lambda *given, **_: rigs.append(given[4]))
    far = halves(bar)
    within = {bd.Everything(): solid, (bd.Everything() - far, far): plane}
    swapped = {bd.Everything(): plane, far: plane, bd.Everything() - far: plane}
    stiff = {bd.Everything(): SOFT, far: HARD}
    for law, failure in ((SOFT, plane), (SOFT, within), (SOFT, swapped), (SOFT, solid), (stiff, plane)):
        test(bar, law, failure)
    alone, plane_last, all_plane, whole, two = rigs
    assert plane_last.expected == all_plane.expected == alone.expected
    assert plane_last.way == all_plane.way == alone.way
    assert plane_last.reach >= 0.9 * whole.reach  # it goes on to where the solid would fail
    assert two.way < alone.way  # stiffer than the first law


@pytest.mark.validate
def test_one_material_named_by_region_is_that_material(bar):
    far = halves(bar)
    plain = bd.labtests.direct_tension(bar, SOFT, PLAIN)
    named = bd.labtests.direct_tension(bar, {bd.Everything(): SOFT, far: SOFT}, {bd.Everything(): PLAIN, far: PLAIN})
    np.testing.assert_allclose(named.curve, plain.curve, rtol=1e-9, atol=1e-12)
    assert named.peak == pytest.approx(plain.peak, rel=1e-9)


@pytest.mark.validate
def test_bending_takes_materials_by_region(bar):
    far = halves(bar)
    until_the_peak = {"span": 24e-3, "ripple": 0.5, "until": 0.8}
    one = bd.labtests.three_point_bending(bar, SOFT, PLAIN, **until_the_peak)
    law, failure = {bd.Everything(): SOFT, far: SOFT}, {bd.Everything(): PLAIN, far: PLAIN}
    same = bd.labtests.three_point_bending(bar, law, failure, **until_the_peak)
    weak = {bd.Everything(): PLAIN, far: bd.Rankine(tension=1.5e6, fracture_energy=20.0)}
    less = bd.labtests.three_point_bending(bar, SOFT, weak, **until_the_peak)
    assert same.peak == pytest.approx(one.peak, rel=1e-9)
    assert less.peak < 0.9 * one.peak


@pytest.mark.validate
@pytest.mark.filterwarnings("ignore::bondem.errors.RaggedInterfaceWarning")
def test_a_test_of_several_materials_has_no_closed_form(bar):
    far = halves(bar)
    law, failure = {bd.Everything(): SOFT, far: HARD}, {bd.Everything(): PLAIN, far: STRONG}
    assert np.isnan(failure_outcome("direct_tension", bar, law, failure, density=2400.0).theory)
    pulse = {"pressure": 1e6, "rise": 1e-6, "fall": 1e-6}
    with pytest.raises(InputError, match="one law"):
        failure_outcome("spall", bar, law, PLAIN, density=2400.0, options=pulse)


@pytest.mark.parametrize("law", [{}, {bd.Everything(): bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.8)}, None])
def test_laws_that_are_none_of_cells_are_refused(bar, law):
    with pytest.raises(InputError, match="cells"):
        bd.labtests.direct_tension(bar, law, PLAIN)
    with pytest.raises(InputError, match="failure"):
        bd.labtests.direct_tension(bar, SOFT, {})


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    out = tmp_path_factory.mktemp("mesoscale")
    with only("cut_open"):
        return out, run_study(parse_study(STUDY | {"output": {"vtk": True, "run_files": True}}), out)


@pytest.mark.validate
def test_a_study_with_aggregates_lies_between_interface_and_mortar_and_breaks_no_aggregate(finished):
    out, results = finished
    test = results["packings"][0]["tests"]["direct_tension"]
    assert 2e6 < test["measured"] < 4e6
    assert test["theory"] is None
    lost = test["failure"]["lost_area"]
    assert lost["aggregate"] == 0.0
    assert lost["interface"] > 0.3 * lost["matrix"] > 0.0
    grains = results["specimen"]["aggregates"]
    assert grains["fraction"] == pytest.approx(0.15, abs=0.03)
    assert 25e9 < results["macro"]["E"] < 25e9 * 0.85 + 70e9 * 0.15  # Voigt's bound
    html = (out / "report.html").read_text()
    assert "Interface: Rankine" in html
    assert "Aggregates: Rankine" in html
    assert (out / "figures" / "cut_open.png").stat().st_size > 20_000
    kept = bd.read_run(out / "specimen_1.h5").model
    assert [law.E for law in kept.bond.values()] == [25e9, 70e9]


def test_lost_area_is_that_of_the_facets_that_lost_it():
    box = bd.Box((36e-3, 24e-3, 24e-3))
    stones = bd.aggregates(box, bd.Sieve((8e-3, 12e-3), (0.0, 1.0)), fraction=0.15, gap=3e-3, seed=1)
    body = bd.connect(bd.pack(box, count=800, method="even", around=stones, seed=1), method="laguerre")
    inside = stones.mask(body)[body.pairs].sum(axis=1)
    integrity = np.ones(len(body.pairs))
    chosen = [int(np.flatnonzero(inside == k)[0]) for k in range(3)]
    integrity[chosen] = 0.75, 0.5, 0.0
    state = SimpleNamespace(bond_integrity=integrity)
    area = body.facets.area[chosen]
    expected = dict(zip(("matrix", "interface", "aggregate"), (0.25 * area[0], 0.5 * area[1], area[2]), strict=True))
    assert lost_area(body, state, stones) == pytest.approx(expected)


@pytest.mark.parametrize(("changed", "told"), [
    ({"bond": {"law": "ParallelBond"}}, "failure"),
    ({"specimen": STUDY["specimen"] | {"method": "growth"}}, "even"),
    ({"specimen": STUDY["specimen"] | {"count": 300}}, "specimen.count"),
    ({"tests": ["direct_tension", "spall"], "spall": {"pressure": 1e6, "rise": 1e-6, "fall": 1e-6}}, "spall"),
    ({"failure": ROCK | {"curve": "bilinear"}}, "aggregates.failure.criterion"),
    ({"aggregates": STUDY["aggregates"] | {"fraction": 0.7}}, "aggregates.fraction"),
    ({"aggregates": STUDY["aggregates"] | {"fraction": 0.4}}, "aggregates.fraction.*at most 0.55"),
    ({"aggregates": STUDY["aggregates"] | {"diameters": ["12 mm", "8 mm"]}}, "aggregates.diameters"),
    ({"aggregates": STUDY["aggregates"] | {"radius": 1.0}}, "aggregates.radius"),
    ({"aggregates": STUDY["aggregates"] | {"interface": {"criterion": "Rankine"}}}, "aggregates.interface.tension"),
    ({"aggregates": 3}, "aggregates"),
])  # fmt: skip
def test_what_does_not_go_with_aggregates_is_refused(changed, told):
    with pytest.raises(StudyError, match=told):
        parse_study(STUDY | changed)


def test_criteria_of_aggregates_want_one_of_the_matrix():
    plain = {key: value for key, value in STUDY.items() if key != "failure"}
    with pytest.raises(StudyError, match=r"without \[failure\]"):
        parse_study(plain | {"tests": ["static_tension"]})


def test_a_programme_gives_aggregates_to_all_specimens():
    shared = {key: value for key, value in STUDY.items() if key not in ("tests", "specimen", "packings")}
    specimens = [
        STUDY["specimen"] | {"name": "prism", "tests": ["direct_tension"]},
        STUDY["specimen"] | {"name": "pulled", "tests": ["static_tension"]},
    ]
    programme = parse_programme(shared | {"specimens": specimens})
    assert isinstance(programme, Programme)
    broken, pulled = (one.study for one in programme.series)
    assert list(broken.failures) == ["Matrix", "Aggregates", "Interface"]
    assert pulled.failures == {}
    assert pulled.aggregates.E == 70e9
    assert json.dumps(programme.series[0].inputs)
