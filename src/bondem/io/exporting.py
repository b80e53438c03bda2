"""Export of elements, bonds and cells to other programs: LAMMPS, CSV, and the formats of meshio."""

import csv
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem._checks import array, instance, number, place
from bondem._extras import needed
from bondem._types import ArrayLike, Floats, Ints, Pairs, PerElement3
from bondem.errors import InputError
from bondem.io.atomic import replacing, require_writable
from bondem.io.field_names import check_names
from bondem.io.lammps import STRAINED
from bondem.io.vtk_cells import Corners
from bondem.model.state import State
from bondem.specimen.lattice import Lattice

_TABLE, _DATA, _DUMP = (".csv",), (".data", ".lmp", ".lammps"), (".dump", ".lammpstrj")
# Formats of meshio for spheres, with points and lines; for cells, with polyhedra; and for points beside lines.
_MESH, _POLYHEDRA = (".vtu", ".vtk", ".xdmf", ".msh"), (".vtu",)
_MIXED = (".vtu", ".vtk")
# Formats whose fields have 1, 3 or 9 components, and so no quaternions.
_UNTURNED = (".xdmf", ".msh")
_FORMATS = ".csv; .data or .lmp (LAMMPS read_data); .dump or .lammpstrj (LAMMPS, OVITO); " + ", ".join(_MESH)


def export(
    path: str | Path,
    lattice: Lattice,
    *,
    state: State | None = None,
    density: float | None = None,
    elements: Mapping[str, ArrayLike] | None = None,
) -> None:
    """Write elements and bonds for another program, in the format of the suffix.

    `.csv` is a table with a header: x, y, z, radius (for cells: volume), and one column per field component. `.data`
    and `.lmp` are LAMMPS data files of atom_style bpm/sphere with bonds, which `bd.read_lattice` can read; `.dump` is
    a snapshot in the LAMMPS dump format, for OVITO. `.vtu`, `.vtk`, `.xdmf` and `.msh` (gmsh) are written by meshio
    (extra `exchange`) with points and lines, or polyhedra for cells (`.vtu`).

    Units are SI throughout (LAMMPS: `units si`). For ParaView and time series, use `bd.write_vtkhdf` and `out=`.

    Args:
        path: file to write; an existing file is replaced once the new one is complete.
        lattice: elements and bonds, or cells.
        state: state of the elements; adds displacement, velocity and (.vtu, .vtk) orientation; omits broken bonds.
        density: density of the elements [kg/m³], required for LAMMPS data files.
        elements: further fields by name, each (n,), (n, k) or (n, 3, 3), for CSV, dumps and meshio.

    Raises:
        InputError: an unknown format, one that cannot represent these elements, a field of the wrong length or with a
            name that is in use or that the format cannot represent, or a file that cannot be written.
        RunFileError: the disk is full, or another failure to write.
        MissingDependencyError: meshio is not installed.
    """
    path = place("export: path", path)
    instance("export", "lattice", lattice, Lattice, "a lattice")
    suffix = path.suffix.lower()
    writer = _WRITERS.get(suffix)
    if writer is None:
        raise InputError(f"export: path = '{path}': unsupported suffix; give one of {_FORMATS}")
    if suffix not in (*_TABLE, *_DUMP, *_POLYHEDRA):
        lattice.elements.refuse_cells(f"export: '{suffix}' files hold spheres, not cells; give .csv, .dump or .vtu")
    if suffix in _DATA and density is None:
        raise InputError("export: LAMMPS data files need a density; give density= [kg/m³]")
    if density is not None:
        density = number("export", "density", density, unit="kg/m³", above=0.0, advice="a positive density")
    if state is not None:
        instance("export", "state", state, State, "a state of a model of this lattice")
        if len(state.displacement) != len(lattice.particles):
            raise InputError(
                f"export: the state has {len(state.displacement)} elements, the lattice {len(lattice.particles)};"
                " give the lattice of its model"
            )
    frame = _Frame.of(lattice, state, density, elements)
    _check_names(frame, elements or {}, suffix)
    require_writable(path, "file")
    with replacing(path) as new:
        writer(new, frame, suffix)


def refuse_suffix(argument: str, path: Path) -> None:
    """Raise InputError for an HDF5 file with the suffix of a format of `export`, in which programs would read it."""
    if path.suffix.lower() in _WRITERS:
        raise InputError(
            f"{argument} = '{path}': the file is HDF5, not {path.suffix}; give .vtkhdf or .h5, or use bd.export"
        )


