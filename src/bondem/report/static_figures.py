"""Figures of the calibration curve, the strain field in tension and deflected shapes."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from scipy.interpolate import PchipInterpolator

from bondem.labtests.gauge_length import AffineField, at_generators, middle_half
from bondem.report.findings import Examined, Findings
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet


def draw_free_parameter(path: Path, findings: Findings) -> None:
    """Draw ν and E / E_μ over the free parameter of the law, with the evaluations and the result."""
    fit, material = findings.fit, findings.material
    assert fit is not None
    assert material is not None
    chosen = getattr(fit.law, fit.parameter)
    curve = sorted({trial.value: trial for trial in findings.chart}.values(), key=lambda trial: trial.value)
    value = np.array([trial.value for trial in curve])
    fine = np.linspace(value[0], value[-1], 200)
    with sheet(path, 8.2, 3.2, 1, 2) as (_, axes):
        rows = (
            ("nu", "Poisson's ratio ν [-]", material.nu, fit.nu, BLUE),
            ("stiffness_ratio", "modulus ratio E / E$_μ$ [-]", None, fit.E / fit.law.E, GREEN),
        )
        for ax, (name, label, target, reached, colour) in zip(axes, rows, strict=True):
            ax.plot(fine, PchipInterpolator(value, [getattr(trial, name) for trial in curve])(fine), color=colour)
            ax.plot(value, [getattr(trial, name) for trial in curve], "o", color=colour, markersize=4)
            if target is not None:
                ax.axhline(target, color=GREY, linestyle=(0, (4, 3)), linewidth=1.0)
                ax.annotate(
                    f"target ν = {target:g}", (value[-1], target), ha="right", va="bottom", color=INK, fontsize=8.5,
                    xytext=(0, 3), textcoords="offset points",
                )  # fmt: skip
            ax.plot([chosen], [reached], "D", color=ORANGE, markersize=7, label=f"calibrated: {chosen:.4f}", zorder=5)
            ax.set(xlabel=fit.law.free.label, ylabel=label)
            ax.legend(loc="best")


def draw_tension(path: Path, findings: Findings) -> None:
    """Draw stress over strain of every packing, and the displacements of the first packing with the fitted field."""
    with sheet(path, 8.2, 3.0, 1, 3, width_ratios=(1.15, 1.2, 1)) as (_, (left, middle, right)):
        _draw_stress_strain(left, findings)
        _draw_displacement(middle, findings.specimens[0], "x")
        _draw_displacement(right, findings.specimens[0], "y")


def _draw_stress_strain(ax: Axes, findings: Findings) -> None:
    material = findings.material
    assert material is not None
    stress = np.array([0.0, 1.0])
    for one in findings.specimens:
        # linear: one solution is the whole curve
        assert one.tension is not None
        axial = 1e6 * stress * 1e6 / one.tension.E
        ax.plot(axial, stress, color=BLUE, label="along x")
        ax.plot(-one.tension.nu * axial, stress, color=GREEN, label="across")
    axial = 1e6 * 1e6 / material.E
    ax.plot([axial, -material.nu * axial], [1.0, 1.0], "D", color=ORANGE, markersize=6, label="material", zorder=5)
    ax.set(xlabel="strain [10⁻⁶]", ylabel="stress [MPa]", ylim=(0.0, 1.12), xlim=(-0.35 * axial, 1.12 * axial))
    handles = {handle.get_label(): handle for handle in ax.get_lines()}
    ax.legend(handles=list(handles.values()), loc="lower right")


def _draw_displacement(ax: Axes, specimen: Examined, name: str) -> None:
    lattice, tension = specimen.lattice, specimen.tension
    assert tension is not None
    chosen = middle_half(lattice)
    axis = "xyz".index(name)
    position, displacement = at_generators(lattice, tension.solution.displacement, tension.solution.rotation)
    field = AffineField.fit(position[chosen], displacement[chosen])
    moved = field.without_rigid_motion(position, displacement)[:, axis] / tension.stress * 1e15
    slope = field.strain[axis, axis] / tension.stress * 1e12
    place = position[:, axis] * 1e3
    ends = lattice.connected.copy()
    ends[chosen] = False
    if axis == 0:
        ax.plot(place[ends], moved[ends], ".", color=GREY, markersize=2.0, alpha=0.6, label="ends")
    ax.plot(place[chosen], moved[chosen], ".", color=BLUE, markersize=2.0, alpha=0.6, label="middle half")
    span = np.array([place[lattice.connected].min(), place[lattice.connected].max()])
    line = slope * (span - 1e3 * field.centre[axis])
    ax.plot(span, line, color=ORANGE, label=f"ε$_{{{name}{name}}}$ = {slope:.2f}·10⁻⁶".replace("-", "−"))
    top = 1.85 * np.abs(line).max()
    ax.set(xlabel=f"{name} [mm]", ylabel=f"u$_{name}$ [nm] at 1 MPa", ylim=(-top, top))
    legend = ax.legend(loc="upper left" if axis == 0 else "upper right", markerscale=4)
    for handle in filter(None, legend.legend_handles):
        handle.set_alpha(1.0)


def draw_profiles(path: Path, specimen: Examined) -> None:
    """Draw the motion of cross-sections in the three static tests, relative to the theoretical motion of the end."""
    wanted = (
        ("static_tension", "tension", "elongation", BLUE, lambda s: s),
        ("static_bending", "bending", "deflection", GREEN, lambda s: 0.5 * s**2 * (3.0 - s)),
        ("static_torsion", "torsion", "rotation", PURPLE, lambda s: s),
    )
    rows = [row for row in wanted if "profile" in getattr(specimen.outcomes.get(row[0]), "curves", {})]
    lower, upper = specimen.lattice.particles.envelope.bounds
    with sheet(path, 8.2, 2.9, 1, len(rows), squeeze=False) as (_, axes):
        for ax, (name, title, what, colour, theory) in zip(axes[0], rows, strict=True):
            outcome = specimen.outcomes[name]
            share = (outcome.curves["x"] - lower[0]) / (upper[0] - lower[0])
            fine = np.linspace(0.0, 1.0, 100)
            ax.plot(fine, theory(fine), color=INK, linewidth=1.0, label="theory, 1 at the end")
            measured = outcome.curves["profile"] / outcome.theory
            ax.plot(share, measured, "o", color=colour, markersize=4, label="measured")
            ax.set(title=title, xlabel="x / length [-]", ylabel=f"{what} / theory [-]")
            ax.set(xlim=(0.0, 1.02), ylim=(0.0, 1.12))
            ax.legend(loc="upper left")
