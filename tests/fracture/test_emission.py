"""How fast cracks grow, what is one emission, and b of catalogues of which it is known."""

import math
from collections.abc import Callable

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.fracture.magnitudes import b_value_of, magnitude_of
from tests.specimens import cells, cubes


def broken(time, position, energy=1.0, mode="tension") -> bd.BrokenBonds:
    e = len(time)
    given = np.asarray(position, dtype=float)
    place = np.zeros((e, 3))
    place[:, : given.shape[1]] = given
    return bd.BrokenBonds(
        time=np.asarray(time, dtype=float), step=np.arange(e), bond=np.arange(e),
        mode=np.broadcast_to(np.array(mode), (e,)), gap=np.zeros(e), energy=np.broadcast_to(float(energy), (e,))
        if np.isscalar(energy) else np.asarray(energy, dtype=float), position=place,
        opening_steps=np.full(e, np.nan),
    )  # fmt: skip


NOTHING = broken([], np.zeros((0, 3)))


# Growth


def test_speed_of_a_crack_is_that_of_its_front() -> None:
    """A front at 2000 m/s along (3, 4, 0)/5 from an origin, and crumbs behind it that do not count."""
    t = np.linspace(1e-6, 21e-6, 41)
    way, start = np.array([0.6, 0.8, 0.0]), np.array([1.0, 2.0, 3.0])
    front = start + 2000.0 * t[:, None] * way + 1e-3 * np.sin(np.arange(41.0))[:, None] * [0.8, -0.6, 0.0]
    behind = front - 5e-3 * way
    found = bd.crack_speed(broken(np.tile(t, 2), np.vstack([front, behind])), start, 7.0 * way)
    assert found.speed == pytest.approx(2000.0, rel=1e-9)
    assert found.interval == pytest.approx((2000.0, 2000.0), rel=1e-9)
    np.testing.assert_allclose(found.time, t)
    np.testing.assert_allclose(found.length, 2000.0 * t, rtol=1e-9)
    some = bd.crack_speed(broken(t, front), start, way, between=(5.1e-6, 15.1e-6), beyond=0.02)
    assert some.time.min() > 9.9e-6
    assert some.time.max() < 15.1e-6


def test_a_robust_slope_does_not_follow_what_breaks_far_ahead() -> None:
    """Ten of fifty advances jump ahead by up to the tenth of the whole way, and wait there."""
    t = np.linspace(0.0, 1.0, 51)[1:]
    x = 3.0 * t
    x[20:30] = x[19] + 0.3 + 1e-3 * np.arange(10)
    found = bd.crack_speed(broken(t, x[:, None]), (0, 0, 0), (1, 0, 0))
    straight = np.polyfit(found.time, found.length, 1)[0]
    assert found.interval[0] <= 3.0 <= found.interval[1]
    assert abs(found.speed - 3.0) < abs(straight - 3.0)


@pytest.mark.parametrize("seed", range(5))
def test_a_front_that_staggers_has_its_mean_speed(seed: int) -> None:
    """What breaks scatters by 0.02 about a place that runs 5.0 in the time of 400 breaks."""
    rng = np.random.default_rng(seed)
    t = np.sort(rng.uniform(0.0, 1.0, 400))
    found = bd.crack_speed(broken(t, (5.0 * t + 0.02 * rng.standard_normal(400))[:, None]), (0, 0, 0), (1, 0, 0))
    assert (np.diff(found.length) > 0.0).all()
    assert found.speed == pytest.approx(5.0, rel=0.05)


# Emissions


