"""Assignment of laws to bonds: one law for all, or laws by region."""

from collections.abc import Mapping

import numpy as np

from bondem._checks import instance
from bondem._types import Mask
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region, as_region

BondAssignment = BondLaw | Mapping[Region | tuple[Region, Region], BondLaw]


def bond_geometry(lattice: Lattice) -> BondGeometry:
    """Return the geometry of the bonds of a lattice, the input of bond laws, user's order."""
    i, j = lattice.pairs.T
    r = lattice.particles.radius
    return BondGeometry(lattice.length, r[i], r[j], lattice.elements.mean_radii[i])


def bond_stiffness(lattice: Lattice, bond: BondAssignment | None) -> tuple[BondStiffness, str]:
    """Return the stiffnesses of all bonds in the user's order, and the formulation, "total" or "incremental".

    With a mapping, the bonds within a region follow its law, and bonds between two regions follow the law of the
    pair. Later entries override earlier ones.

    Raises:
        InputError: A bond of connected elements has no law, a law or key is no law or region, or formulations differ.
        EmptyRegionError: A region has no elements.
    """
    if bond is None:
        if len(lattice.pairs):
            raise InputError("bond = None: the lattice has bonds; give a bond law, or a lattice without bonds")
        return BondStiffness.empty(0), "total"
    i, j = lattice.pairs.T
    geometry = bond_geometry(lattice)
    if isinstance(bond, BondLaw):
        return bond.stiffness(geometry), bond.formulation
    if not isinstance(bond, Mapping) or not bond:
        raise InputError("bond= is not a bond law; give one, or a mapping {region: law, (region, region): law}")
    laws = [instance("Model", "bond", law, BondLaw, "a bond law") for law in bond.values()]
    ends = [ends_of("bond=", where, lattice) for where in bond]
    formulations = {law.formulation for law in bond.values()}
    if len(formulations) > 1:
        raise InputError("all bond laws of one model must share a formulation; choose 'total' or 'incremental'")
    table = BondStiffness.empty(len(lattice.pairs))
    for (a, b), law in zip(ends, laws, strict=True):
        chosen = np.flatnonzero((a[i] & b[j]) | (b[i] & a[j]))
        table.put(chosen, law.stiffness(geometry.take(chosen)))
    bare = np.flatnonzero(np.isnan(table.kn) & lattice.connected[i])
    if bare.size:
        raise InputError(
            f"{bare.size} bonds follow no law, the first between elements {i[bare[0]]} and {j[bare[0]]};"
            " add an entry for their region, or (region, region): law for bonds between two regions"
        )
    table.put(np.isnan(table.kn), BondStiffness(*(np.zeros(1) for _ in range(6))))
    return table, formulations.pop()


def ends_of(argument: str, where: object, lattice: Lattice) -> tuple[Mask, Mask]:
    """Return masks of the elements at both ends of bonds for the key `where`, a region or two regions, (n,) each.

    Raises:
        InputError: The key is something else; the message begins with `argument`.
        EmptyRegionError: A region has no elements.
    """
    pair = where if isinstance(where, tuple) else (where, where)
    if len(pair) != 2:
        raise InputError(f"{argument} names {len(pair)} regions for bonds of two ends; give (region, region): law")
    first, second = (as_region(argument, side) for side in pair)
    return first.with_rattlers(lattice), second.with_rattlers(lattice)
