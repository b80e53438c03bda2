"""Bits of runs on one level of vector instructions: a SHA-256 per case of `bits/`, to compare with another level.

BONDEM_ISA=v3 python benchmarks/levels.py --out v3.txt        # on any machine with AVX2
BONDEM_ISA=v4 python benchmarks/levels.py --against v3.txt    # on one with AVX-512, or in an emulator of one

Levels with fused multiply-add (v3, v4 and aarch64) should give the same bits; v2 gives others. NumPy and OpenBLAS
prepare the bodies: keep them on the same instructions (NPY_DISABLE_CPU_FEATURES, OPENBLAS_CORETYPE).
"""

import argparse
import hashlib
import sys
from pathlib import Path

from bits.bodies import ALL
from bits.case import set_threads
from bits.runs import arrays, explicit
from bondem._core import compiled_level


def bits_of(name: str, size: int, steps: int) -> str:
    """Return the SHA-256 of the results of a case: its final state, and its records every 20 steps."""
    case = ALL[name](size)
    dt = explicit(case.model, case, duration=0.0, safety=case.share, every=0).dt
    result = explicit(case.model, case, duration=steps * dt, dt=dt, every=20, state=case.start(dt))
    digest = hashlib.sha256()
    for key, value in sorted(arrays(result).items()):
        digest.update(key.encode() + value.tobytes())
    return digest.hexdigest()


def main() -> None:
    """Print the digests of cases, and compare them with those of a file."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--size", type=int, default=60, help="elements: 60, 500, 3000 or 9000")
    options.add_argument("--steps", type=int, default=100)
    options.add_argument("--cases", nargs="+", default=list(ALL), choices=list(ALL), metavar="CASE")
    options.add_argument("--out", type=Path, help="write the digests here")
    options.add_argument("--against", type=Path, help="file of another level")
    asked = options.parse_args()
    set_threads(1)
    known = dict(line.split() for line in asked.against.read_text().splitlines()) if asked.against else {}
    found, unlike = {}, []
    for name in asked.cases:
        key = f"{name}-{asked.size}-{asked.steps}"
        found[key] = bits_of(name, asked.size, asked.steps)
        same = known.get(key, found[key]) == found[key]
        unlike += [] if same else [name]
        verdict = "" if key not in known else "same" if same else "DIFFERS"
        print(compiled_level(), key, found[key][:16], verdict, flush=True)
    if asked.out:
        asked.out.write_text("".join(f"{key} {digest}\n" for key, digest in found.items()))
    if known:
        compared = sum(key in known for key in found)
        print(f"{compared - len(unlike)} of {compared} cases have the same bits")
    sys.exit(1 if unlike or (known and not compared) else 0)


if __name__ == "__main__":
    main()
