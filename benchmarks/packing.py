"""Time to a packing, against spheropack (PyPI; event-driven Lubachevsky-Stillinger in C++), in one run.

The request: monodisperse spheres in a periodic cube up to a volume fraction, and until they jam.

    pip install spheropack && python benchmarks/packing.py 10000
"""

import sys
import time

import spheropack

import bondem as bd

CELL = bd.Cell((1.0, 1.0, 1.0))


def seconds(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def main(count):
    for method in ("quench", "growth", "compression"):  # compile outside the timing
        bd.pack(CELL, count=2500, method=method, volume_fraction=0.5, cache=False)
    requests = (("volume fraction 0.60", {"volume_fraction": 0.60}, 0.60), ("jamming", {"jamming": True}, "max"))
    for name, target, density in requests:
        theirs = seconds(lambda density=density: spheropack.pack(n=count, density=density, seed=1))
        print(f"{count} spheres, {name}: spheropack {theirs:.2f} s", flush=True)
        for method in ("quench", "growth", "compression"):
            ours = seconds(lambda m=method, t=target: bd.pack(CELL, count=count, seed=1, method=m, cache=False, **t))
            print(f"    {method}: {ours:.2f} s, ratio {theirs / ours:.2f}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
