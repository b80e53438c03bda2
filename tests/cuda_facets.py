"""Small runs in which facets break at once: python tests/cuda_facets.py gpu|cpu OUT.npz BODIES IN HANDED.

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
from cuda_halves import FIELDS, kept, leave_cells, start

DT, STEPS, HALF = 1e-3, 24, 14


def mohr_coulomb(strength: float, **options: Any) -> bd.MohrCoulomb:
    """Of a tension and a cohesion that is twice that."""
    return bd.MohrCoulomb(tension=strength, cohesion=2.0 * strength, friction_angle=0.5, **options)


def breaking(model: bd.Model, failure: Any) -> bd.Model:
    """A model of `device_cases` whose facets break."""
    return bd.Model(model.lattice, model.bond, model.density, boundary=model.boundary, failure=failure)


def held_bar() -> bd.Model:
    """That between walls, of facets whose strengths scatter."""
    scatter = bd.Weibull(modulus=6.0, volume=0.3, seed=2)
    return breaking(device_cases.held_bar(), mohr_coulomb(2e5, scatter=scatter))


def results(device: str, given: dict[str, Any], handed: dict[str, Any]) -> Iterator[tuple[str, ExplicitResult]]:
    """The cases, carried out."""
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop if device == "gpu" else None

    def go(model: bd.Model, state: bd.State, steps: int = STEPS, dt: float = DT, **options: Any) -> ExplicitResult:
        return integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=state, loop_of=loop_of)

    common: dict[str, Any] = {"damping": bd.LocalDamping(0.1), "gauges": device_cases.CELL_GAUGES}
    held = held_bar()
    yield "held", go(held, device_cases.moving(held), every=6, **common)
    if device_cases.EVERY:
        yield "paused", go(held, device_cases.moving(held), every=0, save_every=5, **common)
    half = go(held, device_cases.moving(held), HALF, every=0, **common).state
    handed["held"] = kept(half, FIELDS)
    yield "resumed", go(held, half.copy(), every=6, **common)
    if given:
        yield "handed", go(held, start(held, given["held"]), every=6, **common)
    scheme = bd.TchamwaWielgosz(1.2)
    pressed = breaking(device_cases.pressed_bar(), mohr_coulomb(2.5e4))
    yield "pressed", go(pressed, device_cases.moving(pressed), dt=8e-4, scheme=scheme, every=5)
    body = device_cases.body(3, 3, 3, periodic=True)
    flying = bd.Model(body, bd.CellBond(E=1e7, nu=0.2), 1000.0, failure=mohr_coulomb(4e4))
    yield "flying", go(flying, device_cases.moving(flying, speed=1.5), every=3)


if __name__ == "__main__":
    leave_cells(results, FIELDS)
