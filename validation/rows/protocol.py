"""A bar measured as André et al. (2012) measure theirs: dimensions and moduli by eqs (12)–(15), explicit runs."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from scipy.optimize import root_scalar

import bondem as bd
from bondem.errors import InputError
from bondem.labtests.beam_tests import Bar, CrossSection
from bondem.labtests.faces import specimen_faces
from bondem.labtests.wave import first_passage, strike
from bondem.specimen.materials import fused_silica
from validation.frame.files import plain
from validation.measures.ramped_loads import KINDS, ramped_load
from validation.measures.ramped_vibration import ramped_vibration
from validation.rows.packings import PackingTest, kept_lattice

#: Table 2 of the paper.
PRINTED = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
#: How E and ν are read off a tension test: eqs (12)–(15), or the affine fit of `static_tension`.
MEASURES = ("paper", "affine")
#: Levels of the first peak of the far face at which a wave may be said to have arrived [-].
LEVELS = (0.01, 0.1, 0.5)

_DEPTH = 0.02  # of the face sets, in mean radii
_RAMP, _PHI = 0.5, 1.3  # §5.1.3 prints φ
_VELOCITY = 0.1  # of the strike [m/s]
_PASSAGES = 2.7  # recorded after it
_RATIOS = (0.71, 0.69)  # radius ratios to begin with [-]


@dataclass(frozen=True)
class ProtocolTest(PackingTest):
    """A bar that calibrates its own bonds by the paper's measure, and is tested as in Tables 3 and 4.

    Attributes:
        packing: made before.
        steps: of each explicit run.
    """

    steps: int

    @property
    def weight(self) -> float:
        return super().weight * self.steps

    @property
    def asked(self) -> dict[str, Any]:
        return super().asked | {"steps": self.steps}

    def measured(self, folder: Path) -> dict[str, Any]:
        """Moduli with the printed bonds, calibrated bonds by both measures, and errors of the seven tests."""
        lattice = kept_lattice(self.packing, folder)
        faces = specimen_faces(lattice, _DEPTH)
        found: dict[str, Any] = {
            "coordination_number": 2.0 * len(lattice.pairs) / len(lattice.particles),
            "volume_fraction": lattice.particles.volume.sum() / lattice.particles.envelope.volume,
            "length": faces.paper_length, "radius": faces.paper_radius,
        }  # fmt: skip
        printed = bd.Response(lattice, PRINTED)
        for measure in MEASURES:
            E, nu = moduli(printed, measure)
            ratio, E_mu = own_bonds(lattice, measure)
            found |= {f"printed_E_{measure}": E, f"printed_nu_{measure}": nu,
                      f"r_mu_ratio_{measure}": ratio, f"E_mu_{measure}": E_mu}  # fmt: skip
        return plain(found | _tested(lattice, found["r_mu_ratio_paper"], found["E_mu_paper"], self.steps))


def moduli(found: bd.Response, measure: str) -> tuple[float, float]:
    """E [Pa] and ν by one of the two measures."""
    tension = found.tension
    assert tension is not None
    assert tension.nu_paper is not None
    return (tension.E_paper, tension.nu_paper) if measure == "paper" else (tension.E, tension.nu)


def own_bonds(lattice: bd.Lattice, measure: str) -> tuple[float, float]:
    """r̃ and E_μ [Pa] with which one packing has the E and ν of fused silica (§5.3).

    Raises:
        InputError: no radius ratio has that ν.
    """
    last = bd.Response(lattice, PRINTED)

    def miss(ratio: float) -> float:
        nonlocal last
        last = bd.Response(lattice, replace(PRINTED, radius_ratio=ratio), guess=last)
        return moduli(last, measure)[1] - fused_silica.nu

    solved = root_scalar(miss, x0=_RATIOS[0], x1=_RATIOS[1], method="secant", xtol=1e-5)
    if not solved.converged:
        raise InputError(f"no radius ratio near {_RATIOS[0]} gives ν = {fused_silica.nu} by the {measure} measure")
    miss(solved.root)
    return float(solved.root), PRINTED.E * fused_silica.E / moduli(last, measure)[0]


def _tested(lattice: bd.Lattice, ratio: float, E_mu: float, steps: int) -> dict[str, Any]:
    """Errors [-] against strength of materials of a cylinder with the dimensions of eqs (12), (13)."""
    law = replace(PRINTED, E=E_mu, radius_ratio=ratio)
    faces = specimen_faces(lattice, _DEPTH)
    shape = bd.Cylinder(radius=faces.paper_radius, length=faces.paper_length)
    bar = Bar(shape.length, CrossSection.of(shape), fused_silica.E, fused_silica.nu, fused_silica.rho)
    density = fused_silica.rho * shape.volume / lattice.particles.volume[lattice.connected].sum()
    errors: dict[str, float] = {}
    for kind in KINDS:
        run = ramped_load(lattice, law, bar, kind, density=density, steps=steps, ramp=_RAMP, phi=_PHI)
        errors[f"static_{kind}"] = run.error
    free = ramped_vibration(lattice, law, density=density, steps=steps)
    theory = (bar.axial_frequency, bar.bending_frequency, bar.torsional_frequency)
    errors |= {f"dynamic_{kind}": free.frequency(kind) / f - 1.0 for kind, f in zip(KINDS, theory, strict=True)}
    errors["dynamic_bending_timoshenko"] = free.frequency("bending") / bar.bending_frequency_timoshenko - 1.0
    passage = bar.length / bar.wave_speed
    wave = strike(lattice, law, density=density, duration=_PASSAGES * passage, velocity=_VELOCITY, held=False)
    peak = float(wave.far[wave.time <= 2.0 * passage].max())
    for level in LEVELS:
        errors[f"impact_{level:g}"] = passage / first_passage(wave.time, wave.far, level * peak) - 1.0
    return {"errors": errors}
