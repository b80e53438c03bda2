"""Spall test: a pressure pulse is reflected as tension at the free end of a bar and breaks the bar there."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import count, number
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.gauges import Gauge
from bondem.boundary.loads import Pressure
from bondem.boundary.schedules import Table
from bondem.damage.criteria.criterion import Criterion
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import InputError
from bondem.fracture.fragments import Fragments, fragments
from bondem.interactions.cells.cell_bond import CellBond
from bondem.labtests.quasi_static_rig import require_cells
from bondem.labtests.recorded_run import OfOneRun, run_test
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant
from bondem.specimen.regions import Face

# Largest mass share of fragments that are not counted; largest integrity of broken facets [-].
_CRUMB, _BROKEN = 0.01, 0.1
# Rise of the velocity that ends the pull-back, over 2 p / ρ c [-].
_REBOUND = 0.04
# Largest number of bins of a profile.
_MOST_BINS = 1_000_000
# Length of the bins along the bar over the mean edge of its cells, and number of steps between records.
_BIN = 1.0
_EVERY = 2


@dataclass(frozen=True)
class ThinBar:
    """Response of a thin elastic bar to a triangular pressure pulse.

    Attributes:
        E: Young's modulus [Pa].
        rho: density [kg/m³].
        pressure: peak pressure p of the pulse [Pa].
        rise, fall: rise time and fall time of the pulse [s].
    """

    E: float
    rho: float
    pressure: float
    rise: float
    fall: float

    @property
    def celerity(self) -> float:
        """Wave speed c = √(E/ρ) [m/s]."""
        return math.sqrt(self.E / self.rho)

    @property
    def velocity(self) -> float:
        """Largest velocity of the free end, 2 p / ρ c [m/s], for the peak pressure p."""
        return 2.0 * self.pressure / (self.rho * self.celerity)

    def pull_back(self, tension: float) -> float:
        """Return the pull-back velocity of the free end 2 f_t / ρ c [m/s] for a tensile strength f_t [Pa]."""
        return 2.0 * tension / (self.rho * self.celerity)

    def strength(self, pull_back: float) -> float:
        """Return the tensile strength ½ ρ c Δu [Pa] for a pull-back velocity Δu [m/s], Novozhilov's estimate."""
        return 0.5 * self.rho * self.celerity * pull_back

    def place(self, tension: float) -> float:
        """Return the distance ½ c t_fall f_t / p from the free end at which tension first reaches a strength f_t [m].

        At the distance d the reflected peak meets the incident pulse after 2 d / c, when its pressure has dropped by
        f_t. The result is infinite for a strength above the peak pressure.
        """
        return 0.5 * self.celerity * tension / self.pressure * self.fall if tension <= self.pressure else math.inf


@dataclass(frozen=True, eq=False)
class SpallTest(OfOneRun):
    """Result of a spall test.

    Attributes:
        bar: thin elastic bar of equal E, ρ and pulse.
        time, velocity: time [s] and velocity of the free end along the bar [m/s] of each record, (k,).
        highest: largest velocity of the free end [m/s].
        pull_back: drop of the velocity from its maximum until it rises again, Δu [m/s]; None if it does not rise.
        first: time of the first failure of a facet [s]; None without failure.
        lengths: lengths of the fragments, mass over mass per length of the bar, in the order from the free end [m],
            (f,); fragments of at most 1 % of the total mass are left out.
        edges, profile: edges of bins from the free end [m], (b + 1,), and broken area per bin, projected along x,
            over the section [-], (b,).
        residual: error of the energy balance over its largest term [-].
        run: result of the explicit run.
    """

    bar: ThinBar
    time: Floats
    velocity: Floats
    highest: float
    pull_back: float | None
    first: float | None
    lengths: Floats
    edges: Floats
    profile: Floats
    residual: float
    run: ExplicitResult

    @property
    def peak(self) -> float:
        """Spall strength ½ ρ c Δu [Pa] from the velocity Δu of `pull_back`; NaN if that is None."""
        return math.nan if self.pull_back is None else self.bar.strength(self.pull_back)

    @property
    def place(self) -> float | None:
        """Length of the fragment at the free end [m]; None for an unbroken bar."""
        return float(self.lengths[0]) if len(self.lengths) > 1 else None

    @property
    def table(self) -> dict[str, Floats]:
        """Columns of the velocity of the free end over time, by their names with units, (k,) each."""
        return {"time [s]": self.time, "velocity of the free end [m/s]": self.velocity}


