"""Pipeline of `bondem calibrate`: pack, bond, calibrate and state the uncertainty."""

import json
import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bondem import __version__
from bondem._checks import count as whole
from bondem._checks import instance, number
from bondem.calibration.elastic import Calibration, calibrate
from bondem.calibration.reach import recommend
from bondem.calibration.strength import StrengthCalibration
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Cell, Cylinder, Shape
from bondem.interactions.beams.bond_law import BondLaw
from bondem.io.atomic import make_folder, require_folder, write_text
from bondem.packing import SEED, pack
from bondem.packing.sizes import SPREAD, Uniform
from bondem.report.calibration_figure import draw_calibration
from bondem.specimen.bonding import connect
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material

#: Shapes of calibration specimens. Results depend on the number of elements, and not on the size of a shape.
SHAPES: dict[str, Shape] = {"cell": Cell((10e-3, 10e-3, 10e-3)), "cylinder": Cylinder(radius=5e-3, length=40e-3)}


@dataclass(frozen=True, kw_only=True)
class CalibrationPlan:
    """Plan of a calibration from packing to bond parameters; an invalid value raises InputError.

    Attributes:
        material: target material.
        law: family of bond laws; None for the recommended one.
        count: number of elements per packing.
        packings: number of packings, with seeds seed, seed + 1, …
        shape: "cell", which is periodic and without surfaces, or "cylinder", that of André et al. (2012).
        spread: full range of the radii over their mean, κ [-].
        nu_mu: Poisson's ratio of the bonds [-].
        seed: seed of the first packing.
        ucs, tension: strengths in compression and in direct tension [Pa]; None for elasticity only.
        friction_angle: friction angle of the bonds [rad].
    """

    material: Material
    law: type[BondLaw] | None = None
    count: int = 10_000
    packings: int = 3
    shape: str = "cell"
    spread: float = SPREAD
    nu_mu: float = 0.3
    seed: int = SEED
    ucs: float | None = None
    tension: float | None = None
    friction_angle: float = math.radians(35.0)

    def __post_init__(self) -> None:
        if self.shape not in SHAPES:
            raise InputError(f"shape = '{self.shape}': unknown shape; choose from {', '.join(SHAPES)}")
        instance("calibrate", "material", self.material, Material, "a material such as bd.materials.granite")
        for name, least in (("count", 1), ("packings", 1), ("seed", 0)):
            whole("", name, getattr(self, name), least=least)
        if (self.ucs is None) != (self.tension is None):
            raise InputError("ucs and tension belong together; give both strengths, or neither")
        if self.ucs is not None and self.shape == "cell":
            raise InputError("ucs and tension need specimens with ends; set the shape to cylinder, of fewer elements")
        Uniform(self.spread)
        number("", "nu_mu", self.nu_mu, above=-1.0, below=0.5, advice="a Poisson's ratio in (-1, 0.5)")


def run_calibration(
    plan: CalibrationPlan,
    out: str | Path | None = None,
    *,
    cache: bool = True,
    progress: Callable[[str, float], None] | None = None,
) -> tuple[Calibration, dict[str, Any]]:
    """Pack and calibrate; with a folder, write `calibration.json` and `calibration.png`.

    Args:
        plan: plan of the calibration.
        out: folder for the results, or None.
        cache: True to reuse packings of earlier calls from disk.
        progress: callback, called with the stage and its completed share [-], or None.

    Returns:
        The calibration, and the contents of `calibration.json`.

    Raises:
        InputError: the folder cannot be written to, or the plan is not feasible.
        PackingError: a packing did not reach its target.
        UnreachableTargetError: the law cannot give the material's Poisson's ratio.
    """
    if out is not None:
        require_folder(Path(out), "output folder")
    on_stage = progress or (lambda stage, share: None)
    if plan.law is None:
        recommend(plan.material.nu)  # raises before any work
    start = time.perf_counter()
    lattices: list[Lattice] = []
    for k in range(plan.packings):
        stage = f"pack {k + 1} of {plan.packings}"
        particles = pack(
            SHAPES[plan.shape], count=plan.count, spread=plan.spread, seed=plan.seed + k, cache=cache,
            progress=lambda share, stage=stage: on_stage(stage, share),
        )  # fmt: skip
        lattices.append(connect(particles))
    packed = time.perf_counter()
    on_stage("calibrate", 0.0)
    fit = calibrate(
        lattices, plan.material, law=plan.law, nu_mu=plan.nu_mu, ucs=plan.ucs, tension=plan.tension,
        friction_angle=plan.friction_angle,
    )  # fmt: skip
    on_stage("calibrate", 1.0)
    seconds = {"pack_s": round(packed - start, 3), "calibrate_s": round(time.perf_counter() - packed, 3)}
    found = _summary(plan, fit, lattices) | {"timing": seconds, "version": __version__}
    if out is not None:
        folder = Path(out)
        make_folder(folder)
        write_text(folder / "calibration.json", json.dumps(found, indent=2, allow_nan=False) + "\n")
        draw_calibration(folder / "calibration.png", fit)
    return fit, found


def _summary(plan: CalibrationPlan, fit: Calibration, lattices: list[Lattice]) -> dict[str, Any]:
    """Collect a calibration as finite numbers in SI; scatter and intervals are None for a single packing."""
    several = len(fit.responses) > 1
    quantities: dict[str, Any] = {}
    for name in ("E", "nu", "E_mu", "value"):
        sample = fit.sample(name)
        quantities[name] = {
            "mean": sample.mean, "std": sample.std if several else None,
            "confidence_95": sample.interval() if several else None,
            "prediction_95": sample.interval(kind="prediction") if several else None,
        }  # fmt: skip
    slopes = {name: fit.sensitivity(name) for name in dict.fromkeys((fit.parameter, "nu"))}
    material = fit.material
    return {
        "material": {"name": material.name, "E": material.E, "nu": material.nu, "rho": material.rho},
        "specimen": {
            "shape": plan.shape, "elements": plan.count, "packings": plan.packings,
            "seeds": [plan.seed + k for k in range(plan.packings)], "spread": plan.spread,
            "coordination_number": [2.0 * len(one.pairs) / len(one.particles) for one in lattices],
        },
        "law": type(fit.law).__name__, "reason": fit.reason, "parameter": fit.parameter,
        "micro": {"E_mu": fit.law.E, "nu_mu": fit.law.nu, fit.parameter: fit.value,
                  "r_mu_ratio": fit.law.radius_ratio, "rho_mu": fit.density},
        "quantities": quantities,
        "packings_for_1_percent": {name: fit.packings_for(0.01, quantity=name) if several else None
                                   for name in ("E", "nu")},
        "sensitivity": {name: {"log_E": one.log_E, "nu": one.nu} for name, one in slopes.items()},
        "table": [{fit.parameter: one.value, "stiffness_ratio": one.stiffness_ratio, "nu": one.nu}
                  for one in fit.table],
        "strength": None if fit.strength is None else _strength(fit.strength, several),
    }  # fmt: skip


def _strength(fit: StrengthCalibration, several: bool) -> dict[str, Any]:
    """Collect the calibrated strengths of the bonds [Pa]; intervals are None for a single packing."""
    return {
        "reached": fit.reached, "message": fit.message, "parameters": dict(fit.nearest.parameters),
        "confidence_95": {name: fit.interval(name) if several else None for name in fit.names},
        "measured": {name: fit.strengths(name).values.tolist() for name in fit.targets},
        "new_packing_95": {
            name: fit.strengths(name).interval(kind="prediction") if several else None for name in fit.targets
        },
    }  # fmt: skip
