"""Tables of facets and cells in the layout of the core, and passes that evaluate a body in any pose.

`core/tables/cell_tables.hpp` declares types and shapes.
"""

import numpy as np

from bondem._core import run_pass
from bondem._indices import group_starts
from bondem._passes import calls
from bondem._tables.cell_tables import (
    CellDilatation,
    DilatationGradients,
    ElasticFacets,
    FacetRelease,
    WallConstraints,
    WallTime,
)
from bondem._types import Floats, Ints, PerBond
from bondem.geometry.rotations import turned_vectors
from bondem.interactions.beams.bond_table import with_twins, with_zeros
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.cells.dilatation_gradients import GradientConstants
from bondem.specimen.ordering import Layout

#: Column of a pose with the stress λ θ of a cell [Pa].
STRESS = 3


def cell_tables(
    cells: CellConstants, layout: Layout, period: Floats, integrity: PerBond, to_i: np.ndarray
) -> tuple[ElasticFacets, CellDilatation]:
    """Return the tables of facets and cells in the layout of the core; facets share arrays of the constants.

    Args:
        cells: constants in the order of the layout.
        layout: cells of the facets.
        period: edges of the periodic cell and their inverses, (6,).
        integrity: integrity of the facets [-], (m,).
        to_i: row of V θ that each facet adds to for its cell i, uint32, (m,).
    """
    levers = cells.levers
    if cells.strain.size:
        levers = np.array([np.rint(each / cells.pitch).T for each in (cells.lever_i, cells.lever_j)], dtype=np.int32)
    facets = ElasticFacets(
        i=with_twins(layout.i), j=with_twins(layout.j), integrity=with_zeros(integrity), k=with_zeros(cells.k),
        pitch=cells.pitch, lever_i=with_zeros(levers[0]), lever_j=with_zeros(levers[1]),
        share_i=with_zeros(cells.shares[0]), share_j=with_zeros(cells.shares[1]), H=with_zeros(cells.bend),
        normal=with_zeros(cells.direction), period=period,
    )  # fmt: skip
    count = max(len(cells.weight), int(to_i.max(initial=0)) + 1)
    return facets, CellDilatation(cells.weight.copy(), cells.pressed.copy(), np.zeros(count), with_twins(to_i))


def gradient_tables(gradients: GradientConstants, n: int, walls: WallConstraints) -> DilatationGradients:
    """Return the table of gradients of the dilatation in the layout of the core.

    Args:
        gradients: constants in internal order.
        n: number of cells.
        walls: walls that constrain facets of the cells.
    """
    near, far, spring = gradients.springs()
    start, order, other = _of_cells(near, far, n)
    layered = len(gradients.weight)
    layer, rows, following = _of_cells(gradients.a, gradients.b, layered)
    way = np.concatenate([
        np.concatenate([gradients.way_a, gradients.way_b], axis=1),
        -np.concatenate([gradients.way_b, gradients.way_a], axis=1),
    ]).reshape(-1, 12)[rows]  # fmt: skip
    wall = gradients.wall
    cell = walls.cell[wall]
    by_cell = np.argsort(cell, kind="stable")
    turned = turned_vectors(np.repeat(walls.base[wall, 3:], 2, axis=0), gradients.wall_way.reshape(-1, 3))
    return DilatationGradients(
        start, other, np.tile(spring, 2)[order], np.zeros(n), layer, following, np.ascontiguousarray(way),
        group_starts(cell, layered), wall[by_cell], np.ascontiguousarray(turned.reshape(-1, 6)[by_cell]),
        np.ascontiguousarray(gradients.weight), np.zeros((layered, 4)), np.zeros((layered, 3)),
    )  # fmt: skip


def _of_cells(i: Ints, j: Ints, n: int) -> tuple[Ints, Ints, np.ndarray]:
    """Group the ends of facets by cell: starts of the n groups, (n + 1,), order of the ends, and cells opposite."""
    near, far = np.concatenate([i, j]), np.concatenate([j, i])
    order = np.argsort(near, kind="stable")
    return group_starts(near, n), order, far[order].astype(np.uint32)


def facet_release(
    constants: CellConstants, layout: Layout, facets: ElasticFacets, cells: CellDilatation, walls: WallConstraints
) -> FacetRelease:
    """Return the table by which failing facets change their cells, and set the weights of cells.

    Args:
        constants: constants of the whole body in the order of the layout.
        layout: cells of the facets.
        facets: facets with their integrity.
        cells: cells, whose weights are set by their unbroken facets.
        walls: walls that constrain facets of the cells.
    """
    n, (slack_i, slack_j) = len(constants.weight), constants.slack()
    release = FacetRelease(
        constants.weight, cells.weight, cells.given, slack_i, slack_j, *layout.adjacency, group_starts(walls.cell, n),
        np.argsort(walls.cell, kind="stable").astype(np.int64), np.zeros(n, dtype=np.uint32),
        np.zeros(1, dtype=np.int64),
    )  # fmt: skip
    run_pass(calls.weigh_cells(facets, release))
    return release


def place_supports(walls: WallConstraints, time: float) -> None:
    """Move walls that constrain facets to their places at a time [s], in place."""
    run_pass(calls.place_walls(walls, WallTime(time)))
