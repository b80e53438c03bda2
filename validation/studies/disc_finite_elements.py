"""Strength of a splitting disc by finite elements with one cohesive crack: what discs of cells are compared with.

Plane stress (`validation.measures.plane_stress`), one quarter of the disc of `brazilian.py`: flattened by 20 degrees
at both ends, smooth rigid platens on the flats. The crack runs along the loaded diameter from the centre. Its
traction falls along a straight line from f_t to nothing at 2 G_f / f_t. The strength is the first maximum of
k 2P / (pi D t) over f_t, k of the flattened disc. It depends on Poisson's ratio and on E G_f / f_t^2 over D alone.
"""

import math
from typing import Any

import numpy as np

from validation.cases.flattened_disc import HALF
from validation.frame.record import Record
from validation.measures.plane_stress import condensed, crack_path, quads, stiffness, tied
from validation.studies.brazilian import DISC, LAW, TENSION

#: E G_f / f_t^2 over the diameter.
DISCS = (0.25, 1.0, 4.0)
#: Elements along the radius and around of a disc; two meshes show what is left of the error.
MESHES = ((60, 40), (90, 60))
#: How far a crack goes, over the radius.
DEEPEST = 0.8


def disc(share: float, along: int, around: int) -> dict[str, Any]:
    """Strength of a disc of diameter 1 whose E G_f / f_t^2 is a share of it; None where the load has no maximum."""
    corner = 0.5 * math.pi - HALF
    angle = np.r_[np.linspace(0.0, corner, around + 1), np.linspace(corner, 0.5 * math.pi, 16)[1:]]
    flat = angle > corner - 1e-9
    reach = 0.5 * np.where(flat, math.cos(HALF) / np.sin(np.maximum(angle, 0.1)), 1.0)
    radius = np.linspace(0.0, 1.0, along + 1)[1:, None] * reach
    ring = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=2)
    nodes = np.concatenate([[(0.0, 0.0)], ring.reshape(-1, 2)])
    at = np.concatenate([np.zeros((1, len(angle)), dtype=int), 1 + np.arange(ring[..., 0].size).reshape(along, -1)])
    matrix, number = tied(stiffness(nodes, quads(at), LAW.E, LAW.nu), 2 * at[-1, flat] + 1)
    crack, load = np.r_[0, at[1:, -1]], number[2 * at[-1, -1] + 1]  # all nodes of the flat move as one along y
    body = condensed(matrix, number[np.unique(2 * at[:, 0] + 1)], np.r_[number[2 * crack], load])
    pieces = np.diff(nodes[crack, 1])
    width = 0.5 * (np.r_[pieces, 0.0] + np.r_[0.0, pieces])
    opening, falls = np.array([0.0, 2.0 * share * TENSION / LAW.E]), np.array([TENSION, 0.0])
    path = crack_path(body, width, opening, falls, range(1, round(DEEPEST * len(width))))
    loads = np.array([abs(load) for load, _ in path])
    stress = DISC.factor * 2.0 * 2.0 * loads / math.pi / TENSION
    top = next((k for k in range(1, len(stress) - 1) if stress[k - 1] <= stress[k] > stress[k + 1]), None)
    return {
        "share": share, "along": along, "around": around,
        "strength": None if top is None else float(stress[top]),
    }  # fmt: skip


def measure(record: Record) -> None:
    """Split discs of several sizes."""
    record.keep(discs=[disc(share, *mesh) for share in DISCS for mesh in MESHES])
