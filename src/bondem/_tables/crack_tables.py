"""Tables of `core/tables/crack_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Int32s, Ints, Uint32s


class StressesOfCells(NamedTuple):
    """Mean stresses of n cells, and Σ b⊗f of their cracks."""

    volume: Floats  #: [m³], (n,)
    tensor: Floats  #: stress in the last step, xx … yz [Pa], Σ T_b² [Pa²], size [Pa], (n, 8)
    #: Σ b⊗f of cracks, b in the reference and f in space: b_x f, b_y f, b_z f [J], and a number after each, the
    #: first of which is 0 for cells that have had no crack, (n, 12)
    carried: Floats
    pressed: Floats  #: contribution of loads on free facets to V σ at full load [J], (*, n, 6)


class YieldingCells(NamedTuple):
    """Cells that yield."""

    cone: int  #: whether by Drucker and Prager
    cohesion: Floats  #: c cos φ or k [Pa], inf for cells that do not yield, (n,)
    slope: Floats  #: (n,)
    dilation: Floats  #: (n,)
    stiffness: Floats  #: [Pa], (n,)
    fade: Floats  #: share of the cohesion lost by a mean slip of 1 of the cells near, (n,)
    near_start: Ints  #: cells near cell p are near[near_start[p]] …, (n + 1,)
    near: Uint32s  #: (*,)
    slipped: Floats  #: Σ Δγ before this step, which other cells read, (n,)
    carry: Floats  #: that of a state: slip that the next step begins with, (n,)
    plastic: Floats  #: P - 1 by rows, Σ Δγ, last increment of strain in space, energy dissipated [J], (n, 17)
    base_i: Int32s  #: levers of facets without plastic strain [pitch], (3, m)
    base_j: Int32s  #: levers of facets without plastic strain [pitch], (3, m)
    base_wall: Floats  #: those of walls [m], (supports, 3)


class FacetStrengths(NamedTuple):
    """Strengths of m facets."""

    area: Floats  #: [m²], (m,)
    strength: Floats  #: f_t [Pa], (m,)
    absorbed: Floats  #: G_f A [J], inf of brittle facets, (m,)
    brittleness: Floats  #: 1 over the traction k u / A of the last opening [1/Pa], (m,)
    part: Floats  #: part of cell i in the compliance, (m,)
    fastest: Floats  #: largest loss of integrity in a step of facets that break at once, (m,)
    friction: Floats  #: tan φ, μ of closed cracks, (m,)
    plane: Floats  #: 1 for facets of material planes, (m,)
    cohesion: Floats  #: cohesion of these [Pa], (m,)
    slip_brittleness: Floats  #: the same as `brittleness` for slip [1/Pa], (m,)
    planes: Ints  #: facets of material planes, (*,)
    kink: float  #: of the softening curve
    steep: float  #: of the softening curve
    hot: float  #: √(σ:σ) of a cell from which its facets are judged [Pa]


class CrackOnset(NamedTuple):
    """Facets that begin to crack."""

    cracked: Bytes  #: 1 for cells with cracks, (n,)
    judged: Bytes  #: 1 for cells whose facets are judged, 2 for those without cohesion, (n,)
    #: 1 for facets that begin to crack, 2 for those of a cell without cohesion; zero between steps, (m,)
    marked: Bytes
    listed: Bytes  #: that of `CohesiveCracks`, (m,)
    found: Ints  #: number of marks of each portion of facets, and of planes, (bond_portions + 1,)


class CohesiveCracks(NamedTuple):
    """Cracked facets, by the number of their facet; rows as in `core/passes/cracks/crack_rows.hpp`."""

    shape: Floats  #: and so on, (facets, 8)
    face: Floats  #: (facets, 8)
    state: Floats  #: (facets, 8)
    frame: Floats  #: (facets, 8)
    past: Floats  #: (facets, 8)
    softening: Floats  #: (facets, 8)
    history: Floats  #: (facets, 8)
    pull: Floats  #: force on cell i [N], (facets, 4)
    lever: Int32s  #: levers of cells i and j in the reference, each and another number [pitch], (facets, 8)
    pitch: Floats  #: unit of levers [m], (3,)
    order: Ints  #: cracked facets in the order in which they began, (facets,)
    listed: Bytes  #: 0 for whole facets, else 1 and the status of the crack, (m,)
    integrity: Floats  #: that of a state, (facets,)
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
    """Lists of a step, and data of the cracks on them."""

    #: numbers of cracks treated one by one, of those that rest, of cells of the first, and of `parted`, (4,)
    size: Ints
    treated: Ints  #: cracks; lanes after the last one repeat it, (places,)
    resting: Ints  #: cracks; lanes after the last one repeat it, (places,)
    treated_i: Uint32s  #: their cells, (places,)
    treated_j: Uint32s  #: their cells, (places,)
    resting_i: Uint32s  #: their cells, (places,)
    resting_j: Uint32s  #: their cells, (places,)
    parted: Ints  #: facets whose faces have parted in this step, (places,)
    cell: Uint32s  #: cells of cracks that are treated one by one, (*,)
    head: Int32s  #: first half of each cell, (n,)
    next: Int32s  #: half of its cell that follows a half, (halves,)
    flag: Bytes  #: what becomes of a crack, by place, (places,)
    waking: Bytes  #: what becomes of a crack, by place, (places,)
    flagged: Ints  #: whether there is a flag in a portion, (crack_portions,)
    woken: Ints  #: whether there is a flag in a portion, (crack_portions,)
    outdated: Bytes  #: 1 for cells whose stress is to be found again, (n,)
    leader: Int32s  #: facet of the crack that leads those of a cell, -1 of none, (n,)
    base: Floats  #: V θ without cracks that are treated one by one [m³], (n,)
    #: `SwellingHalf` by the number of the half (`half_of`) and, once forces are known, `crack::LoadColumn`, (halves,
    #: 16): one memory for both, because the data of many cracks exceed the caches., (halves, 16)
    half: Floats
    sum: Floats  #: of the first eight columns of loads over the halves of a cell, (n, 8)
    slip: Floats  #: by how much the cracks of a cell slip in this step [m], and `crack::Slipping`, (n, 4)
    lost: Ints  #: exact sum of the energy dissipated in a step [J], (1, 68)


class PartedReach(NamedTuple):
    """Distances at which elements touch whose facet has parted."""

    apart: Floats  #: by facet [m], (*,)
