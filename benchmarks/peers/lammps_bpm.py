"""Runs of LAMMPS with `bond_style bpm/rotational`: input, execution and outcome."""

import math
import os
import re
import subprocess
from pathlib import Path

import numpy as np
from outcome import Code, Outcome, why_not
from specimen import DENSITY, Specimen

#: The beginning of an input in SI units, and what both granite and agglomerates have next.
HEAD = "units si\ndimension 3\nboundary f f f\natom_style bpm/sphere\nnewton on off\n"
BREAKING = f"{HEAD}special_bonds lj 0 1 1 coul 1 1 1\n"
EXTRA = ("30 extra bond per atom", "60 extra special per atom")
# Bonds have their stiffness by type: as many types as this, by length; stiffnesses within half a percent.
TYPES = 64


class Lammps(Code):
    """The executable is `lmp`, or what the environment variable LAMMPS names."""

    name = "lammps"
    differs = (
        f"stiffness by {TYPES} classes of bond length instead of bond by bond",
        "bonds compute their damping, with coefficients of zero, and a measure of breaking that never breaks them;"
        " neither can be left out",
    )

    def missing(self) -> str:
        return why_not([executable(), "-h"], "BPM", _environment())

    def run(self, specimen: Specimen, folder: Path, check: int, steps: int) -> Outcome:
        write_data(folder / "specimen.data", specimen)
        ran(folder, script(specimen, check, steps))
        return read(folder)


def executable() -> str:
    """Return the executable that the environment variable LAMMPS names, or else `lmp`."""
    return os.environ.get("LAMMPS", "lmp")


def _environment() -> dict[str, str]:
    """Return the environment of a run, with the libraries of the virtual environment of LAMMPS and its MPI."""
    path = Path(executable()).absolute().parent.parent / "lib"
    return {**os.environ, "LD_LIBRARY_PATH": str(path), "OMP_NUM_THREADS": "1"}


def wall_spring(kn: float, soft: float, rate: float, friction: float) -> str:
    """Return the contact model of walls of LAMMPS for kn [N/m], ks / kn, dashpot over mass [1/s] and friction.

    Walls of style `hooke/history` have ks times √(R overlap / m²) in version 22 Jul 2025, and hardly any friction.
    """
    tangential = f"tangential linear_history {soft * kn:.17g} {math.sqrt(soft):.17g} {friction}"
    return f"granular hooke {kn:.17g} {rate:.17g} {tangential} damping mass_velocity limit_damping"


