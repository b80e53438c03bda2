"""Bond-steps per second by number of elements and of threads, and the share of what this machine can do at most.

    python benchmarks/scaling.py [--elements 1000 ... 1000000] [--threads 1 2 ...] [--repeat 5] [--figure FILE]

The bound is a roofline: the least time for the bytes of a step at the bandwidth of a sum over as many bytes, or for
its flops at the peak of a product of matrices, whichever is longer, both measured in the same run on the same
threads. How bytes and flops are counted is printed, and stated in roofline.py. Do it on a machine that is
doing nothing else.
"""

import argparse
import statistics
import time
from pathlib import Path

import numpy as np

import bondem as bd
from bondem._threads import most_threads, threads
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from kept import RESULTS, keep, origin
from roofline import bandwidth, bytes_per_bond, flops_per_bond, peak, state_bytes_per_element
from tiled import specimen

# Bond-steps of one timed run and thread.
WORK = 20_000_000


def measured(model: bd.Model, state: State, dt: float, counts: list[int], repeat: int, work: int) -> dict[int, dict]:
    """Seconds a step by number of threads, which take turns."""
    bonds = len(model.layout.i)
    seconds: dict[int, list[float]] = {count: [] for count in counts}
    for turn in range(repeat + 1):
        for count in counts:
            steps = max(5, work * count // bonds) if turn else 2
            with threads(count):
                plan = Plan(duration=(state.step + steps) * dt, dt=dt, every=0)
                start = time.perf_counter()
                state = integrate(model, plan, state=state).state
                if turn:  # the first one warms up
                    seconds[count].append((time.perf_counter() - start) / steps)
    return {count: {"best": min(found), "median": statistics.median(found)} for count, found in seconds.items()}


def size(elements: int, counts: list[int], peaks: dict[int, float], repeat: int, work: int) -> dict:
    """All there is to say of one size; a line printed for each number of threads."""
    lattice = specimen(elements)
    law = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
    # the stiffest corner is in the packing that is repeated: a small lattice has the same critical step
    dt = 0.5 * critical_step(bd.Model(specimen(min(elements, 20_000)), law, 2500.0), bd.VelocityVerlet())
    model = bd.Model(lattice, law, 2500.0)
    state = State(model)
    n, m = len(lattice.particles), len(lattice.pairs)
    state.set_motion(velocity=0.1 * np.random.default_rng(0).standard_normal((n, 3)))
    traffic, flops = bytes_per_bond(model, state), flops_per_bond(n / m)
    found = measured(model, state, dt, counts, repeat, work)
    assert np.isfinite(state.velocity).all()
    # half of the traffic of elements is the way back
    footprint = m * (traffic["all"] - traffic["poses, motions and sums of elements, read and written"] / 2)
    rows = []
    for count in counts:
        with threads(count):
            speed = bandwidth(footprint, count)
        by_memory, by_arithmetic = traffic["all"] / speed, flops["all"] / peaks[count]
        rate = {name: m / value / 1e6 for name, value in found[count].items()}
        bound = 1e-6 / max(by_memory, by_arithmetic)
        rows.append({
            "threads": count,
            "Mbond_steps_per_s_best": rate["best"],
            "Mbond_steps_per_s_median": rate["median"],
            "speed_up": found[counts[0]]["median"] / found[count]["median"],
            "sum_GB_per_s": speed / 1e9,
            "peak_Gflop_per_s": peaks[count] / 1e9,
            "bound_by": "memory" if by_memory > by_arithmetic else "arithmetic",
            "bound_Mbond_steps_per_s": bound,
            "share_of_bound": rate["median"] / bound,
        })  # fmt: skip
        row = rows[-1]
        print(
            f"{n:>9} {m:>9} {count:>4} {rate['best']:8.1f} {rate['median']:8.1f} {1e3 / rate['median']:7.1f}"
            f" {row['speed_up']:7.2f}   {row['sum_GB_per_s']:8.1f} {row['peak_Gflop_per_s']:8.1f}"
            f" {bound:9.1f} {row['bound_by']:>10} {row['share_of_bound']:6.0%}",
            flush=True,
        )
    return {
        "elements": n, "bonds": m, "bytes_per_bond": traffic, "flops_per_bond": flops,
        "state_bytes_per_element": state_bytes_per_element(model, state), "threads": rows,
    }  # fmt: skip


def draw(report: dict, path: Path) -> None:
    """Rates over the number of elements, and their bounds dashed."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6, 4), layout="constrained")
    axes = figure.add_subplot(xlabel="elements", ylabel="million bond-steps per second", xscale="log")
    for k in range(len(report["sizes"][0]["threads"])):
        rows = [one["threads"][k] for one in report["sizes"]]
        elements = [one["elements"] for one in report["sizes"]]
        axes.plot(elements, [row["Mbond_steps_per_s_median"] for row in rows], "o-", color=f"C{k}",
                  label=f"{rows[0]['threads']} thread(s)")  # fmt: skip
        axes.plot(elements, [row["bound_Mbond_steps_per_s"] for row in rows], "--", color=f"C{k}")
    axes.set_ylim(bottom=0)
    axes.legend(title="dashed: bound of the machine")
    figure.savefig(path, dpi=150)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, nargs="+", default=[1000, 10_000, 100_000, 1_000_000])
    parser.add_argument("--threads", type=int, nargs="+", default=sorted({1, min(2, most_threads()), most_threads()}))
    parser.add_argument("--repeat", type=int, default=5, help="timed runs of each, in turns [5]")
    parser.add_argument("--work", type=int, default=WORK, help="bond-steps of a timed run and thread [2e7]")
    parser.add_argument("--figure", type=Path, help="draw it into this file")
    parser.add_argument("--output", type=Path, default=RESULTS / "scaling.json")
    options = parser.parse_args()
    report: dict = {**origin(), "sizes": []}
    print(f"{report['machine']}, bondem {bd.__version__}; best and median of {options.repeat} runs")
    peaks = {}
    for count in options.threads:
        with threads(count):
            peaks[count] = peak(count)
    print(
        f"{'elements':>9} {'bonds':>9} {'thr.':>4} {'Mbond/s':>8} {'median':>8} {'ns/bond':>7} {'speedup':>7}  "
        f" {'sum GB/s':>8} {'Gflop/s':>8} {'bound':>7} {'by':>10} {'share':>6}"
    )
    for elements in options.elements:
        report["sizes"].append(size(elements, options.threads, peaks, options.repeat, options.work))
        keep(options.output, report)
    last = report["sizes"][-1]
    for unit in ("bytes", "flops"):
        parts = last[f"{unit}_per_bond"]
        print(f"{unit} per bond: " + ", ".join(f"{name} {value:.0f}" for name, value in parts.items()))
    print("each array counts once a step, and twice if it is written back; a root, division or rounding is a flop")
    print(f"memory per element: {last['state_bytes_per_element']:.0f} bytes of state, constants, indices and sums")
    if options.figure:
        draw(report, options.figure)


if __name__ == "__main__":
    main()
