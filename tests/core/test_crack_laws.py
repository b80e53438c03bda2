"""Laws of softening, cracks and yielding on a thousand random states: by numbers, by lanes, by plain functions."""

import itertools
import math
from typing import NamedTuple

import numpy as np
import pytest

from bondem._core import Pass
from bondem.kernels import crack_energy as energies
from bondem.kernels import cracking
from bondem.laws import plasticity, softening
from bondem.laws.cell_energy import bending_square, cross, opened, scalar, turned_by


class SofteningSamples(NamedTuple):
    traction: np.ndarray
    normal: np.ndarray
    stress: np.ndarray
    bent: np.ndarray
    integrity: np.ndarray
    strength: np.ndarray
    kink: float
    steep: float
    wide: bool
    left: np.ndarray


class CrackSamples(NamedTuple):
    given: np.ndarray
    wide: bool
    found: np.ndarray


class YieldSamples(NamedTuple):
    stress: np.ndarray
    strength: np.ndarray
    cone: bool
    wide: bool
    found: np.ndarray


evaluate_softening = Pass("evaluate_softening", SofteningSamples)
evaluate_cracks = Pass("evaluate_cracks", CrackSamples)
evaluate_yielding = Pass("evaluate_yielding", YieldSamples)

COUNT = 1003  # no multiple of the lanes
CURVES = {"straight": (0.0, 1.0), "bilinear": (0.25, 0.4)}


def unit(rng: np.random.Generator, size: int) -> np.ndarray:
    rows = rng.standard_normal((size, COUNT))
    return rows / np.linalg.norm(rows, axis=0)


def tuples(rows: np.ndarray, k: int) -> tuple[float, ...]:
    return tuple(rows[:, k].tolist())


# ---- softening


def softening_samples(kind: str, curve: str) -> SofteningSamples:
    """Facets near their strength: loaded, unloaded and turned; whole, softening, all but broken."""
    rng = np.random.default_rng(1)
    normal, stress = unit(rng, 3), 4e6 * rng.standard_normal((6, COUNT))
    stress[:, ::7] *= [[1.0], [1.0], [1.0], [0.0], [0.0], [0.0]]  # along the axes
    stress[:3, ::5] -= 6e6
    tensor = stress[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]]
    traction = np.einsum("abk,bk->ak", tensor, normal) * rng.uniform(0.3, 2.0, COUNT)
    traction += 1e6 * rng.standard_normal((3, COUNT))
    integrity = rng.choice([1.0, 0.9, 0.5, 0.1, 1e-3], COUNT)
    tension, last = np.full(COUNT, 3e6), rng.uniform(5e6, 2e7, COUNT)
    friction, cohesion, slip = np.full(COUNT, 0.6), np.full(COUNT, math.inf), np.full(COUNT, math.inf)
    if kind == "brittle":
        last[:] = 0.0
    elif kind == "loose":
        tension[::2] = 0.0
    elif kind == "slipping":
        cohesion[::2], slip[::4] = 4e6, 2e7
    with np.errstate(divide="ignore"):
        on_plane = np.full(COUNT, float(kind in ("plane", "slipping")))
        strength = np.array([tension, 1.0 / last, cohesion, 1.0 / slip, friction, on_plane])
    bent = np.where(rng.random(COUNT) < 0.5, 0.0, rng.uniform(0.0, 4e6, COUNT))
    kink, steep = CURVES[curve]
    return SofteningSamples(
        traction, normal, stress, bent, integrity, strength, kink, steep, False, np.empty((2, COUNT))
    )


