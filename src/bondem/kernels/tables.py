"""What the kernels take: named arrays, so that no two of them can be swapped.

A kernel gets a handful of these tuples instead of dozens of arrays, and the names say who may write what. They are
flat, because threads take no others. What only some runs have (`Alike`, `ContactTable`, `Added`, `Strain`, and what
bonds store in the incremental formulation) is an argument of its own, or None: that is decided when a kernel is
compiled, so what is absent costs nothing.

Rows of eight are one cache line: pose (x, y, z, λ θ of a cell, quaternion w x y z), motion (velocity, 1/m, angular
velocity, 1/I) and sums (force, 0, torque, 0).
"""

from typing import NamedTuple

import numpy as np

from bondem.kernels.couples import CoupleTable
from bondem.kernels.crack_tables import CrackTable
from bondem.kernels.strain_tables import StrainedCells

# Columns of a row of the pose, and of the motion.
QUATERNION = 4
INVERSE_MASS, SPIN, INVERSE_INERTIA = 3, 4, 7
# Columns of the losses of an element: energy taken by damping [J], its present power [W], lost to friction [J].
DAMPED, POWER, RUBBED = range(3)

# Columns of a record before the gauges.
(
    TIME, TRANSLATION, ROTATION, NORMAL, SHEAR, BENDING, TWISTING, CONTACT, WORK, LOSS, FRICTION, NON_LOCAL,
    FRACTURE, PLASTIC, FIXED_COLUMNS,
) = range(15)  # fmt: skip

# Columns of a breakage: time [s], step, bond, mode, gap [m], energy released [J], where [m].
BROKEN_TIME, BROKEN_STEP, BROKEN_BOND, BROKEN_MODE, BROKEN_GAP, BROKEN_ENERGY, BROKEN_PLACE = range(7)
BROKEN_COLUMNS = 9

# What a gauge reads of elements, and from WALL_DISPLACEMENT on of a wall.
(
    OF_DISPLACEMENT, OF_VELOCITY, OF_ROTATION, OF_SPIN, OF_FORCE, WALL_DISPLACEMENT, WALL_FORCE, WALL_GROWTH,
    WALL_VELOCITY,
) = range(9)  # fmt: skip
# How it makes one number of many.
MEAN, SUM, LARGEST = range(3)


class Elements(NamedTuple):
    """The motion of the elements, n of them; kernels write all but `rest`."""

    pose: np.ndarray  #: (n, 8)
    motion: np.ndarray  #: (n, 8)
    acceleration: np.ndarray  #: translational and rotational, at a pause [m/s², rad/s²], (n, 6)
    loss: np.ndarray  #: (n, 3)
    rest: np.ndarray  #: centres in the reference [m], (n, 3)
    load: np.ndarray  #: force and torque of contacts, cracks, pressed beams [N, N·m], (n, 6), or (0,) without


class Bonds(NamedTuple):
    """The bonds, m of them; kernels write rest length, `ks` and `lever` where a strain changes, and nothing else."""

    m: int  #: how many; where it is less than a loop takes at once, further bonds follow that bear no force
    i: np.ndarray  #: uint32, (m,)
    j: np.ndarray  #: uint32, after i, (m,)
    X0: np.ndarray  #: reference direction i→j [-], (m,)
    Y0: np.ndarray
    Z0: np.ndarray
    length: np.ndarray  #: at rest, L (1 + ε*) [m], (m,)
    kn: np.ndarray  #: [N/m]
    A: np.ndarray  #: constants of the energy [N·m]
    B: np.ndarray
    C: np.ndarray
    kt: np.ndarray  #: [N·m]
    ks: np.ndarray  #: [N/m]
    kb: np.ndarray  #: [N·m]
    lever: np.ndarray  #: of the contact point from i [m]
    integrity: np.ndarray  #: 1 intact … 0 broken [-]
    hold: np.ndarray  #: integrity over rest length [1/m]; only where bonds are alike, else (0,)
    period: np.ndarray  #: edges of the periodic cell and their inverses, zero where there is none, (6,)


