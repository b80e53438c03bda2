"""Free vibration of a clamped specimen after its loads are let go."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from bondem._drawing import Plotted
from bondem._progress import staged
from bondem._types import Floats
from bondem.errors import InputError, UnstableRunError
from bondem.labtests.arguments import AnyLaw, check
from bondem.labtests.beams import CrossSection
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.frequency import dominant_frequency
from bondem.model.boundary import Fix, Load
from bondem.model.gauges import Gauge
from bondem.model.model import Model
from bondem.model.schedules import Constant, Ramp, Schedule
from bondem.model.state import State
from bondem.run import solve_explicit
from bondem.solve.plan import ExplicitResult, Plan, settled
from bondem.solve.static import solve_static
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face

# Steps between records: a wave crosses less than an element radius a step, so no first mode has fewer than a
# dozen samples a period.
_EVERY = 8
_AT_ONCE = Constant(1.0)


@dataclass(frozen=True, eq=False)
class FreeVibration(Plotted):
    """Motion of the face x_max after release.

    Attributes:
        time: [s], (s,).
        signal: mean displacement along x ("tension") and y ("bending") [m] and mean rotation about x
            ("torsion") [rad] of the elements at x_max, each (s,).
        energy: ledger of the run, `History.energy` [J], each (s,).
        energy_error: largest imbalance of the energy ledger over the energy at release [-].
        dt: time step [s].
        steps: taken.
        released: when the loads went [s]; before, where the run begins at rest, they grew.
    """

    time: Floats
    signal: Mapping[str, Floats]
    energy: Mapping[str, Floats]
    energy_error: float
    dt: float
    steps: int
    released: float = 0.0

    @property
    def free(self) -> slice:
        """The records after release."""
        return slice(int(np.argmax(self.time >= self.released * (1.0 - 1e-9))), len(self.time))

    def frequency(self, kind: str) -> float:
        """Frequency of one signal [Hz], over as many of its own periods as were recorded after release."""
        return dominant_frequency(self.time[self.free], self.signal[kind][self.free])


@staged("free vibration")
def free_vibration(
    lattice: Lattice,
    law: AnyLaw,
    *,
    density: float,
    E: float,
    nu: float,
    rho: float,
    periods: float = 3.0,
    stress: float = 1e5,
    depth: float = 0.02,
) -> FreeVibration:
    """Load a clamped specimen, let go, and record how it swings.

    The run starts at rest from the static equilibrium under an axial force, a transverse force and a moment
    about x at once, the limit of the paper's slow ramp, and the loads are gone at t = 0. Amplitudes are so
    small that the three motions do not feel each other.

    Args:
        lattice: the specimen.
        law: its bonds.
        density: of the elements, ρ_μ [kg/m³].
        E: its own Young's modulus [Pa]; with nu and rho it sets the duration.
        nu: its own Poisson's ratio [-].
        rho: its own density [kg/m³].
        periods: of the bending mode, the slowest [-].
        stress: that each load causes, roughly [Pa].
        depth: of the two faces, in mean radii [-].
    """
    check(
        "free_vibration", lattice, density=density, E=E, nu=nu, rho=rho, periods=periods, stress=stress, depth=depth
    )
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, depth=depth).paper
    held = Fix(Face("x_min", depth))
    model = Model(lattice, law, density=density, boundary=[held])
    start = solve_static(model.with_boundary([held, combined_load(bar.section, stress=stress, depth=depth)]))
    state = State(model)
    state.set_pose(
        position=state.position + start.displacement, orientation=_quaternions(start.rotation)
    )
    run = solve_explicit(
        model,
        duration=periods / bar.bending_frequency_timoshenko,
        gauges=_gauges(depth),
        every=_EVERY,
        state=state,
    )
    return _recorded(run, 0.0, start.energy.total)


def ramped_vibration(
    lattice: Lattice,
    law: AnyLaw,
    *,
    density: float,
    steps: int = 50_000,
    ramp: float = 0.4,
    stress: float = 1e5,
    depth: float = 0.02,
    safety: float = 0.9,
    progress: Callable[[float], None] | None = None,
) -> FreeVibration:
    """Load a clamped specimen little by little, let go, and record all of it, as the paper does.

    The loads of `free_vibration` grow from nothing, and are gone from one step to the next.

    Args:
        lattice: the specimen.
        law: its bonds.
        density: of the elements, ρ_μ [kg/m³].
        steps: how many.
        ramp: share of the steps in which the loads grow [-].
        stress: that each load causes at its end, roughly [Pa].
        depth: of the two faces, in mean radii [-].
        safety: share of the critical time step to take [-].
        progress: told the share of steps done, 0 … 1.

    Raises:
        InputError: fewer than 1000 steps, or a ramp that leaves nothing to swing in.
    """
    if steps < 1000:
        raise InputError(f"steps = {steps}; give at least 1000, for a few oscillations")
    growing = round(ramp * steps / _EVERY) * _EVERY
    if not 0 < growing < steps:
        raise InputError(f"ramp = {ramp}; give the share of the steps in which the loads grow, in (0, 1)")
    held = Fix(Face("x_min", depth))
    model = Model(lattice, law, density=density, boundary=[held])
    dt = settled(model, Plan(duration=0.0, safety=safety)).dt
    assert dt is not None
    tell = progress or (lambda share: None)
    released = growing * dt
    section = CrossSection.of(lattice.particles.envelope)
    load = combined_load(section, stress=stress, depth=depth, schedule=Ramp(0.0, 1.0, released))
    loaded = solve_explicit(
        model.with_boundary([held, load]), duration=released, dt=dt, gauges=_gauges(depth), every=_EVERY,
        progress=lambda share: tell(share * growing / steps),
    )  # fmt: skip
    energy = float(loaded.history.energy["work"][-1])
    before = _recorded(loaded, 0.0, energy)
    # a run of its own: the kick that closes its last step is the load's, the one that opens the next is not
    free = solve_explicit(
        model, duration=(steps - growing) * dt, dt=dt, gauges=_gauges(depth), every=_EVERY, state=loaded.state,
        progress=lambda share: tell((growing + share * (steps - growing)) / steps),
    )  # fmt: skip
    return _joined(before, _recorded(free, released, energy))


def combined_load(
    section: CrossSection, *, stress: float, depth: float, schedule: Schedule = _AT_ONCE
) -> Load:
    """An axial force, a transverse force and a moment about x on the face x_max, each causing about `stress` [Pa]."""
    # a bar 8 radii long is some 30 times softer across than along, so the transverse force is taken smaller
    force = (stress * section.area, 0.05 * stress * section.area, 0.0)
    moment = (stress * section.torsion_constant / section.area**0.5, 0.0, 0.0)
    return Load(Face("x_max", depth), force=force, moment=moment, schedule=schedule)


def _gauges(depth: float) -> dict[str, Gauge]:
    end = Face("x_max", depth)
    return {"shift": Gauge(end, "displacement"), "turn": Gauge(end, "rotation")}


def _recorded(run: ExplicitResult, released: float, energy: float) -> FreeVibration:
    if run.status.failed:
        raise UnstableRunError(run.message)
    history = run.history
    whole = slice(0, run.steps // _EVERY + 1)  # the last record of a run may come early
    shift, turn = history["shift"][whole], history["turn"][whole]
    ledger = history.energy
    return FreeVibration(
        time=history.time[whole],
        signal={"tension": shift[:, 0], "bending": shift[:, 1], "torsion": turn[:, 0]},
        energy={name: values[whole] for name, values in ledger.items()},
        energy_error=float(np.abs(ledger["balance"]).max() / energy),
        dt=run.dt,
        steps=run.steps,
        released=released,
    )


def _joined(before: FreeVibration, after: FreeVibration) -> FreeVibration:
    """Two runs as one: the first record of the second, which is the last of the first, is left out."""
    carried = {name: before.energy[name][-1] for name in ("work", "loss", "friction", "balance")}
    energy = {
        name: np.concatenate([values, after.energy[name][1:] + carried.get(name, 0.0)])
        for name, values in before.energy.items()
    }
    return FreeVibration(
        time=np.concatenate([before.time, after.time[1:]]),
        signal={kind: np.concatenate([values, after.signal[kind][1:]]) for kind, values in before.signal.items()},
        energy=energy,
        energy_error=float(np.abs(energy["balance"]).max() / energy["work"].max()),
        dt=before.dt,
        steps=before.steps + after.steps,
        released=after.released,
    )


def _quaternions(rotation: Floats) -> Floats:
    """Unit quaternions (w, x, y, z) of rotation vectors (n, 3) [rad], shape (n, 4)."""
    half = 0.5 * np.linalg.norm(rotation, axis=1, keepdims=True)
    return np.hstack([np.cos(half), 0.5 * rotation * np.sinc(half / np.pi)])
