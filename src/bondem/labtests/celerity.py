"""Celerity of a longitudinal wave along a specimen."""

import numpy as np

from bondem.errors import InputError, UnstableRunError
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.outcome import Outcome
from bondem.model.assignment import BondAssignment
from bondem.model.boundary import Drive
from bondem.model.gauges import Gauge
from bondem.model.model import Model
from bondem.run import solve_explicit
from bondem.solve.explicit import Status
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face


def impact(
    lattice: Lattice,
    law: BondAssignment,
    *,
    density: float,
    E: float,
    nu: float,
    rho: float,
    velocity: float = 0.1,
    depth: float = 0.02,
) -> Outcome:
    """Push the face x_max at a held velocity and time the arrival at x_min; celerity against √(E/ρ).

    The free face x_min doubles the velocity of the wave, to a plateau of 2 v that lasts until the wave is
    back from x_max at three times the arrival. The wave has arrived when the mean velocity of the elements at
    x_min first passes half the plateau, the mean over the middle of that time. Celerity is L_M of eq (12)
    over the arrival time; refined, the path runs from the mean centre of the driven elements to the face
    x_min.

    Args:
        lattice: the specimen.
        law: its bonds.
        density: of the elements, ρ_μ [kg/m³].
        E: its own Young's modulus [Pa].
        nu: its own Poisson's ratio [-].
        rho: its own density, mass over volume of the shape [kg/m³].
        velocity: v of the face [m/s], towards x_min.
        depth: of the two faces, in mean radii [-].

    Raises:
        InputError: no plateau: the specimen is too coarse or the wrong E and rho were given.
    """
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, depth=depth)
    expected = bar.paper.length / bar.paper.wave_speed
    near, far = Face("x_max", depth), Face("x_min", depth)
    run = solve_explicit(
        Model(lattice, law, density=density, boundary=[Drive(near, vx=-velocity)]),
        duration=2.7 * expected,
        gauges={"near": Gauge(near, "velocity"), "far": Gauge(far, "velocity")},
        every=1,
    )
    if run.status is Status.UNSTABLE:
        raise UnstableRunError(run.message)
    time = run.history.time
    v = -run.history["far"][:, 0]
    plateau = v[time >= 1.4 * expected].mean()
    if not plateau > velocity:
        raise InputError(
            f"no wave arrived: the far face moves at {plateau:.3g} m/s, not near {2.0 * velocity:g};"
            " check E=, rho= and density=, or use a finer specimen"
        )
    first = int(np.argmax(v >= 0.5 * plateau))
    before = max(first - 1, 0)
    arrival = float(np.interp(0.5 * plateau, v[[before, first]], time[[before, first]]))
    path = float(lattice.particles.position[bar.loaded, 0].mean() - lattice.particles.envelope.bounds[0][0])
    speed = bar.paper.wave_speed
    return Outcome(
        name="impact",
        measured=bar.paper.length / arrival,
        theory=speed,
        # the same path in both numbers would cancel, so the ratio of paths goes into the theory
        theory_refined=speed * bar.paper.length / path,
        unit="m/s",
        curves={
            "time": time,
            "near": -run.history["near"][:, 0],
            "far": v,
            "arrival": np.array(arrival),
            "plateau": np.array(plateau),
        },
    )
