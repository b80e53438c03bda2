"""VTKHDF that grows: pieces of a body, each with values at many times, in one group that ParaView opens.

The group is a PartitionedDataSetCollection (VTKHDF 2.5) whose pieces all have the same steps. Of each array the steps
say from which row on theirs begin, so that what does not change is written once: all steps begin at the same row.
"""

from collections.abc import Mapping
from typing import Any

import h5py
import numpy as np

from bondem._types import Floats, Ints

_VERSION = (2, 5)
_KINDS = ("Vertices", "Lines", "Polygons", "Strips")
_POLYHEDRON = 42
# Bytes in a chunk where a step has few rows.
_CHUNK = 1 << 13


def begin_collection(file: h5py.File) -> h5py.Group:
    """The group of all pieces, without any."""
    root = file.create_group("VTKHDF", track_order=True)
    root.attrs["Version"] = _VERSION
    _set_type(root, b"PartitionedDataSetCollection")
    root.create_group("Assembly", track_order=True)
    return root


def _set_type(group: h5py.Group, name: bytes) -> None:
    group.attrs.create("Type", name, dtype=h5py.string_dtype("ascii", len(name)))


class Piece:
    """One piece: points with vertices, lines or polygons, or cells as polyhedra.

    Args:
        group: of the piece; `lines`, `vertices`, `polygons` and `polyhedra` make one.
    """

    def __init__(self, group: h5py.Group) -> None:
        self.group = group
        self._plain = _text(group.attrs["Type"]) == "PolyData"

    @classmethod
    def begin(cls, root: h5py.Group, name: str, kind: str) -> "Piece":
        """A new piece: "PolyData" or "UnstructuredGrid"."""
        group = root.create_group(name, track_order=True)
        group.attrs["Version"], group.attrs["Index"] = _VERSION, len(root) - 2  # there is the assembly, too
        _set_type(group, kind.encode())
        assembly: Any = root["Assembly"]
        node = assembly.create_group(name, track_order=True)
        node[name] = h5py.SoftLink(group.name)
        steps = group.create_group("Steps", track_order=True)
        steps.attrs["NSteps"] = 0
        return cls(group)

    @property
    def steps(self) -> int:
        """How many there are."""
        return int(_group(self.group, "Steps").attrs["NSteps"])

    @property
    def times(self) -> Floats:
        """Of the steps [s], (s,)."""
        steps = _group(self.group, "Steps")
        return np.asarray(steps["Values"][: self.steps]) if self.steps else np.zeros(0)

    @property
    def has_points(self) -> bool:
        """Whether its points have been written, of all steps or of the first one."""
        return "Points" in self.group

    def has(self, field: str) -> bool:
        """Whether its cells have a field."""
        return f"CellData/{field}" in self.group

    def set_static(self, arrays: Mapping[str, Any]) -> None:
        """Write arrays that no step changes, by their path in the piece."""
        for name, values in arrays.items():
            append(self.group, name, np.asarray(values))

    def add_step(
        self, time: float, *, points: Floats | None, point_data: Mapping[str, Any], cell_data: Mapping[str, Any],
        polygons: Ints | None = None,
    ) -> None:  # fmt: skip
        """Add a step.

        Args:
            time: [s].
            points: where the points are now (p, 3), None where they do not move.
            point_data, cell_data: by name, one row a point or cell; a name that is None has its one static row.
            polygons: where the corners of each polygon begin, (c + 1,): of a piece with other polygons each time.
        """
        group, steps = self.group, _group(self.group, "Steps")
        part = cell = corner = place = 0
        if points is not None:
            place = append(group, "Points", points.astype(np.float32))
        if polygons is not None:
            assert points is not None
            part = append(group, "NumberOfPoints", np.array([len(points)]))
            for kind in _KINDS:
                own = polygons if kind == "Polygons" else np.zeros(1, dtype=np.int64)
                append(group, f"{kind}/NumberOfCells", np.array([len(own) - 1]))
                append(group, f"{kind}/NumberOfConnectivityIds", np.array([own[-1]]))
                begun = append(group, f"{kind}/Offsets", own)
                linked = append(group, f"{kind}/Connectivity", np.arange(own[-1]))
                if kind == "Polygons":
                    cell, corner = begun - part, linked
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
                at = 0 if values is None else append(group, f"{where}/{name}", _small(values))
                append(steps, f"{where}Offsets/{name}", np.array([at]))
        steps.attrs["NSteps"] = self.steps + 1

    def cut(self, count: int) -> None:
        """Forget all steps but the first so many; their rows are written over by the next ones."""
        group, steps = self.group, _group(self.group, "Steps")
        if count >= self.steps:
            return
        for where in ("PointData", "CellData"):
            for name in _group(steps, f"{where}Offsets") if f"{where}Offsets" in steps else ():
                _shorten(group, f"{where}/{name}", steps[f"{where}Offsets/{name}"], count)
        _shorten(group, "Points", steps["PointOffsets"], count)
        if int(steps["PartOffsets"][-1]):
            part = int(steps["PartOffsets"][count])
            for kind in _KINDS:
                ends = {"Offsets": "NumberOfCells", "Connectivity": "NumberOfConnectivityIds"}
                for name, number in ends.items():
                    kept = _dataset(group, f"{kind}/{number}")[:part]
                    _dataset(group, f"{kind}/{name}").resize(int(kept.sum()) + part * (name == "Offsets"), axis=0)
                for number in ends.values():
                    _dataset(group, f"{kind}/{number}").resize(part, axis=0)
            _dataset(group, "NumberOfPoints").resize(part, axis=0)
        for item in list(steps.values()):
            for one in item.values() if isinstance(item, h5py.Group) else (item,):
                one.resize(count, axis=0)
        steps.attrs["NSteps"] = count


