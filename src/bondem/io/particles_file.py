"""Particles, or a lattice with bonds, in one HDF5 file with their provenance.

    /                attributes format, schema, bondem_version, digest; texts shape and provenance (JSON)
    /elements        position (n, 3) [m], radius (n,) [m], period (3,) [m] of a periodic cell
    /bonds           pairs (m, 2) of a saved lattice
    /facets, /cells  of a body of cells, see `bondem.io.bodies`

Arrays are stored bit for bit, and a file with a changed array is rejected.
"""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from bondem._checks import instance, place, require_file
from bondem.errors import InputError
from bondem.geometry.shape import Shape
from bondem.io.atomic import require_writable
from bondem.io.bodies import read_bonds, read_elements, write_bonds, write_elements
from bondem.io.codec import decode, encode
from bondem.io.digest import agree, arrays_of, digest_of, fixed, text_of
from bondem.io.hdf5 import Kind, array_at, damage, reading, refuse_newer, write_head, writing
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles

FORMAT = "bondem particles"
#: Current schema: files may contain facets and cells from 2 on, and contain a digest from 3 on.
SCHEMA = 3
_DIGESTED = 3
_KIND = Kind("a particle file of bondem", "give a file of bd.save_particles", "write it again", InputError)


def save_particles(
    path: str | Path, particles: Particles | Lattice, *, provenance: Mapping[str, Any] | None = None
) -> None:
    """Write particles, or a lattice, to an HDF5 file.

    Args:
        path: the file, usually with the suffix .h5; an existing file is replaced by one atomic move.
        particles: the elements; a Lattice includes its bonds.
        provenance: origin of the particles, such as method, seed and target, by name: JSON values and dataclasses of
            bondem. The version of bondem is added.

    Raises:
        InputError: the file cannot be written.
        RunFileError: the shape or the provenance contains an object that cannot be stored, or the disk is full.
    """
    path = place("save_particles: path", path)
    given = instance("save_particles", "particles", particles, (Particles, Lattice), "bd.Particles or a lattice")
    instance("save_particles", "provenance", provenance or {}, Mapping, "a mapping of names to what JSON can hold")
    elements = given.particles if isinstance(given, Lattice) else given
    texts = {
        "shape": json.dumps(encode(elements.shape)),
        "provenance": json.dumps({str(key): encode(value) for key, value in dict(provenance or {}).items()}),
    }
    require_writable(path, "particle file")
    with writing(path) as file:
        write_head(file, FORMAT, SCHEMA, texts)
        write_elements(file, elements)
        if isinstance(given, Lattice):
            write_bonds(file, given)
        file.attrs["digest"] = fixed(digest_of(arrays_of(file)))


def load_particles(path: str | Path) -> Particles:
    """Read the particles of `save_particles` bit for bit, with their shape.

    Raises:
        InputError: no such file, not a particle file, damaged, or of a newer bondem.
    """
    return _read(place("load_particles: path", path))[0]


def load_bonded(path: str | Path) -> tuple[Particles, np.ndarray | None]:
    """Read particles and their bonds, (m, 2), or None for a file without bonds; errors as for `load_particles`."""
    particles, lattice, _ = _read(Path(path))
    return particles, None if lattice is None else lattice.pairs


def load_lattice(path: str | Path) -> Lattice | None:
    """Read the stored lattice, including any facets and cells; None without bonds. Errors as for `load_particles`."""
    return _read(Path(path))[1]


def read_provenance(path: str | Path) -> dict[str, Any]:
    """Read the provenance of the particles of a file: the argument of `save_particles`, and `bondem_version`.

    Raises:
        InputError: The file does not exist, is no particle file, is damaged, or is of a newer bondem.
    """
    return _read(place("read_provenance: path", path))[2]


def _read(path: Path) -> tuple[Particles, Lattice | None, dict[str, Any]]:
    require_file(path, "particle file")
    with reading(path, _KIND) as file:
        head: Any = file.attrs
        if text_of(head.get("format")) != FORMAT:
            raise InputError(f"'{path}' is not {_KIND.name}; {_KIND.given}")
        version, schema = text_of(head.get("bondem_version", "")), head.get("schema")
        if schema is None or not version:
            raise InputError(f"'{path}' is damaged (its version of bondem is missing); {_KIND.again}")
        refuse_newer(path, schema, version, SCHEMA, _KIND)
        with damage(path, _KIND):
            if schema >= _DIGESTED and not agree(digest_of(arrays_of(file)), head["digest"]):
                raise ValueError("its digest does not match")
            shape = decode(json.loads(array_at(file, "shape").item()))
            if not isinstance(shape, Shape | None):
                raise ValueError(f"its shape is a {type(shape).__name__}")
            particles = read_elements(file, shape)
            lattice = read_bonds(file, particles) if "bonds/pairs" in file else None
            stored = json.loads(array_at(file, "provenance").item())
            origin = {"bondem_version": version} | {key: decode(value) for key, value in stored.items()}
    return particles, lattice, origin
