"""Import of spheres from files: choice of the reader, and checks common to all formats."""

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import instance, number, place, require_file, shown, vector
from bondem._names import users_line
from bondem._plausibility import is_long
from bondem._types import ArrayLike, Pairs
from bondem._units import length_unit
from bondem.errors import DisconnectedError, InputError, StressFreeWarning, UnitWarning
from bondem.geometry.elementary_shapes import Shape
from bondem.io.lammps import read_lammps
from bondem.io.lammps_dump import read_dump
from bondem.io.particles_file import load_bonded, load_lattice
from bondem.io.raw_spheres import RawSpheres
from bondem.io.sphere_tables import read_csv, read_yade
from bondem.io.vtk_spheres import read_vtk
from bondem.io.vtkhdf_spheres import read_vtkhdf_spheres
from bondem.io.xyz import read_xyz
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles

_OWN = (".h5", ".hdf5")
_LAMMPS, _DUMP, _XYZ = (".data", ".lmp", ".lammps"), (".dump", ".lammpstrj"), (".xyz", ".extxyz")
_VTK = (".vtk", ".vtp", ".vtu")
_FORMATS = (
    ".h5 (bondem), .csv, .txt (Yade), .data or .lmp (LAMMPS), .dump or .lammpstrj (LAMMPS), .xyz, .vtk, .vtp, .vtu,"
    " .vtkhdf"
)
# Least length of bonds across a periodic border over that of the longest other bond, both in sums of radii [-].
_ACROSS = 1.3


def read_particles(
    path: str | Path, *, unit: str | float | None = None, shape: Shape | None = None, period: ArrayLike | None = None,
    columns: Sequence[str | int] | None = None, radius: str | float | None = None, diameters: bool = False,
    periodic: bool | None = None, frame: int = -1,
) -> Particles:  # fmt: skip
    """Read spheres from a file, in the format of its suffix.

    `.h5` is the format of `bd.save_particles`. `.csv` has a header, or columns x, y, z, radius. `.txt` is a file of
    Yade. `.data`, `.lmp` and `data.*` are LAMMPS data files of atom_style sphere or bpm/sphere. `.dump`, `.lammpstrj`
    and `dump.*` are LAMMPS dumps in text. `.xyz` and `.extxyz` are plain or extended XYZ. `.vtk`, `.vtp` and `.vtu`
    have points with an array of radii and require VTK (extra `view`). `.vtkhdf` does not require VTK.

    Args:
        path: the file.
        unit: unit of length of the file, by name ("mm") or in metres (1e-3). None means the unit that CSV headers
            ("x [mm]") and LAMMPS ("units = si") may state, else metres, with a warning for a specimen of more than a
            metre. Files of bondem are in metres.
        shape: shape that the spheres fill [m], for files without one.
        period: edge lengths of the periodic cell [m], (3,), for files without one; its corner is the origin.
        columns: columns of x, y, z and radius in CSV files, by name or by number from 0; in XYZ files by number.
        radius: name of the array of radii in VTK files, dumps and extended XYZ. For dumps and XYZ without one: one
            radius for all, in the unit of the file.
        diameters: True if sizes are diameters, for CSV, Yade and XYZ. Columns named diameter are always halved.
        periodic: True to use the box of a LAMMPS or XYZ file as a periodic cell, moved to the origin. None does so if
            the file states that all borders are periodic, which data files cannot. A file that states some of its
            borders to be periodic needs False, or `period`.
        frame: index of the snapshot of dumps, XYZ and VTKHDF, from 0; -1 is the last.

    Returns:
        The spheres in the order of the file, or of the ids in LAMMPS files.

    Raises:
        InputError: no such file, an unknown format, or unusable spheres; the message states the file and, for text
            files, the line.

    Warns:
        UnitWarning: the specimen is more than a metre long, and no unit is given.
        FillingWarning: the spheres do not fill the shape, or extend beyond it.
    """
    path = _existing(path)
    asked = _Asked(unit, columns, radius, diameters, periodic, frame)
    _check_options(asked, shape, period)
    if path.suffix.lower() in _OWN:
        return _own(path, unit, shape, period)[0]
    return _particles(path, _read(path, asked), unit, shape, period)


