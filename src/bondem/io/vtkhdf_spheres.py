"""Import of spheres from VTKHDF, as written by `write_vtkhdf`: points with an array of radii."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from bondem._types import PerElement
from bondem.errors import InputError
from bondem.io.raw_spheres import RawSpheres

# In small letters; of a diameter, half.
_RADIUS = ("radius", "radii", "rad", "r")
_DIAMETER = ("diameter", "diameters", "d")


def read_vtkhdf_spheres(path: Path, radius: str | None = None) -> RawSpheres:
    """Read spheres from a VTKHDF file of PolyData or an UnstructuredGrid in one piece; lines of two points are bonds.

    Args:
        path: the file.
        radius: name of the point array of radii; None for the default names of `radii`.

    Raises:
        InputError: not such a file, or no such array.
    """
    try:
        with h5py.File(path, "r") as file:
            root: Any = file["VTKHDF"]
            centre = np.asarray(root["Points"][()], dtype=float)
            arrays = {name: np.asarray(item[()]) for name, item in root["PointData"].items()}
            lines = root.get("Lines")
            ends = None
            if lines is not None and (np.diff(lines["Offsets"][()]) == 2).all():
                ends = np.asarray(lines["Connectivity"][()], dtype=np.int64).reshape(-1, 2)
    except (OSError, KeyError, ValueError):
        raise InputError(f"'{path}' is not VTKHDF with points and point data; write it again") from None
    pairs = ends if ends is not None and len(ends) else None
    moved = "its elements have displacements" if np.any(arrays.get("displacement", 0.0)) else ""
    return RawSpheres(centre, radii(path, arrays, radius), pairs=pairs, strained=moved if pairs is not None else "")


def radii(path: Path, arrays: Mapping[str, np.ndarray], name: str | None) -> PerElement:
    """Radii among the point arrays of a file: `name`, or radius, radii, rad, r, or half of diameter or d.

    Raises:
        InputError: the file has no such array.
    """
    if name is not None and name in arrays:
        return np.array(arrays[name], dtype=float) * (0.5 if name.lower() in _DIAMETER else 1.0)
    if name is None:
        known = {key.lower(): values for key, values in arrays.items()}
        for wanted, share in (*((one, 1.0) for one in _RADIUS), *((one, 0.5) for one in _DIAMETER)):
            if wanted in known:
                return share * np.array(known[wanted], dtype=float)
    raise InputError(
        f"'{path}' has no point array '{name or 'radius'}' (its arrays: {', '.join(sorted(arrays)) or 'none'});"
        " give the name of the array of radii as radius="
    )
