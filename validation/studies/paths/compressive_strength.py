"""Compression, with a pressure on the sides and without, and splitting: as a Mohr–Coulomb continuum has it."""

import json
import math

import bondem as bd
from validation.frame.record import RESULTS
from validation.studies import brazilian
from validation.studies.paths.driving import ANGLE, COHESION, ENERGY, LAW, TENSION
from validation.studies.paths.rows import Row

#: Pressures on the sides [Pa], and limits of compression, and of splitting as before [-].
PRESSURES, LIMIT, SPLIT_LIMIT = (0.0, 5e6, 10e6), 0.01, 0.02
#: G_II, at which cells slip all at once [J/m²].
SHEARED = 500.0
#: Fracture energies of discs [J/m²].
SPLIT = (5.0, 80.0)
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
        test = bd.labtests.uniaxial_compression(body, LAW, MATERIAL, pressure=pressure, reach=1.5)
        theory = (2.0 * COHESION * cosine + pressure * (1.0 + sine)) / (1.0 - sine)
        name = f"compression at {pressure / 1e6:g} MPa on the sides [Pa]"
        rows.append(
            Row("compression", name, test.peak, theory, LIMIT, note=f"residual {test.residual:.1e}")
        )  # fmt: skip
    return rows


def splitting(seed: int, count: int) -> list[Row]:
    """Brazilian strength of the disc of `brazilian.py`, over what was kept of the same packing before."""
    kept = json.loads((RESULTS / "brazilian.json").read_text())["cases"]
    body, rows = brazilian.DISC.body(count, seed), []
    for energy in SPLIT:
        case = count, seed, energy
        before = [one["strength"] for one in kept if (one["count"], one["seed"], one["energy"]) == case]
        theory = before[0] if before else 1.0
        found = brazilian.measured(body, energy)
        name, note = f"Brazilian, G_f = {energy:g} J/m²: strength over f_t", f"residual {found['residual']:.1e}"
        rows.append(Row("compression", name, found["strength"], theory, SPLIT_LIMIT, note=note))
    return rows
