"""Branching, spalling and granite as studies: closed forms, what is read of a run, small runs, options."""

import math
from dataclasses import replace

import numpy as np
import pytest

from bondem.errors import InputError
from bondem.labtests.failure.spall import pulled_back
from validation.cases.lac_du_bonnet import CLAIMS, CORE, DISC, Granite, bent, toughness
from validation.frame.runner import run
from validation.rows.branching import BranchingRun, branching, fastest
from validation.rows.granite import GraniteRun
from validation.rows.ring import Ring, RingRun
from validation.rows.spall import Bar, SpallRun
from validation.studies import branching as branches
from validation.studies.branching import PLATES, Branching
from validation.studies.granite import GraniteStudy, _judged, first_peak
from validation.studies.ring import RingStudy
from validation.studies.spall import Spall

PLATE = PLATES["A"]


def test_plates_have_the_stated_geometry_and_waves():
    body = PLATE.body(2000, 1)
    assert body.cells.volume.sum() == pytest.approx(0.1 * 0.04 * 2e-3 - 50e-3 * 1e-3 * 2e-3, rel=2e-3)
    assert PLATE.rayleigh == pytest.approx(2125.0, rel=1e-3)
    # Viktorov's approximation
    shear = math.sqrt(72e9 / 2.0 / 1.22 / 2440.0)
    assert PLATES["B30"].rayleigh == pytest.approx(shear * (0.87 + 1.12 * 0.22) / 1.22, rel=5e-3)
    assert PLATES["B40"].longest == pytest.approx(0.342e-3, rel=1e-3)


def test_branches_are_counted_in_strips():
    x = np.linspace(0.0, 40e-3, 400)
    straight = np.zeros(400)
    assert branching(x, straight, 1e-3) is None
    fork = np.concatenate([straight, np.maximum(x - 20e-3, 0.0)])
    found = branching(np.tile(x, 2), fork, 1e-3)
    assert found == pytest.approx(20e-3 + 3.0e-3, abs=2.1e-3)  # three cells apart, to a strip
    # a speck beside the crack is no branch
    assert branching(np.append(x, 10e-3), np.append(straight, 8e-3), 1e-3) is None
    assert branching(np.zeros(0), np.zeros(0), 1e-3) is None


def test_the_fastest_advance_is_a_mean_over_ten_microseconds():
    time = np.linspace(0.0, 40e-6, 401)
    length = np.where(time < 20e-6, 500.0 * time, 10e-3 + 1200.0 * (time - 20e-6))
    assert fastest(time, length) == pytest.approx(1200.0, rel=0.02)
    jump = np.where(time < 20e-6, 0.0, 5e-3)  # a daughter crack ahead counts by its distance
    assert fastest(time, jump) == pytest.approx(500.0, rel=0.02)
    assert fastest(time[:50], length[:50]) is None


@pytest.mark.validate  # a whole study; `test_validation_fracture` and `test_validation_beams` keep one of each kind
def test_a_small_plate_breaks_and_is_judged(tmp_path, monkeypatch):
    """A thousand cells and 30 µs: the crack starts once the waves have been at the notch, 20 mm / 3.8 km/s."""
    monkeypatch.setitem(branches.PLATES, "A", replace(PLATE, duration=30e-6))
    found = run(Branching(counts=(1000,), seeds=(1,), cases=("A",)), tmp_path, processes=1, command="by a test")
    (one,) = found["runs"]
    assert 5e-6 < one["onset"] < 25e-6
    assert abs(one["onset_x"]) < 3e-3
    assert one["verdict"] == "missed"  # it has not branched by then
    assert (tmp_path / "figures" / "branching_A.png").stat().st_size > 10_000
    assert len({BranchingRun("A", PLATE, count, seed).name for count, seed in ((1, 1), (1, 2), (2, 1))}) == 3


@pytest.mark.parametrize("bad", [{"cases": ("C",)}, {"seeds": ()}, {"seeds": (-1,)}, {"counts": (10,)}])
def test_bad_plates_are_refused(bad):
    with pytest.raises(InputError):
        Branching(**bad)


def test_a_thin_bar_gives_the_published_velocities_and_another_place():
    bar = Bar()
    thin = bar.thin
    assert thin.celerity == pytest.approx(4050.0, rel=1e-3)
    assert thin.velocity == pytest.approx(7.75, rel=0.01)
    assert thin.pull_back(18.9e6) == pytest.approx(3.5, rel=0.01)
    # tension of the two waves, read from the pulse: the crest has come back when the tail is 2 d / c behind
    place = thin.place(18.9e6)
    later = bar.crest + 2.0 * place / thin.celerity
    assert bar.pressure * (1.0 - (bar.end - later) / (bar.end - bar.crest)) == pytest.approx(18.9e6)


def test_a_pull_back_ends_where_the_velocity_comes_up():
    t = np.linspace(0.0, 1.0, 1001)
    velocity = np.interp(t, [0.0, 0.3, 0.5, 0.7, 1.0], [0.0, 8.0, 4.5, 6.0, 1.0])
    assert pulled_back(velocity, 0.3) == pytest.approx((8.0, 3.5), abs=0.02)
    assert pulled_back(np.interp(t, [0.0, 0.3, 1.0], [0.0, 8.0, 0.0]), 0.3)[1] is None


def test_a_small_bar_spalls(tmp_path):
    """A thousand cells: twice the incident velocity but for the width of the cells, and pieces that add up."""
    bar = Bar()
    row = SpallRun(bar, 18.9e6, 50.0, 6e-3, 1).measured(tmp_path)
    assert row["highest"] == pytest.approx(bar.thin.velocity, rel=0.12)
    assert 0.9 * bar.length < sum(row["lengths"]) <= 1.001 * bar.length
    assert (bar.crest + bar.length / bar.thin.celerity) < row["first"] < 100e-6
    assert row["residual"] < 1e-2
    strong = SpallRun(bar, 60e6, 500.0, 6e-3, 1).measured(tmp_path)
    assert strong["first"] is None
    assert strong["lengths"] == [pytest.approx(bar.length, rel=2e-3)]


