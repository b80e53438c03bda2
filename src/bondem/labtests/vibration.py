"""Free vibration of a clamped specimen after its loads are let go."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats
from bondem.errors import UnstableRunError
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.frequency import dominant_frequency
from bondem.model.assignment import BondAssignment
from bondem.model.boundary import Fix, Load
from bondem.model.gauges import Gauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.run import solve_explicit
from bondem.solve.explicit import Status
from bondem.solve.static import solve_static
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face

# Steps between records: a wave crosses less than an element radius a step, so no first mode has fewer than a
# dozen samples a period.
_EVERY = 8


@dataclass(frozen=True, eq=False)
class FreeVibration:
    """Motion of the face x_max after release.

    Attributes:
        time: [s], (s,).
        signal: mean displacement along x ("tension") and y ("bending") [m] and mean rotation about x
            ("torsion") [rad] of the elements at x_max, each (s,).
        energy_error: largest imbalance of the energy ledger over the energy at release [-].
        dt: time step [s].
        steps: taken.
    """

    time: Floats
    signal: Mapping[str, Floats]
    energy_error: float
    dt: float
    steps: int

    def frequency(self, kind: str) -> float:
        """Frequency of one signal [Hz], over as many of its own periods as were recorded."""
        return dominant_frequency(self.time, self.signal[kind])


def free_vibration(
    lattice: Lattice,
    law: BondAssignment,
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
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, depth=depth).paper
    section = bar.section
    held, end = Fix(Face("x_min", depth)), Face("x_max", depth)
    # a bar 8 radii long is some 30 times softer across than along, so the transverse force is taken smaller
    force = (stress * section.area, 0.05 * stress * section.area, 0.0)
    moment = (stress * section.torsion_constant / section.area**0.5, 0.0, 0.0)
    model = Model(lattice, law, density=density, boundary=[held])
    start = solve_static(model.with_boundary([held, Load(end, force=force, moment=moment)]))
    state = State(model)
    state.set_pose(
        position=state.position + start.displacement, orientation=_quaternions(start.rotation)
    )
    run = solve_explicit(
        model,
        duration=periods / bar.bending_frequency_timoshenko,
        gauges={"shift": Gauge(end, "displacement"), "turn": Gauge(end, "rotation")},
        every=_EVERY,
        state=state,
    )
    if run.status is Status.UNSTABLE:
        raise UnstableRunError(run.message)
    history = run.history
    whole = slice(0, run.steps // _EVERY + 1)  # the last record of a run may come early
    shift, turn = history["shift"][whole], history["turn"][whole]
    ledger = history.energy
    return FreeVibration(
        time=history.time[whole],
        signal={"tension": shift[:, 0], "bending": shift[:, 1], "torsion": turn[:, 0]},
        energy_error=float(np.abs(ledger["balance"]).max() / start.energy.total),
        dt=run.dt,
        steps=run.steps,
    )


def _quaternions(rotation: Floats) -> Floats:
    """Unit quaternions (w, x, y, z) of rotation vectors (n, 3) [rad], shape (n, 4)."""
    half = 0.5 * np.linalg.norm(rotation, axis=1, keepdims=True)
    return np.hstack([np.cos(half), 0.5 * rotation * np.sinc(half / np.pi)])
