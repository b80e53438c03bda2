"""Agglomerates of bonded spheres that fall on a floor and break, in bondem and in LAMMPS.

    LAMMPS=lammps/bin/lmp python benchmarks/peers/agglomerates.py [--bodies 50] [--each 200] [--repeat 3]

Balls of 10 mm of bonded spheres, turned at random and stacked without touching, move down at a speed and hit a floor.
Both codes have the same spheres, four stiffnesses of all bonds, `LinearSum` (the sum of `bond_style bpm/rotational`)
with the same strengths, contact with one stiffness and friction, gravity, and time step, that of bondem; one thread
each, in turns. A bond that breaks makes its spheres touch.

best      time of a fall, LAMMPS over bondem, of the fastest runs; "median" of all
memory    largest resident size of the process [MiB]
broken    share of the bonds at the end, for each speed, and that over the speed squared
impulse   momentum that the floor and gravity gave, over what the bodies gained: 1 [-]; of bondem
sideways  momentum along the floor over that of the fall, where nothing rubs on it [-]; of bondem
"""

import argparse
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))
from alike import Alike

import bondem as bd
from kept import RESULTS, keep, origin

RADIUS, DENSITY, E, NU, SHARE = 5e-3, 2500.0, 1e9, 0.2, 0.6
TENSION = 8e6  # of the section of a bond [Pa]; twice that in shear, bending and twisting
FRICTION, SPEEDS, GRAVITY = 0.5, (5.0, 7.0, 10.0), 9.81
#: Free fall before the floor is reached, and how long bodies are followed after that, over RADIUS / speed.
AHEAD, AFTER = 0.2, 4.0


def stiffness(rock: bd.Lattice) -> dict[str, float]:
    """Of a bond as long as the mean one, as an Euler–Bernoulli beam, and its strengths in `LinearSum`."""
    r, length = SHARE * rock.particles.mean_radius, float(rock.length.mean())
    area, second = np.pi * r**2, 0.25 * np.pi * r**4
    return {
        "kn": E * area / length, "ks": 12.0 * E * second / length**3, "kb": E * second / length,
        "kt": E / (1.0 + NU) * second / length, "radius": r, "force": TENSION * area, "shear": 2.0 * TENSION * area,
        "bending": 2.0 * TENSION * second / r, "twisting": 2.0 * TENSION * second / r,
    }  # fmt: skip


