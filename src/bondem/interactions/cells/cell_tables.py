"""Facets and cells as the core takes them, and its passes over a body in any poses.

`core/tables/cell_tables.hpp` declares types and shapes.
"""

from typing import NamedTuple

import numpy as np

from bondem._core import Pass
from bondem._types import Floats, Ints, PerBond
from bondem.boundary.wall_constraints import WallConstraints
from bondem.geometry.rotations import turned_vectors
from bondem.interactions.beams.beam_tables import BeamSums, Poses
from bondem.interactions.beams.bond_table import with_twins, with_zeros
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.cells.dilatation_gradients import GradientConstants
from bondem.specimen.ordering import Layout

#: Column of a pose that holds the stress λ θ of a cell [Pa].
STRESS = 3


class ElasticFacets(NamedTuple):
    """Bonded facets, m of them, and a few without force behind them where they are fewer than a group."""

    i: np.ndarray  #: uint32
    j: np.ndarray
    integrity: Floats  #: 1 intact … 0 broken [-]
    k: Floats  #: 2 G A / L [N/m]
    pitch: Floats  #: unit of the levers along x, y, z [m], (3,)
    lever_i: np.ndarray  #: from the centres of mass to the facet [pitch], int32, (3, m)
    lever_j: np.ndarray
    share_i: np.ndarray  #: A w m [m²], float32, (3, m)
    share_j: np.ndarray
    H: np.ndarray  #: resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], float32, (6, m)
    normal: Floats  #: from i to j in the reference [-], (3, m)
    period: Floats  #: edges of the periodic cell and their inverses, (6,)


class CellDilatation(NamedTuple):
    """Cells, n of them, and the dilatation that their facets add up."""

    weight: Floats  #: λ / V [Pa/m³], (n,)
    given: Floats  #: part of V θ from tractions on free facets [m³], (n,)
    swelling: Floats  #: the rest of V θ [m³], zero between passes: of n cells, then of shared cells by domains
    to_i: np.ndarray  #: place in `swelling` where a facet adds to its cell i, uint32, (m,)


class DilatationGradients(NamedTuple):
    """Springs between the stresses λ θ of neighbouring cells, and bending of layers one cell thick."""

    start: Ints  #: springs of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    other: np.ndarray  #: cell on the other side, uint32, (springs,)
    spring: Floats  #: c [m³/Pa], (springs,)
    difference: Floats  #: Σ c (σ_p - σ_q) of each cell [m³], (n,)
    layer: Ints  #: facets of cell p within its layer, (layered + 1,); layered is n, or 0
    next: np.ndarray  #: cell on the other side, uint32, (turns,)
    way: Floats  #: n × s of the cell and of the other, for both directions, turned to the cell as i [m²], (turns, 12)
    hold: Ints  #: walls that hold cell p of a layer, (layered + 1,)
    wall: Ints  #: number of the wall, (layer_walls,)
    wall_way: Floats  #: n × s of the wall for both directions, in space [m²], (layer_walls, 6)
    weight: Floats  #: J λ / V² for both directions [Pa/m], (layered, 2)
    bend: Floats  #: J λ χ / V for both directions [Pa·m], (layered, 2)
    torque: Floats  #: on each cell by bent layers [N·m], (layered, 3)
    energy: Floats  #: of both in portions of cells [J]


class CorrectedMass(NamedTuple):
    """The mass that waves of pressure lack in cells of finite size."""

    in_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_start: Ints
    out_bond: np.ndarray  #: uint32
    factor: Floats  #: ρ β / V of each cell [kg/m⁶], (n,)
    wall_start: Ints  #: walls of cell p are wall[wall_start[p]] …, (n + 1,)
    wall: Ints  #: (held,)
    acceleration: Floats  #: of each element by its loads [m/s², rad/s²], (n, 6)
    inertia: Floats  #: ρ β θ̈ of each cell [Pa], (n,)
    force: Floats  #: force and torque of the correction on each element [N, N·m], (n, 6)


class DilatationEnergy(NamedTuple):
    """Energy of dilatation in portions of cells."""

    energy: Floats  #: [J]


class CellEnergies(NamedTuple):
    """Energies of all facets, cells and walls."""

    energy: Floats  #: normal, shear, bending, twisting [J], (4,)


class CellPoses(NamedTuple):
    """Poses of cells, whose stresses passes write."""

    pose: Floats  #: (n, 8)
    rest: Floats  #: centres in the reference [m], (n, 3)


class FacetForces(NamedTuple):
    """Forces of facets and moments of cells, which criteria of cracks and yielding need."""

    bends: Floats  #: 4 k / A², by which bending is a traction [1/(N m³)], (m,)
    force: Floats  #: of each facet on its cell i in the last step [N], (3, m)
    moment: Floats  #: V σ of each cell, xx, yy, zz, xy, xz, yz [J], and the square of its bending [Pa²], (n, 7)
    sums: Floats  #: sums of them in rows as `StepCut.sums`, (rows, 8)


