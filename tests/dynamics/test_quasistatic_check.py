"""Runs that look quasi-static say when they are not: servo walls, ends that differ, kinetic energy."""

import math
import re
import warnings
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import NotQuasistaticWarning
from tests.specimens import bar, cells

LAW, RHO = bd.CellBond(E=30e9, nu=0.2), 2500.0
ENDS = bd.Face("x_min"), bd.Face("x_max")
CALM = bd.LocalDamping(0.2)
TARGET = 1e3


def pushed(duration: float, *, speed: float = 1.0, **options: Any) -> bd.ExplicitResult:
    """Bar of 100 cells between a fixed wall and a servo wall of 1 kN, which both touch it at first."""
    body = bar(100, 20e-3, 10e-3)
    radius = bd.Model(body, LAW, RHO).contact_radius
    low, high = (body.centre[:, 0] - radius).min(), (body.centre[:, 0] + radius).max()
    servo = bd.Servo(TARGET, speed=speed, **options)
    walls = [bd.PlaneWall((low, 0, 0), (1, 0, 0)), bd.PlaneWall((high, 0, 0), (-1, 0, 0), motion=servo)]
    model = bd.Model(body, LAW, RHO, contact=bd.LinearContact(E=30e9), walls=walls)
    gauges = {"near": bd.WallGauge(0, "force"), "far": bd.WallGauge(1, "force")}
    return bd.solve_explicit(model, duration=duration, damping=CALM, every=20, gauges=gauges)


def late(run: bd.ExplicitResult) -> np.ndarray:
    """Force of the servo wall in the last fifth of a run over the prescribed one [-]."""
    force = run.history["far"][:, 0] / TARGET
    return force[-len(force) // 5 :]


def test_a_servo_wall_of_default_mass_settles_at_its_force():
    settled = pushed(6e-4)
    assert np.abs(late(settled) - 1.0).max() < 0.03
    assert settled.quasistatic.servo[1] == pytest.approx((TARGET, TARGET), rel=0.03)
    assert settled.quasistatic.faults == ()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NotQuasistaticWarning)
        former = pushed(6e-4, damping=0.0)
    assert np.ptp(late(former)) > 3.0 * np.ptp(late(settled))


def test_a_servo_wall_that_does_not_reach_its_force_says_what_it_reached():
    with pytest.warns(NotQuasistaticWarning, match="servo wall 1 presses with .* N at the end, not 1000 N") as caught:
        run = pushed(1e-4, speed=0.2)
    reached, wanted = run.quasistatic.servo[1]
    assert (reached, wanted) == (run.history["far"][-1, 0], TARGET)
    assert reached < 0.9 * TARGET
    assert f"{reached:.4g} N" in str(caught[0].message)
    assert caught[0].filename == __file__


def joint(speed: float, push: float = 20e-6) -> bd.ExplicitResult:
    """Block that is pressed on a rough floor by 20 µm and then driven along it."""
    floor = bd.Fix(bd.Face("z_min"), translation="z", rotation="", friction=0.46)
    rise = 4e-5
    lid = bd.Drive(bd.Face("z_max"), z=bd.Ramp(0.0, -push, rise), vx=bd.Ramp(0.0, speed, rise, begin=rise))
    model = bd.Model(cells(bd.Box((20e-3, 10e-3, 10e-3)), 100), LAW, RHO, [floor, lid])
    gauges = {"floor": bd.Gauge(bd.Face("z_min"), "force"), "lid": bd.Gauge(bd.Face("z_max"), "force")}
    return bd.solve_explicit(model, duration=3e-4, damping=CALM, every=20, gauges=gauges)


def ratio(run: bd.ExplicitResult, end: str) -> float:
    """Largest shear force at an end over its largest pressure [-]."""
    shear, _, pressure = np.abs(run.history[end]).max(axis=0)
    return float(shear / pressure)


def test_a_joint_that_is_sheared_too_fast_is_not_silent():
    """Sliding carries μ times the pressure; a lid that is driven too fast carries the inertia of the block too."""
    slow = joint(0.2)
    assert slow.quasistatic.faults == ()
    assert ratio(slow, "lid") == pytest.approx(0.46, rel=0.02)
    with pytest.warns(NotQuasistaticWarning, match="the forces at both ends differed by"):
        fast = joint(10.0)
    assert ratio(fast, "floor") == pytest.approx(0.46, rel=0.02)
    assert ratio(fast, "lid") > 0.6
    assert fast.quasistatic.difference > 0.1


def pull(speed: float, **changed: Any) -> bd.ExplicitResult:
    """Bar between two ends that move apart, to a strain of 10⁻⁴."""
    rise = 1e-4 * 20e-3 / speed
    ways = zip(ENDS, (-0.5, 0.5), strict=True)
    ends = [bd.Drive(end, vx=bd.Ramp(0.0, share * speed, 0.2 * rise)) for end, share in ways]
    gauges = {name: bd.Gauge(end, "force") for name, end in zip(("near", "far"), ENDS, strict=True)}
    model = bd.Model(bar(60, 20e-3, 10e-3), LAW, RHO, ends)
    return bd.solve_explicit(model, **{"duration": rise, "damping": CALM, "every": 2, "gauges": gauges} | changed)


def test_measures_are_those_of_a_bar():
    """A bar whose ends part by ε L in N passes of sound has kinetic over elastic energy of 1 / (12 N²)."""
    passes = 10.0
    speed = 1e-4 * math.sqrt(LAW.E / RHO) / passes
    run = pull(speed)
    assert run.quasistatic.kinetic == pytest.approx(1.0 / (12.0 * passes**2), rel=0.5)
    assert run.quasistatic.difference < 0.05
    assert re.search("two ends, with damping", run.quasistatic.meant)
    with pytest.warns(NotQuasistaticWarning, match="kinetic energy reached"):
        pull(speed * 2.0 * passes)


def test_what_is_meant_to_be_fast_is_not_judged():
    """Undamped and fast, or driven at one end only: silent, as warnings are errors here."""
    fast = pull(2.0, damping=None, duration=5e-6)
    assert fast.quasistatic.kinetic > 0.05
    model = bd.Model(bar(60, 20e-3, 10e-3), LAW, RHO, [bd.Drive(ENDS[1], vx=-1.0)])
    struck = bd.solve_explicit(model, duration=2e-5, damping=CALM, every=2)
    for run in (fast, struck):
        assert run.quasistatic.meant == ""
        assert run.quasistatic.faults == ()
