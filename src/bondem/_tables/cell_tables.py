"""Tables of `core/tables/cell_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Int32s, Ints, Singles, Uint32s


class ElasticFacets(NamedTuple):
    """Bonded facets, m of them; facets without force follow if they are fewer than a group of lanes.

    Levers are whole multiples of a pitch, shares and H are in single precision. Their conversion to doubles is exact,
    and passes read half as many bytes.
    """

    i: Uint32s  #: first cell of each facet, (m,)
    j: Uint32s  #: second cell of each facet, (m,)
    integrity: Floats  #: 1 intact … 0 broken [-], (m,)
    k: Floats  #: stiffness 2 G A / L [N/m], (m,)
    pitch: Floats  #: unit of the levers along x, y, z [m], (3,)
    lever_i: Int32s  #: from the centre of mass of cell i to the facet [pitch], (3, m)
    lever_j: Int32s  #: from the centre of mass of cell j to the facet [pitch], (3, m)
    share_i: Singles  #: share in V θ of cell i, A w m [m²], (3, m)
    share_j: Singles  #: share in V θ of cell j, A w m [m²], (3, m)
    H: Singles  #: resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], (6, m)
    normal: Floats  #: from i to j in the reference [-], (3, m)
    period: Floats  #: edges of the periodic cell and their inverses, zero where there is none, (6,)


class CellDilatation(NamedTuple):
    """Cells, n of them, and the dilatation that their facets add up."""

    weight: Floats  #: λ / V [Pa/m³], (n,)
    given: Floats  #: part of V θ from tractions on free facets [m³], (n,)
    #: rest of V θ [m³], zero until facets add to it: n cells, then parts of shared cells by domains, (*,)
    swelling: Floats
    to_i: Uint32s  #: place in `swelling` where a facet adds to its cell i, (m,)


class DilatationGradients(NamedTuple):
    """Springs between the stresses λ θ of neighbouring cells, and bending of layers one cell thick."""

    start: Ints  #: springs of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    other: Uint32s  #: cell on the other side, (springs,)
    spring: Floats  #: stiffness c of each spring [m³/Pa], (springs,)
    difference: Floats  #: Σ c (σ_p - σ_q) of each cell [m³], (n,)
    layer: Ints  #: start of the facets of cell p within its layer; layered is n, or 0, (layered + 1,)
    next: Uint32s  #: cell on the other side, (turns,)
    #: n × s of the cell and of the other one for both directions, n normal to the layer, signs for the cell as i
    #: [m²], (turns, 12)
    way: Floats
    wall_start: Ints  #: start of the walls that fix cell p of a layer, (layered + 1,)
    wall: Ints  #: number of the wall, (layer_walls,)
    wall_way: Floats  #: n × s of the wall for both directions, in space [m²], (layer_walls, 6)
    weight: Floats  #: J λ / V² for both directions [Pa/m], (layered, 2)
    bend: Floats  #: J λ χ / V for both directions, then their changes by small motions [Pa·m], (layered, 4)
    torque: Floats  #: on each cell by bent layers [N·m], (layered, 3)


class CorrectedMass(NamedTuple):
    """Dispersion-corrected mass of cells, with which short waves of pressure keep their speed."""

    in_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_bond: Uint32s  #: facets of each cell, as in `FacetsOfCells`, (*,)
    factor: Floats  #: ρ β / V of each cell [kg/m⁶], (n,)
    wall_start: Ints  #: walls of cell p are wall[wall_start[p]] …, (n + 1,)
    wall: Ints  #: numbers of the walls, cell by cell, (supports,)
    acceleration: Floats  #: acceleration of each element by its loads [m/s², rad/s²], (n, 6)
    inertia: Floats  #: ρ β θ̈ of each cell [Pa], (n,)
    force: Floats  #: force and torque of the correction on each element [N, N·m], (n, 6)


class CellEnergies(NamedTuple):
    """Energies of all facets, cells and walls."""

    energy: Floats  #: normal, shear, bending, twisting [J], (4,)


class CellPoses(NamedTuple):
    """Poses of cells; passes write the stresses λ θ in them."""

    pose: Floats  #: (n, 8)
    rest: Floats  #: centres in the reference [m], (n, 3)


class FacetForces(NamedTuple):
    """Forces of facets and moments of cells, which criteria of cracks and yielding need."""

    bends: Floats  #: factor 4 k / A² of v·H v in T_b² [N/m⁵], (m,)
    force: Floats  #: force of each facet on its cell i in the last step [N], (3, m)
    moment: Floats  #: V σ of each cell, xx, yy, zz, xy, xz, yz [J], and Σ T_b² of its facets [Pa²], (n, 7)
    sums: Floats  #: V σ and Σ T_b² (xx, yy, zz, Σ T_b², xy, xz, yz, 0) in rows as `StepBlocks.sums`, (*, 8)


class FacetsOfCells(NamedTuple):
    """Facets of each cell: first those of which it is j, then those of which it is i."""

    in_start: Ints  #: facets in_start[p] … in_start[p + 1] - 1 have j = p, (n + 1,)
    out_start: Ints  #: facets with i = p are out_bond[out_start[p]] …, (n + 1,)
    out_bond: Uint32s  #: facets by their cells i, (*,)


class FacetRelease(NamedTuple):
    """Effect of failing facets on their cells, n of them; a failed facet is a free facet of both cells."""

    whole: Floats  #: λ / V of each cell with all its facets [Pa/m³], (n,)
    weight: Floats  #: λ / V with the unbroken facets: the array of `CellDilatation`, (n,)
    given: Floats  #: array `given` of `CellDilatation`, (n,)
    slack_i: Floats  #: increase of 1 / weight of cell i if the facet fails [m³/Pa], (bonds,)
    slack_j: Floats  #: increase of 1 / weight of cell j if the facet fails [m³/Pa], (bonds,)
    in_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_start: Ints  #: facets of each cell, as in `FacetsOfCells`, (n + 1,)
    out_bond: Uint32s  #: facets of each cell, as in `FacetsOfCells`, (bonds,)
    wall_start: Ints  #: walls of each cell: wall(wall_start(p)) … wall(wall_start(p + 1) - 1), (n + 1,)
    wall: Ints  #: ascending, (supports,)
    changed: Uint32s  #: cells of the facets that fail in a step, then their neighbours, (n,)
    changes: Ints  #: number of these cells, (1,)


class WallConstraints(NamedTuple):
    """Facets on the surface that walls fix or support, each by the half facet of its cell."""

    cell: Ints  #: (supports,)
    row: Ints  #: row of the boundary that the cell owns, (supports,)
    k: Floats  #: 2 G A / d [N/m], (supports,)
    lever: Floats  #: from the centre of the cell to the facet in the reference [m], (supports, 3)
    arm: Floats  #: lever with stress-free and plastic strains of the cell [m], (supports, 3)
    share: Floats  #: A m along the fixed axes [m²], (supports, 3)
    H: Floats  #: resistance to rotation, xx, yy, zz, xy, xz, yz [N·m], (supports, 6)
    base: Floats  #: origin of the motion of the wall [m], and the quaternion of the cell there, (supports, 7)
    axes: Floats  #: 1 where fixed, along x, y, z, (supports, 3)
    drive: Ints  #: schedule that moves the wall along x, y, z, or -1, (supports, 3)
    rate: Bytes  #: 1 for schedules of velocities, (support_schedules,)
    times: Floats  #: times of the schedules, one after the other [s], (support_times,)
    values: Floats  #: values of the schedules at these times, (support_times,)
    start: Ints  #: start of each schedule, (support_schedules + 1,)
    wall: Floats  #: displacement of the wall now [m], (supports, 3)
    increment: Floats  #: displacement of the wall in this step [m], (supports, 3)
    load: Floats  #: force and torque on the cell [N, N·m], (supports, 6)
    friction: Floats  #: μ of a wall on which the facet may slide, NaN if it may not, (supports,)
    inward: Floats  #: axis along which a wall with friction presses on the cell, (supports, 3)


class FacetTractions(NamedTuple):
    """Tractions on free facets, which change the dilatation of their cells."""

    value: Floats  #: contribution of each to V θ of the cells at full load [m³], (tractions, n)
    schedule: Ints  #: (tractions,)
    factor: Floats  #: present factors, (tractions,)
    increment: Floats  #: changes of the factors in this step, (tractions,)


class CellStrains(NamedTuple):
    """Stress-free strains of cells that change in time."""

    schedule: Ints  #: (strains,)
    base_i: Floats  #: levers of cells i in the reference [m], (3, strained)
    base_j: Floats  #: levers of cells j in the reference [m], (3, strained)
    still: Floats  #: 1 + ε* of each facet without the strains that change, (strained,)
    part: Floats  #: strain of each facet at factor 1, (strains, strained)
    wall_base: Floats  #: levers of walls [m], (supports, 3)
    wall_still: Floats  #: 1 + ε* at each wall without the strains that change, (supports,)
    wall_part: Floats  #: strain at each wall at factor 1, (strains, supports)
    place: int  #: place of their work in the list of works
    factor: Floats  #: rows: factors a step ago and now, ∂U/∂factor [J] a step ago and now, (4, strains)
    power: Ints  #: exact sums of ∂U/∂factor [J], zero between steps, (strains, 68)
    due: Bytes  #: flags by `strain_due`: ∂U/∂factor is needed; levers have changed, (2,)


class WallTime(NamedTuple):
    """Time at which walls are placed."""

    time: float  #: [s]


class TurnedVectors(NamedTuple):
    """Vectors, and their rotations by unit quaternions."""

    quaternion: Floats  #: w x y z, (vectors, 4)
    vector: Floats  #: (vectors, 3)
    turned: Floats  #: (vectors, 3)


class MomentsOfForces(NamedTuple):
    """Forces on elements, and the moments V σ of the elements."""

    moment: Floats  #: xx, yy, zz, xy, yz, zx [J], (*, 6)
    owner: Ints  #: element that each force acts on, (vectors,)
    arm: Floats  #: arm of each force from the centre of its element [m], (vectors, 3)
    force: Floats  #: [N], (vectors, 3)
    sign: float  #: factor of all moments [-]
