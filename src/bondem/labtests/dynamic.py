"""First natural frequencies of a clamped specimen, compared with the vibrations of bars."""

import numpy as np

from bondem._progress import staged
from bondem._types import Floats, PerElement
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.frequency import spectrum
from bondem.labtests.modal import NaturalFrequencies, natural_frequencies
from bondem.labtests.outcome import Outcome
from bondem.labtests.vibration import FreeVibration
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant


@staged("dynamic tension")
def dynamic_tension(
    lattice: Lattice, law: AnyLaw, *, density: float | PerElement | Material, E: float | Material,
    nu: float | Material, rho: float | Material, gyration: Floats | None = None,
    modes: NaturalFrequencies | None = None, vibration: FreeVibration | None = None, depth: float = 0.02,
) -> Outcome:  # fmt: skip
    """Compare the first axial frequency of a clamped specimen with √(E/ρ) / (4 L).

    The measured value is the natural frequency of the modes, which needs no signal processing. Given a free
    vibration, `Outcome.curves` has its signal, spectrum and frequency ("free_vibration").

    Args:
        lattice: the specimen.
        law: bond law or cell law of the specimen; the non-local law has no modes, and raises InputError.
        density: density of the elements, ρ_μ [kg/m³], a number or (n,); `theory_refined` uses the distribution of
            their mass.
        E: Young's modulus of the specimen [Pa].
        nu: Poisson's ratio of the specimen [-].
        rho: density of the specimen, mass over volume of the shape [kg/m³].
        gyration: `Tension.gyration` of the specimen [m²], (2,), for `theory_refined`; None for that of the shape.
        modes: natural frequencies of the specimen, if known; None to compute them.
        vibration: free vibration of the specimen, or None.
        depth: depth of the two face regions, in mean radii [-].

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: neither a Cylinder nor a Box, a kind of mode missing among the first 8, or a value out of range.
    """
    density, E, nu, rho = constant("density", density), constant("E", E), constant("nu", nu), constant("rho", rho)
    check("dynamic_tension", lattice, density=density, E=E, nu=nu, rho=rho, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, gyration=gyration, density=density, depth=depth)
    modes = modes or natural_frequencies(lattice, law, density=density, depth=depth)
    return Outcome(
        name="dynamic_tension", measured=modes.tension, theory=bar.paper.axial_frequency,
        theory_refined=bar.moving.axial_frequency, unit="Hz", curves=_curves(vibration, "tension"),
    )  # fmt: skip


@staged("dynamic bending")
def dynamic_bending(
    lattice: Lattice, law: AnyLaw, *, density: float | PerElement | Material, E: float | Material,
    nu: float | Material, rho: float | Material, gyration: Floats | None = None,
    modes: NaturalFrequencies | None = None, vibration: FreeVibration | None = None, depth: float = 0.02,
) -> Outcome:  # fmt: skip
    """Compare the first bending frequency of a clamped specimen with Euler–Bernoulli's and Timoshenko's cantilevers.

    `Outcome.curves` has the signal, spectrum and frequency of the free vibration, if it is given.

    Args:
        lattice: the specimen.
        law: bond law or cell law of the specimen; the non-local law has no modes, and raises InputError.
        density: density of the elements, ρ_μ [kg/m³], a number or (n,).
        E: Young's modulus of the specimen [Pa].
        nu: Poisson's ratio of the specimen [-].
        rho: density of the specimen, mass over volume of the shape [kg/m³].
        gyration: `Tension.gyration` of the specimen [m²], (2,), for `theory_refined`; None for that of the shape.
        modes: natural frequencies of the specimen, if known; None to compute them.
        vibration: free vibration of the specimen, or None.
        depth: depth of the two face regions, in mean radii [-].

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: neither a Cylinder nor a Box, a kind of mode missing among the first 8, or a value out of range.
    """
    density, E, nu, rho = constant("density", density), constant("E", E), constant("nu", nu), constant("rho", rho)
    check("dynamic_bending", lattice, density=density, E=E, nu=nu, rho=rho, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, gyration=gyration, density=density, depth=depth)
    modes = modes or natural_frequencies(lattice, law, density=density, depth=depth)
    return Outcome(
        name="dynamic_bending", measured=modes.bending, theory=bar.paper.bending_frequency,
        theory_timoshenko=bar.paper.bending_frequency_timoshenko,
        theory_refined=bar.moving.bending_frequency_timoshenko, unit="Hz", curves=_curves(vibration, "bending"),
    )  # fmt: skip


@staged("dynamic torsion")
def dynamic_torsion(
    lattice: Lattice, law: AnyLaw, *, density: float | PerElement | Material, E: float | Material,
    nu: float | Material, rho: float | Material, gyration: Floats | None = None,
    modes: NaturalFrequencies | None = None, vibration: FreeVibration | None = None, depth: float = 0.02,
) -> Outcome:  # fmt: skip
    """Compare the first torsional frequency of a clamped specimen with √(G J / (ρ I_p)) / (4 L).

    `Outcome.curves` has the signal, spectrum and frequency of the free vibration, if it is given.

    Args:
        lattice: the specimen.
        law: bond law or cell law of the specimen; the non-local law has no modes, and raises InputError.
        density: density of the elements, ρ_μ [kg/m³], a number or (n,).
        E: Young's modulus of the specimen [Pa].
        nu: Poisson's ratio of the specimen [-].
        rho: density of the specimen, mass over volume of the shape [kg/m³].
        gyration: `Tension.gyration` of the specimen [m²], (2,), for `theory_refined`; None for that of the shape.
        modes: natural frequencies of the specimen, if known; None to compute them.
        vibration: free vibration of the specimen, or None.
        depth: depth of the two face regions, in mean radii [-].

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: neither a Cylinder nor a Box, a kind of mode missing among the first 8, or a value out of range.
    """
    density, E, nu, rho = constant("density", density), constant("E", E), constant("nu", nu), constant("rho", rho)
    check("dynamic_torsion", lattice, density=density, E=E, nu=nu, rho=rho, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, gyration=gyration, density=density, depth=depth)
    modes = modes or natural_frequencies(lattice, law, density=density, depth=depth)
    return Outcome(
        name="dynamic_torsion", measured=modes.torsion, theory=bar.paper.torsional_frequency,
        theory_refined=bar.moving.torsional_frequency, unit="Hz", curves=_curves(vibration, "torsion"),
    )  # fmt: skip


def _curves(vibration: FreeVibration | None, kind: str) -> dict[str, Floats]:
    if vibration is None:
        return {}
    signal = vibration.signal[kind]
    frequency, amplitude = spectrum(vibration.time, signal)
    return {
        "time": vibration.time, "signal": signal, "frequency": frequency, "amplitude": amplitude,
        "free_vibration": np.array(vibration.frequency(kind)),
    }  # fmt: skip
