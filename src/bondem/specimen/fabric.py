"""Geometric quality of a lattice: density, contacts, overlaps and isotropy, with a verdict."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import instance
from bondem._types import Floats, Ints, Mask, PerBond3, Vector
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.specimen.direction_sphere import direction_sphere
from bondem.specimen.filling import unfilled
from bondem.specimen.interior import core_solid, region, solid_fraction
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import freeze
from bondem.specimen.strata import Strata, strata

# The verdict rests on effect sizes, which do not depend on the number of elements, and on the core: walls order the
# bonds of the elements that touch them, whose share depends on the size of the specimen.
# Measured: cores of cylinders (length four diameters, κ = 25 %) reach an rms excess of 0.35 ± 0.11 at 1000 spheres
# and 0.11 above 4000, cores that crystallised between flat walls (κ = 0) 0.4 to 2, a cubic crystal 5.
_CORE_DEPTH = 2.0  # mean radii from wall to centre
_CORE_BONDS = 100  # least number for a verdict on isotropy
_RMS_EXCESS = 0.3
_STRETCH = 0.1
_CHANCE = 3.0  # standard deviations by which chance may exceed a limit
_COORDINATION = (4.5, 18.0)
_RATTLERS = 0.05
# Layers along a wall decay within about a diameter and a half; deeper inside, a specimen should be homogeneous.
_DEEP = 3.0  # mean radii from the wall
_EMPTY = 2.0  # mean radii from a wall to the nearest sphere, from which the spheres do not fill the shape
_FIXING = 4  # least number of contacts that fix a sphere
_TOUCH = 1e-6  # mean radii
_STRATA = {"density": 0.03, "coordination": 0.06, "size": 0.35, "layers": 0.6}
#: Limits of the verdict by measure [-], without the allowance for chance.
LIMITS = {"rms_excess": _RMS_EXCESS, "stretch": _STRETCH, "rattlers": _RATTLERS, **_STRATA}

_DOF = 159  # 160 pairs of opposite faces, less the total


@dataclass(frozen=True, eq=False)
class Fabric:
    """Geometric quality of a lattice.

    Attributes:
        volume_fraction: φ, volume of the spheres over that of the shape [-]; overlaps count twice.
        coordination_number: z = 2 bonds / elements, over all elements [-].
        coordination_histogram: number of elements with 0, 1, 2, ... bonds.
        rattlers: number of elements in small pieces without bonds to the body.
        core_volume_fraction: φ of the core, which lies three mean radii or more from every wall [-]; NaN without a
            core. The volume of the core is exact for cylinder, box, ball and cell. Spheres cut by its border are
            divided by evenly spread points, at most 256 each: ± 0.003 at 1000 spheres, ± 0.001 at 10 000.
        loose: number of elements with fewer than four contacts with walls and other elements, counted repeatedly
            without the elements already found: rattlers in the sense of jamming.
        backbone_coordination_number: mean number of bonds among elements that are not `loose` [-]; NaN if all are.
        backbone_histogram: number of elements that are not `loose` with 0, 1, 2, ... bonds among them.
        fineness: edge of the cube with the volume of the shape, over the mean diameter [-].
        smallest_extent: smallest extent of the shape along x, y or z, over the mean diameter [-].
        strata: differences between slices of the core across x, y and z, and layers; near 0 in a homogeneous packing.
        largest_overlap: largest overlap of two bonded spheres, over R̄ [-]; 0 without overlaps.
        isotropy_error: e of André et al. (2012), eq 11 [-]: mean square difference between the frequencies of bond
            directions on the faces of `direction_sphere()` and 1/320. It is at most 319/320², so the limit of
            0.0032 in the paper excludes nothing.
        chi2_per_dof: χ² over the 160 pairs of opposite faces, with their true solid angles, per degree of freedom
            [-]. It is 1 ± 0.11 for a random isotropic fabric, and grows with the sample for any other.
        rms_excess: √((χ² - dof) / bonds) [-]: relative rms deviation of the directional density from isotropy,
            beyond chance; it does not depend on the size of the sample.
        face_counts: number of bond directions, both ways, on each face of `direction_sphere()`, shape (320,).
        face_density: `face_counts` over the counts of an isotropic fabric, shape (320,) [-].
        core_rms_excess: `rms_excess` of the core bonds: those of elements whose centres lie two mean radii or more
            from every wall [-]; NaN without such bonds.
        core_stretch: largest relative difference of an eigenvalue of the fabric tensor of the core bonds from 1/3
            [-]; NaN without such bonds.
        fabric_tensor: mean of n ⊗ n over the bond directions, shape (3, 3) [-]; its trace is 1.
        eigenvalues: eigenvalues of the fabric tensor, in ascending order, (3,); 1/3 each when isotropic.
        reasons: defects of the lattice, one sentence each; empty for a good lattice.
    """

    volume_fraction: float
    coordination_number: float
    coordination_histogram: Ints
    rattlers: int
    core_volume_fraction: float
    loose: int
    backbone_coordination_number: float
    backbone_histogram: Ints
    fineness: float
    smallest_extent: float
    strata: Strata
    largest_overlap: float
    isotropy_error: float
    chi2_per_dof: float
    rms_excess: float
    face_counts: Ints
    face_density: Floats
    core_rms_excess: float
    core_stretch: float
    fabric_tensor: Floats
    eigenvalues: Vector
    reasons: tuple[str, ...]

    @property
    def passed(self) -> bool:
        """Verdict: True if the lattice is fit for an isotropic, homogeneous material."""
        return not self.reasons


def fabric(lattice: Lattice) -> Fabric:
    """Measure the geometric quality of a lattice.

    Args:
        lattice: elements and their bonds.

    Returns:
        Measures and a verdict. The verdict rests on effect sizes, which do not depend on the number of elements.

    Raises:
        InputError: The lattice has no bonds, or several bodies.
    """
    instance("fabric", "lattice", lattice, Lattice, "a lattice, from bd.connect or bd.Lattice")
    if not len(lattice.pairs):
        raise InputError(
            f"fabric: the lattice of {len(lattice.particles)} elements has no bonds; bond it with bd.connect"
        )
    lattice.bodies.require_one("fabric")
    particles = lattice.particles
    n, m = len(particles), len(lattice.pairs)
    direction = lattice.branch / lattice.length[:, None]
    all_of_them = _isotropy(direction)
    shape, R = region(particles), particles.mean_radius
    inside = shape.depth(particles.position) >= _CORE_DEPTH * R
    core = _isotropy(direction[inside[lattice.pairs].all(axis=1)])
    # between the centres of spheres, because cells have their centres of mass elsewhere
    i, j = lattice.pairs.T
    between = particles.nearest(particles.position[j] - particles.position[i])
    overlap = particles.radius[i] + particles.radius[j] - np.linalg.norm(between, axis=1)
    z, bonds = lattice.coordination_number, np.bincount(lattice.pairs.ravel(), minlength=n)
    fixed = _fixed(lattice, shape)
    backbone = np.bincount(lattice.pairs[fixed[lattice.pairs].all(axis=1)].ravel(), minlength=n)[fixed]
    core_spheres = core_solid(particles, shape, _DEEP * R)
    slices = strata(shape, particles.position, particles.radius, bonds, core_spheres, _DEEP * R)
    lower, upper = shape.bounds
    empty = unfilled(shape, particles.position, particles.radius, away=_EMPTY)
    return Fabric(
        volume_fraction=float(particles.volume.sum()) / shape.volume,
        coordination_number=z,
        coordination_histogram=freeze(np.bincount(bonds)),
        rattlers=lattice.rattlers,
        core_volume_fraction=solid_fraction(shape, core_spheres, _DEEP * R),
        loose=int(n - fixed.sum()),
        backbone_coordination_number=float(backbone.mean()) if len(backbone) else np.nan,
        backbone_histogram=freeze(np.bincount(backbone)),
        fineness=float(np.cbrt(shape.volume) / (2.0 * R)),
        smallest_extent=float((upper - lower).min() / (2.0 * R)),
        strata=slices,
        largest_overlap=max(0.0, float(overlap.max())) / R,
        isotropy_error=float(np.mean((all_of_them.counts / (2.0 * m) - 1.0 / len(all_of_them.counts)) ** 2)),
        chi2_per_dof=all_of_them.chi2 / _DOF,
        rms_excess=_rms(all_of_them),
        face_counts=freeze(all_of_them.counts),
        face_density=freeze(all_of_them.density),
        core_rms_excess=_rms(core),
        core_stretch=_stretch(core),
        fabric_tensor=freeze(all_of_them.tensor),
        eigenvalues=freeze(np.linalg.eigvalsh(all_of_them.tensor)),
        reasons=(
            *_isotropy_reasons(core),
            # empty parts would also appear in the strata
            *(empty or _strata_reasons(slices)),
            *_contact_reasons(z, lattice.rattlers / n),
        ),
    )


def _fixed(lattice: Lattice, shape: Shape) -> Mask:
    """Return a mask of the elements with four contacts or more, after removing all others repeatedly, (n,)."""
    particles = lattice.particles
    walls = np.zeros(len(particles), dtype=np.int64)
    for face in shape.faces:
        walls += shape.face_depth(face, particles.position) <= particles.radius + _TOUCH * particles.mean_radius
    fixed, pairs = np.ones(len(particles), dtype=bool), lattice.pairs
    while True:
        pairs = pairs[fixed[pairs].all(axis=1)]
        still = fixed & (np.bincount(pairs.ravel(), minlength=len(particles)) + walls >= _FIXING)
        if (still == fixed).all():
            return fixed
        fixed = still


@dataclass(frozen=True, eq=False)
class _Isotropy:
    bonds: int
    counts: Ints
    density: Floats
    chi2: float
    tensor: Floats


def _isotropy(direction: PerBond3) -> _Isotropy:
    sphere, m = direction_sphere(), len(direction)
    one_way = np.bincount(sphere.face_of(direction), minlength=len(sphere.faces))
    counts = one_way + one_way[sphere.opposite]
    expected = 2.0 * max(m, 1) * sphere.solid_angle / (4.0 * np.pi)
    # A class is a face and its antipode, so that the sum over all faces counts every class twice.
    chi2 = 0.5 * float(((counts - expected) ** 2 / expected).sum())
    return _Isotropy(m, counts, counts / expected, chi2, direction.T @ direction / max(m, 1))


def _rms(found: _Isotropy) -> float:
    return float(np.sqrt(max(found.chi2 - _DOF, 0.0) / found.bonds)) if found.bonds else np.nan


def _stretch(found: _Isotropy) -> float:
    return float(np.abs(3.0 * np.linalg.eigvalsh(found.tensor) - 1.0).max()) if found.bonds else np.nan


def _isotropy_reasons(core: _Isotropy) -> list[str]:
    m = core.bonds
    if m < _CORE_BONDS:
        return [f"only {m} bonds lie inside, away from the walls: too few to judge isotropy; use more elements"]
    found = []
    # Standard deviations for a random isotropic fabric: √(2 dof) of χ², and √(4/5) of 3 n_x² - 1.
    if core.chi2 - _DOF > m * _RMS_EXCESS**2 + _CHANCE * np.sqrt(2.0 * _DOF):
        found.append(
            f"bond directions away from the walls deviate from isotropy by {_rms(core):.0%} rms, more than"
            f" {_RMS_EXCESS:.0%}: the packing is ordered; spread the radii more or use more elements"
        )
    if _stretch(core) > _STRETCH + _CHANCE * np.sqrt(0.8 / m):
        found.append(
            f"an eigenvalue of the fabric tensor away from the walls is {_stretch(core):.0%} off 1/3, more than"
            f" {_STRETCH:.0%}: the bonds prefer a direction"
        )
    return found


def _strata_reasons(found: Strata) -> list[str]:
    reasons = []
    for what, values, name, advice in (
        ("the solid fraction", found.density, "density", "compress it evenly, without gravity"),
        ("the coordination number", found.coordination, "coordination", "compress it evenly, without gravity"),
        ("the mean radius", found.size, "size", "mix the sizes: they have parted"),
    ):
        if (values > _STRATA[name]).any():
            axis = int(np.nanargmax(values))
            of = " of the standard deviation of the radii" if name == "size" else ""
            reasons.append(
                f"{what} differs by {values[axis]:.0%} rms{of} between slices along {'xyz'[axis]}, more than"
                f" {_STRATA[name]:.0%}: the packing is in strata; {advice}"
            )
    if (found.layers > _STRATA["layers"]).any():
        axis = int(np.nanargmax(found.layers))
        reasons.append(
            f"centres lie in layers along {'xyz'[axis]}, of amplitude {found.layers[axis]:.0%}, more than"
            f" {_STRATA['layers']:.0%}: the packing was deposited or is ordered; spread the radii more"
        )
    return reasons


def _contact_reasons(z: float, rattling: float) -> list[str]:
    found = []
    least, most = _COORDINATION
    if not least <= z <= most:
        found.append(f"the coordination number {z:.2f} is not between {least:g} and {most:g}")
    if rattling > _RATTLERS:
        found.append(f"{rattling:.1%} of the elements are rattlers, more than {_RATTLERS:.0%}; pack more densely")
    return found
