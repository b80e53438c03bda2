"""Table of the elastic tests of studies: static tests, natural frequencies and the speed of a wave."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.cantilever import clamped_tension, static_bending, static_torsion
from bondem.labtests.celerity import impact
from bondem.labtests.dynamic import dynamic_bending, dynamic_tension, dynamic_torsion
from bondem.labtests.modal import NaturalFrequencies, natural_frequencies
from bondem.labtests.outcome import Outcome
from bondem.labtests.tension import Tension
from bondem.labtests.vibration import FreeVibration, free_vibration
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class ElasticBar:
    """Bar with measured elasticity, and results that several of its tests share.

    Attributes:
        lattice: the bar.
        law: law of its bonds or cells.
        tension: measured moduli of the bar.
        density: density of the elements [kg/m³].
        rho: mass of the bar over the volume of its shape [kg/m³].
    """

    lattice: Lattice
    law: AnyLaw
    tension: Tension
    density: float
    rho: float

    @property
    def moduli(self) -> dict[str, float]:
        """Measured E [Pa] and ν [-], as keyword arguments of tests."""
        return {"E": self.tension.E, "nu": self.tension.nu}

    @property
    def moving(self) -> dict[str, Any]:
        """Measured E [Pa] and ν [-], and densities of elements and bar [kg/m³], as arguments of dynamic tests."""
        return self.moduli | {"density": self.density, "rho": self.rho}

    @cached_property
    def frequencies(self) -> NaturalFrequencies:
        """First natural frequencies of the bar clamped at x_min."""
        return natural_frequencies(self.lattice, self.law, density=self.density)

    @cached_property
    def vibration(self) -> FreeVibration:
        """Vibration of the bar clamped at x_min, after the release of its loads."""
        return free_vibration(self.lattice, self.law, **self.moving)


@dataclass(frozen=True)
class ElasticTest:
    """Elastic test of a bar along x.

    Attributes:
        name: name in studies and results.
        perform: function that runs the test on a bar.
        vibrates: True if the test uses the natural frequencies and the free vibration of the bar.
    """

    name: str
    perform: Callable[[ElasticBar], Outcome]
    vibrates: bool = False


def _still(test: Callable[..., Outcome]) -> Callable[[ElasticBar], Outcome]:
    return lambda bar: test(bar.lattice, bar.law, **bar.moduli, gyration=bar.tension.gyration)


def _vibrating(test: Callable[..., Outcome]) -> Callable[[ElasticBar], Outcome]:
    return lambda bar: test(
        bar.lattice, bar.law, **bar.moving, modes=bar.frequencies, vibration=bar.vibration,
        gyration=bar.tension.gyration,
    )  # fmt: skip


_RECORDS = (
    ElasticTest("static_tension", _still(clamped_tension)),
    ElasticTest("static_bending", _still(static_bending)),
    ElasticTest("static_torsion", _still(static_torsion)),
    ElasticTest("dynamic_tension", _vibrating(dynamic_tension), vibrates=True),
    ElasticTest("dynamic_bending", _vibrating(dynamic_bending), vibrates=True),
    ElasticTest("dynamic_torsion", _vibrating(dynamic_torsion), vibrates=True),
    ElasticTest("impact", lambda bar: impact(bar.lattice, bar.law, **bar.moving)),
)
#: Elastic tests by their names in studies, in the order in which a study runs them unless it has its own.
ELASTIC_TESTS: Mapping[str, ElasticTest] = {one.name: one for one in _RECORDS}
