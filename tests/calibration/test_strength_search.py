"""Steps of a strength calibration: bounds, longest steps, what a run teaches, and intervals, in closed form."""

import itertools
import math

import numpy as np
import pytest
from scipy import stats

import bondem as bd
from bondem.calibration.secant import Secant

NEAR = {"a": (4e6, 4e4), "b": (4e6, 4e4)}


def product(p, q):
    return 1e6 * p * q


def quotient(p, q):
    return 1e6 * p / q


POWERS = {"a": product, "b": quotient}


def secant(slopes, target, weight=(1.0, 1.0)):
    return Secant(np.zeros(2), np.zeros(2), np.array(slopes), np.array(target), np.array(weight))


def test_what_is_held_at_a_bound_is_made_up_for_by_the_others():
    """Slopes (1 1; 0 1) and the target (2, 1): (1, 1) where it is free; least squares with x0 <= 1/2: 5/4."""
    search, far = secant([[1.0, 1.0], [0.0, 1.0]], [2.0, 1.0]), np.full(2, 10.0)
    assert search.step(10.0, -far, far) == pytest.approx([1.0, 1.0])
    assert search.step(10.0, -far, np.array([0.5, 10.0])) == pytest.approx([0.5, 1.25])
    assert search.step(0.25, -far, far) == pytest.approx([0.25, 0.25])


def test_steps_weigh_targets_by_their_tolerances():
    """One parameter for two targets: least squares of what is missed over the tolerance."""
    search = Secant(np.zeros(1), np.zeros(2), np.ones((2, 1)), np.array([1.0, 0.0]), np.array([3.0, 1.0]))
    assert search.step(10.0, np.array([-9.0]), np.array([9.0])) == pytest.approx([0.9])


def test_a_run_that_is_worse_teaches_slopes_and_moves_nothing():
    search = secant([[1.0, 0.0], [0.0, 1.0]], [1.0, 1.0])
    worse = search.learned(np.array([1.0, 0.0]), np.array([-2.0, 0.0]))
    assert worse.x == pytest.approx([0.0, 0.0])
    assert worse.y == pytest.approx([0.0, 0.0])
    assert worse.slopes[0] == pytest.approx([-2.0, 0.0], rel=1e-3)
    better = search.learned(np.array([1.0, 0.0]), np.array([0.5, 0.5]))
    assert better.x == pytest.approx([1.0, 0.0])
    assert better.slopes == pytest.approx(np.array([[0.5, 0.0], [0.5, 1.0]]), abs=1e-3)


def test_no_run_is_farther_than_a_factor_of_two_from_the_one_before():
    tests = {"t": lambda strength: 0.31 * strength}
    fit = bd.calibrate_strength(tests, {"t": (4e6, 4e4)}, {"strength": 400e6}, strengths=("strength",))
    assert fit.reached
    tried = [run.parameters["strength"] for run in fit.runs]
    assert len(tried) > 4
    assert max(abs(math.log(b / a)) for a, b in itertools.pairwise(tried)) < math.log(2.0) * (1.0 + 1e-9)


def test_first_slopes_are_found_where_the_scale_meets_the_tighter_target():
    """Both scale with p: at the start a is half of its target and b is it, and only a is asked for closely."""
    tests = {"a": lambda p, q: 2e6 * p * q**0.2, "b": lambda p, q: 4e6 * p * q**-0.1}
    targets = {"a": (4e6, 1e4), "b": (4e6, 2e6)}
    fit = bd.calibrate_strength(tests, targets, {"q": 1.0, "p": 1.5}, strengths=("p",), most=2)
    assert fit.runs[1].parameters["q"] == pytest.approx(1.25)
    assert fit.runs[1].parameters["p"] == pytest.approx(2.0, rel=1e-3)


def test_a_parameter_at_its_bound_is_probed_the_other_way():
    fit = bd.calibrate_strength(POWERS, NEAR, {"p": 5.0, "q": 1.5}, bounds={"p": (1.0, 5.0)})
    assert fit.reached
    assert fit.runs[1].parameters["p"] == pytest.approx(4.0)
    assert fit.parameters["p"] == pytest.approx(4.0, rel=0.01)
    assert fit.parameters["q"] == pytest.approx(1.0, rel=0.01)