@staged("spall")
def spall(
    bar: Lattice,
    law: CellBond,
    failure: Criterion | None,
    *,
    density: float | Material,
    pressure: float,
    rise: float,
    fall: float,
    duration: float | None = None,
    rebound: float | None = None,
    bins: int | None = None,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> SpallTest:
    """Apply a triangular pressure pulse to x_min of a bar of cells and record its free end x_max, without damping.

    For pulses much longer than the diameter, stresses are those of a thin bar. The strength is Novozhilov's acoustic
    estimate, ½ ρ c Δu with Δu the pull-back of the free end and c = √(E/ρ).

    Args:
        bar: cells of a bar along x.
        law: cell law of the bar.
        failure: failure criterion; None for an elastic bar.
        density: density of the material [kg/m³], or a `bd.Material`.
        pressure: peak pressure p of the pulse [Pa].
        rise, fall: rise time of the pulse, and its fall time to zero [s].
        duration: duration of the run [s]; None for three passes along the bar, until the pulse is at x_max again.
        rebound: rise of the velocity that ends a pull-back [m/s]; None for 4 % of 2 p / ρ c.
        bins: number of bins of the profile; None for bins as long as the mean edge of cells.
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: a lattice without cells, no faces x_min and x_max, a pulse longer than two passes along the bar,
            or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Reference: Novozhilov's formula as in Schuler, Mayrhofer and Thoma, Int. J. Impact Eng. 32 (2006) 1635-1650.
    """
    density = constant("density", density)
    owner = "labtests.spall"
    require_cells("spall", bar, law, density)
    given = {"pressure": (pressure, "Pa"), "rise": (rise, "s"), "fall": (fall, "s")}
    given |= {"duration": (duration, "s")} if duration is not None else {}
    given |= {"rebound": (rebound, "m/s")} if rebound is not None else {}
    for name, (value, unit) in given.items():
        number(owner, name, value, above=0.0, unit=unit)
    parts = None if bins is None else count(owner, "bins", bins, least=1)
    if parts is not None and parts > _MOST_BINS:
        raise InputError(f"{owner}: bins = {parts}: too many; give at most {_MOST_BINS}")
    thin = ThinBar(law.E, density, pressure, rise, fall)
    shape = bar.particles.envelope
    length, section = shape.extent, shape.section()
    way = length / thin.celerity
    if rise + fall > 2.0 * way:
        raise InputError(
            f"{owner}: the pulse of {rise + fall:.3g} s is not over when its front returns to x_min after"
            f" {2.0 * way:.3g} s; give a shorter pulse or a longer bar"
        )
    load = Pressure(Face("x_min"), pressure, schedule=Table((0.0, rise, rise + fall), (0.0, 1.0, 0.0)))
    model = Model(bar, law, density, failure=failure, boundary=[load])
    edge = _REBOUND * thin.velocity if rebound is None else rebound

    def read(run: ExplicitResult) -> SpallTest:
        velocity = run.history["end"][:, 0]
        highest, fallen = pulled_back(velocity, edge)
        edges, profile = _profile(bar, run.state, length, section, parts)
        return SpallTest(
            bar=thin, time=run.history.time, velocity=velocity, highest=highest, pull_back=fallen,
            first=float(run.events.time.min()) if len(run.events) else None,
            lengths=lengths(fragments(bar, run.state), density * section), edges=edges, profile=profile,
            residual=run.residual, run=run,
        )  # fmt: skip

    return run_test(
        "spall", model, read, duration=3.0 * way if duration is None else duration, every=_EVERY, out=out,
        progress=progress, gauges={"end": Gauge(Face("x_max"), "velocity")},
    )  # fmt: skip


def pulled_back(velocity: Floats, rebound: float) -> tuple[float, float | None]:
    """Compute the largest velocity of a free end and its pull-back [m/s]; the latter is None without a later rise.

    Args:
        velocity: velocity of the free end over time [m/s], (k,).
        rebound: rise of the velocity that ends a pull-back [m/s].
    """
    top = int(np.argmax(velocity))
    least = np.minimum.accumulate(velocity[top:])
    again = np.flatnonzero(velocity[top:] > least + rebound)
    return float(velocity[top]), float(velocity[top] - least[again[0]]) if again.size else None


def lengths(pieces: Fragments, mass: float) -> Floats:
    """Compute the lengths of the fragments of a bar along x from their masses, in the order from x_max [m], (f,).

    `mass` is the mass of the bar per length [kg/m]. Fragments of at most 1 % of the total mass are left out.
    """
    whole = pieces.mass > _CRUMB * pieces.mass.sum()
    order = np.argsort(-pieces.position[whole, 0])
    return pieces.mass[whole][order] / mass


def _profile(bar: Lattice, state: State, length: float, section: float, bins: int | None) -> tuple[Floats, Floats]:
    """Compute `edges` and `profile` of a `SpallTest` from the length [m] and the section [m²] of the bar."""
    facets = bar.elements.require_cells().facets
    if bins is None:
        bins = max(1, round(length / (_BIN * float(np.cbrt(bar.element_volume.mean())))))
    broken = np.flatnonzero(state.bond_integrity < _BROKEN)
    place = float(bar.particles.envelope.bounds[1][0]) - facets.centroid[broken, 0]
    area = facets.area[broken] * np.abs(facets.normal[broken, 0])
    found, edges = np.histogram(place, bins, range=(0.0, length), weights=area)
    return edges, found / section