def ran(folder: Path, script: str) -> tuple[str, float]:
    """Run a script in a folder on one thread; return its log and the peak memory of LAMMPS [MiB].

    Raises:
        RuntimeError: LAMMPS ended with an error.
    """
    (folder / "in.script").write_text(script)
    words = [executable(), "-in", "in.script", "-nocite", "-screen", "none", "-log", "log"]
    process = subprocess.Popen(words, cwd=folder, env=_environment(), stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    log = (folder / "log").read_text()
    if status != 0:
        raise RuntimeError(f"LAMMPS ended with {status}: {log[-500:]}")
    return log, used.ru_maxrss / 1024.0


def counts(log: str, columns: int) -> np.ndarray:
    """Return the rows of thermodynamic output from the step to the number of bonds, (k, columns)."""
    pattern = rf"\s*\d+(\s+\S+){{{columns - 2}}}\s+\d+\s*"
    return np.array([line.split() for line in log.splitlines() if re.fullmatch(pattern, line)], dtype=float)


def classes(specimen: Specimen) -> tuple[np.ndarray, np.ndarray]:
    """Return the type of each bond by its length, from 0, (m,), and the mean length of each type [m]."""
    L = specimen.length
    edges = np.linspace(L.min(), L.max(), TYPES + 1)
    kind = np.clip(np.searchsorted(edges, L, side="right") - 1, 0, TYPES - 1)
    _, kind = np.unique(kind, return_inverse=True)
    return kind, np.bincount(kind, weights=L) / np.bincount(kind)


def data(
    title: str, spheres: tuple[np.ndarray, np.ndarray, np.ndarray], pairs: np.ndarray, kind: np.ndarray,
    box: tuple[np.ndarray, np.ndarray], *, extra: tuple[str, ...], velocity: np.ndarray | None = None,
) -> str:  # fmt: skip
    """Spheres, velocities and bonds as a data file of atom_style bpm/sphere.

    Args:
        title: first line.
        spheres: centres (n, 3), radii (n,) and densities (n,).
        pairs: spheres of each bond, (m, 2).
        kind: type of each bond from 1, (m,).
        box: its lower and its upper corner.
        extra: further lines of the head.
        velocity: of spheres that do not spin, (n, 3); at rest unless given.
    """
    lines = [title, "", f"{len(spheres[1])} atoms", "1 atom types", f"{len(pairs)} bonds", f"{max(kind)} bond types"]
    lines += extra
    lines += [f"{a:.17g} {b:.17g} {c}lo {c}hi" for a, b, c in zip(*box, "xyz", strict=True)]
    lines += ["", "Atoms # bpm/sphere", ""]
    lines += [
        f"{k} 1 1 {2.0 * r:.17g} {rho:.17g} {x:.17g} {y:.17g} {z:.17g}"
        for k, ((x, y, z), r, rho) in enumerate(zip(*spheres, strict=True), start=1)
    ]
    if velocity is not None:
        lines += ["", "Velocities", ""]
        lines += [f"{k} {u:.17g} {v:.17g} {w:.17g} 0 0 0" for k, (u, v, w) in enumerate(velocity, start=1)]
    lines += ["", "Bonds", ""]
    lines += [f"{k} {t} {i + 1} {j + 1}" for k, (t, (i, j)) in enumerate(zip(kind, pairs, strict=True), start=1)]
    return "\n".join(lines) + "\n"


def write_data(path: Path, specimen: Specimen) -> None:
    """The specimen as a data file."""
    most, margin = int(np.bincount(specimen.pairs.ravel()).max()), specimen.radius.max()
    spheres = specimen.position, specimen.radius, np.full(len(specimen.radius), DENSITY)
    box = specimen.position.min(axis=0) - margin, specimen.position.max(axis=0) + margin
    path.write_text(data(
        "bonded spheres", spheres, specimen.pairs, classes(specimen)[0] + 1, box,
        extra=(f"{most} extra bond per atom",), velocity=specimen.velocity,
    ))  # fmt: skip


def script(specimen: Specimen, check: int, steps: int) -> str:
    """Elastic bonds, no pair forces and no output in the loop."""
    _, length = classes(specimen)
    # products with powers of L are the same for all bonds
    L = specimen.length
    axial, shear = (specimen.kn * L).mean(), (specimen.ks * L**3).mean()
    bend, twist = (specimen.kb * L).mean(), (specimen.kt * L).mean()
    never = "1e30 1e30 1e30 1e30"
    coefficients = "\n".join(
        f"bond_coeff {t} {axial / l:.17g} {shear / l**3:.17g} {twist / l:.17g} {bend / l:.17g} {never} 0 0 0 0"
        for t, l in enumerate(length, start=1)
    )
    reach = 2.2 * specimen.radius.max()
    return f"""{HEAD}special_bonds lj/coul 1 1 1
comm_modify vel yes cutoff {reach:.17g}
# without a pair style atoms are sorted only where a bin size is given
atom_modify sort 100 {reach:.17g} map array
read_data specimen.data
pair_style none
bond_style bpm/rotational overlay/pair yes smooth no break no
{coefficients}
neighbor {0.1 * specimen.radius.max():.17g} bin
neigh_modify every 1 delay 0 check yes
fix motion all nve/bpm/sphere
timestep {specimen.dt:.17g}
thermo_style custom step bonds
thermo {max(check, steps)}
run {check}
write_dump all custom check.dump id x y z modify sort id format float %.17g
run {steps}
write_dump all custom end.dump id vx vy vz omegax omegay omegaz modify sort id format float %.17g
"""


def read(folder: Path) -> Outcome:
    """Return the outcome of a run from the files in its folder."""
    log = (folder / "log").read_text()
    loops = re.findall(r"Loop time of (\S+) on 1 procs", log)
    end = np.loadtxt(folder / "end.dump", skiprows=9)
    return Outcome(
        seconds=float(loops[-1]),
        bonds=int(counts(log, 2)[-1, 1]),
        position=np.loadtxt(folder / "check.dump", skiprows=9)[:, 1:],
        velocity=end[:, 1:4],
        spin=end[:, 4:7],
        version=log.splitlines()[0].strip(),
    )
