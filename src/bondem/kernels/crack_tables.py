"""The tables of facets that soften and cells that yield, as kernels take them."""

from typing import NamedTuple

import numpy as np

# Columns of a cracked facet: which, strength [Pa] (0 where a cell of it had lost its cohesion), slip in the frame of
# cell i [m], -∂U/∂s now [J], how it is treated, integrity a step ago, friction force a step ago in space [N], energy
# dissipated [J], and of a crack at rest the force below which it does not soften, whatever its direction [N]. Once
# faces no longer face each other, the last is the distance of centres at which their cells touch [m].
FACET, ONSET, SLIP, RATE, STATUS, BEFORE, RUB, SPENT, TOP = 0, 1, 2, 5, 6, 7, 8, 11, 12
CRACK_COLUMNS = 13
# How cracked facets are treated: one by one; as facets of less stiffness among all others, while they are open and do
# not soften; and not at all, once their faces no longer face each other.
ACTIVE, RESTING, PARTED = 0, 1, 2
# How many there are: cracks, cells with some that are treated one by one, rows logged, cracks that are treated one by
# one, and that rest.
CRACKS, CELLS, LOGGED, TREATED_ONES, AT_REST = range(5)
# Columns of a cell that yields: P - 1 of its plastic deformation P in its own frame, row by row, Σ Δγ, the last
# increment of strain in space xx, yy, zz, xy, xz, yz, energy dissipated [J].
DEFORMATION, GAMMA, INCREMENT, HEAT = 0, 9, 10, 16
PLASTIC_COLUMNS = 17
# Columns of what is known of a crack in a step: gap [m], normal, shares of both sides [m²], levers of both [m],
# cosine of the angle between the normals of both sides.
GAP, NORMAL, SHARE_I, SHARE_J, ARM_I, ARM_J, FACING = 0, 3, 6, 9, 12, 15, 18
GEOMETRY_COLUMNS = 19
# Columns of a half, by which the stress of its cell is found: g·δ, k g·δ [N·m²], g²/w, g·n, g·n/w, k δ·n, (1 - s)/k;
# and 1 where the crack is treated one by one.
SWOLLEN, PULLED, SQUARE, ALONG, PRESSED, CLOSED, LOOSE, TREATED = range(8)
HALF_COLUMNS = 8
# Columns of what a crack does in a step.
TORQUE_I, TORQUE_J, RUBBED_AWAY, LOST = 0, 3, 6, 7
OUTPUT_COLUMNS = 8


class CellStresses(NamedTuple):
    """Mean stresses of n cells; kernels write the last two."""

    volume: np.ndarray  #: [m³], (n,)
    tensor: np.ndarray  #: mean stress in the last step, in space, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    bending: np.ndarray  #: Σ T_b² of the facets of a cell, but for cracks [Pa²], (n,)


class CellYield(NamedTuple):
    """Cells that yield; n cells, g walls that hold some, l loads on free facets. Kernels write `plastic`."""

    yielding: bool  #: whether any do
    cone: bool  #: by Drucker–Prager, else by Mohr–Coulomb
    cohesion: np.ndarray  #: c cos φ of each cell, or k of a cone [Pa]; inf where it does not yield, (n,)
    sine: np.ndarray  #: sin φ, or α, (n,)
    dilation: np.ndarray  #: sin ψ, or β, (n,)
    fade: np.ndarray  #: V^(1/3) c / 2 G_II, k in place of c: share of the cohesion lost by Δγ of 1, (n,)
    G: np.ndarray  #: [Pa], of a cone G + 9 K α β, (n,)
    base_i: np.ndarray  #: levers without plastic strain, int32, (3, m) or (3, 0)
    base_j: np.ndarray
    base_grip: np.ndarray  #: the same of walls [m], (g, 3)
    pressed: np.ndarray  #: what each load on free facets adds to V σ of the cells at full load [J], (l, n, 6)
    plastic: np.ndarray  #: (n, 17) or (0, 17)