def read_lattice(
    path: str | Path, *, unit: str | float | None = None, shape: Shape | None = None, period: ArrayLike | None = None,
    radius: str | None = None, periodic: bool | None = None,
) -> Lattice:  # fmt: skip
    """Read spheres and their bonds from a file of bondem, a LAMMPS data file with bonds, or VTKHDF with lines.

    Bonds are intact and at rest at the lengths that they have in the file, without the broken bonds of a state.
    Bodies of cells can only be read from files of bondem, which store facets and cells bit for bit.

    Args:
        path: the file.
        unit: unit of length of the file, as for `read_particles`.
        shape: shape that the spheres fill [m], as for `read_particles`.
        period: edge lengths of the periodic cell [m], (3,), as for `read_particles`.
        radius: name of the array of radii in VTKHDF files.
        periodic: True to use the box of a LAMMPS file as a periodic cell.

    Raises:
        InputError: an error of `read_particles`, a file without bonds, or bonds across the border of a cell
            that is not known to be periodic.
        DisconnectedError: the specimen consists of more than one large piece.

    Warns:
        StressFreeWarning: the body in the file moves, is strained or has damage, and the imported one does not.
    """
    path = _existing(path)
    asked = _Asked(unit, None, radius, False, periodic, -1)
    _check_options(asked, shape, period)
    strained = ""
    if path.suffix.lower() in _OWN:
        own = load_lattice(path)
        if own is not None and own.cells is not None:
            _as_saved(path, unit, shape, period)
            return own
        particles, pairs = _own(path, unit, shape, period)
    else:
        raw = _read(path, asked)
        strained = raw.strained
        particles, pairs = _particles(path, raw, unit, shape, period), raw.pairs
    if pairs is None:
        raise InputError(f"'{path}' has no bonds; read it with bd.read_particles and connect with bd.connect")
    try:
        lattice = Lattice(particles, pairs)
    except DisconnectedError as error:
        if not strained:
            raise
        raise DisconnectedError(
            f"'{path}': {strained}; {str(error).partition(';')[0]}; read the broken body from a run file (out=) with"
            " bd.read_run, or its spheres alone with bd.read_particles"
        ) from None
    _refuse_across(path, lattice)
    if strained:
        warnings.warn(
            f"'{path}': {strained}; the present lengths of its bonds become their rest lengths, so that the body"
            " is free of stress; read the file of the body before it was loaded, or keep runs in run files (out=)",
            StressFreeWarning, stacklevel=2,
        )  # fmt: skip
    return lattice


@dataclass(frozen=True)
class _Asked:
    """Arguments of `read_particles` that describe a file."""

    unit: str | float | None
    columns: Sequence[str | int] | None
    radius: str | float | None
    diameters: bool
    periodic: bool | None
    frame: int


def _refuse_across(path: Path, lattice: Lattice) -> None:
    """Reject bonds across the border of a periodic cell in a lattice without a period.

    Such bonds span more than half of the body, and are longer than all others.
    """
    particles = lattice.particles
    if particles.period is not None or not len(lattice.pairs):
        return
    width = np.ptp(particles.position, axis=0) + 2.0 * particles.radius.max()
    wide = (np.abs(lattice.branch) > 0.5 * width).any(axis=1)
    length = lattice.length / particles.radius[lattice.pairs].sum(axis=1)
    across = np.flatnonzero(wide & (length > _ACROSS * length[~wide].max(initial=1.0)))
    if across.size:
        raise InputError(
            f"'{path}': bond {across[0]} reaches across half the specimen ({len(across)} such bonds): bonds over the"
            " border of a periodic cell? Pass periodic=True (LAMMPS) or period="
        )


def _existing(path: str | Path) -> Path:
    path = place("path", path)
    require_file(path, "file")
    return path


