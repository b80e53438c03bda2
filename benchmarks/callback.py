"""Cost of a Python callback at each output: the same run with and without it, in turns.

With 10 000 elements the difference is less than the noise of the machine, so that the cost of an output is measured
with few elements. The recorded share is this cost over the time of the steps between two outputs with many elements.
Times are processor seconds, which on one thread do not depend on other work of the machine.

python benchmarks/callback.py [--elements 10000] [--few 300] [--every 100] [--steps 2000] [--repeat 9]
"""

import json
import statistics
import time

import numpy as np

import bondem as bd
from bondem._threads import threads
from bondem.dynamics.history import History
from bondem.model.state import State
from kept import Record, run, spread
from static_solve import LAW
from validation.measures.jittered_cylinder import cylinder


def compared(elements: int, every: int, steps: int, repeat: int) -> dict:
    """Measure runs with and without a callback; return their seconds, and the cost of an output (median of pairs)."""
    model = bd.Model(cylinder(elements), LAW, density=2700.0)
    start = State(model)
    start.set_motion(velocity=np.random.default_rng(0).standard_normal((len(model.mass), 3)))
    dt = bd.solve_explicit(model, duration=0.0).dt
    seen: list[float] = []

    def look(state: State, record: History) -> None:
        seen.append(float(record.energy["translation"][0]))

    def clock(callback) -> float:
        state = start.copy()
        begun = time.process_time()
        bd.solve_explicit(model, duration=steps * dt, dt=dt, every=every, state=state, callback=callback)
        return time.process_time() - begun

    clock(look), clock(None)  # compiled, and warm
    times = [(clock(None), clock(look)) for _ in range(repeat)]
    without, within = zip(*times, strict=True)
    outputs = steps // every + 1
    return {
        "elements": len(model.mass),
        "steps": steps,
        "outputs": outputs,
        "without [s]": spread(without),
        "with [s]": spread(within),
        "cost, median of the pairs [-]": statistics.median(b / a for a, b in times) - 1.0,
        "cost of an output, median of the pairs [s]": statistics.median(b - a for a, b in times) / outputs,
    }


def measure(
    record: Record, *, elements: int = 10_000, few: int = 300, every: int = 100, steps: int = 2000, repeat: int = 9,
    thread_count: int = 1,
) -> None:  # fmt: skip
    with threads(thread_count):
        small, many = (compared(count, every, steps, repeat) for count in (few, elements))
    between = many["without [s]"]["median"] * every / steps
    share = small["cost of an output, median of the pairs [s]"] / between
    result = {"threads": thread_count, "every": every, "few": small, "many": many,
              "share of an output in the steps between two": share}  # fmt: skip
    record.keep(**result)
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    run()
