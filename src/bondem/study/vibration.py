"""Energies of a free vibration, and inertia (André et al. 2012, fig. 19, eq 19): `bondem study vibration`."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem.labtests.cantilever import Cantilever
from bondem.labtests.inertia import inertia_excess, stiffness_effect
from bondem.labtests.modal import NaturalFrequencies, natural_frequencies
from bondem.labtests.vibration import FreeVibration, ramped_vibration
from bondem.model.model import Model
from bondem.report.energy_curves import draw_breakdown, draw_inertia, draw_vibration_energy
from bondem.report.study_page import write_study_page
from bondem.specimen.materials import fused_silica
from bondem.study.calibrated_bar import BarRequest, CalibratedBar, calibrated_bars
from bondem.study.quasistatic import shares
from bondem.study.study_files import in_percent, keep_study, mean_and_scatter, study_folder, table, thinned

_KINDS = ("tension", "bending", "torsion")
_PARTS = ("normal", "shear", "bending", "twisting")
# The share of mass that decides which mode is which: along x, along y, about x.
_COLUMN = {"tension": 0, "bending": 1, "torsion": 3}

_CAPTIONS = {
    "vibration_breakdown": """Figure 19. Elastic energy of the bonds by kind, while an axial force, a transverse force
        and a torque grow together on the free end, and after they are let go. Left, about
        that moment, as the paper splits it; right in four shares.""",
    "vibration_energy": """Stored and moving energy; the share of the moving energy that is in the rotation of the
        elements; and what the ledger of energy misses: Verlet keeps an energy of its own, which differs from this one
        by a share of dt², and by another one once the load is gone.""",
    "vibration_inertia": """Left: mass and moments of inertia of the elements that move, with density after eq (19),
        against the continuum. Right: what the first frequencies owe to it, what they owe to the section that forces
        fill, and the whole difference from theory (for bending Timoshenko's). Mean and scatter over the packings.""",
}


@dataclass(frozen=True)
class Vibration:
    """What to run.

    Attributes:
        bar: the packings; the first one vibrates, all are weighed.
        steps: of the run.
        ramp: share of the steps in which the loads grow [-].
    """

    bar: BarRequest = BarRequest(packings=5)
    steps: int = 50_000
    ramp: float = 0.4


def run_vibration(
    study: Vibration, out: str | Path, *, progress: Callable[[str, float], None] | None = None
) -> dict[str, Any]:
    """Load, let go and weigh; leave `results.json`, `table.md`, figure 19 and `report.html` in a folder.

    Args:
        study: what to run.
        out: folder for the results.
        progress: told the stage and the share of it that is done.

    Returns:
        What `results.json` holds.

    Raises:
        InputError: the folder cannot be written to, or too few steps.
    """
    out = study_folder(out)
    tell = progress or (lambda stage, share: None)
    bars = calibrated_bars(study.bar, tell)
    first = bars[0]
    run = ramped_vibration(
        first.lattice, first.law, density=first.density, steps=study.steps, ramp=study.ramp,
        progress=lambda share: tell(f"{study.steps} steps", share),
    )  # fmt: skip
    rows = []
    modes = []
    for k, bar in enumerate(bars):
        modes.append(natural_frequencies(bar.lattice, bar.law, density=bar.density))
        rows.append(_weighed(bar, modes[-1]))
        tell("modes and moments", (k + 1) / len(bars))
    results = {
        "study": "vibration",
        **first.told,
        "run": _numbers(run, modes[0]),
        "summary": _summary(rows),
        "rows": rows,
        "curves": {
            name: thinned(np.asarray(curve))
            for name, curve in {
                "time": run.time,
                **{part: run.energy[part] for part in (*_PARTS, "translation", "rotation", "work")},
            }.items()
        },
    }
    results = keep_study(out, results, _tables(results))
    figures = out / "figures"
    after = run.time[-1] - run.released
    draw_breakdown(
        figures / "vibration_breakdown.png", run.time, run.energy, mark=run.released, mark_name="let go",
        window=(run.released - 0.05 * after, run.released + 0.25 * after),
    )  # fmt: skip
    draw_vibration_energy(figures / "vibration_energy.png", run)
    draw_inertia(figures / "vibration_inertia.png", results["summary"])
    write_study_page(
        out,
        title="Energies of a free vibration, and inertia",
        about=f"André et al. (2012), §6 · {study.bar.count} spheres, {study.steps} steps, {len(bars)} packings",
        verdict=_verdict(results),
        captions={name: " ".join(text.split()) for name, text in _CAPTIONS.items()},
        note="Effects of mass and section are to first order (Rayleigh); modes are those of the specimens.",
    )
    return results


def _numbers(run: FreeVibration, modes: NaturalFrequencies) -> dict[str, Any]:
    free, energy = run.free, run.energy
    kinetic = energy["translation"] + energy["rotation"]
    moving = kinetic[free] > 0.05 * kinetic[free].max()
    share = energy["rotation"][free][moving] / kinetic[free][moving]
    total = kinetic + sum((energy[name] for name in _PARTS), np.zeros(1))
    drift = np.polynomial.Polynomial.fit(run.time[free], total[free], 1).convert().coef[1]
    return {
        "steps": run.steps,
        "dt": run.dt,
        "released": run.released,
        "work": float(energy["work"].max()),
        "shares": shares({name: float(energy[name][free].mean()) for name in _PARTS}),
        "shares_loaded": shares({name: float(energy[name][free][0]) for name in _PARTS}),
        "rotational_share_mean": float(energy["rotation"][free].sum() / kinetic[free].sum()),
        "rotational_share_largest": float(share.max()),
        "energy_error": run.energy_error,
        "total_drift": float(drift * np.ptp(run.time[free]) / total[free].mean()),
        "frequency": {
            kind: {"signal": run.frequency(kind), "mode": getattr(modes, kind)} for kind in _KINDS
        },
    }


