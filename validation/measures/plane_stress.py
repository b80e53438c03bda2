"""Bodies in plane stress with one cohesive crack on a line of symmetry: its tip is the control.

Bilinear quadrilaterals with two by two Gauss points; unknowns are x and y of each node in turn. The body is condensed
on the nodes of the crack and the load. The tip of the crack is set, node after node, at the strength; the load that
goes with it follows, and snap-back does no harm (Petersson 1981).
"""

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
from scipy.sparse import coo_array, csc_array
from scipy.sparse.linalg import splu

from bondem._types import Floats, Ints
from bondem.errors import ConvergenceError

# Rounds until no opening changes its line of the softening curve, and what counts as no opening, over the last one.
_ROUNDS, _SMALL = 200, 1e-12


def quads(number: Ints) -> Ints:
    """Corners of the elements between nodes that are numbered on a grid, (k, m), (e, 4)."""
    return np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)


def stiffness(nodes: Floats, elements: Ints, E: float, nu: float, width: float = 1.0) -> Any:
    """Stiffness of elements between nodes (n, 2) [m], as a sparse matrix [N/m], (2n, 2n)."""
    D = width * E / (1.0 - nu**2) * np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu)]])
    place, block = nodes[elements], np.zeros((len(elements), 8, 8))
    for a in (-(3**-0.5), 3**-0.5):
        for b in (-(3**-0.5), 3**-0.5):
            slope = 0.25 * np.array([[b - 1, 1 - b, 1 + b, -1 - b], [a - 1, -1 - a, 1 + a, 1 - a]])
            jacobian = slope @ place
            dx, dy = np.moveaxis(np.linalg.solve(jacobian, np.broadcast_to(slope, (len(place), 2, 4))), 1, 0)
            B = np.zeros((len(place), 3, 8))
            B[:, 0, 0::2] = B[:, 2, 1::2] = dx
            B[:, 1, 1::2] = B[:, 2, 0::2] = dy
            block += np.einsum("eki,kl,elj,e->eij", B, D, B, np.linalg.det(jacobian))
    dof = (2 * elements[:, :, None] + np.arange(2)).reshape(-1, 8)
    i, j = np.broadcast_to(dof[:, :, None], block.shape), np.broadcast_to(dof[:, None, :], block.shape)
    return coo_array((block.ravel(), (i.ravel(), j.ravel())), shape=(2 * len(nodes),) * 2).tocsc()


def tied(matrix: Any, together: Ints) -> tuple[Any, Ints]:
    """The matrix with some unknowns as one, which comes last, and the new number of each unknown."""
    number = np.empty(matrix.shape[0], dtype=int)
    free = np.setdiff1d(np.arange(len(number)), together)
    number[free], number[together] = np.arange(len(free)), len(free)
    tie = csc_array((np.ones(len(number)), (np.arange(len(number)), number)))
    return (tie.T @ matrix @ tie).tocsc(), number


def condensed(matrix: Any, held: Ints, kept: Ints) -> Floats:
    """Stiffness of the kept unknowns, with others free but those that are held."""
    inner = np.setdiff1d(np.arange(matrix.shape[0]), np.r_[held, kept])
    mixed = matrix[:, kept][inner].toarray()
    return matrix[:, kept][kept].toarray() - mixed.T @ splu(matrix[:, inner][inner]).solve(mixed)


def crack_path(
    body: Floats, area: Floats, opening: Floats, stress: Floats, tips: Iterable[int]
) -> Iterator[tuple[float, float]]:
    """Force of the load on the body, and its displacement, as the tip goes from node to node.

    Args:
        body: stiffness of half openings, from where the crack begins, and of the displacement of the load, the last.
        area: of the crack that belongs to each of its nodes, (n,).
        opening, stress: corners of the softening curve, from no opening at the strength to the last one at none.
        tips: nodes at which the tip is set.

    Raises:
        ConvergenceError: openings that change their lines for ever.
    """
    slope = np.append(np.diff(stress) / np.diff(opening), 0.0)
    at_zero = stress - slope * opening
    lines = np.zeros(len(area), dtype=int)  # those of the last tip are the first guess
    for tip in tips:
        # unknown: half openings of what is open, and the displacement; the tip is closed at the strength
        moved, open_, line = np.append(np.arange(tip), len(area)), np.arange(tip), lines[:tip]
        for _ in range(_ROUNDS):
            system = body[np.ix_(np.arange(tip + 1), moved)]
            system[open_, open_] += 2.0 * slope[line] * area[:tip]
            found = np.linalg.solve(system, -np.append(at_zero[line], stress[0]) * area[: tip + 1])
            now = np.searchsorted(opening, 2.0 * found[:tip] + _SMALL * opening[-1], side="right") - 1
            before, line = line, np.clip(now, 0, len(opening) - 1)
            if (line == before).all():
                break
        else:
            raise ConvergenceError(f"a cohesive crack finds no openings with its tip at node {tip}")
        lines[:tip] = line
        yield float(body[-1, moved] @ found), float(found[-1])