def _check_options(asked: _Asked, shape: object, period: object) -> None:
    if asked.unit is not None and isinstance(asked.unit, str | float | int):
        length_unit("read", asked.unit)
    for name, value, kinds, wanted in (
        ("unit", asked.unit, (str, float, int, np.number), "a unit of length: 'mm', or 1e-3"),
        ("shape", shape, Shape, "a shape such as bd.Box(...)"),
        ("columns", asked.columns, (list, tuple), "four columns: those of x, y, z and radius"),
        ("radius", asked.radius, (str, float, int, np.number), "the name of the array of radii, or one radius"),
        ("diameters", asked.diameters, bool, "True or False"),
        ("periodic", asked.periodic, bool, "True or False"),
    ):
        if value is not None:
            instance("read", name, value, kinds, wanted)
    if isinstance(asked.frame, bool) or not isinstance(asked.frame, int | np.integer):
        raise InputError(f"read: frame = {shown(asked.frame)}; give the number of a snapshot, from 0, or -1")
    if asked.radius is not None and not isinstance(asked.radius, str):
        number("read", "radius", asked.radius, above=0.0, advice="a name, or one positive radius for all")
    if period is not None:
        vector("read", "period", period, unit="m", advice="three positive edge lengths in metres")


def _as_saved(path: Path, unit: str | float | None, shape: Shape | None, period: ArrayLike | None) -> None:
    """Reject shape, period and unit for a body of cells, which has those of its file."""
    if shape is not None or period is not None or (unit is not None and length_unit("read", unit) != 1.0):
        raise InputError(
            f"'{path}' has a body of cells with its own shape, in metres; leave out shape=, period= and unit=, or"
            " read its spheres with bd.read_particles and connect them again"
        )


def _own(
    path: Path, unit: str | float | None, shape: Shape | None, period: ArrayLike | None
) -> tuple[Particles, Pairs | None]:
    particles, pairs = load_bonded(path)
    if unit is not None and length_unit("read", unit) != 1.0:
        raise InputError(f"'{path}' is a file of bondem, in metres; leave out unit=")
    if shape is None and period is None:
        return particles, pairs
    raw = RawSpheres(particles.position, particles.radius, particles.period)
    return _particles(path, raw, 1.0, shape, period), pairs


def _read(path: Path, asked: _Asked) -> RawSpheres:
    suffix = path.suffix.lower()
    if suffix in _DUMP or path.name.startswith("dump."):
        return read_dump(path, size=asked.radius, periodic=asked.periodic, frame=asked.frame)
    if suffix in _XYZ:
        return read_xyz(
            path, asked.columns, size=asked.radius, diameters=asked.diameters, periodic=asked.periodic,
            frame=asked.frame,
        )  # fmt: skip
    if asked.radius is not None and not isinstance(asked.radius, str):
        raise InputError(f"radius = {asked.radius}: '{path}' has radii of its own; leave it out, or give their name")
    if suffix in _LAMMPS or path.name.startswith("data."):
        return read_lammps(path, periodic=bool(asked.periodic))
    if suffix == ".csv":
        return read_csv(path, asked.columns, diameters=asked.diameters, unit_given=asked.unit is not None)
    if suffix == ".txt":
        return read_yade(path, diameters=asked.diameters)
    if suffix == ".vtkhdf":
        return read_vtkhdf_spheres(path, asked.radius, frame=asked.frame)
    if suffix in _VTK:
        return read_vtk(path, asked.radius)
    raise InputError(f"'{path}': '{suffix or path.name}' files of spheres are not supported; give one of {_FORMATS}")


def _particles(
    path: Path, raw: RawSpheres, unit: str | float | None, shape: Shape | None, period: ArrayLike | None
) -> Particles:
    if unit is not None and raw.unit is not None and not math.isclose(length_unit("read", unit), raw.unit):
        raise InputError(f"unit = {shown(unit)}, but '{path}' says that its unit is {raw.unit:g} m; leave out unit=")
    unit = raw.unit if unit is None else unit
    scale = 1.0 if unit is None else length_unit("read", unit)
    if period is None and (shape is None or shape.period is None):
        if raw.partly:
            raise InputError(
                f"'{path}' is periodic along {raw.partly} only, and bodies are periodic along all axes or none; give"
                " periodic=False, or period= with an edge beyond the body where its border is free"
            )
        period = None if raw.period is None else scale * raw.period
    longest = float(np.ptp(raw.position, axis=0).max(initial=0.0))
    if unit is None and is_long(longest):
        warnings.warn(
            f"'{path}' is taken to be {longest:.4g} m long; give unit='m' if it is, unit='mm' if millimetres",
            UnitWarning, stacklevel=users_line(),
        )  # fmt: skip
    try:
        return Particles(scale * raw.position, scale * raw.radius, period, shape)
    except InputError as error:
        raise InputError(f"'{path}': {error}") from error