class Adjacency(NamedTuple):
    """Bonds of each element; see `bondem.model.layout`."""

    in_start: np.ndarray  #: bonds in_start[p] … in_start[p + 1] end in p, (n + 1,)
    out_start: np.ndarray  #: those that begin in p are in …, (n + 1,)
    out_bond: np.ndarray  #: … this, from out_start[p] to out_start[p + 1], uint32, (m,)


class Alike(NamedTuple):
    """What all bonds share that differ in length only: Euler–Bernoulli bonds of one material and radius."""

    knL: float  #: kn L [N]
    AL: float  #: A L = C L [N·m²]
    BL: float
    ktL: float


class CellTable(NamedTuple):
    """The facets and cells of a body, m facets in the order of the bonds, n cells; kernels write the last four.

    `bends` and the last three are None where facets do not crack.
    """

    k: np.ndarray  #: [N/m], (m,)
    pitch: np.ndarray  #: unit of the levers along x, y, z [m], (3,)
    lever_i: np.ndarray  #: from the centre of i to the facet [pitch], int32, (3, m)
    lever_j: np.ndarray
    share_i: np.ndarray  #: A w M⁻¹n of both sides [m²], float32, (3, m)
    share_j: np.ndarray
    normal: np.ndarray  #: from i to j [-], (3, m)
    H: np.ndarray  #: resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], float32, (6, m)
    bends: np.ndarray | None  #: 4 k / A², by which bending is a traction (`bending_square`) [1/(N m³)], (m,)
    weight: np.ndarray  #: λ / V of each cell [Pa/m³], (n,)
    to_i: np.ndarray  #: where a facet adds to its cell i: there, or for the other domain, uint32, (m,)
    in_start: np.ndarray  #: facets of each cell, as `Adjacency` has them, where facets may crack; else empty
    out_start: np.ndarray
    out_bond: np.ndarray
    given: np.ndarray  #: part of V θ from tractions on free facets [m³], (n,)
    swelling: np.ndarray  #: the rest of V θ [m³], (n + …,)
    force: np.ndarray | None  #: of each facet on its cell i in the last step [N], (3, m)
    #: V σ of each cell, of its facets alone, in space, xx, yy, zz, xy, xz, yz [J], and Σ T_b² of these [Pa²], (n, 7)
    moment: np.ndarray | None
    sums: np.ndarray | None  #: what is being found of it, in rows as those of `StepCut.sums`, (…, 8)


class LaggedTable(NamedTuple):
    """Bonds of the non-local law, m of them, and its n elements; kernels write the last five."""

    area: np.ndarray  #: [m²], (m,)
    kn: np.ndarray  #: [N/m], (m,)
    kt: np.ndarray  #: [N/m], (m,)
    normal: np.ndarray  #: from i to j in the reference [-], (3, m)
    lever_i: np.ndarray  #: from the element i to the contact point in the reference [m], (3, m)
    lever_j: np.ndarray
    inverse: np.ndarray  #: 1 / V of each element [1/m³], (n,)
    nu: float  #: ν [-]
    limited: bool  #: whether the extra shear force is limited
    to_i: np.ndarray  #: where a bond adds to its element i: there, or for the other domain, uint32, (m,)
    history: np.ndarray  #: what bonds store (`bondem.kernels.non_local`), (7, m)
    stress: np.ndarray  #: of each element in its own frame, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    space: np.ndarray  #: the same in space, as the step has it so far, and bounds of σ1 and σ3 [Pa], (n, 8)
    moment: np.ndarray  #: what bonds and contacts add to V σ of each [N·m], zero between steps, (n + parts, 8)
    output: np.ndarray  #: force on i, torque on i, minus torque on j of each bond now [N, N·m], (9, m)


