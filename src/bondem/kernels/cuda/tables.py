"""What the loops of CUDA take beside `bondem.kernels.tables`: arrays on the device, under their names.

An array without entries has one unused there, so that counts stand on their own.
"""

from typing import NamedTuple

from bondem._compile_cuda import Array


class DeviceElements(NamedTuple):
    """The motion of n elements; kernels write all."""

    pose: Array  #: (n, 8)
    motion: Array  #: (n, 8)
    acceleration: Array  #: translational and rotational, at a pause [m/s², rad/s²], (n, 6)
    loss: Array  #: (n, 3)


class DeviceBonds(NamedTuple):
    """The bonds; kernels write `forces` only."""

    m: int  #: how many
    i: Array  #: uint32, (m,)
    j: Array  #: uint32, after i, (m,)
    constants: Array  #: reference direction, rest length and, unless bonds are alike, kn, A, B, C, kt; (4 or 9, m)
    same: Array  #: `bondem.kernels.tables.Alike`, or zeros; (4,)
    integrity: Array  #: 1 intact … 0 broken [-], (m,)
    period: Array  #: edges of the periodic cell and their inverses, zero where there is none, (6,)
    forces: Array  #: force on j, torque on i and on j; (9, m)


class DeviceFacets(NamedTuple):
    """The facets of a body, m of them, and what makes stress of dilatation; kernels write `forces` only."""

    m: int  #: how many
    i: Array  #: uint32, (m,)
    j: Array  #: uint32, after i, (m,)
    integrity: Array  #: 1 intact … 0 broken [-], (m,)
    period: Array  #: edges of the periodic cell and their inverses, zero where there is none, (6,)
    k: Array  #: from here to `weight` as `bondem.kernels.tables.CellTable` has them
    pitch: Array
    lever_i: Array
    lever_j: Array
    share_i: Array
    share_j: Array
    normal: Array
    H: Array
    weight: Array
    forces: Array  #: V θ of i and of j (2 rows), then force on j, torque on i and on j; (9, m)


class DeviceBody(NamedTuple):
    """`DeviceFacets`, and what of a body cracks need besides: the bonds and the cells of the CPU's functions in one.

    Kernels write `integrity`, `weight`, `forces` and `moment`.
    """

    m: int
    i: Array
    j: Array
    integrity: Array  #: as the loop over facets has it, 0 of cracks that are treated one by one, (m,)
    period: Array
    k: Array
    pitch: Array
    lever_i: Array
    lever_j: Array
    share_i: Array
    share_j: Array
    normal: Array
    H: Array
    weight: Array
    forces: Array
    in_start: Array  #: facets of each cell, as `bondem.kernels.tables.Adjacency` has them
    out_start: Array
    out_bond: Array
    bends: Array  #: 4 k / A², by which bending is a traction [1/(N m³)], (m,)
    #: V σ of each cell but for cracks that are treated one by one, a step ago [J], and Σ T_b² of these [Pa²], (n, 7)
    moment: Array


class DeviceOnset(NamedTuple):
    """Where facets begin to crack; kernels write the last two. Stresses are those of `CrackedFacets.tensor`."""

    strength: Array  #: f_t of each facet [Pa], (m,)
    hot: float  #: largest principal stress of a cell from which its facets are looked at [Pa]
    least: float  #: size of a stress below which another criterion than Rankine's is not asked [Pa]
    tension: float  #: f_t of such a criterion without scatter [Pa]
    volume: Array  #: [m³], (n,)
    load_start: Array  #: where the loads on free facets of the cells of each row begin, (r + 1,)
    load_schedule: Array  #: (e,)
    load_value: Array  #: what each adds to V σ of its cell at full load [J], (e, 6)
    cracked: Array  #: 1 for cells with cracks, however treated, uint8, (n,)
    hotter: Array  #: 1 for cells whose facets are looked at, 2 for those without cohesion, uint8, (n,)


