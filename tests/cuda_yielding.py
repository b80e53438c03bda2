"""Small runs in which cells yield and criteria of the stress crack facets: python tests/cuda_yielding.py gpu|cpu …

As `cuda_cracks.py`, from whose bodies and arguments they are made.
"""

import importlib
from collections.abc import Iterator
from typing import Any

import bondem as bd
import device_cases
from bondem.solve.explicit import integrate
from bondem.solve.plan import ExplicitResult, Plan
from cuda_cracks import FIELDS, SOFT, torn
from cuda_halves import kept, leave_cells, start

DT, STEPS, HALF = 1.6e-3, 32, 17
COULOMB = bd.MohrCoulomb(
    tension=2.5e5, cohesion=3e5, friction_angle=0.4, fracture_energy=8e3, fracture_energy_shear=2e4, dilatancy=0.2
)
CONE = bd.DruckerPrager(
    tension=2.5e5, compression=8e5, fracture_energy=8e3, fracture_energy_shear=2e4, dilatancy=0.1, friction=0.3
)


def squeezed(failure: Any) -> bd.Model:
    """A bar that is pressed, sheared and pulled again between two walls, with loads that change on two faces."""
    boundary = [
        bd.Fix(bd.Face("x_min")),
        bd.Drive(
            bd.Face("x_max"), x=bd.Table([0.0, 0.022, 0.05], [0.0, -0.25, 0.2]), y=bd.Ramp(0.0, 0.15, 0.03),
        ),
        bd.Load(bd.Face("y_max"), force=(0.0, 6e4, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Pressure(bd.Face("z_max"), 4e4, schedule=bd.Ramp(1.0, 0.0, 0.03)),
    ]  # fmt: skip
    body = device_cases.body(3, 2, 2)
    return bd.Model(body, bd.CellBond(E=1e7, nu=0.3), 1000.0, boundary=boundary, failure=failure)


def largest_sum(stress: Any, tension: float, share: float) -> float:
    """A criterion of one's own: the mean stress and the shear of the x and y axes, over a strength."""
    return (stress[0, 0] + stress[1, 1] + stress[2, 2] + share * abs(stress[0, 1])) / tension


def results(device: str, given: dict[str, Any], handed: dict[str, Any]) -> Iterator[tuple[str, ExplicitResult]]:
    """The cases, carried out."""
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop if device == "gpu" else None

    def go(model: bd.Model, state: bd.State, steps: int = STEPS, dt: float = DT, **options: Any) -> ExplicitResult:
        return integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=state, loop_of=loop_of)

    common: dict[str, Any] = {"damping": bd.LocalDamping(0.1), "gauges": device_cases.CELL_GAUGES}
    fields = (*FIELDS, "plastic")
    for name, failure in (("coulomb", COULOMB), ("cone", CONE)):
        model = squeezed(failure)
        yield name, go(model, device_cases.moving(model), every=HALF, **common)
    model = squeezed(COULOMB)
    half = go(model, device_cases.moving(model), HALF, every=0, **common).state
    handed["coulomb"] = kept(half.copy(), fields)
    yield "resumed", go(model, half, every=HALF, **common)
    if given:
        yield "handed", go(model, start(model, given["coulomb"]), every=HALF, **common)
    if device_cases.EVERY:
        yield "paused", go(model, device_cases.moving(model), every=0, save_every=9, **common)
    own = bd.StressCriterion(largest_sum, tension=2.5e5, share=0.7, fracture_energy=SOFT["fracture_energy"])
    model = squeezed(own)
    yield "own", go(model, device_cases.moving(model), every=8)
    model = squeezed(bd.DruckerPrager(tension=1e5, compression=4e5))
    yield "pressed cone", go(model, device_cases.moving(model), steps=14, every=0)
    model = torn(bd.DruckerPrager(tension=1e5, compression=4e5))
    yield "brittle cone", go(model, device_cases.moving(model), steps=40, dt=2.2e-3, every=8)


if __name__ == "__main__":
    leave_cells(results, (*FIELDS, "plastic"))