def scene(bodies: int, each: int) -> tuple[bd.Lattice, dict[str, float]]:
    """The bodies in the reference, the lowest sphere of all at z = 0."""
    packed = bd.pack(bd.Ball(radius=RADIUS), count=each, seed=1)
    bonds = bd.connect(packed, tolerance=0.01)
    # spheres of broken bonds do not push each other apart from the start: LAMMPS knows no overlap without force
    i, j = bonds.pairs.T
    shrunk = min(1.0, float((bonds.length / (packed.radius[i] + packed.radius[j])).min()))
    rock = bd.Lattice(bd.Particles(packed.position, shrunk * packed.radius), bonds.pairs)
    side = int(np.ceil(bodies ** (1.0 / 3.0)))
    k = np.arange(bodies)
    places = 2.3 * RADIUS * np.column_stack([k % side, k // side % side, k // side**2])
    all_of = bd.replicate(rock, places, rotations="random", seed=1)
    lowest = float((all_of.particles.position[:, 2] - all_of.particles.radius).min())
    return all_of.moved((0.0, 0.0, -lowest)), stiffness(rock)


def model_of(bodies: int, each: int, speed: float, *, rubs: bool = True) -> tuple[bd.Model, bd.State, float, dict]:
    """Model, state and duration of a fall, and what a bond has."""
    lattice, bond = scene(bodies, each)
    law = Alike(E=E, nu=NU, **{name: bond[name] for name in ("kn", "ks", "kb", "kt", "radius")})
    failure = bd.LinearSum(**{name: bond[name] for name in ("force", "shear", "bending", "twisting")})
    # kn = E π R² / 2R of two mean spheres
    contact = bd.LinearContact(
        E=2.0 * bond["kn"] / (np.pi * lattice.particles.mean_radius), kappa=3.5, friction=FRICTION if rubs else 0.0,
        stress_free=False,
    )  # fmt: skip
    floor = bd.PlaneWall((0, 0, -AHEAD * RADIUS), (0, 0, 1))
    model = bd.Model(
        lattice, law, DENSITY, contact=contact, failure=failure, boundary=[bd.Gravity(GRAVITY)], walls=[floor]
    )
    state = model.state()
    state.velocity = (0.0, 0.0, -speed)
    return model, state, (AHEAD + AFTER) * RADIUS / speed, bond


def bondem(bodies: int, each: int, speed: float, *, rubs: bool) -> dict:
    """One fall."""
    model, state, duration, _ = model_of(bodies, each, speed, rubs=rubs)
    mass = DENSITY * model.lattice.particles.volume
    before = mass @ state.velocity
    # the force of the floor is added up from records, which a timed run has few of
    often = {"every": 2, "gauges": {"floor": bd.WallGauge(0, "force")}} if not rubs else {"every": 200}
    began = perf_counter()
    run = bd.solve_explicit(model, duration=duration, state=state, **often)
    seconds = perf_counter() - began
    gained, fell = mass @ run.state.velocity - before, float(mass.sum()) * speed
    balance = {}
    if not rubs:
        pushed = -float(np.trapezoid(run.history["floor"][:, 2], run.history.time))
        given = pushed - float(mass.sum()) * GRAVITY * run.state.time
        balance = {"impulse": given / float(gained[2]), "sideways": float(np.abs(gained[:2]).max()) / fell}
    return balance | {
        "seconds": seconds, "steps": run.steps, "dt": run.dt, "bonds": len(model.lattice.pairs),
        "elements": len(mass), "broken": len(run.events) / len(model.lattice.pairs),
        "imbalance": run.history.imbalance,
        "memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0,
    }  # fmt: skip


def script(bond: dict[str, float], steps: int, dt: float) -> str:
    """The input of LAMMPS."""
    order = "kn", "ks", "kt", "kb", "force", "shear", "bending", "twisting"
    values = " ".join(f"{bond[name]:.17g}" for name in order)
    # without any dashpot, sliding at a wall divides by zero there
    spring = f"{bond['kn']:.17g} {2.0 / 7.0 * bond['kn']:.17g} 1e-3 NULL {FRICTION} 1"
    return f"""units si
dimension 3
boundary f f f
atom_style bpm/sphere
newton on off
special_bonds lj 0 1 1 coul 1 1 1
comm_modify vel yes cutoff {0.8 * RADIUS:.17g}
read_data start.data
pair_style gran/hooke/history {spring}
pair_coeff * *
bond_style bpm/rotational smooth no
bond_coeff 1 {values} 0 0 0 0
neighbor {0.3 * SHARE:.3g}e-3 bin
neigh_modify every 1 delay 0 check yes
fix motion all nve/bpm/sphere
fix weight all gravity {GRAVITY} vector 0 0 -1
fix floor all wall/gran hooke/history {spring} zplane {-AHEAD * RADIUS:.17g} NULL
timestep {dt:.17g}
thermo_style custom step bonds
thermo {steps}
thermo_modify lost ignore lost/bond ignore
run {steps}
"""


def data(model: bd.Model, speed: float) -> str:
    """Spheres, velocities and bonds as a data file."""
    particles, pairs = model.lattice.particles, model.lattice.pairs
    low, high = particles.position.min(axis=0) - 3.0 * RADIUS, particles.position.max(axis=0) + 3.0 * RADIUS
    lines = ["agglomerates", "", f"{len(particles)} atoms", "1 atom types", f"{len(pairs)} bonds", "1 bond types"]
    lines += ["30 extra bond per atom", "60 extra special per atom"]
    lines += [f"{a:.17g} {b:.17g} {c}lo {c}hi" for a, b, c in zip(low, high, "xyz", strict=True)]
    spheres = zip(particles.radius, particles.position, strict=True)
    lines += ["", "Atoms # bpm/sphere", ""]
    lines += [
        f"{k} 1 1 {2.0 * r:.17g} {DENSITY:.17g} {x:.17g} {y:.17g} {z:.17g}"
        for k, (r, (x, y, z)) in enumerate(spheres, start=1)
    ]
    lines += ["", "Velocities", ""]
    lines += [f"{k} 0 0 {-speed:.17g} 0 0 0" for k in range(1, len(particles) + 1)]
    lines += ["", "Bonds", ""]
    lines += [f"{k} 1 {i + 1} {j + 1}" for k, (i, j) in enumerate(pairs, start=1)]
    return "\n".join(lines) + "\n"


def lammps(bodies: int, each: int, speed: float, steps: int, dt: float) -> dict:
    """The same fall in LAMMPS."""
    executable = os.environ.get("LAMMPS", "lmp")
    environment = os.environ | {
        "LD_LIBRARY_PATH": str(Path(executable).absolute().parent.parent / "lib"), "OMP_NUM_THREADS": "1"
    }  # fmt: skip
    model, _, _, bond = model_of(bodies, each, speed)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "start.data").write_text(data(model, speed))
        (Path(folder) / "in.fall").write_text(script(bond, steps, dt))
        words = [executable, "-in", "in.fall", "-nocite", "-screen", "none", "-log", "log"]
        started = subprocess.Popen(words, cwd=folder, env=environment, stderr=subprocess.PIPE)
        _, status, used = os.wait4(started.pid, 0)
        log = (Path(folder) / "log").read_text()
    if status != 0:
        raise RuntimeError(f"LAMMPS ended with {status}: {log[-500:]}")
    left = [line.split() for line in log.splitlines() if re.fullmatch(r"\s*\d+\s+\d+\s*", line)][-1]
    return {
        "seconds": float(re.findall(r"Loop time of (\S+) on", log)[-1]), "steps": steps,
        "version": log.splitlines()[0], "broken": 1.0 - int(left[1]) / len(model.lattice.pairs),
        "memory": used.ru_maxrss / 1024.0,
    }  # fmt: skip


def apart(*words: object) -> dict:
    """A fall of bondem in a process of its own, with one thread."""
    command = [sys.executable, __file__, "--one", *map(str, words)]
    single = {**os.environ, "BONDEM_NUM_THREADS": "1"}
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=single)
    return json.loads(done.stdout.splitlines()[-1])


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bodies", type=int, default=50)
    parser.add_argument("--each", type=int, default=200, help="spheres of a body")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each code at the middle speed, in turns")
    parser.add_argument("--out", type=Path, default=RESULTS / "agglomerates.json")
    parser.add_argument("--one", nargs=2, help=argparse.SUPPRESS)
    given = parser.parse_args(arguments)
    if given.one:
        print(json.dumps(bondem(given.bodies, given.each, float(given.one[0]), rubs=given.one[1] == "rough")))
        return
    sizes = ("--bodies", given.bodies, "--each", given.each)
    report = origin() | {"bodies": given.bodies, "each": given.each, "threads": 1, "falls": []}
    for speed in SPEEDS:
        ours = [apart(speed, "rough", *sizes)]
        alike = given.bodies, given.each, speed, ours[0]["steps"], ours[0]["dt"]
        theirs = [lammps(*alike)]
        for _ in range(given.repeat - 1 if speed == SPEEDS[1] else 0):
            ours.append(apart(speed, "rough", *sizes))
            theirs.append(lammps(*alike))
        row = {"speed": speed, "bondem": ours, "lammps": theirs}
        for name, one in (("best", min), ("median", statistics.median)):
            row[name] = one([x["seconds"] for x in theirs]) / one([x["seconds"] for x in ours])
        if speed == SPEEDS[1]:
            row["smooth"] = apart(speed, "smooth", *sizes)
        report["falls"].append(row)
        keep(given.out, report)
        print(
            f"{speed:4.1f} m/s: {ours[0]['steps']} steps, broken {ours[0]['broken']:.3f}, {theirs[0]['broken']:.3f},"
            f" {row['best']:.1f} (median {row['median']:.1f}) times as fast as LAMMPS,"
            f" memory {ours[0]['memory']:.0f} and {theirs[0]['memory']:.0f} MiB,"
            f" ledger {ours[0]['imbalance']:.1e}", flush=True,
        )  # fmt: skip


if __name__ == "__main__":
    main()
