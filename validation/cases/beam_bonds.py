"""Beam bonds for a published case: E and ν by `bd.calibrate`, strength by direct tension of another specimen.

Fixed before the runs: Euler–Bernoulli beams between spheres packed by the default method; a bar 3 : 1 : 1 of 1000
spheres (seed 101), on which E and ν are calibrated and which is pulled apart between smooth platens; a shear strength
of twice the tensile one. The strength of a brittle lattice is proportional to that of its bonds, nearly so where it
is pulled at a finite speed: three tests, each with the strength that follows from the one before; what the last has
is told.
"""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np

import bondem as bd
from bondem.errors import UnstableRunError

#: The bar for calibration: seed, spheres, and its edge [m]; no strength depends on the last.
SEED, COUNT, EDGE = 101, 1000, 0.01
#: Shear strength of bonds over their tensile strength.
SHEAR = 2.0
#: Tests in direct tension.
PULLS = 3
# Traverses of sound until the strain f_t / E, damping of the first axial vibration, and strain at the latest end.
_TRAVERSES, _DAMPING, _REACH = 60.0, 0.05, 6.0


@dataclass(frozen=True, eq=False)
class BeamBonds:
    """Calibrated bonds.

    Attributes:
        law: of the bonds.
        density: of the spheres [kg/m³].
        failure: of the bonds.
        factor: strength of the bar over that of its bonds, in the last test [-].
        tension: strength of the bar in the last test [Pa].
    """

    law: bd.EulerBernoulli
    density: float
    failure: bd.PeripheralStress
    factor: float
    tension: float


@cache
def beam_bonds(E: float, nu: float, rho: float, tension: float) -> BeamBonds:
    """Bonds for a material with a tensile strength [Pa]."""
    bar = bd.connect(bd.pack(bd.Box((3.0 * EDGE, EDGE, EDGE)), count=COUNT, seed=SEED))
    fit = bd.calibrate(bar, bd.Material("of the case", E=E, nu=nu, rho=rho), law=bd.EulerBernoulli)
    assert isinstance(fit.law, bd.EulerBernoulli)
    failure = _criterion(2.0 * tension)
    found = _pulled(bar, fit.law, fit.density, failure, E, tension)
    for _ in range(PULLS - 1):
        failure = _criterion(failure.tension * tension / found)
        found = _pulled(bar, fit.law, fit.density, failure, E, tension)
    return BeamBonds(fit.law, fit.density, failure, found / failure.tension, found)


def _criterion(tension: float) -> bd.PeripheralStress:
    return bd.PeripheralStress(tension=tension, shear=SHEAR * tension)


def _pulled(
    bar: bd.Lattice, law: bd.EulerBernoulli, density: float, failure: bd.PeripheralStress, E: float, tension: float
) -> float:
    """Strength of a bar in direct tension [Pa], slowly."""
    length, section = 3.0 * EDGE, EDGE**2
    sound = math.sqrt(E / (density * 0.63))
    rise = _TRAVERSES * length / sound
    speed = tension / E * length / rise
    model = bd.Model(bar, law, density, failure=failure, boundary=[
        bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
        bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, speed, 0.2 * rise)),
    ])  # fmt: skip
    run = bd.solve_explicit(
        model, duration=_REACH * rise, every=20, gauges={"end": bd.Gauge(bd.Face("x_max"), "force")},
        until=bd.LoadDrop({"end": (1.0, 0.0, 0.0)}, 0.3, 0.2 * tension * section),
        damping=bd.MassDamping(alpha=2.0 * _DAMPING * math.pi * sound / length),
    )  # fmt: skip
    if run.status.failed:
        raise UnstableRunError(run.message)
    return float(np.max(run.history["end"][:, 0])) / section
