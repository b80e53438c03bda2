"""Speed of a longitudinal wave along a specimen."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from bondem._progress import staged
from bondem.errors import InputError
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.faces import specimen_faces
from bondem.labtests.outcome import Outcome
from bondem.labtests.wave import first_passage, strike
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant


@staged("impact")
def impact(
    lattice: Lattice, law: AnyLaw, *, density: float | Material, E: float | Material, nu: float | Material,
    rho: float | Material, velocity: float = 0.1, depth: float = 0.02, out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> Outcome:  # fmt: skip
    """Measure the speed of a longitudinal wave along a bar and compare it with √(E/ρ).

    The face x_max moves at a prescribed velocity v. The free face x_min then moves at a plateau velocity of 2 v,
    until the wave returns from x_max at three times the arrival time. The arrival is the time at which the mean
    velocity at x_min first exceeds half the plateau; the plateau is averaged over the middle of its duration. The
    speed is L_M of eq (12) of André et al. (2012) over the arrival time.

    The refined theory uses the path from the mean centre of the driven elements to the face x_min. In a body of cells
    this path is the full length, as the wall drives the face x_max itself. The cells at x_min record the front and
    its reflection, symmetrically about the time at which the front reaches the face.

    Args:
        lattice: the specimen.
        law: bond law, cell law or non-local law of the specimen.
        density: density of the elements, ρ_μ [kg/m³].
        E: Young's modulus of the specimen [Pa].
        nu: Poisson's ratio of the specimen [-].
        rho: density of the specimen, mass over volume of the shape [kg/m³].
        velocity: velocity v of the face towards x_min [m/s].
        depth: depth of the two face regions, in mean radii [-].
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Returns:
        Measured and theoretical speed [m/s], with the velocities of both faces over time as curves.

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: a value out of range, a shape other than a Cylinder or a Box, or no plateau of the velocity at
            x_min, such as for a coarse specimen or wrong E or rho.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error is the `Wave` so far, None for a short run.
    """
    density, E, nu, rho = constant("density", density), constant("E", E), constant("nu", nu), constant("rho", rho)
    check("impact", lattice, density=density, E=E, nu=nu, rho=rho, velocity=velocity, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, depth=depth)
    expected = bar.paper.length / bar.paper.wave_speed
    wave = strike(
        lattice, law, density=density, duration=2.7 * expected, velocity=velocity, depth=depth, out=out,
        progress=progress,
    )  # fmt: skip
    plateau = wave.far[wave.time >= 1.4 * expected].mean()
    if not plateau > velocity:
        raise InputError(
            f"labtests.impact: the far face moves at {plateau:.3g} m/s instead of {2.0 * velocity:g} m/s;"
            " check E=, rho= and density=, or use a finer specimen"
        )
    arrival = first_passage(wave.time, wave.far, 0.5 * plateau)
    path = specimen_faces(lattice, depth).ends[1] - float(lattice.particles.envelope.bounds[0][0])
    speed = bar.paper.wave_speed
    return Outcome(
        name="impact", measured=bar.paper.length / arrival, theory=speed, unit="m/s",
        # the same path in both numbers would cancel, so the ratio of paths goes into the theory
        theory_refined=speed * bar.paper.length / path,
        curves={
            "time": wave.time, "near": wave.near, "far": wave.far, "arrival": np.array(arrival),
            "plateau": np.array(plateau),
        },
    )  # fmt: skip
