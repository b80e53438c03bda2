"""Fused silica in Python: pack a cylinder, calibrate its bonds, then pull, bend and ring it.

Physics: André et al. (2012). Expected: E = 72.5 GPa and ν = 0.17 on this specimen, by r̃ of about 0.70; the first
bending frequency within 6.5 % of Euler–Bernoulli theory and 2 % of Timoshenko's. Takes about 8 s of a core.

Run it with:  python examples/silica.py
"""

from dataclasses import dataclass

import bondem as bd


@dataclass(frozen=True)
class Answer:
    """What the example finds: moduli [Pa], [-], errors against theory [-]."""

    E: float
    nu: float
    radius_ratio: float
    bending_error: float
    frequency_error: float
    frequency_error_timoshenko: float


def main(count: int = 10_000) -> Answer:
    """Pack `count` spheres, calibrate and test them."""
    silica = bd.Material("fused silica", E=72.5e9, nu=0.17, rho=2201.0)
    particles = bd.pack(bd.Cylinder(radius=5e-3, length=40e-3), count=count, spread=0.25, seed=1)
    lattice = bd.connect(particles)
    quality = bd.fabric(lattice)
    print(f"z = {quality.coordination_number:.3f}, φ = {quality.volume_fraction:.4f}, isotropic: {quality.passed}")

    fit = bd.calibrate(lattice, silica, law=bd.EulerBernoulli)
    print(f"E_μ = {fit.law.E / 1e9:.1f} GPa, r̃ = {fit.law.radius_ratio:.4f}, ρ_μ = {fit.density:.0f} kg/m³")

    tension = bd.labtests.static_tension(lattice, fit.law)
    print(f"E = {tension.E / 1e9:.3f} GPa, ν = {tension.nu:.5f}")

    own = {"E": tension.E, "nu": tension.nu}
    bending = bd.labtests.static_bending(lattice, fit.law, **own)
    ringing = bd.labtests.dynamic_bending(lattice, fit.law, density=fit.density, rho=silica.rho, **own)
    for outcome in (bending, ringing):
        print(f"{outcome.name}: {outcome.error:+.2%}, against Timoshenko {outcome.error_timoshenko:+.2%}")
    return Answer(
        tension.E, tension.nu, fit.law.radius_ratio, bending.error, ringing.error, ringing.error_timoshenko
    )


if __name__ == "__main__":
    main()
