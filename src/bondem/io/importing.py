"""Import of spheres from files: choice of the reader, and checks common to all formats."""

import importlib
import os
import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from bondem._checks import instance, place, vector
from bondem._extras import install
from bondem._names import users_line
from bondem._types import ArrayLike, Pairs
from bondem.errors import InputError, UnitWarning
from bondem.io.lammps import read_lammps
from bondem.io.particles_file import load_bonded, load_lattice
from bondem.io.sphere_tables import RawSpheres, read_csv, read_yade
from bondem.io.vtkhdf_spheres import read_vtkhdf_spheres
from bondem.specimen.geometry import Shape
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles
from bondem.specimen.units import length_unit

# Longest specimen taken for metres without being told so [m].
_USUAL = 1.0
_OWN = (".h5", ".hdf5")
_LAMMPS = (".data", ".lmp", ".lammps")
_VTK = (".vtk", ".vtp", ".vtu")
_FORMATS = ".h5 (bondem), .csv, .txt (Yade), .data or .lmp (LAMMPS), .vtk, .vtp, .vtu, .vtkhdf"


def read_particles(
    path: str | Path,
    *,
    unit: str | float | None = None,
    shape: Shape | None = None,
    period: ArrayLike | None = None,
    columns: Sequence[str | int] | None = None,
    radius: str | None = None,
    periodic: bool = False,
) -> Particles:
    """Read spheres from a file, in the format of its suffix.

    `.h5` is the format of `bd.save_particles`. `.csv` has a header, or columns x, y, z, radius. `.txt` is a file of
    Yade. `.data`, `.lmp` and `data.*` are LAMMPS data files of atom_style sphere or bpm/sphere. `.vtk`, `.vtp` and
    `.vtu` have points with an array of radii and require VTK (extra `view`). `.vtkhdf` does not require
    VTK.

    Args:
        path: the file.
        unit: unit of length of the file, by name ("mm") or in metres (1e-3). None means metres, with a warning for a
            specimen of more than a metre. Files of bondem are in metres.
        shape: shape that the spheres fill [m], for files without one.
        period: edge lengths of the periodic cell [m], (3,), for files without one; its corner is the origin.
        columns: columns of x, y, z and radius in CSV files, by name or by number from 0.
        radius: name of the array of radii in VTK files.
        periodic: True to use the box of a LAMMPS file as a periodic cell, moved to the origin.

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
    _check_options(unit, shape, period, columns, radius, periodic)
    if path.suffix.lower() in _OWN:
        return _own(path, unit, shape, period)[0]
    return _particles(path, _read(path, columns, radius, periodic), unit, shape, period)


def read_lattice(
    path: str | Path,
    *,
    unit: str | float | None = None,
    shape: Shape | None = None,
    period: ArrayLike | None = None,
    radius: str | None = None,
    periodic: bool = False,
) -> Lattice:
    """Read spheres and their bonds from a file of bondem, a LAMMPS data file with bonds, or VTKHDF with lines.

    Bodies of cells can only be read from files of bondem, which store facets and cells to the bit.

    Args:
        path: the file.
        unit: unit of length of the file, as for `read_particles`.
        shape: shape that the spheres fill [m], as for `read_particles`.
        period: edge lengths of the periodic cell [m], (3,), as for `read_particles`.
        radius: name of the array of radii in VTKHDF files.
        periodic: True to use the box of a LAMMPS file as a periodic cell.

    Raises:
        InputError: an error of `read_particles`, or a file without bonds.
        DisconnectedError: the specimen consists of two large pieces.
    """
    path = _existing(path)
    _check_options(unit, shape, period, None, radius, periodic)
    if path.suffix.lower() in _OWN:
        own = load_lattice(path)
        if own is not None and own.cells is not None:
            _as_saved(path, unit, shape, period)
            return own
        particles, pairs = _own(path, unit, shape, period)
    else:
        raw = _read(path, None, radius, periodic)
        particles, pairs = _particles(path, raw, unit, shape, period), raw.pairs
    if pairs is None:
        raise InputError(f"'{path}' has no bonds; read it with bd.read_particles and connect with bd.connect")
    lattice = Lattice(particles, pairs)
    far = 0.5 * np.ptp(particles.position, axis=0) + 4.0 * particles.radius.max()
    across = np.flatnonzero((np.abs(lattice.branch) > far).any(axis=1))
    if particles.period is None and across.size:
        raise InputError(
            f"'{path}': bond {across[0]} reaches across half the specimen ({len(across)} such bonds): bonds over the"
            " border of a periodic cell? Pass periodic=True (LAMMPS) or period="
        )
    return lattice


def _existing(path: str | Path) -> Path:
    path = place("path", path)
    if not os.path.isfile(path):
        raise InputError(f"path = '{path}': there is no file; check the path")
    return path


def _check_options(
    unit: object, shape: object, period: object, columns: object, radius: object, periodic: object
) -> None:
    if unit is not None and isinstance(unit, str | float | int):
        length_unit("read", unit)
    for name, value, kinds, wanted in (
        ("unit", unit, (str, float, int, np.number), "a unit of length: 'mm', or 1e-3"),
        ("shape", shape, Shape, "a shape such as bd.Box(...)"),
        ("columns", columns, (list, tuple), "four columns: those of x, y, z and radius"),
        ("radius", radius, str, "the name of the array of radii"),
        ("periodic", periodic, bool, "True or False"),
    ):
        if value is not None:
            instance("read", name, value, kinds, wanted)
    if period is not None:
        vector("read", "period", period, unit="m", advice="three positive edge lengths in metres")


def _as_saved(path: Path, unit: str | float | None, shape: Shape | None, period: ArrayLike | None) -> None:
    """Check that a body of cells keeps the shape and the period of its file."""
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


def _read(path: Path, columns: Sequence[str | int] | None, radius: str | None, periodic: bool) -> RawSpheres:
    suffix = path.suffix.lower()
    if suffix in _LAMMPS or path.name.startswith("data."):
        return read_lammps(path, periodic=periodic)
    if suffix == ".csv":
        return read_csv(path, columns)
    if suffix == ".txt":
        return read_yade(path)
    if suffix == ".vtkhdf":
        return read_vtkhdf_spheres(path, radius)
    if suffix in _VTK:
        try:
            reader = importlib.import_module("bondem.io.vtk_spheres")
        except ModuleNotFoundError as error:
            raise InputError(
                f"'{path}' needs VTK, which is not installed ({error.name}); {install('view')}, or write"
                " the spheres as CSV"
            ) from error
        return reader.read_vtk(path, radius)
    raise InputError(f"'{path}': '{suffix or path.name}' files of spheres are not supported; give one of {_FORMATS}")


def _particles(
    path: Path, raw: RawSpheres, unit: str | float | None, shape: Shape | None, period: ArrayLike | None
) -> Particles:
    scale = 1.0 if unit is None else length_unit("read", unit)
    if period is None and raw.period is not None and (shape is None or shape.period is None):
        period = scale * raw.period
    longest = float(np.ptp(raw.position, axis=0).max(initial=0.0))
    if unit is None and longest > _USUAL:
        warnings.warn(
            f"'{path}' is taken to be {longest:.4g} m long; give unit='m' if it is, unit='mm' if millimetres",
            UnitWarning, stacklevel=users_line(),
        )  # fmt: skip
    try:
        return Particles(scale * raw.position, scale * raw.radius, period, shape)
    except InputError as error:
        raise InputError(f"'{path}': {error}") from error
