"""One packing of a study: what was asked for, and the row of numbers it gave.

Its spheres and bonds are kept beside the rows, in DIR/packings/NAME.h5, so that figures and tests of it need no
packing again.
"""

import math
import time
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, cast

import numpy as np

import bondem as bd
from bondem.io.particles_file import load_bonded
from bondem.packing import Method
from bondem.specimen.direction_sphere import direction_sphere
from bondem.specimen.interior import region
from validation.frame.request import Request

#: What `pack` can be asked for here: the onset of jamming, or 6.2 contacts a sphere, its default.
TARGETS = ("jamming", "contacts")

# Nothing that is measured of a packing depends on the edge [m].
_EDGES = (0.01, 0.01, 0.01)

#: What is packed: a cube, or the bar of the paper's §5.1, 10 mm thick and 40 mm long.
FORMS: dict[str, bd.Shape] = {"cube": bd.Box(_EDGES), "bar": bd.Cylinder(radius=5e-3, length=40e-3)}

# Contacts of spheres this far from the walls [mean radii] are free of them.
_DEEP = 3.0


class Packed(Request):
    """A body whose spheres and bonds are kept beside the rows."""

    def packing_file(self, folder: Path) -> Path:
        """Where they are kept."""
        return folder / "packings" / f"{self.name}.h5"

    def whole(self, folder: Path) -> bool:
        return self.packing_file(folder).is_file()


@dataclass(frozen=True)
class PackingRequest(Packed):
    """One packing of a study.

    Attributes:
        count: number of spheres.
        spread: κ, radii uniform in R̄ (1 ± κ/2) [-].
        method: of `bd.pack`.
        target: one of `TARGETS`.
        seed: which of the random packings.
        periodic: whether the cube goes on beyond its faces, instead of having walls.
        form: one of `FORMS`.
    """

    count: int
    spread: float
    method: str
    target: str
    seed: int
    periodic: bool = False
    form: str = "cube"

    @property
    def shape(self) -> bd.Shape:
        """What is filled."""
        return bd.Cell(_EDGES) if self.periodic else FORMS[self.form]

    def measured(self, folder: Path) -> dict[str, Any]:
        """Pack, bond and measure, and keep the packing; the time is that of packing."""
        start = time.perf_counter()
        particles = bd.pack(
            self.shape, count=self.count, spread=self.spread, method=cast(Method, self.method), seed=self.seed,
            jamming=self.target == "jamming",
        )  # fmt: skip
        seconds = round(time.perf_counter() - start, 3)
        lattice = bd.connect(particles)
        found = _measures(lattice)
        bd.save_particles(self.packing_file(folder), lattice, provenance=asdict(self))
        return {"seconds": seconds} | found


@dataclass(frozen=True)
class PackingTest(Request):
    """What is measured of one packing.

    Attributes:
        packing: made before.
    """

    packing: PackingRequest

    @property
    def weight(self) -> float:
        return float(self.packing.count)

    @property
    def needs(self) -> PackingRequest:
        return self.packing

    @property
    def asked(self) -> dict[str, Any]:
        return asdict(self.packing)


def kept_lattice(request: Packed, folder: Path) -> bd.Lattice:
    """The spheres and bonds behind a row."""
    particles, pairs = load_bonded(request.packing_file(folder))
    assert pairs is not None
    return bd.Lattice(particles, pairs)


@lru_cache(maxsize=2)
def shared_lattice(request: Packed, folder: Path) -> bd.Lattice:
    """The same once for several laws that ask for it in turn."""
    return kept_lattice(request, folder)


def _measures(lattice: bd.Lattice) -> dict[str, Any]:
    quality = bd.fabric(lattice)
    particles = lattice.particles
    inside = region(particles).depth(particles.position) >= _DEEP * particles.mean_radius
    bonds = np.bincount(lattice.pairs.ravel(), minlength=len(particles))
    numbers = {
        "volume_fraction": quality.volume_fraction,
        "core_volume_fraction": quality.core_volume_fraction,
        "coordination_number": quality.coordination_number,
        "core_coordination_number": float(bonds[inside].mean()) if inside.any() else math.nan,
        "backbone_coordination_number": quality.backbone_coordination_number,
        "loose_share": quality.loose / len(particles),
        "isotropy_error": quality.isotropy_error,
        "isotropy_error_random": random_isotropy_error(len(lattice.pairs)),
        "chi2_per_dof": quality.chi2_per_dof,
        "rms_excess": quality.rms_excess,
        "core_rms_excess": quality.core_rms_excess,
        "stretch": float(np.abs(3.0 * quality.eigenvalues - 1.0).max()),
        "core_stretch": quality.core_stretch,
        "largest_overlap": quality.largest_overlap,
        "fineness": quality.fineness,
    }
    finite = {name: value if math.isfinite(value) else None for name, value in numbers.items()}
    verdict = {"passed": quality.passed, "reasons": list(quality.reasons)}
    return {"bonds": len(lattice.pairs), "rattlers": quality.rattlers} | finite | verdict


def random_isotropy_error(bonds: int) -> float:
    """Mean of e, eq (11), for that many bonds of random direction in an isotropic fabric [-].

    A bond counts on a face and on the opposite one, so that the frequency f of both is half that of a binomial draw.
    What is left for infinitely many bonds is due to the faces, which are not equal.
    """
    share = direction_sphere().solid_angle / (4.0 * np.pi)
    chance = 2.0 * share * (1.0 - 2.0 * share) / (4.0 * bonds)
    return float(np.mean(chance + (share - 1.0 / len(share)) ** 2))
