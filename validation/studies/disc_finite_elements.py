"""Strength of a splitting disc by finite elements with one cohesive crack: what discs of cells are compared with.

Plane stress, bilinear quadrilaterals with 2 x 2 Gauss points, one quarter of the disc of `brazilian.py`: flattened by
20 degrees at both ends, smooth rigid platens on the flats. The crack runs along the loaded diameter from the centre.
Its traction falls along a straight line from f_t to nothing at 2 G_f / f_t. The body is condensed on the nodes of the
crack and the load; the tip is put at each node in turn, where the traction is f_t, so that the path may snap back.
The strength is the first maximum of k 2P / (pi D t) over f_t, k of the flattened disc. It depends on Poisson's ratio
and on E G_f / f_t^2 over D alone.

A beam in three-point bending, whose span is four depths, checks the same elements and crack: by Planas, Guinea and
Elices (1999) f_r / f_t = 1 + 1 / (0.85 + 2.3 D f_t^2 / (E G_f)). That leaves out the stress concentration of the
load, and finite elements are 3 to 5 % above it.
"""

import math
from typing import Any

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

from validation.cases.flattened_disc import HALF
from validation.frame.record import Record
from validation.studies.brazilian import DISC, LAW, TENSION

#: E G_f / f_t^2 over the diameter of discs, and the depth of beams over E G_f / f_t^2.
DISCS, BEAMS = (0.25, 1.0, 4.0), (0.25, 0.5, 1.0, 2.0, 4.0)
#: Elements along the radius and around of a disc; two meshes show what is left of the error.
MESHES = ((60, 40), (90, 60))
#: How far a crack goes, over the depth of a beam and the radius of a disc.
DEEPEST = 0.8


def stiffness(corners: np.ndarray) -> np.ndarray:
    """Of a quadrilateral of unit thickness, (8, 8)."""
    elastic = LAW.E / (1.0 - LAW.nu**2) * np.array(
        [[1.0, LAW.nu, 0.0], [LAW.nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - LAW.nu)]]
    )  # fmt: skip
    found, point = np.zeros((8, 8)), 1.0 / math.sqrt(3.0)
    for a in (-point, point):
        for b in (-point, point):
            slope = 0.25 * np.array([[b - 1, 1 - b, 1 + b, -1 - b], [a - 1, -1 - a, 1 + a, 1 - a]])
            jacobian = slope @ corners
            g = np.linalg.solve(jacobian, slope)
            strain = np.zeros((3, 8))
            strain[0, 0::2], strain[1, 1::2] = g
            strain[2, 0::2], strain[2, 1::2] = g[1], g[0]
            found += strain.T @ elastic @ strain * np.linalg.det(jacobian)
    return found


def assembled(nodes: np.ndarray, elements: np.ndarray) -> sparse.csc_matrix:
    """Stiffness of all elements."""
    dofs = np.stack([2 * elements, 2 * elements + 1], axis=2).reshape(len(elements), 8)
    values = np.array([stiffness(nodes[element]) for element in elements])
    rows, columns = np.repeat(dofs, 8, axis=1).ravel(), np.tile(dofs, (1, 8)).ravel()
    return sparse.csc_matrix((values.ravel(), (rows, columns)), shape=(2 * len(nodes),) * 2)


def condensed(matrix: sparse.csc_matrix, held: np.ndarray, kept: np.ndarray) -> np.ndarray:
    """Stiffness of the kept unknowns, with others free but those that are held."""
    inner = np.setdiff1d(np.arange(matrix.shape[0]), np.r_[held, kept])
    across = matrix[inner][:, kept].toarray()
    return matrix[kept][:, kept].toarray() - across.T @ splu(matrix[inner][:, inner].tocsc()).solve(across)


