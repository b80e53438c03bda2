"""Laws of softening, cracks and yielding on a thousand random states: numbers, lanes, and closed forms."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.core.former_loop import FormerLoop
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


@pytest.mark.parametrize("curve", CURVES)
@pytest.mark.parametrize("kind", ["bulk", "brittle", "loose", "plane", "slipping"])
def test_the_integrity_that_loads_leave(kind, curve):
    samples, former = softening_samples(kind, curve), FormerLoop("crack_laws", f"{kind}, {curve}")
    evaluate_softening(samples)
    former.assert_close(1e-11, left=samples.left[0], least=samples.left[1])
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
    turned = (rotations(p).apply(lever_i.T) - rotations(q).apply(lever_j.T)).T
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


#: What is found of a crack, and its first row.
CRACK_ROWS = {
    "force": 0, "torques": 3, "friction": 9, "slip": 12, "rates": 15, "torque of bending": 17, "across": 20,
    "along": 21, "cracked": 22, "rubbed away": 23, "swelling": 24,
}  # fmt: skip


def test_what_cracks_carry_store_and_dissipate():
    samples, former = crack_samples(), FormerLoop("crack_laws", "cracks")
    evaluate_cracks(samples)
    parts = np.split(samples.found, [*CRACK_ROWS.values()][1:])
    former.assert_close(1e-11, **dict(zip(CRACK_ROWS, parts, strict=True)))
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


def test_bending_is_that_of_the_cell_law():
    """2 v·H v, with v the vector of the quaternion by which one cell is turned from the other."""
    samples = crack_samples()
    evaluate_cracks(samples)
    p, q, H = samples.given[3:7], samples.given[7:11], samples.given[26:32]
    v = (rotations(p).inv() * rotations(q)).as_quat()[:, :3]
    square = 2.0 * np.einsum("ka,kab,kb->k", v, matrices(H), v)
    np.testing.assert_allclose(samples.found[16], square, rtol=1e-10)


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
    np.testing.assert_allclose(np.sort(found[9:].T), principal, rtol=1e-12, atol=1e-6)
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


@pytest.mark.parametrize("cone", [False, True], ids=["mohr-coulomb", "drucker-prager"])
def test_lanes_yield_as_single_cells(cone):
    one, several = (YieldSamples(*yielding_cells(), cone, wide, np.empty((12, COUNT))) for wide in (False, True))
    evaluate_yielding(one)
    evaluate_yielding(several)
    np.testing.assert_array_equal(several.found, one.found)