class DeviceLists(NamedTuple):
    """What changes in a step by its number: facets that begin to crack, cracks that part, cracks that break."""

    found: Array  #: numbers of those, int32, (m,)
    counts: Array  #: how many of these; how many cracks there were before, int32, (2,)
    crack: Array  #: of each facet, or -1, int32, (m,)
    lost: Array  #: parts of what cracks have dissipated in this step [J], (S,)


class DeviceBreaks(NamedTuple):
    """When the m bonds or facets break, and what is kept of those that do; kernels write all from `held` on.

    Of facets `station` and `share` are not used.
    """

    kind: int  #: number of the criterion
    coefficient: Array  #: what judges each bond, (m, 4)
    station: Array  #: where its moment counts, from i over its length; below 0 the larger of both ends, (m,)
    limit: Array  #: of the bound of each bond, float32, (m,)
    of_force: float  #: the bound is of_force |F|² + of_moment |M|² [1/N²]
    of_moment: float  #: [1/(N·m)²]
    share: Array  #: where the contact point divides each, from i [-], (m,)
    held: Array  #: not 0 for elements that wait at the end of the step, uint8, (n,)
    found: Array  #: bonds that break in this step, int32, (m,)
    counts: Array  #: how many of these, how many in the log, whether any element waits, int32, (3,)
    log: Array  #: what broke in this call (`bondem.kernels.tables.BROKEN_…`), (m, 9)
    released: Array  #: energy released since the start of the run [J], (1,)


class WholeCells(NamedTuple):
    """What cells weigh by as they lose facets."""

    weight: Array  #: λ / V with all facets [Pa/m³], (n,)
    slack_i: Array  #: what 1 / weight of cell i gains where a facet breaks [m³/Pa], (m,)
    slack_j: Array


class DeviceHolds(NamedTuple):
    """What walls and tractions do to the cells of each row of the boundary; kernels write the last two.

    The walls' own table is a `bondem.kernels.tables.GripTable` in the order of the rows.
    """

    g: int  #: facets that walls hold
    rest: Array  #: centres in the reference [m], (n, 3) where walls hold cells, else unused
    grip_start: Array  #: where the grips of each row begin, (r + 1,)
    press_start: Array  #: where the tractions of each row begin, (r + 1,)
    press_schedule: Array  #: (e,)
    press_value: Array  #: what each adds to V θ of its cell at full load [m³], (e,)
    press_factor: Array  #: present factors, (e,)
    press_came: Array  #: by how much they changed in this step, (e,)


class DeviceBodies(NamedTuple):
    """Body forces, b of them, on g groups of elements that have the same ones; kernels write `present` only."""

    b: int  #: how many
    group: Array  #: of each element, uint32, (n,), unused without body forces
    member: Array  #: which of them act on a group, 0 or 1, (g, b)
    pull: Array  #: their accelerations [m/s²], (b, 3)
    schedule: Array  #: (b,)
    place: int  #: where their works begin in the list of works, one an element
    present: Array  #: acceleration of each group now [m/s²], (g, 3)


class RowSchedules(NamedTuple):
    """Schedules of the rows of the boundary; the loads and drives of a row are contiguous."""

    r: int  #: of rows
    times: Array  #: of all schedules, one after the other [s]
    values: Array
    start: Array  #: where each begins
    load_start: Array  #: where the loads of each row begin, (r + 1,)
    load_schedule: Array
    load_value: Array  #: [N, N·m], (…, 6)
    drive_start: Array  #: where the drives of each row begin, (r + 1,)
    drive_dof: Array
    drive_schedule: Array
    drive_rate: Array  #: 1 for a velocity, 0 for a displacement


class DeviceGauges(NamedTuple):
    """What is read off for the history; kernels write `parts` only."""

    g: int  #: how many
    rest: Array  #: centres of their elements in the reference [m], (e, 3)
    start: Array  #: where the elements of each gauge begin, (g + 1,)
    element: Array  #: (e,)
    quantity: Array  #: OF_…, (g,)
    reduction: Array  #: MEAN, SUM or LARGEST, (g,)
    parts: Array  #: of their sums or largest values, (g, S, 3)