class GripTable(NamedTuple):
    """Facets of cells that walls hold, g of them (`bondem.kernels.grip_pass`); kernels write the last three."""

    cell: np.ndarray  #: (g,)
    row: np.ndarray  #: of the boundary, that the cell owns, (g,)
    k: np.ndarray  #: [N/m], (g,)
    lever: np.ndarray  #: from the centre of the cell to the facet [m], (g, 3)
    arm: np.ndarray  #: the same with the plastic strain of the cell [m], (g, 3)
    share: np.ndarray  #: A M⁻¹n along the held axes [m²], (g, 3)
    H: np.ndarray  #: xx, yy, zz, xy, xz, yz [N·m], (g, 6)
    base: np.ndarray  #: where the motion of the wall counts from [m], and the orientation of the cell there, (g, 7)
    axes: np.ndarray  #: 1 where held, along x, y, z, (g, 3)
    drive: np.ndarray  #: which schedule moves the wall along x, y, z, or -1, (g, 3)
    rate: np.ndarray  #: whether a schedule is a velocity, uint8
    times: np.ndarray  #: schedules, as `Schedules` has them
    values: np.ndarray
    start: np.ndarray
    place: int  #: of the walls in the list of works
    wall: np.ndarray  #: displacement of the wall now [m], (g, 3)
    came: np.ndarray  #: how much of it came in this step [m], (g, 3)
    load: np.ndarray  #: force and torque on the cell [N, N·m], (g, 6)


class PressTable(NamedTuple):
    """Loads on free facets, l of them (`bondem.kernels.press_pass`); kernels write the last two."""

    value: np.ndarray  #: what each adds to V θ of the cells at full load [m³], (l, n)
    schedule: np.ndarray  #: (l,)
    place: int  #: in the list of works
    factor: np.ndarray  #: present factors, (l,)
    came: np.ndarray  #: by how much they changed in this step, (l,)


class Body(NamedTuple):
    """What only bodies of cells have; not flat, so it stays outside of threads."""

    cells: CellTable
    grips: GripTable
    presses: PressTable
    cracks: CrackTable | None  #: facets that soften and cells that yield
    strain: StrainedCells | None  #: stress-free strains that change


class StepCut(NamedTuple):
    """How a step is cut (`bondem.model.blocks`), and the sums it adds to; kernels write `sums` only."""

    domain: np.ndarray
    bond: np.ndarray
    move: np.ndarray
    held: np.ndarray
    ready: np.ndarray
    ready_row: np.ndarray
    row_i: np.ndarray
    row_j: np.ndarray
    shared: np.ndarray
    shared_row: np.ndarray
    shared_held: int
    part: np.ndarray
    parts: int
    sums: np.ndarray  #: force and torque of the bonds on each element, (rows, 8)


class Rows(NamedTuple):
    """Elements that are held, driven or loaded own a row, r of them; kernels write all but `of` and `fixed`."""

    of: np.ndarray  #: row of each element, or -1, (n,)
    fixed: np.ndarray  #: degrees of freedom with prescribed motion, uint8, (r, 6)
    force: np.ndarray  #: of loads now [N, N·m], (r, 6)
    half: np.ndarray  #: prescribed velocities over the step [m/s, rad/s], (r, 6)
    full: np.ndarray  #: prescribed velocities now, (r, 6)
    reaction: np.ndarray  #: minus the bond forces [N, N·m], (r, 6)
    grip: np.ndarray  #: of walls that hold facets of cells [N, N·m], (r, 6), or (0, 6) without any
    work: np.ndarray  #: of loads and drives on each row [J], then of body forces, strains and walls that hold cells


class Schedules(NamedTuple):
    """How much over time, and what on the rows follows it."""

    times: np.ndarray  #: of all schedules, one after the other [s]
    values: np.ndarray
    start: np.ndarray  #: where each begins
    drive_row: np.ndarray
    drive_dof: np.ndarray
    drive_schedule: np.ndarray
    drive_rate: np.ndarray  #: 1 for a velocity, 0 for a displacement, uint8
    load_row: np.ndarray
    load_schedule: np.ndarray
    load_value: np.ndarray  #: [N, N·m], (…, 6)
    load_turns: np.ndarray  #: element with which each turns, or -1; (0,) where none does
    couples: CoupleTable  #: moments, whose forces turn with their regions


class Gauges(NamedTuple):
    """What is read off for the history."""

    start: np.ndarray  #: where the elements of each gauge begin, (g + 1,)
    element: np.ndarray  #: elements, or the number of a wall
    quantity: np.ndarray  #: OF_… or WALL_…, (g,)
    reduction: np.ndarray  #: MEAN, SUM or LARGEST, (g,)


