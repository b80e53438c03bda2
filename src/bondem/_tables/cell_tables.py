"""Tables of `core/tables/cell_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Int32s, Ints, Singles, Uint32s


class ElasticFacets(NamedTuple):
    """Bonded facets, m of them; fewer than a group are followed by facets without force.

    Levers are whole multiples of a pitch, shares and H single precision: results from them are exact, and passes read
    half as much.
    """

    i: Uint32s  #: (m,)
    j: Uint32s  #: (m,)
    integrity: Floats  #: 1 intact … 0 broken [-], (m,)
    k: Floats  #: 2 G A / L [N/m], (m,)
    pitch: Floats  #: unit of the levers along x, y, z [m], (3,)
    lever_i: Int32s  #: from the centres of mass to the facet [pitch], (3, m)
    lever_j: Int32s  #: from the centres of mass to the facet [pitch], (3, m)
    share_i: Singles  #: A w m [m²], (3, m)
    share_j: Singles  #: A w m [m²], (3, m)
    H: Singles  #: resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], (6, m)
    normal: Floats  #: from i to j in the reference [-], (3, m)
    period: Floats  #: edges of the periodic cell and their inverses, zero where there is none, (6,)


class CellDilatation(NamedTuple):
    """Cells, n of them, and the dilatation that their facets add up."""

    weight: Floats  #: λ / V [Pa/m³], (n,)
    given: Floats  #: part of V θ from tractions on free facets [m³], (n,)
    swelling: Floats  #: the rest of V θ [m³], zero between passes: of n cells, then of shared cells by domains, (*,)
    to_i: Uint32s  #: place in `swelling` where a facet adds to its cell i, (m,)


class DilatationGradients(NamedTuple):
    """Springs between the stresses λ θ of neighbouring cells, and bending of layers one cell thick."""

    start: Ints  #: springs of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    other: Uint32s  #: cell on the other side, (springs,)
    spring: Floats  #: c [m³/Pa], (springs,)
    difference: Floats  #: Σ c (σ_p - σ_q) of each cell [m³], (n,)
    layer: Ints  #: facets of cell p within its layer, (layered + 1,); layered is n, or 0, (layered + 1,)
    next: Uint32s  #: cell on the other side, (turns,)
    way: Floats  #: n × s of the cell and of the other, for both directions, turned to the cell as i [m²], (turns, 12)
    wall_start: Ints  #: walls that hold cell p of a layer, (layered + 1,)
    wall: Ints  #: number of the wall, (layer_walls,)
    wall_way: Floats  #: n × s of the wall for both directions, in space [m²], (layer_walls, 6)
    weight: Floats  #: J λ / V² for both directions [Pa/m], (layered, 2)
    bend: Floats  #: J λ χ / V for both directions, and by small motions [Pa·m], (layered, 4)
    torque: Floats  #: on each cell by bent layers [N·m], (layered, 3)


class CorrectedMass(NamedTuple):
    """The mass that waves of pressure lack in cells of finite size."""

    in_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_bond: Uint32s  #: (*,)
    factor: Floats  #: ρ β / V of each cell [kg/m⁶], (n,)
    wall_start: Ints  #: walls of cell p are wall[wall_start[p]] …, (n + 1,)
    wall: Ints  #: (supports,)
    acceleration: Floats  #: of each element by its loads [m/s², rad/s²], (n, 6)
    inertia: Floats  #: ρ β θ̈ of each cell [Pa], (n,)
    force: Floats  #: force and torque of the correction on each element [N, N·m], (n, 6)


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
    sums: Floats  #: sums of them in rows as `StepBlocks.sums`, (*, 8)


class FacetsOfCells(NamedTuple):
    """Facets of each cell: first those of which it is j, then those of which it is i."""

    in_start: Ints  #: facets in_start[p] … in_start[p + 1] have j = p, (n + 1,)
    out_start: Ints  #: those with i = p are out_bond[out_start[p]] …, (n + 1,)
    out_bond: Uint32s  #: (*,)


class FacetRelease(NamedTuple):
    """Effect of failing facets on their cells, n of them; a failed facet is a free facet of both cells."""

    whole: Floats  #: λ / V of each cell with all its facets [Pa/m³], (n,)
    weight: Floats  #: λ / V with the unbroken facets: the array of `CellDilatation`, (n,)
    given: Floats  #: the array of `CellDilatation`, (n,)
    slack_i: Floats  #: increase of 1 / weight of cell i if the facet fails [m³/Pa], (bonds,)
    slack_j: Floats  #: increase of 1 / weight of cell j if the facet fails [m³/Pa], (bonds,)
    in_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_start: Ints  #: (n + 1,)
    out_bond: Uint32s  #: (bonds,)
    wall_start: Ints  #: walls of each cell: wall(wall_start(p)) … wall(wall_start(p + 1) - 1), (n + 1,)
    wall: Ints  #: ascending, (supports,)
    changed: Uint32s  #: cells of the facets that fail in a step, then their neighbours, (n,)
    changes: Ints  #: their number, (1,)


class WallConstraints(NamedTuple):
    """Facets on the surface that walls hold, g of them, each by the half facet of its cell."""

    cell: Ints  #: (supports,)
    row: Ints  #: row of the boundary that the cell owns, (supports,)
    k: Floats  #: 2 G A / d [N/m], (supports,)
    lever: Floats  #: from the centre of the cell to the facet in the reference [m], (supports, 3)
    arm: Floats  #: the same with stress-free and plastic strains of the cell [m], (supports, 3)
    share: Floats  #: A m along the fixed axes [m²], (supports, 3)
    H: Floats  #: resistance to rotation, xx, yy, zz, xy, xz, yz [N·m], (supports, 6)
    base: Floats  #: origin of the motion of the wall [m], and the quaternion of the cell there, (supports, 7)
    axes: Floats  #: 1 where fixed, along x, y, z, (supports, 3)
    drive: Ints  #: schedule that moves the wall along x, y, z, or -1, (supports, 3)
    rate: Bytes  #: 1 for schedules of velocities, (support_schedules,)
    times: Floats  #: schedules, one after the other, (support_times,)
    values: Floats  #: schedules, as `Timeline` has them, (support_times,)
    start: Ints  #: (support_schedules + 1,)
    wall: Floats  #: displacement of the wall now [m], (supports, 3)
    increment: Floats  #: of it in this step [m], (supports, 3)
    load: Floats  #: force and torque on the cell [N, N·m], (supports, 6)
    friction: Floats  #: μ of a wall on which the facet may slide, NaN for one that holds it, (supports,)
    inward: Floats  #: axis along which such a wall presses on the cell, (supports, 3)


class FacetTractions(NamedTuple):
    """Tractions on free facets, l of them, which change the dilatation of their cells."""

    value: Floats  #: contribution of each to V θ at full load [m³], (tractions, n)
    schedule: Ints  #: (tractions,)
    factor: Floats  #: present factors, (tractions,)
    increment: Floats  #: of them in this step, (tractions,)


class CellStrains(NamedTuple):
    """Stress-free strains of cells that change in time, g of them."""

    schedule: Ints  #: (strains,)
    base_i: Floats  #: levers of the reference [m], (3, strained)
    base_j: Floats  #: levers of the reference [m], (3, strained)
    still: Floats  #: 1 + ε* of the state, (strained,)
    part: Floats  #: strain of each facet at factor 1, (strains, strained)
    wall_base: Floats  #: levers of walls [m], (supports, 3)
    wall_still: Floats  #: (supports,)
    wall_part: Floats  #: (strains, supports)
    place: int  #: of their work in the list of works
    factor: Floats  #: of each strain: now, its increment, ∂U/∂factor before and now [J], (4, strains)
    power: Ints  #: exact sums of ∂U/∂factor [J], zero between steps, (strains, 68)
    due: Bytes  #: 1 where ∂U/∂factor is needed, and where levers have changed, (2,)


class WallTime(NamedTuple):
    """Time that walls are placed at."""

    time: float  #: [s]


class TurnedVectors(NamedTuple):
    """Vectors, k of them, and the same rotated by unit quaternions."""

    quaternion: Floats  #: w x y z, (vectors, 4)
    vector: Floats  #: (vectors, 3)
    turned: Floats  #: (vectors, 3)


class MomentsOfForces(NamedTuple):
    """Forces on elements, k of them, and V σ of the elements."""

    moment: Floats  #: xx, yy, zz, xy, yz, zx [J], (*, 6)
    owner: Ints  #: element that each force acts on, (vectors,)
    arm: Floats  #: from its centre [m], (vectors, 3)
    force: Floats  #: [N], (vectors, 3)
    sign: float
