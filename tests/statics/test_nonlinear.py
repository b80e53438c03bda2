"""Static equilibrium at large rotations, against the elastica and what every equilibrium must satisfy."""

import math

import numpy as np
import pytest
from scipy.integrate import simpson, solve_bvp

import bondem as bd
from bondem.errors import ConvergenceError, InputError
from bondem.statics.linear import System
from bondem.statics.nonlinear import tangent_matrix
from tests.specimens import crooked_block, row

E, NU, RADIUS, LENGTH = 200e9, 0.3, 0.5e-3, 1.0
BENDING = E * math.pi * RADIUS**4 / 4.0
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)


def bent(bonds: int, *conditions, nonlinear: bool = True):
    model = bd.Model(row(bonds + 1, LENGTH / bonds), LAW, 1.0, boundary=[bd.Fix(bd.Index(0)), *conditions])
    return bd.solve_static(model, nonlinear=nonlinear)


def elastica(load: float) -> tuple[float, float, float]:
    """Tip displacement along and across, tip slope, of θ'' = -λ cos θ, θ(0) = 0, θ'(1) = 0, λ = F L²/EI."""
    s = np.linspace(0.0, 1.0, 201)
    solution = solve_bvp(
        lambda s, y: np.stack([y[1], -load * np.cos(y[0])]),
        lambda a, b: np.array([a[0], b[1]]),
        s,
        np.stack([s, np.ones_like(s)]),
        tol=1e-10,
        max_nodes=100_000,
    )
    s = np.linspace(0.0, 1.0, 4001)
    slope = solution.sol(s)[0]
    return simpson(np.cos(slope), x=s) - 1.0, simpson(np.sin(slope), x=s), slope[-1]


@pytest.mark.parametrize("load", [1.0, 8.0])
def test_cantilever_converges_to_the_elastica_with_second_order(load):
    exact = np.array(elastica(load))
    error = []
    for bonds in (15, 30, 60):
        force = (0.0, load * BENDING / LENGTH**2, 0.0)
        static = bent(bonds, bd.Load(bd.Index(bonds), force=force))
        tip = np.array([static.displacement[-1, 0], static.displacement[-1, 1], static.rotation[-1, 2]])
        error.append(np.abs(tip / exact - 1.0).max())
        # in the bent shape: force, and moment about the origin
        np.testing.assert_allclose(static.reaction[0, :3], [0.0, -force[1], 0.0], atol=1e-7 * force[1])
        arm = LENGTH + static.displacement[-1, 0]
        assert static.reaction[0, 5] == pytest.approx(-force[1] * arm, rel=1e-7)
    assert error[2] <= 3e-4
    order = np.log2(np.array(error[:-1]) / error[1:])
    np.testing.assert_allclose(order, 2.0, atol=0.15)


def test_a_moment_bends_the_rod_to_a_circle():
    turn = 3.0
    static = bent(80, bd.Load(bd.Index(80), moment=(0.0, 0.0, turn * BENDING / LENGTH)))
    circle = [math.sin(turn) / turn - 1.0, (1.0 - math.cos(turn)) / turn, 0.0]
    np.testing.assert_allclose(static.displacement[-1], circle, atol=5e-4)
    assert static.rotation[-1, 2] == pytest.approx(turn, rel=5e-4)
    assert static.energy.total == pytest.approx(0.5 * turn**2 * BENDING / LENGTH, rel=1e-3)


def test_small_loads_give_the_linear_answer():
    load = bd.Load(bd.Index(10), force=(0.0, 1e-6, 2e-6), moment=(1e-7, 0.0, 0.0))
    linear, full = bent(10, load, nonlinear=False), bent(10, load)
    largest = np.abs(linear.displacement).max()
    assert np.abs(full.displacement - linear.displacement).max() <= 1e-3 * largest
    np.testing.assert_allclose(full.rotation, linear.rotation, atol=1e-3 * np.abs(linear.rotation).max())
    assert full.energy.total == pytest.approx(linear.energy.total, rel=1e-3)


def test_a_driven_turn_of_the_support_is_rigid():
    model = bd.Model(
        row(7, LENGTH / 6), LAW, 1.0, boundary=[bd.Fix(bd.Index(0), rotation="xy"), bd.Drive(bd.Index(0), rz=2.0)]
    )
    static = bd.solve_static(model, nonlinear=True)
    x = model.lattice.particles.position[:, 0]
    expected = np.stack([x * (math.cos(2.0) - 1.0), x * math.sin(2.0), 0.0 * x], axis=1)
    np.testing.assert_allclose(static.displacement, expected, atol=1e-8)
    np.testing.assert_allclose(static.rotation, np.tile([0.0, 0.0, 2.0], (7, 1)), atol=1e-8)
    assert static.energy.total <= 1e-12 * BENDING / LENGTH


def test_tangent_at_rest_is_the_stiffness_matrix():
    model = bd.Model(row(6, LENGTH / 5), bd.Timoshenko(E=E, nu=NU, radius=0.03), 1000.0)
    system = System.of(model)
    tangent = tangent_matrix(model, system.matrix.bonds, model.state().pose)
    difference = (tangent.tocsc() - system.matrix.tocsc()).toarray()
    assert np.abs(difference).max() <= 1e-15 * np.abs(system.matrix.bonds.data).max()


def test_a_block_twisted_by_its_faces_balances():
    """A lattice in three dimensions, large enough to be iterated on."""
    lattice = crooked_block((14, 7, 7), jitter=0.2, radius=0.35, reach=1.6, seed=3, walled=True)
    end, moment = bd.Face("x_max", depth=1.0), np.array([0.02, 0.0, 0.0])
    pull, twist = bd.Load(end, force=(0.0, 9e-3, 0.0)), bd.Load(end, moment=moment)
    law = bd.EulerBernoulli(E=1.0, nu=NU, radius_ratio=0.8)
    model = bd.Model(lattice, law, 1.0, boundary=[bd.Fix(bd.Face("x_min", depth=1.0)), pull, twist])
    static = bd.solve_static(model, nonlinear=True)
    assert np.linalg.norm(static.rotation, axis=1).max() > 0.1
    chosen, nodal = pull.nodal(lattice)
    total = static.reaction.copy()
    total[chosen] += nodal
    x = lattice.centre + static.displacement
    assert np.abs(total[:, :3].sum(axis=0)).max() <= 1e-8
    turned = np.cross(x, total[:, :3]).sum(axis=0) + total[:, 3:].sum(axis=0)
    # the forces of the moment turn with the end, their resultant does not
    assert np.abs(turned + moment).max() <= 1e-6


def test_what_cannot_stand_is_an_error():
    pull = [bd.Load(bd.Index(k), force=(sign, 0.0, 0.0)) for k, sign in ((0, -1.0), (4, 1.0))]
    model = bd.Model(row(5, LENGTH / 4), LAW, 1.0, boundary=pull)
    with pytest.raises(InputError, match="needs a specimen that is held"):
        bd.solve_static(model, nonlinear=True)
    with pytest.raises(ConvergenceError, match="more and shorter bonds"):
        bent(2, bd.Load(bd.Index(2), moment=(0.0, 0.0, 6.0 * BENDING / LENGTH)))
