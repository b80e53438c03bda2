"""Deformation of the middle of a specimen, by least-squares fits to displacements.

The ends of a specimen, where constraints and loads act, deform unevenly. The middle half follows beam theory, so that
material parameters are measured there.
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, PerElement3
from bondem.errors import InputError
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class AffineField:
    """Affine field closest to given displacements: u(x) = shift + gradient (x - centre).

    Attributes:
        centre: centroid of the points [m], (3,).
        shift: mean displacement [m], (3,).
        gradient: displacement gradient ∂u_i/∂x_j [-], (3, 3).
    """

    centre: Floats
    shift: Floats
    gradient: Floats

    @classmethod
    def fit(cls, position: PerElement3, displacement: PerElement3) -> "AffineField":
        """Fit the field to points and their displacements [m], (n, 3), with equal weights.

        `shift` and `spin` of the result are the rigid motion of the points.
        """
        centre, shift = position.mean(axis=0), displacement.mean(axis=0)
        gradient = np.linalg.lstsq(position - centre, displacement - shift, rcond=None)[0].T
        return cls(centre, shift, gradient)

    @property
    def strain(self) -> Floats:
        """Strain tensor, the symmetric part of the displacement gradient [-], (3, 3)."""
        return 0.5 * (self.gradient + self.gradient.T)

    @property
    def spin(self) -> Floats:
        """Rotation vector of the antisymmetric part of the displacement gradient [rad], (3,)."""
        W = 0.5 * (self.gradient - self.gradient.T)
        return np.array([W[2, 1], W[0, 2], W[1, 0]])

    def without_rigid_motion(self, position: PerElement3, displacement: PerElement3) -> PerElement3:
        """Return displacements of points [m], (n, 3), less the shift and the spin of the field."""
        return displacement - self.shift - np.cross(self.spin, position - self.centre)


def at_generators(
    lattice: Lattice, displacement: PerElement3, rotation: PerElement3
) -> tuple[PerElement3, PerElement3]:
    """Compute the displacements of the generators of elements, which are the sphere centres of the packing.

    A uniform stress moves the generators of cells, and not their centres of mass, by an affine field. The two points
    of a sphere coincide.

    Args:
        lattice: the specimen.
        displacement: displacements of the centres of mass [m], (n, 3).
        rotation: rotation vectors of the elements [rad], (n, 3).

    Returns:
        Positions and displacements of the generators [m], (n, 3) each.
    """
    position = lattice.particles.position
    return position, displacement + np.cross(rotation, position - lattice.centre)


def middle_half(lattice: Lattice) -> Ints:
    """Select the connected elements whose centres lie in the middle half of the length, as indices, (k,).

    Raises:
        InputError: fewer than 12 elements, too few for a fit.
    """
    particles = lattice.particles
    lower, upper = particles.envelope.bounds
    x = lattice.centre[:, 0]
    inside = np.abs(x - 0.5 * (lower[0] + upper[0])) <= 0.25 * (upper[0] - lower[0])
    chosen = np.flatnonzero(inside & lattice.connected)
    if len(chosen) < 12:
        raise InputError(
            f"lattice: only {len(chosen)} connected elements lie in the middle half of the specimen, less than 12;"
            " use a longer or finer specimen along x"
        )
    return chosen


def curvature(position: PerElement3, displacement: PerElement3, at: float) -> float:
    """Fit the curvature dθ_z/dx at x = `at` [rad/m] to positions and displacements [m], (n, 3).

    A section rotated by θ about z has the displacement u_x = -y θ, the only component used. θ(x) is fitted as a
    parabola, which is exact under a transverse end force.
    """
    x, y, z = position.T
    s = (x - at) / np.ptp(x)
    basis = np.stack([np.ones_like(s), s, y, y * s, y * s * s, z, z * s, z * s * s], axis=1)
    fitted = np.linalg.lstsq(basis, displacement[:, 0], rcond=None)[0]
    return float(-fitted[3] / np.ptp(x))


def twist_rate(position: PerElement3, displacement: PerElement3) -> float:
    """Fit the twist rate dθ_x/dx [rad/m] to positions and displacements [m], (n, 3), of which u_y and u_z count.

    Rotation and shift of the sections are linear in x.
    """
    x, y, z = position.T
    s = (x - x.mean()) / np.ptp(x)
    one, none = np.ones_like(s), np.zeros_like(s)
    shift = np.stack([one, s], axis=1)
    turn_y, turn_z = np.stack([-z, -z * s], axis=1), np.stack([y, y * s], axis=1)
    rest = np.stack([none, none], axis=1)
    basis = np.block([[shift, rest, turn_y], [rest, shift, turn_z]])
    fitted = np.linalg.lstsq(basis, np.concatenate([displacement[:, 1], displacement[:, 2]]), rcond=None)[0]
    return float(fitted[5] / np.ptp(x))


def profile(position: PerElement3, displacement: PerElement3, *, slices: int = 24) -> tuple[Floats, Floats]:
    """Compute the rigid motion of slices along x from positions and displacements [m], (n, 3).

    Returns:
        Mean x of the k slices with at least six points [m], (k,), and the mean displacement and the rotation about x,
        y and z of each [m, rad], (k, 6).
    """
    x = position[:, 0]
    edges = np.linspace(x.min(), x.max(), slices + 1)
    number = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, slices - 1)
    places, motions = [], []
    for k in range(slices):
        part = number == k
        if part.sum() >= 6:
            places.append(x[part].mean())
            motions.append(rigid_motion(position[part], displacement[part]))
    return np.array(places), np.array(motions).reshape(-1, 6)


def rigid_motion(position: Floats, displacement: Floats, weight: Floats | None = None) -> Floats:
    """Fit a rigid motion to points: weighted mean displacement and least-squares rotation [m, rad], (6,).

    Positions and displacements [m] have shape (n, 3), weights (n,); None for equal weights.
    """
    share = np.full(len(position), 1.0 / len(position)) if weight is None else weight / weight.sum()
    shift = share @ displacement
    arm = position - share @ position
    inertia = (share @ arm**2).sum() * np.eye(3) - (share[:, None] * arm).T @ arm
    turn = np.linalg.pinv(inertia, rcond=1e-9, hermitian=True) @ (share @ np.cross(arm, displacement - shift))
    return np.concatenate([shift, turn])
