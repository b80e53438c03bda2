"""Free vibration of a clamped specimen after a slow ramp of its loads (André et al. 2012)."""

import numpy as np

import bondem as bd
from bondem.dynamics.plan import settled
from bondem.errors import InputError
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.beam_tests import CrossSection
from bondem.labtests.vibration import RECORD_INTERVAL, combined_load, end_gauges, recorded_vibration

# Depth of both faces in mean radii [-], and the approximate final stress of each load [Pa].
_DEPTH, _STRESS = 0.02, 1e5


def ramped_vibration(
    lattice: bd.Lattice,
    law: AnyLaw,
    *,
    density: float,
    steps: int = 50_000,
    ramp: float = 0.4,
    safety: float = 0.9,
) -> bd.labtests.FreeVibration:
    """Load a clamped specimen gradually, release it and record the whole motion, as in the paper.

    The loads are those of `free_vibration`. They increase from zero and are removed within one step.

    Args:
        lattice: the specimen.
        law: bond law, cell law or non-local law of the specimen.
        density: density of the elements, ρ_μ [kg/m³].
        steps: number of steps.
        ramp: share of the steps in which the loads increase [-].
        safety: time step over the critical time step [-].

    Raises:
        InputError: fewer than 1000 steps, or a ramp that leaves no steps for the vibration.
    """
    if steps < 1000:
        raise InputError(f"steps = {steps}: too few for a few oscillations; give at least 1000")
    growing = round(ramp * steps / RECORD_INTERVAL) * RECORD_INTERVAL
    if not 0 < growing < steps:
        raise InputError(f"ramp = {ramp}: not in (0, 1); give the share of the steps in which the loads increase")
    held = bd.Fix(bd.Face("x_min", _DEPTH))
    model = bd.Model(lattice, law, density=density, boundary=[held])
    dt = settled(model, bd.Plan(duration=0.0, safety=safety)).dt
    assert dt is not None
    released = growing * dt
    section = CrossSection.of(lattice.particles.envelope)
    load = combined_load(section, stress=_STRESS, depth=_DEPTH, schedule=bd.Ramp(0.0, 1.0, released))
    loaded = bd.solve_explicit(
        model.with_boundary([held, load]), duration=released, dt=dt, gauges=end_gauges(_DEPTH), every=RECORD_INTERVAL
    )
    energy = float(loaded.history.energy["work"][-1])
    before = recorded_vibration(loaded, 0.0, energy)
    # a run of its own: the kick that closes its last step is the load's, the one that opens the next is not
    free = bd.solve_explicit(
        model, duration=(steps - growing) * dt, dt=dt, gauges=end_gauges(_DEPTH), every=RECORD_INTERVAL,
        state=loaded.state,
    )  # fmt: skip
    return _joined(before, recorded_vibration(free, released, energy))


def _joined(before: bd.labtests.FreeVibration, after: bd.labtests.FreeVibration) -> bd.labtests.FreeVibration:
    """Join two runs, without the first record of the second, which equals the last record of the first."""
    carried = {name: before.energy[name][-1] for name in ("work", "loss", "friction", "balance")}
    energy = {
        name: np.concatenate([values, after.energy[name][1:] + carried.get(name, 0.0)])
        for name, values in before.energy.items()
    }
    return bd.labtests.FreeVibration(
        time=np.concatenate([before.time, after.time[1:]]),
        signal={kind: np.concatenate([values, after.signal[kind][1:]]) for kind, values in before.signal.items()},
        energy=energy,
        energy_error=float(np.abs(energy["balance"]).max() / energy["work"].max()),
        dt=before.dt,
        steps=before.steps + after.steps,
        released=after.released,
    )
