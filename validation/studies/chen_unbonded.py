"""Chen et al. (2022): the cantilevers of parallel bonds with PFC's unbonded component beside the bond."""

from dataclasses import dataclass
from itertools import product
from typing import ClassVar

import numpy as np

import bondem as bd
from bondem._threads import threads
from bondem.interactions.beams.bond_law import BondGeometry, BondStiffness
from validation.frame.record import Record
from validation.measures.chen_one_sided import run_to_rest
from validation.measures.chen_specimens import CASES, FORCE, NU, RHO, E, bond, cantilever, exact

KAPPA = 2.0 * (1.0 + NU)
#: μ is of no consequence where the contact is open. Under the push it has to stick while the load makes the beam
#: vibrate: with μ = 0.5 one of the fifteen cases, 4 with five bonds, slips on the way and ends 2e-4 off.
CONTACT = bd.LinearContact(E=E, kappa=KAPPA, friction=1.0)
#: Surfaces closer than this share of the radius touch.
TOUCHING = 1e-9
LOAD, PUSH, GAMMA = 1e3, 5e3, 0.5


@dataclass(frozen=True, kw_only=True)
class Pressed(bd.ParallelBond):
    """Parallel bond and the linear contact of PFC beside it, pressed together and sticking.

        kn + k    ks + k / κ*    kb, kt and the contact point as they are

    with k = E* π min(Ri, Rj)² / (Ri + Rj) where the spheres touch, and 0 where they do not.

    Attributes:
        contact: of which E* is the modulus and κ* the ratio of stiffnesses.
    """

    title: ClassVar[str] = "parallel, in contact"

    contact: bd.LinearContact

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        bonded = super().stiffness(bonds)
        k = unbonded(bonds.length, bonds.radius_i, bonds.radius_j, self.contact)
        return BondStiffness(
            kn=bonded.kn + k, ks=bonded.ks + k / self.contact.kappa, kb=bonded.kb, kt=bonded.kt, lever=bonded.lever,
            radius=bonded.radius,
        )  # fmt: skip


def unbonded(length: np.ndarray, Ri: np.ndarray, Rj: np.ndarray, contact: bd.LinearContact) -> np.ndarray:
    """Normal stiffness of the linear contact of each pair [N/m], (m,)."""
    least = np.minimum(Ri, Rj)
    touching = length - Ri - Rj <= TOUCHING * least
    return np.where(touching, contact.E * np.pi * least**2 / (Ri + Rj), 0.0)


def beside(lattice: bd.Lattice) -> np.ndarray:
    """k of each bond [N/m], (m,)."""
    R = lattice.particles.radius
    i, j = lattice.pairs.T
    return unbonded(lattice.length, R[i], R[j], CONTACT)


def pressed(radius: float, kappa: float | None) -> Pressed:
    return Pressed(E=E, nu=NU, radius=radius, kappa=kappa, contact=CONTACT)


def static_cases() -> list[dict]:
    """Every case of Table 3 at 100 kN: tips of the bond alone and with the component sticking."""
    rows = []
    for case, variants in CASES.items():
        for parameter, (lattice, r, kappa) in variants.items():
            k = beside(lattice)
            laws = {"bonded": bond("PBM", r, kappa), "pressed": pressed(r, kappa)}
            tips = {
                name: float(bd.solve_static(cantilever(lattice, law, FORCE)).displacement[-1, 1])
                for name, law in laws.items()
            }
            theory = {
                "bonded": float(exact("PBM", lattice, r, kappa)[-1]),
                "pressed": float(exact("PBM", lattice, r, kappa, more=k / KAPPA)[-1]),
            }
            stiffness = {name: bd.Model(lattice, law, 1000.0).stiffness for name, law in laws.items()}
            rows.append(
                {"case": case, "parameter": parameter, "touching": int((k > 0.0).sum()), "bonds": len(k),
                 "tip": tips, "exact": theory,
                 "shear": {name: float(found.ks[0]) for name, found in stiffness.items()}}
            )  # fmt: skip
    return rows


def dynamic_cases() -> list[dict]:
    """The cases whose spheres touch, at 1 kN: bond alone, with the one-sided component, and both after a push."""
    rows = []
    for case in ("1", "2", "4"):
        for parameter, (lattice, r, kappa) in CASES[case].items():
            if case == "2" and parameter == 10:  # case 1 again, as case 3 of ten bonds is
                continue
            rows += _runs(case, parameter, lattice, r, kappa, gamma=GAMMA, ramp=0.1)
    lattice, r, kappa = CASES["1"][10]
    return rows + _runs("1", 10, lattice, r, kappa, gamma=0.001, ramp=1.0, pushes=(0.0,))


def _runs(
    case: str, parameter: float, lattice: bd.Lattice, r: float, kappa: float | None, *, gamma: float, ramp: float,
    pushes: tuple[float, ...] = (0.0, PUSH),
) -> list[dict]:  # fmt: skip
    law = bond("PBM", r, kappa)
    static = {
        name: bd.solve_static(cantilever(lattice, one, LOAD)).displacement[:, 1]
        for name, one in (("bonded", law), ("pressed", pressed(r, kappa)))
    }
    # the load across has the part F sin θ along a bond
    opened = LOAD * np.diff(static["bonded"]) / lattice.length / bd.Model(lattice, law, RHO).stiffness.kn
    rows = []
    for (name, contact), push in product((("bonded", None), ("one-sided", CONTACT)), pushes):
        found = run_to_rest(lattice, law, load=LOAD, push=push, contact=contact, gamma=gamma, ramp=ramp)
        rows.append(
            {"case": case, "parameter": parameter, "component": name, "push": push, "gamma": gamma,
             "static": {which: float(y[-1]) for which, y in static.items()}, "status": found.status,
             "tip": float(found.displacement[-1, 1]), "closed_at_rest": int((found.gap < 0.0).sum()),
             "gap_error": None if push else float(np.abs(found.gap / opened - 1.0).max())}
        )  # fmt: skip
    return rows


def measure(record: Record) -> None:
    """Measure static tips and explicit runs."""
    with threads(1):
        record.keep(load=LOAD, push=PUSH, friction=CONTACT.friction, gamma=GAMMA, static=static_cases(),
                    explicit=dynamic_cases())  # fmt: skip
