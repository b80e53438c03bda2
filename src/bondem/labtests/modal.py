"""Natural frequencies of a clamped specimen from its modes."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._drawing import Coloured, Plotted, columns_of
from bondem._progress import staged
from bondem._types import Floats, PerElement
from bondem.boundary.conditions import Fix
from bondem.errors import InputError
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant
from bondem.specimen.regions import Face
from bondem.statics.modes import ModesResult, solve_modes


@dataclass(frozen=True, eq=False)
class NaturalFrequencies(Plotted):
    """First natural frequencies of a specimen clamped at x_min.

    Attributes:
        tension, bending, torsion: first axial, bending and torsional frequency [Hz].
        modes: computed modes, among which the three were found.
        mass_share: effective mass of each mode along x, y and z over the total mass, and effective moment of inertia
            about x over the total one [-], (count, 4).
    """

    tension: float
    bending: float
    torsion: float
    modes: ModesResult
    mass_share: Floats

    @property
    def table(self) -> dict[str, Floats]:
        """Frequency and effective mass of every mode, by name and unit, (count,) each."""
        share = columns_of("effective mass share {} [-]", ("x", "y", "z", "about x"), self.mass_share)
        return dict(self.modes.table) | share

    @property
    def _pictures(self) -> tuple[Coloured, ...]:
        return self.modes._pictures


@staged("natural frequencies")
def natural_frequencies(
    lattice: Lattice, law: AnyLaw, *, density: float | PerElement | Material, count: int = 8, depth: float = 0.02
) -> NaturalFrequencies:
    """Compute the first axial, bending and torsional frequency by `solve_modes`.

    The effective mass identifies the modes: the first axial mode has 81 % of the total mass, and the first pair of
    bending modes 61 %. The first torsional mode has 81 % of the total moment of inertia. The square of the bending
    frequency is the mean of the squares over the pair, weighted with the effective mass along y.

    Args:
        lattice: the specimen.
        law: bond law or cell law of the specimen; the non-local law has no modes, and raises InputError.
        density: density of the elements, ρ_μ [kg/m³], a number or (n,).
        count: number of modes to compute.
        depth: depth of the clamped face region, in mean radii [-].

    Raises:
        EmptyRegionError: the face x_min has no connected element.
        InputError: a kind of mode is missing among the computed modes, or a value is out of range.
    """
    density = constant("density", density)
    check("natural_frequencies", lattice, density=density, depth=depth)
    model = Model(lattice, law, density=density, boundary=[Fix(Face("x_min", depth))])
    modes = solve_modes(model, count=count)
    share = _effective_mass(model, modes.shape)

    def strongest(column: int, name: str) -> float:
        best = int(np.argmax(share[:, column]))
        if share[best, column] < 0.4:
            raise InputError(f"count = {count}: the first {count} modes contain no {name} mode; give a larger count=")
        return float(modes.frequency[best])

    lateral = share[:, 1] + share[:, 2]
    pair = np.flatnonzero(lateral >= 0.4)
    if not len(pair) or not share[pair, 1].sum() > 0.0:
        raise InputError(f"count = {count}: the first {count} modes contain no bending mode; give a larger count=")
    bending = math.sqrt(np.average(modes.frequency[pair] ** 2, weights=share[pair, 1]))
    return NaturalFrequencies(strongest(0, "axial"), bending, strongest(3, "torsional"), modes, share)


def _effective_mass(model: Model, shape: Floats) -> Floats:
    """Compute mass shares (φ·M r)² / (φ·M φ · r·M r) of modes φ, (count, 4), for r along x, y and z and about x."""
    lattice = model.lattice
    moving = lattice.connected
    y, z = (lattice.centre - lattice.centre[moving].mean(axis=0))[:, 1:].T
    rigid = np.zeros((4, len(y), 6))
    rigid[range(3), :, range(3)] = 1.0
    rigid[3, :, 1], rigid[3, :, 2], rigid[3, :, 3] = -z, y, 1.0
    mass = np.repeat(np.stack([model.mass, model.inertia], axis=1), 3, axis=1) * moving[:, None]
    crossed = np.einsum("knc,nc,rnc->kr", shape, mass, rigid)
    own = np.einsum("knc,nc,knc->k", shape, mass, shape)
    whole = np.einsum("rnc,nc,rnc->r", rigid, mass, rigid)
    return crossed**2 / (own[:, None] * whole)
