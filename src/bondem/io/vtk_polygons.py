"""Polygons for ParaView as VTKHDF PolyData."""

from collections.abc import Mapping
from pathlib import Path

import h5py
import numpy as np

from bondem._types import Floats, Ints
from bondem.io.atomic import require_writable
from bondem.io.hdf5 import put, writing


def write_polygons(path: Path, vertex: Floats, start: Ints, fields: Mapping[str, np.ndarray]) -> None:
    """Write polygons without common corners.

    Args:
        path: file to write.
        vertex: corners of all polygons in sequence [m], (v, 3).
        start: offsets of the polygons, (p + 1,); corners of polygon q are start[q] … start[q + 1] - 1.
        fields: fields of the polygons by name, (p,) or (p, k).
    """
    require_writable(path, "VTK file")
    with writing(path) as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = (2, 0)
        root.attrs.create("Type", b"PolyData", dtype=h5py.string_dtype("ascii", 8))
        root["NumberOfPoints"] = [len(vertex)]
        put(root, "Points", vertex)
        for kind in ("Vertices", "Lines", "Polygons", "Strips"):
            offsets = start if kind == "Polygons" else np.zeros(1, dtype=np.int64)
            group = root.create_group(kind)
            group["NumberOfCells"], group["NumberOfConnectivityIds"] = [len(offsets) - 1], [int(offsets[-1])]
            put(group, "Offsets", offsets)
            put(group, "Connectivity", np.arange(offsets[-1]))
        root.create_group("PointData")
        data = root.create_group("CellData")
        for name, values in fields.items():
            put(data, name, values)
