"""Reader of each format of surface files, chosen by the suffix of the file."""

import importlib
import io
from pathlib import Path

import numpy as np

from bondem._checks import require_file
from bondem.errors import InputError
from bondem.geometry.surface_files.contents import Contents
from bondem.geometry.surface_files.stl import read_stl
from bondem.geometry.surface_files.threemf import read_3mf
from bondem.geometry.surface_files.wavefront import read_obj


def read_surface_file(file: Path) -> Contents:
    """Read the triangles and named parts of a surface file.

    Raises:
        InputError: The file does not exist, has another format, or is damaged.
    """
    ending = file.suffix.lower()
    if ending not in _READERS:
        raise InputError(f"{file}: Surface reads STL, OBJ, 3MF, PLY and OFF files; export the part as one of these")
    require_file(file, "such file")
    try:
        data = file.read_bytes()
    except OSError as error:
        raise InputError(f"{file} cannot be read ({error.strerror}); check its permissions") from error
    return _READERS[ending](str(file), data)


def _by_trimesh(name: str, data: bytes) -> Contents:
    """Read a PLY or OFF file, whose formats name no parts, by `trimesh`."""
    # imported on use, so that runs without surfaces start faster
    trimesh = importlib.import_module("trimesh")
    ending = Path(name).suffix[1:].lower()
    try:
        mesh = trimesh.load_mesh(io.BytesIO(data), file_type=ending)
        return Contents(np.array(mesh.vertices, dtype=float), np.array(mesh.faces, dtype=np.int64), {})
    except Exception as error:  # parsers raise errors of many types
        raise InputError(
            f"{name} cannot be read as {ending.upper()} ({error}); export it again, as triangles"
        ) from error


_READERS = {".stl": read_stl, ".obj": read_obj, ".3mf": read_3mf, ".ply": _by_trimesh, ".off": _by_trimesh}
