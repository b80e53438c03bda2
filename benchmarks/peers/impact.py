"""Impact of a ball on a bonded plate, the published example of bonded particles of LAMMPS, in LAMMPS and bondem.

    LAMMPS=lammps/bin/lmp python benchmarks/peers/impact.py [--figures docs/figures]

The example is `examples/bpm/impact` of LAMMPS, `bond_style bpm/rotational`, in its own units: a disc of radius 20 and
a ball of radius 6 of spheres of diameter 1 on a disturbed fcc lattice, bonded within reach 1.5, the ball four times
as strong, speed 0.05. LAMMPS makes the specimen, and bondem takes centres and bonds from it, to the last bit.
bondem has the same four stiffnesses for all bonds, `LinearSum` with the same strengths, `BondDamping(beta=0.1)`
and `LinearContact` from the surface of the spheres, with the same kn, ks, friction and (nearly) dashpots.

One run of bondem is compared with three of LAMMPS: as published, where a bond softens by 1 - (index)^4 before it
breaks; without softening (`smooth no`); and without softening and with the rolling and twisting dashpots of bondem.
The result has the bonds lost over time, for several disturbances of the lattice. The dashpots are those of the input
of 2026. The published logs have a shear dashpot ten times as strong; the result contains them as `log`.
"""

import dataclasses
import re
import sys
import tempfile
from pathlib import Path
from time import perf_counter

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from alike import Alike
from lammps_bpm import ran

import bondem as bd
from bondem.report.style import BLUE, GREY, INK, ORANGE, sheet
from kept import Record, run

SEEDS = (134598738, 1)  # the first is that of the example
DT, STEPS, EVERY = 0.05, 2500, 100
KN, KS, KB, KT = 1.0, 0.2, 0.02, 0.02
STRENGTH = {"force": 0.05, "shear": 0.01, "bending": 0.01, "twisting": 0.01}  # of the plate
STRONGER = 4.0  # the ball
SPEED = 0.05
# Unbroken bonds per element in LAMMPS' own log of September 2026, every 500 steps, with a shear dashpot of 0.2.
LOG = (10.8703, 10.8703, 10.734844, 10.567008, 10.471128, 10.373448)
VARIANTS = {
    "published": {"smooth": "yes", "roll": 0.002, "twist": 0.002},
    "sharp": {"smooth": "no", "roll": 0.002, "twist": 0.002},
    # rolling dashpots act with half the length of a bond there, twisting ones by half
    "matched": {"smooth": "no", "roll": 0.0036, "twist": 0.004},
}  # fmt: skip


@dataclasses.dataclass(frozen=True, kw_only=True)
class TwoBodies(bd.LinearSum):
    """Linear sum with one strength factor per bond, for a plate and a stronger ball.

    Attributes:
        stronger: strength of each bond over that of the criterion [-], (m,).
    """

    stronger: np.ndarray = dataclasses.field(default_factory=lambda: np.ones(0))

    def factors(self, *_: object) -> np.ndarray:
        return self.stronger


LOOKS = {
    "published": (GREY, "LAMMPS as published: bonds soften before they break"),
    "matched": (ORANGE, "LAMMPS, brittle, dashpots as in bondem"),
    "bondem": (BLUE, "bondem"),
}

COMMON = """units lj
boundary f f f
atom_style bpm/sphere
newton on off
comm_modify vel yes cutoff 2.6
"""


class Crowded(bd.Particles):
    """Spheres that may overlap by more than half a radius, as bonded ones of the example do."""

    def _check_overlap(self) -> None:
        pass


def making(seed: int) -> str:
    """Return the input of LAMMPS that makes the specimen of the example and writes it to a data file.

    Bonds are made under a bond style without forces.
    """
    return f"""{COMMON}special_bonds lj 0.0 1.0 1.0 coul 0.0 1.0 1.0
lattice fcc 1.0
region box block -25 15 -22 22 -22 22
create_box 1 box bond/types 2 extra/bond/per/atom 20 extra/special/per/atom 50
region disk cylinder x 0.0 0.0 20.0 -0.5 0.5
create_atoms 1 region disk
group plate region disk
region ball sphere 8.0 0.0 0.0 6.0
create_atoms 1 region ball
group projectile region ball
displace_atoms all random 0.1 0.1 0.1 {seed}
neighbor 1.0 bin
pair_style zero 1.0
pair_coeff * *
bond_style zero
bond_coeff *
create_bonds many plate plate 1 0.0 1.5
create_bonds many projectile projectile 2 0.0 1.5
velocity projectile set -{SPEED} 0.0 0.0
write_data start.data nocoeff
"""


