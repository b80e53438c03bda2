"""E and ν over the parameters of bonds (André et al. 2012, figs 11, 13 and 14), and the exponent of r̃."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes

from bondem._types import Floats
from bondem.interactions.law_catalogue import named
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, SEQUENTIAL, sheet
from validation.figures.law_colours import law_colour

Groups = Mapping[str, Sequence[Mapping[str, Any]]]

_MARKS = ("o", "s")
_DASHED = (0, (3, 2))
_STYLES: dict[bool, dict[str, Any]] = {
    True: {"linestyle": "-"},
    False: {"linestyle": _DASHED, "markerfacecolor": "white"},
}
_E_RATIO, _NU = r"$E\,/\,E_\mu$ [-]", "Poisson's ratio ν [-]"


def draw_nu_mu(path: Path, groups: Groups, *, radius_ratio: float) -> None:
    """Figure 11: E and ν over ν_μ, of bonds of several laws.

    Args:
        path: PNG to write.
        groups: means by shape, over law and ν_μ.
        radius_ratio: r̃ of them all.
    """
    with sheet(path, 8.6, 3.9, 1, 2) as (_, (left, right)):
        for k, (shape, own) in enumerate(groups.items()):
            for law in dict.fromkeys(one["law"] for one in own):
                chosen, colour = [one for one in own if one["law"] == law], law_colour(law)
                label = f"{named(law)}, {shape}"
                _line(left, chosen, "nu_mu", "stiffness_ratio", colour, k, label)
                _line(right, chosen, "nu_mu", "nu", colour, k, None)
        left.set(xlabel=r"$\nu_\mu$ [-]", ylabel=_E_RATIO, title=f"(a) stiffness at r̃ = {radius_ratio:g}")
        right.set(xlabel=r"$\nu_\mu$ [-]", ylabel=_NU, title="(b) Poisson's ratio")
        left.set_ylim(bottom=0.0)
        right.set_ylim(0.0, 0.3)
        left.legend(fontsize=8.0, loc="lower left")


def draw_bond_modulus(path: Path, groups: Groups, *, shown: Sequence[float]) -> None:
    """Figure 13: E and ν over E_μ, a curve for each of several r̃.

    Args:
        path: PNG to write.
        groups: by shape, over E_μ and r̃, of the same packings throughout.
        shown: r̃ to draw.
    """
    with sheet(path, 8.6, 4.2, 1, 2) as (_, (left, right)):
        for k, own in enumerate(groups.values()):
            for radius, colour in zip(shown, _shades(len(shown)), strict=True):
                chosen = sorted((one for one in own if one["radius_ratio"] == radius), key=lambda one: one["E_mu"])
                for ax, name, factor in ((left, "E", 1e-9), (right, "nu", 1.0)):
                    _line(ax, chosen, "E_mu", name, colour, k, None, x_factor=1e-9, factor=factor)
                    if k == 0:
                        _at_its_end(ax, chosen, "E_mu", name, f"r̃ = {radius:.1f}", x_factor=1e-9, factor=factor)
        end = 1e-9 * max(one["E_mu"] for own in groups.values() for one in own)
        for ax in (left, right):
            ax.set(xlabel=r"$E_\mu$ [GPa]", xlim=(0.0, 1.22 * end), ylim=(0.0, None))
        left.set(ylabel="E [GPa]", title="(a) Young's modulus")
        right.set(ylabel=_NU, title="(b) Poisson's ratio")
        left.legend(handles=_shapes(left, groups), fontsize=8.0, loc="upper left")


def draw_bond_radius(path: Path, groups: Groups, *, judged: tuple[float, float]) -> None:
    """Figure 14: E and ν over r̃, a curve for each of several E_μ, with the parabolas that the paper's words ask for.

    Args:
        path: PNG to write.
        groups: by shape, over E_μ and r̃, of the same packings throughout.
        judged: between which r̃ the parabolas are fitted.
    """
    with sheet(path, 8.6, 4.4, 1, 2) as (_, (left, right)):
        moduli = sorted({one["E_mu"] for own in groups.values() for one in own})
        for k, own in enumerate(groups.values()):
            for i, (E_mu, colour) in enumerate(zip(moduli, _shades(len(moduli)), strict=True)):
                chosen = sorted((one for one in own if one["E_mu"] == E_mu), key=lambda one: one["radius_ratio"])
                _line(left, chosen, "radius_ratio", "E", colour, k, None, factor=1e-9)
                radius, nu = _column(chosen, "radius_ratio"), _column(chosen, "nu")
                modulus = f"{E_mu / 1e9:.0f} GPa"
                if k > 0:
                    right.plot(radius, nu, color=colour, linewidth=1.2, linestyle=_DASHED)
                    continue
                # the curves are one: rings of growing size show that all are there
                right.plot(radius, nu, "o", color=colour, markersize=3.5 + 2.5 * i, fillstyle="none", linewidth=1.0,
                           label=rf"$E_\mu$ = {modulus}")  # fmt: skip
                largest = E_mu == moduli[-1]
                _at_its_end(left, chosen, "radius_ratio", "E", rf"$E_\mu$ = {modulus}" if largest else modulus,
                            factor=1e-9)  # fmt: skip
                _parabola(left, chosen, "E", judged, 1e-9, square=largest)
                if largest:
                    _parabola(right, chosen, "nu", judged, 1.0, square=False)
        left.set(xlabel="r̃ [-]", ylabel="E [GPa]", title="(a) Young's modulus", xlim=(0.0, 1.35), ylim=(0.0, None))
        right.set(xlabel="r̃ [-]", ylabel=_NU, title="(b) Poisson's ratio", xlim=(0.0, 1.1), ylim=(0.0, 0.5))
        fits = dict(zip(*reversed(left.get_legend_handles_labels()), strict=True))
        left.legend(handles=[*_shapes(left, groups), *fits.values()], fontsize=8.0, loc="upper left")
        right.legend(fontsize=8.0)


def draw_exponent(path: Path, groups: Groups, *, judged: tuple[float, float]) -> None:
    """d ln E / d ln r̃ over r̃: 2 where bonds only stretch, 4 where they only bend and twist.

    Args:
        path: PNG to write.
        groups: means by shape over r̃, of Euler–Bernoulli bonds.
        judged: r̃ between which the paper's words are judged.
    """
    with sheet(path, 8.6, 4.0, 1, 2) as (_, (left, right)):
        for k, (shape, own) in enumerate(groups.items()):
            colour = (BLUE, ORANGE)[k]
            _line(left, own, "radius_ratio", "stiffness_ratio", colour, k, shape)
            _line(right, own, "radius_ratio", "exponent", colour, k, f"{shape}, from adjoints")
            radius, ratio = _column(own, "radius_ratio"), _column(own, "stiffness_ratio")
            right.plot(np.sqrt(radius[1:] * radius[:-1]), np.diff(np.log(ratio)) / np.diff(np.log(radius)), "x",
                       color=colour, markersize=5.0, label="between neighbours" if k == 0 else None)  # fmt: skip
            if own[0]["energy_exponent"]["mean"] is not None:
                right.plot(radius, _column(own, "energy_exponent"), color=GREEN, linewidth=1.0,
                           label=f"{shape}, from the energy")  # fmt: skip
        first = next(iter(groups.values()))
        radius, ratio = _column(first, "radius_ratio"), _column(first, "stiffness_ratio")
        middle = len(radius) // 2
        for power in (2, 4):
            left.plot(radius, ratio[middle] * (radius / radius[middle]) ** power, color=GREY, linewidth=1.0,
                      linestyle=(0, (1, 1.5)))  # fmt: skip
            left.text(radius[-1] * 1.03, ratio[middle] * (radius[-1] / radius[middle]) ** power, f"r̃$^{power}$",
                      color=GREY, fontsize=8.5, va="center")  # fmt: skip
            right.axhline(power, color=GREY, linewidth=1.0, linestyle=(0, (1, 1.5)))
        right.text(0.99, 2.02, "bonds stretch: r̃²", color=GREY, fontsize=8.5, ha="right", va="bottom",
                   transform=right.get_yaxis_transform())  # fmt: skip
        right.text(0.99, 3.98, r"bonds bend and twist: r̃$^4$", color=GREY, fontsize=8.5, ha="right", va="top",
                   transform=right.get_yaxis_transform())  # fmt: skip
        right.axvspan(*judged, color=GREY, alpha=0.08, linewidth=0.0)
        left.set(xlabel="r̃ [-]", ylabel=_E_RATIO, xscale="log", yscale="log", title="(a) stiffness")
        right.set(xlabel="r̃ [-]", ylabel="d ln E / d ln r̃ [-]", title="(b) its exponent", ylim=(1.8, 4.2))
        left.legend(fontsize=8.0)
        right.legend(fontsize=7.5, loc="upper left", bbox_to_anchor=(0.0, 0.93))


def _line(
    ax: Axes, groups: Sequence[Mapping[str, Any]], over: str, name: str, colour: Any, which: int, label: str | None,
    *, x_factor: float = 1.0, factor: float = 1.0,
) -> None:  # fmt: skip
    """Means with their standard deviation, full for the first shape and dashed for the second."""
    std = np.array([one[name]["std"] or 0.0 for one in groups])
    ax.errorbar(x_factor * _column(groups, over), factor * _column(groups, name), yerr=factor * std, color=colour,
                marker=_MARKS[which], markersize=4.0, capsize=2.0, elinewidth=0.9, linewidth=1.2, label=label,
                **_STYLES[which == 0])  # fmt: skip


def _at_its_end(
    ax: Axes, groups: Sequence[Mapping[str, Any]], over: str, name: str, text: str, *, x_factor: float = 1.0,
    factor: float = 1.0,
) -> None:  # fmt: skip
    """What a curve is, right of its last mark."""
    end = x_factor * _column(groups, over)[-1], factor * _column(groups, name)[-1]
    ax.annotate(text, end, xytext=(6.0, 0.0), textcoords="offset points", fontsize=8.0, va="center")


def _shapes(ax: Axes, groups: Groups) -> list[Any]:
    """Handles of a legend of the shapes."""
    return [ax.plot([], [], color=INK, marker=_MARKS[k], markersize=4.0, label=shape, **_STYLES[k == 0])[0]
            for k, shape in enumerate(groups)]  # fmt: skip


def _parabola(
    ax: Axes, groups: Sequence[Mapping[str, Any]], name: str, judged: tuple[float, float], factor: float, *,
    square: bool,
) -> None:  # fmt: skip
    radius, value = _column(groups, "radius_ratio"), factor * _column(groups, name)
    inside = (radius >= judged[0]) & (radius <= judged[1])
    over = np.linspace(*judged, 60)
    ax.plot(over, np.polyval(np.polyfit(radius[inside], value[inside], 2), over), color=INK, linewidth=0.9, zorder=3,
            label="parabola")  # fmt: skip
    if square:
        r, y = radius[inside], value[inside]
        ax.plot(over, (y * r**2).sum() / (r**4).sum() * over**2, color=INK, linewidth=1.2, linestyle=(0, (1, 1.5)),
                label="c r̃²")  # fmt: skip


def _column(groups: Sequence[Mapping[str, Any]], name: str) -> Floats:
    values = (one[name] for one in groups)
    return np.array([one["mean"] if isinstance(one, Mapping) else one for one in values], dtype=float)


def _shades(count: int) -> list[Any]:
    return [colormaps[SEQUENTIAL](0.85 * k / max(count - 1, 1)) for k in range(count)]
