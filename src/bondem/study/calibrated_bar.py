"""The specimen of the dynamic studies: the calibrated silica cylinder of André et al. (2012), 10 × 40 mm."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from bondem.calibration import calibrate
from bondem.errors import InputError
from bondem.labtests.tension import Tension, static_tension
from bondem.laws.bond import BondLaw
from bondem.laws.catalogue import DEFAULT
from bondem.packing import SEED, pack
from bondem.packing.sizes import SPREAD
from bondem.specimen.bonding import connect
from bondem.specimen.geometry import Cylinder
from bondem.specimen.lattice import Lattice
from bondem.specimen.materials import fused_silica

#: Diameter 10 mm, length 40 mm.
CYLINDER = Cylinder(radius=5e-3, length=40e-3)


@dataclass(frozen=True)
class BarRequest:
    """Which packings a study looks at.

    Attributes:
        count: number of spheres.
        seed: of the first packing, on which the bonds are calibrated.
        packings: how many, seeds in sequence.
    """

    count: int = 10_000
    seed: int = SEED
    packings: int = 1

    def __post_init__(self) -> None:
        if self.count < 500:
            raise InputError(f"count = {self.count}; give at least 500 spheres, or the cylinder is no bar")
        if self.packings < 1:
            raise InputError(f"packings = {self.packings}; give at least 1")


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

    @property
    def own(self) -> dict[str, Any]:
        """E, ν and ρ of this packing, by the names the tests take them."""
        return {"E": self.tension.E, "nu": self.tension.nu, "rho": self.rho}

    @property
    def told(self) -> dict[str, Any]:
        """What `results.json` says of it."""
        particles = self.lattice.particles
        return {
            "specimen": {
                "elements": len(particles),
                "bonds": len(self.lattice.pairs),
                "coordination_number": 2.0 * len(self.lattice.pairs) / len(particles),
                "mean_radius": particles.mean_radius,
                "rattlers": int((~self.lattice.connected).sum()),
                "seed": self.seed,
            },
            "micro": {
                "law": type(self.law).__name__,
                "E_mu": self.law.E,
                "nu_mu": self.law.nu,
                "r_mu_ratio": getattr(self.law, "radius_ratio", None),
                "rho_mu": self.density,
            },
            "macro": self.own,
        }


def calibrated_bars(request: BarRequest, tell: Callable[[str, float], None]) -> tuple[CalibratedBar, ...]:
    """Pack and bond all, calibrate the paper's bonds on the first, and pull each once.

    Args:
        request: which packings.
        tell: told the stage and the share of it that is done.

    Raises:
        PackingError: a packing did not reach its target.
    """
    lattices = []
    for k in range(request.packings):
        stage = f"pack {k + 1} of {request.packings}"
        particles = pack(
            CYLINDER, count=request.count, spread=SPREAD, seed=request.seed + k,
            progress=lambda share, stage=stage: tell(stage, share),
        )  # fmt: skip
        lattices.append(connect(particles))
    tell("calibrate", 0.0)
    fit = calibrate(lattices[0], fused_silica, law=DEFAULT)
    bars = []
    for k, lattice in enumerate(lattices):
        tension = static_tension(lattice, fit.law)
        mass = fit.density * lattice.particles.volume[lattice.connected].sum()
        rho = float(mass / lattice.particles.envelope.volume)
        bars.append(CalibratedBar(request.seed + k, lattice, fit.law, fit.density, tension, rho))
        tell("calibrate", (k + 1) / len(lattices))
    return tuple(bars)
