"""Tables of `core/tables/packing_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints, Uint32s


class Spheres(NamedTuple):
    """Spheres, n of them; passes write all but `unit`, `period` and `ease`."""

    sphere: Floats  #: centres and radii [m], (n, 4)
    unit: Floats  #: radii at scale 1 [m], (n,)
    velocity: Floats  #: kept between calls, (n, 3)
    force: Floats  #: overlap forces [m], without the parts that walls carry, (n, 3)
    period: Floats  #: periodic edge lengths [m], 0 where there is none, (3,)
    ease: Floats  #: 1 / √mass of each sphere in a relaxation [-], (n,)


class PackingWalls(NamedTuple):
    """A box, infinite where it has no wall, and a round wall; any other shape is given by its depth on a grid."""

    lower: Floats  #: corner of the box [m], (3,)
    upper: Floats  #: corner of the box [m], (3,)
    #: 1 for the axes along which the distance from the centre, or the centre line, of the round wall counts, else 0,
    #: (3,)
    weight: Floats
    radius: float  #: radius of the round wall [m], infinite without one
    corner: Floats  #: first node of the grid [m], (3,)
    spacing: float  #: distance of the nodes of the grid [m]
    depth: Floats  #: depth at the nodes [m], empty without a grid, (grid_x, grid_y, grid_z)


class Near(NamedTuple):
    """Neighbour lists, and the motion for which they are valid."""

    start: Ints  #: where the neighbours of each sphere begin, (n + 1,)
    neighbour: Uint32s  #: (neighbours,)
    listed: Floats  #: centres when the list was made [m], (n, 3)
    slack: float  #: how far a centre may move before the list is out of date [m]


class Relaxing(NamedTuple):
    """Criteria for the end of a relaxation, and data that the descent keeps between calls."""

    tolerance: float  #: converged when the rms force is below this share of the mean contact force [-]
    loose: float  #: mean overlap below which a relaxation ends: the spheres do not press on each other [m]
    steps: int  #: largest number of steps
    fire: Floats  #: time step, mixing, steps downhill; zeros at the beginning, (3,)
    part: Floats  #: sums of each block of spheres, (blocks, 8)
    report: Floats  #: rms force [m], mean overlap [m], contacts, largest overlap [m], steps, (5,)


class Growing(NamedTuple):
    """Growth of flying spheres, and a report of its end."""

    scale: float  #: scale of the radii at the beginning [-]
    rate: float  #: scale gained per unit of time
    duration: float  #: duration of the growth
    events: int  #: largest number of collisions
    report: Floats  #: elapsed time, sum of distance times exchanged momentum [m²], collisions, (3,)


class Flight(NamedTuple):
    """Times and next events of n flying spheres; passes write all."""

    since: Floats  #: time for which the centre of each sphere is stored, (n,)
    when: Floats  #: time of the next event of each sphere, (n,)
    what: Ints  #: next event of each sphere: the number of another sphere, or a code, (n,)
    heap: Ints  #: spheres by the time of their events, the next one first, (n,)
    place: Ints  #: place of each sphere in the heap, (n,)


class SphereGrid(NamedTuple):
    """Spheres sorted into the cells of a grid."""

    sphere: Floats  #: centres and radii [m], (n, 4)
    lower: Floats  #: corner of the grid [m], (3,)
    edge: Floats  #: edges of the cells of the grid [m], (3,)
    period: Floats  #: periodic edge lengths [m], 0 where there is none, (3,)
    cells: Ints  #: along each axis, (3,)
    skin: float  #: largest gap of neighbours [m]
    cell: Ints  #: cell of each sphere, (n,)
    first: Ints  #: where the members of each cell begin, (cells + 1,)
    member: Uint32s  #: spheres, cell by cell, (n,)
    place: Floats  #: centres and radii of `member` [m], and room to read several at once, (4, n + 8)
    start: Ints  #: where the neighbours of each sphere begin, (n + 1,)


class NeighbourLists(NamedTuple):
    """The lists of all spheres one after the other."""

    neighbour: Uint32s  #: (neighbours,)