def left_by_python(s: SofteningSamples, k: int) -> tuple[float, float]:
    t, n, stress = tuples(s.traction, k), tuples(s.normal, k), tuples(s.stress, k)
    bent, left = s.bent[k], s.integrity[k]
    tension, brittle, cohesion, slip, friction, plane = tuples(s.strength, k)
    last, last_slip = (1.0 / one if one > 0.0 else math.inf for one in (brittle, slip))
    least = math.inf
    if plane:
        slips = cohesion / math.sqrt(1.0 + friction * friction)
        least = min(tension, slips) if left == 1.0 or last > 0.0 else 0.0
    else:
        least = softening.softens_at(left, 0.7 * softening.LEAST_SLOPE * tension, last, s.kink, s.steep)
    if last == 0.0 and left < 1.0:
        return 0.0, least
    if tension == 0.0:
        opening, _ = softening.opening_force(t, n)
        size = math.sqrt(scalar(opening, opening) + bent * bent)
        return softening.softened(left, size, 0.0, last, s.kink, s.steep), least
    if plane:
        return softening.left_on_plane(
            left, t, n, bent, tension, last, cohesion, last_slip, friction, s.kink, s.steep
        ), least  # fmt: skip
    b = max(bent - plasticity.largest_pressure(stress), 0.0)
    a, v = np.empty((3, 3)), np.empty((3, 3))
    plasticity.principal(stress, a, v)
    return softening.left_in_bulk(left, t, n, b, a, v, tension, last, s.kink, s.steep), least


@pytest.mark.parametrize("curve", CURVES)
@pytest.mark.parametrize("kind", ["bulk", "brittle", "loose", "plane", "slipping"])
def test_the_integrity_that_loads_leave(kind, curve):
    samples = softening_samples(kind, curve)
    evaluate_softening(samples)
    with np.errstate(over="ignore"):
        expected = np.array([left_by_python(samples, k) for k in range(COUNT)]).T
    np.testing.assert_allclose(samples.left, expected, rtol=1e-9, atol=1e-11)
    fell = (samples.left[0] < samples.integrity).mean()
    assert fell > 0.1
    assert kind == "brittle" or ((samples.left[0] > 0.0) & (samples.left[0] < samples.integrity)).mean() > 0.03
    wide = samples._replace(wide=True, left=np.empty((2, COUNT)))
    evaluate_softening(wide)
    np.testing.assert_array_equal(wide.left, samples.left)


def test_a_facet_keeps_its_integrity_below_the_traction_that_softens_none():
    samples = softening_samples("bulk", "bilinear")
    evaluate_softening(samples)
    size = np.sqrt((samples.traction**2).sum(axis=0) + samples.bent**2)
    samples.traction[:] *= 0.999 * samples.left[1] / size
    samples.bent[:] *= 0.999 * samples.left[1] / size
    evaluate_softening(samples)
    np.testing.assert_array_equal(samples.left[0], samples.integrity)


# ---- cracks


def crack_samples() -> CrackSamples:
    """Cracks that are open, closed and sliding, of any integrity and turned."""
    rng = np.random.default_rng(2)
    normal, k, area = unit(rng, 3), np.full(COUNT, 1e9), 1e-6
    lever_i = 0.5e-3 * normal + 1e-4 * rng.standard_normal((3, COUNT))
    lever_j = -0.5e-3 * normal + 1e-4 * rng.standard_normal((3, COUNT))
    w, s = rng.uniform(0.3, 0.7, COUNT), rng.choice([1.0, 0.7, 0.2, 0.0], COUNT)
    share_i, share_j = area * w * (normal + 0.1 * unit(rng, 3)), area * (1.0 - w) * (normal + 0.1 * unit(rng, 3))
    gap = 1e-6 * (rng.standard_normal((3, COUNT)) + rng.choice([-2.0, 0.0, 2.0], COUNT) * normal)
    p, q = np.array([[1.0], [0], [0], [0]]), np.array([[1.0], [0], [0], [0]])
    p, q = p + 0.1 * rng.standard_normal((4, COUNT)), q + 0.1 * rng.standard_normal((4, COUNT))
    p, q = p / np.linalg.norm(p, axis=0), q / np.linalg.norm(q, axis=0)
    turned = np.array([
        np.subtract(turned_by(tuples(p, c), tuples(lever_i, c)), turned_by(tuples(q, c), tuples(lever_j, c)))
        for c in range(COUNT)
    ]).T  # fmt: skip
    half = rng.standard_normal((3, 3, COUNT)) * 1e-2
    H = np.einsum("abk,cbk->ack", half, half)
    H = np.array([H[0, 0], H[1, 1], H[2, 2], H[0, 1], H[0, 2], H[1, 2]])
    stress = 3e8 * rng.standard_normal((2, COUNT))
    before = np.minimum(s + rng.choice([0.0, 0.05], COUNT), 1.0)
    rest = [
        1e-6 * rng.standard_normal((3, COUNT)), rng.choice([0.0, 0.5], (1, COUNT)), before[None],
        rng.uniform(0.0, 1e-3, (1, COUNT)), rng.standard_normal((3, COUNT)),
    ]  # fmt: skip
    given = np.vstack([gap + turned, p, q, lever_i, lever_j, share_i, share_j, normal, H, k, w, s, stress, *rest])
    return CrackSamples(np.ascontiguousarray(given), False, np.empty((26, COUNT)))


