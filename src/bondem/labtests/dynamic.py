"""First natural frequencies of a clamped specimen against the vibrations of bars."""

import numpy as np

from bondem._progress import staged
from bondem._types import Floats, PerElement
from bondem.labtests.arguments import AnyLaw, check
from bondem.labtests.cantilever import Cantilever
from bondem.labtests.frequency import spectrum
from bondem.labtests.modal import NaturalFrequencies, natural_frequencies
from bondem.labtests.outcome import Outcome
from bondem.labtests.vibration import FreeVibration
from bondem.specimen.lattice import Lattice


@staged("dynamic tension")
def dynamic_tension(
    lattice: Lattice,
    law: AnyLaw,
    *,
    density: float | PerElement,
    E: float,
    nu: float,
    rho: float,
    gyration: Floats | None = None,
    modes: NaturalFrequencies | None = None,
    vibration: FreeVibration | None = None,
    depth: float = 0.02,
) -> Outcome:
    """First axial frequency against √(E/ρ) / (4 L).

    The measured value is that of the modes, which needs no signal processing. With a free vibration at hand,
    `curves` holds its signal, spectrum and frequency ("free_vibration") too.

    Args:
        lattice: the specimen.
        law: its bonds.
        density: of the elements, ρ_μ [kg/m³], a number or (n,); `theory_refined` has their mass where it is.
        E: its own Young's modulus [Pa].
        nu: its own Poisson's ratio [-].
        rho: its own density, mass over volume of the shape [kg/m³].
        gyration: `Tension.gyration`, for `theory_refined`, a consistency check.
        modes: its natural frequencies, where they are known already.
        vibration: its free vibration, likewise.
        depth: of the two faces, in mean radii [-].
    """
    check("dynamic_tension", lattice, density=density, E=E, nu=nu, rho=rho, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, gyration=gyration, density=density, depth=depth)
    modes = modes or natural_frequencies(lattice, law, density=density, depth=depth)
    return Outcome(
        name="dynamic_tension",
        measured=modes.tension,
        theory=bar.paper.axial_frequency,
        theory_refined=bar.moving.axial_frequency,
        unit="Hz",
        curves=_curves(vibration, "tension"),
    )


@staged("dynamic bending")
def dynamic_bending(
    lattice: Lattice,
    law: AnyLaw,
    *,
    density: float | PerElement,
    E: float,
    nu: float,
    rho: float,
    gyration: Floats | None = None,
    modes: NaturalFrequencies | None = None,
    vibration: FreeVibration | None = None,
    depth: float = 0.02,
) -> Outcome:
    """First bending frequency against the cantilevers of Euler–Bernoulli and of Timoshenko.

    Arguments as for `dynamic_tension`.
    """
    check("dynamic_bending", lattice, density=density, E=E, nu=nu, rho=rho, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, gyration=gyration, density=density, depth=depth)
    modes = modes or natural_frequencies(lattice, law, density=density, depth=depth)
    return Outcome(
        name="dynamic_bending",
        measured=modes.bending,
        theory=bar.paper.bending_frequency,
        theory_timoshenko=bar.paper.bending_frequency_timoshenko,
        theory_refined=bar.moving.bending_frequency_timoshenko,
        unit="Hz",
        curves=_curves(vibration, "bending"),
    )


@staged("dynamic torsion")
def dynamic_torsion(
    lattice: Lattice,
    law: AnyLaw,
    *,
    density: float | PerElement,
    E: float,
    nu: float,
    rho: float,
    gyration: Floats | None = None,
    modes: NaturalFrequencies | None = None,
    vibration: FreeVibration | None = None,
    depth: float = 0.02,
) -> Outcome:
    """First torsional frequency against √(G J / (ρ I_p)) / (4 L).

    Arguments as for `dynamic_tension`.
    """
    check("dynamic_torsion", lattice, density=density, E=E, nu=nu, rho=rho, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, rho=rho, gyration=gyration, density=density, depth=depth)
    modes = modes or natural_frequencies(lattice, law, density=density, depth=depth)
    return Outcome(
        name="dynamic_torsion",
        measured=modes.torsion,
        theory=bar.paper.torsional_frequency,
        theory_refined=bar.moving.torsional_frequency,
        unit="Hz",
        curves=_curves(vibration, "torsion"),
    )


def _curves(vibration: FreeVibration | None, kind: str) -> dict[str, Floats]:
    if vibration is None:
        return {}
    signal = vibration.signal[kind]
    frequency, amplitude = spectrum(vibration.time, signal)
    return {
        "time": vibration.time,
        "signal": signal,
        "frequency": frequency,
        "amplitude": amplitude,
        "free_vibration": np.array(vibration.frequency(kind)),
    }
