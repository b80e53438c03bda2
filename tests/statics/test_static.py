"""Static equilibrium against closed forms, and what every equilibrium must satisfy."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem._blas import one_blas_thread
from bondem.errors import ConvergenceError, InputError
from bondem.observables.energy import linear_energy
from bondem.statics.linear import Elimination, Iteration, System
from tests.beam_theory import beam_stiffness
from tests.specimens import crooked_block, two_spheres

E, NU, RADIUS = 200e9, 0.3, 1.5e-3
G = E / (2.0 * (1.0 + NU))
AREA, INERTIA = math.pi * RADIUS**2, math.pi * RADIUS**4 / 4.0
AXIS = np.array([2.0, -1.0, 2.0]) / 3.0
ACROSS = np.array([1.0, 2.0, 0.0]) / math.sqrt(5.0)


def chain(bonds: int, *, step: float = 8e-3, axis: np.ndarray = AXIS) -> bd.Lattice:
    """Equal elements in a row along `axis`, in a mixed order that the result must not show."""
    order = np.random.default_rng(bonds).permutation(bonds + 1)
    position = np.empty((bonds + 1, 3))
    position[order] = np.arange(bonds + 1)[:, None] * step * axis
    return bd.Lattice(bd.Particles(position, step / 2), np.stack([order[:-1], order[1:]], axis=1))


def ends(lattice: bd.Lattice) -> tuple[int, int]:
    along = lattice.particles.position @ AXIS
    return int(along.argmin()), int(along.argmax())


def shear_flexibility(law: str) -> float:
    """Φ of one bond of length 8 mm: 0, or as Chen et al. (2022)."""
    return 0.0 if law == "EulerBernoulli" else 20.0 * RADIUS**2 * (1.0 + NU) / (3.0 * 8e-3**2)


@pytest.mark.parametrize("law", ["EulerBernoulli", "Timoshenko"])
def test_bond_matrix_is_the_textbook_beam(law):
    lattice = two_spheres(8e-3)
    model = bd.Model(lattice, getattr(bd, law)(E=E, nu=NU, radius=RADIUS), 1000.0)
    K = model.interaction.stiffness().tocsc().toarray()
    expected = beam_stiffness(8e-3, E * AREA, E * INERTIA, 2.0 * G * INERTIA, shear_flexibility(law))
    assert np.abs(K - expected).max() <= 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("law", ["EulerBernoulli", "Timoshenko"])
@pytest.mark.parametrize("bonds", [1, 7, 60])
def test_cantilever_is_exact_at_the_elements(law, bonds):
    lattice = chain(bonds)
    root, tip = ends(lattice)
    force = 3.0
    model = bd.Model(
        lattice,
        getattr(bd, law)(E=E, nu=NU, radius=RADIUS),
        1000.0,
        boundary=[bd.Fix(bd.Index(root)), bd.Load(bd.Index(tip), force=tuple(force * ACROSS))],
    )
    static = bd.solve_static(model)
    length = bonds * 8e-3
    x = (lattice.particles.position - lattice.particles.position[root]) @ AXIS
    phi = shear_flexibility(law) * 8e-3**2 / 12.0  # EI / (κ G A)
    expected = force * (x**2 * (3.0 * length - x) / 6.0 + phi * x) / (E * INERTIA)
    assert np.abs(static.displacement @ ACROSS - expected).max() <= 1e-8 * expected.max()
    slope = force * x * (2.0 * length - x) / (2.0 * E * INERTIA)
    assert np.abs(static.rotation @ np.cross(AXIS, ACROSS) - slope).max() <= 1e-8 * slope.max()
    assert np.abs(static.displacement @ AXIS).max() <= 1e-9 * expected.max()
    work = 0.5 * force * expected[tip]
    assert static.energy.total == pytest.approx(work, rel=1e-8)
    assert static.energy.normal <= 1e-12 * work


def test_tension_and_torsion_of_a_chain():
    lattice = chain(9)
    root, tip = ends(lattice)
    force, moment = 50.0, 0.2
    model = bd.Model(
        lattice,
        bd.Timoshenko(E=E, nu=NU, radius=RADIUS),
        1000.0,
        boundary=[
            bd.Fix(bd.Index(root)),
            bd.Load(bd.Index(tip), force=tuple(force * AXIS), moment=tuple(moment * AXIS)),
        ],
    )
    static = bd.solve_static(model)
    x = (lattice.particles.position - lattice.particles.position[root]) @ AXIS
    np.testing.assert_allclose(static.displacement @ AXIS, force * x / (E * AREA), rtol=1e-9, atol=1e-18)
    np.testing.assert_allclose(static.rotation @ AXIS, moment * x / (2.0 * G * INERTIA), rtol=1e-9, atol=1e-15)
    assert static.energy.normal == pytest.approx(0.5 * force**2 * 9 * 8e-3 / (E * AREA), rel=1e-9)
    assert static.energy.twisting == pytest.approx(0.25 * moment**2 * 9 * 8e-3 / (G * INERTIA), rel=1e-9)
    assert static.energy.shear + static.energy.bending <= 1e-12 * static.energy.total
    held = -np.concatenate([force * AXIS, moment * AXIS])
    np.testing.assert_allclose(static.reaction[root], held, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("bonds", [4, 40])
def test_a_free_chain_in_tension_stretches_about_its_middle(bonds):
    lattice = chain(bonds)
    first, last = ends(lattice)
    force = 50.0
    model = bd.Model(
        lattice,
        bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS),
        1000.0,
        boundary=[
            bd.Load(bd.Index(first), force=tuple(-force * AXIS)),
            bd.Load(bd.Index(last), force=tuple(force * AXIS)),
        ],
    )
    static = bd.solve_static(model)
    x = (lattice.particles.position - lattice.particles.position.mean(axis=0)) @ AXIS
    largest = force * x.max() / (E * AREA)
    assert np.abs(static.displacement - np.outer(force * x / (E * AREA), AXIS)).max() <= 1e-9 * largest
    assert np.abs(static.rotation).max() * 8e-3 <= 1e-9 * largest
    assert np.abs(static.reaction).max() == 0.0


@pytest.fixture(scope="module")
def block() -> bd.Lattice:
    """More than elimination is used for."""
    return crooked_block((12, 8, 8), edge=1e-3, jitter=0.2, radius=0.35, reach=1.83, seed=0, walled=True)


LAW = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.6)
CLAMP = bd.Fix(bd.Face("x_min", depth=1.0))


def test_reactions_balance_the_loads(block):
    load = bd.Load(bd.Face("x_max", depth=1.0), force=(30.0, -20.0, 10.0), moment=(0.02, 0.0, -0.03))
    static = bd.solve_static(bd.Model(block, LAW, 1.0, boundary=[CLAMP, load]))
    chosen, nodal = load.nodal(block)
    applied = np.zeros_like(static.reaction)
    applied[chosen] = nodal
    total = static.reaction + applied
    assert np.abs(total[:, :3].sum(axis=0)).max() <= 1e-8 * 40.0
    x = block.particles.position
    moment = np.cross(x, total[:, :3]).sum(axis=0) + total[:, 3:].sum(axis=0)
    assert np.abs(moment).max() <= 1e-8 * 40.0 * 20e-3
    work = 0.5 * (applied[:, :3] * static.displacement + applied[:, 3:] * static.rotation).sum()
    assert static.energy.total == pytest.approx(work, rel=1e-8)
    held = CLAMP.region.select(block)
    assert np.abs(static.displacement[held]).max() == np.abs(static.rotation[held]).max() == 0.0


def test_driving_what_a_load_moved_gives_its_force_back(block):
    grip = bd.Index(bd.Face("x_max", depth=1.0).select(block)[3])
    loaded = bd.solve_static(bd.Model(block, LAW, 1.0, boundary=[CLAMP, bd.Load(grip, force=(5.0, 1.0, 0.0))]))
    k = grip.elements[0]
    u = loaded.displacement[k]
    driven = bd.solve_static(bd.Model(block, LAW, 1.0, boundary=[CLAMP, bd.Drive(grip, x=u[0], y=u[1], z=u[2])]))
    np.testing.assert_allclose(driven.reaction[k, :3], [5.0, 1.0, 0.0], atol=1e-7)
    assert np.abs(driven.displacement - loaded.displacement).max() <= 1e-8 * np.abs(u).max()
    np.testing.assert_array_equal(driven.displacement[k], u)


@one_blas_thread
def test_elimination_and_iteration_agree_also_where_the_specimen_is_free(block):
    load = np.zeros((2, len(block.particles), 6))
    faces = [bd.Face(name, depth=1.0) for name in ("x_min", "x_max")]
    for face, sign in zip(faces, (-1.0, 1.0), strict=True):
        chosen, nodal = bd.Load(face, force=(sign * 30.0, 0.0, 0.0), moment=(sign * 0.01, 0.0, 0.0)).nodal(block)
        load[:, chosen] += nodal
    for k, boundary in enumerate(([CLAMP], [])):
        model = bd.Model(block, LAW, 1.0, boundary=boundary)
        system = System.of(model)
        assert system.loose.shape[1] == (0, 6)[k]
        right = load[k][model.layout.order].ravel()
        exact, found = Elimination(system).solve(right)[0], Iteration(system).solve(right)[0]
        assert np.abs(found - exact).max() <= 1e-7 * np.abs(exact).max()
        near = Iteration(system).solve(right, guess=1.01 * exact)[0]
        assert np.abs(near - exact).max() <= 1e-7 * np.abs(exact).max()


def test_supports_may_leave_some_rigid_motions_free():
    lattice = chain(12)
    first, last = ends(lattice)
    ball = bd.Fix(bd.Index(first), rotation="")
    law = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
    pull = bd.Load(bd.Index(last), force=tuple(10.0 * AXIS))
    static = bd.solve_static(bd.Model(lattice, law, 1.0, boundary=[ball, pull]))
    assert static.displacement[last] @ AXIS == pytest.approx(10.0 * 12 * 8e-3 / (E * AREA), rel=1e-9)
    push = bd.Load(bd.Index(last), force=tuple(10.0 * ACROSS))
    with pytest.raises(InputError, match="balance them"):
        bd.solve_static(bd.Model(lattice, law, 1.0, boundary=[ball, push]))


def test_rattlers_stay_where_they_are(block):
    particles = block.particles
    far = np.array([[0.1, 0.0, 0.0], [0.1, 0.0, 0.9e-3]])
    radius = np.r_[0.5e-3, 0.5e-3, particles.radius]
    more = bd.Particles(np.vstack([far, particles.position]), radius, shape=particles.shape)
    lattice = bd.Lattice(more, np.vstack([[[0, 1]], block.pairs + 2]))
    load = bd.Load(bd.Face("x_max", depth=1.0), force=(30.0, 0.0, 0.0))
    clean = bd.solve_static(bd.Model(block, bd.EulerBernoulli(E=E, nu=NU, radius=2e-4), 1.0, boundary=[CLAMP, load]))
    law = bd.EulerBernoulli(E=E, nu=NU, radius=2e-4)
    dirty = bd.solve_static(bd.Model(lattice, law, 1.0, boundary=[CLAMP, load]))
    assert lattice.rattlers == 2
    assert np.abs(dirty.displacement[:2]).max() == np.abs(dirty.rotation[:2]).max() == 0.0
    largest = np.abs(clean.displacement).max()
    assert np.abs(dirty.displacement[2:] - clean.displacement).max() <= 1e-8 * largest


def test_a_load_no_bond_resists_is_an_error():
    lattice = chain(3)
    first, last = ends(lattice)
    law = bd.ContactBond(E=E, nu=NU, radius=RADIUS)
    pull = bd.Load(bd.Index(last), force=tuple(10.0 * AXIS))
    static = bd.solve_static(bd.Model(lattice, law, 1.0, boundary=[bd.Fix(bd.Index(first)), pull]))
    assert static.displacement[last] @ AXIS == pytest.approx(30.0 * 8e-3 / (E * AREA), rel=1e-9)
    push = bd.Load(bd.Index(last), force=tuple(10.0 * ACROSS))
    with pytest.raises(ConvergenceError, match="no bond resists"):
        bd.solve_static(bd.Model(lattice, law, 1.0, boundary=[bd.Fix(bd.Index(first)), push]))


def test_a_free_specimen_needs_balanced_loads(block):
    push = bd.Load(bd.Face("x_max", depth=1.0), force=(1.0, 0.0, 0.0))
    with pytest.raises(InputError, match="balance them"):
        bd.solve_static(bd.Model(block, LAW, 1.0, boundary=[push]))


@pytest.mark.parametrize("law", [bd.EulerBernoulli, bd.ParallelBond], ids=["middle", "between surfaces"])
def test_strains_of_bonds_give_the_energy_of_the_matrix(law):
    # unequal elements: the contact point of a parallel bond is not in the middle, and levers cannot be swapped
    rng = np.random.default_rng(3)
    particles = bd.Particles(0.1 * rng.random((40, 3)), 1e-3 * (0.5 + rng.random(40)))
    pairs = np.array([(i, j) for i in range(40) for j in (i + 1, i + 7) if j < 40])
    model = bd.Model(bd.Lattice(particles, pairs), law(E=1e9, nu=0.2, radius_ratio=0.6), 1000.0)
    u, turn = 1e-6 * rng.standard_normal((2, len(particles), 3))
    turn /= particles.mean_radius
    motion = np.hstack([u, turn])[model.layout.order].ravel()
    energy = 0.5 * motion @ (model.interaction.stiffness() @ motion)
    assert linear_energy(model, u, turn).total == pytest.approx(energy, rel=1e-12)
    # ... and their forces and products are parts of the same
    k = model.stiffness
    strain = bd.BondStrain.of(model.lattice, k.lever, u, turn)
    work = strain.products(strain) * np.stack([k.kn, k.ks, k.kb, k.kt])
    assert 0.5 * work.sum() == pytest.approx(energy, rel=1e-12)
    slip = strain.normal[:, None] * strain.direction + strain.shear
    assert (strain.forces(k) * slip).sum() == pytest.approx(work[:2].sum(), rel=1e-12)
