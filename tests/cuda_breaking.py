"""Small runs in which bonds break: python tests/cuda_breaking.py gpu|cpu OUT.npz IN HANDED, as `device_cases.py`.

Both sides leave the states of half a run in HANDED and go on with those in IN, if it is there, so that a run can
change sides.
"""

import importlib
from collections.abc import Iterator
from typing import Any

import bondem as bd
import device_cases
from bondem.solve.explicit import integrate
from bondem.solve.plan import ExplicitResult, Plan
from cuda_halves import kept, leave, start

CRITERIA: dict[str, Any] = {
    "peripheral": bd.PeripheralStress(tension=1.5e5, shear=1e5, scatter=bd.Weibull(modulus=6.0, volume=0.3, seed=2)),
    "mohr coulomb": bd.MohrCoulomb(tension=6e4, cohesion=5e4, friction_angle=0.5),
    "linear": bd.LinearSum(force=1.5e4, shear=1.5e4, bending=5e3, twisting=5e3, scatter=bd.Normal(deviation=0.1)),
    "elliptic": bd.Elliptic(elongation=0.011, rotation=0.04),
}
DT, STEPS, HALF = 2e-3, 30, 17
FIELDS = "pose", "motion", "acceleration", "loss", "work", "reaction", "integrity", "released", "broken"


def breaking_bar(criterion: Any) -> bd.Model:
    """The bar of `device_cases`, whose bonds break."""
    model = device_cases.bar()
    return bd.Model(model.lattice, model.bond, model.density, boundary=model.boundary, failure=criterion)


def breaking_cell() -> bd.Model:
    """The periodic cell, whose bonds are alike but for their length."""
    model = device_cases.cell()
    return bd.Model(model.lattice, model.bond, model.density, failure=bd.PeripheralStress(tension=4e5, shear=2e5))


def results(device: str, given: dict[str, Any], handed: dict[str, Any]) -> Iterator[tuple[str, ExplicitResult]]:
    """The cases, carried out."""
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop if device == "gpu" else None

    def go(model: bd.Model, state: bd.State, steps: int = STEPS, **options: Any) -> ExplicitResult:
        plan = Plan(duration=steps * DT, dt=DT, **options)
        return integrate(model, plan, state=state, loop_of=loop_of)

    common: dict[str, Any] = {"damping": bd.LocalDamping(0.1), "gauges": device_cases.GAUGES}
    for name, criterion in CRITERIA.items():
        model = breaking_bar(criterion)
        yield name, go(model, device_cases.moving(model), every=5, **common)
    model = breaking_bar(CRITERIA["peripheral"])
    if device_cases.EVERY:
        yield "paused", go(model, device_cases.moving(model), every=0, save_every=7, **common)
    scheme = bd.TchamwaWielgosz(1.2)
    yield "dissipative", go(model, device_cases.moving(model), every=5, scheme=scheme)
    model = breaking_cell()
    yield "alike", go(model, device_cases.moving(model, speed=1.2), every=5)
    model = breaking_bar(CRITERIA["peripheral"])
    half = go(model, device_cases.moving(model), HALF, every=0, **common).state
    handed["beams"] = kept(half, FIELDS)
    yield "resumed", go(model, half.copy(), every=5, **common)
    if given:
        yield "handed", go(model, start(model, given["beams"]), every=5, **common)


if __name__ == "__main__":
    leave(results, FIELDS)
