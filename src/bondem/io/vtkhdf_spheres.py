"""Import of spheres from VTKHDF: points with an array of radii, of one time or many, in one piece or several."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem._types import Pairs, PerElement
from bondem.errors import InputError
from bondem.io.digest import text_of
from bondem.io.hdf5 import Kind, array_at, damage, reading
from bondem.io.raw_spheres import RawSpheres, listed, snapshot_number

# Names of arrays of sizes, in lower case.
_RADIUS = ("radius", "radii", "rad", "r")
_DIAMETER = ("diameter", "diameters", "d")
_TYPES = ("PolyData", "UnstructuredGrid")
_LINES = 1  # of the kinds of cells of PolyData: vertices, lines, polygons, strips
_KIND = Kind(
    "VTKHDF with points and point data", "give PolyData or an UnstructuredGrid", "write it again", InputError
)  # fmt: skip


def read_vtkhdf_spheres(path: Path, radius: str | None = None, *, frame: int = -1) -> RawSpheres:
    """Read spheres from a VTKHDF file of PolyData or an UnstructuredGrid; lines are bonds, unless broken.

    Args:
        path: the file.
        radius: name of the point array of radii; None for the default names of `radii`.
        frame: index of the time step, from 0; -1 is the last.

    Raises:
        InputError: another kind of file, no such array or time step, or arrays shorter than the file announces.
    """
    with reading(path, _KIND) as file:
        root: Any = file.get("VTKHDF")
        kind = None if root is None else text_of(dict(root.attrs).get("Type"))
        if kind not in _TYPES or "Points" not in root or "PointData" not in root:
            raise InputError(f"'{path}' is not {_KIND.name}; {_KIND.given}")
        with damage(path, _KIND, InputError):
            step = _Step.of(path, root, frame)
            centre = np.asarray(step.rows(root["Points"], "PointOffsets"), dtype=float)
            arrays = {
                name: step.rows(item, f"PointDataOffsets/{name}") for name, item in root["PointData"].items()
            }
            pairs = step.pairs(root["Lines"]) if "Lines" in root else None
            integrity = np.asarray(root["CellData/integrity"]) if "CellData/integrity" in root else np.zeros(0)
    if pairs is None:
        return RawSpheres(centre, radii(path, arrays, radius))
    reasons = ["its elements have displacements"] if np.any(arrays.get("displacement", 0.0)) else []
    if integrity.shape == (len(pairs),):
        broken, count = integrity == 0.0, len(pairs)
        reasons += [f"{broken.sum()} of its {count} bonds are broken and left out"] if broken.any() else []
        softened = int((integrity < 1.0).sum() - broken.sum())
        reasons += [f"{softened} of its {count} bonds are damaged, and become intact"] if softened else []
        pairs = pairs[~broken]
    return RawSpheres(centre, radii(path, arrays, radius), pairs=pairs, strained="; ".join(reasons))


@dataclass(frozen=True, eq=False)
class _Step:
    """Time step of a file, or all contents of a file without time steps.

    Attributes:
        offsets: group with the first rows of the step in each array; None for a file without time steps.
        number: number of the step.
        first: number of the first piece of the step.
        points: number of points of each piece, (p,).
    """

    offsets: Any
    number: int
    first: int
    points: np.ndarray

    @classmethod
    def of(cls, path: Path, root: Any, frame: int) -> "_Step":
        points = array_at(root, "NumberOfPoints").astype(np.int64)
        offsets = root.get("Steps")
        number = snapshot_number(path, frame, 1 if offsets is None else int(offsets.attrs["NSteps"]))
        if offsets is None:
            return cls(None, number, 0, points)
        first = int(offsets["PartOffsets"][number])
        count = int(offsets["NumberOfParts"][number]) if "NumberOfParts" in offsets else 1
        return cls(offsets, number, first, points[first : first + count])

    def rows(self, data: Any, offset: str) -> np.ndarray:
        """Return the rows of an array for the points of the step; `offset` names the first rows of all steps.

        Raises:
            ValueError: the array has fewer rows than the file announces.
        """
        begin, count = self._begin(offset), int(self.points.sum())
        found = np.asarray(data[begin : begin + count])
        if len(found) != count or (self.offsets is None and len(data) != count):
            raise ValueError(f"{count} points announced, {len(data) - begin} rows in {data.name}")
        return found

    def pairs(self, lines: Any) -> Pairs | None:
        """Return the ends of lines, (m, 2), or None without lines or with longer ones; damage raises ValueError."""
        cells = array_at(lines, "NumberOfCells")[self.first :][: len(self.points)].astype(np.int64)
        # the offsets of each piece have one entry more than its lines
        begin = self._begin("CellOffsets", _LINES) + self.first
        at, point, found = self._begin("ConnectivityIdOffsets", _LINES), 0, []
        for count, own in zip(cells.tolist(), self.points.tolist(), strict=True):
            if (np.diff(lines["Offsets"][begin : begin + count + 1]) != 2).any():
                return None
            ends = np.asarray(lines["Connectivity"][at : at + 2 * count], dtype=np.int64)
            if len(ends) != 2 * count or (count and not 0 <= ends.min() <= ends.max() < own):
                raise ValueError(f"{count} lines announced, {len(ends) // 2} with points of the file")
            found.append(ends.reshape(-1, 2) + point)
            begin, at, point = begin + count + 1, at + 2 * count, point + own
        pairs = np.concatenate(found) if found else np.zeros((0, 2), dtype=np.int64)
        return pairs if len(pairs) else None

    def _begin(self, offset: str, kind: int | None = None) -> int:
        if self.offsets is None or offset not in self.offsets:
            return 0
        found = self.offsets[offset][self.number]
        return int(found if kind is None else np.ravel(found)[kind])


def radii(path: Path, arrays: Mapping[str, np.ndarray], name: str | None) -> PerElement:
    """Return radii from the point array `name`, or a default: radius, radii, rad, r, or half of diameter(s) or d.

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
        f"'{path}' has no point array '{name or 'radius'}' (its arrays: {listed(sorted(arrays))});"
        " give the name of the array of radii as radius="
    )
