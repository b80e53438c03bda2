"""A square plate split between two strips as a continuum with one cohesive crack along its axis of load.

One quarter in plane stress (`validation.measures.plane_stress`). The strips are rigid and smooth. The crack begins at
the centre. It softens along a straight line of last opening 2 G_f/f_t.
"""

from dataclasses import dataclass

import numpy as np

from validation.measures.plane_stress import condensed, crack_path, quads, stiffness, tied


@dataclass(frozen=True)
class SplitPlate:
    """Loads of a plate as 2 P / (π D t) over f_t.

    Attributes:
        elastic: as the first facet cracks, by elasticity alone [-].
        peak: first maximum; the largest where there is none [-].
    """

    elastic: float
    peak: float


def split_plate(length: float, strip: float, nu: float, across: int = 50) -> SplitPlate:
    """Path of a plate of edge 1, strength 1 and E G_f / f_t² of a given length.

    Args:
        length: E G_f / f_t² over the edge [-].
        strip: width of the strips over the edge [-].
        nu: Poisson's ratio [-].
        across: elements across a quarter, along each axis.
    """
    at = np.linspace(0.0, 0.5, across + 1)
    number = np.arange((across + 1) ** 2).reshape(across + 1, across + 1)  # x, y
    nodes = np.stack(np.meshgrid(at, at, indexing="ij"), axis=-1).reshape(-1, 2)
    under = 2 * number[at <= 0.5 * strip + 1e-9, -1] + 1
    matrix, new = tied(stiffness(nodes, quads(number), 1.0, nu), under)
    body = condensed(matrix, new[2 * number[:, 0] + 1], np.append(new[2 * number[0]], new[under[0]]))
    area = np.full(across + 1, 0.5 / across)
    area[0] = area[-1] = 0.25 / across
    # openings in units of f_t / E
    stress: list[float] = []
    for load, _ in crack_path(body, area, np.array([0.0, 2.0 * length]), np.array([1.0, 0.0]), range(across)):
        stress.append(4.0 * abs(load) / np.pi)
        if len(stress) > 2 and stress[-3] <= stress[-2] > stress[-1]:
            return SplitPlate(stress[0], stress[-2])
    return SplitPlate(stress[0], max(stress))
