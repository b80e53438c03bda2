"""The highest frequency of a model at rest, by Lanczos iteration without a matrix."""

import math
from typing import Any

import numpy as np
from scipy.linalg import eigh_tridiagonal
from scipy.sparse import csr_array

from bondem._blas import one_blas_thread
from bondem._cache_lines import lines
from bondem._types import Floats, PerBond, PerElement
from bondem.interactions.beams.bond_table import BondTable
from bondem.interactions.cells.corrected_mass import largest_share
from bondem.model.long_slip import LongSlip
from bondem.model.model import Model
from bondem.model.stiffness_matrices import mass_diagonal
from bondem.specimen.local_origin import local_rest

# Relative error of ω²_max at which Lanczos ends; the result, which approaches from below, is raised by it.
_TOLERANCE = 1e-3
_LEAST, _MOST, _EVERY = 24, 600, 4  # iterations: first check of the error, limit, and distance of checks


def highest_frequency(
    model: Model, *, integrity: PerBond | None = None, table: BondTable | None = None,
    slips: tuple[LongSlip, ...] = (),
) -> float:
    """Return ω_max of a model at rest with all elements free [rad/s], a bound for any elements that are fixed.

    Springs between facets of cells and walls that constrain them are included. With the dispersion-corrected mass the
    result is raised to a bound for explicit steps.

    Args:
        model: bonds or facets, masses and walls.
        integrity: present integrity of the bonds (`State.integrity`), internal order, (m,); None for intact bonds.
            Broken bonds only lower ω_max.
        table: constants of the bonds, internal order; None for those of the model.
        slips: slips on planes between regions, from `long_slips`.
    """
    order = model.layout.order
    mass, inertia = model.mass[order], model.inertia[order]
    square = stiffest(model, mass, inertia, integrity=integrity, table=table, slips=slips)
    if model.correction is not None:
        forms = model.interaction.stiffness().forms
        assert forms is not None
        square *= 1.0 + largest_share(mass_diagonal(model), csr_array(forms.tocsr()), model.correction[order])
    return math.sqrt(square)


@one_blas_thread
def stiffest(
    model: Model, mass: PerElement, inertia: PerElement, *, integrity: PerBond | None = None,
    table: BondTable | None = None, slips: tuple[LongSlip, ...] = (),
) -> float:  # fmt: skip
    """Return a bound of ω² in K u = ω² M u [1/s²], for masses [kg] and inertias [kg·m²], (n,), internal order.

    Lanczos iteration finds the bound without a matrix: K u is the derivative of the forces of the bonds at rest along
    u. The iteration ends when the residual is below the tolerance, and the residual is added. The start is a fixed
    vector, larger for elements that are stiff for their mass: a highest mode of few such elements, hardly above the
    others, could be missed from another start. Other arguments are those of `highest_frequency`.
    """
    layout, n, m = model.layout, len(model.layout.order), len(model.layout.i)
    if m == 0 and not len(model.interaction.supports.cell):
        return 0.0
    intact = np.ones(m) if integrity is None else integrity
    table = model.bonds if table is None else table
    pose = lines(n)
    pose[:, :3], pose[:, 4] = local_rest(model.lattice)[layout.order], 1.0
    product = model.interaction.product(pose, intact, table)
    root = 1.0 / np.sqrt(np.column_stack([mass, mass, mass, inertia, inertia, inertia]))

    def answer(y: Floats) -> Floats:
        motion = y * root
        forces = product(motion)
        for slip in slips:
            forces += slip.forces(motion)
        return forces * root

    resisted = np.zeros(n)
    for end, arm in ((layout.i, table.lever), (layout.j, table.length - table.lever)):
        resisted += np.bincount(end, weights=intact * (table.kn + table.ks), minlength=n) / mass
        turned = intact * (table.ks * arm**2 + table.kb)
        resisted += np.bincount(end, weights=turned, minlength=n) / inertia
    for slip in slips:
        resisted += slip.resistance(n) / inertia
    share = resisted / resisted.max() if m else np.ones(n)  # walls alone hold cells without inner facets
    start = np.random.default_rng(0).standard_normal((n, 6)) * share[:, None] ** 2
    vector, last = start / np.linalg.norm(start), np.zeros((n, 6))
    diagonal: list[float] = []
    beside: list[float] = []
    top = rest_of_it = 0.0
    for k in range(1, min(_MOST, 6 * n) + 1):
        image = answer(vector)
        diagonal.append(float(np.vdot(vector, image)))
        image -= diagonal[-1] * vector
        if beside:
            image -= beside[-1] * last
        beside.append(float(np.linalg.norm(image)))
        spent = beside[-1] <= 1e-9 * max(diagonal)
        if spent or k == 6 * n or k == _MOST or (k >= _LEAST and k % _EVERY == 0):
            found: Any = eigh_tridiagonal(diagonal, beside[:-1], select="i", select_range=(k - 1, k - 1))
            value, weight = found
            top, rest_of_it = float(value[0]), beside[-1] * abs(float(weight[-1, 0]))
            if spent or rest_of_it <= _TOLERANCE * top:
                break
        last, vector = vector, image / beside[-1]
    return (1.0 + _TOLERANCE) * (top + rest_of_it)
