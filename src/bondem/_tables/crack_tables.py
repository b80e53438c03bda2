"""Tables of `core/tables/crack_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Int32s, Ints, Uint32s


class StressesOfCells(NamedTuple):
    """Mean stresses of n cells, and Σ b⊗f of their cracks, with the forces f at the levers b."""

    volume: Floats  #: [m³], (n,)
    tensor: Floats  #: stress in the last step, xx … yz [Pa], Σ T_b² [Pa²], size [Pa], (n, 8)
    #: Σ b⊗f of cracks, b in the reference and f in space: b_x f, b_y f, b_z f [J], and a number after each, the
    #: first of which is 0 for cells that have had no crack, (n, 12)
    carried: Floats
    pressed: Floats  #: contribution of loads on free facets to V σ at full load [J], (*, n, 6)


class YieldingCells(NamedTuple):
    """Strengths and plastic strains of cells that yield."""

    cone: int  #: 1 for Drucker and Prager, 0 for Mohr and Coulomb
    cohesion: Floats  #: c cos φ or k [Pa], inf for cells that do not yield, (n,)
    slope: Floats  #: sin φ, or α [-], (n,)
    dilation: Floats  #: sin ψ, or β [-], (n,)
    stiffness: Floats  #: H [Pa], (n,)
    fade: Floats  #: share of the cohesion lost at a mean slip of 1 of the cells nearby, (n,)
    near_start: Ints  #: cells near cell p are near[near_start[p]] …, (n + 1,)
    near: Uint32s  #: (*,)
    slipped: Floats  #: Σ Δγ before this step, which other cells read, (n,)
    carry: Floats  #: array of the state: slip with which the next step begins, (n,)
    plastic: Floats  #: P - 1 by rows, Σ Δγ, last increment of strain in space, energy dissipated [J], (n, 17)
    base_i: Int32s  #: levers of facets without plastic strain [pitch], (3, m)
    base_j: Int32s  #: levers of facets without plastic strain [pitch], (3, m)
    base_wall: Floats  #: levers of walls without plastic strain [m], (supports, 3)


class FacetStrengths(NamedTuple):
    """Strengths of m facets."""

    area: Floats  #: [m²], (m,)
    strength: Floats  #: f_t [Pa], (m,)
    absorbed: Floats  #: fracture energy G_f A [J], inf of brittle facets, (m,)
    brittleness: Floats  #: 1 over the traction k u / A of the last opening [1/Pa], (m,)
    part: Floats  #: part of cell i in the compliance, (m,)
    fastest: Floats  #: largest loss of integrity in a step of facets that break at once, (m,)
    friction: Floats  #: tan φ, μ of closed cracks, (m,)
    plane: Floats  #: 1 for facets of material planes, (m,)
    cohesion: Floats  #: cohesion of facets of material planes [Pa], (m,)
    slip_brittleness: Floats  #: `brittleness` for slip along a material plane [1/Pa], (m,)
    planes: Ints  #: facets of material planes, (*,)
    kink: float  #: κ of the softening curve [-]
    steep: float  #: m of the softening curve [-]
    hot: float  #: √(σ:σ) + √Σ T_b² of a cell above which its facets are evaluated [Pa]


class CrackOnset(NamedTuple):
    """Marks of facets that begin to crack, and of cells whose facets are evaluated."""

    cracked: Bytes  #: 1 for cells with cracks, (n,)
    judged: Bytes  #: 1 for cells whose facets are evaluated, 2 for those without cohesion, (n,)
    #: 1 for facets that begin to crack, 2 for those of a cell without cohesion; zero between steps, (m,)
    marked: Bytes
    listed: Bytes  #: `listed` of `CohesiveCracks`, (m,)
    found: Ints  #: number of marks of each portion of facets, and of planes, (bond_portions + 1,)


class CohesiveCracks(NamedTuple):
    """Cracked facets, by the number of their facet; rows as in `core/passes/cracks/crack_rows.hpp`."""

    shape: Floats  #: `CrackShapeRow`, (facets, 8)
    face: Floats  #: `CrackFaceRow`, (facets, 8)
    state: Floats  #: `CrackStateRow`, (facets, 8)
    frame: Floats  #: `CrackFrameRow`, (facets, 8)
    past: Floats  #: `CrackPastRow`, (facets, 8)
    softening: Floats  #: `CrackSofteningRow`, (facets, 8)
    history: Floats  #: `CrackHistoryRow`, (facets, 8)
    pull: Floats  #: force on cell i [N], (facets, 4)
    lever: Int32s  #: levers of cells i and j in the reference, each with an unused number [pitch], (facets, 8)
    pitch: Floats  #: unit of levers [m], (3,)
    order: Ints  #: cracked facets in the order in which they began, (facets,)
    listed: Bytes  #: 0 for whole facets, else 1 plus the `crack::CrackStatus`, (m,)
    integrity: Floats  #: integrity of cracks, array of the state [-], (facets,)
    size: Ints  #: number of cracks, and 1 where lists are out of date, (2,)
    slide: float  #: largest slip of faces of material planes that face each other, over √A, at most 1 [-]


class CellSlack(NamedTuple):
    """Facets of each cell, and the increase of 1 / weight of the cell if a facet breaks."""

    in_start: Ints  #: facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    out_start: Ints  #: facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    out_bond: Uint32s  #: (*,)
    slack_i: Floats  #: increase of 1 / weight of cell i if the facet parts [m³/Pa], (m,)
    slack_j: Floats  #: increase of 1 / weight of cell j if the facet parts [m³/Pa], (m,)
    weight: Floats  #: λ / V of each cell with all its facets [Pa/m³], (n,)


class CrackLists(NamedTuple):
    """Lists of active and of resting cracks in a step, and data of the cracks on them."""

    size: Ints  #: numbers of entries by `list_count`, (4,)
    treated: Ints  #: active cracks; lanes after the last one repeat it, (places,)
    resting: Ints  #: resting cracks; lanes after the last one repeat it, (places,)
    treated_i: Uint32s  #: cells i of active cracks, (places,)
    treated_j: Uint32s  #: cells j of active cracks, (places,)
    resting_i: Uint32s  #: cells i of resting cracks, (places,)
    resting_j: Uint32s  #: cells j of resting cracks, (places,)
    parted: Ints  #: facets whose faces have parted in this step, (places,)
    cell: Uint32s  #: cells of active cracks, (*,)
    head: Int32s  #: first half of an active crack at each cell, 0 without, (n,)
    next: Int32s  #: half at the same cell that follows a half, 0 at the end, (halves,)
    flag: Bytes  #: `crack::Flag` of active cracks, by place, (places,)
    waking: Bytes  #: `crack::Flag` of resting cracks, by place, (places,)
    flagged: Ints  #: above 0 for a portion of active cracks with a flag, (crack_portions,)
    woken: Ints  #: above 0 for a portion of resting cracks with a flag, (crack_portions,)
    outdated: Bytes  #: 1 for cells whose stress has to be found again, (n,)
    leader: Int32s  #: facet of the leading crack of each cell, -1 without, (n,)
    base: Floats  #: V θ without active cracks [m³], (n,)
    #: `SwellingHalf` of each half by its number (`half_of`), replaced by loads (`crack::LoadColumn`) once forces are
    #: known: one memory for both, because the data of many cracks exceed the caches, (halves, 16)
    half: Floats
    sum: Floats  #: sums of the first eight columns of loads over the halves of each cell, (n, 8)
    slip: Floats  #: slip of the cracks of each cell in this step [m], and `crack::Slipping`, (n, 4)
    lost: Ints  #: exact sum of the energy dissipated in a step [J], (1, 68)


class PartedReach(NamedTuple):
    """Distances of centres at which two cells touch once their facet has parted."""

    apart: Floats  #: distance of each facet [m], (*,)