def test_what_is_near_in_space_and_time_is_one_emission() -> None:
    """A chain in which each link is short; one too late; one too far; one farther than its cube is wide."""
    events = broken(
        time=[0.0, 0.9, 1.8, 9.0, 0.0, 0.0],
        position=[[0, 0, 0], [0.9, 0, 0], [1.8, 0, 0], [0, 0, 0], [9, 0, 0], [9.8, 0.8, 0.0]],
        energy=[1.0, 2.0, 1.0, 4.0, 8.0, 16.0], mode=["tension", "shear", "tension", "tension", "shear", "bending"],
    )  # fmt: skip
    found = bd.acoustic_emission(events, time=1.0, distance=1.0)
    assert found.label.tolist() == [0, 0, 0, 3, 1, 2]
    assert found.count.tolist() == [3, 1, 1, 1]
    np.testing.assert_allclose(found.energy, [4.0, 8.0, 16.0, 4.0])
    np.testing.assert_allclose(found.position[0], [0.9, 0.0, 0.0])  # (2 · 0.9 + 1.8) / 4
    np.testing.assert_allclose(found.time, [0.0, 0.0, 0.0, 9.0])
    np.testing.assert_allclose(found.duration, [1.8, 0.0, 0.0, 0.0])
    assert found.mode.tolist() == ["tension", "shear", "bending", "tension"]
    assert len(bd.acoustic_emission(events, time=100.0, distance=100.0)) == 1
    assert len(bd.acoustic_emission(events, time=1e-3, distance=1e-3)) == 6
    assert len(bd.acoustic_emission(NOTHING, time=1.0, distance=1.0)) == 0


def test_magnitudes_are_those_of_gutenberg_and_richter() -> None:
    """log10(E / erg) = 1.5 M + 11.8; a ton of TNT, 4.184e9 J, is M = 3.2."""
    energy = 10.0 ** (1.5 * np.array([-6.0, 0.0, 5.5]) + 11.8 - 7.0)
    np.testing.assert_allclose(magnitude_of(energy), [-6.0, 0.0, 5.5], atol=1e-12)
    assert magnitude_of(np.array([4.184e9]))[0] == pytest.approx(3.2, abs=0.02)
    events = broken([0.0, 5.0], np.zeros((2, 3)), energy=[0.0, 1.0])
    found = bd.acoustic_emission(events, time=1.0, distance=1.0)
    np.testing.assert_array_equal(found.magnitude, [-math.inf, -3.2])


def test_links_go_through_the_edges_of_a_periodic_cell() -> None:
    model = bd.Model(cells(bd.Cell((1.0, 1.0, 1.0)), 200), bd.CellBond(E=1e9, nu=0.2), 1000.0)
    events = broken([0.0, 0.0, 0.0], [[0.02, 0.5, 0.5], [0.98, 0.5, 0.5], [0.5, 0.5, 0.5]], energy=[1.0, 3.0, 1.0])
    found = bd.acoustic_emission(events, model=model, distance=0.1)
    assert found.label.tolist() == [0, 0, 1]
    np.testing.assert_allclose(found.position[0], [0.02 - 0.75 * 0.04, 0.5, 0.5])
    open_ended = bd.acoustic_emission(events, time=1.0, distance=0.1)
    assert len(open_ended) == 3


def test_defaults_are_two_spacings_and_the_time_of_a_wave_over_them() -> None:
    """Cubic cells of edge 1 at E = 4e6, ρ = 1000: √(E/ρ) = 63.2; beams of the same grid in a chain L √(k_n / m)."""
    body = cubes((4, 3, 3))
    late = 2.0 / math.sqrt(4e6 / 1000.0)
    beams = bd.EulerBernoulli(E=4e6, nu=0.2, radius_ratio=0.5)
    chain = 2.0 / math.sqrt(4e6 * math.pi * 0.25**2 / (1000.0 * math.pi / 6.0))
    bars = bd.Lattice(body.particles, body.pairs)
    for model, span in (
        (bd.Model(body, bd.CellBond(E=4e6, nu=0.3), 1000.0), late), (bd.Model(bars, beams, 1000.0), chain)
    ):  # fmt: skip
        for apart, after, many in ((1.99, 0.0, 1), (2.01, 0.0, 2), (0.0, 0.99 * span, 1), (0.0, 1.01 * span, 2)):
            events = broken([0.0, after], [[0.0, 0.0, 0.0], [apart, 0.0, 0.0]])
            assert len(bd.acoustic_emission(events, model=model)) == many


# b


def catalogue(b: float, count: int, seed: int, least: float = -7.0) -> np.ndarray:
    """Magnitudes with P(M > m) = 10^(-b (m - least))."""
    return least + np.random.default_rng(seed).exponential(math.log10(math.e) / b, count)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize(("b", "count"), [(0.7, 2000), (1.0, 2000), (1.5, 300)])
