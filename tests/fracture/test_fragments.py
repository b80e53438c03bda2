"""The pieces into which a specimen breaks."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.specimens import row


def chain(count: int) -> bd.Model:
    line = row(count, 1.0)
    particles = bd.Particles(line.centre, np.linspace(0.4, 0.5, count))
    law = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.5)
    return bd.Model(bd.Lattice(particles, line.pairs[::-1]), law, density=1000.0)


def test_pieces_of_a_chain():
    model = chain(9)
    state = model.state()
    pieces = bd.fragments(model.lattice, state)
    assert len(pieces) == 1
    assert pieces.size.tolist() == [9]
    cut = state.integrity
    cut[np.flatnonzero(np.isin(state.layout.bond_order, [8 - 1 - 2, 8 - 1 - 3]))] = 0.0  # bonds 2-3 and 3-4
    spin = np.array([0.3, -0.2, 0.5])
    x = model.lattice.particles.position
    moving = np.array([1.0, 2.0, 3.0]) + np.cross(spin, x)
    state.set_motion(velocity=moving, angular_velocity=np.broadcast_to(spin, moving.shape))
    pieces = bd.fragments(model.lattice, state)
    assert pieces.label.tolist() == [1, 1, 1, 2, 0, 0, 0, 0, 0]
    assert pieces.size.tolist() == [5, 3, 1]
    np.testing.assert_allclose(pieces.mass.sum(), model.mass.sum())
    own = [pieces.label == f for f in range(3)]
    centre = np.array([np.average(x[f], axis=0, weights=model.mass[f]) for f in own])
    np.testing.assert_allclose(pieces.position, centre, atol=1e-14)
    np.testing.assert_allclose(pieces.velocity, np.array([1.0, 2.0, 3.0]) + np.cross(spin, centre), atol=1e-13)
    np.testing.assert_allclose(pieces.spin, np.broadcast_to(spin, (3, 3)), atol=1e-13)


def test_a_state_of_another_lattice_is_refused():
    with pytest.raises(InputError, match="its own lattice"):
        bd.fragments(chain(4).lattice, chain(5).state())


def test_what_has_softened_so_far_joins_nothing():
    model = chain(6)
    state = model.state()
    state.integrity[np.flatnonzero(np.isin(state.layout.bond_order, [1]))] = 0.4  # bond 3-4
    assert len(bd.fragments(model.lattice, state)) == 1
    assert len(bd.fragments(model.lattice, state, integrity=0.3)) == 1
    assert bd.fragments(model.lattice, state, integrity=0.4).label.tolist() == [0, 0, 0, 0, 1, 1]
    with pytest.raises(InputError, match="integrity = 1"):
        bd.fragments(model.lattice, state, integrity=1.0)