class FacetsOfCells(NamedTuple):
    """Facets of each cell: first those of which it is j, then those of which it is i."""

    in_start: Ints  #: facets in_start[p] … in_start[p + 1] have j = p, (n + 1,)
    out_start: Ints  #: those with i = p are out_bond[out_start[p]] …, (n + 1,)
    out_bond: np.ndarray  #: uint32


class FacetRelease(NamedTuple):
    """Effect of failing facets on their cells, n of them; a failed facet is a free facet of both cells."""

    whole: Floats  #: λ / V of each cell with all its facets [Pa/m³], (n,)
    weight: Floats  #: with those it has left: the array of `CellDilatation`
    given: Floats  #: that of `CellDilatation` too
    slack_i: Floats  #: gain of 1 / weight of each side where a facet fails [m³/Pa], (bonds,)
    slack_j: Floats
    in_start: Ints  #: facets of each cell, as in `FacetsOfCells`
    out_start: Ints
    out_bond: np.ndarray  #: uint32
    wall_start: Ints  #: walls wall[wall_start[p] …] hold cell p, (n + 1,)
    wall: Ints  #: (g,)
    changed: np.ndarray  #: cells of the facets that fail in a step, then their neighbours, uint32, (n,)
    changes: Ints  #: their number, (1,)


class FacetTractions(NamedTuple):
    """Tractions on free facets, l of them, which change the dilatation of their cells."""

    value: Floats  #: contribution of each to V θ at full load [m³], (l, n)
    schedule: Ints  #: (l,)
    place: int  #: in the list of works
    factor: Floats  #: present factors, (l,)
    came: Floats  #: their increments in this step, (l,)


class CellStrains(NamedTuple):
    """Stress-free strains of cells that change in time, g of them."""

    schedule: Ints  #: (g,)
    base_i: Floats  #: levers of the reference [m], (3, facets)
    base_j: Floats
    still: Floats  #: 1 + ε* of the state, (facets,)
    part: Floats  #: strain of each facet at factor 1, (g, facets)
    wall_base: Floats  #: levers of walls [m], (w, 3)
    wall_still: Floats  #: (w,)
    wall_part: Floats  #: (g, w)
    place: int  #: of their work in the list of works
    factor: Floats  #: of each strain: now, its increment, ∂U/∂factor before and now [J], (4, g)
    power: Floats  #: ∂U/∂factor of portions of facets [J], (portions, g)
    cracked: Floats  #: ∂U/∂factor of cracks, where there are any [J], (g,)
    due: np.ndarray  #: 1 where ∂U/∂factor is needed, and where levers have changed, uint8, (2,)


class WallTime(NamedTuple):
    """Time that walls are placed at."""

    time: float  #: [s]


_load_body = Pass(
    "load_body", CellPoses, ElasticFacets, CellDilatation, DilatationGradients, WallConstraints, BeamSums
)  # fmt: skip
_load_facets = Pass("load_facets", Poses, ElasticFacets, BeamSums)
_measure = Pass(
    "measure_cell_energies", CellPoses, ElasticFacets, CellDilatation, DilatationGradients, WallConstraints,
    CellEnergies,
)  # fmt: skip
_weigh_cells = Pass("weigh_cells", ElasticFacets, FacetRelease)
_place_walls = Pass("place_walls", WallConstraints, WallTime)


def cell_tables(
    cells: CellConstants, layout: Layout, period: Floats, integrity: PerBond, to_i: np.ndarray
) -> tuple[ElasticFacets, CellDilatation]:
    """Return facets and cells as the core takes them.

    Args:
        cells: constants in the order of the layout.
        layout: cells of the facets.
        period: edges of the periodic cell and their inverses, (6,).
        integrity: integrity of the facets [-], (m,).
        to_i: place where each facet adds to V θ of its cell i, uint32, (m,).
    """

    def rows(each: Floats, kind: type) -> np.ndarray:
        return np.ascontiguousarray(with_zeros(each.T.astype(kind)))

    def whole(lever: Floats) -> np.ndarray:
        return rows(np.rint(lever / cells.pitch), np.int32)

    facets = ElasticFacets(
        i=with_twins(layout.i), j=with_twins(layout.j), integrity=with_zeros(integrity), k=with_zeros(cells.k),
        pitch=cells.pitch, lever_i=whole(cells.lever_i), lever_j=whole(cells.lever_j),
        share_i=rows(cells.share_i, np.float32), share_j=rows(cells.share_j, np.float32),
        H=rows(cells.H.reshape(-1, 9)[:, [0, 4, 8, 1, 2, 5]], np.float32), normal=rows(cells.normal, np.float64),
        period=period,
    )  # fmt: skip
    count = max(len(cells.weight), int(to_i.max(initial=0)) + 1)
    return facets, CellDilatation(cells.weight.copy(), cells.pressed.copy(), np.zeros(count), with_twins(to_i))


