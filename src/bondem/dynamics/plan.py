"""Plan of an explicit run, its result, and the interface of loops over its steps."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np

from bondem._checks import count, instance, number, several, shown
from bondem._drawing import PlottedState
from bondem._types import Floats
from bondem.boundary.gauges import AnyGauge, Gauge, StrainGauge, WallGauge, units_of
from bondem.dynamics.damping import AnyDamping, DampingTerms
from bondem.dynamics.events import Event
from bondem.dynamics.history import History
from bondem.dynamics.quasistatic import Quasistatic
from bondem.dynamics.schemes import Scheme, VelocityVerlet
from bondem.dynamics.timestep import choose_step
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.solution import Solution, Status
from bondem.model.state import State
from bondem.observables.breakage import BrokenBonds
from bondem.observables.fracture_energy import FractureEnergy, fracture_energies

# A function called with the state and the record of each output; it ends the run by returning True.
Callback = Callable[[State, History], bool | None]

__all__ = ["Callback", "ExplicitResult", "Loop", "Plan", "Status", "settled"]

# Largest number of steps: more would take weeks for two elements, and indicate a duration in another unit.
_MOST = 10**12


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Parameters of an explicit run; an invalid value raises InputError.

    Attributes:
        duration: physical time [s]; the run takes round(duration / dt) steps.
        dt: time step [s]; None for `safety` times the critical step, or less to resolve short collisions.
        scheme: time integration scheme.
        damping: damping of elements or bonds, one kind or several in a tuple, or None.
        gauges: quantities to record, by name.
        every: steps between records, 0 for none; the end of the run is recorded, too.
        save_every: steps between checkpoints; 0 for the last one only.
        snapshot_every: steps between snapshots for ParaView; 0 for none.
        until: one event or several that end the run.
        safety: share of the critical time step to use if dt is None [-].
        imbalance: limits of the error of the energy balance that give a warning and stop the run, as shares of the
            largest energy so far [-]; None for no check.
    """

    duration: float
    dt: float | None = None
    scheme: Scheme = field(default_factory=VelocityVerlet)
    damping: AnyDamping | tuple[AnyDamping, ...] | None = None
    gauges: Mapping[str, AnyGauge] = field(default_factory=dict)
    every: int = 100
    save_every: int = 0
    snapshot_every: int = 0
    until: Event | Sequence[Event] = ()
    safety: float = 0.9
    imbalance: tuple[float, float] | None = (0.01, 0.10)

    def __post_init__(self) -> None:
        number("", "duration", self.duration, unit="s", least=0.0, advice="a time of zero or more")
        if self.dt is not None:
            number("", "dt", self.dt, unit="s", advice="a time step, or None for the best stable one")
        share = number("", "safety", self.safety, above=0.0, advice="a share of the critical step in (0, 1]")
        if share > 1.0:
            raise InputError(f"safety = {self.safety}; give a share of the critical step in (0, 1]")
        for name in ("every", "save_every", "snapshot_every"):
            whole = count("", name, getattr(self, name), advice="a whole number of steps, 0 for never")
            object.__setattr__(self, name, whole)
        object.__setattr__(self, "imbalance", _limits(self.imbalance))
        instance("", "scheme", self.scheme, Scheme, "a scheme such as bd.VelocityVerlet()")
        instance("", "gauges", self.gauges, Mapping, 'gauges by name, {"end": bd.Gauge(region, "displacement")}')
        for name, gauge in self.gauges.items():
            instance("gauges", "a name", name, str, "text")
            instance("gauges", name, gauge, (Gauge, WallGauge, StrainGauge), "bd.Gauge(...) or bd.WallGauge(...)")
        object.__setattr__(self, "gauges", dict(self.gauges))
        until = several("", "until", self.until, Event, "bd.AtRest(...), or several events")
        object.__setattr__(self, "until", until)
        if self.until and not self.every:
            raise InputError("until= is evaluated with each record, but every = 0; give every= of at least 1")
        DampingTerms.of(self.damping)

    @property
    def events(self) -> tuple[Event, ...]:
        """Events that end the run."""
        return (self.until,) if isinstance(self.until, Event) else tuple(self.until)

    @property
    def steps(self) -> int:
        """Number of steps, round(duration / dt); requires a time step.

        Raises:
            InputError: The number of steps is excessive, or zero although the duration is not.
        """
        assert self.dt is not None
        if self.duration > 0.0 and round(self.duration / self.dt) == 0:
            raise InputError(
                f"duration = {self.duration:.3g} s is shorter than a step of {self.dt:.3g} s, so that nothing would"
                " move; give a longer duration (seconds) or a smaller dt=, or duration=0 to record the start only"
            )
        if not self.duration <= _MOST * self.dt:
            raise InputError(
                f"duration = {self.duration:.3g} s takes {self.duration / self.dt:.3g} steps of {self.dt:.3g} s;"
                " check its units (seconds), or give dt="
            )
        return round(self.duration / self.dt)


