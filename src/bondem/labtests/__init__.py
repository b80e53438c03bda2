"""Standard laboratory tests of a specimen, each with its measured value and the theoretical value."""

import sys
from typing import TYPE_CHECKING

from bondem._describe import describe
from bondem._guard import guard
from bondem._names import no_attribute
from bondem.labtests.ball import BrokenBall, FragmentSizes
from bondem.labtests.cantilever import clamped_tension, static_bending, static_torsion
from bondem.labtests.celerity import impact
from bondem.labtests.cracking import Cracking
from bondem.labtests.dynamic import dynamic_bending, dynamic_tension, dynamic_torsion
from bondem.labtests.failure.brazilian import BrazilianTest, brazilian
from bondem.labtests.failure.direct_tension import direct_tension
from bondem.labtests.failure.shear import punch_specimen, shear
from bondem.labtests.failure.spall import SpallTest, ThinBar, spall
from bondem.labtests.failure.sphere_crushing import SphereCrushing, sphere_crushing
from bondem.labtests.failure.sphere_impact import SphereImpact, sphere_impact
from bondem.labtests.failure.three_point_bending import BendingTest, three_point_bending
from bondem.labtests.failure.triaxial import TriaxialTest, triaxial
from bondem.labtests.failure.uniaxial_compression import uniaxial_compression
from bondem.labtests.isotropic import Isotropic
from bondem.labtests.modal import NaturalFrequencies, natural_frequencies
from bondem.labtests.outcome import Outcome
from bondem.labtests.quasi_static_rig import StrengthTest
from bondem.labtests.tension import Tension, static_tension
from bondem.labtests.uniform_traction import UniformStress, uniform_stress
from bondem.labtests.vibration import FreeVibration, free_vibration

__all__ = [
    "BendingTest",
    "BrazilianTest",
    "BrokenBall",
    "Cracking",
    "FragmentSizes",
    "FreeVibration",
    "Isotropic",
    "NaturalFrequencies",
    "Outcome",
    "SpallTest",
    "SphereCrushing",
    "SphereImpact",
    "StrengthTest",
    "Tension",
    "ThinBar",
    "TriaxialTest",
    "UniformStress",
    "brazilian",
    "clamped_tension",
    "direct_tension",
    "dynamic_bending",
    "dynamic_tension",
    "dynamic_torsion",
    "free_vibration",
    "impact",
    "natural_frequencies",
    "punch_specimen",
    "shear",
    "spall",
    "sphere_crushing",
    "sphere_impact",
    "static_bending",
    "static_tension",
    "static_torsion",
    "three_point_bending",
    "triaxial",
    "uniaxial_compression",
    "uniform_stress",
]

for _name in __all__:
    _home = globals()[_name].__module__
    guard({_home: tuple(__all__)})
    globals()[_name] = getattr(sys.modules[_home], _name)
    describe({_home: tuple(__all__)})


if not TYPE_CHECKING:  # type checkers report wrong names themselves

    def __getattr__(name: str) -> None:
        raise AttributeError(no_attribute("bd.labtests", name, __all__), name=name)


def __dir__() -> list[str]:
    return __all__
