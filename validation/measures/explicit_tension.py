"""Tension of a free specimen by explicit dynamics: loads grow slowly, and the scheme damps (André et al. 2012)."""

import time
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

import bondem as bd
from bondem._types import Floats
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import settled
from bondem.errors import InputError, UnstableRunError
from bondem.labtests.gauge_length import AffineField, middle_half

# Records of a run: enough for a curve, and for a mean over the last of them.
_RECORDS = 1000
# Depth of the loaded faces, in mean radii [-].
_DEPTH = 0.02
# The last tenth of a run is what it has come to.
_TAIL = 0.1


@dataclass(frozen=True, eq=False)
class ExplicitTension:
    """What a slow tension test by explicit dynamics went through.

    Attributes:
        time: [s], (s,).
        strain: affine fit over the middle half, along x and the mean of y and z [-], (s, 2).
        energy: ledger of the run, `History.energy` [J], each (s,).
        stress: F / S at full load [Pa].
        ramp: how long the load grew [s].
        dt: time step [s].
        steps: taken.
        seconds: of wall time the steps took [s].
        busy: of processor time they took, all threads together [s].
    """

    time: Floats
    strain: Floats
    energy: Mapping[str, Floats]
    stress: float
    ramp: float
    dt: float
    steps: int
    seconds: float
    busy: float

    @property
    def E(self) -> float:
        """Young's modulus: F / S over the mean strain of the last tenth of the run [Pa]."""
        return self.stress / float(self._tail[:, 0].mean())

    @property
    def nu(self) -> float:
        """Poisson's ratio, from the same means [-]."""
        return -float(self._tail[:, 1].mean() / self._tail[:, 0].mean())

    @property
    def kinetic(self) -> Floats:
        """Kinetic energy [J], (s,)."""
        return self.energy["translation"] + self.energy["rotation"]

    @property
    def elastic(self) -> Floats:
        """Elastic energy of the bonds [J], (s,)."""
        return sum((self.energy[name] for name in ("normal", "shear", "bending", "twisting")), np.zeros(1))

    @property
    def _tail(self) -> Floats:
        return self.strain[self.time >= (1.0 - _TAIL) * self.time[-1]]


def explicit_tension(
    lattice: bd.Lattice,
    law: bd.BondAssignment,
    *,
    density: float,
    steps: int = 100_000,
    ramp: float = 0.5,
    phi: float = 1.3,
    stress: float = 1e5,
) -> ExplicitTension:
    """Pull a free specimen as `static_tension` does, step by step: a linear ramp, then the load stays.

    Args:
        lattice: the specimen.
        law: its bonds.
        density: of the elements, ρ_μ [kg/m³].
        steps: of 0.9 of the critical time step.
        ramp: share of the steps in which the load grows [-].
        phi: of the scheme of Tchamwa and Wielgosz, which damps [-].
        stress: F / S at full load [Pa]; so small that geometry stays linear to a part in a million.

    Raises:
        InputError: fewer than 1000 steps, or a ramp that leaves nothing to hold.
        EmptyRegionError: no connected element at a face.
    """
    if steps < 1000:
        raise InputError(f"steps = {steps}; a slow test takes at least 1000, and some ten thousands to be slow")
    if not 0.0 < ramp < 1.0:
        raise InputError(f"ramp = {ramp}; give the share of the steps in which the load grows, in (0, 1)")
    free = bd.Model(lattice, law, density=density)
    plan = settled(free, bd.Plan(duration=0.0, scheme=bd.TchamwaWielgosz(phi), every=max(steps // _RECORDS, 1)))
    assert plan.dt is not None
    duration = ramp * steps * plan.dt
    force = stress * lattice.particles.envelope.section()
    grows = bd.Ramp(0.0, 1.0, duration)
    model = free.with_boundary([
        bd.Load(bd.Face("x_max", _DEPTH), force=(force, 0.0, 0.0), schedule=grows),
        bd.Load(bd.Face("x_min", _DEPTH), force=(-force, 0.0, 0.0), schedule=grows),
    ])  # fmt: skip
    chosen = middle_half(lattice)
    position = lattice.particles.position[chosen]
    strain: list[tuple[float, float]] = []

    def read(state: bd.State, _record: bd.History) -> None:
        axial, *lateral = np.diag(AffineField.fit(position, state.displacement[chosen]).strain)
        strain.append((axial, 0.5 * sum(lateral)))

    began, busy = time.perf_counter(), time.process_time()
    run = integrate(model, replace(plan, duration=steps * plan.dt), callback=read)
    seconds, busy = time.perf_counter() - began, time.process_time() - busy
    if run.status.failed:
        raise UnstableRunError(run.message)
    return ExplicitTension(
        time=run.history.time[: len(strain)],
        strain=np.array(strain),
        energy={name: values[: len(strain)] for name, values in run.history.energy.items()},
        stress=stress,
        ramp=duration,
        dt=run.dt,
        steps=run.steps,
        seconds=seconds,
        busy=busy,
    )
