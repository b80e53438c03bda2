"""Free vibration of a clamped specimen after the release of its loads."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._drawing import Plotted
from bondem._progress import staged
from bondem._types import Floats
from bondem.boundary.conditions import Fix, Load
from bondem.boundary.gauges import Gauge
from bondem.boundary.schedules import Constant, Schedule
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import UnstableRunError
from bondem.geometry.rotations import turned_further
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.beam_tests import CrossSection
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.frequency import dominant_frequency
from bondem.labtests.recorded_run import run_test
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant
from bondem.specimen.regions import Face
from bondem.statics.static import solve_static

# Steps between records: a wave crosses less than an element radius per step, so that a first mode has at least a
# dozen samples per period.
RECORD_INTERVAL = 8
_AT_ONCE = Constant(1.0)


@dataclass(frozen=True, eq=False)
class FreeVibration(Plotted):
    """Motion of the face x_max of a clamped specimen after the release of its loads.

    Attributes:
        time: time of each record [s], (s,).
        signal: motion of the elements at x_max, (s,) each: mean displacement along x ("tension") and y ("bending")
            [m], and mean rotation about x ("torsion") [rad].
        energy: terms of the energy balance, `History.energy` [J], each (s,).
        energy_error: largest error of the energy balance over the energy at release [-].
        dt: time step [s].
        steps: number of steps.
        released: time of release [s]: 0 for a start from the equilibrium under load. In a run from the unloaded
            state, the loads increase until then.
    """

    time: Floats
    signal: Mapping[str, Floats]
    energy: Mapping[str, Floats]
    energy_error: float
    dt: float
    steps: int
    released: float = 0.0

    @property
    def table(self) -> dict[str, Floats]:
        """Motions of the free face and energies in time, by name and unit, (s,) each."""
        units = {"tension": "m", "bending": "m", "torsion": "rad"}
        moved = {f"{kind} [{units[kind]}]": values for kind, values in self.signal.items()}
        return {"time [s]": self.time} | moved | {f"{name} [J]": values for name, values in self.energy.items()}

    @property
    def drawn(self) -> dict[str, Floats]:
        """Motions of the free face over their largest values [-] in time, by name and unit, (s,) each."""
        moved = {f"{kind} over its largest value [-]": one / np.abs(one).max() for kind, one in self.signal.items()}
        return {"time [s]": self.time} | moved

    @property
    def free(self) -> slice:
        """Slice of the records after release."""
        return slice(int(np.argmax(self.time >= self.released * (1.0 - 1e-9))), len(self.time))

    def frequency(self, kind: str) -> float:
        """Return the frequency of a signal [Hz], fitted over all records after release.

        Args:
            kind: name of the signal, "tension", "bending" or "torsion".

        Raises:
            InputError: fewer than 16 records after release, or a constant signal.
        """
        return dominant_frequency(self.time[self.free], self.signal[kind][self.free])


@staged("free vibration")
def free_vibration(
    lattice: Lattice, law: AnyLaw, *, density: float | Material, E: float | Material, nu: float | Material,
    rho: float | Material, periods: float = 3.0, stress: float = 1e5, depth: float = 0.02,
    out: str | Path | None = None, progress: Callable[[float], None] | None = None,
) -> FreeVibration:  # fmt: skip
    """Load a clamped specimen, release it and record its vibration.

    The run starts at rest from the static equilibrium under an axial force, a transverse force and a moment about x.
    This is the limit of the slow ramp of André et al. (2012). The loads are removed at t = 0. Amplitudes are so small
    that the three motions do not interact.

    Args:
        lattice: the specimen.
        law: bond law, cell law or non-local law of the specimen.
        density: density of the elements, ρ_μ [kg/m³].
        E: Young's modulus of the specimen [Pa]; with nu and rho it sets the duration.
        nu: Poisson's ratio of the specimen [-].
        rho: density of the specimen [kg/m³].
        periods: number of periods of the bending mode, the slowest one [-].
        stress: approximate stress from each load [Pa].
        depth: depth of the two face regions, in mean radii [-].
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: a specimen that is neither a Cylinder nor a Box, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error is the motion so far, None for a short run.
    """
    density, E, nu, rho = constant("density", density), constant("E", E), constant("nu", nu), constant("rho", rho)
    check(
        "free_vibration", lattice, density=density, E=E, nu=nu, rho=rho, periods=periods, stress=stress, depth=depth
    )
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, depth=depth).paper
    clamp = Fix(Face("x_min", depth))
    model = Model(lattice, law, density=density, boundary=[clamp])
    start = solve_static(model.with_boundary([clamp, combined_load(bar.section, stress=stress, depth=depth)]))
    state = State(model)
    turned = turned_further(state.orientation, start.rotation)
    state.set_pose(position=state.position + start.displacement, orientation=turned)
    return run_test(
        "free_vibration", model, lambda run: recorded_vibration(run, 0.0, start.energy.total),
        duration=periods / bar.bending_frequency_timoshenko, every=RECORD_INTERVAL, out=out, state=state,
        gauges=end_gauges(depth), progress=progress,
    )  # fmt: skip


def combined_load(section: CrossSection, *, stress: float, depth: float, schedule: Schedule = _AT_ONCE) -> Load:
    """Create a load of the face x_max: an axial force, a transverse force and a moment about x.

    Each gives a largest stress of about `stress` [Pa] in a bar eight radii long. `depth` is in mean radii [-].
    """
    # in a bar 8 radii long, a transverse force gives 32 times the stress of an equal axial force
    force = (stress * section.area, 0.05 * stress * section.area, 0.0)
    moment = (stress * section.torsion_constant / section.area**0.5, 0.0, 0.0)
    return Load(Face("x_max", depth), force=force, moment=moment, schedule=schedule)


def end_gauges(depth: float) -> dict[str, Gauge]:
    """Create the gauges "shift" and "turn" of the mean displacement [m] and rotation [rad] of the face x_max."""
    end = Face("x_max", depth)
    return {"shift": Gauge(end, "displacement"), "turn": Gauge(end, "rotation")}


def recorded_vibration(run: ExplicitResult, released: float, energy: float) -> FreeVibration:
    """Evaluate a run with `end_gauges`, from the time of release [s] and the energy at release [J].

    Raises:
        UnstableRunError: the run became unstable or lost its energy balance.
    """
    if run.status.failed:
        raise UnstableRunError(run.message)
    history = run.history
    whole = slice(0, run.steps // RECORD_INTERVAL + 1)  # the last record of a run may come early
    shift, turn = history["shift"][whole], history["turn"][whole]
    ledger = history.energy
    return FreeVibration(
        time=history.time[whole],
        signal={"tension": shift[:, 0], "bending": shift[:, 1], "torsion": turn[:, 0]},
        energy={name: values[whole] for name, values in ledger.items()},
        energy_error=float(np.abs(ledger["balance"]).max() / energy), dt=run.dt, steps=run.steps, released=released,
    )  # fmt: skip