def _check_names(frame: "_Frame", given: Mapping[str, ArrayLike], suffix: str) -> None:
    """Reject field names that the format cannot represent, and fields whose columns would have equal names."""
    own = {"x", "y", "z", frame.lattice.elements.size_column[0]}
    if frame.state is not None:
        own |= {"displacement", "velocity"}
    if suffix in _DUMP:
        own |= {"id", "type"} | ({"vx", "vy", "vz"} if frame.state is not None else set())
    check_names("export", given, own=own, forbidden=" " if suffix in (*_DUMP, ".vtk") else "")
    columns = [key for name in frame.fields for key in frame.columns_of(name)]
    twice = next((key for key in columns if columns.count(key) > 1), None)
    if twice is not None and suffix in (*_TABLE, *_DUMP):
        raise InputError(f"export: two fields make a column '{twice}'; give one another name")


@dataclass(frozen=True, eq=False)
class _Frame:
    """Contents of an export.

    Attributes:
        lattice: elements and bonds.
        state: state of the elements, or None.
        position: centres [m], of cells their centroids, (n, 3).
        density: density of the elements [kg/m³], or None.
        fields: fields of the elements by name, each (n,), (n, k) or (n, 3, 3).
    """

    lattice: Lattice
    state: State | None
    position: PerElement3
    density: float | None
    fields: Mapping[str, Floats]

    @classmethod
    def of(
        cls, lattice: Lattice, state: State | None, density: float | None, elements: Mapping[str, ArrayLike] | None
    ) -> "_Frame":
        instance("export", "elements", elements or {}, Mapping, "fields by name")
        fields: dict[str, Floats] = {}
        n = len(lattice.particles)
        if state is not None:
            fields |= {"displacement": state.displacement, "velocity": state.velocity}
        for name, values in (elements or {}).items():
            found = array("export", f"elements['{name}']", values, wanted="numbers of the elements")
            if (found.ndim not in (1, 2) and found.shape[1:] != (3, 3)) or len(found) != n:
                raise InputError(
                    f"export: elements['{name}'] has shape {found.shape}; give ({n},), ({n}, k) or ({n}, 3, 3)"
                )
            fields[name] = found
        position = lattice.centre if state is None else lattice.centre + state.displacement
        return cls(lattice, state, position, density, fields)

    @property
    def pairs(self) -> Pairs:
        """Unbroken bonds, (m, 2)."""
        pairs = self.lattice.pairs
        return pairs if self.state is None else pairs[self.state.bond_integrity > 0.0]

    @property
    def columns(self) -> dict[str, Floats]:
        """Columns of all fields, (n,) each: "NAME_x" … of vectors, "NAME_xx" … of tensors, "NAME_0" … of others."""
        return {key: values for name in self.fields for key, values in self.columns_of(name).items()}

    def columns_of(self, name: str) -> dict[str, Floats]:
        """Return the components of a field, (n,) each, by column name."""
        values = self.fields[name]
        if values.ndim == 1:
            return {name: values}
        if values.ndim == 3:
            return {f"{name}_{a}{b}": values[:, i, j] for i, a in enumerate("xyz") for j, b in enumerate("xyz")}
        ends = "xyz" if values.shape[1] == 3 else range(values.shape[1])
        return {f"{name}_{end}": values[:, k] for k, end in enumerate(ends)}

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper corner of the periodic cell, or of the elements with a margin of 1 % [m], (3,) each."""
        period = self.lattice.particles.period
        if period is not None:
            return np.zeros(3), np.asarray(period, dtype=float)
        radius = self.lattice.particles.radius[:, None]
        lower, upper = (self.position - radius).min(axis=0), (self.position + radius).max(axis=0)
        margin = 0.01 * float((upper - lower).max())
        return lower - margin, upper + margin


def _write_csv(path: Path, frame: _Frame, suffix: str) -> None:
    name, size = frame.lattice.elements.size_column
    columns = {"x": frame.position[:, 0], "y": frame.position[:, 1], "z": frame.position[:, 2], name: size}
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow([*columns, *frame.columns])
        for row in zip(*columns.values(), *frame.columns.values(), strict=True):
            table.writerow([repr(float(value)) for value in row])


def _write_data(path: Path, frame: _Frame, suffix: str) -> None:
    """Write atoms of style bpm/sphere (id, molecule, type, diameter, density, x, y, z), velocities and bonds."""
    diameter, pairs = 2.0 * frame.lattice.particles.radius, frame.pairs
    with open(path, "w", encoding="utf-8") as file:
        strained = f", {STRAINED}" if frame.state is not None and np.any(frame.state.displacement) else ""
        file.write(f"LAMMPS data file of bondem: units si, atom_style bpm/sphere{strained}\n\n")
        file.write(f"{len(diameter)} atoms\n{len(pairs)} bonds\n1 atom types\n1 bond types\n")
        # room in LAMMPS for the bonds of the element with most bonds, and for one more special neighbour than that
        most = int(np.bincount(pairs.ravel(), minlength=1).max()) if len(pairs) else 0
        file.write(f"{most} extra bond per atom\n{most + 1} extra special per atom\n\n")
        for axis, low, high in zip("xyz", *frame.bounds, strict=True):
            file.write(f"{float(low)!r} {float(high)!r} {axis}lo {axis}hi\n")
        file.write("\nAtoms # bpm/sphere\n\n")
        for k, (size, place) in enumerate(zip(diameter.tolist(), frame.position.tolist(), strict=True), start=1):
            file.write(f"{k} 1 1 {size!r} {frame.density!r} {' '.join(map(repr, place))}\n")
        if frame.state is not None:
            file.write("\nVelocities\n\n")
            both = np.hstack([frame.state.velocity, frame.state.angular_velocity]).tolist()
            file.writelines(f"{k} {' '.join(map(repr, row))}\n" for k, row in enumerate(both, start=1))
        if len(pairs):
            file.write("\nBonds\n\n")
            file.writelines(f"{k} 1 {i + 1} {j + 1}\n" for k, (i, j) in enumerate(pairs.tolist(), start=1))


def _write_dump(path: Path, frame: _Frame, suffix: str) -> None:
    edge = "ff ff ff" if frame.lattice.particles.period is None else "pp pp pp"
    name, size = frame.lattice.elements.size_column
    step, columns = 0, frame.columns
    if frame.state is not None:
        velocity = {f"v{axis}": columns.pop(f"velocity_{axis}") for axis in "xyz"}
        step, columns = frame.state.step, velocity | columns
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(size)}\nITEM: BOX BOUNDS {edge}\n")
        file.writelines(f"{float(low)!r} {float(high)!r}\n" for low, high in zip(*frame.bounds, strict=True))
        file.write(f"ITEM: ATOMS id type x y z {' '.join([name, *columns])}\n")
        rows = np.column_stack([frame.position, size, *columns.values()]).tolist()
        file.writelines(f"{k} 1 {' '.join(map(repr, row))}\n" for k, row in enumerate(rows, start=1))


def _write_mesh(path: Path, frame: _Frame, suffix: str) -> None:
    meshio = needed("meshio", "exchange")
    name, size = frame.lattice.elements.size_column
    turned = {} if frame.state is None or suffix in _UNTURNED else {"orientation": frame.state.orientation}
    flat = {key: values.reshape(len(values), -1) for key, values in frame.fields.items() if values.ndim == 3}
    fields = {name: size, **turned, **frame.fields, **flat}
    if frame.lattice.cells is not None:
        points, blocks, order = _polyhedra(frame)
        data = {key: [values[chosen] for chosen in order] for key, values in fields.items()}
        mesh = meshio.Mesh(points, blocks, cell_data=data)
    else:
        lines, vertices = [("line", frame.pairs)], [("vertex", np.arange(len(size))[:, None])]
        # the other formats take one kind of cell, and keep points without a cell
        mesh = meshio.Mesh(frame.position, vertices + lines if suffix in _MIXED else lines, point_data=fields)
    meshio.write(path, mesh, file_format={".msh": "gmsh"}.get(suffix, suffix[1:]))


def _polyhedra(frame: _Frame) -> tuple[Floats, list[tuple[str, Any]], list[Ints]]:
    """Return points [m], (c, 3), cells in blocks of equal corner counts for meshio, and cell numbers by block."""
    corners = Corners(frame.lattice)
    points = corners.place if frame.state is None else corners.moved(frame.lattice, frame.state)
    faces: list[list[Ints]] = [[] for _ in frame.position]
    for polygon, cell in enumerate(corners.polygon_cell.tolist()):
        faces[cell].append(corners.number[corners.start[polygon] : corners.start[polygon + 1]])
    count = np.bincount(corners.cell, minlength=len(faces))
    order = [np.flatnonzero(count == kind) for kind in np.unique(count)]
    blocks = [(f"polyhedron{count[chosen[0]]}", [faces[k] for k in chosen]) for chosen in order]
    return points, blocks, order


_Writer = Callable[[Path, _Frame, str], None]
_WRITERS: dict[str, _Writer] = {
    **dict.fromkeys(_TABLE, _write_csv), **dict.fromkeys(_DATA, _write_data), **dict.fromkeys(_DUMP, _write_dump),
    **dict.fromkeys(_MESH, _write_mesh),
}  # fmt: skip
