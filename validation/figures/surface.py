"""Figure of the surface study: bodies against the bulk, their prediction, and what ends do to Poisson's ratio."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet

_FORMS = {"cube": "s", "beam": "^", "plate": "D", "cylinder": "o", "ball": "P", "bracket": "X"}
_TARGETS = {"contacts": ("z = 6.2 over all elements", BLUE), "jamming": ("onset of jamming", ORANGE),
            "carved": ("cut from a large packing", GREEN)}  # fmt: skip
_TESTS = {"tension": ("tension", BLUE), "plates": ("between plates", ORANGE), "stress": ("uniform stress", PURPLE)}


def draw_surface(path: Path, results: Mapping[str, Any]) -> None:
    """Draw it.

    Args:
        path: PNG to write.
        results: of the study, with "bodies", "predicted" and "ends".
    """
    with sheet(path, 12.0, 4.1, columns=3) as (figure, (stiffness, prediction, ends)):
        _stiffness(stiffness, results["bodies"])
        _prediction(prediction, results["predicted"])
        _ends(ends, results["ends"])
        shapes = {form: axes.plot([], [], marker, color=GREY, ls="")[0]
                  for axes in (stiffness,) for form, marker in _FORMS.items()}  # fmt: skip
        figure.legend(shapes.values(), shapes.keys(), loc="outside lower center", ncols=len(shapes))


def _stiffness(axes: Any, bodies: Sequence[Mapping[str, Any]]) -> None:
    for target, (label, colour) in _TARGETS.items():
        own = [one for one in bodies if one["target"] == target and one["E"] is not None]
        for one in own:
            marker = _FORMS[one["form"]]
            axes.errorbar(one["surface_ratio"], one["E"], one["E_std"], fmt=marker, color=colour, ms=5, lw=1)
        if own:
            axes.plot([], [], "s", color=colour, label=label)
    axes.axhline(1.0, color=INK, lw=0.8)
    axes.set(title="Thin bodies: softer or stiffer?", xlabel="R̄ S / V", ylabel="E in tension / E of the bulk")
    axes.set_xlim(0.0)
    axes.legend(loc="upper left")


def _prediction(axes: Any, predicted: Mapping[str, Sequence[float]]) -> None:
    found, wanted = (np.array(predicted[name]) for name in ("predicted", "measured"))
    targets = np.array(predicted["target"])
    span = np.array([min(found.min(), wanted.min()), max(found.max(), wanted.max())])
    axes.fill_between(span, 0.98 * span, 1.02 * span, color=GREY, alpha=0.25, lw=0, label="± 2 %")
    axes.plot(span, span, color=INK, lw=0.8)
    for target, (_, colour) in _TARGETS.items():
        chosen = targets == target
        axes.plot(wanted[chosen], found[chosen], "o", color=colour, ms=3, alpha=0.6, mew=0)
    axes.set(title="Predicted without the shape", xlabel="E measured / E of the bulk at z = 6.2",
             ylabel="E predicted from the lattice")  # fmt: skip
    axes.legend(loc="upper left")


def _ends(axes: Any, ends: Sequence[Mapping[str, Any]]) -> None:
    for test, (label, colour) in _TESTS.items():
        own = [one for one in ends if one["test"] == test] if test != "tension" else []
        points = [(one["surface_ratio"], one["nu"], one["form"]) for one in own]
        if test == "tension":
            points = [(one["surface_ratio"], one["nu_tension"], one["form"]) for one in ends
                      if one["test"] == "plates" and one["nu_tension"] is not None]  # fmt: skip
        for s, nu, form in points:
            axes.plot(s, nu, _FORMS[form], color=colour, ms=5)
        if points:
            axes.plot([], [], "s", color=colour, label=label)
    axes.axhline(1.0, color=INK, lw=0.8)
    axes.set(title="Poisson's ratio and how it is tested", xlabel="R̄ S / V", ylabel="ν / ν of the bulk")
    axes.set_xlim(0.0)
    axes.legend(loc="lower left")
