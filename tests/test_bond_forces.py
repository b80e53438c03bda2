"""Forces and moments of bonds: what moves the elements, of every formulation, and closed forms of a cantilever."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.solve.explicit import integrate
from bondem.solve.plan import Plan
from bondem.solve.timestep import critical_step

E, NU, RHO = 1e9, 0.25, 1000.0
SOFT = bd.MohrCoulomb(
    tension=1.2e6, cohesion=2.4e6, friction_angle=0.5, fracture_energy=5e3, fracture_energy_shear=2e4
)
LAWS = {
    "total": (bd.Timoshenko(E=E, nu=NU, radius_ratio=0.7), None),
    "incremental": (bd.ParallelBond(E=E, nu=NU, radius_ratio=0.7), None),
    "softening": (bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.7), SOFT),
    "breaking": (bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.7), bd.PeripheralStress(tension=4e6, shear=1e8)),
    "non-local": (bd.NonLocal(E=E, nu=NU, areas="weighted", lever="contact"), None),
}


def spheres() -> bd.Lattice:
    particles = bd.pack(bd.Box((3.0, 2.0, 2.0)), count=120, spread=0.2, seed=3)
    return bd.connect(particles, reach=1.1)


@pytest.mark.parametrize("name", LAWS)
def test_forces_and_moments_are_what_moves_the_elements(name: str) -> None:
    """Summed up over the bonds of an element they are mass times acceleration, to rounding."""
    law, failure = LAWS[name]
    model = bd.Model(spheres(), law, RHO, failure=failure)
    state = model.state()
    rng, n = np.random.default_rng(5), len(model.lattice.particles)
    state.set_motion(velocity=rng.standard_normal((n, 3)), angular_velocity=rng.standard_normal((n, 3)))
    dt = 0.2 * critical_step(model, bd.VelocityVerlet())
    state = integrate(model, Plan(duration=60 * dt, dt=dt, every=0), state=state).state
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
    lattice = bd.Lattice(bd.Particles([[0.0, 0.0, 0.0], [length, 0.0, 0.0]], 0.5), [(1, 0)])
    end = bd.Load(bd.Index([1]), (P, Q, 0.0), moment=(T, 0.0, 0.0))
    model = bd.Model(lattice, bd.EulerBernoulli(E=E, nu=NU, radius=0.1), RHO, boundary=[bd.Fix(bd.Index([0])), end])
    dt = 0.5 * critical_step(model, bd.VelocityVerlet())
    plan = Plan(duration=4000 * dt, dt=dt, every=0, damping=bd.LocalDamping(0.7))
    found = bd.bond_forces(model, integrate(model, plan).state)
    assert found.normal == pytest.approx([P], rel=1e-3)
    assert found.shear == pytest.approx([Q], rel=1e-3)
    assert found.bending == pytest.approx([Q * length], rel=1e-3)
    assert found.twisting == pytest.approx([T], rel=1e-3)
    # the force on the second element of the pair, which is the one that is held
    assert found.force[0] == pytest.approx([P, Q, 0.0], rel=1e-3, abs=1e-6)
    assert math.isclose(found.axis[0, 0], -1.0, abs_tol=1e-6)


def test_cells_and_other_states_are_refused() -> None:
    body = bd.connect(bd.pack(bd.Box((2.0, 1.0, 1.0)), count=60, method="even", seed=1), method="laguerre")
    model = bd.Model(body, bd.CellBond(E=E, nu=NU), RHO)
    with pytest.raises(InputError, match="cell_stress"):
        bd.bond_forces(model, model.state())
    other = bd.Model(spheres(), LAWS["total"][0], RHO)
    with pytest.raises(InputError, match="belongs to another"):
        bd.bond_forces(other, model.state())
