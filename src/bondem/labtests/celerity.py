"""Celerity of a longitudinal wave along a specimen."""

import numpy as np

from bondem._progress import staged
from bondem.errors import InputError
from bondem.labtests.arguments import AnyLaw, check
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.faces import ends
from bondem.labtests.outcome import Outcome
from bondem.labtests.wave import first_passage, strike
from bondem.specimen.lattice import Lattice


@staged("impact")
def impact(
    lattice: Lattice,
    law: AnyLaw,
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
    x_min. A body of cells is driven at its wall. Its far cells feel the front and its reflection at equal times
    before and after it reaches the wall, so that their path is the whole length, too.

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
    check("impact", lattice, density=density, E=E, nu=nu, rho=rho, velocity=velocity, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, depth=depth)
    expected = bar.paper.length / bar.paper.wave_speed
    wave = strike(lattice, law, density=density, duration=2.7 * expected, velocity=velocity, depth=depth)
    plateau = wave.far[wave.time >= 1.4 * expected].mean()
    if not plateau > velocity:
        raise InputError(
            f"no wave arrived: the far face moves at {plateau:.3g} m/s, not near {2.0 * velocity:g};"
            " check E=, rho= and density=, or use a finer specimen"
        )
    arrival = first_passage(wave.time, wave.far, 0.5 * plateau)
    path = ends(lattice, depth)[1] - float(lattice.particles.envelope.bounds[0][0])
    speed = bar.paper.wave_speed
    return Outcome(
        name="impact",
        measured=bar.paper.length / arrival,
        theory=speed,
        # the same path in both numbers would cancel, so the ratio of paths goes into the theory
        theory_refined=speed * bar.paper.length / path,
        unit="m/s",
        curves={
            "time": wave.time,
            "near": wave.near,
            "far": wave.far,
            "arrival": np.array(arrival),
            "plateau": np.array(plateau),
        },
    )
