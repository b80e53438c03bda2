"""Polygons for ParaView as VTKHDF PolyData."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np

from bondem._types import ArrayLike, Floats, Ints
from bondem.io.atomic import require_writable
from bondem.io.hdf5 import put, writing


@contextmanager
def poly_data(path: Path, points: ArrayLike, chosen: str, offsets: Ints, corners: Ints) -> Iterator[h5py.Group]:
    """Create a PolyData file of points and cells of one kind, and yield its group, to which fields can be added.

    Args:
        path: file to write.
        points: positions of the points [m], (n, 3).
        chosen: kind of the cells, "Lines" or "Polygons".
        offsets: offsets of the cells in `corners`, (c + 1,).
        corners: points of all cells in sequence.
    """
    require_writable(path, "VTK file")
    with writing(path) as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = (2, 0)
        root.attrs.create("Type", b"PolyData", dtype=h5py.string_dtype("ascii", 8))
        root["NumberOfPoints"] = [len(np.asarray(points))]
        put(root, "Points", points)
        for kind in ("Vertices", "Lines", "Polygons", "Strips"):
            starts, of = (offsets, corners) if kind == chosen else (np.zeros(1, np.int64), np.zeros(0, np.int64))
            group = root.create_group(kind)
            group["NumberOfCells"], group["NumberOfConnectivityIds"] = [len(starts) - 1], [len(of)]
            put(group, "Offsets", starts)
            put(group, "Connectivity", of)
        yield root


def write_polygons(path: Path, vertex: Floats, start: Ints, fields: Mapping[str, np.ndarray]) -> None:
    """Write a VTKHDF file of polygons that share no corners.

    Args:
        path: file to write.
        vertex: corners of all polygons in sequence [m], (v, 3).
        start: offsets of the polygons, (p + 1,); corners of polygon q are start[q] … start[q + 1] - 1.
        fields: fields of the polygons by name, (p,) or (p, k).
    """
    with poly_data(path, vertex, "Polygons", start, np.arange(start[-1])) as root:
        root.create_group("PointData")
        data = root.create_group("CellData")
        for name, values in fields.items():
            put(data, name, values)