def crack_path(body: np.ndarray, width: np.ndarray, last: float) -> tuple[np.ndarray, np.ndarray]:
    """Load, and opening where the crack begins, as its tip goes from node to node, to `DEEPEST` of the way.

    Args:
        body: stiffness of half openings and of the displacement of the load, which is the last one.
        width: of the crack that belongs to each of its nodes.
        last: opening at which it bears nothing.
    """
    loads, mouths = [], []
    for tip in range(1, round(DEEPEST * len(width))):
        apart = np.zeros(tip, dtype=bool)
        chosen = np.r_[np.arange(tip), len(width)]
        for _ in range(50):
            falls, begins = (np.where(apart, 0.0, one) * width[:tip] for one in (2.0 * TENSION / last, TENSION))
            system = body[np.ix_(np.r_[np.arange(tip), tip], chosen)].copy()
            system[:tip, :tip] -= np.diag(falls)
            moved = np.linalg.solve(system, np.r_[-begins, -width[tip] * TENSION])
            if ((2.0 * moved[:tip] > last) == apart).all():
                break
            apart = 2.0 * moved[:tip] > last
        else:
            raise RuntimeError(f"tractions behind the tip at node {tip} do not settle")
        loads.append(abs(body[-1, chosen] @ moved))
        mouths.append(2.0 * moved[0])
    return np.array(loads), np.array(mouths)


def _grid(first: int, second: int) -> np.ndarray:
    at = np.arange((first + 1) * (second + 1)).reshape(first + 1, second + 1)
    return np.stack([at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]], axis=2).reshape(-1, 4)


def beam(share: float, along: int = 60, across: int = 80) -> float:
    """Bending strength over f_t of a beam of depth 1 and span 4, whose depth is a share of E G_f / f_t^2."""
    x = np.linspace(0.0, 1.0, along + 1) ** 1.6 * 2.25
    support = int(np.argmin(abs(x - 2.0)))
    x[support] = 2.0
    nodes = np.array([(a, b) for a in x for b in np.linspace(0.0, 1.0, across + 1)])
    matrix = assembled(nodes, _grid(along, across))
    middle = np.arange(across + 1)  # nodes of the cut at mid-span, from the side in tension
    kept = np.r_[2 * middle, 2 * across + 1]
    body = condensed(matrix, np.array([2 * support * (across + 1) + 1]), kept)
    width = np.full(across + 1, 1.0 / across)
    width[[0, -1]] *= 0.5
    loads, _ = crack_path(body, width, 2.0 * TENSION / LAW.E / share)
    return 1.5 * 2.0 * float(loads.max()) * 4.0 / TENSION


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
    elements = np.stack([at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]], axis=2).reshape(-1, 4)
    matrix = assembled(nodes, elements)
    # all nodes of the flat move as one along y
    platen, unknowns = 2 * at[-1, flat] + 1, np.arange(2 * len(nodes))
    number = np.full(len(unknowns), -1)
    rest = np.setdiff1d(unknowns, platen)
    number[rest], number[platen] = np.arange(len(rest)), len(rest)
    tied = sparse.csc_matrix((np.ones(len(unknowns)), (unknowns, number)), shape=(len(unknowns), len(rest) + 1))
    crack = np.r_[0, at[1:, -1]]
    held = number[np.unique(2 * at[:, 0] + 1)]
    body = condensed((tied.T @ matrix @ tied).tocsc(), held, np.r_[number[2 * crack], len(rest)])
    pieces = np.diff(nodes[crack, 1])
    width = 0.5 * (np.r_[pieces, 0.0] + np.r_[0.0, pieces])
    last = 2.0 * share * TENSION / LAW.E
    loads, mouths = crack_path(body, width, last)
    stress = DISC.factor * 2.0 * 2.0 * loads / math.pi / TENSION
    top = next((k for k in range(1, len(stress) - 1) if stress[k - 1] <= stress[k] > stress[k + 1]), None)
    return {
        "share": share, "along": along, "around": around, "elastic": float(stress[0]),
        "strength": None if top is None else float(stress[top]),
        "crack": None if top is None else (top + 1) / along,
        "opening": None if top is None else float(mouths[top] / last),
        "deepest": float(stress[-1]),
    }  # fmt: skip


def measure(record: Record) -> None:
    """Split discs and bend beams of several sizes."""
    beams = [{"share": one, "strength": beam(one), "Planas": 1.0 + 1.0 / (0.85 + 2.3 * one)} for one in BEAMS]
    record.keep(beams=beams, discs=[disc(share, *mesh) for share in DISCS for mesh in MESHES])