class Onset(NamedTuple):
    """Which facets begin to crack; m facets, n cells. Kernels write the last three."""

    strength: np.ndarray  #: f_t of each facet [Pa], (m,)
    area: np.ndarray  #: [m²], (m,)
    plane: np.ndarray  #: facets of material planes, judged by their traction, (p,)
    hot: float  #: largest principal stress of a cell from which its facets are looked at [Pa]
    judge: int  #: address of the function that judges a stress, 0 for the largest principal stress
    given: np.ndarray  #: parameters of that function
    cracked: np.ndarray  #: 1 for cells with cracks, however treated, uint8, (n,)
    least: float  #: size √(σ:σ) below which no stress is judged: its index is below 1 [Pa]
    tension: float  #: f_t without scatter [Pa]: a facet is judged by its stress times this over its own
    hotter: np.ndarray  #: 1 for cells whose facets are looked at, 2 for those without cohesion, uint8, (n,)
    marked: np.ndarray  #: 1 for facets that begin to crack, 2 for those of a cell without cohesion, uint8, (m,)
    listed: np.ndarray  #: not 0 for facets that have begun, uint8, (m,)


class CrackedFacets(NamedTuple):
    """Facets that soften; m facets, n cells. A half is one side of a crack: 2 c on cell i of crack c, 2 c + 1 on j.

    From `now` on kernels write.
    """

    last: np.ndarray  #: k u / A where nothing is left of a facet, 0 where it breaks at once [Pa], (m,)
    part: np.ndarray  #: w_i: part of cell i in the compliance, (m,)
    fastest: np.ndarray  #: by how much the integrity of what breaks at once falls in a step at most, (m,)
    area: np.ndarray  #: [m²], (m,)
    kink: float  #: of the softening curve, and
    steep: float  #: its first line (`bondem.laws.softening.softened`)
    friction: np.ndarray  #: μ of each facet, (m,)
    plane: np.ndarray  #: 1 for facets of material planes, uint8, (m,)
    cohesion: np.ndarray  #: of these [Pa], inf for those that do not slip and for all others, (m,)
    last_slip: np.ndarray  #: k u / A of these where no cohesion is left [Pa], (m,)
    tensor: np.ndarray  #: that of `CellStresses`
    weight: np.ndarray  #: λ / V of each cell with all its facets [Pa/m³], (n,)
    slack_i: np.ndarray  #: what 1 / weight of cell i gains where the facet parts [m³/Pa], (m,)
    slack_j: np.ndarray
    now: np.ndarray  #: time [s] and step; a step below 0 where nothing is to change, (2,)
    integrity: np.ndarray  #: 1 whole … 0 broken, (m,)
    listed: np.ndarray  #: 0 for whole facets, 1 and how they are treated for cracks, uint8, (m,)
    row: np.ndarray  #: cracked facets in the order in which they began, (m, 13)
    sizes: np.ndarray  #: of the lists (`CRACKS` …), (5,)
    facet: np.ndarray  #: of each crack, (m,)
    active: np.ndarray  #: cracks that are treated one by one, in that order, (m,)
    resting: np.ndarray  #: those that rest, (m,)
    flag: np.ndarray  #: what is to be done with a crack, uint8, (m,)
    geometry: np.ndarray  #: (m, 19)
    half: np.ndarray  #: (2 m, 8), zeros for cracks that are not treated one by one
    cell: np.ndarray  #: cells with cracks that are treated one by one, (n,)
    head: np.ndarray  #: first half of a cell, or -1, (n,)
    after: np.ndarray  #: the next half of its cell, or -1, (2 m,)
    stale: np.ndarray  #: 1 for cells whose stress is to be found again in this step, uint8, (n,)
    base: np.ndarray  #: V θ of cells without the cracks that are treated one by one [m³], (n,)
    pull: np.ndarray  #: force of each crack on its cell i [N], (m, 3)
    output: np.ndarray  #: torques on both cells [N·m], energy lost to friction and to the crack in a step [J], (m, 8)
    load: np.ndarray  #: force and torque of all cracks on each cell [N, N·m], (n, 6)
    log: np.ndarray  #: what broke in this call (`BROKEN_…`), (m, 9)
    released: np.ndarray  #: energy that cracks have dissipated since the start of the run [J], (1,)


class CrackTable(NamedTuple):
    """Facets that soften and cells that yield."""

    stress: CellStresses
    flow: CellYield
    onset: Onset
    facets: CrackedFacets
