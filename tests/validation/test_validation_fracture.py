"""Published fracture cases: their geometry, what is said of a run, and rows that are not made twice."""

from dataclasses import replace

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from validation.cases.beams import BentBeam
from validation.cases.case import Claim
from validation.figures.fracture import envelope
from validation.frame.runner import run
from validation.rows.fracture import FractureRun, counted
from validation.studies import fracture
from validation.studies.fracture import CASES, Fracture

BENT = [name for name in CASES if name != "l_panel"]
# length, depth, width, supports, load, notch: middle and depth [mm], as the benchmarks have them
STATED = {
    "petersson": (2100, 200, 50, (50, 2050), 1050, (1050, 100)),
    "gregoire": (175, 50, 50, (25, 150), 87.5, (87.5, 25)),
    "garcia_alvarez": (250, 80, 50, (25, 225), 125, (75, 20)),
}


@pytest.fixture(scope="module", params=list(CASES))
def case(request):
    return CASES[request.param]


@pytest.fixture(scope="module")
def body(case):
    return case.body(1, 0.6)


@pytest.mark.parametrize("name", BENT)
def test_beams_have_the_stated_geometry(name):
    case, (length, depth, width, supports, load, (at, deep)) = CASES[name], STATED[name]
    lower, upper = case.shape.bounds
    np.testing.assert_allclose(lower, 0.0, atol=1e-12)
    np.testing.assert_allclose(1e3 * upper, [length, depth, width])
    np.testing.assert_allclose([1e3 * line.x for line in case.held], supports)
    assert 1e3 * case.driven[0].x == pytest.approx(load)
    across = np.array([[at, y, 0.5 * width] for y in (0.99 * deep, 1.01 * deep)]) * 1e-3
    assert case.shape.contains(across).tolist() == [False, True]


def test_the_panel_has_the_stated_geometry():
    case = CASES["l_panel"]
    assert case.shape.volume == pytest.approx(0.75 * 0.5 * 0.5 * 0.1, rel=2e-3)
    assert not case.shape.contains([[0.26, 0.24, 0.05]]).any()
    assert case.shape.contains([[0.24, 0.24, 0.05], [0.26, 0.26, 0.05]]).all()
    assert (case.driven[0].x, case.driven[0].y) == (0.47, 0.25)
    assert max(load for _, load in case.curve) == pytest.approx(0.5 * (case.claim.low + case.claim.high))


def test_bodies_fill_their_shapes_and_are_fine_where_the_crack_is(case, body):
    size = np.cbrt(body.cells.volume)
    lower, upper = case.about.bounds
    assert body.cells.volume.sum() == pytest.approx(case.shape.volume, rel=2e-3)
    assert size.max() > 1.5 * size.min()
    fine = case.about.contains(body.centre)
    assert size[fine].mean() == pytest.approx(case.fine / 0.6, rel=0.15)
    assert (lower >= -1e-6).all()
    assert (upper <= case.shape.bounds[1] + 1e-6).all()


def test_rollers_are_rows_of_cells_across_the_body_that_may_turn(case, body):
    model, driven = case.model(body)
    width = case.shape.bounds[1][2]
    for line, cells in [(case.driven[0], driven), *((one, one.cells(body)) for one in case.held)]:
        centre = body.centre[list(cells.elements)]
        assert len(centre) >= 2
        assert np.ptp(centre[:, 2]) > 0.4 * width
        assert np.abs(centre[:, 0] - line.x).max() < 1.1 * case.coarse / 0.6
        assert np.abs(centre[:, 1] - line.y).max() < 1.1 * case.coarse / 0.6
    # forces through the middles of their lines, in balance unless a face is clamped
    loads = [one for one in model.boundary if isinstance(one, bd.Load)]
    force = np.array([one.force for one in loads])
    acts = [np.cross(one.region.anchor(body), one.force) + one.moment for one in loads]
    lines = [case.driven[0], *case.held]
    through = [np.cross([line.x, line.y, 0.5 * width], one) for line, one in zip(lines, force, strict=True)]
    np.testing.assert_allclose(acts, through, atol=1e-9)
    if not case.clamped:
        assert np.abs(force.sum(axis=0)).max() < 1e-9
        assert np.abs(np.sum(through, axis=0)).max() < 1e-9


