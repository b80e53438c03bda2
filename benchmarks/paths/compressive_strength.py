"""Compression, with a pressure on the sides and without, and splitting: as a Mohr–Coulomb continuum has it."""

import math

import bondem as bd
from paths.driving import ANGLE, COHESION, ENERGY, LAW, TENSION
from paths.rows import Row

#: Pressures on the sides [Pa], and limits of compression and splitting [-].
PRESSURES, LIMIT, SPLIT_LIMIT = (0.0, 5e6, 10e6), 0.02, 0.05
#: G_II, at which cells slip all at once [J/m²].
SHEARED = 500.0
SIZE = (60e-3, 30e-3, 30e-3)
MATERIAL = bd.MohrCoulomb(
    tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=ENERGY, fracture_energy_shear=SHEARED
)


def compression(seed: int, count: int) -> list[Row]:
    """UCS and triaxial strength over (2 c cos φ + p (1 + sin φ)) / (1 - sin φ)."""
    body = bd.connect(bd.pack(bd.Box(SIZE), count=count, method="even", seed=seed), method="laguerre")
    sine, cosine = math.sin(ANGLE), math.cos(ANGLE)
    rows = []
    for pressure in PRESSURES:
        test = bd.labtests.uniaxial_compression(body, LAW, MATERIAL, pressure=pressure, traverses=30.0, reach=1.5)
        theory = (2.0 * COHESION * cosine + pressure * (1.0 + sine)) / (1.0 - sine)
        name = f"compression at {pressure / 1e6:g} MPa on the sides [Pa]"
        rows.append(
            Row("compression", name, test.peak, theory, LIMIT, seed, count, note=f"residual {test.residual:.1e}")
        )  # fmt: skip
    return rows


def splitting(seed: int, count: int) -> list[Row]:
    """Brazilian strength of a short cylinder, with the factor of its strips, over f_t.

    Small beside E G_f / f_t², a disc bears more than a brittle one does: G_f is that of a brittle material here.
    """
    disc = bd.Cylinder(radius=25e-3, length=20e-3)
    body = bd.connect(bd.pack(disc, count=count, method="even", seed=seed), method="laguerre")
    brittle = bd.MohrCoulomb(
        tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=5.0, fracture_energy_shear=SHEARED
    )  # fmt: skip
    test = bd.labtests.brazilian(body, LAW, brittle, traverses=50.0)
    return [Row("compression", "Brazilian strength over f_t", test.tension / TENSION, 1.0, SPLIT_LIMIT, seed, count)]
