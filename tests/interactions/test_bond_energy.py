"""The bond energy: its gradient, its second derivative at rest, its invariances and its parts.

U = ½ kn (ℓ - L)² + ½ A (1 - c1²) + B (X1·X2 - c1 c2) + ½ C (1 - c2²) + 2 kt (1 - w²)
"""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem._tables.step_tables import Beams
from bondem.interactions.beams.beam_tables import beam_energies, beam_tables, count_turned, loads_of_each
from tests.beam_theory import beam_stiffness
from tests.recording import Record

E, NU = 3.0e6, 0.27

LAWS = {
    "EulerBernoulli": bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.6),
    "EulerBernoulli, nu < 0": bd.EulerBernoulli(E=E, nu=-0.4, radius_ratio=0.6, radius_rule="pair_mean"),
    "Timoshenko": bd.Timoshenko(E=E, nu=NU, radius_ratio=0.7, radius_rule="pair_min"),
    "ParallelBond": bd.ParallelBond(E=E, nu=NU, radius_ratio=0.8, radius_rule="pair_min"),
    "ParallelBond, kt > kb": bd.ParallelBond(E=E, nu=NU, radius_ratio=0.8, kappa=0.9),
    "Obermayr": bd.Obermayr(E=E, nu=NU, radius_ratio=0.6, alpha_s=0.8),
    "ContactBond": bd.ContactBond(E=E, nu=NU, radius_ratio=0.6),
}
every_law = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())


def cluster(count: int = 9, seed: int = 4) -> bd.Lattice:
    """Elements of very unequal radii in no order, each bonded to some others, in both directions."""
    rng = np.random.default_rng(seed)
    radius = rng.uniform(0.25, 1.0, count)
    position = [np.zeros(3)]
    pairs = []
    for k in range(1, count):
        host = int(rng.integers(max(0, k - 3), k))
        while True:
            way = rng.standard_normal(3)
            centre = position[host] + way / np.linalg.norm(way) * (radius[host] + radius[k]) * 1.05
            gap = np.linalg.norm(centre - np.array(position), axis=1) - radius[k] - radius[:k]
            if gap.min() > 0.0:
                break
        position.append(centre)
        pairs.append((host, k) if k % 2 else (k, host))
    for k in range(2, count, 3):
        if (k, k - 2) not in pairs and (k - 2, k) not in pairs:
            pairs.append((k, k - 2))
    return bd.Lattice(bd.Particles(np.array(position), radius), np.array(pairs))


def moved(model: bd.Model, shift: float, degrees: float, seed: int = 0) -> bd.State:
    """A state with every centre displaced by up to `shift` and every element turned by up to `degrees`."""
    rng = np.random.default_rng(seed)
    n = len(model.lattice.particles)
    turn = rng.standard_normal((n, 3))
    turn *= math.radians(degrees) * rng.uniform(0.3, 1.0, (n, 1)) / np.linalg.norm(turn, axis=1)[:, None]
    position = model.lattice.particles.position + shift * rng.uniform(-1.0, 1.0, (n, 3)) / math.sqrt(3.0)
    state = model.state()
    state.set_pose(position=position, orientation=Rotation.from_rotvec(turn).as_quat(scalar_first=True))
    return state


def beams(model: bd.Model, integrity: np.ndarray) -> Beams:
    """Beams of a model as the core takes them."""
    return beam_tables(model.bonds, model.layout, model.period, integrity, may_share=False)[0]


def energies(model: bd.Model, pose: np.ndarray) -> np.ndarray:
    """Normal, shear, bending and twisting energy of each bond, (4, m)."""
    return np.transpose([beam_energies(pose, beams(model, only)) for only in np.eye(len(model.layout.i))])


def bond_forces(model: bd.Model, pose: np.ndarray) -> np.ndarray:
    """Force on j, torque on i and torque on j of each bond, (9, m)."""
    m = len(model.layout.i)
    on_i, on_j = loads_of_each(pose, beams(model, np.ones(m)), m)
    return np.vstack([on_j[:, :3].T, on_i[:, 4:7].T, on_j[:, 4:7].T])


