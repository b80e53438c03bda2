"""Agglomerates of bonded spheres that break as they fall on a floor or tumble in a drum, in bondem and in LAMMPS.

    LAMMPS=lammps/bin/lmp python benchmarks/peers/agglomerates.py [--bodies 50] [--each 200] [--repeat 3]
    LAMMPS=lammps/bin/lmp python benchmarks/peers/agglomerates.py --scene drum [--bodies 1000] [--each 60]
    python benchmarks/peers/agglomerates.py --scene drum --bodies 40 --turns 2

Balls of 10 mm of bonded spheres, in random orientations and stacked without contact, move down at a speed. They hit a
floor, or the shell of a drum that rotates between two smooth ends. Both codes have the same spheres, the same four
stiffnesses of all bonds, and `LinearSum` (the sum of `bond_style bpm/rotational`) with the same strengths. Contact
has one stiffness, share of critical damping and friction. Gravity and time step, that of bondem, are also the same.
The codes run in turns on one thread each. Spheres of a broken bond touch. Times are processor seconds of the loop
alone.

best      time of a run, LAMMPS over bondem, of the fastest runs; "median" of all
memory    largest resident size of the process [MiB]
broken    share of the bonds at the end
impulse   momentum that the floor and gravity gave, over what the bodies gained: 1 [-]; of bondem, without friction
sideways  momentum along the floor over that of the fall, where nothing rubs on it [-]; of bondem
balance   angular momentum of a charge about the axis of its drum: what it gained, over what weight and drum gave [-]
torque    mean torque of the drum, its work over its angle, over M g x̄ in the last turn [-]; "lever" is x̄ [m]
"""

import math
import os
import re
import resource
import statistics
import sys
import tempfile
from dataclasses import asdict, replace
from pathlib import Path
from time import process_time
from typing import Annotated, Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from agglomerate_scenes import DENSITY, FRICTION, GRAVITY, RADIUS, Drum, Fall, Scene, model_of
from lammps_bpm import BREAKING, EXTRA, counts, data, ran

import bondem as bd
from kept import Record, alone, run, variant

#: Speeds of falls [m/s].
SPEEDS = (5.0, 7.0, 10.0)


def bondem(scene: Scene, *, rubs: bool, every: int) -> dict[str, Any]:
    """Run a scene in bondem; return its measures, with balances for a drum or without friction.

    `every` is the number of steps between records: few for a balance, many for a run that is timed.
    """
    model, state, _ = model_of(scene, rubs=rubs)
    start = state.copy()
    began = process_time()
    run = bd.solve_explicit(model, duration=scene.duration, state=state, gauges=scene.gauges, every=every)
    seconds = process_time() - began
    balance = scene.balance(model, start, run) if isinstance(scene, Drum) or not rubs else {}
    return balance | {
        "seconds": seconds, "steps": run.steps, "dt": run.dt, "bonds": len(model.lattice.pairs),
        "elements": len(model.mass), "broken": len(run.events) / len(model.lattice.pairs),
        "imbalance": run.history.imbalance,
        "memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0,
    }  # fmt: skip


def wall_spring(kn: float, soft: float, rate: float, friction: float) -> str:
    """Return the contact model of walls of LAMMPS for kn [N/m], ks / kn, dashpot over mass [1/s] and friction.

    Walls of style `hooke/history` have ks times √(R overlap / m²) in version 22 Jul 2025, and hardly any friction.
    """
    tangential = f"tangential linear_history {soft * kn:.17g} {math.sqrt(soft):.17g} {friction}"
    return f"granular hooke {kn:.17g} {rate:.17g} {tangential} damping mass_velocity limit_damping"


