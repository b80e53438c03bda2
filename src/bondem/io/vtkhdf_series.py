"""Growing VTKHDF files: pieces of a body with values at many times, in one group that ParaView opens.

The group is a PartitionedDataSetCollection (VTKHDF 2.5) whose pieces all have equal steps. Each step stores the
offset of its rows in every array. Constant data are therefore written once: all steps have the same offset.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np

from bondem._types import Floats, Ints
from bondem.io.digest import text_of

_VERSION = (2, 5)
_KINDS = ("Vertices", "Lines", "Polygons", "Strips")
_POLYHEDRON = 42
# Least size of a chunk, for steps with few rows [bytes].
_CHUNK = 1 << 13


def begin_collection(file: h5py.File) -> h5py.Group:
    """Create the empty VTKHDF group of a file, to which pieces can be added."""
    root = begin_group(file, "PartitionedDataSetCollection")
    root.create_group("Assembly", track_order=True)
    return root


def begin_group(place: h5py.Group, kind: str, name: str = "VTKHDF") -> h5py.Group:
    """Create an empty group of a type of VTKHDF, such as "PolyData"."""
    group = place.create_group(name, track_order=True)
    group.attrs["Version"] = _VERSION
    group.attrs.create("Type", kind.encode(), dtype=h5py.string_dtype("ascii", len(kind)))
    return group


@dataclass(frozen=True, eq=False)
class Same:
    """Reference to rows that another piece has just stored: the file has them once, under both names.

    Attributes:
        data: dataset of the other piece.
        begin: offset of the rows in it.
        rows: the rows, for a file whose pieces have datasets of their own.
    """

    data: h5py.Dataset
    begin: int
    rows: np.ndarray


class Piece:
    """Piece of a body in a growing file: points with vertices, lines or polygons, or polyhedra.

    Args:
        group: HDF5 group of the piece, which `begin` creates.
    """

    def __init__(self, group: h5py.Group) -> None:
        self.group: Any = group
        self._plain = text_of(group.attrs["Type"]) == "PolyData"

    @classmethod
    def begin(cls, root: h5py.Group, name: str, kind: str) -> "Piece":
        """Create an empty piece of a collection; `kind` is "PolyData" or "UnstructuredGrid"."""
        group = begin_group(root, kind, name)
        group.attrs["Index"] = len(root) - 2  # the group has the assembly, too
        assembly: Any = root["Assembly"]
        node = assembly.create_group(name, track_order=True)
        node[name] = h5py.SoftLink(group.name)
        steps = group.create_group("Steps", track_order=True)
        steps.attrs["NSteps"] = 0
        return cls(group)

    @property
    def steps(self) -> int:
        """Number of steps."""
        return int(self.group["Steps"].attrs["NSteps"])

    @property
    def times(self) -> Floats:
        """Times of the steps [s], (s,)."""
        return np.asarray(self.group["Steps/Values"][: self.steps]) if self.steps else np.zeros(0)

    @property
    def has_points(self) -> bool:
        """Return True if the points have been written, of all steps or of the first one."""
        return "Points" in self.group

    def has(self, field: str) -> bool:
        """Return True if the cells have a field."""
        return f"CellData/{field}" in self.group

    def set_static(self, arrays: Mapping[str, Any]) -> None:
        """Write arrays that are constant over all steps, by their path in the piece."""
        for name, values in arrays.items():
            append(self.group, name, np.asarray(values))

    def add_step(
        self, time: float, *, points: Floats | None, point_data: Mapping[str, Any], cell_data: Mapping[str, Any],
        polygons: Ints | None = None,
    ) -> None:  # fmt: skip
        """Append a step.

        Args:
            time: time of the step [s].
            points: positions of the points [m], (p, 3); None for constant positions.
            point_data, cell_data: arrays by name, one row per point or cell; None for the static array of this name,
                and `Same` for rows that another piece has already stored.
            polygons: offsets of the corners of each polygon, (c + 1,), for a piece whose polygons change.
        """
        group, steps = self.group, self.group["Steps"]
        part = cell = corner = place = 0
        if points is not None:
            place = append(group, "Points", points.astype(np.float32))
        if polygons is not None:
            assert points is not None
            part = append(group, "NumberOfPoints", np.array([len(points)]))
            cells = static_cells("Polygons", polygons, np.arange(polygons[-1]))
            at = {name: append(group, name, values) for name, values in cells.items()}
            cell, corner = at["Polygons/Offsets"] - part, at["Polygons/Connectivity"]
        append(steps, "Values", np.array([time]))
        append(steps, "PartOffsets", np.array([part]))
        append(steps, "NumberOfParts", np.array([1]))
        append(steps, "PointOffsets", np.array([place]))
        kinds = [cell if kind == "Polygons" else 0 for kind in _KINDS] if self._plain else [0]
        linked_at = [corner if kind == "Polygons" else 0 for kind in _KINDS] if self._plain else [0]
        append(steps, "CellOffsets", np.array([kinds]))
        append(steps, "ConnectivityIdOffsets", np.array([linked_at]))
        for where, fields in (("PointData", point_data), ("CellData", cell_data)):
            for name, values in fields.items():
                at = 0 if values is None else _stored(group, f"{where}/{name}", values)
                append(steps, f"{where}Offsets/{name}", np.array([at]))
        steps.attrs["NSteps"] = self.steps + 1

    def last(self, field: str, rows: np.ndarray) -> Same:
        """Return a reference to a point field in the last step, for a piece whose values `rows` equal it."""
        begin = int(self.group[f"Steps/PointDataOffsets/{field}"][-1])
        return Same(self.group[f"PointData/{field}"], begin, rows)

    def cut(self, count: int) -> None:
        """Remove all steps but the first `count`, with their rows; static arrays stay."""
        group, steps = self.group, self.group["Steps"]
        if count >= self.steps:
            return
        for where in ("PointData", "CellData"):
            for name in steps.get(f"{where}Offsets", ()):
                _shorten(group, f"{where}/{name}", steps[f"{where}Offsets/{name}"], count)
        _shorten(group, "Points", steps["PointOffsets"], count)
        if int(steps["PartOffsets"][-1]):
            part = int(steps["PartOffsets"][count])
            for kind in _KINDS:
                ends = {"Offsets": "NumberOfCells", "Connectivity": "NumberOfConnectivityIds"}
                for name, number in ends.items():
                    rows = int(group[f"{kind}/{number}"][:part].sum()) + part * (name == "Offsets")
                    group[f"{kind}/{name}"].resize(rows, axis=0)
                for number in ends.values():
                    group[f"{kind}/{number}"].resize(part, axis=0)
            group["NumberOfPoints"].resize(part, axis=0)
        for item in list(steps.values()):
            for one in item.values() if isinstance(item, h5py.Group) else (item,):
                one.resize(count, axis=0)
        steps.attrs["NSteps"] = count


def append(group: Any, name: str, rows: Any) -> int:
    """Append rows to an array, which is created with the first rows, and return their offset."""
    if name not in group:
        tail = rows.shape[1:]
        size = max(rows.nbytes // max(len(rows), 1), 1)
        chunk = max(len(rows), _CHUNK // size, 1)
        group.create_dataset(
            name, shape=(0, *tail), maxshape=(None, *tail), chunks=(chunk, *tail), dtype=rows.dtype, fletcher32=True
        )
    data = group[name]
    begin = len(data)
    data.resize(begin + len(rows), axis=0)
    if len(rows):
        data[begin:] = rows
    return begin


def _stored(group: Any, name: str, values: Any) -> int:
    if not isinstance(values, Same):
        return append(group, name, _small(values))
    if name not in group:
        group[name] = values.data  # a second name of the same dataset
    if group[name] == values.data:
        return values.begin
    return append(group, name, _small(values.rows))


def static_polyhedra(cell: Ints, number: Ints, start: Ints, owner: Ints, count: int) -> dict[str, Any]:
    """Return the static arrays of `count` polyhedra, each with its own points, sorted by cell.

    Args:
        cell: cell of each point, (c,).
        number: corner numbers of all polygons in sequence.
        start: offset of each polygon in `number`, (p + 1,).
        owner: cell of each polygon, (p,).
        count: number of cells.
    """
    corners, faces = np.bincount(cell, minlength=count), np.bincount(owner, minlength=count)
    arrays = {
        "Types": np.full(count, _POLYHEDRON, dtype=np.uint8),
        "Connectivity": np.arange(len(cell)), "Offsets": np.append(0, np.cumsum(corners)),
        "FaceConnectivity": number, "FaceOffsets": start, "PolyhedronToFaces": np.arange(len(owner)),
        "PolyhedronOffsets": np.append(0, np.cumsum(faces)),
    }  # fmt: skip
    sizes = {"Points": len(cell), "Cells": count, "ConnectivityIds": len(cell), "Faces": len(owner),
             "FaceConnectivityIds": len(number), "PolyhedronToFaceIds": len(owner)}  # fmt: skip
    return arrays | {"NumberOf" + name: np.array([size]) for name, size in sizes.items()}


def static_lines(pairs: Ints) -> dict[str, Any]:
    """Return the static arrays of lines between points, (c, 2), or of vertices, (c, 1)."""
    count, corners = pairs.shape
    return static_cells("Lines" if corners == 2 else "Vertices", corners * np.arange(count + 1), pairs.ravel())


def static_cells(chosen: str, offsets: Ints, corners: Ints) -> dict[str, Any]:
    """Return the static arrays of PolyData with cells of one kind.

    Args:
        chosen: kind of the cells: "Vertices", "Lines", "Polygons" or "Strips".
        offsets: offsets of the cells in `corners`, (c + 1,).
        corners: points of all cells in sequence.
    """
    arrays: dict[str, Any] = {}
    for kind in _KINDS:
        starts, of = (offsets, corners) if kind == chosen else (np.zeros(1, np.int64), np.zeros(0, np.int64))
        arrays |= {
            f"{kind}/NumberOfCells": np.array([len(starts) - 1]), f"{kind}/Offsets": starts,
            f"{kind}/NumberOfConnectivityIds": np.array([len(of)]), f"{kind}/Connectivity": of,
        }  # fmt: skip
    return arrays


def _shorten(group: Any, name: str, offsets: Any, count: int) -> None:
    if name in group and int(offsets[-1]):
        group[name].resize(int(offsets[count]), axis=0)


def _small(values: Any) -> Any:
    values = np.asarray(values)
    return values.astype(np.float32) if values.dtype == np.float64 else values