def test_b_of_a_catalogue_is_the_one_put_in(b: float, count: int, seed: int) -> None:
    """Within three of its standard errors; these are b / √n of an exponential distribution, and so are measured."""
    found = b_value_of(catalogue(b, count, seed), -7.0, 0.1)
    assert abs(found.b - b) < 3.0 * b / math.sqrt(count)
    assert found.error == pytest.approx(b / math.sqrt(count), rel=4.0 / math.sqrt(count))
    assert found.interval == pytest.approx((found.b - 1.96 * found.error, found.b + 1.96 * found.error))
    assert (found.count, found.completeness) == (count, -7.0)


def test_intervals_hold_b_as_often_as_they_say() -> None:
    """Of 1000 catalogues 950 ± 21 (three deviations of a binomial)."""
    found = [b_value_of(catalogue(1.0, 400, seed), -7.0, 0.1) for seed in range(1000)]
    held = sum(one.interval[0] <= 1.0 <= one.interval[1] for one in found)
    assert abs(held - 950) <= 21


@pytest.mark.parametrize("seed", range(6))
def test_small_emissions_that_are_missing_do_not_count(seed: int) -> None:
    """Below M = -6 more and more of them are not heard: the fullest bin is about there, and b is as above it."""
    all_of_them = catalogue(1.0, 20_000, seed)
    rng = np.random.default_rng(100 + seed)
    heard = all_of_them[rng.random(20_000) < 10.0 ** (4.0 * np.minimum(all_of_them + 6.0, 0.0))]
    found = b_value_of(heard, None, 0.1)
    assert found.completeness == pytest.approx(-6.0, abs=0.151)
    above = (heard >= -6.0).sum()
    assert b_value_of(heard, -6.0, 0.1).b == pytest.approx(1.0, abs=3.0 / math.sqrt(above))
    if found.completeness >= -6.0:
        assert found.b == pytest.approx(1.0, abs=3.0 * found.error)


def test_emissions_of_events_have_a_b() -> None:
    """Single breaks far apart, of energies whose magnitudes follow b = 1."""
    magnitude = catalogue(1.0, 500, 3)
    events = broken(10.0 * np.arange(500), np.zeros((500, 3)), energy=10.0 ** (1.5 * magnitude + 4.8))
    found = bd.acoustic_emission(events, time=1.0, distance=1.0)
    np.testing.assert_allclose(found.magnitude, magnitude, atol=1e-9)
    assert found.b_value(completeness=-7.0).b == pytest.approx(1.0, abs=3.0 / math.sqrt(500))


REFUSED: dict[str, tuple[str, Callable[[], object]]] = {
    "few emissions": ("9 emissions", lambda: b_value_of(catalogue(1.0, 9, 1), -7.0, 0.1)),
    "few above": ("of magnitude -1.00 or more are too few", lambda: b_value_of(catalogue(1.0, 99, 1), -1.0, 0.1)),
    "one magnitude": ("of one magnitude", lambda: b_value_of(np.full(20, -5.0), -6.0, 0.1)),
    "no width": ("width = 0", lambda: b_value_of(catalogue(1.0, 99, 1), None, 0.0)),
    "a width of nothing": ("too many bins", lambda: b_value_of(catalogue(1.0, 99, 1), None, 1e-9)),
    "no magnitude": ("completeness = nan", lambda: b_value_of(catalogue(1.0, 99, 1), math.nan, 0.1)),
    "nothing known": ("give time=", lambda: bd.acoustic_emission(NOTHING)),
    "half known": ("or model=", lambda: bd.acoustic_emission(NOTHING, time=1.0)),
    "no time": ("time = 0.0 s", lambda: bd.acoustic_emission(NOTHING, time=0.0, distance=1.0)),
    "no events": ("give run.events", lambda: bd.acoustic_emission([1, 2], time=1.0, distance=1.0)),
    "nothing grows": ("advances 0 times", lambda: bd.crack_speed(NOTHING, (0, 0, 0), (1, 0, 0))),
    "no direction": ("direction has no length", lambda: bd.crack_speed(NOTHING, (0, 0, 0), (0, 0, 0))),
    "half a window": ("two times", lambda: bd.crack_speed(NOTHING, (0, 0, 0), (1, 0, 0), between=(1.0,))),
    "no events of a crack": ("give run.events", lambda: bd.crack_speed(None, (0, 0, 0), (1, 0, 0))),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_is_refused_in_one_line(name: str) -> None:
    message, ask = REFUSED[name]
    with pytest.raises(InputError, match=message) as caught:
        ask()
    assert "\n" not in str(caught.value)