def forces(model: bd.Model, pose: np.ndarray) -> np.ndarray:
    """Force and torque of the bonds on each element, internal order, (6 n,)."""
    output = bond_forces(model, pose)
    total = np.zeros((len(pose), 6))
    np.add.at(total, model.layout.i, np.hstack([-output[:3].T, output[3:6].T]))
    np.add.at(total, model.layout.j, np.hstack([output[:3].T, output[6:].T]))
    return total.ravel()


def nudged(pose: np.ndarray, dof: int, by: float) -> np.ndarray:
    """The pose with one degree of freedom moved: a centre shifted, or an element turned further."""
    other = pose.copy()
    p, d = divmod(dof, 6)
    if d < 3:
        other[p, d] += by
    else:
        turn = Rotation.from_rotvec(by * np.eye(3)[d - 3])
        old = Rotation.from_quat(pose[p, 4:], scalar_first=True)
        other[p, 4:] = (turn * old).as_quat(scalar_first=True)
    return other


def derivative(function, pose: np.ndarray, dof: int, step: float = 2e-3):
    """Sixth-order central difference."""
    weights = {1: 45.0, 2: -9.0, 3: 1.0}
    total = sum(
        w * (function(nudged(pose, dof, k * step)) - function(nudged(pose, dof, -k * step)))
        for k, w in weights.items()
    )
    return total / (60.0 * step)


@every_law
def test_force_is_the_gradient_of_the_energy(law: bd.BondLaw, record: Record) -> None:
    model = bd.Model(cluster(), bond=law, density=1000.0)
    pose = moved(model, shift=0.12, degrees=20.0).pose
    expected = [-derivative(lambda x: energies(model, x).sum(), pose, dof) for dof in range(6 * len(pose))]
    actual = forces(model, pose)
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=1e-8 * np.abs(actual).max())
    record("gradient", np.abs(actual - expected).max() / np.abs(actual).max())


@every_law
def test_energy_is_the_formula_and_its_parts_are_not_negative(law: bd.BondLaw) -> None:
    model = bd.Model(cluster(), bond=law, density=1000.0)
    state = moved(model, shift=0.12, degrees=20.0, seed=3)
    parts = energies(model, state.pose)

    lattice, k = model.lattice, model.stiffness
    i, j = lattice.pairs.T
    d = state.position[j] - state.position[i]
    l = np.linalg.norm(d, axis=1)
    L = lattice.length
    X0 = lattice.branch / L[:, None]
    turn = Rotation.from_quat(state.orientation, scalar_first=True)
    X, X1, X2 = d / l[:, None], turn[i].apply(X0.copy()), turn[j].apply(X0.copy())
    c1, c2, c12 = (X * X1).sum(axis=1), (X * X2).sum(axis=1), (X1 * X2).sum(axis=1)
    w = (state.orientation[i] * state.orientation[j]).sum(axis=1)
    a, extra = k.lever, k.kb - k.kt
    b = L - a
    A, B, C = k.ks * a * a + extra, k.ks * a * b - extra, k.ks * b * b + extra
    U = (
        0.5 * k.kn * (l - L) ** 2 + 0.5 * A * (1 - c1**2) + B * (c12 - c1 * c2) + 0.5 * C * (1 - c2**2)
        + 2.0 * k.kt * (1 - w**2)
    )  # fmt: skip
    shear = 0.5 * k.ks * (a * a * (1 - c1**2) + 2.0 * a * b * (c12 - c1 * c2) + b * b * (1 - c2**2))
    order = model.layout.bond_order
    np.testing.assert_allclose(parts.sum(axis=0), U[order], rtol=1e-12)
    np.testing.assert_allclose(parts[0], (0.5 * k.kn * (l - L) ** 2)[order], rtol=1e-12)
    np.testing.assert_allclose(parts[1], shear[order], rtol=1e-10, atol=1e-14 * U.max())
    assert (parts >= -1e-15 * U[order]).all()  # a contact bond has no bending but for rounding
    if not isinstance(law, bd.ContactBond):
        assert (parts > 0.0).all()


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (1.0, -2.0, 0.5)])
def test_a_twist_is_twisting_and_a_bend_is_bending(axis: tuple[float, float, float]) -> None:
    X = np.array(axis) / np.linalg.norm(axis)
    across = np.cross(X, np.array([0.3, -0.5, 0.9]))
    across /= np.linalg.norm(across)
    lattice = bd.Lattice(bd.Particles(np.array([0 * X, 2 * X]), np.ones(2)), [(0, 1)])
    model = bd.Model(lattice, bond=LAWS["Timoshenko"], density=1000.0)
    k = model.stiffness
    angle = 0.3
    for around, row, stiffness in ((X, 3, k.kt[0]), (across, 2, k.kb[0])):
        state = model.state()
        both = Rotation.from_rotvec([-0.5 * angle * around, 0.5 * angle * around])
        state.set_pose(orientation=both.as_quat(scalar_first=True))
        parts = energies(model, state.pose)[:, 0]
        # ends turned by ± θ/2: 2 kt sin²(θ/2) of twist, and the same of bending with the rest k' of sin²(θ/2) · 2
        assert parts[row] == pytest.approx(2.0 * stiffness * math.sin(0.5 * angle) ** 2, rel=1e-12)
        assert np.delete(parts, row) == pytest.approx(0.0, abs=1e-14 * parts[row])


