"""Small runs in which beams soften: python tests/cuda_soft_beams.py gpu|cpu OUT.npz IN HANDED.

See `cuda_halves.py`.
"""

import importlib
from collections.abc import Iterator
from typing import Any

import bondem as bd
import device_cases
from bondem.solve.explicit import integrate
from bondem.solve.plan import ExplicitResult, Plan
from cuda_halves import FIELDS as BROKEN_FIELDS
from cuda_halves import kept, leave, start

DT, STEPS, HALF = 2.5e-3, 36, 19
FIELDS = (*BROKEN_FIELDS, "softened")
SOFT = {"fracture_energy": 1.5e3, "fracture_energy_shear": 3e3}
CRITERIA: dict[str, Any] = {
    "peripheral": bd.PeripheralStress(
        tension=1.5e5, shear=1e5, scatter=bd.Weibull(modulus=6.0, volume=0.3, seed=2), **SOFT
    ),
    "mohr coulomb": bd.MohrCoulomb(tension=6e4, cohesion=5e4, friction_angle=0.5, **SOFT),
}


def softening_bar(criterion: Any) -> bd.Model:
    """The bar of `device_cases`, whose bonds soften."""
    model = device_cases.bar()
    return bd.Model(model.lattice, model.bond, model.density, boundary=model.boundary, failure=criterion)


def softening_cell() -> bd.Model:
    """The periodic cell, whose bonds are alike but for their length."""
    model, failure = device_cases.cell(), bd.PeripheralStress(tension=3e5, shear=2e5, fracture_energy=8e3)
    return bd.Model(model.lattice, model.bond, model.density, failure=failure)


def results(device: str, given: dict[str, Any], handed: dict[str, Any]) -> Iterator[tuple[str, ExplicitResult]]:
    """The cases, carried out."""
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop if device == "gpu" else None

    def go(model: bd.Model, state: bd.State, steps: int = STEPS, **options: Any) -> ExplicitResult:
        return integrate(model, Plan(duration=steps * DT, dt=DT, **options), state=state, loop_of=loop_of)

    common: dict[str, Any] = {"damping": bd.LocalDamping(0.1), "gauges": device_cases.GAUGES}
    for name, criterion in CRITERIA.items():
        model = softening_bar(criterion)
        yield name, go(model, device_cases.moving(model, speed=3.0), every=HALF, **common)
    model = softening_bar(CRITERIA["peripheral"])
    if device_cases.EVERY:
        yield "paused", go(model, device_cases.moving(model, speed=3.0), every=0, save_every=7, **common)
    half = go(model, device_cases.moving(model, speed=3.0), HALF, every=0, **common).state
    handed["soft"] = kept(half.copy(), FIELDS)
    yield "resumed", go(model, half.copy(), every=HALF, **common)
    if given:
        yield "handed", go(model, start(model, given["soft"]), every=HALF, **common)
    half.set_motion(velocity=half.velocity[::-1].copy())
    if device_cases.EVERY:
        yield "stale", go(model, half, HALF + 5, every=1, **common)
    model = softening_cell()
    yield "alike", go(model, device_cases.moving(model, speed=5.0), every=6)


if __name__ == "__main__":
    leave(results, FIELDS)
