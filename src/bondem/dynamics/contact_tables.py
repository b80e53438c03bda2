"""Tables of contacts and walls, as `core/tables/contact_tables.hpp` declares them with types and shapes.

Those of the search are in `bondem.interactions.contact.contact_search`.
"""

from typing import NamedTuple

import numpy as np

from bondem._types import Floats, Ints, PerElement


class ContactConstants(NamedTuple):
    """The laws of contacts by kinds of elements, and the radii of the elements."""

    between: Floats  #: rows of `ContactRow` of pairs of each two kinds, (kinds, kinds, 9)
    at_walls: Floats  #: that of each kind at each wall, (kinds, w, 9)
    kind: np.ndarray  #: of each element, uint8, (n,)
    hertzian: bool  #: whether they are those of Hertz and Mindlin
    radius: PerElement  #: [m], (n,)


class ContactPairs(NamedTuple):
    """Pairs that may touch before their list is renewed, c of them."""

    first: np.ndarray  #: uint32, (c,)
    second: np.ndarray  #: uint32, (c,)
    start: Ints  #: start of the pairs of each later element, (n + 1,)
    reach: Floats  #: distance of the centres at which a pair touches [m], (c,)
    own: Floats  #: kn of a pair that does not have that of the law, or 0 [N/m], (c,)
    memory: Floats  #: as `State.stretch`, (c, 8)
    touch: np.ndarray  #: uint8, (c,)
    bond: Ints  #: the bond of each pair, or -1, (c,)
    joined: Floats  #: above 0 of bonds that join their elements, which then do not touch, (m,)
    of_bond: Ints  #: the pair of each bond, or -1, (m,)
    period: Floats  #: edges of the periodic cell and their inverses, (6,)


class NearPairs(NamedTuple):
    """Pairs that every step examines, until distances are measured again."""

    near: np.ndarray  #: pairs that may touch, uint32, (c + 1,)
    close: np.ndarray  #: pairs that touch or have just parted, uint32, (c + 1,)
    output: Floats  #: force on the later element, damped [J], torque over the radius, rubbed [J], (c, 8)
    counts: Ints  #: of near and of close pairs of each portion of elements, (portions, 2)
    width: float  #: motion of an element after which distances are measured again [m]
    beyond: float  #: gap up to which pairs that do not touch act [m]


class AdheringPairs(NamedTuple):
    """Adhesion of near pairs."""

    force: Floats  #: on the later element [N], (c, 3)


class RolledPairs(NamedTuple):
    """Resistance of pairs to rolling."""

    rolled: Floats  #: R̄ times the rotation that the spring of each pair stores [m], (c, 3)
    output: Floats  #: moment on the later element [N·m], lost to friction [J], (c, 4)


class RolledWalls(NamedTuple):
    """Resistance of elements at walls to rolling."""

    rolled: Floats  #: R times the rotation that the spring of each contact stores [m], (b, 3)


class FacePairs(NamedTuple):
    """Faces of cells on material planes whose facet has cracked, and the pairs that touch by them."""

    in_start: Ints
    out_start: Ints
    out_bond: np.ndarray  #: uint32
    lever_i: np.ndarray  #: those of `ElasticFacets`, (3, m)
    lever_j: np.ndarray
    pitch: Floats
    normal: Floats
    j: np.ndarray
    k: Floats
    area: Floats  #: [m²], (m,)
    listed: np.ndarray  #: that of `CohesiveCracks`, (m,)
    plane: Floats  #: 1 for facets of material planes, (m,)
    open: np.ndarray  #: 1 for facets whose faces have parted, uint8, (m,)
    faced: np.ndarray  #: 1 for cells with such a facet, uint8, (n,)
    outer: Floats  #: distance within which two cells touch by faces, as a sum of both [m], (n,)
    earlier_start: Ints  #: start of the pairs whose earlier element each element is, (n + 1,)
    earlier: np.ndarray  #: these pairs, uint32, (c,)
    chosen: Floats  #: the two faces by which each pair touches as one number, 0 for none, (c,)
    whole: Floats  #: reach of the spheres of pairs whose faces have not lain between them [m], (c,)
    close: np.ndarray  #: pairs that touch by faces, uint32, (c,)
    output: Floats  #: loads of each pair, (c, 12)
    gained: Floats  #: energy taken over from facets that part [J], (c,)
    count: Ints  #: close pairs of each portion of elements, (portions,)


class Travel(NamedTuple):
    """Motion of the elements since their distances were measured, and since the list was made."""

    listed: Floats  #: centres when the list was made [m], (n, 3)
    measured: Floats  #: centres when distances were measured [m], (n, 3)
    portion: Floats  #: squares of both largest distances [m²], and the deepest overlap [-], (portions, 3)
    far: Floats  #: both largest distances; the second is below 0 before the first measurement [m], (2,)
    reach: float  #: motion of an element or a wall for which the list is made [m]


class ContactSums(NamedTuple):
    """Forces and losses of contacts of elements, zero between steps."""

    sums: Floats  #: force [N], lost to dashpots [J], torque [N·m], lost to friction [J], (n, 8)


class ContactEnergies(NamedTuple):
    """Elastic energy of the contacts of each portion of elements."""

    energy: Floats  #: [J], (portions,)


class WallContacts(NamedTuple):
    """Contacts of elements with walls, b of them."""

    start: Ints  #: start of the contacts of each element, (n + 1,)
    element: np.ndarray  #: uint32, (b,)
    wall: np.ndarray  #: uint32, (b,)
    gap: Floats  #: gap from which the overlap counts [m], (b,)
    memory: Floats  #: (b, 6)
    touch: np.ndarray  #: uint8, (b,)
    output: Floats  #: rows of `WallLoad`, (b, 7)


class WallMotions(NamedTuple):
    """Prescribed motions of walls, servos, and free walls."""

    times: Floats  #: schedules, as those of `Timeline`
    values: Floats
    start: Ints
    drive_wall: Ints
    drive_component: Ints
    drive_schedule: Ints
    drive_rate: np.ndarray  #: 1 for a velocity, 0 for a displacement, uint8
    drive_axis: Floats  #: of what turns, zero for other components, (d, 3)
    servo_wall: Ints
    servo_schedule: Ints
    servo_speed: Floats  #: largest speed [m/s]
    servo_mass: Floats  #: [kg]
    servo_damping: Floats  #: share of the missing force that resists the motion [-]
    free_wall: Ints
    free_mass: Floats  #: [kg]
    free_force: Floats  #: on each beside that of elements [N], (f, 3)
    free_torque: Floats  #: on each beside that of elements [N·m], (f, 3)
