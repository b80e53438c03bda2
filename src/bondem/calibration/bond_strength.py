"""Strengths of bonds between spheres for given strengths of specimens: UCS and direct tension."""

from collections.abc import Callable, Sequence
from functools import partial

from bondem._checks import number
from bondem.calibration.strength import StrengthCalibration, calibrate_strength
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondLaw
from bondem.labtests.failure.direct_tension import direct_tension
from bondem.labtests.failure.uniaxial_compression import uniaxial_compression
from bondem.labtests.quasi_static_rig import StrengthTest
from bondem.specimen.lattice import Lattice

# Tolerances over the targets [-]: strengths of packings of some hundred spheres scatter by 5 to 10 %.
_WITHIN = {"ucs": 0.04, "tension": 0.04}
# Start values: tensile strength of the bonds over the target, and cohesion over that tensile strength. The direct
# tensile strength of a packing is about half that of its bonds.
_BOND, _COHESION = 2.0, 2.0
# Largest cohesion over the tensile strength: beyond it bonds fail in tension only, and cohesion has no effect.
_LARGEST = 20.0


def calibrate_bond_strength(
    lattices: Sequence[Lattice], law: BondLaw, *, ucs: float, tension: float, friction_angle: float, density: float,
) -> StrengthCalibration:  # fmt: skip
    """Calibrate tensile strength and cohesion of `bd.MohrCoulomb` bonds to mean strengths of several specimens.

    Args:
        lattices: bars along x.
        law: calibrated bond law.
        ucs: target of `labtests.uniaxial_compression` with smooth platens [Pa].
        tension: target of `labtests.direct_tension` [Pa].
        friction_angle: friction angle of the bonds [rad].
        density: density of the elements [kg/m³].

    Raises:
        InputError: a target that is not positive, a UCS not above the tensile strength, or a periodic cell.
        UnstableRunError: a test failed at the start.
    """
    targets = {"ucs": number("calibrate", "ucs", ucs, unit="Pa", above=0.0),
               "tension": number("calibrate", "tension", tension, unit="Pa", above=0.0)}  # fmt: skip
    if not targets["ucs"] > targets["tension"]:
        raise InputError(
            f"calibrate: ucs = {ucs:g} Pa: not above tension = {tension:g} Pa; give a compressive strength above the"
            " tensile one"
        )
    if any(one.particles.period is not None for one in lattices):
        raise InputError(
            "calibrate: ucs and tension need specimens with ends, and the lattice is a periodic cell; pack a"
            " bd.Cylinder or a bd.Box"
        )
    tests = {"ucs": uniaxial_compression, "tension": direct_tension}

    def run(test: Callable[..., StrengthTest], body: Lattice, tension: float, cohesion: float) -> float:
        failure = MohrCoulomb(tension=tension, cohesion=cohesion, friction_angle=friction_angle)
        return test(body, law, failure, density=density).peak

    start = _BOND * targets["tension"]
    return calibrate_strength(
        {name: [partial(run, test, body) for body in lattices] for name, test in tests.items()},
        {name: (target, _WITHIN[name] * target) for name, target in targets.items()},
        {"tension": start, "cohesion": _COHESION * start}, strengths=("tension", "cohesion"),
        bounds={"cohesion": (0.05 * start, _LARGEST * start)},
    )  # fmt: skip