@every_law
def test_hessian_at_rest_is_the_stiffness_matrix(law: bd.BondLaw, record: Record) -> None:
    model = bd.Model(cluster(), bond=law, density=1000.0)
    pose = model.state().pose
    K = model.interaction.stiffness().tocsc().toarray()
    measured = np.array([-derivative(lambda x: forces(model, x), pose, dof) for dof in range(len(K))])
    np.testing.assert_allclose(measured, K, rtol=0.0, atol=1e-8 * np.abs(K).max())
    np.testing.assert_array_equal(K, K.T)
    record("hessian", np.abs(measured - K).max() / np.abs(K).max())


@pytest.mark.parametrize("shear", [False, True])
@pytest.mark.parametrize("direction", [(1.0, 0.0, 0.0), (0.2, -0.7, 0.4)])
def test_hessian_at_rest_is_the_textbook_beam(
    shear: bool, direction: tuple[float, float, float], record: Record
) -> None:
    L, r, Ri, Rj = 1.7, 0.35, 0.5, 1.1
    X = np.array(direction) / np.linalg.norm(direction)
    law = (bd.Timoshenko if shear else bd.EulerBernoulli)(E=E, nu=NU, radius=r)
    pair = bd.Lattice(bd.Particles(np.array([0 * X, L * X]), np.array([Ri, Rj])), [(0, 1)])
    model = bd.Model(pair, bond=law, density=1000.0)
    G, I = E / (2 * (1 + NU)), math.pi * r**4 / 4
    Phi = 12 * E * I * (10 / 9) / (G * math.pi * r**2 * L**2) if shear else 0.0
    local = beam_stiffness(L, E * math.pi * r**2, E * I, G * 2 * I, Phi)
    frame = np.linalg.qr(np.column_stack([X, np.eye(3)[2], np.eye(3)[1]]))[0].T
    frame[0], frame[2] = X, np.cross(X, frame[1])
    T = np.kron(np.eye(4), frame)
    if model.layout.order[0] == 1:  # the kernels number the elements the other way round
        T = T[:, np.r_[6:12, 0:6]]
    pose = model.state().pose
    measured = np.array([-derivative(lambda x: forces(model, x), pose, dof) for dof in range(12)])
    np.testing.assert_allclose(measured, T.T @ local @ T, rtol=0.0, atol=1e-8 * np.abs(local).max())
    record("hessian", np.abs(measured - T.T @ local @ T).max() / np.abs(local).max())


def test_parallel_bond_is_that_of_chen_tables_1_and_2() -> None:
    # F_c = k v_c with v_c the velocity of α against β at the contact point between the two surfaces
    Ra, Rb, gap, rb = 0.4, 0.9, 0.1, 0.3
    L = Ra + Rb + gap
    X = np.array([0.6, 0.0, -0.8])
    model = bd.Model(
        bd.Lattice(bd.Particles(np.array([0 * X, L * X]), np.array([Ra, Rb])), [(0, 1)]),
        bond=bd.ParallelBond(E=E, nu=NU, radius=rb),
        density=1000.0,
    )
    kn = E * math.pi * rb**2 / L
    ks = kn / (2 * (1 + NU))
    ktor, kben = 0.5 * ks * rb**2, 0.25 * kn * rb**2
    U_a, w_a, U_b, w_b = np.random.default_rng(1).standard_normal((4, 3))
    arm_a, arm_b = (Ra + gap / 2) * X, -(Rb + gap / 2) * X
    v = (U_a + np.cross(w_a, arm_a)) - (U_b + np.cross(w_b, arm_b))
    w = w_a - w_b
    along = np.outer(X, X)
    F = (kn * along + ks * (np.eye(3) - along)) @ v
    M = (ktor * along + kben * (np.eye(3) - along)) @ w
    expected = np.concatenate([-F, -M + np.cross(arm_a, -F), F, M + np.cross(arm_b, F)])
    motion = np.array([np.r_[U_a, w_a], np.r_[U_b, w_b]])[model.layout.order].ravel()
    actual = -(model.interaction.stiffness() @ motion).reshape(2, 6)[model.layout.rank].ravel()
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=1e-13 * np.abs(expected).max())


