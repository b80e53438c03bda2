"""Figures of tests to failure: fragments and crack surfaces of the first specimen, and its energies."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from bondem.labtests.energy_balance import PARTS
from bondem.labtests.failure_record import TestFigure
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.labtests.outcome import Outcome
from bondem.report.crack_pictures import draw_cracks, draw_fragments
from bondem.report.findings import Examined
from bondem.report.numbers import area, many, pieces_and_crumbs, with_unit
from bondem.report.strength_figures import broken_in, magnified, panels, reach_of, view_of
from bondem.report.style import AMBER, BLUE, GREEN, GREY, INK, ORANGE, PALE, PURPLE, colour_bar, legend_columns, sheet
from bondem.specimen.lattice import Lattice

# Colours of `PARTS` of the energy.
_COLOURS = BLUE, GREY, ORANGE, AMBER, PURPLE, GREEN, PALE


def draw_pieces(path: Path, specimen: Examined) -> None:
    """Draw the separated fragments and the crack surfaces with their opening, one row per test."""
    names = broken_in(specimen)
    with sheet(path, 8.2, 3.5 * len(names), len(names), 2, squeeze=False) as (figure, axes):
        for (left, right), name in zip(axes, names, strict=True):
            _draw_test(figure, left, right, specimen.lattice, specimen.outcomes[name], FAILURE_TESTS[name].figure)


def _draw_test(figure: Figure, left: Axes, right: Axes, body: Lattice, outcome: Outcome, style: TestFigure) -> None:
    cracking = outcome.cracking
    assert cracking is not None
    state, found = cracking.state, cracking.found
    reach = reach_of(body, state.displacement)
    draw_fragments(left, body, state, cracking.fragments, view=view_of(style), reach=reach)
    left.set_title(f"{style.title}: {pieces_and_crumbs(cracking)}", color=INK)
    left.text(0.02, 0.0, magnified(reach), transform=left.transAxes, fontsize=8.5)
    cracks = many(cracking.count, "crack") if cracking.sectioned else "cracks"
    scale = draw_cracks(right, body, found, view=view_of(style))
    right.set_title(f"{cracks}, {area(cracking.surface)} of facets", color=INK)
    if len(found):
        colour_bar(figure, scale, "opening [µm]", edge=GREY, ax=right, orientation="horizontal", shrink=0.6)


def draw_energies(path: Path, specimen: Examined) -> None:
    """Draw the energy balance of each test over its strain: the parts into which the work is converted.

    On a path with snap-back, only points beyond all previous strains are drawn.
    """
    names = [name for name in broken_in(specimen) if specimen.outcomes[name].energy]
    with panels(path, len(names), (4.1, 3.2), margin=(0.4, 0.5)) as (figure, axes):
        for ax, name in zip(axes, names, strict=True):
            outcome = specimen.outcomes[name]
            style = FAILURE_TESTS[name].figure_of(outcome.curves)
            strain = style.across[0] * outcome.curves["strain"]
            missing = np.abs(outcome.energy["balance"]).max()
            farther = strain >= np.maximum.accumulate(strain)
            strain, energy = strain[farther], {part: along[farther] for part, along in outcome.energy.items()}
            top = np.zeros(len(strain))
            for part, colour in zip(PARTS, _COLOURS, strict=True):
                ax.fill_between(strain, top, top + energy[part], color=colour, linewidth=0.0, label=part)
                top = top + energy[part]
            ax.plot(strain, energy["work"], color=INK, linestyle=(0, (4, 3)), linewidth=1.2, label="work of the load")
            ax.set(xlabel=f"{style.strain} [{style.across[1]}]", ylabel="energy [J]", title=style.title)
            ax.set_ylim(bottom=0.0)
            ax.text(0.02, 0.97, f"balance within {with_unit(float(missing), 'J', 2)}", transform=ax.transAxes,
                    va="top", fontsize=8.5)  # fmt: skip
        handles, labels = axes[0].get_legend_handles_labels()
        wide = 4 if len(names) > 1 else 2
        figure.legend(handles, labels, loc="outside lower center", ncols=legend_columns(wide, 2))