def gradient_tables(
    gradients: GradientConstants, n: int, walls: WallConstraints, portions: int = 0
) -> DilatationGradients:
    """Return gradients of the dilatation as the core takes them.

    Args:
        gradients: constants in internal order.
        n: number of cells.
        walls: walls that hold facets of the cells.
        portions: number of portions of cells whose energies are summed.
    """
    start, order, other = _of_cells(gradients.i, gradients.j, n)
    layered = len(gradients.weight)
    layer, rows, following = _of_cells(gradients.a, gradients.b, layered)
    way = np.concatenate([
        np.concatenate([gradients.way_a, gradients.way_b], axis=1),
        -np.concatenate([gradients.way_b, gradients.way_a], axis=1),
    ]).reshape(-1, 12)[rows]  # fmt: skip
    held = gradients.held
    cell = walls.cell[held]
    by_cell = np.argsort(cell, kind="stable")
    hold = np.concatenate([[0], np.cumsum(np.bincount(cell, minlength=layered))]).astype(np.int64)
    turned = turned_vectors(np.repeat(walls.base[held, 3:], 2, axis=0), gradients.held_way.reshape(-1, 3))
    return DilatationGradients(
        start, other, np.tile(gradients.spring, 2)[order], np.zeros(n), layer, following, np.ascontiguousarray(way),
        hold, held[by_cell], np.ascontiguousarray(turned.reshape(-1, 6)[by_cell]),
        np.ascontiguousarray(gradients.weight), np.zeros((layered, 2)), np.zeros((layered, 3)), np.zeros(portions),
    )  # fmt: skip


def _of_cells(i: Ints, j: Ints, n: int) -> tuple[Ints, Ints, np.ndarray]:
    """Return where the sides of each of n cells begin, the order of all sides, and the cells on the other sides."""
    near, far = np.concatenate([i, j]), np.concatenate([j, i])
    order = np.argsort(near, kind="stable")
    start = np.concatenate([[0], np.cumsum(np.bincount(near, minlength=n))]).astype(np.int64)
    return start, order, far[order].astype(np.uint32)


def facet_release(
    constants: CellConstants, layout: Layout, facets: ElasticFacets, cells: CellDilatation, walls: WallConstraints
) -> FacetRelease:
    """Return the effect of failing facets on their cells, and weigh the cells by the facets that they have left.

    Args:
        constants: constants of the whole body in the order of the layout.
        layout: cells of the facets.
        facets: facets with their integrity.
        cells: cells, whose weights are set.
        walls: walls that hold facets of the cells.
    """
    n = len(constants.weight)
    wall_start = np.concatenate([[0], np.cumsum(np.bincount(walls.cell, minlength=n))]).astype(np.int64)
    release = FacetRelease(
        constants.weight, cells.weight, cells.given, constants.slack_i, constants.slack_j, layout.in_start,
        layout.out_start, layout.out_bond, wall_start, np.argsort(walls.cell, kind="stable").astype(np.int64),
        np.zeros(n, dtype=np.uint32), np.zeros(1, dtype=np.int64),
    )  # fmt: skip
    _weigh_cells(facets, release)
    return release


def load_body(
    all_cells: CellPoses, facets: ElasticFacets, cells: CellDilatation, gradients: DilatationGradients,
    walls: WallConstraints, sums: Floats,
) -> None:  # fmt: skip
    """Set the stresses of the cells in the poses, and add the loads of facets and walls to the sums, (n, 8)."""
    _load_body(all_cells, facets, cells, gradients, walls, BeamSums(facets.i, facets.j, sums))


def load_all_facets(pose: Floats, facets: ElasticFacets, sums: BeamSums) -> None:
    """Add force and torque of all facets to rows of the sums, at the stresses in the poses."""
    _load_facets(Poses(pose), facets, sums)


def body_energies(
    all_cells: CellPoses, facets: ElasticFacets, cells: CellDilatation, gradients: DilatationGradients,
    walls: WallConstraints,
) -> tuple[float, float, float, float]:  # fmt: skip
    """Return normal (with dilatation), shear, bending and twisting energy of facets, cells and walls [J]."""
    found = np.empty(4)
    _measure(all_cells, facets, cells, gradients, walls, CellEnergies(found))
    normal, shear, bending, twisting = found.tolist()
    return normal, shear, bending, twisting


def place_held_walls(walls: WallConstraints, time: float) -> None:
    """Bring walls to a time [s]."""
    _place_walls(walls, WallTime(time))
