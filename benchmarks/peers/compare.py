"""Speed of bondem and other codes on the same bonded specimen, in turns on one thread: bond-steps per second.

    python benchmarks/peers/compare.py [--elements 10000 100000] [--steps 500] [--repeat 3]
                                       [--codes bondem non-local lammps yade kratos]

README.md in this folder describes the installation of the other codes and their differences. Codes that are not
installed are left out. Each run is a new process; set-up, compilation and the first steps are not timed. The first
steps are compared with those of bondem: a code with another motion, or with broken bonds, gets no ratio.
"""

import argparse
import statistics
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))

from kratos_kdem import Kratos
from lammps_bpm import Lammps
from outcome import Outcome, difference, kinetic_share
from own import Bondem, NonLocalBondem
from specimen import Specimen, build
from yade_cohfrict import Yade

from kept import RESULTS, keep, origin

CODES = {code.name: code for code in (Bondem, NonLocalBondem, Lammps, Yade, Kratos)}
# Number of compared steps: about three periods of the highest mode, so that every bond is both stretched and pressed.
CHECK = 20
# Largest difference of positions, and of the share of kinetic energy at the end, of equal motions. Codes that store
# velocities half a step earlier have a twentieth more kinetic energy, and the share oscillates at the start.
SAME_MOTION = 0.01
SAME_ENERGY = 0.1
# Factors by which codes take fewer steps than bondem, so that runs of all codes take about equally long.
SLOWER = {"bondem": 1, "non-local": 8, "lammps": 8, "yade": 16, "kratos": 64}


def installed(names: list[str]) -> list:
    """The codes that can run here; bondem is always the first, as it is what others are compared with."""
    found = []
    for name in dict.fromkeys(["bondem", *names]):
        code = CODES[name]()
        why = code.missing()
        if why:
            print(f"without {name}: {why}")
        else:
            found.append(code)
    return found


def turns(codes: list, specimen: Specimen, steps: dict[str, int], repeat: int) -> dict[str, list[Outcome]]:
    """Run all codes in turns, `repeat` times, and return the outcomes by code."""
    runs: dict[str, list[Outcome]] = {code.name: [] for code in codes}
    for _ in range(repeat):
        for code in codes:
            with tempfile.TemporaryDirectory() as folder:
                runs[code.name].append(code.run(specimen, Path(folder), CHECK, steps[code.name]))
    return runs


def judged(code, specimen: Specimen, found: Outcome, ours: Outcome) -> dict:
    """Compare an outcome with that of bondem; return differences of motion and kinetic energy, and faults as text."""
    apart = difference(specimen, found, ours, CHECK)
    share, own = kinetic_share(specimen, found), kinetic_share(specimen, ours)
    bonds = len(specimen.pairs)
    faults = []
    if found.bonds != bonds:
        faults.append(f"{found.bonds} of {bonds} bonds")
    if code.alike and not apart <= SAME_MOTION:
        faults.append(f"positions differ by {apart:.1%}")
    if not (abs(share - own) <= SAME_ENERGY or code.own_law):
        faults.append(f"kinetic energy {share:.3f} of that at the start, {own:.3f} in bondem")
    return {"difference": apart, "kinetic_share": share, "faults": faults}


def table(codes: list, specimen: Specimen, runs: dict[str, list[Outcome]], steps: dict[str, int]) -> dict:
    """Return rates, ratios and the comparison of each code, and print a line for each."""
    bonds = len(specimen.pairs)
    ours = runs["bondem"]
    report = {}
    per_step = {}
    for code in codes:
        seconds = [run.seconds for run in runs[code.name]]
        per_step[code.name] = [s / steps[code.name] for s in seconds]
        best, middle = min(per_step[code.name]), statistics.median(per_step[code.name])
        row = report[code.name] = {
            "version": runs[code.name][-1].version,
            "steps": steps[code.name],
            "seconds": seconds,
            "Mbond_steps_per_s_best": bonds / best / 1e6,
            "Mbond_steps_per_s_median": bonds / middle / 1e6,
            "ratio_best": best / min(per_step["bondem"]),
            "ratio_median": middle / statistics.median(per_step["bondem"]),
            "differs": code.differs,
            **judged(code, specimen, runs[code.name][-1], ours[-1]),
        }
        told = "NO RATIO: " + "; ".join(row["faults"]) if row["faults"] else f"{row['ratio_median']:.1f} of bondem"
        rate = f"{row['Mbond_steps_per_s_median']:8.2f} million bond-steps/s"
        motion = f"motion {row['difference']:.1e}, kinetic {row['kinetic_share']:.3f}"
        print(f"{len(specimen.radius):>8} {code.name:>9} {rate}, time {told}, {motion}", flush=True)
    return report


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, nargs="+", default=[10_000, 100_000])
    parser.add_argument("--steps", type=int, help="timed steps of bondem, peers take fewer [8 seconds or so]")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each code, in turns [3]")
    parser.add_argument("--codes", nargs="+", choices=CODES, default=[one for one in CODES if one != "non-local"])
    parser.add_argument("--output", type=Path, default=RESULTS / "peers.json")
    options = parser.parse_args()
    codes = installed(options.codes)
    report: dict = {**origin(), "threads": 1, "specimens": []}
    print(f"{report['machine']}; one thread each, {options.repeat} runs in turns")
    for code in codes:
        for remark in code.differs:
            print(f"  {code.name}: {remark}")
    for elements in options.elements:
        specimen = build(elements)
        bonds = len(specimen.pairs)
        wanted = options.steps or max(100, 500_000_000 // bonds)
        steps = {code.name: max(10, wanted // SLOWER[code.name]) for code in codes}
        runs = turns(codes, specimen, steps, options.repeat)
        rows = table(codes, specimen, runs, steps)
        report["specimens"].append(
            {"elements": elements, "bonds": bonds, "z": 2.0 * bonds / elements, "dt": specimen.dt, "codes": rows}
        )
        keep(options.output, report)


if __name__ == "__main__":
    main()
