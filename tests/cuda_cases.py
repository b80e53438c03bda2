"""Small runs for the CPU and for the simulator of CUDA devices: python tests/cuda_cases.py gpu|cpu OUT.npz.

In a process of its own, because the simulator must be chosen before anything is imported.
"""

import importlib
import sys
from collections.abc import Iterator

import numpy as np

import bondem as bd
from bondem.model.state import State
from bondem.solve.explicit import integrate
from bondem.solve.plan import ExplicitResult, Plan

GAUGES = {
    "end": bd.Gauge(bd.Face("x_max", depth=0.5), "displacement"),
    "grip": bd.Gauge(bd.Face("x_min", depth=0.5), "force", "sum"),
    "fastest": bd.Gauge(bd.Everything(), "velocity", "max_abs"),
    "turned": bd.Gauge(bd.Everything(), "rotation"),
    "spin": bd.Gauge(bd.Everything(), "angular_velocity", "sum"),
}


def bar() -> bd.Model:
    """A crooked bar of 4 × 3 × 3, held at one end, loaded twice by ramps at the other and driven in the middle."""
    rng = np.random.default_rng(1)
    grid = np.indices((4, 3, 3)).reshape(3, -1).T.astype(float)
    lattice = bd.connect(
        bd.Particles(grid + rng.uniform(-0.1, 0.1, grid.shape), rng.uniform(0.3, 0.4, len(grid))), reach=2.0
    )
    law = bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6)
    boundary = [
        bd.Fix(bd.Face("x_min", depth=0.5)),
        bd.Drive(bd.Index([len(grid) // 2]), vy=bd.Ramp(0.0, 0.4, 0.05), rx=bd.Ramp(0.0, 0.1, 0.03)),
        bd.Load(bd.Face("x_max", depth=0.5), force=(3e4, -1e4, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Load(bd.Index([len(grid) - 1, 2]), force=(0.0, 1e4, 0.0), moment=(1e3, 0.0, 0.0)),
    ]
    return bd.Model(lattice, law, density=rng.uniform(900.0, 1100.0, len(grid)), boundary=boundary)


def cell() -> bd.Model:
    """27 elements in a periodic cell, with bonds that are alike but for their length."""
    rng = np.random.default_rng(2)
    grid = np.indices((3, 3, 3)).reshape(3, -1).T.astype(float)
    particles = bd.Particles(grid + rng.uniform(-0.1, 0.1, grid.shape), np.full(27, 0.5), period=(3.0, 3.0, 3.0))
    return bd.Model(bd.connect(particles, reach=1.15), bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6), 1000.0)


def moving(model: bd.Model, speed: float = 0.5) -> State:
    """A state in which all velocities have a sign: at rest, rounding would choose that of local damping."""
    rng = np.random.default_rng(7)
    n = len(model.lattice.particles)
    state = State(model)
    state.set_motion(velocity=rng.uniform(-speed, speed, (n, 3)), angular_velocity=rng.uniform(-speed, speed, (n, 3)))
    return state


def results(device: str) -> Iterator[tuple[str, ExplicitResult]]:
    """The cases, carried out."""
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop if device == "gpu" else None

    def go(model: bd.Model, state: State, steps: int, dt: float, **options) -> ExplicitResult:
        return integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=state, loop_of=loop_of)

    damped = bd.LocalDamping(0.1)
    model = bar()
    yield "bar", go(model, moving(model), 36, 2e-3, damping=damped, gauges=GAUGES, every=6)
    yield "paused", go(model, moving(model), 36, 2e-3, damping=damped, gauges=GAUGES, every=0, save_every=17)
    scheme = bd.TchamwaWielgosz(1.2)
    yield "dissipative", go(model, moving(model), 24, 2e-3, scheme=scheme, gauges=GAUGES, every=5)
    model = cell()
    state = moving(model)
    state.set_eigenstrain(1e-3 * np.random.default_rng(3).standard_normal(len(model.lattice.pairs)))
    yield "cell", go(model, state, 36, 2e-3, every=6)
    yield "wild", go(model, moving(model, speed=300.0), 12, 2e-3, every=3)


def main() -> None:
    device, out = sys.argv[1:]
    arrays = {}
    for name, result in results(device):
        for field in ("pose", "motion", "acceleration", "loss", "work", "reaction"):
            arrays[f"{name}/{field}"] = getattr(result.state, field)
        arrays[f"{name}/records"] = result.history.records
        arrays[f"{name}/end"] = np.array([result.status.name, result.message])
    np.savez(out, **arrays)


if __name__ == "__main__":
    main()