def crack_by_python(x: list[float]) -> list[float]:
    three = lambda first: tuple(x[first : first + 3])  # noqa: E731
    d, p, q, H = three(0), tuple(x[3:7]), tuple(x[7:11]), tuple(x[26:32])
    K, w, s, stress_i, stress_j, slip, mu = x[32], x[33], x[34], x[35], x[36], three(37), x[40]
    before, rate_before, rub_before = x[41], x[42], three(43)
    arm_i, arm_j = turned_by(p, three(11)), turned_by(q, three(14))
    gi, gj, own = turned_by(p, three(17)), turned_by(q, three(20)), three(23)
    gap, n = opened(d, arm_i, arm_j), np.add(turned_by(p, own), turned_by(q, own))
    n = tuple((n / np.linalg.norm(n)).tolist())
    (one, press_i), (other, press_j) = energies.halves.py_func(K, w, gap, n, (gi, gj), (stress_i, stress_j))
    along = w * press_i + (1.0 - w) * press_j
    rub, now = softening.rubbed(K, s, gap, n, slip, -mu * (1.0 - s) * along)
    f = np.add(rub, s * w * np.array(one) + s * (1.0 - w) * np.array(other) + along * np.array(n))
    f = tuple(f.tolist())
    ci = cracking._half_couple(K, w, s, gap, gi, stress_i, one)
    cj = cracking._half_couple(K, 1.0 - w, s, gap, gj, stress_j, other)
    ni, nj = cracking._normal_couples(softening.crack_couple(gap, f, ci, cj), cross(now, rub), p, own, n)
    bent, h = energies.bending.py_func(p, q, H)
    on_i, on_j = np.add(cross(arm_i, f), np.add(ci, ni)), np.add(cross(f, arm_j), np.add(cj, nj))
    rate = 0.5 / K * (w * scalar(one, one) + (1.0 - w) * scalar(other, other))
    across, shear = energies.crack_energy.py_func(K, w, s, gap, n, (one, other), rub)
    rows, outputs = np.zeros((1, 13)), np.zeros((1, 8))
    rows[0, cracking.BEFORE], rows[0, cracking.RATE] = before, rate_before
    rows[0, cracking.RUB : cracking.RUB + 3] = rub_before
    cracking._book(rows, outputs, 0, K, s, rate + bent, rub, tuple(np.subtract(now, slip).tolist()))
    swollen = [
        scalar(g, gap) - (1.0 - s) * scalar(g, opening) / K for g, opening in ((gi, one), (gj, other))
    ]  # fmt: skip
    return [
        *f, *on_i, *on_j, *rub, *now, rate, bent, *h, across, shear, outputs[0, cracking.LOST],
        outputs[0, cracking.RUBBED_AWAY], *swollen,
    ]  # fmt: skip


