"""Agglomerates of bonded spheres that break as they fall on a floor, in bondem and in LAMMPS.

    LAMMPS=lammps/bin/lmp python benchmarks/peers/agglomerates.py [--bodies 50] [--each 200] [--repeat 3]

Balls of 10 mm of bonded spheres, in random orientations and stacked without contact, move down at a speed and hit a
floor. Both codes have the same spheres, the same four stiffnesses of all bonds, and `LinearSum` (the sum of
`bond_style bpm/rotational`) with the same strengths. Contact has one stiffness and friction. Gravity and time step,
that of bondem, are also the same. The codes run in turns on one thread each. Spheres of a broken bond touch. Times
are processor seconds of the loop alone.

best      time of a run, LAMMPS over bondem, of the fastest runs; "median" of all
memory    largest resident size of the process [MiB]
broken    share of the bonds at the end
"""

import math
import os
import re
import resource
import statistics
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from time import process_time
from typing import Any, ClassVar

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from lammps_bpm import BREAKING, EXTRA, counts, data, ran, wall_spring

import bondem as bd
from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness
from kept import Record, alone, run

#: Radius of a ball [m], density [kg/m³], E [Pa], ν of bonds, and their radius over the mean radius of spheres.
RADIUS, DENSITY, E, NU, SHARE = 5e-3, 2500.0, 1e9, 0.2, 0.6
#: Strength over E: tension of the section of a bond, twice that in shear, bending and twisting [-].
STRENGTH = 8e-3
FRICTION, GRAVITY = 0.5, 9.81
#: Duration of motion before and after the first contact, over RADIUS / speed.
AHEAD, AFTER = 0.2, 4.0
#: Distance of the centres of stacked bodies [m], and speeds of falls [m/s].
APART, SPEEDS = 2.3 * RADIUS, (5.0, 7.0, 10.0)


@dataclass(frozen=True, kw_only=True)
class Alike(BondLaw):
    """Bonds with the same four stiffnesses at any length, as in `bond_style bpm/rotational` of LAMMPS.

    Attributes:
        kn, ks: normal and shear stiffness [N/m].
        kb, kt: bending and twisting stiffness [N·m].
    """

    title: ClassVar[str] = "alike"
    moments_at_contact: ClassVar[bool] = True

    kn: float
    ks: float
    kb: float
    kt: float

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        names = ("kn", "ks", "kb", "kt", "radius")
        values = {name: np.full_like(bonds.length, getattr(self, name)) for name in names}
        return BondStiffness(lever=0.5 * bonds.length, **values)


def agglomerate(each: int) -> bd.Lattice:
    """Return a ball of `each` bonded spheres that do not overlap."""
    packed = bd.pack(bd.Ball(radius=RADIUS), count=each, seed=1)
    bonds = bd.connect(packed, tolerance=0.01)
    # no overlaps, because LAMMPS has none without force: spheres of broken bonds would push each other apart
    i, j = bonds.pairs.T
    shrunk = min(1.0, float((bonds.length / (packed.radius[i] + packed.radius[j])).min()))
    return bd.Lattice(bd.Particles(packed.position, shrunk * packed.radius), bonds.pairs)


