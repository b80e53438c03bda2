"""A slow tensile test by explicit dynamics (André et al. 2012, figs 10, 12)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from bondem.interactions.beams.bond_law import BondLaw
from bondem.observables.energy import EnergyParts
from validation.figures.energy import draw_breakdown, draw_quasistatic, draw_settling
from validation.frame.limits import numbers
from validation.frame.study import Row
from validation.measures.explicit_tension import ExplicitTension, explicit_tension
from validation.rows.bar import BarStudy, BarTest, CalibratedBar
from validation.rows.packings import PackingRequest

# Share of the steps in which the load grows, and φ of the scheme of Tchamwa and Wielgosz [-].
_RAMP, _PHI = 0.5, 1.3
# Shorter runs beside the one asked for: what steps buy.
_SHORTER = (0.1, 0.3)
_PARTS = ("normal", "shear", "bending", "twisting")


@dataclass(frozen=True)
class SlowTension(BarTest):
    """A slow tensile test of a bar.

    Attributes:
        steps: of the run.
    """

    steps: int

    @property
    def weight(self) -> float:
        return float(self.packing.count) * self.steps

    def tested(self, bar: CalibratedBar, folder: Path) -> dict[str, Any]:
        """The run beside the static solution; its course is kept."""
        run = explicit_tension(
            bar.lattice, bar.law, density=bar.density, steps=self.steps, ramp=_RAMP, phi=_PHI
        )
        self.keep(folder, run)
        parts: EnergyParts = bar.tension.solution.energy
        static = {name: getattr(parts, name) for name in _PARTS}
        length = float(bar.lattice.particles.envelope.bounds[1][0])
        return _compared(run, bar) | {"shares_static": shares(static), "length": length}


@dataclass(frozen=True)
class QuasiStatic(BarStudy):
    """A slow tensile test by explicit dynamics: figures 10 and 12 of André et al. (2012).

    Attributes:
        count: spheres of the packing.
        seed: of the packing, on which the bonds are calibrated.
        packings: the first is tested.
        steps: of the run.
    """

    limits: ClassVar = BarStudy.limits | {
        "steps": numbers(least=1000, advice="at least 1000; a slow test takes some ten thousands"),
    }  # fmt: skip

    steps: int = 100_000

    def tests(self, packings: Sequence[PackingRequest], law: BondLaw, density: float) -> Sequence[SlowTension]:
        """See `BarStudy`: the run, and shorter ones beside it."""
        steps = [round(share * self.steps) for share in _SHORTER]
        return [
            SlowTension(packings[0], law, density, count)
            for count in (self.steps, *(count for count in steps if count >= 1000))
        ]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        _, run = self.first(out)
        return rows[0]["bar"] | _numbers(rows, run)

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures 10 and 12, and how runs settle."""
        figures = out / "figures"
        run, *shorter = (test.kept(out) for test in self.calibrated_tests(out))
        draw_quasistatic(figures / "quasistatic_energy.png", run, kinetic=results["energy"]["kinetic_theory"])
        draw_breakdown(
            figures / "quasistatic_breakdown.png", run.time, run.energy, mark=run.ramp, mark_name="load full"
        )
        draw_settling(figures / "quasistatic_settling.png", [*shorter, run], results["static"]["E"])


def shares(energy: Mapping[str, float]) -> dict[str, float]:
    """Parts of the elastic energy over the whole [-], the four and the paper's three."""
    whole = sum(energy[name] for name in _PARTS)
    four = {name: energy[name] / whole for name in _PARTS}
    return four | {
        "paper_tension": four["normal"],
        "paper_bending": four["shear"] + four["bending"],
        "paper_torsion": four["twisting"],
    }


def _numbers(rows: Sequence[Row], run: ExplicitTension) -> dict[str, Any]:
    static = rows[0]["bar"]["macro"]
    speed = (static["E"] / static["rho"]) ** 0.5
    elastic = float(run.elastic[-1])
    return {
        "static": {"E": static["E"], "nu": static["nu"]},
        "explicit": sorted(map(_bare, rows), key=lambda row: row["steps"]),
        "energy": {
            "kinetic_theory": (rows[0]["length"] / (speed * run.ramp)) ** 2 / 12.0 * elastic,
            "kinetic_over_elastic": float(run.kinetic.max()) / elastic,
            "shares": shares({name: float(run.energy[name][-1]) for name in _PARTS}),
            "shares_static": rows[0]["shares_static"],
        },
    }  # fmt: skip


def _bare(row: Row) -> Row:
    return {name: value for name, value in row.items() if name not in ("bar", "shares_static", "length")}


def _compared(run: ExplicitTension, bar: CalibratedBar) -> dict[str, Any]:
    static = bar.tension
    return {
        "steps": run.steps,
        "E_ppm": 1e6 * (run.E / static.E - 1.0),
        "nu_ppm": 1e6 * (run.nu / static.nu - 1.0),
    }