def test_what_cracks_bear_store_and_dissipate():
    samples = crack_samples()
    evaluate_cracks(samples)
    with np.errstate(all="ignore"):
        expected = np.array([crack_by_python(samples.given[:, k].tolist()) for k in range(COUNT)]).T
    ends = 0, 3, 9, 12, 15, 17, 20, 22, 23, 24, 26
    for first, last in itertools.pairwise(ends):
        a, b = samples.found[first:last], expected[first:last]
        np.testing.assert_allclose(a, b, rtol=1e-9, atol=1e-11 * np.abs(b).max())
    wide = samples._replace(wide=True, found=np.empty((26, COUNT)))
    evaluate_cracks(wide)
    np.testing.assert_array_equal(wide.found, samples.found)


def test_torques_of_a_crack_balance_its_force():
    """δ × f and all torques but those of the levers add up to zero: no angular momentum comes from a crack."""
    samples = crack_samples()
    evaluate_cracks(samples)
    f, on_i, on_j = samples.found[:3].T, samples.found[3:6].T, samples.found[6:9].T
    moment = np.cross(samples.given[:3].T, -f) + on_i + on_j
    np.testing.assert_allclose(moment, 0.0, atol=1e-12 * np.abs(on_i).max())


# ---- yielding


@pytest.mark.parametrize("cone", [False, True], ids=["mohr-coulomb", "drucker-prager"])
def test_a_step_of_plastic_strain(cone):
    rng = np.random.default_rng(3)
    stress = 1e7 * rng.standard_normal((6, COUNT))
    stress[:3] -= 2e7 * rng.random(COUNT)
    stress[3:, ::5] = 0.0
    stress[0, ::5] = stress[1, ::5]
    strength = np.array([
        rng.choice([0.0, 5e6, 2e7], COUNT), np.full(COUNT, 0.2), np.full(COUNT, 0.1), np.full(COUNT, 1e10)
    ])  # fmt: skip
    samples = YieldSamples(stress, strength, cone, False, np.empty((11, COUNT)))
    evaluate_yielding(samples)
    a, v = np.empty((3, 3)), np.empty((3, 3))
    for k in range(COUNT):
        s, (cohesion, slope, dilation, G) = tuples(stress, k), tuples(strength, k)
        mean, deviator = plasticity.invariants(s)
        with np.errstate(over="ignore"):
            high, low, one, three = plasticity.principal(s, a, v)
        if cone:
            gamma = plasticity.cone_flow(mean, deviator, slope, cohesion, G)
            sizes = [gamma * (0.5 * (a[d, d] - mean) / deviator + dilation) for d in range(3)]
            strain = sum(size * np.outer(v[:, d], v[:, d]) for d, size in enumerate(sizes))
        else:
            gamma = plasticity.flow(high, low, slope, cohesion, G)
            up, down = 0.5 * gamma * (1.0 + dilation), -0.5 * gamma * (1.0 - dilation)
            strain = up * np.outer(v[:, one], v[:, one]) + down * np.outer(v[:, three], v[:, three])
            bound = plasticity.yield_bound(mean, deviator, slope, cohesion)
            assert samples.found[0, k] == pytest.approx(bound, rel=1e-12, abs=1e-3)
        assert samples.found[1, k] == pytest.approx(gamma, rel=1e-9, abs=1e-16)
        found = samples.found[2:8, k]
        expected = strain[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * gamma)
        np.testing.assert_allclose(np.sort(samples.found[8:, k]), np.sort(np.diag(a)), rtol=1e-12, atol=1e-6)
    assert 0.1 < (samples.found[1] > 0.0).mean() < 0.9
    wide = samples._replace(wide=True, found=np.empty((11, COUNT)))
    evaluate_yielding(wide)
    np.testing.assert_array_equal(wide.found, samples.found)


def test_bending_is_that_of_the_cell_law():
    samples = crack_samples()
    evaluate_cracks(samples)
    for k in range(50):
        x = samples.given[:, k]
        square = bending_square(tuple(x[3:7]), tuple(x[7:11]), 2.0, tuple(x[26:32]))
        assert samples.found[16, k] == pytest.approx(square, rel=1e-10)
