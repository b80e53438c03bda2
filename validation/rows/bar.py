"""Tests of the calibrated silica cylinder of André et al. (2012), 10 × 40 mm, as rows of a study."""

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, ClassVar

from bondem.calibration import calibrate
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.law_catalogue import DEFAULT
from bondem.labtests.tension import Tension, static_tension
from bondem.packing import SEED
from bondem.packing.sizes import SPREAD
from bondem.specimen.lattice import Lattice
from bondem.specimen.materials import fused_silica
from validation.frame.failures import complain
from validation.frame.files import plain
from validation.frame.limits import numbers
from validation.frame.study import Stages, Study
from validation.rows.packings import PackingRequest, PackingTest, kept_lattice


@dataclass(frozen=True, eq=False)
class CalibratedBar:
    """One packing, bonded.

    Attributes:
        seed: of its packing.
        lattice: elements and bonds.
        law: calibrated on the first packing.
        density: of the elements, from eq (19) on the first packing [kg/m³].
        tension: its own tension test.
        rho: its own density [kg/m³].
    """

    seed: int
    lattice: Lattice
    law: BondLaw
    density: float
    tension: Tension
    rho: float

    @classmethod
    def of(cls, lattice: Lattice, law: BondLaw, density: float, seed: int) -> "CalibratedBar":
        """Pull a bonded packing once."""
        mass = density * lattice.particles.volume[lattice.connected].sum()
        rho = float(mass / lattice.particles.envelope.volume)
        return cls(seed, lattice, law, density, static_tension(lattice, law), rho)

    @property
    def own(self) -> dict[str, Any]:
        """E, ν and ρ of this packing, by the names the tests take them."""
        return {"E": self.tension.E, "nu": self.tension.nu, "rho": self.rho}

    @property
    def told(self) -> dict[str, Any]:
        """What `results.json` says of it."""
        return {
            "specimen": {"elements": len(self.lattice.particles), "seed": self.seed},
            "macro": self.own,
        }


@dataclass(frozen=True)
class BarTest(PackingTest):
    """A test of one bar.

    Attributes:
        packing: made before.
        law: its bonds.
        density: of its elements [kg/m³].
    """

    law: BondLaw
    density: float

    def measured(self, folder: Path) -> dict[str, Any]:
        """What `tested` gives, and what there is to say of the bar."""
        lattice = kept_lattice(self.packing, folder)
        bar = CalibratedBar.of(lattice, self.law, self.density, self.packing.seed)
        return plain(self.tested(bar, folder) | {"bar": bar.told})

    @abstractmethod
    def tested(self, bar: CalibratedBar, folder: Path) -> dict[str, Any]:
        """Carry the test out; what figures need is kept in the folder."""


@dataclass(frozen=True)
class BarStudy(Study):
    """A study of calibrated bars.

    Attributes:
        count: spheres of a packing.
        seed: of the first packing, on which the bonds are calibrated.
        packings: how many, seeds in sequence.
    """

    limits: ClassVar = {
        "count": numbers(least=500, advice="at least 500 spheres, or the cylinder is no bar"),
        "packings": numbers(least=1),
    }

    count: int = 10_000
    seed: int = SEED
    packings: int = 1

    @property
    def bars(self) -> list[PackingRequest]:
        """What is packed."""
        return [
            PackingRequest(self.count, SPREAD, "quench", "contacts", self.seed + k, form="bar")
            for k in range(self.packings)
        ]

    def stages(self, out: Path) -> Stages:
        """See `Study`; the bonds are calibrated between the two."""
        complain((yield "pack", self.bars), out)
        complain((yield "test", self.calibrated_tests(out)), out, what="tests")

    def calibrated_tests(self, out: Path) -> Sequence[BarTest]:
        """What is tested, when the packings are there."""
        bars = self.bars
        return self.tests(bars, *calibrated(bars[0], out))

    def first(self, out: Path) -> tuple[PackingRequest, Any]:
        """The first packing, and what the first test of it has kept."""
        return self.bars[0], self.calibrated_tests(out)[0].kept(out)

    @abstractmethod
    def tests(self, packings: Sequence[PackingRequest], law: BondLaw, density: float) -> Sequence[BarTest]:
        """What is tested."""


@lru_cache(maxsize=1)
def calibrated(packing: PackingRequest, out: Path) -> tuple[BondLaw, float]:
    """The paper's bonds and the density of the elements [kg/m³], calibrated on a packing that is there."""
    fit = calibrate(kept_lattice(packing, out), fused_silica, law=DEFAULT)
    return fit.law, fit.density
