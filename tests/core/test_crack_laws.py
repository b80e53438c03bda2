"""Laws of softening, cracks and yielding on a thousand random states: numbers, lanes, and closed forms."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.core.law_samples import (
    CrackSamples,
    SofteningSamples,
    YieldSamples,
    evaluate_cracks,
    evaluate_softening,
    evaluate_yielding,
    yielding,
)

COUNT = 1003  # no multiple of the lanes
CURVES = {"straight": (0.0, 1.0), "bilinear": (0.25, 0.4)}


def unit(rng: np.random.Generator, size: int) -> np.ndarray:
    rows = rng.standard_normal((size, COUNT))
    return rows / np.linalg.norm(rows, axis=0)


def rotations(quaternions: np.ndarray) -> Rotation:
    return Rotation.from_quat(quaternions.T, scalar_first=True)


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
    integrity = np.sort(rng.choice([1.0, 0.9, 0.5, 0.1, 1e-3], (3, COUNT)), axis=0)
    tension, last = np.full(COUNT, 3e6), rng.uniform(5e6, 2e7, COUNT)
    friction, cohesion, slip = np.full(COUNT, 0.6), np.full(COUNT, math.inf), np.full(COUNT, math.inf)
    if kind == "brittle":
        last[:] = 0.0
    elif kind == "loose":
        tension[::2] = 0.0
    elif kind == "slipping":
        cohesion[::2], slip[::4] = 4e6, 2e7
    with np.errstate(divide="ignore"):
        alike = np.full(COUNT, float(kind in ("plane", "slipping", "loose")))
        strength = np.array([tension, 1.0 / last, cohesion, 1.0 / slip, friction, alike])
    bent = np.where(rng.random(COUNT) < 0.5, 0.0, rng.uniform(0.0, 4e6, COUNT))
    axes = rotations(unit(rng, 4)).as_matrix().transpose(2, 1, 0).reshape(9, COUNT)
    kink, steep = CURVES[curve]
    slip = np.where(rng.random(COUNT) < 0.5, 0.0, 2e6 * rng.standard_normal((3, COUNT)))
    moved = [slip, rng.uniform(0.0, 0.15, COUNT)]
    given = np.vstack([traction, normal, bent, stress, strength, axes, integrity, np.ones(COUNT), *moved])
    return SofteningSamples(np.ascontiguousarray(given), kink, steep, False, np.empty((5, COUNT)))


@pytest.mark.parametrize("curve", CURVES)
@pytest.mark.parametrize("kind", ["bulk", "brittle", "loose", "plane", "slipping"])
def test_integrities_only_fall_and_lanes_agree(kind, curve):
    samples = softening_samples(kind, curve)
    evaluate_softening(samples)
    integrity, left = samples.given[28:31], samples.left[:3]
    assert (left <= integrity).all()
    assert (left >= 0.0).all()
    fell = (left[0] < integrity[0]).mean()
    assert fell > 0.1
    assert kind == "brittle" or ((left[0] > 0.0) & (left[0] < integrity[0])).mean() > 0.01
    wide = samples._replace(wide=True, left=np.empty((5, COUNT)))
    evaluate_softening(wide)
    np.testing.assert_array_equal(wide.left, samples.left)


def test_what_is_left_along_each_direction_follows_the_curve():
    """s T = t_0 (1 - T / T_l) / (1 - t_0 / T_l) from t_0 = r f_t c_d on, for each direction that has begun."""
    samples = softening_samples("bulk", "straight")
    evaluate_softening(samples)
    traction, normal, bent = samples.given[:3], samples.given[3:6], samples.given[6]
    strength, last = samples.given[13], 1.0 / samples.given[14]
    axes, integrity = samples.given[19:28].reshape(3, 3, COUNT), samples.given[28:31]
    slip, stress = samples.given[32:35], samples.given[7:13][[[0, 3, 4], [3, 1, 5], [4, 5, 2]]]
    pressure = -np.einsum("dak,abk,dbk->dk", axes, stress, axes).min(axis=0)
    slope = np.abs(np.einsum("dak,ak->dk", axes, normal))
    opens = np.maximum(bent - np.maximum(pressure, 0.0), 0.0) / slope.max(axis=0)
    begun = (integrity < 1.0).all(axis=0)  # axes that are whole turn first
    for d in range(3):
        slid = np.zeros(COUNT) if d == 0 else np.einsum("ak,ak->k", axes[d], slip)
        pull, bend = np.maximum(np.einsum("ak,ak->k", axes[d], traction) + slid, 0.0), opens * slope[d]
        if d == 0:
            pull = np.hypot(pull, np.linalg.norm(slip, axis=0) / (1.0 - np.where(begun, integrity[0], 0.0)))
        T, both = np.hypot(pull, bend), pull + bend
        with np.errstate(divide="ignore", invalid="ignore"):
            r = T / both
            onset, end = r * strength * np.maximum(slope[d], 0.2), last / r
            curve = np.clip(onset * (1.0 - T / end) / (T * (1.0 - onset / end)), 0.0, integrity[d])
        expected = np.where(onset < T, curve, integrity[d])[begun]
        np.testing.assert_allclose(samples.left[d, begun], np.where(expected < 1e-9, 0.0, expected), atol=2e-9)
    assert begun.mean() > 0.3


def test_grip_goes_with_the_distance_of_the_faces_and_in_rubble_with_the_opening():
    """Both where nothing is left along e_1, and the facet is open along its own normal."""
    normal = np.array([1.0, 0.0, 0.0])
    stress, last = np.diag([3e6, 0.0, -1e6]), 1e7
    opened, apart = np.array([1.5, 3.0, 3.0, 5.0, 5.0, 5.0, 3.0]), np.array([0.0, 0.0, 0.075, 0.0, 0.2, 0.0, 0.0])
    rubble = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.4, 0.5])  # what e_2 and e_3 have of their integrity, 0 for all
    m = len(opened)
    others = np.where(rubble > 0.0, rubble, 1.0)
    rows = [
        np.outer(normal, opened * last), np.outer(normal, np.ones(m)), np.zeros((1, m)),
        np.outer([stress[0, 0], stress[1, 1], stress[2, 2], 0.0, 0.0, 0.0], np.ones(m)),
        np.outer([3e6, 1.0 / last, math.inf, 0.0, 0.0, 0.0], np.ones(m)), np.outer(np.eye(3).ravel(), np.ones(m)),
        [np.zeros(m), others, others, np.ones(m)], np.zeros((3, m)), [apart],
    ]  # fmt: skip
    samples = SofteningSamples(np.ascontiguousarray(np.vstack(rows)), 0.0, 1.0, False, np.empty((5, m)))
    evaluate_softening(samples)
    np.testing.assert_allclose(samples.left[3], [1.0, 1.0, 0.5, 1.0, 0.0, 0.0, 0.5], atol=1e-9)


# ---- cracks

#: Rows of what is given and found of a crack.
BRANCH, H_ROWS, K, LEFT, RUBS, STRESS, SLIP, FRICTION = slice(0, 3), slice(26, 32), 32, slice(38, 42), 42, 43, 45, 48
BEFORE, PAST = slice(49, 53), slice(53, 57)
FOUND = 28
FORCE, ON_I, ON_J, ROOTS, BENDING, ACROSS, SWELLING = slice(0, 3), slice(3, 6), slice(6, 9), slice(15, 18), 18, 22, 26
CRACKED = 24


def crack_samples() -> CrackSamples:
    """Cracks that are open, closed and sliding, of any axes and integrity, and turned."""
    rng = np.random.default_rng(2)
    normal, k, area = unit(rng, 3), np.full(COUNT, 1e9), 1e-6
    lever_i = 0.5e-3 * normal + 1e-4 * rng.standard_normal((3, COUNT))
    lever_j = -0.5e-3 * normal + 1e-4 * rng.standard_normal((3, COUNT))
    w, s = rng.uniform(0.3, 0.7, COUNT), np.sort(rng.choice([1.0, 0.7, 0.2, 0.0], (3, COUNT)), axis=0)
    grip = rng.choice([1.0, 0.6, 0.0], COUNT)
    share_i, share_j = area * w * (normal + 0.1 * unit(rng, 3)), area * (1.0 - w) * (normal + 0.1 * unit(rng, 3))
    gap = 1e-6 * (rng.standard_normal((3, COUNT)) + rng.choice([-2.0, 0.0, 2.0], COUNT) * normal)
    p, q = np.array([[1.0], [0], [0], [0]]), np.array([[1.0], [0], [0], [0]])
    p, q = p + 0.1 * rng.standard_normal((4, COUNT)), q + 0.1 * rng.standard_normal((4, COUNT))
    p, q = p / np.linalg.norm(p, axis=0), q / np.linalg.norm(q, axis=0)
    turned = (rotations(p).apply(lever_i.T) - rotations(q).apply(lever_j.T)).T
    half = rng.standard_normal((3, 3, COUNT)) * 1e-2
    H = np.einsum("abk,cbk->ack", half, half)
    H = np.array([H[0, 0], H[1, 1], H[2, 2], H[0, 1], H[0, 2], H[1, 2]])
    stress = 3e8 * rng.standard_normal((2, COUNT))
    before = np.minimum(np.vstack([s, grip]) + rng.choice([0.0, 0.05], (4, COUNT)), 1.0)
    rest = [
        1e-6 * rng.standard_normal((3, COUNT)), rng.choice([0.0, 0.5], (1, COUNT)), before,
        rng.uniform(0.0, 1e-3, (4, COUNT)), rng.standard_normal((3, COUNT)),
    ]  # fmt: skip
    given = np.vstack([
        gap + turned, p, q, lever_i, lever_j, share_i, share_j, normal, H, k, w, unit(rng, 4), s, grip,
        (grip == 0.0).astype(float), stress, *rest,
    ])  # fmt: skip
    return CrackSamples(np.ascontiguousarray(given), False, np.empty((FOUND, COUNT)))


def given_gap(samples: CrackSamples) -> np.ndarray:
    """Gaps of the faces in space, (COUNT, 3)."""
    branch, lever_i, lever_j = (samples.given[a : a + 3].T for a in (0, 11, 14))
    p, q = rotations(samples.given[3:7]), rotations(samples.given[7:11])
    return branch - p.apply(lever_i) + q.apply(lever_j)


def evaluated(samples: CrackSamples, **changed) -> np.ndarray:
    """What is found with some rows changed."""
    given = samples.given.copy()
    for row, values in changed.values():
        given[row] += values
    now = CrackSamples(given, False, np.empty((FOUND, COUNT)))
    evaluate_cracks(now)
    return now.found


def potential(found: np.ndarray, samples: CrackSamples) -> np.ndarray:
    """Energy of cracks and σ V θ of their cells: a function of gaps and stresses whose gradient is the force."""
    stress = samples.given[STRESS : STRESS + 2]
    return found[ACROSS] + found[ACROSS + 1] + (stress * found[SWELLING:]).sum(axis=0)


def test_lanes_of_cracks_agree():
    samples = crack_samples()
    evaluate_cracks(samples)
    wide = samples._replace(wide=True, found=np.empty((FOUND, COUNT)))
    evaluate_cracks(wide)
    np.testing.assert_array_equal(wide.found, samples.found)


def test_the_force_of_a_crack_is_the_gradient_of_its_energy():
    """By central differences of the gap, at cracks without friction that no half closes or opens in between."""
    samples = crack_samples()
    samples.given[FRICTION] = 0.0
    force, step = evaluated(samples)[FORCE], 1e-11
    for axis in range(3):
        ahead, behind = (potential(evaluated(samples, gap=(axis, sign * step)), samples) for sign in (1.0, -1.0))
        slope = (ahead - behind) / (2.0 * step)
        np.testing.assert_allclose(slope, force[axis], atol=2e-4 * np.abs(force).max())


def test_what_a_crack_releases_is_the_slope_of_its_energy():
    """-∂U/∂s of each integrity and of the grip from the roots, by a difference of each; both halves pull or press."""
    samples = crack_samples()
    samples.given[FRICTION] = 0.0
    samples.given[STRESS : STRESS + 2] *= 1e-4
    found, (*s, grip) = evaluated(samples), samples.given[LEFT]
    pull, press = (np.maximum(sign * found[ROOTS], 0.0) ** 2 for sign in (1.0, -1.0))
    released = [pull[0], grip * pull[1], grip * pull[2], (s[1:] * pull[1:] + press[1:]).sum(axis=0)]
    before, step = potential(found, samples), 1e-7
    inside = samples.given[LEFT] < 1.0
    for d in range(4):
        after = potential(evaluated(samples, left=(LEFT.start + d, step * inside[d])), samples)
        # σ V θ takes part: at fixed gap and stress the slope is that of W, and W rises with what is left
        slope = ((after - before) / step)[inside[d]]
        np.testing.assert_allclose(slope, released[d][inside[d]], atol=2e-5 * np.abs(released).max())


def test_the_work_on_a_crack_is_its_energy_and_its_dissipation():
    """By the trapezoidal rule, over steps that open it or close it and lower any integrity, also where it is bent."""
    rng = np.random.default_rng(7)
    before = crack_samples()
    before.given[[RUBS, FRICTION, STRESS, STRESS + 1]] = before.given[SLIP : SLIP + 3] = 0.0
    found = evaluated(before)
    after = before._replace(given=before.given.copy(), found=np.empty((FOUND, COUNT)))
    after.given[BEFORE] = before.given[LEFT]
    after.given[LEFT] *= rng.choice([1.0, 0.9, 0.3, 0.0], (4, COUNT))
    after.given[PAST] = [*found[ROOTS], np.sqrt(found[BENDING])]
    axes = (rotations(before.given[3:7]) * rotations(before.given[34:38])).as_matrix()
    gap = np.einsum("kab,ka->kb", axes, given_gap(before))
    moved = np.einsum("kab,kb->ka", axes, rng.uniform(-0.5, 1.0, (COUNT, 3)) * gap).T
    after.given[BRANCH] += moved
    evaluate_cracks(after)
    work = 0.5 * ((found[FORCE] + after.found[FORCE]) * moved).sum(axis=0)
    stored = [
        of.found[ACROSS] + of.found[ACROSS + 1] + of.given[LEFT][:3].min(axis=0) * of.found[BENDING]
        for of in (before._replace(found=found), after)
    ]
    lost = after.found[CRACKED]
    np.testing.assert_allclose(stored[1] - stored[0] + lost, work, atol=1e-10 * np.abs(work).max())
    assert (lost > 1e-3 * np.abs(work).max()).mean() > 0.3


def test_bending_below_zero_by_rounding_dissipates_nothing():
    samples = crack_samples()
    samples.given[H_ROWS] *= -1e-20
    found = evaluated(samples)
    assert (found[BENDING] < 0.0).mean() > 0.9
    assert np.isfinite(found).all()


def test_torques_of_a_crack_balance_its_force():
    """δ × f and all torques but those of the levers add up to zero: no angular momentum comes from a crack."""
    samples = crack_samples()
    found = evaluated(samples)
    f, on_i, on_j = found[FORCE].T, found[ON_I].T, found[ON_J].T
    moment = np.cross(samples.given[BRANCH].T, -f) + on_i + on_j
    np.testing.assert_allclose(moment, 0.0, atol=1e-12 * np.abs(on_i).max())


def test_a_crack_that_has_lost_all_presses_along_its_normal_only():
    samples = crack_samples()
    samples.given[LEFT] = 0.0
    samples.given[RUBS], samples.given[FRICTION] = 1.0, 0.0
    axes = (rotations(samples.given[3:7]) * rotations(samples.given[34:38])).as_matrix()[:, :, 0]
    force = evaluated(samples)[FORCE].T
    along = (force * axes).sum(axis=1)
    np.testing.assert_allclose(force, along[:, None] * axes, atol=1e-12 * np.abs(force).max())
    assert (along <= 0.0).all()
    assert 0.2 < (along < 0.0).mean() < 0.8


def test_bending_is_that_of_the_cell_law():
    """2 v·H v, with v the vector of the quaternion by which one cell is turned from the other."""
    samples = crack_samples()
    p, q, H = samples.given[3:7], samples.given[7:11], samples.given[H_ROWS]
    v = (rotations(p).inv() * rotations(q)).as_quat()[:, :3]
    square = 2.0 * np.einsum("ka,kab,kb->k", v, matrices(H), v)
    np.testing.assert_allclose(evaluated(samples)[BENDING], square, rtol=1e-10)


# ---- yielding


def matrices(tensors: np.ndarray) -> np.ndarray:
    """Matrices of symmetric tensors xx, yy, zz, xy, xz, yz, (m, 3, 3)."""
    return tensors[[[0, 3, 4], [3, 1, 5], [4, 5, 2]]].transpose(2, 0, 1)


def yielding_cells() -> tuple[np.ndarray, np.ndarray]:
    """Stresses, of which every fifth has two alike, and strengths."""
    rng = np.random.default_rng(3)
    stress = 1e7 * rng.standard_normal((6, COUNT))
    stress[:3] -= 2e7 * rng.random(COUNT)
    stress[3:, ::5] = 0.0
    stress[0, ::5] = stress[1, ::5]
    strength = np.array([
        rng.choice([0.0, 5e6, 2e7], COUNT), np.full(COUNT, 0.2), np.full(COUNT, 0.1), np.full(COUNT, 1e10),
        rng.choice([0.0, 1e-4, 1e-3], COUNT),
    ])  # fmt: skip
    return stress, strength


def slip_of(
    F: np.ndarray, most: np.ndarray, stiffness: np.ndarray, held: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Δγ and what is held of it, with z = 0.8, where slip takes at most `most`."""
    gamma = np.clip(held + (0.36 + 0.04) * F / stiffness, 0.0, most)
    return gamma, np.where(gamma > 0.0, np.maximum(gamma - 0.36 * F / stiffness, 0.0), 0.0)