@dataclass(frozen=True, eq=False, kw_only=True)
class ExplicitResult(Solution, PlottedState):
    """Result of an explicit run.

    `iterations` is the number of steps since the start of the run. `residual` is the largest error of the energy
    balance over its largest entry (NaN without records).

    Attributes:
        state: final state; after an unstable run, the last good state, fewer than 6 000 steps earlier.
        history: records of the run.
        dt: time step [s].
        message: one line about the end of the run.
        quasistatic: kinetic over elastic energy, difference of the forces at both ends, forces of servo walls.
        gauges: gauges of the run, by name.
    """

    state: State
    history: History
    dt: float
    message: str
    quasistatic: Quasistatic
    gauges: Mapping[str, AnyGauge]

    @property
    def events(self) -> BrokenBonds:
        """Broken bonds or facets in the order of breakage."""
        return BrokenBonds.of(self.state)

    @property
    def fracture_area(self) -> float:
        """Own area of all broken bonds or facets, each counted once [m²].

        Facets of cells without cohesion are left out. A plane crack through cells has 1.2 to 1.5 times its projected
        area, which `bd.cracks(...).projected_area` gives.
        """
        return sum(one.area for one in self.fracture_energy)

    @property
    def fracture_energy(self) -> tuple[FractureEnergy, ...]:
        """Energy dissipated per broken area [J/m²] and its ratio to the fracture energy [-], for each criterion."""
        return fracture_energies(self.state)

    @property
    def steps(self) -> int:
        """Number of steps since the start of the run."""
        return self.iterations

    @property
    def table(self) -> dict[str, Floats]:
        """Times, energies and gauges of the history, by name and unit, (s,) each."""
        history = self.history
        found = {"time [s]": history.time} | {f"{name} [J]": values for name, values in history.energy.items()}
        for name in history.gauges:
            ends = zip("xyz", units_of(self.gauges[name]), history[name].T, strict=True)
            found |= {f"{name} {end} [{unit}]": column for end, unit, column in ends}
        return found

    @property
    def drawn(self) -> dict[str, Floats]:
        """Curves of the plot: time [s] and `History.parts` [J], (s,) each, without those that are always zero."""
        parts = {f"{name} [J]": values for name, values in self.history.parts.items() if np.any(values)}
        return {"time [s]": self.history.time} | parts if parts else {}


# Verdicts of a loop on a run.
FINE, NOT_FINITE, RUNAWAY = range(3)


class Loop(Protocol):
    """A loop over the steps of a run, on the CPU or another device."""

    state: State

    def record_present(self) -> np.ndarray:
        """Update the acceleration and return a record of the present state, (1, columns)."""
        ...

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Take a number of time steps.

        Returns:
            Records, (s, columns); the number of bonds whose ends are rotated beyond the accurate range of the energy
            of the law; the number of those rotated so far that it has no meaning; and FINE, NOT_FINITE or RUNAWAY.
        """
        ...


def _limits(given: tuple[float, float] | None) -> tuple[float, float] | None:
    """Return the checked limits of the imbalance, or None.

    Raises:
        InputError: The value is not a pair of positive shares in ascending order.
    """
    if given is None:
        return None
    advice = "(warning, stop) as shares of the largest energy, such as (0.01, 0.10), or None for no check"
    if not isinstance(given, tuple | list) or len(given) != 2:
        raise InputError(f"imbalance = {shown(given)}; give {advice}")
    for share in given:
        if isinstance(share, bool) or not isinstance(share, int | float | np.number) or not share > 0.0:
            raise InputError(f"imbalance = {shown(given)}; give {advice}")
    if given[0] > given[1]:
        raise InputError(f"imbalance = {shown(given)}: the run would stop before it warns; give {advice}")
    return float(given[0]), float(given[1])


def settled(model: Model, plan: Plan) -> Plan:
    """Return the plan with its time step: the given one after a check, or a chosen one.

    Raises:
        UnstableStepError: dt is not positive, or exceeds the critical step; or the lattice has no stiffness from
            which to choose a step.
    """
    step = choose_step(model, plan.scheme, plan.dt, safety=plan.safety, damping=plan.damping)
    return replace(plan, dt=step.dt)