class StepScheme(NamedTuple):
    """One step of time integration; see `bondem.solve.schemes`."""

    dt: float  #: [s]
    finish: float  #: [s]
    begin: float  #: [s]
    extra: float  #: [s²]
    gamma: float  #: of local damping [-]
    origin: float  #: time of step 0 [s]


class Span(NamedTuple):
    """Which steps a call takes."""

    step: int  #: number of the present one
    steps: int  #: how many to go
    every: int  #: steps between records, 0 for none
    moved: bool  #: whether the elements have already moved in this step, and only its forces are missing
    looks: bool  #: whether it takes none, and records the present
    stale: bool  #: whether the acceleration is to be found for that


class Run(NamedTuple):
    """All tables of a run that every run has."""

    elements: Elements
    bonds: Bonds
    cut: StepCut
    rows: Rows
    schedules: Schedules
    gauges: Gauges
    budget: np.ndarray  #: energy at the start, and most that was put in since [J], (2,); kernels write it


class Added(NamedTuple):
    """What only some runs have on their elements; a part that a run does not have is empty."""

    group: np.ndarray  #: of each element: those of one group have the same body forces, uint32, (n,)
    member: np.ndarray  #: which body forces act on a group, 0 or 1, (g, b)
    pull: np.ndarray  #: their accelerations [m/s²], (b, 3)
    schedule: np.ndarray  #: and schedules, (b,)
    present: np.ndarray  #: acceleration of each group now [m/s²], (g, 3)
    factor: np.ndarray  #: of which factors it is, (b,)
    body: np.ndarray  #: work of the body forces on each element [J], (n, 1)
    absorbing: np.ndarray  #: dashpots of each row, xx, yy, zz, xy, xz, yz [N·s/m], (r, 6)
    alpha: float  #: of mass damping [1/s]
    dashpot: np.ndarray  #: of each bond: cn, cs [N·s/m], cb, ct [N·m·s], (4, m)
    share: np.ndarray  #: where the contact point divides a bond, from i [-], (m,)
    dashed: np.ndarray  #: dashpots' force and torque on each element, and further rows, as the sums of bonds, (…, 8)
    viscous: bool  #: whether there are any dashpots or mass damping


class Breaks(NamedTuple):
    """When bonds break, m of them, in b blocks, and what is kept of those that do; n elements (`kernels.judging`)."""

    kind: int  #: number of the criterion
    coefficient: np.ndarray  #: what judges each bond, (m, 4)
    station: np.ndarray  #: where its moment counts, from i over its length; below 0 the larger of both ends, (m,)
    softens: bool  #: whether bonds lose their integrity little by little (`kernels.beam_softening`)
    onset: np.ndarray  #: what opens and slides of those that begin to [J], and their mode, (m, 3), or (0, 3)
    limit: np.ndarray  #: of the bound of each bond, inf of those that soften, float32, (m,)
    of_force: float  #: the bound is of_force |F|² + of_moment |M|² [1/N²]
    of_moment: float  #: [1/(N·m)²]
    now: np.ndarray  #: time [s] and step that bonds break at; a step below 0 where none is to, (2,)
    marked: np.ndarray  #: bonds beyond the bound, then those that break, from the first bond of each block on, (m,)
    begin: np.ndarray  #: the first bond of each block, or of each domain of facets, (b,)
    found: np.ndarray  #: how many of these are marked, or break, (b,)
    held: np.ndarray  #: not 0 for elements that wait at the end of the step, uint8, (n,)
    turn: np.ndarray  #: elements of a block, those that wait last, uint32, (n,)
    turn_row: np.ndarray  #: rows of their sums, uint32, (n,)
    first_row: int  #: where the rows begin that keep the sums of those that wait, one an element
    log: np.ndarray  #: what broke in this call (`BROKEN_…`), (m, 9)
    logged: np.ndarray  #: how many of it, (1,)
    released: np.ndarray  #: energy released since the start of the run [J], (1,)
    # of bodies of cells; else empty
    weight: np.ndarray  #: λ / V of each cell with all its facets [Pa/m³], (n,)
    slack_i: np.ndarray  #: what 1 / weight of cell i gains where a facet breaks [m³/Pa], (m,)
    slack_j: np.ndarray
    in_start: np.ndarray  #: facets of each cell, as `Adjacency` has them
    out_start: np.ndarray
    out_bond: np.ndarray


