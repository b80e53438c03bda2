"""Comparison of this working tree with an older revision of the repository, on one machine: bits and speed.

    python benchmarks/against.py bits  [--revision c790c8a] [--cases alike grains ...] [--elements 500 3000 9000]
                                       [--threads 1 2 4] [--steps 300]
    python benchmarks/against.py speed [--revision c790c8a] [--kinds beams cells ...]
                                       [--elements 10000 100000 1000000] [--threads 1 2] [--repeat 7]

`bits` runs every kind of bond, load, damping, rotation and contact in both revisions, interrupted in several ways. It
compares all results by bytes, and its exit status is 1 if any byte differs. `speed` runs the specimen of `tiled.py`
in both by turns, and writes benchmarks/results/against.json, with one entry per kind of processor. Option --python
gives another interpreter for a revision that needs other packages.
"""

import argparse
import json
import os
import sys
import tempfile
import time
from pathlib import Path

from bits.compare import Difference, differing
from kept import origin
from paired import ROOT, SOURCE, Worker, extracted, head, in_turns, specimen_file, steps_of

RESULTS = ROOT / "benchmarks" / "results" / "against.json"
SIZES = (500, 3000, 9000)
# Larger specimens test blocks and domains; the small one tests all ways to interrupt a run.
PAUSES = {"small": ("every 30", "every 0", "every 1", "every 7", "saved every 37", "two runs"),
          "large": ("every 30", "every 0", "two runs")}  # fmt: skip


# ---- bits


def compared(old: Worker, new: Worker, name: str, size: int, threads: list[int], steps: int) -> tuple[dict, dict]:
    """Run a case in both revisions; return the answer of the old one, and the first difference per thread count."""
    pauses = PAUSES["small" if size <= SIZES[0] else "large"]
    with tempfile.TemporaryDirectory() as folder:
        told: list[dict] = []
        for side, worker in (("old", old), ("new", new)):
            (Path(folder) / side).mkdir()
            arguments = {"name": name, "size": size, "threads": threads, "pauses": pauses, "steps": steps}
            dt = told[0]["dt"] if told else None
            told.append(worker.ask("bits", **arguments, dt=dt, folder=str(Path(folder) / side)))
        found = {count: _first(Path(folder), count, pauses) for count in threads}
    return told[0], found


def _first(folder: Path, count: int, pauses: tuple[str, ...]) -> Difference | None:
    for pause in pauses:
        pair = [folder / side / f"{pause}-{count}.npz" for side in ("old", "new")]
        if not any(path.exists() for path in pair):  # the case cannot be interrupted in this way
            continue
        found = differing(*pair, pause)
        if found is not None:
            return found
    return None


def bits(options: argparse.Namespace) -> int:
    """Compare all chosen cases and print a table of them; return exit status 1 if any byte differs."""
    threads = options.threads or [1, 2, 4]
    cores = max(4, *threads)
    old_source = extracted(options.revision)
    print(f"{options.revision} against the working tree, {options.steps} steps; first array that differs, if any")
    bad = 0
    with (
        Worker(old_source, cores=cores, cache=old_source.parent, python=options.python) as old,
        Worker(SOURCE, cores=cores) as new,
    ):
        known = new.ask("cases")["names"]
        unknown = sorted(set(options.cases or known) - set(known))
        if unknown:
            sys.exit(f"there is no case '{unknown[0]}'; choose from {', '.join(known)}")
        for size in options.elements or SIZES:
            columns = "".join(f"{f'{count} threads':>11}" for count in threads)
            print(f"\n{f'about {size} elements':<26}{'elements':>9}{'bonds':>8}{'moved':>9}{'touch':>7}{columns}")
            for name in options.cases or known:
                start = time.perf_counter()
                was, found = compared(old, new, name, size, threads, options.steps)
                marks = "".join(f"{'same' if found[count] is None else 'DIFFERS':>11}" for count in threads)
                row = f"{name:<26}{was['elements']:>9}{was['bonds']:>8}{was['moved']:>9.1e}{was['touching']:>7}"
                print(f"{row}{marks}{time.perf_counter() - start:8.1f} s", flush=True)
                for fault in list(was["faults"].items())[:1]:
                    print(f"    the old revision did not complete it ({fault[0]}): {fault[1]}")
                for count, difference in found.items():
                    if difference is not None:
                        print(f"    {count} threads: {difference}")
                bad += bool(was["faults"]) or any(found.values())
    print(f"\n{bad} runs differ" if bad else "\nthe same bits everywhere")
    return 1 if bad else 0


# ---- speed


def _kept(options: argparse.Namespace, begun: dict, found: dict) -> None:
    """Write the entry of this processor into the results, which keep those of others."""
    here = begun["machine"]
    kept = json.loads(options.output.read_text()) if options.output.exists() else {}
    kept[f"{here['processor']}, {here['vector']}"] = begun | {"revision": options.revision} | found
    options.output.write_text(json.dumps(kept, indent=1) + "\n")


def rates(options: argparse.Namespace, old_source: Path) -> list[dict]:
    """Measure both revisions in turns; return a row of rates per kind, size and number of threads."""
    rows = []
    names = (options.revision, "now")
    threads = options.threads or [1, 2]
    cores = max(threads)
    with (
        Worker(old_source, cores=cores, cache=old_source.parent, python=options.python) as old,
        Worker(SOURCE, cores=cores) as new,
    ):
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
                print(scaling([row for row in rows if row["elements"] == elements and row["kind"] == kind], names),
                      flush=True)  # fmt: skip
    return rows


def scaling(rows: list[dict], names: tuple[str, str]) -> str:
    """Return the lines that show the speed-up by threads of both revisions, by median rates."""
    one = [row for row in rows if row["threads"] == 1]
    more = [row for row in rows if row["threads"] > 1]
    return "\n".join(
        f"{'':>11}{row['threads']} threads over one: "
        + ", ".join(f"{row[name]['median'] / one[0][name]['median']:.2f} ({name})" for name in names)
        for row in more
        if one
    )


def speed(options: argparse.Namespace) -> int:
    """Measure, print and write the rates of both revisions; return exit status 0."""
    begun = origin()
    here = begun["machine"]
    print(", ".join(f"{key}: {value}" for key, value in here.items()))
    old_source = extracted(options.revision)
    entry = {"unit": "million bond-steps a second", "rates": rates(options, old_source)}
    here["load at the end"] = round(os.getloadavg()[0], 2)
    _kept(options, begun, entry)
    return 0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("bits", "speed"))
    parser.add_argument("--revision", default="c790c8a", help="what to compare with [c790c8a]")
    parser.add_argument("--elements", type=int, nargs="+", help="[500 3000 9000; 10000 100000 1000000 for speed]")
    parser.add_argument("--threads", type=int, nargs="+", help="[1 2 4; 1 2 for speed]")
    parser.add_argument("--cases", nargs="+", help="bits: some of the cases only")
    parser.add_argument("--steps", type=int, default=300, help="bits: of each run, whole hundreds [300]")
    parser.add_argument("--python", help="interpreter of the old revision [the present one]")
    parser.add_argument("--repeat", type=int, default=7, help="speed: pairs [7]")
    parser.add_argument("--kinds", nargs="+", default=["beams"], help="speed: of `paired_kinds.py` [beams]")
    parser.add_argument("--steps-timed", type=int, help="speed: of a sample [a second or so]")
    parser.add_argument("--output", type=Path, default=RESULTS, help="speed: [benchmarks/results/against.json]")
    options = parser.parse_args()
    sys.exit({"bits": bits, "speed": speed}[options.what](options))


if __name__ == "__main__":
    main()
