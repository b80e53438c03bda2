"""Tables of the passes of a step, as `core/tables/step_tables.hpp` declares them with types and shapes.

`Beams` and `AlikeBeams` are in `bondem.interactions.beams.beam_tables`, `StepCut` in
`bondem.model.domain_blocks`, `Rows` in `bondem.model.constraints`, `CoupleTable` in `bondem.boundary.couples` and
`Gauges` in `bondem.dynamics.gauge_tables`.
"""

from typing import NamedTuple

import numpy as np

from bondem._types import Floats, Ints


class Moving(NamedTuple):
    """The motion of n elements; arrays of a state."""

    pose: Floats  #: (n, 8)
    motion: Floats  #: (n, 8)
    acceleration: Floats  #: at a pause [m/s², rad/s²], (n, 6)
    loss: Floats  #: taken by damping [J], its present power [W], lost to friction [J], (n, 3)
    rest: Floats  #: centres in the reference [m], (n, 3)


class Dashpots(NamedTuple):
    """Dashpots beside the springs of beams, and their forces."""

    c: Floats  #: cn, cs [N·s/m], cb, ct [N·m·s], (4, m)
    share: Floats  #: where the contact point divides a beam, from i [-], (m,)
    sums: Floats  #: on each element, in rows as `StepCut.sums`, (rows, 8)


class Timeline(NamedTuple):
    """Piecewise linear functions of time, one after the other."""

    times: Floats  #: [s]
    values: Floats
    start: Ints  #: where each begins, (schedules + 1,)


class Drives(NamedTuple):
    """Degrees of freedom that follow schedules."""

    row: Ints
    dof: Ints
    schedule: Ints
    rate: np.ndarray  #: 1 for a velocity, 0 for a displacement, uint8


class Strain(NamedTuple):
    """Stress-free strains that change in time; e bonds, g strains."""

    schedule: np.ndarray  #: (g,)
    bond: np.ndarray  #: uint32, (e,)
    part: np.ndarray  #: strain of each bond at factor 1 [-], (g, e)
    still: np.ndarray  #: 1 and what does not change [-], (e,)
    length: np.ndarray  #: L [m], (e,)
    shear: np.ndarray  #: ks [N/m], (e,)
    lever: np.ndarray  #: a [m], (e,)
    factor: np.ndarray  #: rows: present factors, those to come, energy by factor [J] a step ago and now, (4, g)
    place: int  #: in the list of works


class RowLoads(NamedTuple):
    """Forces and torques that follow schedules."""

    row: Ints
    schedule: Ints
    value: Floats  #: [N, N·m], (loads, 6)
    turns: Ints  #: element with which each turns, or -1


class BodyForces(NamedTuple):
    """Body forces, b of them, on g groups of elements."""

    group: np.ndarray  #: of each element, uint32, (n,)
    member: Floats  #: whether each acts on a group, (g, b)
    pull: Floats  #: accelerations [m/s²], (b, 3)
    schedule: Ints  #: (b,)
    present: Floats  #: acceleration of each group now [m/s²], (g, 3)
    factor: Floats  #: of which factors it is, (b,)
    work: Floats  #: on each element [J], (n, 1)


class Resistance(NamedTuple):
    """Damping and dashpots that resist the motion of elements."""

    gamma: float  #: of local damping [-]
    alpha: float  #: of mass damping [1/s]
    viscous: bool  #: whether there is mass damping or any dashpot
    dashed: Floats  #: the sums of `Dashpots`, or (0, 8)
    absorbing: Floats  #: dashpots of each row, xx, yy, zz, xy, xz, yz [N·s/m], or (0, 6)


class Portions(NamedTuple):
    """Sums over portions of elements and bonds, and what is made of them."""

    elements: Floats  #: translation, rotation, damped, rubbed [J]
    bonds: Floats  #: energy of the four modes [J]
    turned: Ints  #: unbroken bonds turned wide, and lost; whether a number was not finite
    budget: Floats  #: energy at the start, the most that was put in since, and the supply of walls [J], (3,)
    found: Ints  #: bonds turned wide, and lost; 1 not finite, 2 a runaway; 1 for a list out of date, (4,)

    @classmethod
    def of(cls, n: int, m: int) -> "Portions":
        """Room for those of n elements and m bonds."""
        element, bond = -(-n // _ELEMENTS), -(-m // BONDS_OF_PORTION)
        return cls(
            np.zeros((element, 4)), np.zeros((bond, 4)), np.zeros((bond, 3), dtype=np.int64), np.zeros(3),
            np.zeros(4, dtype=np.int64),
        )  # fmt: skip


class HistoryRows(NamedTuple):
    """Rows of the history."""

    record: Floats  #: (records, columns)


class StepPasses(NamedTuple):
    """Lists of passes (`bondem._core_steps.Composer`)."""

    present: Ints  #: bring boundary conditions to the time of the clock
    opening: Ints  #: elements open a step after a pause
    travel: Ints  #: walls move, and lists of contacts may be out of date
    forces: Ints  #: forces, and what elements do with them
    resume: Ints  #: elements that a failure has delayed find their acceleration without what failed
    reopening: Ints  #: and open the next step
    guard: Ints  #: whether the run is sound
    record: Ints  #: a row of the history


class StepScheme(NamedTuple):
    """One step of time integration; see `bondem.dynamics.schemes`."""

    dt: float  #: [s]
    finish: float  #: [s]
    begin: float  #: [s]
    extra: float  #: [s²]
    gamma: float  #: of local damping [-]
    origin: float  #: time of step 0 [s]


class StepSpan(NamedTuple):
    """Steps that a call takes, and counts of what it did."""

    step: int  #: number of the present one
    steps: int  #: how many to go
    every: int  #: steps between records, 0 for none
    looks: bool  #: whether it takes none, and records the present
    stale: bool  #: whether the acceleration is to be found for that
    moved: bool  #: whether elements and walls have moved already in the first step, whose list was out of date
    n: int  #: elements
    m: int  #: bonds, without those that fill a group
    done: Ints  #: steps done, records written, bonds turned wide at most and lost, (4,)


# Elements and bonds of a portion, as in `core/steps.hpp`.
_ELEMENTS, BONDS_OF_PORTION = 1024, 2048
