"""Tables of `core/tables/statics_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Ints


class DynamicRelaxation(NamedTuple):
    """Motion, loads and constraints of n elements that relax."""

    pose: Floats  #: (n, 8)
    velocity: Floats  #: of centres and rotations, (n, 6)
    before: Floats  #: forces and torques of the bonds in the step before [N, N·m], (n, 6)
    load: Floats  #: at the end of the ramp [N, N·m], (n, 6)
    inverse: Floats  #: 1 / mass and 1 / moment of inertia, 0 where nothing is bonded, (n, 2)
    free: Bytes  #: degrees of freedom that nothing prescribes, (n, 6)
    motion: Floats  #: prescribed displacements and rotations at the end of the ramp [m, rad], (n, 6)
    memory: Floats  #: running means Σ v·ΔF and Σ m v² of the steps so far, (2,)
    ramp: int  #: steps in which loads and prescribed motions grow
    length: float  #: length that turns torques into forces [m]
    tolerance: float  #: unbalanced force over applied and supporting force at which to stop [-]
    noise: float  #: force that rounding leaves [N]


class RelaxationSpan(NamedTuple):
    """Steps of one call of the core."""

    first: int  #: number of the first step
    steps: int  #: largest number of steps
    done: Ints  #: number of steps that were taken, (1,)
    ratio: Floats  #: unbalanced force over applied and supporting force [-], (1,)