def test_no_run_leaves_the_bounds():
    """The first slope would be told at 1.25 times the start, 3.75, and the targets ask for 4."""
    fit = bd.calibrate_strength(POWERS, NEAR, {"p": 3.0, "q": 1.5}, bounds={"p": (1.0, 3.5), "q": (1.2, 2.0)})
    assert not fit.reached
    assert "p, q at a bound" in fit.message
    assert max(run.parameters["p"] for run in fit.runs) == pytest.approx(3.5)
    assert min(run.parameters["q"] for run in fit.runs) == pytest.approx(1.2)


def test_a_probe_that_meets_the_targets_ends_the_search():
    asked = []

    def both(p, q):
        asked.append((p, q))
        return 1e6 * p * q

    fit = bd.calibrate_strength({"a": both, "b": quotient}, NEAR, {"p": 3.2, "q": 1.0})
    assert fit.reached
    assert len(asked) == len(fit.runs) == 2


def test_targets_that_exclude_each_other_end_it_when_nothing_is_to_be_gained():
    """a = p, b = p with a curve: no p gives 4 and 6 MPa together; the search does not go on about the best one."""
    tests = {"a": lambda p: 1e6 * p, "b": lambda p: 1e6 * p * (1.0 + 0.05 * math.log(p) ** 2)}
    fit = bd.calibrate_strength(tests, {"a": (4e6, 4e4), "b": (6e6, 6e4)}, {"p": 2.0})
    assert not fit.reached
    assert "no change of the parameters leads nearer to all targets" in fit.message
    assert len(fit.runs) <= 4


def test_steps_that_make_things_worse_are_halved_until_there_is_no_way():
    """Every other test is 10 % off to the other side: no slope is to be learned from it, and it ends early."""
    signs = itertools.cycle((-1.0, 1.0))
    tests = {"t": lambda strength: strength * (1.0 + 0.1 * next(signs))}
    fit = bd.calibrate_strength(tests, {"t": (4e6, 1e3)}, {"strength": 4.5e6}, strengths=("strength",))
    assert not fit.reached
    assert "strengths scatter more than their tolerances" in fit.message
    assert len(fit.runs) < 10


def test_tolerances_and_packings_give_the_intervals_of_closed_forms():
    """d ln (p, q) = (1 1; 1 -1)/2 d ln (a, b): both tolerances add up for both parameters."""
    targets = {"a": (4e6, 1e5), "b": (4e6, 2e5)}
    fit = bd.calibrate_strength(POWERS, targets, {"p": 3.0, "q": 1.5})
    half = 0.5 * (0.025 + 0.05)
    for name in ("p", "q"):
        value = fit.parameters[name]
        assert fit.tolerated(name) == pytest.approx((value * math.exp(-half), value * math.exp(half)), rel=2e-3)
    a, b = np.array([3.9e6, 4.0e6, 4.2e6, 4.1e6]), np.array([4.0e6, 4.1e6, 3.9e6, 4.0e6])
    logs = np.log(fit.parameters["q"]) - 0.5 * (np.log(a / 4e6) - np.log(b / 4e6))
    for kind, share in (("confidence", 0.5), ("prediction", math.sqrt(1.25))):
        for level in (0.5, 0.95):
            low, high = fit.interval("q", {"a": a, "b": b}, kind=kind, level=level)
            width = stats.t.ppf(0.5 + 0.5 * level, 3) * share * logs.std(ddof=1)
            assert math.log(high / low) == pytest.approx(2.0 * width, rel=5e-3)


def test_the_mean_of_packings_is_what_meets_a_target():
    fit = bd.calibrate_strength(
        {"t": lambda strength: [strength * f for f in (1.0, 1.0, 1.6)]}, {"t": (4e6, 4e4)}, {"strength": 9e6},
        strengths=("strength",),
    )  # fmt: skip
    assert fit.parameters["strength"] == pytest.approx(4e6 / 1.2, rel=0.01)
