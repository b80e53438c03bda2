"""Energies of a free vibration, and inertia (André et al. 2012, fig. 19, eq 19)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

import bondem as bd
from bondem.labtests.cantilever import Cantilever
from bondem.specimen.materials import fused_silica
from validation.figures.energy import draw_breakdown, draw_inertia, draw_vibration_energy
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers
from validation.frame.study import Row
from validation.measures.inertia import inertia_excess, stiffness_effect
from validation.measures.ramped_vibration import ramped_vibration
from validation.rows.bar import BarStudy, BarTest, CalibratedBar
from validation.rows.packings import PackingRequest
from validation.studies.quasistatic import shares

_KINDS = ("tension", "bending", "torsion")
# Share of the steps in which the loads grow [-].
_RAMP = 0.4
_PARTS = ("normal", "shear", "bending", "twisting")
# The share of mass that decides which mode is which: along x, along y, about x.
_COLUMN = {"tension": 0, "bending": 1, "torsion": 3}


@dataclass(frozen=True)
class VibrationTest(BarTest):
    """A bar weighed, its modes, and where steps are asked for its free vibration.

    Attributes:
        steps: of the run, 0 for none.
    """

    steps: int

    @property
    def weight(self) -> float:
        return float(self.packing.count) * (1000 + self.steps)

    def tested(self, bar: CalibratedBar, folder: Path) -> dict[str, Any]:
        """Moments of inertia and first frequencies; the course of the vibration is kept."""
        modes = bd.labtests.natural_frequencies(bar.lattice, bar.law, density=bar.density)
        row = _weighed(bar, modes)
        if not self.steps:
            return row
        run = ramped_vibration(bar.lattice, bar.law, density=bar.density, steps=self.steps, ramp=_RAMP)
        self.keep(folder, run)
        return row | {"run": _numbers(run, modes)}


@dataclass(frozen=True)
class Vibration(BarStudy):
    """Energies of a free vibration, and the specimen's inertia: figure 19 and eq (19) of André et al. (2012).

    Attributes:
        count: spheres of a packing.
        seed: of the first packing, on which the bonds are calibrated.
        packings: how many, seeds in sequence; the first one vibrates, all are weighed.
        steps: of the run.
    """

    limits: ClassVar = BarStudy.limits | {"steps": numbers(least=1000)}

    packings: int = 5
    steps: int = 50_000

    def tests(self, packings: Sequence[PackingRequest], law: bd.BondLaw, density: float) -> Sequence[VibrationTest]:
        return [VibrationTest(one, law, density, self.steps if k == 0 else 0) for k, one in enumerate(packings)]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        return rows[0]["bar"] | {"run": rows[0]["run"], "summary": _summary(rows)}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figure 19, the energies of the motion, and inertia."""
        figures = out / "figures"
        _, run = self.first(out)
        after = run.time[-1] - run.released
        draw_breakdown(
            figures / "vibration_breakdown.png", run.time, run.energy, mark=run.released, mark_name="let go",
            window=(run.released - 0.05 * after, run.released + 0.25 * after),
        )  # fmt: skip
        draw_vibration_energy(figures / "vibration_energy.png", run)
        draw_inertia(figures / "vibration_inertia.png", results["summary"])


def _numbers(run: bd.labtests.FreeVibration, modes: bd.labtests.NaturalFrequencies) -> dict[str, Any]:
    free, energy = run.free, run.energy
    kinetic = energy["translation"] + energy["rotation"]
    total = kinetic + sum((energy[name] for name in _PARTS), np.zeros(1))
    drift = np.polynomial.Polynomial.fit(run.time[free], total[free], 1).convert().coef[1]
    return {
        "shares": shares({name: float(energy[name][free].mean()) for name in _PARTS}),
        "rotational_share_mean": float(energy["rotation"][free].sum() / kinetic[free].sum()),
        "energy_error": run.energy_error,
        "total_drift": float(drift * np.ptp(run.time[free]) / total[free].mean()),
        "frequency": {kind: {"signal": run.frequency(kind), "mode": getattr(modes, kind)} for kind in _KINDS},
    }


def _weighed(bar: CalibratedBar, found: bd.labtests.NaturalFrequencies) -> dict[str, Any]:
    weighed = inertia_excess(bar.lattice, density=bar.density, rho=bar.rho)
    beam = Cantilever.of(bar.lattice, **bar.own, gyration=bar.tension.gyration)
    force = stiffness_effect(beam.paper, beam.moving)
    theory = {
        "tension": beam.paper.axial_frequency,
        "bending": beam.paper.bending_frequency_timoshenko,
        "torsion": beam.paper.torsional_frequency,
    }
    return {
        "mass": weighed.mass,
        "mass_excess": weighed.mass / (fused_silica.rho * bar.lattice.particles.envelope.volume) - 1.0,
        "axial_excess": weighed.axial_excess,
        "lateral_excess": weighed.lateral_excess,
        "frequency": {
            kind: {
                "mass": weighed.frequency[kind],
                "stiffness": force[kind],
                "measured": getattr(found, kind) / theory[kind] - 1.0,
                "rotational_share": rotational_share(bar, found, kind),
            }
            for kind in _KINDS
        },
    }


def rotational_share(bar: CalibratedBar, found: bd.labtests.NaturalFrequencies, kind: str) -> float:
    """Share of the kinetic energy of a first mode that is in the rotation of the elements [-]."""
    model = bd.Model(bar.lattice, bar.law, density=bar.density)
    mass = found.mass_share
    column = mass[:, 1] + mass[:, 2] if kind == "bending" else mass[:, _COLUMN[kind]]
    shape = found.modes.shape[int(np.argmax(column))]
    turning = float(model.inertia @ (shape[:, 3:] ** 2).sum(axis=1))
    return turning / (turning + float(model.mass @ (shape[:, :3] ** 2).sum(axis=1)))


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    scalars = ("mass_excess", "axial_excess", "lateral_excess")
    found: dict[str, Any] = {name: mean_and_scatter([row[name] for row in rows]) for name in scalars}
    found["frequency"] = {
        kind: {
            part: mean_and_scatter([row["frequency"][kind][part] for row in rows])
            for part in ("mass", "stiffness", "measured", "rotational_share")
        }
        for kind in _KINDS
    }
    found["packings"] = len(rows)
    return found