def assert_step(
    found: np.ndarray, gamma: np.ndarray, held: np.ndarray, strain: np.ndarray, principal: np.ndarray
) -> None:
    np.testing.assert_allclose(found[1], gamma, rtol=1e-9, atol=1e-16)
    np.testing.assert_allclose(found[2], held, rtol=1e-9, atol=1e-16)
    assert (np.abs(matrices(found[3:9]) - strain).max(axis=(1, 2)) <= 1e-9 * gamma).all()
    np.testing.assert_allclose(np.sort(found[9:12].T), principal, rtol=1e-12, atol=1e-6)
    assert 0.1 < (found[1] > 0.0).mean() < 0.9


def test_a_step_of_slip():
    """Δε = ½ Δγ [(1 + sin ψ) e1⊗e1 - (1 - sin ψ) e3⊗e3], at most half of the shear there is."""
    stress, strength = yielding_cells()
    cohesion, slope, dilation, stiffness, before = strength
    found = yielding(stress, strength, cone=False)
    principal, direction = np.linalg.eigh(matrices(stress))
    low, high, third, first = principal[:, 0], principal[:, 2], direction[:, :, 0], direction[:, :, 2]
    F = 0.5 * (high - low) + 0.5 * (high + low) * slope - cohesion
    gamma, held = slip_of(F, 0.25 * (high - low) / stiffness, stiffness, before)
    up, down = 0.5 * gamma * (1.0 + dilation), 0.5 * gamma * (1.0 - dilation)
    strain = up[:, None, None] * first[:, :, None] * first[:, None, :]
    strain -= down[:, None, None] * third[:, :, None] * third[:, None, :]
    # where two principal stresses are alike, the strain has its principal values and the axes of the stress
    alike = np.arange(0, COUNT, 5)
    given = matrices(found[3:9])[alike]
    np.testing.assert_allclose(
        np.linalg.eigvalsh(given), np.linalg.eigvalsh(strain[alike]), rtol=1e-9, atol=1e-9 * gamma.max()
    )
    commuting = given @ matrices(stress)[alike] - matrices(stress)[alike] @ given
    np.testing.assert_allclose(commuting, 0.0, atol=1e-9 * gamma.max() * np.abs(stress).max())
    strain[alike] = given
    assert_step(found, gamma, held, strain, principal)
    mean = principal.mean(axis=1)
    deviator = np.sqrt(0.5 * ((principal - mean[:, None]) ** 2).sum(axis=1))
    bound = deviator + slope * (mean + deviator / math.sqrt(3.0)) - cohesion
    np.testing.assert_allclose(found[0], bound, rtol=1e-12, atol=1e-3)
    np.testing.assert_allclose(found[12], F + cohesion, rtol=1e-12, atol=1e-3)


