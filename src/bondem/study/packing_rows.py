"""One packing of a study: what was asked for, and the row of numbers it gave, kept in two files.

    DIR/rows/NAME.json        the row
    DIR/packings/NAME.h5      the spheres and their bonds, so that figures need no packing again

NAME ends in a hash of the request and of all the code that packs: a row of another request, or of another version, is
never taken for this one. The row comes last and in one move, so that where it is, all is.
"""

import json
import math
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem.errors import BondemError, UnstableRunError
from bondem.io.atomic import write_text
from bondem.io.packing_cache import key
from bondem.io.particles_file import load_bonded, save_particles
from bondem.packing import pack
from bondem.solve.threads import one_blas_thread
from bondem.specimen.bonding import connect
from bondem.specimen.core import region
from bondem.specimen.fabric import fabric
from bondem.specimen.geode import geode
from bondem.specimen.geometry import Box, Cell, Shape
from bondem.specimen.lattice import Lattice

#: What `pack` can be asked for here: the onset of jamming, or 6.2 contacts a sphere, its default.
TARGETS = ("jamming", "contacts")

# The same for all; nothing that is measured depends on the edge [m].
_EDGES = (0.01, 0.01, 0.01)

# To be raised when rows hold something else than before.
_SCHEMA = 1

# Contacts of spheres this far from the walls [mean radii] are free of them.
_DEEP = 3.0


@dataclass(frozen=True)
class PackingRequest:
    """One packing of a study, in a cube.

    Attributes:
        count: number of spheres.
        spread: κ, radii uniform in R̄ (1 ± κ/2) [-].
        method: of `bd.pack`.
        target: one of `TARGETS`.
        seed: which of the random packings.
        periodic: whether the cube goes on beyond its faces, instead of having walls.
    """

    count: int
    spread: float
    method: str
    target: str
    seed: int
    periodic: bool = False

    @property
    def shape(self) -> Shape:
        """The cube."""
        return Cell(_EDGES) if self.periodic else Box(_EDGES)

    @property
    def name(self) -> str:
        """What its files are called: readable, and unlike that of any other request or version."""
        request = asdict(self) | {"shape": self.shape, "row": _SCHEMA}
        walls = "_periodic" if self.periodic else ""
        readable = f"{self.method}_{self.target}{walls}_k{100.0 * self.spread:g}_n{self.count}_seed{self.seed}"
        return f"{readable}_{key(request)[:12]}"

    def row_file(self, folder: Path) -> Path:
        """Where its row is kept."""
        return folder / "rows" / f"{self.name}.json"

    def packing_file(self, folder: Path) -> Path:
        """Where its spheres and bonds are kept."""
        return folder / "packings" / f"{self.name}.h5"


def kept_row(request: PackingRequest, folder: Path) -> dict[str, Any] | None:
    """The row of a request that is there already, or None; a failed packing is a row with an `error`."""
    try:
        row = json.loads(request.row_file(folder).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    whole = isinstance(row, dict) and "error" in row
    return row if whole and (row["error"] or request.packing_file(folder).is_file()) else None


def kept_lattice(request: PackingRequest, folder: Path) -> Lattice:
    """The spheres and bonds behind a row."""
    particles, pairs = load_bonded(request.packing_file(folder))
    assert pairs is not None
    return Lattice(particles, pairs)


@one_blas_thread
def packed_row(request: PackingRequest, folder: Path) -> dict[str, Any]:
    """Pack, bond and measure, and keep the packing and its row.

    Returns:
        The row. A packing that failed has a row, too, with the reason; to try it again, delete its file.
    """
    row: dict[str, Any] = asdict(request) | {"error": "", "unstable": False}
    start = time.perf_counter()
    try:
        particles = pack(
            request.shape, count=request.count, spread=request.spread, method=request.method, seed=request.seed,
            jamming=request.target == "jamming",
        )  # fmt: skip
        row["seconds"] = round(time.perf_counter() - start, 3)
        lattice = connect(particles)
        row |= _measures(lattice)
        save_particles(request.packing_file(folder), lattice, provenance=asdict(request))
    except BondemError as error:
        row |= {"error": str(error), "unstable": isinstance(error, UnstableRunError)}
        row.setdefault("seconds", round(time.perf_counter() - start, 3))
    write_text(request.row_file(folder), json.dumps(row, indent=1, allow_nan=False) + "\n")
    return row


def _measures(lattice: Lattice) -> dict[str, Any]:
    quality = fabric(lattice)
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
    share = geode().solid_angle / (4.0 * np.pi)
    chance = 2.0 * share * (1.0 - 2.0 * share) / (4.0 * bonds)
    return float(np.mean(chance + (share - 1.0 / len(share)) ** 2))