def hitting(smooth: str, roll: float, twist: float) -> str:
    """Return the input of LAMMPS that reads the specimen and runs the impact, for the release of July 2025."""
    strengths = [" ".join(f"{s * value:.17g}" for value in STRENGTH.values()) for s in (1.0, STRONGER)]
    coefficients = "\n".join(
        f"bond_coeff {n} {KN} {KS} {KT} {KB} {strength} 0.1 0.02 {roll} {twist}"
        for n, strength in enumerate(strengths, start=1)
    )
    return f"""{COMMON}special_bonds lj 0.0 1.0 1.0 coul 1.0 1.0 1.0
read_data start.data extra/special/per/atom 50
pair_style gran/hooke/history 1.0 NULL 0.5 NULL 0.1 1
bond_style bpm/rotational store/local lost {EVERY} time id1 id2 smooth {smooth}
pair_coeff 1 1
{coefficients}
fix 1 all nve/bpm/sphere
neighbor 0.3 bin
timestep {DT}
thermo_style custom step bonds ke
thermo {EVERY}
thermo_modify lost ignore lost/bond ignore
dump 2 all local {EVERY} broken.dump f_lost[1] f_lost[2] f_lost[3]
dump_modify 2 header no
run {STEPS}
"""


@dataclasses.dataclass(frozen=True)
class Specimen:
    """Specimen of LAMMPS: centres and velocities, (n, 3), pairs (m, 2), and body of each bond, 1 or 2, (m,)."""

    position: np.ndarray
    velocity: np.ndarray
    pairs: np.ndarray
    kind: np.ndarray

    @classmethod
    def read(cls, path: Path) -> "Specimen":
        """Return the specimen of a data file of LAMMPS."""
        text = path.read_text()

        def table(name: str) -> np.ndarray:
            rows = re.search(rf"^{name}.*?\n\n(.*?)(?:\n\n|\Z)", text, re.S | re.M)
            found = np.array([row.split() for row in rows.group(1).strip().splitlines()], dtype=float)
            return found[np.argsort(found[:, 0])]

        atoms, bonds = table("Atoms"), table("Bonds")
        assert (atoms[:, 0] == np.arange(1, len(atoms) + 1)).all()
        return cls(atoms[:, 5:8], table("Velocities")[:, 1:4], bonds[:, 2:].astype(int) - 1, bonds[:, 1].astype(int))


def lammps(seed: int, variant: str, folder: Path) -> dict:
    """Run a variant in LAMMPS; return lost bonds at each record, broken pairs, loop seconds and version."""
    ran(folder, making(seed))
    log, _ = ran(folder, hitting(**VARIANTS[variant]))
    broken = np.loadtxt(folder / "broken.dump", ndmin=2)
    when = np.sort(broken[:, 0])
    loop = float(re.findall(r"Loop time of (\S+) on", log)[-1])
    return {
        "lost": np.searchsorted(when, np.arange(0, STEPS + 1, EVERY), side="right").tolist(),
        "pairs": np.sort(broken[:, 1:].astype(int) - 1, axis=1),
        "loop": loop, "version": log.splitlines()[0].strip(),
    }  # fmt: skip


