"""Fragments: the pieces of a broken specimen."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from bondem._checks import instance, number
from bondem._types import Floats, Ints
from bondem.errors import InputError
from bondem.model.state import State
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class Fragments:
    """Pieces of elements joined by unbroken bonds, f of them, the heaviest first.

    An element without bonds is a piece, too.

    Attributes:
        label: piece of each element, user's order, shape (n,).
        size: number of elements of each piece, shape (f,).
        body: number of the body of each piece, that of most of its mass where bonds join bodies, shape (f,).
        mass: mass [kg], shape (f,).
        position: centre of mass [m], shape (f, 3).
        velocity: velocity of the centre of mass [m/s], shape (f, 3).
        spin: angular velocity of a rigid body with the angular momentum of the piece [rad/s], shape (f, 3); NaN in a
            periodic cell, where a piece may continue in the next image.
    """

    label: Ints
    size: Ints
    body: Ints
    mass: Floats
    position: Floats
    velocity: Floats
    spin: Floats

    def __len__(self) -> int:
        return len(self.size)


def fragments(lattice: Lattice, state: State, *, integrity: float = 0.0) -> Fragments:
    """Find the pieces of a state.

    Args:
        lattice: lattice of the state.
        state: state of an explicit run, such as `run.state`.
        integrity: largest integrity of the bonds that count as broken [-], in [0, 1): 0 for broken bonds only, more
            to include softening bonds.

    Raises:
        InputError: The state belongs to another lattice, or the integrity is outside [0, 1).
    """
    instance("fragments", "lattice", lattice, Lattice, "the lattice of the model")
    instance("fragments", "state", state, State, "the state of a run, or model.state()")
    number("fragments", "integrity", integrity, least=0.0, below=1.0, advice="a share in [0, 1), 0 for broken bonds")
    n, whole = len(lattice.particles), state.bond_integrity > integrity
    if len(state.pose) != n or len(whole) != len(lattice.pairs):
        raise InputError(f"fragments: the state has {len(state.pose)} elements and other bonds; give its own lattice")
    i, j = lattice.pairs[whole].T
    _, found = connected_components(coo_array((np.ones(len(i), dtype=bool), (i, j)), shape=(n, n)), directed=False)
    rank = state.layout.rank
    mass, inertia = 1.0 / state.motion[rank, 3], 1.0 / state.motion[rank, 7]
    heavy = np.bincount(found, mass).astype(float)
    order = np.argsort(-heavy, kind="stable")
    label = np.argsort(order)[found]
    total = heavy[order]
    position = _sums(label, mass[:, None] * state.position) / total[:, None]
    velocity = _sums(label, mass[:, None] * state.velocity) / total[:, None]
    arm, fast = state.position - position[label], state.velocity - velocity[label]
    momentum = _sums(label, mass[:, None] * np.cross(arm, fast) + inertia[:, None] * state.angular_velocity)
    square = mass * (arm**2).sum(axis=1) + inertia
    resistance = square[:, None, None] * np.eye(3) - mass[:, None, None] * arm[:, :, None] * arm[:, None, :]
    tensor = _sums(label, resistance.reshape(n, 9)).reshape(-1, 3, 3)
    spin = np.asarray(np.linalg.solve(tensor, momentum[:, :, None])[:, :, 0], dtype=float)
    if lattice.particles.period is not None:
        spin = np.full_like(spin, np.nan)
    parts = coo_array((mass, (label, lattice.body)), shape=(len(order), len(lattice.names))).tocsr()
    body = np.asarray(parts.argmax(axis=1)).ravel().astype(np.int64)
    return Fragments(
        label=label, size=np.bincount(label), body=body, mass=total, position=position, velocity=velocity, spin=spin
    )


def _sums(label: Ints, values: Floats) -> Floats:
    """Return the sum of `values` (n, d) over the elements of each piece, (f, d)."""
    return np.column_stack([np.bincount(label, column) for column in values.T]).astype(float)
