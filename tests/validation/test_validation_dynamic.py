"""Kalthoff's plate and bars after Weibull as studies: geometry, what is read of a run, verdicts, options."""

import math

import numpy as np
import pytest

from bondem.errors import InputError
from validation.frame.runner import run
from validation.rows.kalthoff import KalthoffRun, Plate
from validation.rows.weibull import Ceramic, WeibullRun
from validation.studies.kalthoff import Kalthoff, _judged
from validation.studies.weibull import WeibullStudy

PLATE = Plate()


def test_the_plate_has_the_stated_geometry():
    body = PLATE.body(4e-3, 1)
    assert body.cells.volume.sum() == pytest.approx(0.1 * 0.1 * 9e-3 - 50e-3 * 0.5e-3 * 9e-3, rel=2e-3)
    # nothing is joined across the notch
    first, second = body.centre[body.pairs].transpose(1, 0, 2)
    across = (first[:, 1] - 25e-3) * (second[:, 1] - 25e-3) < 0.0
    x = body.facets.centroid[across, 0]
    assert across.sum() > 10
    assert x.min() > 49e-3
    struck = PLATE.struck(4e-3).select(body)
    assert (body.centre[struck, 1] < 25e-3).all()
    assert (body.centre[struck, 0] < 4e-3).all()
    assert len(struck) > 8


@pytest.mark.parametrize("angle", [30.0, 70.0, 85.0])
def test_the_angle_of_a_straight_crack_is_found(angle):
    far = np.linspace(0.0, 60e-3, 200)
    way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    place = np.column_stack([far[:, None] * way + PLATE.tip, np.zeros(200)])
    # and what breaks at the back and below the notch does not count
    other = np.column_stack([np.full(50, 99e-3), np.linspace(0.0, 20e-3, 50), np.zeros(50)])
    found = PLATE.angle(np.vstack([place, other]), np.ones(250), 1e-3)
    assert found == pytest.approx(angle, abs=0.1)


def test_a_plate_that_does_not_crack_is_an_error():
    with pytest.raises(InputError, match="no crack within"):
        PLATE.angle(np.zeros((0, 3)), np.zeros(0), 1e-3)


@pytest.mark.parametrize(
    ("angles", "verdict"),
    [((66.0, 74.0), "met"), ((64.0, 74.0), "met by the mean"), ((60.0, 62.0), "missed"), ((80.0, 70.5), "missed")],
)
def test_angles_are_judged(angles, verdict):
    rows = [
        {"tension": 1.9e9, "size": 1.5e-3, "angle": angle, "seed": k, "count": 1, "steps": 1, "run_seconds": 1.0,
         "residual": 0.0}
        for k, angle in enumerate(angles)
    ]  # fmt: skip
    judged = _judged(rows)
    assert judged["verdict"] == verdict
    assert judged["over"] == pytest.approx(1.5e-3 / (2.0 * 190e9 * 22.13e3 / 1.9e9**2))


def test_a_coarse_plate_is_struck_and_cracks(tmp_path):
    """Cells of 4.4 mm, a thousand of them, and a weak steel: nothing is asked of the angle."""
    row = KalthoffRun(PLATE, 500e6, 4.4e-3, 1).measured(tmp_path)
    assert 800 < row["count"] < 1200
    assert row["residual"] < 1e-2
    assert 0.0 < row["angle"] < 90.0
    assert len(row["x"]) == len(row["y"]) > 10


@pytest.mark.parametrize(
    "bad", [{"seeds": ()}, {"seeds": (-1,)}, {"strengths": (0.0,)}, {"size": 0.0}, {"size": 7.0}]
)
def test_bad_plates_are_refused(bad):
    with pytest.raises(InputError):
        Kalthoff(**bad)


@pytest.mark.filterwarnings("ignore::bondem.errors.StrengthWarning")
def test_bars_have_their_volume_and_their_strength(tmp_path):
    ceramic, volume = Ceramic(), 100 * 27e-9
    asked = WeibullRun(ceramic, volume, 3e-3, 6e-3, 5)
    assert asked.body().cells.volume.sum() == pytest.approx(volume, rel=1e-9)
    row = asked.measured(tmp_path)
    assert row["weakest"] <= row["first"] <= row["strength"] < 1.02 * row["weakest"]
    others = [WeibullRun(ceramic, volume, 3e-3, reach, seed) for reach, seed in ((0.0, 5), (6e-3, 6))]
    assert len({asked.name, *(one.name for one in others)}) == 3


@pytest.mark.validate  # a whole study; `test_validation_fracture` and `test_validation_beams` keep one of each kind
@pytest.mark.filterwarnings("ignore::bondem.errors.StrengthWarning")
def test_the_study_of_bars_compares_with_the_weakest_link(tmp_path, monkeypatch):
    monkeypatch.setattr("validation.studies.weibull._VOLUMES", (30, 60))
    monkeypatch.setattr("validation.studies.weibull._SIZES", (2.8e-3, 3.2e-3))
    monkeypatch.setattr("validation.studies.weibull._SPHERES", (120, 240))
    found = run(WeibullStudy(seeds=(1, 2, 3, 4)), tmp_path, processes=1, command="by a test")
    first = found["bars"][0]
    assert first["asked"] == pytest.approx(math.gamma(1.2) * (1e-6 / (30 * 27e-9)) ** 0.2)
    same = [row["strength"] for row in found["rows"] if row["modulus"] == 5.0 and row["count"] == 30]
    assert first["mean"] == pytest.approx(np.mean(same))
    assert first["over_weakest"] == pytest.approx(1.0, abs=0.02)
    assert len(found["bars"]) == 16
    shown = [one for one in found["bars"] if one["verdict"] == "shown"]
    assert len(shown) == 4  # independent strengths, and cracks that soften
    assert (tmp_path / "figures" / "weibull.png").stat().st_size > 10_000


@pytest.mark.parametrize("bad", [(), (1,), (-1, 2)])
def test_bars_need_two_seeds(bad):
    with pytest.raises(InputError):
        WeibullStudy(seeds=bad)
