"""Forces and moments of bonds: what moves the elements, of every formulation, and closed forms of a cantilever."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.errors import InputError
from tests.models import time_step
from tests.specimens import bar, row, spheres, two_spheres

E, NU, RHO = 1e9, 0.25, 1000.0
SOFT = bd.MohrCoulomb(
    tension=1.2e6, cohesion=2.4e6, friction_angle=0.5, fracture_energy=5e3, fracture_energy_shear=2e4
)
BOX = bd.Box((3.0, 2.0, 2.0))
LAWS = {
    "total": (bd.Timoshenko(E=E, nu=NU, radius_ratio=0.7), None),
    "incremental": (bd.ParallelBond(E=E, nu=NU, radius_ratio=0.7), None),
    "softening": (bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.7), SOFT),
    "breaking": (bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.7), bd.PeripheralStress(tension=4e6, shear=1e8)),
    "non-local": (bd.NonLocal(E=E, nu=NU, areas="weighted", lever="contact"), None),
}


@pytest.mark.parametrize("name", LAWS)
def test_forces_and_moments_are_what_moves_the_elements(name: str) -> None:
    """Summed up over the bonds of an element they are mass times acceleration, to rounding."""
    law, failure = LAWS[name]
    model = bd.Model(spheres(BOX, 120, spread=0.2, seed=3, reach=1.1), law, RHO, failure=failure)
    state = model.state()
    rng, n = np.random.default_rng(5), len(model.lattice.particles)
    state.set_motion(velocity=rng.standard_normal((n, 3)), angular_velocity=rng.standard_normal((n, 3)))
    dt = time_step(model, 0.2)
    state = integrate(model, bd.Plan(duration=60 * dt, dt=dt, every=0), state=state).state
    found = bd.bond_forces(model, state)
    i, j = model.lattice.pairs.T
    load, turn = np.zeros((n, 3)), np.zeros((n, 3))
    for end, force, moment in ((i, -found.force, found.moment_i), (j, found.force, found.moment_j)):
        np.add.at(load, end, force)
        np.add.at(turn, end, moment)
    order, acceleration = model.layout.order, np.empty((n, 6))
    acceleration[order] = state.acceleration
    size = np.abs(found.force).max()
    assert size > 0.0
    np.testing.assert_allclose(load, model.mass[:, None] * acceleration[:, :3], atol=1e-10 * size, rtol=0.0)
    np.testing.assert_allclose(turn, model.inertia[:, None] * acceleration[:, 3:], atol=1e-10 * size, rtol=0.0)
    if name == "softening":
        assert ((state.bond_integrity > 0.0) & (state.bond_integrity < 1.0)).sum() > 5
    if name == "breaking":
        gone = state.bond_integrity == 0.0
        assert gone.sum() > 5
        assert not found.force[gone].any()
        assert not found.moment_j[gone].any()


def test_a_cantilever_of_one_bond_has_its_closed_forms() -> None:
    """Pulled by P, pushed aside by Q, twisted by T: N = P, V = Q, M = Q L where it is held, twist T."""
    length, P, Q, T = 1.0, 50.0, 20.0, 3.0
    lattice = two_spheres(length, 0.5, swapped=True)
    end = bd.Load(bd.Index([1]), (P, Q, 0.0), moment=(T, 0.0, 0.0))
    model = bd.Model(lattice, bd.EulerBernoulli(E=E, nu=NU, radius=0.1), RHO, boundary=[bd.Fix(bd.Index([0])), end])
    dt = time_step(model, 0.5)
    plan = bd.Plan(duration=4000 * dt, dt=dt, every=0, damping=bd.LocalDamping(0.7))
    found = bd.bond_forces(model, integrate(model, plan).state)
    assert found.normal == pytest.approx([P], rel=1e-3)
    assert found.shear == pytest.approx([Q], rel=1e-3)
    assert found.bending == pytest.approx([Q * length], rel=1e-3)
    assert found.twisting == pytest.approx([T], rel=1e-3)
    # the force on the second element of the pair, which is the one that is held
    assert found.force[0] == pytest.approx([P, Q, 0.0], rel=1e-3, abs=1e-6)
    assert math.isclose(found.axis[0, 0], -1.0, abs_tol=1e-6)


def test_cells_and_other_states_are_refused() -> None:
    body = bar(60, 2.0)
    model = bd.Model(body, bd.CellBond(E=E, nu=NU), RHO)
    with pytest.raises(InputError, match="cell_stress"):
        bd.bond_forces(model, model.state())
    other = bd.Model(spheres(BOX, 120, spread=0.2, seed=3, reach=1.1), LAWS["total"][0], RHO)
    with pytest.raises(InputError, match="belongs to another"):
        bd.bond_forces(other, model.state())


def pulled(load: bd.Load, law: bd.BondLaw = LAWS["total"][0]) -> bd.Model:
    """Spheres held at one end, with a load at the other."""
    return bd.Model(
        spheres(BOX, 120, spread=0.2, seed=3, reach=1.1),
        law,
        RHO,
        boundary=[bd.Fix(bd.Face("x_min", depth=0.2)), load],
    )


FAR = bd.Face("x_max", depth=0.2)


@pytest.mark.parametrize("law", [LAWS["total"][0], bd.ParallelBond(E=E, nu=NU, radius_ratio=0.7, kappa=2.0)])
def test_a_static_solution_has_the_forces_of_its_pose(law: bd.BondLaw) -> None:
    """To the square of its rotations; and those of every free element are in equilibrium, to rounding."""
    model = pulled(bd.Load(FAR, (1e-2, 2e-2, 0.0), moment=(0.0, 0.0, 1e-2)), law)
    static = bd.solve_static(model)
    found = bd.bond_forces(model, static)
    n, (i, j) = len(model.lattice.particles), model.lattice.pairs.T
    load, turn = np.zeros((n, 3)), np.zeros((n, 3))
    for end, force, moment in ((i, -found.force, found.moment_i), (j, found.force, found.moment_j)):
        np.add.at(load, end, force)
        np.add.at(turn, end, moment)
    free = np.setdiff1d(np.arange(n), np.concatenate([one.region.select(model.lattice) for one in model.boundary]))
    size = np.abs(found.force).max()
    assert np.abs(load[free]).max() < 1e-9 * size
    assert np.abs(turn[free]).max() < 1e-9 * size
    state = model.state()
    state.displacement = static.displacement
    half = 0.5 * static.rotation
    state.orientation = np.column_stack([np.sqrt(1.0 - (half**2).sum(axis=1)), half])
    if law.formulation == "total":
        posed = bd.bond_forces(model, state)
        for name in ("force", "moment_i", "moment_j"):
            ours, theirs = getattr(found, name), getattr(posed, name)
            assert np.abs(ours - theirs).max() < 1e-4 * np.abs(theirs).max()


def test_bonds_of_a_static_solution_carry_their_stress_free_strain() -> None:
    """A chain between two walls that would grow by ε*: -kn L ε* in each of its equal bonds."""
    chain = bd.Lattice(row(4, 1.0).particles, [(0, 1), (2, 1), (2, 3)])
    heat = bd.Eigenstrain(lambda centre: np.full(len(centre), 1e-3))
    model = bd.Model(chain, LAWS["total"][0], RHO, boundary=[bd.Fix(bd.Index([0, 3])), heat])
    found = bd.bond_forces(model, bd.solve_static(model))
    assert found.normal == pytest.approx(-1e-3 * model.stiffness.kn, rel=1e-9)


def test_the_mean_stress_of_elements_is_the_moment_of_the_loads() -> None:
    """Σ V σ = Σ x ⊗ F over loads and supports, exactly; in a bar in tension between its ends F / A along x."""
    model = pulled(bd.Load(FAR, (1e-2, 0.0, 0.0)))
    static = bd.solve_static(model)
    found = bd.element_stress(model, static)
    assert found.volume.sum() == pytest.approx(12.0)
    outer = static.reaction[:, :3].copy()
    chosen, nodal = model.boundary[1].nodal(model.lattice)
    outer[chosen] += nodal[:, :3]
    whole = model.lattice.centre.T @ outer
    np.testing.assert_allclose(np.einsum("n,nab->ab", found.volume, found.stress), whole, atol=1e-12)
    middle = bd.Within(bd.Box((1.5, 2.0, 2.0)).moved((0.75, 0.0, 0.0)))
    assert found.mean(middle)[0, 0] == pytest.approx(1e-2 / 4.0, rel=0.1)
    np.testing.assert_array_equal(bd.cell_stress(model, static), found.symmetric)


def test_the_sum_by_hand_is_the_load_times_the_distance_of_the_centres() -> None:
    """-Σ f ⊗ l = F d, with d from the held centres to the loaded ones; shorter than the bar by a tenth here."""
    model = pulled(bd.Load(FAR, (1e-2, 0.0, 0.0)))
    lattice, static = model.lattice, bd.solve_static(model)
    found = bd.bond_forces(model, static)
    by_hand = -np.einsum("mi,mj->ij", found.force, lattice.branch)
    (loaded, shares), x = model.boundary[1].nodal(lattice), lattice.centre[:, 0]
    distance = (shares[:, 0] @ x[loaded] + static.reaction[:, 0] @ x) / 1e-2
    assert by_hand[0, 0] == pytest.approx(1e-2 * distance, rel=1e-9)
    assert 0.8 < distance / 3.0 < 0.95
    assert (found.normal > 0.0).sum() > (found.normal < 0.0).sum()


def test_the_couple_stress_of_a_bar_is_its_moment_over_its_section() -> None:
    """Bent by M: elements alone have little couple stress, a section as a whole has M / A about its middle."""
    model = pulled(bd.Load(FAR, moment=(0.0, 0.0, 1e-2)))
    found = bd.element_stress(model, bd.solve_static(model))
    middle = bd.Within(bd.Box((1.5, 2.0, 2.0)).moved((0.75, 0.0, 0.0)))
    whole = found.mean_couple(middle)
    assert whole[0, 2] == pytest.approx(1e-2 / 4.0, rel=0.15)
    assert np.abs(found.mean(middle)).max() < 0.2 * 1e-2 / 4.0
    alone = found.volume[:, None, None] * found.couple_stress
    assert abs(alone.sum(axis=0)[0, 2] / 12.0) < 0.7 * whole[0, 2]


def test_a_bent_chain_has_nothing_but_couple_stress() -> None:
    """M L over the volume of the elements between the ends: no force, no stress."""
    end = bd.Load(bd.Index([4]), moment=(0.0, 0.0, 3.0))
    chain = bd.Lattice(row(5, 1.0).particles, [(0, 1), (2, 1), (2, 3), (3, 4)])
    model = bd.Model(chain, bd.EulerBernoulli(E=E, nu=NU, radius=0.1), RHO, boundary=[bd.Fix(bd.Index([0])), end])
    found = bd.element_stress(model, bd.solve_static(model))
    assert np.abs(found.stress).max() < 1e-6
    inner = found.volume[1:4, None, None] * found.couple_stress[1:4]
    for one in inner:
        assert one[0, 2] == pytest.approx(3.0, rel=1e-9)
        assert np.abs(np.delete(one.ravel(), 2)).max() < 1e-6


def test_results_of_other_kinds_are_refused() -> None:
    model = pulled(bd.Load(FAR, (1e-2, 0.0, 0.0)))
    with pytest.raises(InputError, match="give what bd"):
        bd.bond_forces(model, 3.0)
    other = bd.solve_static(bd.Model(row(5, 1.0), LAWS["total"][0], RHO, boundary=bd.Fix(bd.Index([0]))))
    with pytest.raises(InputError, match="the result has 5 elements"):
        bd.element_stress(model, other)
