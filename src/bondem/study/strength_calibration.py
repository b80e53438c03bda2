"""Pipeline of `bondem strength`: fit tensile strength and cohesion to UCS and Brazilian strength of cylinders."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from bondem._checks import count as whole
from bondem._checks import number
from bondem.calibration.strength import StrengthCalibration, calibrate_strength
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.geometry.elementary_shapes import Cylinder
from bondem.interactions.cells.cell_bond import CellBond
from bondem.labtests.failure.brazilian import brazilian
from bondem.labtests.failure.uniaxial_compression import uniaxial_compression
from bondem.packing import SEED, pack
from bondem.specimen.bonding import connect
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, kw_only=True)
class StrengthPlan:
    """Plan of a calibration of the strengths of cells by tests of cylinders; an invalid value raises InputError.

    Attributes:
        E: Young's modulus [Pa].
        nu: Poisson's ratio [-].
        ucs: target uniaxial compressive strength [Pa].
        brazilian: target Brazilian strength 2 P / (π D t) [Pa].
        ucs_within, brazilian_within: tolerances of the strengths [Pa]; None for 4 % and 7.5 % of the targets.
        friction_angle: friction angle φ [rad].
        fracture_energy: fracture energy G_f [J/m²].
        diameter, length: dimensions of the cylinders [m].
        count: number of cells per packing.
        packings: number of packings, with seeds seed, seed + 1, …; their mean is calibrated.
        seed: seed of the first packing.
        most: largest number of runs; a run is both tests on all packings.
    """

    E: float
    nu: float
    ucs: float
    brazilian: float
    ucs_within: float | None = None
    brazilian_within: float | None = None
    friction_angle: float = math.radians(35.0)
    fracture_energy: float = 100.0
    diameter: float = 100e-3
    length: float = 200e-3
    count: int = 2000
    packings: int = 1
    seed: int = SEED
    most: int = 15

    def __post_init__(self) -> None:
        for name in ("ucs", "brazilian"):
            number("", name, getattr(self, name), above=0.0, unit="Pa")
        for name, least in (("count", 1), ("packings", 1), ("seed", 0), ("most", 1)):
            whole("", name, getattr(self, name), least=least)
        number("", "friction_angle", self.friction_angle, least=0.0, below=0.5 * math.pi, unit="rad")
        self.failure(1e6, 1e6)  # raises an error for an invalid energy
        CellBond(E=self.E, nu=self.nu)

    def failure(self, tension: float, cohesion: float) -> MohrCoulomb:
        """Create the failure criterion with a tensile strength and a cohesion [Pa]."""
        return MohrCoulomb(
            tension=tension, cohesion=cohesion, friction_angle=self.friction_angle,
            fracture_energy=self.fracture_energy,
        )  # fmt: skip

    @property
    def start(self) -> dict[str, float]:
        """Initial tensile strength and cohesion, those of a continuum with both target strengths [Pa]."""
        sine, cosine = math.sin(self.friction_angle), math.cos(self.friction_angle)
        return {"tension": self.brazilian, "cohesion": 0.5 * self.ucs * (1.0 - sine) / cosine}


def run_strength(
    plan: StrengthPlan, out: str | Path | None = None, *, progress: Callable[[str], None] | None = None
) -> StrengthCalibration:
    """Pack, test and calibrate cells by a plan; `progress` is called with a line of text before each test.

    With a folder `out`, every test is stored there, and a later call continues from the stored tests.

    Raises:
        InputError: the folder cannot be written to, or has runs of another plan.
        UnstableRunError: a test with the initial strengths became unstable.
    """
    bodies: list[Lattice] = []
    law = CellBond(E=plan.E, nu=plan.nu)

    def specimens() -> list[Lattice]:
        shape = Cylinder(radius=0.5 * plan.diameter, length=plan.length)
        for k in range(len(bodies), plan.packings):
            particles = pack(shape, count=plan.count, method="even", seed=plan.seed + k)
            bodies.append(connect(particles, method="laguerre"))
        return bodies

    def pressed(tension: float, cohesion: float) -> list[float]:
        return [uniaxial_compression(one, law, plan.failure(tension, cohesion)).peak for one in specimens()]

    def split(tension: float, cohesion: float) -> list[float]:
        return [brazilian(one, law, plan.failure(tension, cohesion)).peak for one in specimens()]

    within = plan.ucs_within or 0.04 * plan.ucs, plan.brazilian_within or 0.075 * plan.brazilian
    targets = {"ucs": (plan.ucs, within[0]), "brazilian": (plan.brazilian, within[1])}
    return calibrate_strength(
        {"ucs": pressed, "brazilian": split}, targets, plan.start, strengths=("tension", "cohesion"), most=plan.most,
        out=out, progress=progress,
        about=(
            f"cells, E = {plan.E:g}, nu = {plan.nu:g}, friction_angle = {plan.friction_angle:g},"
            f" fracture_energy = {plan.fracture_energy:g}, {plan.diameter:g} x {plan.length:g} m,"
            f" {plan.packings} x {plan.count}, seed {plan.seed}"
        ),
    )  # fmt: skip
