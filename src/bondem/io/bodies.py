"""Elements, bonds, facets and cells of a body in an HDF5 file, bit for bit: reading does not repeat the tessellation.

`/elements` has positions and radii, and the edges of a periodic cell.
`/facets` has the arrays of `Facets`, `/cells` those of `Cells`, `/cells/free` those of `FreeFacets`, by name.
A scene of several bodies has `/bodies/label`, with names and shapes as JSON in the attributes of that group.
"""

import json
from dataclasses import fields

import h5py
import numpy as np

from bondem.geometry.shape import Shape
from bondem.io.codec import decode, encode
from bondem.io.hdf5 import array_at
from bondem.io.older_bodies import LACKING, balanced_body
from bondem.specimen.bodies import Bodies
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles, filled, freeze
from bondem.specimen.tessellation.facets import Cells, Facets, FreeFacets


def write_elements(file: h5py.File, particles: Particles) -> None:
    """Write positions and radii of elements, and the period of a periodic cell."""
    file["elements/position"], file["elements/radius"] = particles.position, particles.radius
    if particles.period is not None:
        file["elements/period"] = particles.period


def read_elements(file: h5py.File, shape: Shape | None) -> Particles:
    """Read the elements that `write_elements` wrote, with the shape that they fill.

    Raises:
        KeyError, ValueError: An array is missing, or is no array.
    """
    period = array_at(file, "elements/period") if "elements/period" in file else None
    # a carved packing may extend beyond its shape, which `Particles` would reject
    return filled(Particles(array_at(file, "elements/position"), array_at(file, "elements/radius"), period), shape)


def write_bonds(file: h5py.File, lattice: Lattice) -> None:
    """Write the bonds of a lattice, the bodies of a scene of several, and any facets and cells."""
    file["bonds/pairs"] = lattice.pairs
    if len(lattice.names) > 1:
        file["bodies/label"] = lattice.body
        for name in ("names", "shapes"):
            file["bodies"].attrs[name] = json.dumps(encode(getattr(lattice.bodies, name)))
    complete_body(file, lattice)


def complete_body(file: h5py.File, lattice: Lattice) -> None:
    """Write those arrays of the facets and cells of a body that a file does not have yet."""
    for place, table in lattice.elements.tables.items():
        group = file.require_group(place)
        for item in fields(table):
            if item.name != "free" and item.name not in group:
                group[item.name] = getattr(table, item.name)


def read_bonds(file: h5py.File, particles: Particles) -> Lattice:
    """Read the lattice that `write_bonds` wrote, for given particles.

    A body of an older file, without shares, gets balanced shares.

    Raises:
        KeyError: an array is missing.
        ValueError: an array has the wrong length, or numbers of bodies or cells that do not exist.
    """
    pairs, bodies = array_at(file, "bonds/pairs"), None
    if "bodies" in file:
        label = freeze(array_at(file, "bodies/label"))
        names, shapes = (decode(json.loads(file["bodies"].attrs[name])) for name in ("names", "shapes"))
        if label.shape != (len(particles),) or not 0 <= label.min() <= label.max() < len(names) == len(shapes):
            raise ValueError(f"bodies/label does not number {len(names)} bodies of {len(particles)} elements")
        bodies = Bodies(label, names, shapes)
    if "facets" not in file:
        return Lattice(particles, pairs, bodies=bodies)
    n, m = len(particles), len(pairs)
    older = "facets/share_i" not in file
    free = _table(file, "cells/free", FreeFacets, len(array_at(file, "cells/free/cell")), older)
    cell = free["cell"]
    if len(cell) and not 0 <= cell.min() <= cell.max() < n:
        raise ValueError(f"cells/free/cell has numbers beyond 0 … {n - 1}")
    facets, cells = _table(file, "facets", Facets, m, older), _table(file, "cells", Cells, n, older)
    if older:
        return balanced_body(particles, pairs, facets, cells, free)
    made = Cells(**cells, free=FreeFacets(**free))
    return Lattice(particles, pairs, facets=Facets(**facets), cells=made, bodies=bodies)


def _table(file: h5py.File, place: str, kind: type, count: int, older: bool) -> dict[str, np.ndarray]:
    found: dict[str, np.ndarray] = {}
    for item in fields(kind):
        if item.name == "free" or (older and item.name in LACKING[kind]):
            continue
        found[item.name] = freeze(array_at(file, f"{place}/{item.name}"))
        if len(found[item.name]) != count:
            raise ValueError(f"{place}/{item.name} has {len(found[item.name])} rows, not {count}")
    return found
