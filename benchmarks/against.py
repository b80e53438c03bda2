"""Comparison of this working tree with an older revision of the repository, on one machine: bits and speed.

    python benchmarks/against.py bits  [--revision HEAD] [--runs beams] [--elements 500 3000 9000] [--threads 1 2 4]
    python benchmarks/against.py speed [--revision HEAD] [--kinds beams cells ...]
                                       [--elements 10000 100000 1000000] [--threads 1 2] [--repeat 7]

`bits` compares digests of runs of all kinds (`levels.py`); its exit status is 1 if any differs. The older revision
must have the interfaces that tests of the present one use. `speed` runs the specimen of `tiled.py` in both by turns,
and writes benchmarks/results/against.json, with one entry per kind of processor.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from kept import keep, origin
from levels import SIZES
from paired import ROOT, SOURCE, Worker, commit_of, extracted, head, in_turns, specimen_file, steps_of

RESULTS = ROOT / "benchmarks" / "results" / "against.json"


def bits(options: argparse.Namespace) -> int:
    """Compare digests of all runs of both revisions by `levels.py`; return exit status 1 if any differs."""
    script = str(ROOT / "benchmarks" / "levels.py")
    sizes, threads = options.elements or SIZES, options.threads or [1, 2, 4]
    words = ["--elements", *map(str, sizes), "--threads", *map(str, threads), "--runs", options.runs]
    older, now = (
        os.environ | {"PYTHONPATH": str(source), "BONDEM_NUM_THREADS": str(max(threads))}
        for source in (extracted(options.revision), SOURCE)
    )
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder) / "digests.txt")
        subprocess.run([sys.executable, script, "--out", file, *words], env=older, check=True)
        return subprocess.run([sys.executable, script, "--against", file, *words], env=now, check=False).returncode


def rates(options: argparse.Namespace) -> list[dict]:
    """Measure both revisions in turns; return a row of rates per kind, size and number of threads."""
    rows, names = [], (options.revision, "now")
    threads = options.threads or [1, 2]
    cores = max(threads)
    with Worker(extracted(options.revision), cores=cores) as old, Worker(SOURCE, cores=cores) as new:
        print(f"\n{'kind':<20}{'elements':>9}{'threads':>8}{head(names)}   (rates: min / median / max)")
        for elements in options.elements or [10_000, 100_000, 1_000_000]:
            path = specimen_file(old, elements)
            for kind in options.kinds:
                known: dict = {"kind": kind, "elements": elements}
                bonds = old.ask("load", path=str(path), kind=kind)["bonds"]
                new.ask("load", path=str(path), kind=kind)
                steps = options.steps_timed or steps_of(max(bonds, elements))
                for count in threads:
                    size = max(bonds, elements)
                    pairs = in_turns(old, new, size, threads=count, repeat=options.repeat, steps=steps)
                    known |= {"bonds": bonds, "threads": count, "steps": steps, "counts": new.ask("counts")}
                    print(f"{kind:<20}{elements:>9}{count:>8}{pairs.line()}  {known['counts']}", flush=True)
                    rows.append(known | pairs.report(names))
    return rows


def speed(options: argparse.Namespace) -> int:
    """Measure, print and write the rates of both revisions; return exit status 0."""
    begun = origin()
    here = begun["machine"]
    print(", ".join(f"{key}: {value}" for key, value in here.items()))
    entry = {"revision": options.revision, "unit": "million bond-steps a second", "rates": rates(options)}
    here["load at the end"] = round(os.getloadavg()[0], 2)
    kept = json.loads(options.output.read_text()) if options.output.exists() else {}
    keep(options.output, kept | {f"{here['processor']}, {here['vector']}": begun | entry})
    return 0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("bits", "speed"))
    parser.add_argument("--revision", type=commit_of, default="HEAD", help="what to compare with [HEAD]")
    parser.add_argument("--elements", type=int, nargs="+", help="[500 3000 9000; 10000 100000 1000000 for speed]")
    parser.add_argument("--threads", type=int, nargs="+", help="[1 2 4; 1 2 for speed]")
    parser.add_argument("--runs", default="", help="bits: those alone whose names contain this")
    parser.add_argument("--repeat", type=int, default=7, help="speed: pairs [7]")
    parser.add_argument("--kinds", nargs="+", default=["beams"], help="speed: of `paired_kinds.py` [beams]")
    parser.add_argument("--steps-timed", type=int, help="speed: of a sample [a second or so]")
    parser.add_argument("--output", type=Path, default=RESULTS, help="speed: [benchmarks/results/against.json]")
    options = parser.parse_args()
    sys.exit({"bits": bits, "speed": speed}[options.what](options))


if __name__ == "__main__":
    main()
