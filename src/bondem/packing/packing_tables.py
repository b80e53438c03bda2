"""Tables of the packing passes; `core/tables/packing_tables.hpp` declares their types and shapes."""

from typing import NamedTuple

import numpy as np

from bondem._types import Floats, Ints

# Columns of `Relaxing.report`: rms force [m], mean overlap [m], contacts, largest overlap [m], steps taken.
RMS_FORCE, MEAN_OVERLAP, CONTACTS, LARGEST_OVERLAP, STEPS, _RELAXING = range(6)
# Columns of `Growing.report`: time gone by, sum of distance times exchanged momentum [m²], collisions.
TIME, VIRIAL, COLLISIONS, _GROWING = range(4)
# Columns of the sums of a block of spheres, and how many spheres a block has.
_SUMS, _BLOCK = 8, 128


class Spheres(NamedTuple):
    """Spheres, n of them; passes write all but `unit`, `period` and `ease`."""

    sphere: Floats  #: centres and radii [m], (n, 4)
    unit: Floats  #: radii at scale 1 [m], (n,)
    velocity: Floats  #: (n, 3), kept between calls
    force: Floats  #: overlap forces [m], less what walls carry, (n, 3)
    period: Floats  #: periodic edge lengths [m], 0 where there is none, (3,)
    ease: Floats  #: 1 / √mass of each sphere in a relaxation [-], (n,)


class PackingWalls(NamedTuple):
    """A box, infinite where it has no wall, and a round wall; any other shape is given by its depth on a grid."""

    lower: Floats  #: corner of the box [m], (3,)
    upper: Floats  #: corner of the box [m], (3,)
    weight: Floats  #: 1 for the axes in the distance from the centre line or centre of the round wall, (3,)
    radius: float  #: of the round wall [m], infinite without one
    corner: Floats  #: first node of the grid [m], (3,)
    spacing: float  #: of its nodes [m]
    depth: Floats  #: at its nodes [m], (a, b, c); empty without a grid


class Near(NamedTuple):
    """Neighbour lists, and how long they are valid."""

    start: Ints  #: where the neighbours of each sphere begin, (n + 1,)
    neighbour: np.ndarray  #: uint32
    listed: Floats  #: centres when the list was made [m], (n, 3)
    slack: float  #: how far a centre may move before the list is out of date [m]


class Relaxing(NamedTuple):
    """Criteria for the end of a relaxation, and data that the descent keeps between calls."""

    tolerance: float  #: converged when the rms force is below this share of the mean contact force [-]
    loose: float  #: spheres with a mean overlap below this do not press on each other [m]
    steps: int  #: most steps
    fire: Floats  #: time step, mixing, steps downhill; zeros at the beginning, (3,)
    part: Floats  #: sums of each block of spheres, (blocks, 8)
    report: Floats  #: see RMS_FORCE … STEPS, (5,)

    @classmethod
    def of(cls, count: int, tolerance: float, loose: float) -> "Relaxing":
        """The beginning of a relaxation of so many spheres."""
        part = np.zeros((-(-count // _BLOCK), _SUMS))
        return cls(tolerance, loose, 0, np.zeros(3), part, np.zeros(_RELAXING))


class Growing(NamedTuple):
    """Growth of flying spheres, and a report of its end."""

    scale: float  #: of the radii at the beginning [-]
    rate: float  #: scale gained per unit of time
    duration: float  #: how long to go on
    events: int  #: most collisions
    report: Floats  #: see TIME … COLLISIONS, (3,)

    @classmethod
    def of(cls, scale: float, rate: float, duration: float, events: int) -> "Growing":
        """Return a growth with an empty report."""
        return cls(scale, rate, duration, events, np.zeros(_GROWING))


class Flight(NamedTuple):
    """Times and next events of n flying spheres; passes write all."""

    since: Floats  #: when its centre was true, (n,)
    when: Floats  #: time of its next event, (n,)
    what: Ints  #: its next event: another sphere, or a code, (n,)
    heap: Ints  #: spheres by the time of their events, the next one first, (n,)
    place: Ints  #: of each sphere in the heap, (n,)

    @classmethod
    def of(cls, count: int) -> "Flight":
        """Room for so many spheres."""
        return cls(np.empty(count), np.empty(count), *(np.empty(count, np.int64) for _ in range(3)))