def bondem(specimen: Specimen) -> dict:
    """Run the impact in bondem; return lost bonds by record, broken pairs, and the energy error."""
    particles = Crowded(specimen.position, 0.5)
    label = np.zeros(len(specimen.position), dtype=int)
    label[np.unique(specimen.pairs[specimen.kind == 2])] = 1
    lattice = bd.Lattice(particles, specimen.pairs, bodies=bd.Bodies(label, ("plate", "ball"), (None, None)))
    mass = np.pi / 6.0
    # kn = E π R² / 2R = 1; ks = 2/7; the dashpot is γ m̄ u' with γ = 0.5
    contact = bd.LinearContact(
        E=4.0 / np.pi * KN, kappa=3.5, friction=0.1, damping=0.25 * np.sqrt(0.5 * mass / KN), stress_free=False
    )
    failure = TwoBodies(**STRENGTH, stronger=np.where(specimen.kind == 2, STRONGER, 1.0))
    law = Alike(E=1.0, nu=0.0, radius=0.5, kn=KN, ks=KS, kb=KB, kt=KT)
    model = bd.Model(lattice, law, density=1.0, contact=contact, failure=failure)
    state = model.state()
    state.set_motion(velocity=specimen.velocity)
    began = perf_counter()
    run = bd.solve_explicit(
        model, duration=STEPS * DT, dt=DT, every=EVERY, damping=bd.BondDamping(beta=0.1), state=state
    )  # fmt: skip
    wall = perf_counter() - began
    energy = run.history.energy
    lost = np.searchsorted(run.events.step, np.arange(0, STEPS + 1, EVERY), side="right")
    return {
        "lost": lost.tolist(), "pairs": np.sort(specimen.pairs[run.events.bond], axis=1), "wall": wall,
        "missed": float(np.abs(energy["balance"]).max() / energy["translation"][0]), "message": run.message,
    }  # fmt: skip


def shared(one: np.ndarray, other: np.ndarray) -> float:
    """Return the share of the pairs broken in either run that broke in both [-]."""
    first, second = ({tuple(pair) for pair in pairs.tolist()} for pairs in (one, other))
    return len(first & second) / max(len(first | second), 1)


def measure(record: Record, *, seeds: tuple[int, ...] = SEEDS) -> None:
    runs: list[dict] = []
    for seed in seeds:
        found = {}
        for variant in VARIANTS if seed == seeds[0] else ("published", "matched"):
            with tempfile.TemporaryDirectory() as folder:
                found[variant] = lammps(seed, variant, Path(folder))
                specimen = Specimen.read(Path(folder) / "start.data")
            print(seed, variant, found[variant]["lost"][::5], f"{found[variant]['loop']:.1f} s", flush=True)
        found["bondem"] = bondem(specimen)
        ours = found["bondem"]
        print(seed, "bondem", ours["lost"][::5], f"{ours['wall']:.1f} s", f"{ours['missed']:.1e}", flush=True)
        common = {name: shared(ours["pairs"], run["pairs"]) for name, run in found.items() if name != "bondem"}
        common["published in matched"] = shared(found["published"]["pairs"], found["matched"]["pairs"])
        version = found["published"].pop("version")
        for one in found.values():
            one.pop("pairs")
            one.pop("version", None)
        runs.append({
            "seed": seed, "elements": len(specimen.position), "bonds": len(specimen.pairs), "broken in both": common,
            **found,
        })  # fmt: skip
        record.keep(dt=DT, steps=STEPS, every=EVERY, log=LOG, runs=runs, lammps=version)


def draw(record: Record, folder: Path) -> None:
    """Bonds lost over time."""
    kept = record.data
    steps = np.arange(0, kept["steps"] + 1, kept["every"])
    with sheet(folder / "impact.png", 6.3, 3.6) as (_, ax):
        for name, (colour, label) in LOOKS.items():
            for k, one in enumerate(kept["runs"]):
                lost = 100.0 * np.array(one[name]["lost"]) / one["bonds"]
                ax.plot(steps, lost, color=colour, ls="--" if k else "-", label="" if k else label)
        every = kept["steps"] // (len(kept["log"]) - 1)
        logged = 100.0 * (1.0 - np.array(kept["log"]) / kept["log"][0])
        ax.plot(steps[:: every // kept["every"]], logged, "+", color=INK, label="log of LAMMPS, other dashpots")
        ax.set(xlabel="step (of 0.05)", ylabel="bonds lost [%]")
        ax.legend(loc="upper left")


if __name__ == "__main__":
    run()