def test_a_beam_on_rollers_bends_as_beams_do():
    """Without a notch, P L³ / 48 EI and shear, 3 P L / 10 G A, but for a tenth: rollers clamp nothing."""
    case = CASES["gregoire"]
    length, depth, width = 0.4, 0.05, 0.05
    beam = BentBeam(length=length, depth=depth, width=width, supports=(0.025, 0.375), loaded=0.2,
                    notch=(0.2, 1e-4, 1e-4))  # fmt: skip
    plain = replace(case, shape=bd.Box((length, depth, width)), about=bd.Box((1e-3, depth, width)).moved((0.2, 0, 0)),
                    driven=beam.driven, held=beam.held, mouth=None, fine=7e-3, coarse=12e-3)  # fmt: skip
    body = plain.body(1)
    model, _ = plain.model(body)
    moved = bd.solve_static(replace(model, failure=None)).displacement[:, 1]
    first, second = plain.gauges(body)["roller 0"], plain.gauges(body)["roller 1"]
    found = np.mean([moved[list(b.elements)].mean() - moved[list(a.elements)].mean() for a, b in (first, second)])
    span, area = 0.35, width * depth
    bent = 1e3 * span**3 / (48.0 * case.E * width * depth**3 / 12.0)
    sheared = 0.3 * 1e3 * span * 2.0 * (1.0 + case.nu) / (case.E * area)
    assert -found == pytest.approx(bent + sheared, rel=0.1)


def test_claims_are_judged():
    claim = Claim("peak", 9.0, 11.0, "")
    assert claim.verdict([9.5, 10.5]) == "met"
    assert claim.verdict([8.5, 10.5]) == "met by the mean"
    assert claim.verdict([8.5, 8.9]) == "missed"


def test_the_work_of_petersson_is_that_of_his_ligament():
    case = CASES["petersson"]
    assert case.fracture_energy * 0.05 * 0.1 == pytest.approx(0.62)
    assert (case.claim.low, case.claim.high) == (pytest.approx(0.589), pytest.approx(0.651))


def test_events_of_a_folded_hinge_do_not_count():
    load = np.array([1.0, 5.0, 10.0, 8.0, 2.0, 0.1, 50.0, 3.0])
    way = np.array([0.1, 0.5, 1.0, 1.2, 2.0, 3.0, 90.0, 1.0])
    assert counted(load, way, 0.2, 10.0) == (2, 4)
    assert counted(load, way, 0.2, 100.0) == (6, 6)


def test_an_envelope_holds_the_peak():
    x, load = np.linspace(0.0, 1.0, 400), np.random.default_rng(1).random(400)
    at, most = envelope(x, load)
    assert most.max() == load.max()
    assert (np.diff(at) > 0.0).all()
    assert len(at) <= 122


def test_a_request_knows_its_case_and_size():
    first = FractureRun(CASES["gregoire"], 1)
    names = {first.name, FractureRun(CASES["gregoire"], 2).name, FractureRun(CASES["gregoire"], 1, 2.0).name,
             FractureRun(replace(CASES["gregoire"], nu=0.18), 1).name}  # fmt: skip
    assert len(names) == 4


@pytest.mark.validate
def test_a_study_runs_judges_draws_and_goes_on(tmp_path, monkeypatch):
    """A hundred cells in wide steps: nothing physical is asked of them."""
    quick = replace(CASES["gregoire"], ripple=0.5, together=0.05, until=0.6)
    monkeypatch.setitem(fracture.CASES, "gregoire", quick)
    study = Fracture(cases=("gregoire",), seeds=(1,), finer=0.35)
    first = run(study, tmp_path, processes=1, command="by a test")
    (row,), (one,) = first["rows"], first["cases"]
    load, way = np.array(row["curve"]["load"]), np.array(row["curve"]["displacement"])
    assert row["peak"] == pytest.approx(load.max(), rel=1e-5)
    assert 300.0 < row["peak"] < 5000.0
    assert row["events"] == len(load) == len(way) == len(row["curve"]["CMOD"])
    assert np.array(row["curve"]["CMOD"])[-1] > 0.0
    assert len(row["crack"]["x"]) == len(row["crack"]["normal_z"]) > 0
    assert row["area"] == pytest.approx(sum(row["crack"]["area"]), rel=1e-4)
    assert one["verdict"] == study_verdict(row["peak"])
    assert (tmp_path / "figures" / "gregoire.png").stat().st_size > 10_000
    assert one["verdict"] in (tmp_path / "table.md").read_text()
    (kept,) = (tmp_path / "rows").glob("*.json")
    before = kept.stat().st_mtime_ns
    again = run(study, tmp_path, processes=1, command="by a test")
    assert kept.stat().st_mtime_ns == before
    assert again["cases"] == first["cases"]


def study_verdict(peak: float) -> str:
    return "met" if 933.0 <= peak <= 1114.0 else "missed"


@pytest.mark.parametrize("bad", [{"cases": ("nobody",)}, {"seeds": ()}, {"finer": 0.0}, {"seeds": (-1,)}])
def test_bad_options_are_refused(bad):
    with pytest.raises(InputError):
        Fracture(**bad)
