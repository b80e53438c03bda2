"""What the packing kernels take, as `bondem.kernels.tables` for the step."""

from typing import NamedTuple

import numpy as np


class Spheres(NamedTuple):
    """The spheres, n of them; kernels write all but `unit` and `period`."""

    sphere: np.ndarray  #: centres and radii [m], (n, 4)
    unit: np.ndarray  #: radii at scale 1 [m], (n,)
    velocity: np.ndarray  #: (n, 3), kept between calls
    force: np.ndarray  #: overlap forces [m], less what walls bear, (n, 3)
    period: np.ndarray  #: periodic edge lengths [m], 0 where there is none, (3,)


class PackingWalls(NamedTuple):
    """A box, infinite where it has no wall, and a round wall; any other shape is given by its depth on a grid."""

    lower: np.ndarray  #: corner of the box [m], (3,)
    upper: np.ndarray  #: corner of the box [m], (3,)
    weight: np.ndarray  #: 1 for the axes in the distance from the centre line or centre of the round wall, (3,)
    radius: float  #: of the round wall [m], infinite without one
    corner: np.ndarray  #: first node of the grid [m], (3,)
    spacing: float  #: of its nodes [m]
    depth: np.ndarray  #: at its nodes [m], (a, b, c); empty without a grid


class Near(NamedTuple):
    """Neighbour lists, and how long they hold."""

    start: np.ndarray  #: where each sphere's neighbours begin, (n + 1,)
    neighbour: np.ndarray  #: uint32
    listed: np.ndarray  #: centres when the list was made [m], (n, 3)
    slack: float  #: how far a centre may move before the list is stale [m]


class RelaxLimits(NamedTuple):
    """When a relaxation ends."""

    tolerance: float  #: converged when the rms force is below this share of the mean contact force [-]
    loose: float  #: spheres with a mean overlap below this do not press on each other [m]
    steps: int  #: most steps to take


class Growing(NamedTuple):
    """How spheres grow while they fly."""

    scale: float  #: of the radii at the beginning [-]
    rate: float  #: scale gained per unit of time
    duration: float  #: how long to go on
    events: int  #: most collisions


class Flight(NamedTuple):
    """What is known of each of n flying spheres; kernels write all."""

    since: np.ndarray  #: when its centre was true, (n,)
    when: np.ndarray  #: time of its next event, (n,)
    what: np.ndarray  #: kind of its next event: another sphere, or a code, int64, (n,)
    heap: np.ndarray  #: spheres by the time of their events, the next one first, (n,)
    place: np.ndarray  #: of each sphere in the heap, (n,)
