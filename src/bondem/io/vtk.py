"""Lattices for ParaView as VTKHDF: elements as points with bonds as lines, or cells as polyhedra."""

from collections.abc import Mapping
from pathlib import Path

import h5py
import numpy as np

from bondem._checks import array, instance, place
from bondem._types import ArrayLike
from bondem.errors import InputError
from bondem.io.exporting import refuse_suffix
from bondem.io.field_names import check_names
from bondem.io.hdf5 import put
from bondem.io.vtk_cells import drawn_bonds, fields_of_bodies, fields_of_cells, fields_of_motion, write_cells
from bondem.io.vtk_polygons import poly_data
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.statics.static import StaticResult


def write_vtkhdf(
    path: str | Path,
    lattice: Lattice,
    *,
    state: State | StaticResult | None = None,
    elements: Mapping[str, ArrayLike] | None = None,
    bonds: Mapping[str, ArrayLike] | None = None,
) -> None:
    """Write a lattice as VTKHDF PolyData, which ParaView 5.11 and later opens; glyphs scale with `radius`.

    A body of cells is written as polyhedra (ParaView 6.0 and later), with `elements` as fields of the cells. For a
    state under `CellBond`, the file also has the mean stress of each cell, its dilatation θ and λ θ (λ of Lamé).

    A static solution adds displacement, rotation, reaction and reaction_moment, and the stress of each element with
    its principal_stresses (σ1, σ2, σ3) and von_mises_stress. Elements are at their displaced positions.

    Bonds that cross the border of a periodic cell are omitted, as their lines would cross the whole cell.

    Args:
        path: file to write, usually with the suffix .vtkhdf; a suffix of `bd.export`, such as .vtu, raises an error.
        lattice: elements and bonds.
        state: state or static solution of the elements; a state adds displacement, orientation as a quaternion (w, x,
            y, z), velocity, angular velocity and integrity. Cells move and turn with it.
        elements: further fields by name, each (n,) or (n, k).
        bonds: further fields of the bonds by name, each (m,) or (m, k).

    Raises:
        InputError: the file cannot be written, the state is of another lattice, a field has the wrong length or a
            name in use, `bonds` is given for cells, or a state with cracks was changed after its last step.
        RunFileError: the disk is full, or another failure to write.
    """
    path = place("write_vtkhdf: path", path)
    refuse_suffix("write_vtkhdf: path", path)
    instance("write_vtkhdf", "lattice", lattice, Lattice, "a lattice")
    if state is not None:
        wanted = "a state, or a solution of bd.solve_static, of a model of this lattice"
        instance("write_vtkhdf", "state", state, (State, StaticResult), wanted)
        if len(state.displacement) != len(lattice.particles):
            raise InputError(
                f"write_vtkhdf: the state has {len(state.displacement)} elements, the lattice"
                f" {len(lattice.particles)}; give the lattice of its model"
            )
    for name, given in (("elements", elements), ("bonds", bonds)):
        instance("write_vtkhdf", name, given or {}, Mapping, "fields by name")
    if lattice.cells is not None:
        if bonds:
            raise InputError("write_vtkhdf: a body is written as cells, without lines for bonds=; leave it out")
        own = fields_of_cells(lattice, state)
        check_names("write_vtkhdf", elements or {}, own=own, forbidden="/")
        given = own | dict(elements or {})
        checked = {name: _checked(name, field, len(lattice.particles)) for name, field in given.items()}
        write_cells(path, lattice, state.state if isinstance(state, StaticResult) else state, checked)
        return
    particles = lattice.particles
    points = particles.position if state is None else particles.position + state.displacement
    of_elements: dict[str, ArrayLike] = {"radius": particles.radius, "connected": lattice.connected.astype(np.int8)}
    of_bonds: dict[str, ArrayLike] = {"length": lattice.length}
    of_elements |= fields_of_bodies(lattice)
    of_elements |= fields_of_motion(state)
    if isinstance(state, State):
        of_bonds["integrity"] = state.bond_integrity
    for added, own in ((elements, of_elements), (bonds, of_bonds)):
        check_names("write_vtkhdf", added or {}, own=own, forbidden="/")
    drawn = drawn_bonds(lattice)
    lines = lattice.pairs[drawn]
    with poly_data(path, points, "Lines", 2 * np.arange(len(lines) + 1), lines.ravel()) as root:
        _write_fields(root.create_group("PointData"), of_elements | dict(elements or {}), len(points))
        _write_fields(root.create_group("CellData"), of_bonds | dict(bonds or {}), len(lattice.pairs), drawn)


def _write_fields(
    group: h5py.Group, fields: Mapping[str, ArrayLike], count: int, chosen: np.ndarray | None = None
) -> None:
    for name, field in fields.items():
        values = _checked(name, field, count)
        put(group, name, values if chosen is None else values[chosen])


def _checked(name: str, field: ArrayLike, count: int) -> np.ndarray:
    values = array("write_vtkhdf", f"field '{name}'", field, wanted=f"one row for each of {count}")
    values = values.astype(np.asarray(field).dtype)  # integers remain integers
    if values.shape[:1] != (count,):
        raise InputError(f"field '{name}' has {len(values) if values.ndim else 1} values; give {count}")
    return values