def append(group: h5py.Group, name: str, rows: Any) -> int:
    """Add rows to an array, which is made with the first ones; where they begin."""
    if name not in group:
        tail = rows.shape[1:]
        size = max(rows.nbytes // max(len(rows), 1), 1)
        chunk = max(len(rows), _CHUNK // size, 1)
        group.create_dataset(
            name, shape=(0, *tail), maxshape=(None, *tail), chunks=(chunk, *tail), dtype=rows.dtype, fletcher32=True
        )
    data = _dataset(group, name)
    begin = len(data)
    data.resize(begin + len(rows), axis=0)
    if len(rows):
        data[begin:] = rows
    return begin


def static_polyhedra(cell: Ints, number: Ints, start: Ints, owner: Ints, count: int) -> dict[str, Any]:
    """Static arrays of `count` polyhedra, each with points of its own, sorted by cell.

    Args:
        cell: whose each point is, (c,).
        number: of the corners of all polygons, one after another.
        start: where each polygon begins in `number`, (p + 1,).
        owner: whose each polygon is, (p,).
        count: of cells.
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
    """Static arrays of lines between points, (c, 2), or of vertices, (c, 1)."""
    arrays: dict[str, Any] = {}
    for kind in _KINDS:
        own = pairs if kind == ("Lines" if pairs.shape[1] == 2 else "Vertices") else pairs[:0]
        arrays |= {
            f"{kind}/NumberOfCells": np.array([len(own)]), f"{kind}/NumberOfConnectivityIds": np.array([own.size]),
            f"{kind}/Offsets": pairs.shape[1] * np.arange(len(own) + 1), f"{kind}/Connectivity": own.ravel(),
        }  # fmt: skip
    return arrays


def _shorten(group: h5py.Group, name: str, offsets: Any, count: int) -> None:
    if name in group and int(offsets[-1]):
        _dataset(group, name).resize(int(offsets[count]), axis=0)


def _small(values: Any) -> Any:
    values = np.asarray(values)
    return values.astype(np.float32) if values.dtype == np.float64 else values


def _dataset(group: h5py.Group, name: str) -> h5py.Dataset:
    item = group[name]
    assert isinstance(item, h5py.Dataset)
    return item


def _group(group: h5py.Group, name: str) -> Any:
    return group[name]


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