def test_a_step_on_the_cone():
    """Δε = Δγ [s / 2√J2 + β 1] for compressive mean stress, at most the shear there is."""
    stress, strength = yielding_cells()
    cohesion, slope, dilation, stiffness, before = strength
    found = yielding(stress, strength, cone=True)
    full = matrices(stress)
    mean, one = np.trace(full, axis1=1, axis2=2) / 3.0, np.eye(3)
    s = full - mean[:, None, None] * one
    deviator = np.sqrt(0.5 * (s**2).sum(axis=(1, 2)))
    F = deviator + 3.0 * slope * mean - cohesion
    gamma, held = slip_of(F, np.where(mean > 0.0, 0.0, deviator / stiffness), stiffness, before)
    strain = gamma[:, None, None] * (s / (2.0 * deviator[:, None, None]) + dilation[:, None, None] * one)
    assert_step(found, gamma, held, strain, np.linalg.eigvalsh(full))
    np.testing.assert_allclose(found[12], np.where(mean > 0.0, 0.0, F + cohesion), rtol=1e-12, atol=1e-3)


@pytest.mark.parametrize("cone", [False, True], ids=["mohr-coulomb", "drucker-prager"])
def test_lanes_yield_as_single_cells(cone):
    one, several = (YieldSamples(*yielding_cells(), cone, wide, np.empty((13, COUNT))) for wide in (False, True))
    evaluate_yielding(one)
    evaluate_yielding(several)
    np.testing.assert_array_equal(several.found, one.found)