def script(scene: Scene, model: bd.Model, bond: dict[str, float], steps: int, dt: float) -> str:
    """Return the input script of LAMMPS for a scene."""
    order = "kn", "ks", "kt", "kb", "force", "shear", "bending", "twisting"
    values = " ".join(f"{bond[name]:.17g}" for name in order)
    # the damping of two mean spheres; without any, sliding at a wall divides by zero there
    mass = float(model.mass.mean())
    rate = max(1e-3, 2.0 * scene.damping * math.sqrt(bond["kn"] / (0.5 * mass)))

    kn, soft = bond["kn"], 2.0 / 7.0
    pair = f"{kn:.17g} {soft * kn:.17g} {rate:.17g} {math.sqrt(soft) * rate:.17g} {FRICTION} 1 limit_damping"
    # a sphere at a wall has half the length of two, kn = E π R² / R
    walls = scene.fixes(*(wall_spring(2.0 * kn, soft, rate, friction) for friction in (FRICTION, 0.0)))
    return f"""{BREAKING}comm_modify vel yes cutoff {0.8 * RADIUS:.17g}
read_data start.data
pair_style gran/hooke/history {pair}
pair_coeff * *
bond_style bpm/rotational smooth no
bond_coeff 1 {values} 0 0 0 0
neighbor {0.25 * model.lattice.particles.mean_radius:.3g} bin
neigh_modify every 1 delay 0 check yes
fix motion all nve/bpm/sphere
fix weight all gravity {GRAVITY} vector {" ".join(map(str, scene.down))}
{walls}
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


def lammps(scene: Scene, steps: int, dt: float) -> dict[str, Any]:
    """Run a scene in LAMMPS; return its seconds, version, share of broken bonds and memory [MiB]."""
    model, state, bond = model_of(scene)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "start.data").write_text(start_of(model, state))
        log, memory = ran(Path(folder), script(scene, model, bond, steps, dt))
    wall, share = re.findall(r"Loop time of (\S+) on", log)[-1], re.findall(r"(\S+)% CPU use", log)[-1]
    return {
        "seconds": float(wall) * float(share) / 100.0, "steps": steps,
        "version": log.splitlines()[0], "broken": 1.0 - counts(log, 2)[-1, 1] / len(model.lattice.pairs),
        "memory": memory,
    }  # fmt: skip


def again(kind: str, fields: dict[str, Any], rubs: bool, every: int) -> dict[str, Any]:
    """The run of a scene that JSON describes."""
    return bondem({"Fall": Fall, "Drum": Drum}[kind](**fields), rubs=rubs, every=every)


def apart(scene: Scene, *, rubs: bool = True, every: int = 200) -> dict[str, Any]:
    """A run of bondem in a process of its own, with one thread."""
    return alone(again, type(scene).__name__, asdict(scene), rubs, every, BONDEM_NUM_THREADS="1")


def in_turns(scene: Scene, repeat: int) -> dict[str, Any]:
    """Run both codes in turns; return all results, the loads of the machine, and the ratios of times."""
    loads, ours, theirs = [], [], []
    for _ in range(repeat):
        loads.append(os.getloadavg()[0])
        ours.append(apart(scene))
        theirs.append(lammps(scene, ours[0]["steps"], ours[0]["dt"]))
    row = {"speed": scene.speed, "loads": loads, "bondem": ours, "lammps": theirs}
    for name, one in (("best", min), ("median", statistics.median)):
        row[name] = one([x["seconds"] for x in theirs]) / one([x["seconds"] for x in ours])
    first, other = ours[0], theirs[0]
    print(
        f"{scene.speed:4.1f} m/s: {first['steps']} steps, broken {first['broken']:.3f}, {other['broken']:.3f},"
        f" {first['steps'] / first['seconds']:.0f} steps/s, {row['best']:.1f} (median {row['median']:.1f}) times as"
        f" fast as LAMMPS, memory {first['memory']:.0f} and {other['memory']:.0f} MiB,"
        f" ledger {first['imbalance']:.1e}", flush=True,
    )  # fmt: skip
    return row


def measure(
    record: Record, *, scene: Annotated[str, ("fall", "drum")] = "fall", bodies: int = 0, each: int = 0,
    repeat: int = 3, turns: float = 0.0,
) -> None:  # fmt: skip
    """Measure falls, or a drum.

    Args:
        scene: to be measured.
        bodies: how many; 50 that fall or 1000 in a drum unless given.
        each: spheres of a body; 200, or 60 in a drum, unless given.
        repeat: runs of each code, of falls at 7 m/s.
        turns: turns of the drum, in bondem alone.
    """
    sizes = {name: value for name, value in {"bodies": bodies, "each": each}.items() if value}
    if scene == "drum":
        drum = Drum(**sizes)
        if turns:
            drum = replace(drum, duration=turns * drum.turn)
        found = {"bondem": [apart(drum, every=20)]} if turns else in_turns(drum, repeat)
        whole = {"threads": 1, "bodies": drum.bodies, "each": drum.each, "duration": drum.duration}
        variant(record, "_turns" if turns else "_drum").keep(**whole, **found)
        print(found["bondem"])
        return
    falls: list[dict[str, Any]] = []
    for speed in SPEEDS:
        fall = Fall(speed=speed, **sizes)
        falls.append(in_turns(fall, repeat if speed == SPEEDS[1] else 1))
        if speed == SPEEDS[1]:
            # the force of the floor is added up from records
            falls[-1]["smooth"] = apart(fall, rubs=False, every=2)
        record.keep(threads=1, falls=falls, bodies=fall.bodies, each=fall.each)


if __name__ == "__main__":
    run()
