"""Explanation of fracture in a model: implied fracture properties, and the bonds nearest to failure."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import count, instance
from bondem._plausibility import strength_doubts
from bondem._types import Floats, Ints
from bondem.damage.implied_fracture import ImpliedFracture
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.breakage import failure_index
from bondem.observables.crack_index import yield_index

# Number of elements along a process zone that resolves it.
_RESOLVED = 2.0
# Approximate energy that separates the atoms of a solid, twice the energy of a surface [J/m²].
_SURFACE = 1.0


@dataclass(frozen=True, eq=False)
class Explanation:
    """Fracture properties that a model implies, as values and as a text for `print`.

    Attributes:
        implied: strength, fracture energy and toughness, as medians of bonds or facets.
        doubts: one text for each property that is hardly intended or not resolved.
        nearest: user's numbers of the bonds or facets nearest to failure, the nearest first; empty without a state.
        index: failure index of each of `nearest`, 1 at breakage or onset of softening [-], shape (k,).
        position: middle of each of `nearest` in the reference [m], shape (k, 3).
        broken: number of broken bonds or facets.
        softening: number of softening bonds or facets.
        yielding: largest yield index of the cells, 1 where a cell yields [-]; 0 if no cell can yield.
        text: the whole explanation.
    """

    implied: ImpliedFracture
    doubts: tuple[str, ...]
    nearest: Ints
    index: Floats
    position: Floats
    broken: int
    softening: int
    yielding: float
    text: str

    def __str__(self) -> str:
        return self.text


def explain(model: Model, state: State | None = None, *, most: int = 5) -> Explanation:
    """Explain what strengths, stiffness and size of elements imply for fracture, and what is nearest to failure.

    Args:
        model: model with a failure criterion.
        state: state of this model, at any rotation; None for no list of the bonds nearest to failure.
        most: largest number of bonds in that list.

    Raises:
        InputError: The model has no criterion or no bonds, or the state belongs to another model.
    """
    instance("explain", "model", model, Model, "bd.Model(...)")
    many = count("explain", "most", most)
    implied = model.implied_fracture
    if implied is None:
        raise InputError("explain: the model has no criterion or no bonds; give it failure=bd.PeripheralStress(...)")
    doubts = _doubts(model, implied)
    lines = _implied_lines(model, implied)
    nearest, index, broken, softening, yielding = np.zeros(0, dtype=np.int64), np.zeros(0), 0, 0, 0.0
    if state is not None:
        every, whole = failure_index(model, state), state.bond_integrity
        nearest = np.argsort(-every, kind="stable")[:many]
        nearest = nearest[every[nearest] > 0.0]
        index = every[nearest]
        broken, softening = int((whole == 0.0).sum()), int(((whole > 0.0) & (whole < 1.0)).sum())
        yielding = float(yield_index(model, state).max(initial=0.0))
    position = model.lattice.elements.bond_middle[nearest]
    if state is not None:
        lines += _state_lines(model, state, nearest, index, position, broken, softening, yielding)
    lines += ["", "Doubts:", *(f"  - {one}" for one in doubts)] if doubts else ["", "No doubts."]
    return Explanation(
        implied=implied, doubts=tuple(doubts), nearest=nearest, index=index, position=position, broken=broken,
        softening=softening, yielding=yielding, text="\n".join(lines),
    )  # fmt: skip


def _doubts(model: Model, one: ImpliedFracture) -> list[str]:
    """Return descriptions of properties that are hardly intended or not resolved."""
    found = strength_doubts(one.strength, one.E, one.density, one.fracture_energy)
    if one.fracture_energy < _SURFACE:
        advice = "check its unit (J/m²)" if one.softens else "give a fracture_energy (cells), or stronger bonds"
        found.append(
            f"a fracture energy of {_number(one.fracture_energy, 'J/m²')} is less than that of the surfaces of a"
            f" solid, about 1 J/m²: cracks run far too easily; {advice}"
        )
    if one.softens and one.irwin < _RESOLVED * one.length:
        found.append(
            f"the process zone, E G_c/f_t² = {_number(one.irwin, 'm')}, is {one.irwin / one.length:.2g} elements"
            f" long and not resolved; use elements below {_number(one.irwin / _RESOLVED, 'm')}"
        )
    if one.softens and one.irwin > one.extent:
        found.append(
            f"E G_c/f_t² = {_number(one.irwin, 'm')} is longer than the specimen, {_number(one.extent, 'm')}:"
            " strength governs, and nothing breaks before a whole section nears f_t, notched or not"
        )
    if not one.softens:
        found.append(
            "without a fracture energy toughness is that of the elements: G_c grows with their length, by"
            f" {1e-3 * one.fracture_energy / one.length:.3g} J/m² per mm; choose L for the G_c of the material"
        )
    return found


def _implied_lines(model: Model, one: ImpliedFracture) -> list[str]:
    what, cells = model.interaction.bond, model.interaction.evaluated == "traction"
    given = "as given" if one.softens else "of brittle facets, f_t² L / E"
    if not cells:
        given = f"of {'bonds that soften' if one.softens else 'brittle bonds'}, estimated"
    kind = "cells" if cells else "elements"
    criteria = dict.fromkeys(type(one.criterion).__name__ for one in model.failure_parts)
    lines = [
        f"Fracture of {len(model.lattice.particles)} {kind} with {len(model.lattice.pairs)} {what}s by"
        f" {', '.join(criteria) or model.interaction.name}",
        f"  tensile strength of a {what}  {_number(one.strength, 'Pa')}  (median)",
        f"  Young's modulus           {_number(one.E, 'Pa')}" + ("" if cells else "  (affine estimate, from above)"),
        f"  length L                  {_number(one.length, 'm')}  (median)",
        f"  a {what} holds             {_number(one.bond_energy, 'J/m²')}  of its own area when it breaks in tension",
        f"  fracture energy G_c       {_number(one.fracture_energy, 'J/m²')}  ({given})",
        f"  toughness K_Ic = √(E G_c) {_number(one.toughness, 'Pa√m')}",
    ]
    if one.softens:
        lines.append(
            f"  Irwin's length E G_c/f_t² {_number(one.irwin, 'm')}: {one.irwin / one.length:.2g} elements,"
            f" {one.irwin / one.extent:.2g} of the specimen"
        )
    return lines


def _state_lines(
    model: Model, state: State, nearest: Ints, index: Floats, position: Floats, broken: int, softening: int,
    yielding: float,
) -> list[str]:  # fmt: skip
    what = model.interaction.bond
    lines = ["", f"At t = {_number(state.time, 's')}: {broken} {what}s broken, {softening} softening"]
    for _ in model.yielding:
        lines.append(f"  the cell nearest to yielding is at {yielding:.3g} of its strength (1 yields)")
    if not len(nearest):
        return [*lines, f"  no {what} is pulled"]
    softens = model.softening is not None or model.beam_softening is not None
    lines.append(f"  nearest to failure (1 {'softens' if softens else 'breaks'}):")
    pairs = model.lattice.pairs[nearest].tolist()
    for k, value, (i, j), place in zip(nearest.tolist(), index.tolist(), pairs, position.tolist(), strict=True):
        where = ", ".join(f"{1e3 * x:.4g}" for x in place)
        lines.append(f"    {value:.3f}  {what} {k} between {i} and {j}, at ({where}) mm")
    return lines


def _number(value: float, unit: str) -> str:
    """Format a value with three digits and a unit prefix."""
    if unit == "J/m²" or value == 0.0 or not np.isfinite(value):
        return f"{value:.3g} {unit}"
    for size, prefix in ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")):
        if 0.9995 * size <= abs(value) < 999.5 * size:
            return f"{value / size:.3g} {prefix}{unit}"
    return f"{value:.3g} {unit}"
