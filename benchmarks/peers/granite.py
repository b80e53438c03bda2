"""Uniaxial compression of a granite of parallel bonds, in bondem and in LAMMPS.

    LAMMPS=lammps/bin/lmp python benchmarks/peers/granite.py [--seeds 1,2] [--out FILE]

Packings, bonds, platens and strength are those of `validation/studies/bonded_granite.py`: cylinders of 600 spheres
between platens with a friction of 0.3, and local damping of 0.7. Both codes have the same spheres, four stiffnesses
of every bond (one bond type each in LAMMPS), time step, speed, damping, and contacts of one stiffness. The criterion
is that of `bond_style bpm/rotational`, `bd.LinearSum`, with strengths of sections of the strength of the granite.
Three properties of the granite that LAMMPS lacks are changed:

- the contact point of a bond is in the middle (`Central`), not between the surfaces of its spheres;
- spheres are shrunk until none overlap (by about 6 %), as LAMMPS has no overlap without force. When a bond breaks in
  compression, its spheres approach each other before they touch;
- the criterion is a sum, in which compression strengthens, not the stress of the outermost fibre.

"variants" are runs of bondem with these changes one by one; "as calibrated" is the granite itself.

E         slope of stress over the mean strain of the middle half between a tenth and half of the smaller peak [Pa]
ucs       largest stress [Pa]; "broken" bonds at that peak
"""

import json
import math
import sys
import tempfile
import warnings
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from lammps_bpm import BREAKING, EXTRA, counts, data, ran, wall_spring

import bondem as bd
from bondem.interactions.beams.bond_law import BondGeometry, BondStiffness
from bondem.labtests.gauge_length import AffineField, middle_half
from kept import RESULTS, Record, run
from validation.studies import bonded_granite
from validation.studies.bonded_granite import FRICTION, GRANITE, PIN, criterion

#: Friction of fragments, and local damping.
RUBS, DAMPING = 0.4, 0.7


@dataclass(frozen=True, kw_only=True)
class Central(bd.ParallelBond):
    """Parallel bond with its contact point in the middle."""

    title: ClassVar[str] = "parallel, central"

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        return replace(super().stiffness(bonds), lever=0.5 * bonds.length)


class Granite:
    """Calibrated granite, with its law, density and strength, and its compression tests in both codes."""

    def __init__(self) -> None:
        self.shape = bd.Cylinder(radius=bonded_granite.RADIUS, length=bonded_granite.LENGTH)
        first = bonded_granite.packed(self.shape, PIN, 0)
        fit = bd.calibrate(first, GRANITE, law=bd.ParallelBond)
        self.law, self.density = fit.law, fit.density
        record = json.loads((RESULTS / "bonded_granite.json").read_text())
        self.strength = float(record["granite"][0]["bond_strength"])

    def shrunk(self, body: bd.Lattice) -> bd.Lattice:
        """Return the lattice with the same centres and bonds, and spheres small enough not to overlap."""
        i, j = body.pairs.T
        radius = body.particles.radius
        share = float((body.length / (radius[i] + radius[j])).min())
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the small spheres do not fill the cylinder
            spheres = bd.Particles(body.particles.position, share * radius, shape=self.shape)
        return bd.Lattice(spheres, body.pairs)

    def measure(self, seed: int) -> list[dict[str, Any]]:
        """Return E, strength and broken bonds of a packing in both codes, and of the variants in bondem."""
        whole = bonded_granite.packed(self.shape, PIN, seed)
        small, radius = self.shrunk(whole), float(whole.particles.mean_radius)
        share = float(small.particles.mean_radius) / radius
        given = {name: getattr(self.law, name) for name in ("E", "nu", "kappa")} | {"radius": radius}
        law, at_surfaces = Central(**given), bd.ParallelBond(**given)
        dense = {"density": self.density / share**3, "platen_friction": FRICTION}
        bonds = bd.Model(small, law, dense["density"]).stiffness
        kn = float(np.median(bonds.kn))
        modulus = 2.0 * kn / (np.pi * small.particles.mean_radius)
        contact = bd.LinearContact(E=modulus, friction=RUBS, stress_free=False)
        area, second = math.pi * radius**2, 0.25 * math.pi * radius**4
        force = self.strength * area
        summed = bd.LinearSum(
            force=force, shear=force, bending=self.strength * second / radius,
            twisting=2.0 * self.strength * second / radius,
        )  # fmt: skip
        test = bd.labtests.uniaxial_compression(small, law, summed, contact=contact, **dense)
        theirs = Lammps(test, small, bonds, kn, summed)
        found = theirs.run()
        both = 0.5 * min(test.peak, float(found["stress"].max()))
        row = {
            "spheres": PIN, "bonds": len(small.pairs), "shrunk": share, "steps": test.run.steps, "dt": test.run.dt,
            "version": theirs.version, "bondem": _read(test, both), "lammps": {
                "E": _slope(found["strain"], found["stress"], both), "ucs": float(found["stress"].max()),
                "broken": int(found["broken"][np.argmax(found["stress"])]),
            },
        }  # fmt: skip
        fibre = criterion(self.strength)
        variants = {
            "as calibrated": (whole, at_surfaces, fibre, None), "linear sum": (whole, at_surfaces, summed, None),
            "linear sum, central": (whole, law, summed, None),
            "linear sum, shrunk": (small, at_surfaces, summed, contact),
        }  # fmt: skip
        row["variants"] = {}
        for name, (body, bond, failure, touch) in variants.items():
            density = self.density if body is whole else dense["density"]
            one = bd.labtests.uniaxial_compression(
                body, bond, failure, contact=touch, platen_friction=FRICTION, density=density
            )
            row["variants"][name] = _read(one, 0.5 * one.peak)
        return [row]


