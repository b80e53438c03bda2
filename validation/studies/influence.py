"""Influence of ν_μ, E_μ and r̃ on E and ν (André et al. 2012, §5.2, figs 11, 13, 14)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem._types import Floats
from bondem.interactions.law_catalogue import CALIBRATED, DEFAULT
from bondem.packing.sizes import SPREAD
from validation.figures.influence import draw_bond_modulus, draw_bond_radius, draw_exponent, draw_nu_mu
from validation.frame.limits import numbers
from validation.frame.study import Row, Stages, Study
from validation.frame.tables import summary
from validation.rows.elastic import MEASURED, SHAPES, ElasticRequest, cells_and_bars

#: The paper's fused silica, at which ν_μ varies and to which E_μ = 265 GPa belongs.
_RADIUS, _MODULUS, _NU_MU = 0.71, 265e9, 0.3

# The laws that the paper's r̃ means something to.
_BEAMS = {name: law for name, law in CALIBRATED.items() if law.free.is_radius}

# Incompressible bonds, ν_μ = 1/2, are the end of what a bond may be.
_NU_MUS = (0.0, 0.1, 0.2, 0.3, 0.4, 0.49)
#: Of the families of figures 13 and 14, every one at every r̃: 212 solutions of 10 000 elements in all, seven minutes
#: on two free cores.
_MODULI = (50e9, 150e9, _MODULUS, 380e9, 500e9)
_RADII = tuple(round(0.1 * step, 1) for step in range(1, 11))
#: A curve of figure 13 for each of these; figure 14 has one for each E_μ.
_SHOWN = _RADII[1::2]

#: Between these r̃ the claim is judged.
_JUDGED = (0.2, 0.9)


@dataclass(frozen=True)
class Influence(Study):
    """E and ν over ν_μ, E_μ and r̃: figures 11, 13 and 14 of André et al. (2012).

    Attributes:
        count: elements of a packing.
        packings: periodic cells, seeds 1 … packings.
        bars: cylinders of 10 x 40 mm, seeds 1 … bars; 0 for none.
        spread: κ [-].
    """

    limits: ClassVar = {"count": numbers(least=100), "packings": numbers(least=1), "bars": numbers(least=0)}

    count: int = 10_000
    packings: int = 3
    bars: int = 3
    spread: float = SPREAD

    def stages(self, out: Path) -> Stages:
        packings = cells_and_bars(self.count, self.spread, cells=self.packings, bars=self.bars)
        tests = [
            *((law(E=_MODULUS, nu=nu_mu, radius_ratio=_RADIUS), False)
              for law in _BEAMS.values() for nu_mu in _NU_MUS),
            *((DEFAULT(E=E_mu, nu=_NU_MU, radius_ratio=radius), E_mu == _MODULUS)
              for E_mu in _MODULI for radius in _RADII),
        ]  # fmt: skip
        # that the solution is linear in E_μ shows on the first packing as well as on all
        wanted = [
            ElasticRequest(one, law, slopes) for one in packings for law, slopes in tests
            if one.seed == 1 or law.E == _MODULUS
        ]  # fmt: skip
        yield "pack", packings
        yield "solve", wanted

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: the means, and what they say of the paper's statements."""
        good = [_with_exponent(row) for row in rows if not row["error"]]
        by = ("periodic", "law", "nu_mu", "E_mu", "radius_ratio")
        groups = summary(good, by, (*MEASURED, "energy_exponent"))
        verdicts = {
            shape: {
                "nu_mu": {law: _change(groups, periodic, law) for law in _BEAMS},
                "E_mu": _linearity(good, periodic),
                "radius_ratio": _power(groups, periodic),
            }
            for periodic, shape in SHAPES.items()
            if any(one["periodic"] is periodic for one in groups)
        }
        return {
            "moduli": list(_MODULI), "radius_ratios": list(_RADII),
            "verdicts": verdicts, "cylinder_over_cell": _cylinder_over_cell(groups), "summary": groups,
        }  # fmt: skip

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures 11, 13 and 14, and the exponent."""
        groups = {
            shape: [one for one in results["summary"] if one["periodic"] is periodic]
            for periodic, shape in SHAPES.items()
        }
        groups = {shape: own for shape, own in groups.items() if own}
        over_radius = {shape: radius_groups(own) for shape, own in groups.items()}
        figures = out / "figures"
        draw_nu_mu(figures / "nu_mu.png", {
            shape: [one for one in own if one["radius_ratio"] == _RADIUS] for shape, own in groups.items()
        }, radius_ratio=_RADIUS)  # fmt: skip
        # Every E_μ is there for the first packing only, and its curves are not to be mixed with means of several.
        alone = [row for row in rows if row["seed"] == 1 and row["radius_ratio"] in _RADII]
        by = ("E_mu", "radius_ratio")
        swept = {
            shape: summary([row for row in alone if row["periodic"] is periodic], by, ("E", "nu"))
            for periodic, shape in SHAPES.items()
            if shape in groups
        }
        draw_bond_modulus(figures / "E_mu.png", swept, shown=_SHOWN)
        draw_bond_radius(figures / "radius_ratio.png", swept, judged=_JUDGED)
        draw_exponent(figures / "exponent.png", over_radius, judged=_JUDGED)


def _with_exponent(row: Row) -> Row:
    """A row with the exponent that the energy says, of bars."""
    return row | {"energy_exponent": None if row["periodic"] else 4.0 - 2.0 * row["axial_share"]}


def radius_groups(groups: Sequence[Row]) -> list[Row]:
    """Those of Euler–Bernoulli bonds at E_μ = 265 GPa over r̃, ascending."""
    own = [one for one in groups if one["E_mu"] == _MODULUS and one["radius_ratio"] in _RADII]
    return sorted(own, key=lambda one: one["radius_ratio"])


def _change(groups: Sequence[Row], periodic: bool, law: str) -> dict[str, Any]:
    """By how much E (relative) and ν (absolute) change over ν_μ, against ν_μ = 0.3."""
    own = {
        one["nu_mu"]: one for one in groups
        if one["periodic"] is periodic and one["law"] == law and one["radius_ratio"] == _RADIUS
    }  # fmt: skip
    E, nu = (np.array([own[value][name]["mean"] for value in _NU_MUS]) for name in ("stiffness_ratio", "nu"))
    middle = _NU_MUS.index(_NU_MU)
    return {
        "E_change_low": float((E / E[middle]).min() - 1.0),
        "E_change_high": float((E / E[middle]).max() - 1.0),
        "nu_change_low": float((nu - nu[middle]).min()),
        "nu_change_high": float((nu - nu[middle]).max()),
    }


def _linearity(rows: Sequence[Row], periodic: bool) -> dict[str, float]:
    """Largest departure of E/E_μ (relative) and ν (absolute) from those of the same packing at 265 GPa."""
    own = {
        (row["seed"], row["radius_ratio"], row["E_mu"]): row for row in rows
        if row["periodic"] is periodic and row["radius_ratio"] in _RADII
    }  # fmt: skip
    pairs = [(row, own[seed, radius, _MODULUS]) for (seed, radius, _), row in own.items()]
    return {
        "E": max(abs(row["stiffness_ratio"] / one["stiffness_ratio"] - 1.0) for row, one in pairs),
        "nu": max(abs(row["nu"] - one["nu"]) for row, one in pairs),
    }


def _cylinder_over_cell(groups: Sequence[Row]) -> dict[str, list[float]] | None:
    """E of the cylinder over that of the cell, less one, and ν less that of the cell, over r̃; None without bars."""
    cell, bar = (radius_groups([one for one in groups if one["periodic"] is periodic]) for periodic in (True, False))
    if not bar:
        return None
    pairs = list(zip(cell, bar, strict=True))
    return {
        "radius_ratio": [one["radius_ratio"] for one in cell],
        "E": [two["stiffness_ratio"]["mean"] / one["stiffness_ratio"]["mean"] - 1.0 for one, two in pairs],
        "nu": [two["nu"]["mean"] - one["nu"]["mean"] for one, two in pairs],
    }


def _power(groups: Sequence[Row], periodic: bool) -> dict[str, Any]:
    """Is E ∝ r̃², or at least a parabola in r̃? And ν?"""
    whole = radius_groups([one for one in groups if one["periodic"] is periodic])
    own = [one for one in whole if _JUDGED[0] <= one["radius_ratio"] <= _JUDGED[1]]
    radius, E, nu, exponent = (
        np.array([one[name] if name == "radius_ratio" else one[name]["mean"] for one in own])
        for name in ("radius_ratio", "stiffness_ratio", "nu", "exponent")
    )
    power, factor = np.polyfit(np.log(radius), np.log(E), 1)
    square = float((E * radius**2).sum() / (radius**4).sum())
    return {
        "exponent_low": float(exponent.min()),
        "exponent_high": float(exponent.max()),
        "power": float(power),
        "power_misfit": float(np.abs(np.exp(factor) * radius**power / E - 1.0).max()),
        "square_misfit": float(np.abs(square * radius**2 / E - 1.0).max()),
        "E_parabola_misfit": float(_parabola_misfit(radius, E).max() / E.max()),
        "E_parabola_misfit_relative": float((_parabola_misfit(radius, E) / E).max()),
        "nu_parabola_misfit": float(_parabola_misfit(radius, nu).max()),
    }


def _parabola_misfit(x: Floats, y: Floats) -> Floats:
    return np.abs(np.polyval(np.polyfit(x, y, 2), x) - y)
