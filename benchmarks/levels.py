"""Bits of runs on one level of vector instructions: a SHA-256 per run, to compare with another level or revision.

    BONDEM_ISA=v3 python benchmarks/levels.py --out v3.txt        # on any machine with AVX2
    BONDEM_ISA=v4 python benchmarks/levels.py --against v3.txt    # on one with AVX-512, or in an emulator of one

The runs are the small ones of all kinds with which devices are tested (`tests/device_runs.py`), and those of
`paired_kinds.py` with larger bodies, which have several domains and blocks. `against.py bits` compares two revisions.

Levels with fused multiply-add (v3, v4 and aarch64) should give the same bits; v2 gives others. NumPy and OpenBLAS
prepare the bodies: keep them on the same instructions (NPY_DISABLE_CPU_FEATURES, OPENBLAS_CORETYPE).
"""

import argparse
import hashlib
import importlib
import sys
import warnings
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[1]))  # for the cases of tests

import bondem as bd
from bondem._core import compiled_level
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import ExplicitResult, Plan
from bondem.dynamics.timestep import critical_step
from paired_kinds import KINDS
from tiled import specimen

Run = Callable[[], ExplicitResult]
#: Modules of tests with small runs of all kinds that devices know.
SMALL = ("device_runs", "device_cracks", "device_yielding")
SIZES, STEPS = (500, 3000, 9000), 100


def runs(sizes: list[int]) -> dict[str, Run]:
    """Return all runs by name: small ones, and each of `KINDS` with about so many elements."""
    cases = {module: importlib.import_module(f"tests.{module}").CASES for module in SMALL}
    found: dict[str, Run] = {f"{name}, {module}": partial(_small, make) for module, some in cases.items()
                             for name, make in some.items()}  # fmt: skip
    return found | {f"{name}, {size} elements": partial(_large, name, size) for size in sizes for name in KINDS}


def _small(make: Callable) -> ExplicitResult:
    model, start, steps, dt, options = make()
    return integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=start(model))


_body = cache(specimen)


def _large(name: str, size: int) -> ExplicitResult:
    kind = KINDS[name]
    model = kind.model(_body(size))
    # rounded, so that it does not depend on the last bits of the critical step
    dt = float(f"{kind.share * critical_step(model, bd.VelocityVerlet()):.2g}")
    state = model.state()
    state.set_motion(velocity=kind.speed * np.random.default_rng(0).standard_normal(state.velocity.shape))
    return integrate(model, Plan(duration=(kind.before + STEPS) * dt, dt=dt, every=20), state=state)


def digest(run: ExplicitResult) -> str:
    """Return the SHA-256 of the final state and of the records of a run."""
    parts = {name: getattr(run.state, name) for name in run.state.ARRAYS} | {"records": run.history.records}
    found = hashlib.sha256(run.status.name.encode())
    for name, values in sorted(parts.items()):
        found.update(name.encode() + np.ascontiguousarray(values).tobytes())
    return found.hexdigest()


def main() -> None:
    """Print the digests of runs, and compare them with those of a file."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, nargs="*", default=SIZES, help="of larger bodies [500 3000 9000]")
    parser.add_argument("--threads", type=int, nargs="+", default=[1], help="BONDEM_NUM_THREADS at most [1]")
    parser.add_argument("--runs", default="", help="those alone whose names contain this")
    parser.add_argument("--out", type=Path, help="write the digests here")
    parser.add_argument("--against", type=Path, help="file of another level or revision")
    asked = parser.parse_args()
    warnings.simplefilter("ignore")
    lines = asked.against.read_text().splitlines() if asked.against else []
    known = {name: value for value, _, name in (line.partition(" ") for line in lines)}
    found, unlike = {}, 0
    for name, run in runs(asked.elements).items():
        for count in asked.threads if asked.runs in name else ():
            bd.set_threads(count)
            key = f"{name}, threads: {count}"
            found[key] = digest(run())
            verdict = "" if key not in known else "same" if known[key] == found[key] else "DIFFERS"
            unlike += verdict == "DIFFERS"
            print(compiled_level(), found[key][:16], key, verdict, flush=True)
    if asked.out:
        asked.out.write_text("".join(f"{value} {key}\n" for key, value in found.items()))
    compared = len(found.keys() & known.keys())
    if asked.against:
        print(f"{compared - unlike} of {compared} runs have the same bits")
    sys.exit(1 if unlike or (asked.against and not compared) else 0)


if __name__ == "__main__":
    main()
