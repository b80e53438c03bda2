"""Surfaces made of connected broken facets: size, orientation and roughness."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints
from bondem.fracture.crack_faces import Faces
from bondem.fracture.crack_polygons import CrackPolygons


@dataclass(frozen=True, eq=False)
class CrackSurfaces:
    """Crack surfaces, s of them, the largest first; each has a mean plane through its centroid.

    Attributes:
        count: number of facets of each surface, shape (s,).
        area: total area of its facets [m²], shape (s,).
        projected_area: area projected onto its mean plane, Σ A |n·m| [m²], shape (s,); overhanging parts count too.
        normal: normal m of the mean plane, the direction along which Σ A (n·m)² is largest; its largest component is
            positive [-], shape (s, 3).
        roughness: area over projected area [-], at least 1, shape (s,).
        deviation: area-weighted root mean square distance of the facets' centroids from the mean plane [m], (s,).
        position: centroid [m], shape (s, 3).
        extent: extent of the corners of its facets along x, y and z [m], shape (s, 3).
    """

    count: Ints
    area: Floats
    projected_area: Floats
    normal: Floats
    roughness: Floats
    deviation: Floats
    position: Floats
    extent: Floats

    def __len__(self) -> int:
        return len(self.area)


def crack_surfaces(faces: Faces, polygons: CrackPolygons, label: Ints, shift: Floats) -> CrackSurfaces:
    """Compute size, orientation and roughness of the surface formed by the facets of each label.

    Args:
        faces: geometry of k facets.
        polygons: outlines of the facets.
        label: number of the surface of each facet, shape (k,).
        shift: shift that brings the facets of a periodic surface side by side [m], shape (k, 3).
    """
    s = int(label.max(initial=-1)) + 1
    A, n, place = faces.area, faces.normal, faces.centroid + shift

    def sums(values: Floats) -> Floats:
        total = np.zeros((s, *values.shape[1:]))
        np.add.at(total, label, values)
        return total

    area = np.bincount(label, A, s).astype(float)
    fabric = sums(A[:, None, None] * n[:, :, None] * n[:, None, :])
    mean = np.asarray(np.linalg.eigh(fabric)[1][:, :, 2], dtype=float)
    largest = np.take_along_axis(mean, np.abs(mean).argmax(axis=1)[:, None], axis=1)
    mean = mean * np.sign(largest)
    flat = np.bincount(label, A * np.abs((n * mean[label]).sum(axis=1)), s).astype(float)
    middle = sums(A[:, None] * place) / area[:, None]
    off = ((place - middle[label]) * mean[label]).sum(axis=1)
    row = np.repeat(polygons.facet, np.diff(polygons.start))
    corner = polygons.vertex + shift[row]
    lower, upper = np.full((s, 3), np.inf), np.full((s, 3), -np.inf)
    np.minimum.at(lower, label[row], corner)
    np.maximum.at(upper, label[row], corner)
    return CrackSurfaces(
        count=np.bincount(label, minlength=s), area=area, projected_area=flat, normal=mean, roughness=area / flat,
        deviation=np.sqrt(np.bincount(label, A * off**2, s) / area), position=middle, extent=upper - lower,
    )  # fmt: skip