def _weighed(bar: CalibratedBar, found: NaturalFrequencies) -> dict[str, Any]:
    weighed = inertia_excess(bar.lattice, density=bar.density, rho=bar.rho)
    beam = Cantilever.of(bar.lattice, **bar.own, gyration=bar.tension.gyration)
    force = stiffness_effect(beam.paper, beam.moving)
    theory = {
        "tension": beam.paper.axial_frequency,
        "bending": beam.paper.bending_frequency_timoshenko,
        "torsion": beam.paper.torsional_frequency,
    }
    return {
        "seed": bar.seed,
        "mass": weighed.mass,
        "mass_excess": weighed.mass / (fused_silica.rho * bar.lattice.particles.envelope.volume) - 1.0,
        "rattler_share": float(1.0 - bar.lattice.connected.mean()),
        "centre": list(weighed.centre),
        "axial_excess": weighed.axial_excess,
        "lateral_excess": weighed.lateral_excess,
        "own_share": weighed.own_share,
        "own_factor": 1.0 - weighed.axial_excess / (1.0 + weighed.axial_excess) / weighed.own_share,
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


def rotational_share(bar: CalibratedBar, found: NaturalFrequencies, kind: str) -> float:
    """Share of the kinetic energy of a first mode that is in the rotation of the elements [-]."""
    model = Model(bar.lattice, bar.law, density=bar.density)
    mass = found.mass_share
    column = mass[:, 1] + mass[:, 2] if kind == "bending" else mass[:, _COLUMN[kind]]
    shape = found.modes.shape[int(np.argmax(column))]
    turning = float(model.inertia @ (shape[:, 3:] ** 2).sum(axis=1))
    return turning / (turning + float(model.mass @ (shape[:, :3] ** 2).sum(axis=1)))


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    scalars = ("mass_excess", "axial_excess", "lateral_excess", "own_share", "own_factor", "rattler_share")
    found: dict[str, Any] = {name: mean_and_scatter([row[name] for row in rows]) for name in scalars}
    found["centre"] = mean_and_scatter([float(np.linalg.norm(row["centre"])) for row in rows])
    found["frequency"] = {
        kind: {
            part: mean_and_scatter([row["frequency"][kind][part] for row in rows])
            for part in ("mass", "stiffness", "measured", "rotational_share")
        }
        for kind in _KINDS
    }
    found["packings"] = len(rows)
    return found


def _tables(results: Mapping[str, Any]) -> str:
    one, run = results["summary"], results["run"]
    weights = table(
        "Elements that move against the continuum, per cent",
        ["quantity", f"mean ± scatter of {one['packings']} packings"],
        [
            ["mass (the first packing by eq 19: 0)", in_percent(one["mass_excess"])],
            ["moment about the axis", in_percent(one["axial_excess"])],
            ["moments across it, through the middle", in_percent(one["lateral_excess"])],
            ["of the moment about the axis, own 2/5 m R² of the elements", in_percent(one["own_share"])],
            ["centre of mass off the middle, over R", in_percent(one["centre"])],
            ["elements left out as rattlers", in_percent(one["rattler_share"])],
        ],
    )
    frequencies = table(
        "First frequencies: shift in per cent of theory",
        ["kind", "by the distribution of mass", "by the section of the forces", "all, as measured",
         "rotational share of the mode's kinetic energy"],
        [
            [kind, *(in_percent(one["frequency"][kind][part])
                     for part in ("mass", "stiffness", "measured", "rotational_share"))]
            for kind in _KINDS
        ],
    )  # fmt: skip
    parts = {"paper_tension": "tension", "paper_bending": "bending (shear + bending)", "paper_torsion": "torsion"}
    energy = table(
        "Elastic energy of the bonds, per cent",
        ["part", "mean after release", "at release"],
        [[label, f"{100.0 * run['shares'][name]:.2f}", f"{100.0 * run['shares_loaded'][name]:.2f}"]
         for name, label in parts.items()],
    )  # fmt: skip
    motion = table(
        "The run",
        ["quantity", "value"],
        [
            ["rotational share of the kinetic energy, mean, per cent", f"{100.0 * run['rotational_share_mean']:.3f}"],
            ["largest", f"{100.0 * run['rotational_share_largest']:.3f}"],
            ["largest imbalance of the ledger over the work of the loads", f"{run['energy_error']:.1e}"],
            ["drift of the total energy over the free vibration", f"{run['total_drift']:+.1e}"],
            *(
                [f"{kind}: frequency of the signal over that of the mode, − 1", f"{_off(both):+.1e}"]
                for kind, both in run["frequency"].items()
            ),
        ],
    )
    return "\n".join([weights, frequencies, energy, motion])


def _off(both: Mapping[str, float]) -> float:
    return both["signal"] / both["mode"] - 1.0


def _verdict(results: Mapping[str, Any]) -> str:
    one, run = results["summary"], results["run"]
    shift = {kind: one["frequency"][kind]["mass"] for kind in _KINDS}
    return (
        f"Rotation of the elements holds {100.0 * run['rotational_share_mean']:.2g} % of the kinetic energy. Density"
        f" by eq (19) makes the mass right; the moment of inertia about the axis is"
        f" {in_percent(one['axial_excess'])} % off the continuum's. To the first frequencies this adds"
        f" {in_percent(shift['tension'])} % in tension,"
        f" {in_percent(shift['bending'])} % in bending and {in_percent(shift['torsion'])} % in torsion, where forces"
        f" that leave out the skin take {in_percent(one['frequency']['torsion']['stiffness'])} %: the difference the"
        " paper supposes negligible is so in tension, and in torsion it is hidden by the other one."
    )
