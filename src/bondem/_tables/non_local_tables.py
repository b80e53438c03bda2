"""Tables of `core/tables/non_local_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints


class NonLocalBonds(NamedTuple):
    """Bonds of the non-local law, m of them, the data that they store, and their present loads."""

    area: Floats  #: [m²], (m,)
    kn: Floats  #: [N/m], (m,)
    kt: Floats  #: [N/m], (m,)
    normal: Floats  #: from i to j in the reference [-], (3, m)
    lever_i: Floats  #: from the element i to the contact point in the reference [m], (3, m)
    lever_j: Floats  #: from the element j to the contact point in the reference [m], (3, m)
    nu: float  #: ν [-]
    limited: int  #: 1 to limit the extra shear force
    history: Floats  #: gap [m], extra force [N] and its work [J], in the frame of element i, (7, m)
    output: Floats  #: force on i, torque on i, minus torque on j, now [N, N·m], (9, m)


class SmallPairs(NamedTuple):
    """Bonds at small strain, and the stresses and gaps of the iteration before."""

    pairs: Ints  #: elements of each bond, (m, 2)
    area: Floats  #: [m²], (m,)
    kt: Floats  #: [N/m], (m,)
    nu: float  #: ν [-]
    limited: int  #: 1 to limit the extra shear force
    normal: Floats  #: [-], (m, 3)
    stress: Floats  #: of the elements, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    gap: Floats  #: [m], (m, 3)


class SmallSprings(NamedTuple):
    """Springs and dashpots of bonds at small strain."""

    kn: Floats  #: [N/m], (m,)
    lever_i: Floats  #: from the element i to the contact point [m], (m, 3)
    lever_j: Floats  #: from the element j to the contact point [m], (m, 3)
    along: Floats  #: dashpots along the normals [N·s/m], (m,)
    across: Floats  #: dashpots across the normals [N·s/m], (m,)


class SmallSteps(NamedTuple):
    """Steps of small motions (u, θ) of n elements; `stress` and `gap` are the arrays of `SmallPairs`."""

    dt: float  #: [s]
    gamma: float  #: local damping [-]
    weight: Floats  #: masses and moments of inertia [kg, kg·m²], (n, 6)
    volume: Floats  #: V [m³], (n,)
    motion: Floats  #: [m, rad], (n, 6)
    speed: Floats  #: [m/s, rad/s], (n, 6)
    load: Floats  #: forces and torques [N, N·m], (n, 6)
    moment: Floats  #: V σ of the present forces [N·m], (n, 6)
    stress: Floats  #: of the elements, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    gap: Floats  #: [m], (m, 3)
    size: Floats  #: twice the kinetic energy after each step [J], (steps,)


class ExtraForces(NamedTuple):
    """Extra forces of the bonds of the non-local law."""

    force: Floats  #: [N], (m, 3)
