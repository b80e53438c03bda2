"""Tables of `core/tables/crack_sample_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats


class SofteningSamples(NamedTuple):
    """Samples of facets that follow the softening curve (`laws/softening.hpp`)."""

    #: traction [Pa], normal, T_b [Pa], mean stress of both cells xx, yy, zz, xy, xz, yz [Pa]; f_t, 1 / T_l, c, 1 /
    #: T_l of slip [Pa, 1/Pa], tan φ, 1 for one integrity in all directions; axes e_1, e_2, e_3; s_1, s_2, s_3, grip;
    #: slip as a traction [Pa], distance of the faces over that of the cells [-], (36, m)
    given: Floats
    kink: float  #: κ of the softening curve [-]
    steep: float  #: m of the softening curve [-]
    wide: int  #: 1 to evaluate by lanes, 0 by single numbers
    #: s_1, s_2, s_3 and grip after softening, and the traction below which s_1 does not fall [Pa], (5, m)
    left: Floats


class CrackSamples(NamedTuple):
    """Samples of cracks (`laws/crack.hpp`)."""

    #: branch, orientations of i and j, levers of i and j, shares of i and j, normal; H, k, w; axes as a quaternion,
    #: s_1, s_2, s_3, grip, 1 with friction; σ of i and j [Pa], slip in the frame of i [m], friction; integrities,
    #: roots of energies and friction force before, (60, m)
    given: Floats
    wide: int  #: 1 to evaluate by lanes, 0 by single numbers
    #: force, torques on i and j, friction force, slip; three roots [√J], bending [J], torque of bending; energy
    #: across and along; energy dissipated by the crack and by friction; V θ of the halves of i and j [m³], (28, m)
    found: Floats


class YieldSamples(NamedTuple):
    """Samples of cells that yield (`laws/plasticity.hpp`)."""

    stress: Floats  #: [Pa], (6, m)
    strength: Floats  #: cohesion [Pa], slope, dilation, stiffness [Pa], slip carried over, (5, m)
    cone: int  #: 1 for Drucker and Prager, 0 for Mohr and Coulomb
    wide: int  #: 1 to evaluate by lanes, 0 by single numbers
    #: bound of F [Pa], Δγ, its part for the next step, strain xx, yy, zz, xy, xz, yz; principal stresses [Pa]; F
    #: plus the cohesion [Pa], (13, m)
    found: Floats


class StressBoundSamples(NamedTuple):
    """Bounds of principal stresses, and of the opening traction of bending (`laws/stress.hpp`)."""

    stress: Floats  #: [Pa], (6, m)
    bent: Floats  #: T_b [Pa], (m,)
    wide: int  #: 1 to evaluate by lanes, 0 by single numbers
    #: bounds of σ_1 and σ_3; T_b less the largest pressure, at least 0, and an upper bound of that [Pa], (4, m)
    found: Floats
