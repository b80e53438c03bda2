"""The tests of Celigueta et al.: sizes, plates, criteria and strengths are those of the paper."""

import math
from typing import cast

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from validation.rows.celigueta import FALLEN, CeliguetaRun, criterion
from validation.studies.celigueta import Celigueta


def test_count_0_takes_the_sizes_of_the_paper():
    asked = Celigueta(count=0, seeds=(1,), areas=("weighted",)).requests()
    assert {(one.test, one.count) for one in asked} == {("compression", 12_000), ("splitting", 9_000)}
    assert len(asked) == 4
    assert {one.count for one in Celigueta(count=500, seeds=(1,)).requests()} == {500}
    for wrong in (-1, 100):
        with pytest.raises(InputError, match="give 200 elements or more, or 0"):
            Celigueta(count=wrong)


def test_criteria_are_those_of_the_paper():
    """Its cone has no tensile strength of its own: the tip, c / tan φ, is where it ends."""
    rankine, cone = criterion("Rankine"), criterion("Mohr-Coulomb")
    assert isinstance(rankine, bd.Rankine)
    assert rankine.tension == 6e6
    assert isinstance(cone, bd.MohrCoulomb)
    assert (cone.cohesion, cone.friction_angle) == (14.5e6, pytest.approx(math.radians(60.0)))
    assert cone.tension * math.tan(cone.friction_angle) == pytest.approx(cone.cohesion)


@pytest.mark.parametrize(("test", "axis", "length", "speed"), [
    ("compression", 0, 0.2, 0.05), ("splitting", 2, 0.1, 0.1),
])  # fmt: skip
def test_plates_stand_at_the_specimen_and_move_at_the_speed_of_the_paper(test, axis, length, speed):
    for slower in (1.0, 2.0):
        run = CeliguetaRun(test, "Rankine", "weighted", 200, 1, slower)
        body = run.body()
        model = run.model(body)
        still, moving = model.walls
        assert run.axis == axis
        assert still.motion is None
        assert abs(moving.point[axis] - still.point[axis]) == pytest.approx(length)
        assert moving.normal[axis] == -1.0
        ((number, schedule, by_speed),) = moving.motion.motion
        assert (number, by_speed) == (axis, True)
        assert schedule.at(1.0) == pytest.approx(-speed / slower)
        # spheres are as heavy as the concrete that they stand for
        assert model.mass.sum() == pytest.approx(2400.0 * math.pi * 0.05**2 * 0.2)
        assert model.contact.friction == 0.1


def test_stresses_are_over_the_section_and_by_equation_7():
    pressed, split = (CeliguetaRun(test, "Rankine", "facet", 200, 1) for test in ("compression", "splitting"))
    assert pressed.section == pytest.approx(math.pi * 0.05**2)
    assert split.section == pytest.approx(math.pi * 0.05 * 0.2)


def test_a_run_ends_when_the_force_has_fallen_to_a_share_of_its_peak(monkeypatch):
    given = {}
    monkeypatch.setattr(bd, "solve_explicit", lambda model, **more: given.update(more))
    run = CeliguetaRun("splitting", "Rankine", "facet", 200, 1)
    run.run(cast(bd.Model, None))
    assert given["until"] == bd.LoadDrop({"moving": (0.0, 0.0, 1.0)}, FALLEN, 0.3e6 * run.section)
    assert given["gauges"]["moving"] == bd.WallGauge(1, "force")
    forces = np.array([0.0, 5e3, 1e4, FALLEN * 1e4 + 1.0, FALLEN * 1e4 - 1.0])
    pressed = np.column_stack([np.full(5, 9e9), np.zeros(5), forces])
    over = [given["until"].happened(None, {"moving": pressed[: k + 1]}) for k in range(5)]
    assert over == [False, False, False, False, True]
