"""Rows of the surface study: specimens of many shapes, and what each gives with a bond law beside its estimate."""

import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.calibration.affine import affine_estimate, is_bar
from bondem.interactions.law_catalogue import PARAMETERS
from bondem.labtests.gauge_length import AffineField, middle_half
from bondem.packing.sizes import SPREAD
from validation.frame.request import Request
from validation.rows.packings import Packed, shared_lattice

#: Where a packing ends: 6.2 or 7 contacts a sphere over all spheres, the onset of jamming, or cut from a periodic
#: packing with 6.2 contacts a sphere.
TARGETS = ("contacts", "dense", "jamming", "carved")

# Of what a body is cut from, over the box around the body.
_MARGIN = 1.15


def _bracket() -> bd.Surface:
    """An L, 24 x 24 mm with limbs 8 mm thick, 10 mm deep along y: its surface."""
    a, t, depth = 24e-3, 8e-3, 10e-3
    outline = np.array([[0, 0], [a, 0], [a, t], [t, t], [t, a], [0, a]])
    front = np.column_stack([outline[:, 0], np.zeros(6), outline[:, 1]])
    k = np.arange(6)
    after = (k + 1) % 6
    # seen along +y the outline runs clockwise, so that the front face looks towards -y
    cap = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])
    walls = np.concatenate([np.stack([k, 6 + after, after], axis=1), np.stack([k, 6 + k, 6 + after], axis=1)])
    triangles = np.concatenate([cap, cap[:, ::-1] + 6, walls])
    return bd.Surface(vertices=np.concatenate([front, front + np.array([0.0, depth, 0.0])]), triangles=triangles)


#: What is packed: lengths only count against the radii [m].
FORMS: dict[str, bd.Shape] = {
    "cell": bd.Cell((10e-3, 10e-3, 10e-3)),
    "cube": bd.Box((10e-3, 10e-3, 10e-3)),
    "beam": bd.Box((40e-3, 5e-3, 5e-3)),
    "plate": bd.Box((40e-3, 20e-3, 3e-3)),
    "cylinder": bd.Cylinder(radius=5e-3, length=40e-3),
    "ball": bd.Ball(radius=5e-3),
    "bracket": _bracket(),
}


@dataclass(frozen=True)
class SpecimenRequest(Packed):
    """One specimen.

    Attributes:
        form: one of `FORMS`.
        count: elements; of a body that is cut out, about as many.
        target: one of `TARGETS`.
        seed: which of the random packings.
        spread: κ [-].
    """

    form: str
    count: int
    target: str
    seed: int
    spread: float = SPREAD

    def measured(self, folder: Path) -> dict[str, Any]:
        """Pack, bond, cut out where asked, and keep."""
        lattice = self._cut() if self.target == "carved" else bd.connect(self._packed(FORMS[self.form], self.count))
        bd.save_particles(self.packing_file(folder), lattice, provenance=asdict(self))
        return {"elements": len(lattice.particles), "bonds": len(lattice.pairs), "rattlers": lattice.rattlers}

    def _packed(self, shape: bd.Shape, count: int) -> bd.Particles:
        return bd.pack(
            shape, count=count, spread=self.spread, seed=self.seed, jamming=self.target == "jamming",
            coordination_number=7.0 if self.target == "dense" else None,
        )  # fmt: skip

    def _cut(self) -> bd.Lattice:
        shape = FORMS[self.form]
        lower, upper = shape.bounds
        a, b, c = map(float, _MARGIN * (upper - lower))
        around = bd.Cell((a, b, c))
        whole = self._packed(around, math.ceil(self.count * around.volume / shape.volume))
        # into the middle of the packing
        shift = 0.5 * (np.array([a, b, c]) - lower - upper)
        return bd.carve(bd.connect(whole), shape.moved(shift.tolist()))


@dataclass(frozen=True)
class ModuliRequest(Request):
    """A specimen with a law.

    Attributes:
        specimen: made before.
        law: its bonds.
        test: "tension", which is bulk moduli of a periodic cell; "plates", pulled by smooth rigid plates; or
            "stress", uniform stress on the whole surface.
    """

    specimen: SpecimenRequest
    law: bd.BondLaw
    test: str = "tension"

    @property
    def weight(self) -> float:
        return float(self.specimen.count) * (6.0 if self.specimen.form == "cell" or self.test == "stress" else 1.0)

    @property
    def needs(self) -> SpecimenRequest:
        return self.specimen

    @property
    def asked(self) -> dict[str, Any]:
        law = asdict(self.law)
        named = {name: law.get(name) for name in PARAMETERS}
        return asdict(self.specimen) | {"law": type(self.law).__name__, "test": self.test} | named

    def measured(self, folder: Path) -> dict[str, Any]:
        """Solve and estimate.

        Returns:
            E over E_μ and ν as measured and of the affine field, what else goes into the model, and of the bonds
            their mean length over R̄, its standard deviation, and their number in a volume R̄³.
        """
        lattice = shared_lattice(self.specimen, folder)
        bar = self.test != "stress" and is_bar(lattice)
        estimate = affine_estimate(lattice, self.law, bar=bar)
        E, nu = _moduli(lattice, self.law, self.test)
        particles, shape = lattice.particles, lattice.particles.envelope
        length = lattice.length / particles.mean_radius
        found = {
            "elements": len(particles),
            "bond_length": length.mean(),
            "bond_length_std": length.std(),
            "bond_number": len(length) * particles.mean_radius**3 / shape.volume,
            "surface_ratio": particles.mean_radius * shape.area / shape.volume,
            "wall": estimate.wall,
            "coordination_number": lattice.coordination_number,
            "coordination": estimate.coordination,
            "looseness": estimate.looseness,
            "shear": estimate.shear,
            "bending": estimate.bending,
            "E_affine": estimate.E / self.law.E,
            "nu_affine": estimate.nu,
            "E": E / self.law.E,
            "nu": nu,
        }
        return {name: value if isinstance(value, int) else float(value) for name, value in found.items()}


def _moduli(lattice: bd.Lattice, law: bd.BondLaw, test: str) -> tuple[float, float]:
    if lattice.particles.period is not None:
        found = bd.bulk_moduli(lattice, law)
        return found.E, found.nu
    if test == "stress":
        whole = bd.labtests.uniform_stress(lattice, law)
        return whole.E, whole.nu
    if test == "plates":
        return _between_plates(lattice, law)
    pulled = bd.labtests.static_tension(lattice, law)
    return pulled.E, pulled.nu


def _between_plates(lattice: bd.Lattice, law: bd.BondLaw) -> tuple[float, float]:
    """E and ν in the gauge of `static_tension`, the ends moved apart by smooth rigid plates instead of loaded."""
    shape = lattice.particles.envelope
    held = bd.Fix(bd.Face("x_min"), translation="x", rotation="")
    pulled = bd.solve_static(
        bd.Model(lattice, law, 1.0, boundary=[bd.Drive(bd.Face("x_max"), x=1e-3 * shape.extent), held])
    )
    force = -float(pulled.reaction[held.region.select(lattice), 0].sum())
    chosen = middle_half(lattice)
    strain = np.diag(AffineField.fit(lattice.particles.position[chosen], pulled.displacement[chosen]).strain)
    return force / shape.section() / float(strain[0]), -0.5 * float(strain[1] + strain[2]) / float(strain[0])