class ContactTable(NamedTuple):
    """Contacts in the kernels' order; c pairs, b contacts with walls, w walls."""

    law: np.ndarray  #: modulus [Pa], ks / kn, μ, β, whether Hertzian; (5,)
    radius: np.ndarray  #: of the elements [m], (n,)
    load: np.ndarray  #: force and torque of all contacts on each element [N, N·m], (n, 6)
    listed: np.ndarray  #: centres when the list was made [m], (n, 3)
    reach: float  #: how far elements, and walls, may move before the next list [m]
    first: np.ndarray  #: uint32, (c,)
    second: np.ndarray  #: uint32, (c,)
    gap: np.ndarray  #: from which the overlap counts [m], (c,)
    slack: np.ndarray  #: how far both may move from where they were measured before they touch [m], (c,)
    measured: np.ndarray  #: centres then [m], (n, 3)
    far: np.ndarray  #: farthest that a centre is from there, and was then from where it was listed [m]; and the
    #: deepest overlap so far over the smaller radius; (3,)
    near: np.ndarray  #: pairs that may touch before distances are measured anew, ascending, (c,)
    nears: np.ndarray  #: how many, and how many of them stand in `close` where one thread looks at all, (2,)
    close: np.ndarray  #: those of them that touch or have just parted, uint32, (c,)
    bond: np.ndarray  #: the bond between them, or -1; while that joins them they do not touch, (c,)
    joined: np.ndarray  #: above 0 of bonds that do: their integrity, or 1 of facets whose faces face each other, (m,)
    apart: np.ndarray  #: distance of centres at which the pair of a bond touches then [m], (m,)
    own: np.ndarray  #: kn of a pair that does not have that of the law, or 0 [N/m], (c,)
    of_bond: np.ndarray  #: the pair of each bond, or -1, (m,)
    stretch: np.ndarray  #: tangential stretch [m] and force of the dashpots [N], in six of (c, 8)
    touch: np.ndarray  #: uint8, (c,)
    output: np.ndarray  #: force on the second, torque over the radius, losses; (c, 8)
    in_start: np.ndarray  #: pairs whose second element is p, (n + 1,)
    out_start: np.ndarray  #: pairs whose first element is p, (n + 1,)
    out_pair: np.ndarray  #: uint32, (c,)
    sums: np.ndarray  #: of forces, torques over the radius and losses of elements that are touched, (n, 8)
    hit: np.ndarray  #: elements that are touched, (n,)
    hits: np.ndarray  #: how many, (1,)
    met: np.ndarray  #: zero between steps, uint8, (n,)
    wall_start: np.ndarray  #: contacts of each element with walls, (n + 1,)
    wall: np.ndarray  #: uint32, (b,)
    wall_gap: np.ndarray  #: (b,)
    wall_stretch: np.ndarray  #: (b, 6)
    wall_touch: np.ndarray  #: uint8, (b,)
    wall_output: np.ndarray  #: force on the wall (3), normal force; (b, 4)
    shape: np.ndarray  #: of the walls, (w, 8)
    walls: np.ndarray  #: the walls themselves (`bondem.kernels.walls`), (w, 14)
    wall_listed: np.ndarray  #: displacements when the list was made [m], (w, 4)
    wall_friction: np.ndarray  #: μ, (w,)
    times: np.ndarray  #: schedules of the walls, as `Schedules` has them
    values: np.ndarray
    start: np.ndarray
    drive_wall: np.ndarray
    drive_component: np.ndarray
    drive_schedule: np.ndarray
    drive_rate: np.ndarray
    servo_wall: np.ndarray
    servo_schedule: np.ndarray
    servo_speed: np.ndarray
    servo_mass: np.ndarray
    free_wall: np.ndarray  #: walls that move by what presses on them, (f,)
    free_mass: np.ndarray  #: [kg], (f,)
    free_force: np.ndarray  #: on them beside that of elements [N], (f, 3)


def lines(n: int) -> np.ndarray:
    """Zeros, (n, 8): each row one cache line, and not the halves of two."""
    room = np.zeros(8 * n + 8)
    first = -room.ctypes.data % 64 // 8
    return room[first : first + 8 * n].reshape(n, 8)
