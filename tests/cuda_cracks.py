"""Small runs in which facets crack: python tests/cuda_cracks.py gpu|cpu OUT.npz BODIES IN HANDED.

The device takes the bodies that the CPU has cut, and both sides leave the
states of half a run in HANDED and go on with those in IN, if it is there.
"""

import importlib
from collections.abc import Iterator
from typing import Any

import bondem as bd
import device_cases
from bondem.solve.explicit import integrate
from bondem.solve.plan import ExplicitResult, Plan
from cuda_halves import kept, leave_cells, start

# A facet begins to crack in the step after half a run, so that a state must keep what it is judged by.
DT, STEPS, HALF = 8e-4, 80, 37
FIELDS = (
    "pose", "motion", "acceleration", "loss", "work", "reaction", "integrity", "released", "broken", "cracks",
    "facet_force",
)  # fmt: skip
SOFT = {"tension": 2.5e5, "fracture_energy": 8e3, "friction": 0.5}


def torn(failure: Any) -> bd.Model:
    """A bar that is torn, sheared and pressed together again between two walls, with loads on two faces."""
    boundary = [
        bd.Fix(bd.Face("x_min")),
        bd.Drive(
            bd.Face("x_max"), x=bd.Table([0.0, 0.025, 0.064], [0.0, 0.25, -0.1]), y=bd.Ramp(0.0, 0.15, 0.05),
        ),
        bd.Load(bd.Face("y_max"), force=(0.0, 3e4, 1e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Pressure(bd.Face("z_max"), 2e4, schedule=bd.Ramp(1.0, 0.0, 0.03)),
    ]  # fmt: skip
    body = device_cases.body(3, 2, 2)
    return bd.Model(body, bd.CellBond(E=1e7, nu=0.3), 1000.0, boundary=boundary, failure=failure)


def flying(failure: Any) -> tuple[bd.Model, bd.State]:
    """A periodic body whose cells fly apart and against each other."""
    body = device_cases.body(3, 3, 3, periodic=True)
    model = bd.Model(body, bd.CellBond(E=1e7, nu=0.2), 1000.0, failure=failure)
    return model, device_cases.moving(model, speed=8.0)


def results(device: str, given: dict[str, Any], handed: dict[str, Any]) -> Iterator[tuple[str, ExplicitResult]]:
    """The cases, carried out."""
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop if device == "gpu" else None

    def go(model: bd.Model, state: bd.State, steps: int, dt: float = DT, **options: Any) -> ExplicitResult:
        return integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=state, loop_of=loop_of)

    common: dict[str, Any] = {"damping": bd.LocalDamping(0.1), "gauges": device_cases.CELL_GAUGES}
    scatter = bd.Weibull(modulus=8.0, volume=0.5, seed=3)
    model = torn(bd.Rankine(**SOFT, scatter=scatter))
    yield "soft", go(model, device_cases.moving(model), STEPS, every=HALF, **common)
    if device_cases.EVERY:
        yield "paused", go(model, device_cases.moving(model), STEPS, every=0, save_every=17, **common)
    half = go(model, device_cases.moving(model), HALF, every=0, **common).state
    handed["soft"] = kept(half.copy(), FIELDS)
    yield "resumed", go(model, half.copy(), STEPS, every=HALF, **common)
    if given:
        yield "handed", go(model, start(model, given["soft"]), STEPS, every=HALF, **common)
    half.set_motion(velocity=half.velocity[::-1].copy())
    if device_cases.EVERY:
        yield "stale", go(model, half, HALF + 5, every=1, **common)
    brittle = torn(bd.Rankine(tension=6e5, friction=0.3))
    scheme = bd.TchamwaWielgosz(1.2)
    yield "brittle", go(brittle, device_cases.moving(brittle), 60, 2e-3, every=10, scheme=scheme)
    yield "flying", go(*flying(bd.Rankine(tension=2.5e5, fracture_energy=8e3, friction=0.4)), 30, 1.6e-3, every=5)


if __name__ == "__main__":
    leave_cells(results, FIELDS)
