"""Tables of `core/tables/contact_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Int32s, Ints, Uint32s


class ContactRow(NamedTuple):
    """Parameters of the law of a contact."""

    modulus: float  #: effective modulus [Pa]
    soft: float  #: ks / kn [-]
    friction: float  #: μ [-]
    damping: float  #: β [-]
    rolling: float  #: coefficient μ_r of the resistance to rolling [-]
    twisting: float  #: coefficient μ_w of the resistance to twisting [-]
    deep: float  #: overlap over the radius at which the stiffness against rolling is taken [-]
    strength: float  #: strength of adhesion, 0 for none [Pa]
    reach: float  #: reach of adhesion, 0 for none [m]


class ContactConstants(NamedTuple):
    """The laws of contacts by kinds of elements, and the radii of the elements."""

    between: Floats  #: rows of `ContactRow` of pairs of each two kinds, (kinds, kinds, 9)
    at_walls: Floats  #: rows of `ContactRow` of each kind at each wall, (kinds, walls, 9)
    kind: Bytes  #: kind of each element, (n,)
    hertzian: int  #: 1 for the law of Hertz and Mindlin, 0 for linear contact
    radius: Floats  #: [m], (n,)


class ContactPairs(NamedTuple):
    """Pairs that may touch before their list is renewed."""

    first: Uint32s  #: earlier element of each pair, (pairs,)
    second: Uint32s  #: later element of each pair, (pairs,)
    start: Ints  #: start of the pairs of each later element, (n + 1,)
    reach: Floats  #: distance of the centres at which a pair touches [m], (pairs,)
    #: the same at rest; `reach` is less from a failure under less pressure until the two are farther apart [m],
    #: (pairs,)
    whole: Floats
    own: Floats  #: kn of a pair with a stiffness of its own, else 0 [N/m], (pairs,)
    #: tangential stretch [m] and force of the dashpots [N]; of faces the overlap u0 [m] and kn a step ago [N/m],
    #: (pairs, 8)
    memory: Floats
    touch: Bytes  #: `TouchState`, (pairs,)
    bond: Ints  #: bond of each pair, or -1; a pair does not touch while its bond joins it, (pairs,)
    joined: Floats  #: above 0 for bonds that join their elements, which then do not touch, (*,)
    of_bond: Ints  #: the pair of each bond, or -1, (*,)
    period: Floats  #: edges of the periodic cell and their inverses, zero where there is none, (6,)


class NearPairs(NamedTuple):
    """Pairs that every step examines, until distances are measured again."""

    near: Uint32s  #: pairs that may touch, (pairs + 1,)
    close: Uint32s  #: pairs that touch or have just parted, (pairs + 1,)
    #: of close pairs: force on the later element [N], dashpot loss [J], torque over radius [N], friction loss [J],
    #: (pairs, 8)
    output: Floats
    counts: Ints  #: numbers of near and of close pairs of each portion of elements, (element_portions, 2)
    width: float  #: motion of an element after which distances are measured again [m]
    beyond: float  #: largest gap at which pairs act on each other without touching [m]


class AdheringPairs(NamedTuple):
    """Adhesion of near pairs."""

    force: Floats  #: on the later element [N], (pairs, 3)


class RolledPairs(NamedTuple):
    """Resistance of pairs to rolling."""

    rolled: Floats  #: R̄ times the rotation that the spring of each pair stores [m], (pairs, 3)
    output: Floats  #: moment on the later element [N·m], lost to friction [J], (pairs, 4)


class RolledWalls(NamedTuple):
    """Resistance of elements at walls to rolling."""

    rolled: Floats  #: R times the rotation that the spring of each contact stores [m], (wall_contacts, 3)


class FacePairs(NamedTuple):
    """Faces of cells on material planes whose facet has cracked, and the pairs that touch by them."""

    in_start: Ints  #: facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    out_start: Ints  #: facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    out_bond: Uint32s  #: facets of each cell, as `FacetsOfCells` has them, (*,)
    lever_i: Int32s  #: levers as in `ElasticFacets`, (3, m)
    lever_j: Int32s  #: levers as in `ElasticFacets`, (3, m)
    pitch: Floats  #: unit of the levers [m], (3,)
    normal: Floats  #: normals as in `ElasticFacets`, (3, m)
    j: Uint32s  #: later cell, (m,)
    k: Floats  #: stiffness of the facet [N/m], (m,)
    area: Floats  #: [m²], (m,)
    listed: Bytes  #: `listed` of `CohesiveCracks`, (m,)
    plane: Floats  #: 1 for facets of material planes, (m,)
    open: Bytes  #: 1 for facets whose faces have parted, 2 in the step in which they do, (m,)
    faced: Bytes  #: 1 for cells with such a facet, 2 in the step in which it parts, (n,)
    outer: Floats  #: distance within which two cells touch by faces, as a sum of both [m], (n,)
    earlier_start: Ints  #: start of the pairs whose earlier element each element is, (n + 1,)
    earlier: Uint32s  #: numbers of the pairs, by their earlier elements, (pairs,)
    chosen: Floats  #: the two faces by which each pair touches as one number, 0 for none, (pairs,)
    #: pairs that touch by faces or did a step ago, ascending, each portion from its first pair; on devices 1 or 0,
    #: (pairs,)
    close: Uint32s
    #: of pair k: force on the later element [N], loss to dashpots [J], torque on it [N·m], loss to friction [J],
    #: torque on the earlier one [N·m], (pairs, 12)
    output: Floats
    gained: Floats  #: energy taken over from facets that part [J], (pairs,)
    gained_sum: Ints  #: exact sum of `gained`, zero between steps, (1, 68)
    count: Ints  #: number of close pairs of each portion of elements, (element_portions,)


class Travel(NamedTuple):
    """Motion of the elements since their distances were measured, and since the list was made."""

    listed: Floats  #: centres when the list was made [m], (n, 3)
    measured: Floats  #: centres when distances were measured [m], (n, 3)
    #: squares of the largest motions since measuring and since listing [m²], and the deepest overlap [-],
    #: (element_portions, 3)
    portion: Floats
    far: Floats  #: both largest motions; the second is below 0 before the first measurement [m], (2,)
    reach: float  #: motion of an element or a wall for which the list is made [m]


class ContactSums(NamedTuple):
    """Forces and losses of contacts of elements, zero between steps."""

    sums: Floats  #: force [N], lost to dashpots [J], torque [N·m], lost to friction [J], (n, 8)


class WallContacts(NamedTuple):
    """Contacts of elements with walls."""

    start: Ints  #: start of the contacts of each element, (n + 1,)
    element: Uint32s  #: (wall_contacts,)
    wall: Uint32s  #: (wall_contacts,)
    gap: Floats  #: gap from which the overlap counts [m], (wall_contacts,)
    memory: Floats  #: memory as in `ContactPairs`, (wall_contacts, 6)
    touch: Bytes  #: `TouchState`, (wall_contacts,)
    output: Floats  #: rows of `WallLoad`, (wall_contacts, 7)
    sums: Ints  #: exact sums of `WallLoad` of each wall by `wall_sum`, zero between steps, (*, 68)


class Walls(NamedTuple):
    """Shapes, positions and loads of walls."""

    shape: Floats  #: rows of `WallShape`, (walls, 12)
    body: Floats  #: positions, velocities and loads of the walls, as `State.walls`, (walls, 27)
    inertia: Floats  #: rows of `WallInertia`, (walls, 8)
    listed: Floats  #: where the walls were when the list was made, rows of `WallListed`, (walls, 8)


class WallMotions(NamedTuple):
    """Prescribed motions of walls, servos, and free walls."""

    times: Floats  #: times of the schedules, as in `Timeline` [s], (wall_times,)
    values: Floats  #: values of the schedules, as in `Timeline`, (wall_times,)
    start: Ints  #: start of each schedule, (wall_schedules + 1,)
    drive_wall: Ints  #: (wall_drives,)
    drive_component: Ints  #: 0, 1, 2 for x, y, z, 3 for growth, else rotation, (wall_drives,)
    drive_schedule: Ints  #: (wall_drives,)
    drive_rate: Bytes  #: 1 for a velocity, 0 for a displacement, (wall_drives,)
    drive_axis: Floats  #: axis of a rotation, zero for other components, (wall_drives, 3)
    servo_wall: Ints  #: (servos,)
    servo_schedule: Ints  #: (servos,)
    servo_speed: Floats  #: largest speed [m/s], (servos,)
    servo_mass: Floats  #: [kg], (servos,)
    servo_damping: Floats  #: share of the missing force that resists the motion [-], (servos,)
    free_wall: Ints  #: (free_walls,)
    free_mass: Floats  #: [kg], (free_walls,)
    free_force: Floats  #: force on each wall without that of elements [N], (free_walls, 3)
    free_torque: Floats  #: torque on each wall without that of elements [N·m], (free_walls, 3)


class PairSources(NamedTuple):
    """Bonds and memories of contacts, from which the list of pairs is made."""

    bond_start: Ints  #: start of the bonds of each later element, (n + 1,)
    bond_first: Uint32s  #: earlier elements of the bonds, (m,)
    wanted: Bytes  #: 1 for bonds whose pair is listed at any distance, (m,)
    rest_start: Ints  #: start of the pairs of each later element that overlap in the reference, (n + 1,)
    rest_first: Uint32s  #: earlier elements of pairs that overlap in the reference, (rest,)
    rest_gap: Floats  #: gaps of pairs that overlap in the reference [m], (rest,)
    touching_start: Ints  #: start of the pairs of each later element that touch, (n + 1,)
    touching_first: Uint32s  #: earlier elements of pairs that touch, (touching,)
    touching_memory: Floats  #: memories of pairs that touch, as in `ContactPairs`, (touching, 8)


class FoundPairs(NamedTuple):
    """The list of pairs, sorted by the later element, then by the earlier one."""

    first: Uint32s  #: earlier element of each pair, (room,)
    second: Uint32s  #: later element of each pair, (room,)
    bond: Ints  #: the bond of each pair, or -1, (room,)
    start: Ints  #: start of the pairs of each later element, (n + 1,)
    gap: Floats  #: gap from which the overlap counts, at most 0 [m], (room,)
    memory: Floats  #: memory as in `State.stretch`, (room, 8)
    touch: Bytes  #: `TouchState`, (room,)


class WallSources(NamedTuple):
    """Memories of contacts with walls, from which their list is made."""

    radius: Floats  #: radii of the elements [m], (n,)
    rest_start: Ints  #: start of the contacts of each element that overlap in the reference, (n + 1,)
    rest_wall: Uint32s  #: walls of contacts that overlap in the reference, (rest,)
    rest_gap: Floats  #: gaps of contacts that overlap in the reference [m], (rest,)
    touching_start: Ints  #: start of the contacts of each element that touch, (n + 1,)
    touching_wall: Uint32s  #: walls of contacts that touch, (touching,)
    touching_memory: Floats  #: memories of contacts that touch, as in `WallContacts`, (touching, 6)
    skin: float  #: largest gap [m]
    start: Ints  #: start of the found contacts of each element, (n + 1,)


class FoundWalls(NamedTuple):
    """The list of contacts with walls, sorted by element, then by wall."""

    element: Uint32s  #: (room,)
    wall: Uint32s  #: (room,)
    gap: Floats  #: gap from which the overlap counts, at most 0 [m], (room,)
    now: Floats  #: present gap [m], (room,)
    memory: Floats  #: tangential stretch [m] and force of the dashpots [N], (room, 6)
    touch: Bytes  #: `TouchState`, (room,)