def stacked(rock: bd.Lattice, bodies: int) -> bd.Lattice:
    """Return bodies stacked as a cube, with the lowest sphere at z = 0."""
    side = math.ceil(bodies ** (1.0 / 3.0))
    k = np.arange(bodies)
    places = APART * np.column_stack([k % side, k // side % side, k // side**2])
    all_of = bd.replicate(rock, places, rotations="random", seed=1)
    lowest = float((all_of.particles.position[:, 2] - all_of.particles.radius).min())
    return all_of.moved((0.0, 0.0, -lowest))


def stiffness(rock: bd.Lattice) -> dict[str, float]:
    """Return stiffnesses of an Euler–Bernoulli beam of the mean bond length, and its strengths for `LinearSum`."""
    r, length = SHARE * rock.particles.mean_radius, float(rock.length.mean())
    area, second = np.pi * r**2, 0.25 * np.pi * r**4
    tension = STRENGTH * E
    return {
        "kn": E * area / length, "ks": 12.0 * E * second / length**3, "kb": E * second / length,
        "kt": E / (1.0 + NU) * second / length, "radius": r, "force": tension * area, "shear": 2.0 * tension * area,
        "bending": 2.0 * tension * second / r, "twisting": 2.0 * tension * second / r,
    }  # fmt: skip


def model_of(bodies: int, each: int, speed: float) -> tuple[bd.Model, bd.State, dict[str, float]]:
    """Return model and initial state of a fall at a speed [m/s], and the `stiffness` of its bonds."""
    rock = agglomerate(each)
    bond, radius = stiffness(rock), rock.particles.mean_radius
    law = Alike(E=E, nu=NU, **{name: bond[name] for name in ("kn", "ks", "kb", "kt", "radius")})
    failure = bd.LinearSum(**{name: bond[name] for name in ("force", "shear", "bending", "twisting")})
    # kn = E π R² / 2R of two mean spheres
    contact = bd.LinearContact(
        E=2.0 * bond["kn"] / (np.pi * radius), kappa=3.5, friction=FRICTION, stress_free=False
    )
    model = bd.Model(
        stacked(rock, bodies), law, DENSITY, contact=contact, failure=failure, boundary=[bd.Gravity(GRAVITY)],
        walls=[bd.PlaneWall((0, 0, -AHEAD * RADIUS), (0, 0, 1))],
    )  # fmt: skip
    state = model.state()
    state.velocity = (0.0, 0.0, -speed)
    return model, state, bond


def bondem(bodies: int, each: int, speed: float) -> dict[str, Any]:
    """Run a fall in bondem until `AFTER` the first contact."""
    model, state, _ = model_of(bodies, each, speed)
    began = process_time()
    run = bd.solve_explicit(model, duration=(AHEAD + AFTER) * RADIUS / speed, state=state, every=200)
    return {
        "seconds": process_time() - began, "steps": run.steps, "dt": run.dt, "bonds": len(model.lattice.pairs),
        "elements": len(model.mass), "broken": len(run.events) / len(model.lattice.pairs),
        "imbalance": run.history.imbalance,
        "memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0,
    }  # fmt: skip


def script(model: bd.Model, bond: dict[str, float], steps: int, dt: float) -> str:
    """Return the input script of LAMMPS for a fall."""
    order = "kn", "ks", "kt", "kb", "force", "shear", "bending", "twisting"
    values = " ".join(f"{bond[name]:.17g}" for name in order)
    # without any damping, sliding at a wall divides by zero there
    kn, soft, rate = bond["kn"], 2.0 / 7.0, 1e-3
    pair = f"{kn:.17g} {soft * kn:.17g} {rate:.17g} {math.sqrt(soft) * rate:.17g} {FRICTION} 1 limit_damping"
    # a sphere at a wall has half the length of two, kn = E π R² / R
    wall = wall_spring(2.0 * kn, soft, rate, FRICTION)
    return f"""{BREAKING}comm_modify vel yes cutoff {0.8 * RADIUS:.17g}
read_data start.data
pair_style gran/hooke/history {pair}
pair_coeff * *
bond_style bpm/rotational smooth no
bond_coeff 1 {values} 0 0 0 0
neighbor {0.25 * model.lattice.particles.mean_radius:.3g} bin
neigh_modify every 1 delay 0 check yes
fix motion all nve/bpm/sphere
fix weight all gravity {GRAVITY} vector 0.0 0.0 -1.0
fix floor all wall/gran {wall} zplane {-AHEAD * RADIUS:.17g} NULL
timestep {dt:.17g}
thermo_style custom step bonds
thermo {steps}
thermo_modify lost ignore lost/bond ignore
run {steps}
"""


def start_of(model: bd.Model, state: bd.State) -> str:
    """Spheres, velocities and bonds as a data file."""
    particles, pairs = model.lattice.particles, model.lattice.pairs
    box = particles.position.min(axis=0) - 3.0 * RADIUS, particles.position.max(axis=0) + 3.0 * RADIUS
    spheres = particles.position, particles.radius, np.full(len(particles), DENSITY)
    return data("agglomerates", spheres, pairs, np.ones(len(pairs), int), box, extra=EXTRA, velocity=state.velocity)


def lammps(fall: tuple[int, int, float], steps: int, dt: float) -> dict[str, Any]:
    """Run a fall in LAMMPS; return its seconds, version, share of broken bonds and memory [MiB]."""
    model, state, bond = model_of(*fall)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "start.data").write_text(start_of(model, state))
        log, memory = ran(Path(folder), script(model, bond, steps, dt))
    wall, share = re.findall(r"Loop time of (\S+) on", log)[-1], re.findall(r"(\S+)% CPU use", log)[-1]
    return {
        "seconds": float(wall) * float(share) / 100.0, "steps": steps,
        "version": log.splitlines()[0], "broken": 1.0 - counts(log, 2)[-1, 1] / len(model.lattice.pairs),
        "memory": memory,
    }  # fmt: skip


def in_turns(fall: tuple[int, int, float], repeat: int) -> dict[str, Any]:
    """Run both codes in turns; return all results, the loads of the machine, and the ratios of times."""
    loads, ours, theirs = [], [], []
    for _ in range(repeat):
        loads.append(os.getloadavg()[0])
        ours.append(alone(bondem, *fall, BONDEM_NUM_THREADS="1"))
        theirs.append(lammps(fall, ours[0]["steps"], ours[0]["dt"]))
    row = {"speed": fall[-1], "loads": loads, "bondem": ours, "lammps": theirs}
    for name, one in (("best", min), ("median", statistics.median)):
        row[name] = one([x["seconds"] for x in theirs]) / one([x["seconds"] for x in ours])
    print(f"{fall[-1]:4.1f} m/s: LAMMPS over bondem {row['best']:.1f}, {row['median']:.1f};", ours[0], theirs[0])
    return row


def measure(record: Record, *, bodies: int = 50, each: int = 200, repeat: int = 3) -> None:
    """Measure falls.

    Args:
        bodies: how many fall.
        each: spheres of a body.
        repeat: runs of each code, of falls at 7 m/s.
    """
    falls: list[dict[str, Any]] = []
    for speed in SPEEDS:
        falls.append(in_turns((bodies, each, speed), repeat if speed == SPEEDS[1] else 1))
        record.keep(threads=1, falls=falls, bodies=bodies, each=each)


if __name__ == "__main__":
    run()
