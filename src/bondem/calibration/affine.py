"""Affine (Voigt) estimate of the moduli of a lattice, as a sum over its bonds.

The estimate assumes that all elements move with the mean strain.
"""

import math
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerBond
from bondem.errors import InputError
from bondem.interactions.beams.assignment import BondAssignment, bond_stiffness
from bondem.labtests.isotropic import Isotropic
from bondem.specimen.lattice import Lattice

# Voigt order xx, yy, zz, yz, xz, xy, with engineering shear strains.
_VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))

# Largest relative difference between section times length and the volume of a bar [-].
_PRISM = 0.01


@dataclass(frozen=True, eq=False)
class AffineEstimate:
    """Moduli of a lattice whose elements follow the mean strain, and the quantities that govern their relaxation.

    Attributes:
        stiffness: C = 1/V Σ kn δn δn + ks δs·δs [Pa], (6, 6), with δn and δs the elongation and shear of each bond by
            the unit strains xx, yy, zz, yz, xz, xy.
        E: Young's modulus [Pa]: along x for a bar, otherwise that of the isotropic average over 1 - `wall`.
        nu: Poisson's ratio [-]: along x for a bar, otherwise that of the isotropic average.
        coordination: mean over the bonds of the mean number of bonds of their two elements [-].
        looseness: mean over the bonds of 1/z_i + 1/z_j, with z the number of bonds of an element [-].
        wall: R̄ S_side / V of a bar with the side area S_side, R̄ S / (2 V) of other shapes with the surface S [-];
            0 for periodic cells.
        shear: ratio Σ ks L² / Σ kn L² [-].
        bending: ratio Σ kb / Σ kn L² [-].
    """

    stiffness: Floats
    E: float
    nu: float
    coordination: float
    looseness: float
    wall: float
    shear: float
    bending: float


def is_bar(lattice: Lattice) -> bool:
    """Return True if the section of the shape is constant along x, so that its middle half can gauge tension."""
    shape = lattice.particles.envelope
    return bool(shape.faces) and abs(shape.section() * shape.extent / shape.volume - 1.0) <= _PRISM


def affine_estimate(lattice: Lattice, law: BondAssignment, *, bar: bool | None = None) -> AffineEstimate:
    """Compute the affine estimate of a lattice.

    For a bar, the sum is over the bonds in the middle half of its length, as in `static_tension`. For other shapes
    and periodic cells the sum is over all bonds, and E and ν are those of the isotropic average. Loads act at centres
    of elements, a radius below the walls. A surface S has the mean projected area S/4 (Cauchy), so that the loaded
    volume is smaller than the body by R̄ S/2. E of other shapes than bars is therefore divided by 1 - `wall`.

    Args:
        lattice: elements and bonds.
        law: bond law, or laws by region.
        bar: True to treat the lattice as a bar; None to use `is_bar`.

    Raises:
        InputError: Bonds do not resist every strain, such as those of a plane lattice, or there are several bodies.
    """
    lattice.bodies.require_one("affine_estimate")
    k, _ = bond_stiffness(lattice, law)
    shape, particles = lattice.particles.envelope, lattice.particles
    bar = is_bar(lattice) if bar is None else bar
    moving = lattice.connected[lattice.pairs[:, 0]].astype(float)
    if bar:
        weight, volume = moving * _inside_gauge(lattice), 0.5 * shape.extent * shape.section()
        surface = 0.5 * (shape.area - 2.0 * shape.section())
    else:
        period = particles.period
        weight, volume = moving, shape.volume if period is None else float(period.prod())
        surface = 0.5 * shape.area if period is None else 0.0
    bonds = np.bincount(lattice.pairs.ravel(), minlength=len(particles))[lattice.pairs]
    square = weight * lattice.length**2
    normal = float(k.kn @ square)
    stiffness = _sum(lattice, weight * k.kn, weight * k.ks) / volume
    wall = particles.mean_radius * surface / volume
    E, nu = _along_x(stiffness) if bar else _isotropic(stiffness)
    if not bar:
        least, *_, most = np.linalg.eigvalsh(stiffness)
        E = E / (1.0 - wall) if least > 1e-9 * most else math.nan
    if not (math.isfinite(E) and E > 0.0):
        raise InputError("lattice: its bonds do not resist every strain; pack a body, not a chain or a plane")
    return AffineEstimate(
        stiffness, E, nu, coordination=float(np.average(bonds.mean(axis=1), weights=weight)),
        looseness=float(np.average((1.0 / bonds).sum(axis=1), weights=weight)), wall=wall,
        shear=float(k.ks @ square) / normal, bending=float(k.kb @ weight) / normal,
    )  # fmt: skip


def _inside_gauge(lattice: Lattice) -> PerBond:
    """Share of the extent of each bond along x that lies in the middle half of the specimen [-], (m,)."""
    lower, upper = lattice.particles.envelope.bounds
    x = lattice.particles.position[:, 0] - 0.5 * (lower[0] + upper[0])
    half = 0.25 * (upper[0] - lower[0])
    middle = x[lattice.pairs].mean(axis=1)
    # bonds across x, as in a crystal, have an extent too, however small
    reach = 0.5 * np.maximum(np.abs(lattice.branch[:, 0]), 1e-9 * lattice.length)
    return np.clip(0.5 * (np.minimum(middle + reach, half) - np.maximum(middle - reach, -half)) / reach, 0.0, 1.0)


def _sum(lattice: Lattice, normal: PerBond, shear: PerBond) -> Floats:
    direction = lattice.branch / lattice.length[:, None]
    slip = np.zeros((6, *lattice.branch.shape))
    for s, (a, b) in enumerate(_VOIGT):
        slip[s, :, a] += 0.5 * lattice.branch[:, b]
        slip[s, :, b] += 0.5 * lattice.branch[:, a]
    along = np.einsum("smi,mi->sm", slip, direction)
    across = slip - along[:, :, None] * direction
    return (along * normal) @ along.T + np.einsum("smi,m,tmi->st", across, shear, across, optimize=True)


def _along_x(stiffness: Floats) -> tuple[float, float]:
    try:
        compliance = np.linalg.inv(stiffness)
    except np.linalg.LinAlgError:
        return math.nan, math.nan
    return float(1.0 / compliance[0, 0]), float(-0.5 * (compliance[0, 1] + compliance[0, 2]) / compliance[0, 0])


def _isotropic(stiffness: Floats) -> tuple[float, float]:
    mean = Isotropic.average(stiffness)
    return mean.E, mean.nu
