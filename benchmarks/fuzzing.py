"""Coverage-guided fuzzing of the readers of studies and of run files, by libFuzzer (`pip install atheris`).

Studies are mutated as text, from all examples and templates; run files as bytes, from three small runs. Each input
must raise an error of one line or be read. A study that is read must contain finite numbers only, and a run file the
state, records and masses that were written. Anything else (a traceback, a hang of ten seconds, a crash) ends the
fuzzing and leaves the input in the folder.

Run: python benchmarks/fuzzing.py [--seconds 120] [--folder DIR]
It writes benchmarks/results/fuzzing.json.
"""

import argparse
import dataclasses
import importlib
import json
import math
import re
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
TARGETS = ("study", "run")


def finite(value: Any) -> bool:
    """Return True if all numbers in an object, at any depth, are finite."""
    if isinstance(value, float):
        return math.isfinite(value)
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return all(finite(getattr(value, item.name)) for item in dataclasses.fields(value))
    if isinstance(value, Mapping):
        return all(finite(one) for one in value.values())
    return all(finite(one) for one in value) if isinstance(value, list | tuple) else True


def in_one_line(error: Exception) -> None:
    """Assert that the message of an error is a single line."""
    assert "\n" not in str(error), "more than one line"


def words(folder: Path) -> Path:
    """Write the dictionary of libFuzzer for studies (keys, values, invalid numbers), and return its path."""
    found = {"nan", "inf", "1e400", "-1", "[[", "]]", '"""', "true", "= {", "[]", '""', "\\n", "0x1", "1_0"}
    for path in (folder / "study_seeds").iterdir():
        found |= set(re.findall(r'[A-Za-z_][\w.]*|"[^"\n]*"|[\d.e+-]+', path.read_text(encoding="utf-8")))
    safe = [one.replace("\\", "\\\\").replace('"', '\\"') for one in sorted(found) if one.isascii()]
    file = folder / "words"
    file.write_text("".join(f'"{one}"\n' for one in safe))
    return file


def of_study() -> Callable[[bytes], None]:
    """Return the fuzzing target that reads a text as a study, like `bondem run`."""
    from bondem.errors import StudyError
    from bondem.study.programme import read

    file = Path(tempfile.mkdtemp()) / "study.toml"

    def one(data: bytes) -> None:
        file.write_bytes(data)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                found = read(file)
        except StudyError as error:
            in_one_line(error)
            return
        assert finite(found), "a number that is none was taken"

    return one


def of_run(originals: Path) -> Callable[[bytes], None]:
    """Return the fuzzing target that reads bytes as a run file, like `bondem info` and `bondem resume`."""
    import numpy as np

    import bondem as bd
    from bondem.errors import RunFileError

    known = [bd.read_run(path) for path in sorted(originals.glob("*.h5"))]
    file = Path(tempfile.mkdtemp(dir="/dev/shm" if Path("/dev/shm").is_dir() else None)) / "run.h5"

    def same(read: Any, whole: Any) -> bool:
        return (
            len(read.state.pose) == len(whole.state.pose)
            and all(np.array_equal(getattr(read.state, k), getattr(whole.state, k)) for k in type(read.state).ARRAYS)
            and np.array_equal(read.history.records, whole.history.records)
            and np.array_equal(read.model.mass, whole.model.mass)
        )

    def one(data: bytes) -> None:
        file.write_bytes(data)
        try:
            bd.read_contents(file)
            read = bd.read_run(file)
        except RunFileError as error:
            in_one_line(error)
            return
        assert any(same(read, whole) for whole in known), "other numbers were taken"

    return one


def corpus(target: str, folder: Path) -> Path:
    """Write the inputs from which mutations begin, and return their folder."""
    seeds = folder / f"{target}_seeds"
    seeds.mkdir(parents=True, exist_ok=True)
    if target == "study":
        for path in [*ROOT.glob("examples/*.toml"), *ROOT.glob("src/bondem/study/templates/*.toml")]:
            (seeds / f"{path.parent.name}_{path.name}").write_bytes(path.read_bytes())
        return seeds
    import bondem as bd

    ball = bd.connect(bd.pack(bd.Box((4e-3, 2e-3, 2e-3)), count=100, seed=1))
    body = bd.connect(bd.pack(bd.Box((4e-3, 2e-3, 2e-3)), count=60, method="even", seed=1), method="laguerre")
    beams = bd.Model(ball, bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.5), density=2000.0)
    cells = bd.Model(body, bd.CellBond(E=1e9, nu=0.2), density=2000.0)
    for name, model, snapshots in (("beams", beams, 0), ("cells", cells, 0), ("pictures", beams, 10)):
        dt = bd.solve_explicit(model, duration=0.0).dt
        bd.solve_explicit(model, duration=20 * dt, dt=dt, every=5, out=seeds / f"{name}.h5", snapshot_every=snapshots)
    return seeds


def fuzz(target: str, seconds: int, folder: Path) -> None:
    """Fuzz a target in this process, which libFuzzer ends."""
    atheris: Any = importlib.import_module("atheris")
    with atheris.instrument_imports(include=["bondem.study", "bondem.io", "bondem.specimen", "bondem._checks"]):
        one = of_study() if target == "study" else of_run(folder / "run_seeds")
    found = folder / f"{target}_found"
    found.mkdir(exist_ok=True)
    options = ["-timeout=10", "-rss_limit_mb=4096", "-print_final_stats=1", "-max_len=1000000", "-seed=1"]
    options += [f"-max_total_time={seconds}", f"-artifact_prefix={folder}/{target}_bad_", str(found)]
    if target == "study":
        options.append(f"-dict={words(folder)}")
    atheris.Setup([sys.argv[0], *options, str(folder / f"{target}_seeds")], one)
    atheris.Fuzz()


def told(target: str, seconds: int, folder: Path) -> dict[str, Any]:
    """Fuzz a target in a new process; return counts of inputs, of branches reached, and of failures."""
    corpus(target, folder)
    command = [sys.executable, __file__, "--target", target, "--seconds", str(seconds), "--folder", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    tried = re.search(r"stat::number_of_executed_units:\s*(\d+)", done.stderr)
    reached = re.findall(r"cov: (\d+) ft: (\d+)", done.stderr)
    bad = sorted(path.name for path in folder.glob(f"{target}_bad_*"))
    result = {
        "seconds": seconds, "inputs": int(tried.group(1)) if tried else None, "bad": len(bad),
        "branches at first": int(reached[0][0]) if reached else None,
        "branches": int(reached[-1][0]) if reached else None, "status": done.returncode,
    }  # fmt: skip
    if bad or done.returncode:
        print(done.stderr[-3000:], file=sys.stderr)
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=int, default=120)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--target", choices=TARGETS, help=argparse.SUPPRESS)
    parser.add_argument("--only", choices=TARGETS)
    parser.add_argument("--out", type=Path, default=ROOT / "benchmarks/results/fuzzing.json")
    options = parser.parse_args()
    if options.target:
        fuzz(options.target, options.seconds, options.folder)
        return
    from kept import keep, origin

    begun, folder = origin(), options.folder or Path(tempfile.mkdtemp())
    result = {name: told(name, options.seconds, folder) for name in TARGETS if options.only in (None, name)}
    keep(options.out, begun | result)
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