@pytest.mark.validate  # a whole study; `test_validation_fracture` and `test_validation_beams` keep one of each kind
def test_the_study_of_spalling_draws_and_keeps_its_numbers(tmp_path):
    found = run(Spall(strengths=(18.9,), energies=(50.0,), seeds=(1,), sizes=(7.0,)), tmp_path, processes=1,
                command="by a test")  # fmt: skip
    (one,) = found["runs"]
    assert one["thin"] == pytest.approx(18.4e-3, abs=0.1e-3)
    assert 0.0 < one["broken"][0] < one["broken"][1] < 0.14
    assert (tmp_path / "figures" / "spall.png").stat().st_size > 10_000
    assert "| place | 0.057 |" in (tmp_path / "table.md").read_text()


@pytest.mark.parametrize("bad", [{"strengths": (0.0,)}, {"energies": ()}, {"seeds": (-1,)}, {"sizes": (-2.0,)}])
def test_bad_bars_are_refused(bad):
    with pytest.raises(InputError):
        Spall(**bad)


def test_the_granite_is_what_is_published():
    granite = Granite()
    assert granite.compressive == pytest.approx(216e6, rel=3e-3)
    assert granite.toughness == pytest.approx(1.504e6, rel=1e-3)
    assert DISC.factor == pytest.approx(0.960, abs=5e-4)
    assert CORE.volume == pytest.approx(math.pi * 15.85e-3**2 * 63.4e-3)
    assert math.pi * 27e-3**2 * 27e-3 > DISC.body(300, 1).cells.volume.sum() > 0.98 * math.pi * 27e-3**2 * 27e-3


@pytest.mark.parametrize("depth", [0.05, 0.2])
def test_toughness_is_that_of_another_handbook(depth):
    """Brown and Srawley (1966), K = 1.5 P S √a Y / B W², within 0.5 %."""
    a = 0.5
    Y = 1.93 - 3.07 * a + 14.53 * a**2 - 25.11 * a**3 + 25.8 * a**4
    expected = 1.5 * 1e3 * 4.0 * depth * math.sqrt(a * depth) * Y / (0.5 * depth * depth**2)
    assert toughness(1e3, depth) == pytest.approx(expected, rel=5e-3)


def test_beams_have_the_proportions_of_the_standard():
    case = bent(Granite(), 0.05)
    lower, upper = case.shape.bounds
    np.testing.assert_allclose(upper - lower, [0.25, 0.05, 0.025])
    assert [line.x for line in case.held] == pytest.approx([0.025, 0.225])
    across = np.array([[0.125, y, 0.0125] for y in (0.0249, 0.0251)])
    assert case.shape.contains(across).tolist() == [False, True]


@pytest.mark.parametrize(("test", "least", "most"), [("direct_tension", 0.8, 1.2), ("brazilian", 1.0, 1.3)])
def test_small_specimens_break_near_their_strength(test, least, most, tmp_path):
    """The disc has a diameter of 1.15 E G_f / f_t²: it redistributes stress before it splits."""
    row = GraniteRun(Granite(), test, 300, 1).measured(tmp_path)
    assert least < first_peak(row["curve"]["stress"]) / Granite().tension < most  # its halves carry more later
    assert row["broken"] > 0
    assert max(row["curve"]["stress"]) == pytest.approx(row["peak"], rel=1e-3)


@pytest.mark.validate  # a whole study; `test_validation_fracture` and `test_validation_beams` keep one of each kind
def test_granite_is_judged_by_its_claims(tmp_path):
    study = GraniteStudy(tests=("direct_tension",), counts=(200,), seeds=(1,))
    found = run(study, tmp_path, processes=1, command="by a test")
    (one,) = found["cases"]
    assert one["verdict"] == CLAIMS["direct_tension"].verdict(one["values"])
    assert one["over"] == pytest.approx(one["mean"]["mean"] / 6.9e6)
    assert (tmp_path / "figures" / "granite.png").stat().st_size > 10_000


def test_means_of_granite_are_judged_by_the_published_range():
    assert first_peak([0.0, 3.0, 7.0, 6.0, 5.0, 8.0, 2.0]) == 7.0
    assert first_peak([0.0, 3.0, 7.0, 6.0]) == 7.0
    rows = [{"seed": 1, "count": 9}, {"seed": 2, "count": 9}]
    assert _judged("ucs", rows, 216e6, [170e6, 200e6])["verdict"] == "met by the mean"
    assert _judged("ucs", rows, 216e6, [170e6, 176e6])["verdict"] == "missed"


@pytest.mark.parametrize("bad", [{"tests": ("shear",)}, {"counts": (5,)}, {"seeds": ()}, {"finer": 0.0}])
def test_bad_granite_is_refused(bad):
    with pytest.raises(InputError):
        GraniteStudy(**bad)


def test_a_ring_is_braked_as_a_breathing_ring(tmp_path):
    ring = Ring(circumference=10e-3)
    row = RingRun(ring, 12e3, 0.15e-3, 1).measured(tmp_path)
    _, slowed = ring.braked(12e3)
    assert slowed < 0.9 * 12e3
    assert row["slowed"] == pytest.approx(slowed, rel=0.03)
    assert row["dissipated"] > 0.5
    with pytest.raises(InputError):
        RingStudy(side=0.2e-3, size=0.12e-3)
