"""Tables of `core/tables/step_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Ints, Uint32s


class Moving(NamedTuple):
    """The motion of n elements; arrays of a state."""

    pose: Floats  #: (n, 8)
    motion: Floats  #: (n, 8)
    acceleration: Floats  #: at a pause [m/s², rad/s²], (n, 6)
    loss: Floats  #: loss to damping [J], its present power [W], loss to friction [J], (n, 3)
    rest: Floats  #: centres in the reference [m], (n, 3)


class Beams(NamedTuple):
    """Beams, m of them; beams without force follow if they are fewer than a group of lanes."""

    i: Uint32s  #: first element of each beam, (m,)
    j: Uint32s  #: second element of each beam, (m,)
    X0: Floats  #: x of the reference direction i→j [-], (m,)
    Y0: Floats  #: y of the reference direction i→j [-], (m,)
    Z0: Floats  #: z of the reference direction i→j [-], (m,)
    length: Floats  #: rest length L (1 + ε*) [m], (m,)
    kn: Floats  #: [N/m], (m,)
    A: Floats  #: constants of the energy [N·m], (m,)
    B: Floats  #: constants of the energy [N·m], (m,)
    C: Floats  #: constants of the energy [N·m], (m,)
    kt: Floats  #: [N·m], (m,)
    ks: Floats  #: [N/m], (m,)
    lever: Floats  #: distance of the contact point from i [m], (m,)
    integrity: Floats  #: 1 intact … 0 broken [-], (m,)
    period: Floats  #: edges of the periodic cell and their inverses, zero where there is none, (6,)


class UniformBeams(NamedTuple):
    """Constants of beams that differ in length only."""

    per_length: Floats  #: integrity over rest length [1/m], (m,)
    knL: float  #: kn L [N]
    AL: float  #: A L = C L [N·m²]
    BL: float  #: B L [N·m²]
    ktL: float  #: kt L [N·m²]


class Poses(NamedTuple):
    """Places and orientations of elements."""

    pose: Floats  #: (n, 8)


class BeamSums(NamedTuple):
    """Sums to which beams add the forces on their two ends."""

    row_i: Uint32s  #: row of the sums of element i of each beam, (m,)
    row_j: Uint32s  #: row of the sums of element j of each beam, (m,)
    sums: Floats  #: force, 0, torque, 0 [N, N·m], (sums, 8)


class BeamEnergies(NamedTuple):
    """Energies of all beams."""

    energy: Floats  #: normal, shear, bending, twisting [J], (4,)


class BeamTurns(NamedTuple):
    """Counts of unbroken beams beyond safe angles and beyond valid angles, and 1 if a number is not finite."""

    found: Ints  #: (3,)


class Dashpots(NamedTuple):
    """Dashpots parallel to the springs of beams, and their forces."""

    c: Floats  #: cn, cs [N·s/m], cb, ct [N·m·s], (4, m)
    share: Floats  #: where the contact point divides a beam, from i [-], (m,)
    sums: Floats  #: forces on each element, in rows as `StepBlocks.sums`, (*, 8)


class StepBlocks(NamedTuple):
    """Division of a step in the form of the core (attributes of `Blocks`), and the sums of elements."""

    domain: Ints  #: (domains + 1,)
    bond: Ints  #: (blocks + 1,)
    move: Ints  #: (blocks + 1,)
    first_owner: Ints  #: (blocks,)
    ready: Uint32s  #: (ready,)
    ready_row: Uint32s  #: (ready,)
    row_i: Uint32s  #: (m,)
    row_j: Uint32s  #: (m,)
    shared: Uint32s  #: (shared,)
    shared_row: Uint32s  #: (shared,)
    shared_first_owner: int
    part: Ints  #: (shared + 1,)
    parts: int
    sums: Floats  #: force and torque of the bonds on each element [N, N·m], (sums, 8)


class StepScheme(NamedTuple):
    """One step of time integration; see `bondem.dynamics.schemes`."""

    dt: float  #: [s]
    finish: float  #: change of the velocity per acceleration that closes a step [s]
    begin: float  #: change of the velocity per acceleration that opens a step [s]
    extra: float  #: displacement of a step per acceleration, in addition to that by the velocity [s²]
    gamma: float  #: of local damping [-]
    origin: float  #: time of step 0 [s]


class Rows(NamedTuple):
    """Rows of the elements that are fixed, driven or loaded; passes write all but `of` and `fixed`."""

    of: Ints  #: row of each element, or -1, (n,)
    fixed: Bytes  #: degrees of freedom with prescribed motion, (rows, 6)
    force: Floats  #: loads now [N, N·m], (rows, 6)
    half: Floats  #: prescribed velocities over the step [m/s, rad/s], (rows, 6)
    full: Floats  #: prescribed velocities now, (rows, 6)
    reaction: Floats  #: minus the bond forces [N, N·m], (rows, 6)
    support: Floats  #: loads of walls on facets of cells [N, N·m], empty without any, (*, 6)
    #: works of loads, drives, walls on facets and tractions on each row, then of body forces and strains [J],
    #: (works,)
    work: Floats


class Timeline(NamedTuple):
    """Piecewise linear functions of time, one after the other."""

    times: Floats  #: [s], (times,)
    values: Floats  #: values at these times, (times,)
    start: Ints  #: start of each schedule, (schedules + 1,)


class Drives(NamedTuple):
    """Degrees of freedom that follow schedules."""

    row: Ints  #: (drives,)
    dof: Ints  #: (drives,)
    schedule: Ints  #: (drives,)
    rate: Bytes  #: 1 for a velocity, 0 for a displacement, (drives,)


class RowLoads(NamedTuple):
    """Forces and torques that follow schedules."""

    row: Ints  #: (loads,)
    schedule: Ints  #: (loads,)
    value: Floats  #: [N, N·m], (loads, 6)
    turns: Ints  #: element with which each load turns, or -1, (loads,)


class CoupleTable(NamedTuple):
    """Moments of loads on points of elements."""

    start: Ints  #: start of the points of each moment, (couples + 1,)
    schedule: Ints  #: (couples,)
    moment: Floats  #: [N·m], (couples, 3)
    element: Ints  #: element of each point, (points,)
    row: Ints  #: row of the boundary that the element owns, (points,)
    arm: Floats  #: arm of each point from the centre of its element [m], (points, 3)
    share: Floats  #: share of each point in its moment [-], (points,)


class BodyForces(NamedTuple):
    """Body forces on groups of elements."""

    group: Uint32s  #: group of each element, (n,)
    member: Floats  #: 1 where a body force acts on a group, else 0, (groups, bodies)
    pull: Floats  #: accelerations at factor 1 [m/s²], (bodies, 3)
    schedule: Ints  #: (bodies,)
    present: Floats  #: acceleration of each group now [m/s²], (groups, 3)
    factor: Floats  #: factors for which `present` is computed, (bodies,)
    work: Floats  #: work on each element [J], (n, 1)


class Resistance(NamedTuple):
    """Damping and dashpots that resist the motion of elements."""

    gamma: float  #: of local damping [-]
    alpha: float  #: of mass damping [1/s]
    viscous: int  #: 1 with mass damping or dashpots
    dashed: Floats  #: the sums of `Dashpots`, empty without, (*, 8)
    absorbing: Floats  #: dashpots of each row, xx, yy, zz, xy, xz, yz [N·s/m], empty without, (*, 6)


class Strain(NamedTuple):
    """Stress-free strains of beams that change in time."""

    schedule: Ints  #: (strains,)
    bond: Uint32s  #: (strained,)
    part: Floats  #: strain of each bond at factor 1 [-], (strains, strained)
    still: Floats  #: 1 plus the strains that do not change [-], (strained,)
    length: Floats  #: L without strain [m], (strained,)
    shear: Floats  #: ks without strain [N/m], (strained,)
    lever: Floats  #: a without strain [m], (strained,)
    factor: Floats  #: rows: factors a step ago and now, ∂U/∂factor [J] a step ago and now, (4, strains)
    power: Ints  #: exact sums of ∂U/∂factor [J], zero between steps, (strains, 68)
    due: Bytes  #: flags by `strain_due`: ∂U/∂factor is needed; lengths have changed, (2,)
    place: int  #: place of the work in the list of works


class Ledger(NamedTuple):
    """Exact sums of a record or a guard, zero between them, to which passes add in any order."""

    sums: Ints  #: energies by `history_column` [J], (15, 68)
    turned: Ints  #: unbroken bonds turned wide, and lost; portions with a number that is not finite, (3,)
    budget: Floats  #: energy at the start, and the largest energy supplied since [J], (2,)
    found: Ints  #: bonds turned wide, and lost; 1 not finite, 2 a runaway; 1 for a list out of date, (4,)


class Gauges(NamedTuple):
    """Elements, quantities and reductions of the gauges of a run."""

    start: Ints  #: start of the elements of each gauge, (gauges + 1,)
    element: Ints  #: elements, or the number of a wall, (gauged,)
    quantity: Ints  #: number of the quantity, (gauges,)
    reduction: Ints  #: number of the reduction, (gauges,)


class HistoryRows(NamedTuple):
    """Rows of the history."""

    record: Floats  #: (*, columns)


class StepPasses(NamedTuple):
    """Lists of passes (`bondem._core_steps.Composer`)."""

    present: Ints  #: bring boundary conditions to the time of the clock, (*, 8)
    opening: Ints  #: elements open a step after a pause, (*, 8)
    travel: Ints  #: walls move; check whether the list of contacts is valid, (*, 8)
    forces: Ints  #: forces, and the motion of elements by them, (*, 8)
    resume: Ints  #: postponed elements find their acceleration without failed bonds, (*, 8)
    reopening: Ints  #: postponed elements open the next step, (*, 8)
    guard: Ints  #: check of the run, (*, 8)
    record: Ints  #: a row of the history, (*, 8)


class StepSpan(NamedTuple):
    """Steps of a call of the core, and counts of its results."""

    step: int  #: number of the present step
    steps: int  #: number of steps to take
    every: int  #: steps between records, 0 for none
    records_present: int  #: 1 to record the present state without a step
    stale: int  #: 1 if forces have to be found before the present state is recorded
    moved: int  #: 1 if elements and walls have moved already in the first step, whose list was out of date
    n: int  #: number of elements
    m: int  #: number of bonds, without those that fill a group
    done: Ints  #: steps done, records written, bonds turned wide at most and lost, (4,)


class LaggedStresses(NamedTuple):
    """Stresses of n elements in the previous step."""

    inverse: Floats  #: 1 / V [1/m³], (n,)
    stress: Floats  #: in the element's own frame, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    space: Floats  #: in space, and bounds of σ1 and σ3 [Pa], (n, 8)
    #: contributions of forces to V σ, zero between steps; rows of shared elements follow [N·m], (*, 8)
    moment: Floats
    to_i: Uint32s  #: row of the moment of element i of each bond, (m,)