def _slope(strain: np.ndarray, stress: np.ndarray, limit: float) -> float:
    """Return the slope of stress [Pa] over strain from a fifth of `limit` to its first exceedance."""
    end = int(np.argmax(stress > limit))
    chosen = np.arange(end)[stress[:end] > 0.2 * limit]
    return float(np.polyfit(strain[chosen], stress[chosen], 1)[0])


def _read(test: bd.labtests.StrengthTest, limit: float) -> dict[str, float]:
    """Return E and strength [Pa] of a test in bondem, bonds broken at the peak, and the unbalance of forces."""
    strain, stress = test.curve.T
    strain = -test.run.history["strain"][:, 0]
    at = test.run.history.time[int(np.argmax(stress))]
    return {
        "E": _slope(strain, stress, limit), "ucs": test.peak, "broken": int((test.run.events.time <= at).sum()),
        "unbalance": test.unbalance,
    }  # fmt: skip


class Lammps:
    """Run of a compression test of bondem in LAMMPS, with its input and results."""

    def __init__(
        self, test: bd.labtests.StrengthTest, body: bd.Lattice, bonds: BondStiffness, kn: float, failure: bd.LinearSum
    ) -> None:
        self.body, self.bonds, self.kn, self.failure, self.step = body, bonds, kn, failure, test.run.dt
        self.mass, self.walls = test.run.state.model.mass, test.run.state.model.walls
        self.every = round(float(np.diff(test.run.history.time[:2])[0]) / self.step)
        # half as many steps more than bondem, because bonds may break a little later
        self.steps = self.every * (3 * test.run.steps // (2 * self.every))
        self.version = ""

    def script(self) -> str:
        """Return the input script of LAMMPS."""
        near, far = self.walls
        ramp = far.motion.components["vx"]
        speed, begin = ramp.end, ramp.duration
        strength = " ".join(
            f"{getattr(self.failure, name):.17g}" for name in ("force", "shear", "twisting", "bending")
        )
        b = self.bonds
        coefficients = "\n".join(
            f"bond_coeff {k} {kn:.17g} {ks:.17g} {kt:.17g} {kb:.17g} {strength} 0 0 0 0"
            for k, (kn, ks, kt, kb) in enumerate(zip(b.kn, b.ks, b.kt, b.kb, strict=True), start=1)
        )

        at, wall = f"{far.point[0]:.17g}", wall_spring(2.0 * self.kn, 0.5, 0.0, FRICTION)
        return f"""{BREAKING}comm_modify vel yes cutoff {8.0 * self.body.particles.radius.max():.17g}
read_data start.data
pair_style gran/hooke/history {self.kn:.17g} {0.5 * self.kn:.17g} 0 NULL {RUBS} 1
pair_coeff * *
bond_style bpm/rotational smooth no
{coefficients}
neighbor {0.25 * self.body.particles.mean_radius:.3g} bin
neigh_modify every 1 delay 0 check yes
timestep {self.step:.17g}
variable t equal step*dt
variable b equal {begin:.17g}
variable way equal "{speed:.17g}*((v_t<v_b)*0.5*v_t*v_t/v_b+(v_t>=v_b)*(v_t-0.5*v_b))"
region far plane {at} 0 0 -1 0 0 side in units box move v_way NULL NULL
fix motion all nve/bpm/sphere
fix near all wall/gran {wall} xplane {near.point[0]:.17g} NULL contacts
fix far all wall/gran/region {wall} region far contacts
fix loss all damping/cundall {DAMPING} {DAMPING}
compute near all reduce sum f_near[2]
compute far all reduce sum f_far[2]
thermo_style custom step c_near c_far bonds
thermo_modify lost ignore lost/bond ignore format float %.17g
thermo {self.every}
dump places all custom {self.every} places id x y z
dump_modify places sort id format float %.17g
run {self.steps}
"""

    def data(self) -> str:
        """Spheres and bonds, each bond of its own type."""
        particles, wide = self.body.particles, np.full(3, 3.0 * bonded_granite.LENGTH)
        spheres = particles.position, particles.radius, self.mass / particles.volume
        kinds = np.arange(1, len(self.body.pairs) + 1)
        return data("granite", spheres, self.body.pairs, kinds, (-wide, wide), extra=EXTRA)

    def run(self) -> dict[str, np.ndarray]:
        """Run LAMMPS; return stress [Pa], strain of the middle half, and broken bonds at each record, (s,) each."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "start.data").write_text(self.data())
            log, _ = ran(folder, self.script())
            frames = (folder / "places").read_text().split("ITEM: TIMESTEP\n")[1:]
        self.version = log.splitlines()[0]
        table = counts(log, 4)
        places = np.array([
            [line.split()[1:] for line in frame.splitlines()[8:]] for frame in frames
        ], dtype=float)  # fmt: skip
        start, chosen = self.body.particles.position, middle_half(self.body)
        strain = [-AffineField.fit(start[chosen], (x - start)[chosen]).strain[0, 0] for x in places]
        force = 0.5 * (table[:, 1] - table[:, 2])
        return {
            "stress": force / self.body.particles.envelope.section(), "strain": np.array(strain),
            "broken": len(self.body.pairs) - table[:, 3],
        }  # fmt: skip


def measure(record: Record, *, seeds: tuple[int, ...] = (1, 2)) -> None:
    granite = Granite()
    for seed in seeds:
        record.add(lambda seed=seed: granite.measure(seed), "compression", seed=seed)
    for row in record.rows("compression"):
        print(row)


if __name__ == "__main__":
    run("granite_peers")
