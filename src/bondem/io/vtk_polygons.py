"""Polygons for ParaView as VTKHDF PolyData."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np

from bondem._types import ArrayLike, Floats, Ints
from bondem.io.atomic import require_writable
from bondem.io.hdf5 import put, writing
from bondem.io.vtkhdf_series import begin_group, static_cells


@contextmanager
def poly_data(path: Path, points: ArrayLike, chosen: str, offsets: Ints, corners: Ints) -> Iterator[h5py.Group]:
    """Yield the group of a new PolyData file with points and cells of one kind, to which fields can be added.

    Args:
        path: file to write; InputError if it cannot be written.
        points: positions of the points [m], (n, 3).
        chosen: kind of the cells, "Lines" or "Polygons".
        offsets: offsets of the cells in `corners`, (c + 1,).
        corners: points of all cells in sequence.
    """
    require_writable(path, "VTK file")
    with writing(path) as file:
        root = begin_group(file, "PolyData")
        root.attrs["Version"] = (2, 0)  # for readers that know no later one
        cells = static_cells(chosen, offsets, corners)
        for name, values in ({"NumberOfPoints": [len(np.asarray(points))], "Points": points} | cells).items():
            put(root, name, values)
        yield root


def write_polygons(path: Path, vertex: Floats, start: Ints, fields: Mapping[str, np.ndarray]) -> None:
    """Write a VTKHDF file of polygons that share no corners.

    Args:
        path: file to write; InputError if it cannot be written.
        vertex: corners of all polygons in sequence [m], (v, 3).
        start: offsets of the polygons, (p + 1,); corners of polygon q are start[q] … start[q + 1] - 1.
        fields: fields of the polygons by name, (p,) or (p, k).
    """
    with poly_data(path, vertex, "Polygons", start, np.arange(start[-1])) as root:
        root.create_group("PointData")
        for name, values in fields.items():
            put(root, f"CellData/{name}", values)