@every_law
def test_rigid_motion_gives_no_force(law: bd.BondLaw, record: Record) -> None:
    lattice = cluster()
    model = bd.Model(lattice, bond=law, density=1000.0)
    k, L = model.bonds.kn, model.bonds.length
    rng = np.random.default_rng(8)
    for angle in (1e-9, 1e-3, 0.3, 1.0, 2.0, 3.0, math.pi):
        axis = rng.standard_normal(3)
        turn = Rotation.from_rotvec(angle * axis / np.linalg.norm(axis))
        state = model.state()
        position = turn.apply(lattice.particles.position.copy()) + rng.uniform(-1.0, 1.0, 3)
        orientation = np.tile(turn.as_quat(scalar_first=True), (len(position), 1))
        orientation[::2] *= -1.0  # the same orientations
        state.set_pose(position=position, orientation=orientation)
        output = np.abs(bond_forces(model, state.pose))
        assert (output[:3] <= 1e-12 * k * L).all()
        assert (output[3:] <= 1e-12 * k * L**2).all()
        record("rigid motion", (output[:3] / (k * L)).max(), (output[3:] / (k * L**2)).max())


@every_law
def test_every_bond_is_in_balance(law: bd.BondLaw) -> None:
    model = bd.Model(cluster(), bond=law, density=1000.0)
    pose = moved(model, shift=0.12, degrees=20.0, seed=5).pose
    f, t_i, t_j = (part.T for part in np.split(bond_forces(model, pose), 3))
    d = pose[model.layout.j, :3] - pose[model.layout.i, :3]
    size = np.abs(np.cross(d, f)).max() + np.abs(t_i).max()
    np.testing.assert_allclose(t_i + t_j + np.cross(d, f), 0.0, atol=1e-14 * size)


@pytest.mark.parametrize(
    ("bend", "twist", "wide", "lost"),
    [
        (45.0, 0.0, 0, 0), (46.0, 0.0, 1, 0), (89.0, 0.0, 1, 0), (91.0, 0.0, 1, 1),
        (0.0, 59.0, 0, 0), (0.0, 61.0, 1, 0), (0.0, 119.0, 1, 0), (0.0, 121.0, 1, 1),
    ],
)  # fmt: skip
@pytest.mark.parametrize("end", [0, 1])
def test_guard_counts_wide_and_lost_bonds(bend: float, twist: float, wide: int, lost: int, end: int) -> None:
    # c < 0.7 beyond 45.6° of bending, w² < 0.75 beyond 60° of twist; c = 0 at 90°, w² = ¼ at 120°
    model = bd.Model(
        bd.Lattice(bd.Particles(np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0]]), np.ones(3)), [(0, 1), (2, 0)]),
        bond=LAWS["Timoshenko"],
        density=1000.0,
    )
    turn = Rotation.from_euler("zx", [bend, twist], degrees=True)
    orientation = np.tile([1.0, 0.0, 0.0, 0.0], (3, 1))
    orientation[end] = turn.as_quat(scalar_first=True)
    if end == 0:  # the second bond goes with it
        orientation[2] = orientation[0]
    state = model.state()
    position = np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0]])
    position[2] = turn.apply(position[2]) if end == 0 else position[2]
    state.set_pose(position=position, orientation=orientation)

    def count(integrity: np.ndarray) -> tuple[int, int, bool]:
        return count_turned(state.pose, beams(model, integrity))

    assert count(np.ones(2)) == (wide, lost, False)
    assert count(np.zeros(2)) == (0, 0, False)
    state.pose[0, 0] = np.nan
    assert count(np.ones(2))[2]
