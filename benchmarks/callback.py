"""What a Python callback at each output costs: the same run with and without, in turns.

At 10 000 elements the difference drowns in the noise of the machine; with few elements the cost of an output shows.

python benchmarks/callback.py [--elements 10000] [--every 100] [--steps 2000] [--repeat 9] [--threads 1]
"""

import argparse
import json
import statistics
import time

import numpy as np

import bondem as bd
from bondem._compile import threads
from bondem.model.state import State
from bondem.solve.history import History
from static_solve import LAW, cylinder


def main(arguments: list[str] | None = None) -> dict[str, float]:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--elements", type=int, default=10_000)
    parser.add_argument("--every", type=int, default=100)
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--repeat", type=int, default=9)
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args(arguments)
    model = bd.Model(cylinder(options.elements), LAW, density=2700.0)
    start = State(model)
    start.set_motion(velocity=np.random.default_rng(0).standard_normal((len(model.mass), 3)))
    dt = bd.solve_explicit(model, duration=0.0).dt

    seen: list[float] = []

    def look(state: State, record: History) -> None:
        seen.append(float(record.energy["translation"][0]))

    def clock(callback) -> float:
        state = start.copy()
        begun = time.perf_counter()
        bd.solve_explicit(
            model, duration=options.steps * dt, dt=dt, every=options.every, state=state, callback=callback
        )
        return time.perf_counter() - begun

    with threads(options.threads):
        clock(look), clock(None)  # compiled, and warm
        times = [(clock(None), clock(look)) for _ in range(options.repeat)]
    without, within = zip(*times, strict=True)
    outputs = options.steps // options.every + 1
    result = {
        "elements": len(model.mass),
        "steps": options.steps,
        "outputs": outputs,
        "without, min [s]": min(without),
        "with, min [s]": min(within),
        "without, median [s]": statistics.median(without),
        "with, median [s]": statistics.median(within),
        "cost, of the minima [%]": 100.0 * (min(within) / min(without) - 1.0),
        "cost, of the medians [%]": 100.0 * (statistics.median(within) / statistics.median(without) - 1.0),
        "cost, median of the pairs [%]": 100.0 * (statistics.median(b / a for a, b in times) - 1.0),
        "cost of an output, median of the pairs [µs]": 1e6 * statistics.median(b - a for a, b in times) / outputs,
    }
    print(json.dumps({name: round(value, 4) for name, value in result.items()}, indent=2))
    return result


if __name__ == "__main__":
    main()
